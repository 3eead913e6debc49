// A bar under the UV view that is as long as it says: in cells of an aligned map, otherwise in uv.

import { html, nothing, type TemplateResult } from 'lit';
import { isAligned } from '../model/grid';
import { niceLength } from '../model/nice_length';
import { plural } from '../text/format';
import { Panel } from './panel';

const longest = 110; // pixels

class MapScale extends Panel {
  override render(): TemplateResult | typeof nothing {
    const { ui, doc } = this.app;
    if (!doc.displayed || !(ui.mapScale > 0)) return nothing;
    const isCells = isAligned(doc.displayed);
    const length = this.#length;
    const text = isCells && length >= 1 ? plural(length, 'cell') : `${length} ${isCells ? 'cells' : 'uv'}`; // prettier-ignore
    return html`<p class="map-scale"><i></i>${text}</p>`;
  }

  get #length(): number {
    return niceLength(longest / this.app.ui.mapScale);
  }

  protected override updated(): void {
    const bar = this.querySelector('i');
    // The content security policy forbids style attributes.
    if (bar) bar.style.width = `${(this.#length * this.app.ui.mapScale).toFixed(1)}px`;
  }
}
customElements.define('hgp-map-scale', MapScale);
