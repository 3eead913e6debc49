// One sentence on how the pattern continues at seams, according to the certificate.

import { html, nothing, type TemplateResult } from 'lit';
import { showPlaces } from '../actions/view';
import { isAligned, turnedSeams } from '../model/grid';
import type { Pattern, Solution } from '../model/types';
import { attempt } from '../actions/app';
import { plural } from '../text/format';
import { Panel } from './panel';

const names: Partial<Record<Pattern, string>> = {
  brick: 'Brick',
  wood: 'Wood',
  hex: 'Hexagons',
  image: 'Your image',
};

class SeamNote extends Panel {
  override render(): TemplateResult | typeof nothing {
    const { displayed, look } = this.app.doc;
    if (!displayed || ['plain', 'material'].includes(look.pattern)) return nothing;
    return html`<p class="seam-note">${this.#sentence(displayed, look.pattern)}</p>`;
  }

  #sentence(solution: Solution, pattern: Pattern): TemplateResult | string {
    if (solution.seams.length === 0) return 'There are no seams.';
    if (!isAligned(solution)) {
      return 'Directions and sizes continue across seams; lines may be shifted there.';
    }
    if (pattern === 'cross') return 'Lines meet at every seam.';
    const { all, turned, edges } = turnedSeams(pattern, solution);
    if (turned === 0) return 'Lines meet at every seam.';
    const is = pattern === 'hex' ? 'are' : 'is';
    const what = `${names[pattern] ?? 'The pattern'} ${is} turned across ${turned} of ${plural(all, 'seam')}.`;
    const { uvToVertex } = solution.result;
    const places = edges.map((i) => {
      const [id, other] = solution.seams[i].a.map((end) => uvToVertex[end]);
      return { kind: 'edge' as const, id, other };
    });
    return html`Lines meet at every seam. ${what}
      <button
        type="button"
        class="link"
        id="show-turned"
        @click=${() => void attempt(this.app, () => showPlaces(this.app, places))}
      >
        Show
      </button>`;
  }
}
customElements.define('hgp-seam-note', SeamNote);
