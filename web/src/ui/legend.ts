// What the colours of the overlay mean, in numbers.

import { html, nothing, type TemplateResult } from 'lit';
import type { App } from '../state/app';
import { legendOf } from '../view/geometry';

export function legend(app: App): TemplateResult | typeof nothing {
  const solved = app.shown;
  if (!solved) return nothing;
  if (app.look.overlay === 'flips') {
    const count = solved.distortion.flipped.length;
    const text = count === 0 ? 'No triangle is folded' : `${count} folded, in red`;
    return html`<p class="legend"><b>Flips</b><span>${text}</span></p>`;
  }
  const scale = legendOf(solved, app.look.overlay);
  if (!scale) return nothing;
  return html`<div class="legend">
    <b>${scale.title}</b>
    <i class=${scale.kind}></i>
    <span class="ends"
      ><span>${scale.low}</span><span>${scale.middle}</span><span>${scale.high}</span></span
    >
  </div>`;
}
