// The column at the side: model, cones, boundaries and handles, result.

import { html, nothing, type TemplateResult } from 'lit';
import type { App } from '../state/app';
import { change } from '../state/load';
import { result } from './certificate';
import { cones } from './cones';
import type { Controls } from './controls';
import { solve } from './solve';
import { turnings } from './turnings';
import { typed } from './typed';

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

const repairNames = {
  split: 'split non-manifold places',
  orient: 'turn triangles round',
  degenerate: 'remove degenerate triangles',
};

function weld(app: App): TemplateResult {
  const set = (event: Event): void => {
    const text = (event.target as HTMLInputElement).value.trim();
    const length = text === '' ? undefined : Number(text);
    if (length !== undefined && !(length >= 0)) return;
    if (length === app.loaded.weld) return;
    const kind = length === undefined ? 'weld as the format needs' : `weld closer than ${length}`;
    void change(app, { ...app.loaded, weld: length }, kind);
  };
  const example = (1e-6 * (app.info?.diagonal ?? 1)).toPrecision(1);
  return html`<div class="row field">
    <label for="weld">Join vertices closer than</label>
    <input
      id="weld"
      class="length"
      type="number"
      min="0"
      step="any"
      placeholder="exact"
      title="In units of the file, for example ${example}"
      .value=${typed(app.loaded.weld === undefined ? '' : String(app.loaded.weld))}
      @change=${set}
    />
  </div>`;
}

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
                    const settings = app.loaded;
                    const more = { ...settings, fix: { ...settings.fix, [fix[0]]: true } };
                    void change(app, more, repairNames[fix[0]]);
                  }}
                >
                  ${fix[1]}
                </button>`
              : nothing
          }
        </span>
      </li>`;
    })}
    ${
      app.info?.usable
        ? nothing
        : html`<li>
            <button type="button" class="small" @click=${() => ui.chooseFiles()}>Other file</button>
          </li>`
    }
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
    ['Diagonal', info.diagonal.toPrecision(4)],
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
    ${defects(app, ui)} ${weld(app)}
    ${[...app.remarks, ...(surface?.notes ?? []), ...info.notes].map((note) => html`<p class="note">${note}</p>`)}
  </details>`;
}

export function inspector(app: App, ui: Controls): TemplateResult {
  const isUsable = app.info?.usable ?? false;
  return html`
    ${app.shown ? result(app, ui) : nothing} ${isUsable ? cones(app, ui) : nothing}
    ${isUsable ? turnings(app, ui) : nothing} ${isUsable ? solve(app, ui) : nothing}
    ${app.info ? model(app, ui) : nothing}
    <p class="note guide">
      <a href="./guide.html">How cones work, and what to do with the result</a>
    </p>
  `;
}
