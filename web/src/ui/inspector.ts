// The column at the side: model, cones, boundaries and handles, result.

import { html, nothing, type TemplateResult } from 'lit';
import type { App } from '../state/app';
import { load } from '../state/open';
import { result } from './certificate';
import { cones } from './cones';
import type { Controls } from './controls';
import { turnings } from './turnings';

const number = new Intl.NumberFormat('en');
const count = (n: number | undefined): string => number.format(n ?? 0).replaceAll(',', ' ');

const defectNames: Record<string, string> = {
  'non-manifold-edge': 'Edges with more than two triangles',
  'non-manifold-vertex': 'Vertices where fans of triangles touch',
  'inconsistent-edge': 'Edges between triangles of opposite orientation',
  'zero-area': 'Triangles without area',
  'duplicate-face': 'Duplicate triangles',
  'repeated-vertex': 'Triangles that use a vertex twice',
  'isolated-vertex': 'Vertices without triangles',
  'not-finite': 'Positions that are no numbers',
  extent: 'Too large or too small to compute with',
  'index-out-of-range': 'Triangles naming missing vertices',
};

const fixes: Record<string, ['split' | 'orient' | 'degenerate', string]> = {
  'non-manifold-edge': ['split', 'Split them'],
  'non-manifold-vertex': ['split', 'Split them'],
  'inconsistent-edge': ['orient', 'Turn triangles round'],
  'zero-area': ['degenerate', 'Remove them'],
  'repeated-vertex': ['degenerate', 'Remove them'],
  'duplicate-face': ['degenerate', 'Remove them'],
};

function defects(app: App, ui: Controls): TemplateResult | typeof nothing {
  const list = app.info?.defects ?? [];
  if (list.length === 0) return nothing;
  return html`<ul class="defects">
    ${list.map(({ kind, count: found, where, fatal }) => {
      const fix = fatal ? fixes[kind] : undefined;
      return html`<li class=${fatal ? 'fatal' : ''}>
        <span><b>${count(found)}</b> ${defectNames[kind] ?? kind}</span>
        <span class="row">
          <button
            type="button"
            class="small"
            data-show=${kind}
            @click=${() => ui.showPlaces(where)}
          >
            Show
          </button>
          ${
            fix
              ? html`<button
                  type="button"
                  class="small"
                  data-fix=${fix[0]}
                  @click=${() => {
                    app.settings.fix = { ...app.settings.fix, [fix[0]]: true };
                    void load(app, app.info!.surface);
                  }}
                >
                  ${fix[1]}
                </button>`
              : nothing
          }
        </span>
      </li>`;
    })}
  </ul>`;
}

function model(app: App, ui: Controls): TemplateResult {
  const info = app.info!;
  const surface = info.surfaces[info.surface];
  const vertices =
    surface && surface.storedVertices !== info.vertices
      ? `${count(surface.storedVertices)} → ${count(info.vertices)}`
      : count(info.vertices);
  const rows: [string, string | number][] = [
    ['Vertices', vertices],
    ['Triangles', count(info.triangles)],
  ];
  if (info.usable) {
    rows.push(
      ['Parts', info.components?.length ?? 1],
      ['Genus g', info.genus ?? 0],
      ['Boundaries', info.boundaryLoops ?? 0],
      ['Euler χ', info.eulerCharacteristic ?? 0],
    );
  }
  return html`<details open id="panel-model">
    <summary>Model</summary>
    <dl class="facts">
      ${rows.map(
        ([name, value]) =>
          html`<div>
            <dt>${name}</dt>
            <dd>${value}</dd>
          </div>`,
      )}
    </dl>
    ${defects(app, ui)}
    ${[...(surface?.notes ?? []), ...info.notes].map((note) => html`<p class="note">${note}</p>`)}
  </details>`;
}

export function inspector(app: App, ui: Controls): TemplateResult {
  const isUsable = app.info?.usable ?? false;
  return html`
    ${app.shown ? result(app, ui) : nothing} ${isUsable ? cones(app, ui) : nothing}
    ${isUsable ? turnings(app, ui) : nothing} ${app.info ? model(app, ui) : nothing}
    <p class="note guide">
      <a href="./guide.html">How cones work, and what to do with the result</a>
    </p>
  `;
}
