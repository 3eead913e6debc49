// What is saved, in which format, and how it goes into the file.

import { html, nothing, type TemplateResult } from 'lit';
import type { App } from '../state/app';
import { formats, make, nameOf, save } from '../state/exports';
import { rewrite } from '../state/run';
import type { Output, Solved } from '../state/solved';
import { validate } from '../state/validate';
import type { Controls } from './controls';
import { frame } from './dialogs';

const scales: [Output['scale'], string][] = [
  ['solved', 'As solved'],
  ['unit', 'Average edge 1'],
  ['fit', 'Into the unit square'],
];

/** The choices that change the written file; each is written, read back and judged again. */
function choices(app: App, solved: Solved): TemplateResult {
  const output = app.wanted ?? solved.output;
  const surface = app.info?.surfaces[app.info.surface];
  const isGltf = /^(glb|gltf)$/.test(app.info?.file.format ?? '');
  const set = (part: Partial<Output>): void => void rewrite(app, part);
  const value = (event: Event): string => (event.target as HTMLSelectElement).value;
  const sets = surface?.uvSets ?? [];
  return html`<div class="choices">
    ${
      isGltf && sets.length > 0
        ? html`<label
            >Texture coordinates
            <select
              id="uv-set"
              @change=${(event: Event) => set({ uvSet: value(event) === 'next' ? undefined : Number(value(event)) })}
            >
              <option value="next" ?selected=${output.uvSet === undefined}>
                next free: TEXCOORD_${sets.length}
              </option>
              ${sets.map(
                (n) =>
                  html`<option value=${n} ?selected=${output.uvSet === n}>
                    replace TEXCOORD_${n}
                  </option>`,
              )}
            </select>
          </label>`
        : nothing
    }
    <label
      >Scale
      <select
        id="uv-scale"
        @change=${(event: Event) => set({ scale: value(event) as Output['scale'] })}
      >
        ${scales.map(
          ([scale, name]) =>
            html`<option value=${scale} ?selected=${output.scale === scale}>${name}</option>`,
        )}
      </select>
    </label>
    <label class="tick">
      <input
        type="checkbox"
        id="embed-cones"
        .checked=${output.embedCones}
        @change=${(event: Event) => set({ embedCones: (event.target as HTMLInputElement).checked })}
      />
      Embed the cones, to edit them again
    </label>
    <label class="tick">
      <input
        type="checkbox"
        id="grid-material"
        .checked=${output.hasGrid}
        @change=${(event: Event) => set({ hasGrid: (event.target as HTMLInputElement).checked })}
      />
      <span
        >Assign a grid as material
        <small>An OBJ is then a ZIP, with its .mtl and image.</small></span
      >
    </label>
  </div>`;
}

/** Khronos' validator, on request. */
function validation(app: App, solved: Solved, isBusy: boolean): TemplateResult {
  const seen = app.validation?.of === solved ? app.validation : undefined;
  const isIt = /\.(glb|gltf)$/i.test(solved.written.files[0].name);
  return html`<div class="validation">
    <button
      type="button"
      class="small"
      id="validate"
      ?disabled=${isBusy}
      @click=${() => void validate(app, solved)}
    >
      Validate ${isIt ? 'output' : 'the GLB'}
    </button>
    <p class="note ${seen && !seen.isGood ? 'bad' : ''}" role="status" id="validation">
      ${seen?.text ?? ''}
    </p>
    ${
      seen && seen.issues.length > 0
        ? html`<ul class="note">
            ${seen.issues.map((text) => html`<li>${text}</li>`)}
          </ul>`
        : nothing
    }
  </div>`;
}

export function downloads(app: App, ui: Controls, solved: Solved): TemplateResult {
  const close = (): void => ui.show('');
  const isBusy = app.phase !== 'editing';
  const { info } = app;
  const stored = info?.surfaces[info.surface]?.storedVertices ?? 0;
  const { notes } = solved;
  return frame(
    'downloads',
    solved.isCertified ? 'Download' : 'Download uncertified result',
    html`${
        solved.isCertified
          ? nothing
          : html`<p class="note bad">
              This map does not pass its checks; see the certificate for which.
            </p>`
      }
      <p class="note">
        ${
          notes.length > 0
            ? `${notes.join('; ')}. All else in the file stays as it was${solved.kept ? `: ${solved.kept}` : ''}.`
            : `${stored} vertices; ${solved.result.uvToVertex.length} texture vertices, as seams are split.`
        }
      </p>
      <ul class="list" aria-busy=${isBusy}>
        ${formats.map(({ format, label, hint }) => {
          return html`<li>
            <button
              type="button"
              class="wide-button"
              data-format=${format}
              ?autofocus=${format === 'same'}
              ?disabled=${isBusy}
              @click=${() => {
                save(make(app, solved, format));
                app.isUnsaved = false;
                close();
              }}
            >
              <b>${label}</b><small>${nameOf(app, solved, format)} · ${hint}</small>
            </button>
          </li>`;
        })}
      </ul>
      ${choices(app, solved)} ${validation(app, solved, isBusy)}
      <p class="row end"><button type="button" @click=${close}>Close</button></p>`,
    close,
  );
}
