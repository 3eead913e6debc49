// The Model panel: facts on the mesh, its defects, and the repairs for them.

import { html, nothing, type TemplateResult } from 'lit';
import { attempt } from '../actions/app';
import { reloadWith } from '../actions/load';
import { repair, repairAll } from '../actions/repair';
import { showPlaces } from '../actions/view';
import { canRepair, repairFor, type Repair } from '../model/repairs';
import type { Model } from '../model/types';
import { count } from '../text/format';
import { noteForPage, weldIn } from '../text/notes';
import { actionButton } from './action_button';
import { keepWhileTyping } from './keep_while_typing';
import { Panel } from './panel';

/** Of one, and of several. */
const defectNames: Record<string, [string, string]> = {
  'non-manifold-edge': ['Edge with more than two triangles', 'Edges with more than two triangles'],
  'non-manifold-vertex': [
    'Vertex where fans of triangles touch',
    'Vertices where fans of triangles touch',
  ],
  'inconsistent-edge': [
    'Edge between triangles of opposite orientation',
    'Edges between triangles of opposite orientation',
  ],
  'zero-area': ['Triangle without area', 'Triangles without area'],
  'duplicate-face': ['Duplicate triangle', 'Duplicate triangles'],
  'repeated-vertex': ['Triangle that uses a vertex twice', 'Triangles that use a vertex twice'],
  'isolated-vertex': ['Vertex without triangles', 'Vertices without triangles'],
  'not-finite': ['Position that is not a number', 'Positions that are not numbers'],
  extent: ['Too large or too small to compute with', 'Too large or too small to compute with'],
  'index-out-of-range': [
    'Triangle that refers to a missing vertex',
    'Triangles that refer to missing vertices',
  ],
};

function defectName(kind: string, found: number): string {
  const [one, several] = defectNames[kind] ?? Array<string>(2).fill(kind.replaceAll('-', ' '));
  return found === 1 ? one : several;
}

const repairLabels: Record<Repair, string> = {
  split: 'Split them',
  orient: 'Turn triangles round',
  degenerate: 'Remove them',
};

class ModelPanel extends Panel {
  override render(): TemplateResult | typeof nothing {
    const { model } = this.app.doc;
    if (!model) return nothing;
    const { info, remarks } = model;
    const told = [...(info.surfaces[info.surface]?.notes ?? []), ...info.notes];
    const notes = [...remarks, ...told.map((note) => noteForPage(note))];
    return html`<details open id="panel-model">
      <summary>Model</summary>
      ${this.#facts(model)} ${this.#defects(model)} ${this.#weld(model)}
      ${notes.map((note) => html`<p class="note">${note}</p>`)} ${this.#weldButton(model)}
    </details>`;
  }

  #facts({ info }: Model): TemplateResult {
    const stored = info.surfaces[info.surface]?.storedVertices ?? info.vertices;
    const isWelded = stored !== info.vertices;
    const rows: [string, string | number, string?][] = [
      ['Vertices', isWelded ? `${count(stored)} → ${count(info.vertices)}` : count(info.vertices)],
      ['Triangles', count(info.triangles)],
      ['Diagonal', info.diagonal.toPrecision(4)],
    ];
    if (info.usable) {
      rows.push(
        ['Components', info.components?.length ?? 1],
        ['Genus g', info.genus ?? 0, 'The number of handles: a ball has none, a cup one'],
        ['Boundaries', info.boundaryLoops ?? 0],
        ['Euler χ', info.eulerCharacteristic ?? 0, 'Cones and boundaries add up to q times this'],
      );
    }
    return html`<dl class="facts">
      ${rows.map(
        ([name, value, hint = '']) =>
          html`<div title=${hint || nothing}>
            <dt>${name}</dt>
            <dd>${value}</dd>
          </div>`,
      )}
    </dl>`;
  }

  /** A button for one repair, or for all repairs if that one was made and did not suffice. */
  #fixButton(model: Model, fix: Repair | undefined): TemplateResult | typeof nothing {
    if (!fix || !canRepair(model)) return nothing;
    const isMade = model.loaded.fix[fix] === true;
    const act = (): Promise<boolean> => (isMade ? repairAll(this.app) : repair(this.app, [fix]));
    return html`<button
      type="button"
      class="small"
      data-fix=${isMade ? 'all' : fix}
      @click=${() => void attempt(this.app, act)}
    >
      ${isMade ? 'Repair all' : repairLabels[fix]}
    </button>`;
  }

  #defects(model: Model): TemplateResult | typeof nothing {
    const { app } = this;
    const { info } = model;
    if (info.defects.length === 0) return nothing;
    return html`<ul class="defects">
      ${info.defects.map(({ kind, count: found, where, fatal }) => {
        const fix = fatal ? repairFor[kind] : undefined;
        return html`<li class=${fatal ? 'fatal' : ''}>
          <span><b>${count(found)}</b> ${defectName(kind, found)}</span>
          <span class="row">
            <button
              type="button"
              class="small"
              data-show=${kind}
              @click=${() => showPlaces(app, where)}
            >
              Show
            </button>
            ${this.#fixButton(model, fix)}
          </span>
        </li>`;
      })}
      ${
        info.usable
          ? nothing
          : html`<li>
              ${actionButton(app, 'open', { domId: 'other-file', className: 'small', text: 'Other file' })}
            </li>`
      }
    </ul>`;
  }

  /** What a note recommends, by one click. */
  #weldButton({ info, loaded }: Model): TemplateResult | typeof nothing {
    const { app } = this;
    const weld = weldIn(info.notes);
    if (weld === undefined || loaded.weld !== undefined) return nothing;
    const kind = weld === 0 ? 'join equal positions' : `weld closer than ${weld}`;
    const act = (): void => void attempt(app, () => reloadWith(app, { ...loaded, weld }, kind));
    return html`<p class="row">
      <button type="button" class="small" id="weld-now" ?disabled=${app.doc.isBusy} @click=${act}>
        Join them
      </button>
    </p>`;
  }

  #weld({ info, loaded }: Model): TemplateResult {
    const { app } = this;
    const set = (event: Event): void => {
      this.requestUpdate(); // the field shows what holds, whatever was typed
      const text = (event.target as HTMLInputElement).value.trim();
      const weld = text === '' ? undefined : Number(text);
      if ((weld !== undefined && !(weld >= 0)) || weld === loaded.weld) return;
      const kind = weld === undefined ? 'weld as the format needs' : `weld closer than ${weld}`;
      void attempt(app, () => reloadWith(app, { ...loaded, weld }, kind));
    };
    const example = (1e-6 * info.diagonal).toPrecision(1);
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
        .value=${keepWhileTyping(loaded.weld === undefined ? '' : String(loaded.weld))}
        @change=${set}
      />
    </div>`;
  }
}
customElements.define('hgp-model-panel', ModelPanel);
