// The legend of the overlay's colours, with numbers.

import { html, nothing, type TemplateResult } from 'lit';
import type { Overlay, Solution } from '../model/types';
import { areaLimit, seamLimit, stretchLimit } from '../services/geometry/overlay_colours';
import { Panel } from './panel';

interface Scale {
  title: string;
  low: string;
  middle: string;
  high: string;
  kind: 'sequential' | 'diverging';
}

function scaleOf({ distortion }: Solution, overlay: Overlay): Scale | undefined {
  if (overlay === 'angle') {
    const max = stretchLimit(distortion);
    const [middle, high] = [(1 + max) / 2, max].map((x) => x.toFixed(2));
    return { title: 'Stretch σ₁/σ₂', low: '1', middle, high: `≥ ${high}`, kind: 'sequential' };
  }
  if (overlay === 'seams') {
    const max = seamLimit(distortion);
    const [middle, end] = [max / 2, max].map((x) => x.toPrecision(2));
    return { title: 'Distance to a seam', low: '0', middle, high: `≥ ${end}`, kind: 'sequential' };
  }
  if (overlay !== 'area') return undefined;
  const factor = (2 ** areaLimit(distortion)).toPrecision(2);
  return { title: 'Area', low: `÷ ${factor}`, middle: '1', high: `× ${factor}`, kind: 'diverging' };
}

class Legend extends Panel {
  override render(): TemplateResult | typeof nothing {
    const { displayed, look } = this.app.doc;
    if (!displayed) return nothing;
    if (look.overlay === 'flips') {
      const { length } = displayed.distortion.flipped;
      const text = length === 0 ? 'none' : `${length}, in red`;
      return html`<p class="legend"><b>Folded triangles</b><span>${text}</span></p>`;
    }
    const scale = scaleOf(displayed, look.overlay);
    if (!scale) return nothing;
    return html`<div class="legend">
      <b>${scale.title}</b>
      <i class=${scale.kind}></i>
      <span class="ends"
        ><span>${scale.low}</span><span>${scale.middle}</span><span>${scale.high}</span></span
      >
    </div>`;
  }
}
customElements.define('hgp-legend', Legend);
