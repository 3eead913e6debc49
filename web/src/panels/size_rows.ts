// What a user sees of the quality of a map: stretch, sizes, overlaps, each with its value before the last run, and the
// way out where sizes differ much.

import { html, nothing, type TemplateResult } from 'lit';
import type { Where } from 'hgp';
import { attempt, type AppView } from '../actions/app';
import { evenOut } from '../actions/even_out';
import { showPlaces } from '../actions/view';
import { shareText } from '../model/compare';
import type { Solution } from '../model/types';
import { count, percentText, timesText } from '../text/format';

/** From here on sizes are said to differ much. */
const much = 10;

const places = (triangles: Uint32Array): Where[] =>
  Array.from(triangles, (id): Where => ({ kind: 'triangle', id }));

/** A number, and what it was before if that differs as written. */
function withBefore(
  id: string,
  now: number,
  before: number | undefined,
  text: (x: number) => string,
): TemplateResult {
  const old = before === undefined ? '' : text(before);
  const isNew = old !== '' && old !== text(now);
  return html`<dd id=${id}>
    ${
      isNew
        ? html`<small class="before"
            ><span class="visually-hidden">before: </span>${old} <span aria-hidden="true">→</span
            ><span class="visually-hidden">, now: </span></small
          >`
        : nothing
    }
    <span class=${isNew ? (now < before! ? 'better' : 'worse') : ''}>${text(now)}</span>
  </dd>`;
}

function overlapRow(app: AppView, { overlaps, result }: Solution): TemplateResult {
  const share = 100 * result.certificate.overlap.share;
  const show = (): void => showPlaces(app, places(overlaps.triangles));
  return html`<div
    title="Distant parts of the map may lie on top of each other; neighbours never do"
  >
    <dt>Overlaps</dt>
    <dd id="overlaps">
      ${
        result.certificate.overlap.layers <= 1
          ? 'none'
          : html`${shareText(share)} of the area
              <button type="button" class="link" @click=${show}>Show</button>`
      }
    </dd>
  </div>`;
}

/** Where the pattern is ten times larger than elsewhere, and cones that would even it out. */
function sizeNote(
  app: AppView,
  { sizes }: Solution,
  isCurrent: boolean,
): TemplateResult | typeof nothing {
  const { range, larger, smaller } = sizes;
  if (range < much) return nothing;
  const canAdd = larger.vertices.length + smaller.vertices.length > 0;
  const outlined = larger.triangles.length > 0 ? larger : smaller;
  const show = (): void => showPlaces(app, places(outlined.triangles), outlined.vertices[0]);
  const act = (): void => void attempt(app, () => evenOut(app));
  return html`<div class="note warn" id="sizes-differ">
    <p>
      The pattern is ${count(Math.round(range))} times larger in some places than in others; on
      ${percentText(100 * outlined.share)} of the surface it is much
      ${outlined === larger ? 'larger' : 'smaller'} than usual.
    </p>
    <p class="row">
      <button type="button" class="small" @click=${show}>Show</button>
      ${
        isCurrent && canAdd
          ? html`<button type="button" class="small" ?disabled=${app.doc.isBusy} @click=${act}>
              Add cones there and run
            </button>`
          : nothing
      }
    </p>
  </div>`;
}

export function sizeRows(app: AppView, solution: Solution): TemplateResult {
  const { sizes } = solution;
  const before = app.doc.beforeDisplayed?.sizes;
  return html`<dl class="facts plain">
      <div
        title="How much longer one direction is than the other; half of the surface is stretched more"
      >
        <dt>Typical stretch</dt>
        ${withBefore(
          'stretch',
          100 * (sizes.typicalStretch - 1),
          before && 100 * (before.typicalStretch - 1),
          percentText,
        )}
      </div>
      <div
        title="How much larger the pattern is at the 95 % mark of the surface than at the 5 % mark"
      >
        <dt>Size varies <small>(5–95 %)</small></dt>
        ${withBefore('size', sizes.spread, before?.spread, timesText)}
      </div>
      ${overlapRow(app, solution)}
    </dl>
    ${sizeNote(app, solution, app.doc.current === solution)}`;
}
