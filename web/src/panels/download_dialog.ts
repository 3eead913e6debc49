// The Download dialog: one button for the program in which the file is used next; all formats and choices under More.

import { html, nothing, type TemplateResult } from 'lit';
import { attempt, type AppView } from '../actions/app';
import { download, exportSource } from '../actions/download';
import { mappedMeshes } from '../actions/download_all';
import { perform } from '../actions/registry';
import { rewrite } from '../actions/solve';
import { downloadQuads, quadName, whyNoQuads } from '../actions/quads';
import { formats, nameOf, type ExportSource, type Format } from '../formats/exports';
import { isGltf, isGltfModel } from '../formats/glb';
import { formatFor, setHint, targets, textureHint } from '../formats/targets';
import { chosenSet, textureFate } from '../model/texture_fate';
import { isAligned } from '../model/grid';
import type { Model, Output, Solution } from '../model/types';
import type { TargetId } from '../model/ui_state';
import { isCertified } from '../model/verdict';
import { noteForPage } from '../text/notes';
import { dialogFrame } from './dialog_frame';
import { icon } from './icons';

const scales: [Output['scale'], string][] = [
  ['solved', 'As solved'],
  ['unit', 'Average edge 1'],
  ['fit', 'Into the unit square'],
];

const valueOf = (event: Event): string => (event.target as HTMLSelectElement).value;
const isChecked = (event: Event): boolean => (event.target as HTMLInputElement).checked;

/** glTF: whether the textures of the file use the new coordinates or keep the old ones, or which set is replaced. */
function setChooser(app: AppView, solution: Solution): TemplateResult | typeof nothing {
  const model = app.doc.model!;
  const sets = model.info.surfaces[model.info.surface]?.uvSets ?? [];
  if (!isGltfModel(model) || sets.length === 0) return nothing;
  const chosen = chosenSet(app.doc.pendingOutput ?? solution.output, solution);
  const set = (event: Event): void => {
    const value = valueOf(event);
    const uvSet = /\d/.test(value) ? Number(value) : undefined;
    void attempt(app, () => rewrite(app, { uvSet, usesNewSet: value === 'use' }));
  };
  const choice = (value: string, text: string): TemplateResult =>
    html`<option value=${value} ?selected=${chosen === value}>${text}</option>`;
  const replacing = sets.map((n) => choice(String(n), `replace TEXCOORD_${n} by the new ones`));
  const usual = textureFate(solution)
    ? [choice('keep', 'keep the old coordinates'), choice('use', 'use the new coordinates; the old ones are kept')] // prettier-ignore
    : choice(chosen === 'use' ? 'use' : 'keep', 'stay beside the new ones');
  return html`<label
    >${textureFate(solution) ? 'The file’s own textures' : 'The old coordinates'}
    <select id="uv-set" @change=${set}>
      ${usual}${replacing}
    </select>
  </label>`;
}

/** Choices that change the written file; after each, the file is written, read back and verified again. */
function choices(app: AppView, solution: Solution): TemplateResult {
  const output = app.doc.pendingOutput ?? solution.output;
  const set = (part: Partial<Output>): void => void attempt(app, () => rewrite(app, part));
  return html`<div class="choices">
    <label
      >Scale
      <select
        id="uv-scale"
        @change=${(event: Event) => set({ scale: valueOf(event) as Output['scale'] })}
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
        @change=${(event: Event) => set({ embedCones: isChecked(event) })}
      />
      Embed the cones, to edit them again
    </label>
    <label class="tick">
      <input
        type="checkbox"
        id="grid-material"
        .checked=${output.hasGrid}
        @change=${(event: Event) => set({ hasGrid: isChecked(event) })}
      />
      <span
        >Assign a grid as material
        <small>An OBJ is then a ZIP, with its .mtl and image.</small></span
      >
    </label>
  </div>`;
}

/** Runs the Khronos validator on request. */
function validation(app: AppView, solution: Solution): TemplateResult {
  const { doc } = app;
  const seen = doc.validation?.of === solution ? doc.validation : undefined;
  const isIt = isGltf(solution.written.files[0].name);
  return html`<div class="validation">
    <button
      type="button"
      class="small"
      id="validate"
      ?disabled=${doc.isBusy}
      @click=${() => void perform(app, 'validate')}
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

function formatButton(
  app: AppView,
  source: ExportSource,
  { format, label, hint }: (typeof formats)[number],
): TemplateResult {
  return html`<li>
    <button
      type="button"
      class="wide-button"
      data-format=${format}
      ?disabled=${app.doc.isBusy}
      @click=${() => void save(app, format)}
    >
      <b>${label}</b><small>${nameOf(source, format)} · ${hint}</small>
    </button>
  </li>`;
}

function save(app: AppView, format: Format): Promise<void> {
  return attempt(app, async () => {
    await download(app, format);
    app.ui.dialog = '';
  });
}

/** Closes the dialog first, because the map may have to be run again, and the progress is shown behind it. */
function saveQuads(app: AppView, file: 'obj' | 'glb'): Promise<void> {
  app.ui.dialog = '';
  return attempt(app, () => downloadQuads(app, file));
}

function targetChooser({ ui }: AppView): TemplateResult {
  return html`<label
    >Use it in
    <select id="target" @change=${(event: Event) => ui.setTarget(valueOf(event) as TargetId)}>
      ${targets.map(({ id, label }) => html`<option value=${id} ?selected=${ui.target === id}>${label}</option>`)}
    </select>
  </label>`;
}

/** The button that saves the file for the chosen program. */
function mainButton(app: AppView, source: ExportSource): TemplateResult {
  const { isBusy } = app.doc;
  const format = formatFor(app.ui.target, source.solution.files[0].name);
  const isQuads = format === 'quads';
  const why = isQuads ? whyNoQuads(app) : '';
  const name = isQuads ? quadName(app, 'obj') : nameOf(source, format);
  const act = (): void => void (isQuads ? saveQuads(app, 'obj') : save(app, format));
  return html`<p>
      <button
        type="button"
        class="primary big"
        data-format=${format}
        autofocus
        ?disabled=${isBusy || why !== ''}
        @click=${act}
      >
        ${icon('download')} Save ${name}
      </button>
    </p>
    <p class="note" id="target-hint">${why || hintOf(app, source.solution)}</p>
    ${ownTextures(app, source.solution)}`;
}

/** The number of the set that is written; 0 for formats with one. */
function writtenSet(model: Model, { uvSet }: Output): number {
  const { info } = model;
  const sets = info.surfaces[info.surface]?.uvSets ?? [];
  let free = 0;
  while (sets.includes(free)) free += 1;
  return isGltfModel(model) ? (uvSet ?? free) : 0;
}

/** A sentence on the textures of the file, if it has some on a mesh with coordinates. */
function ownTextures(app: AppView, solution: Solution): TemplateResult | typeof nothing {
  const { info } = app.doc.model!;
  const hasOld = (info.surfaces[info.surface]?.uvSets ?? []).length > 0;
  const fate = textureFate(solution);
  if (app.ui.target === 'quads' || !fate || (!hasOld && fate === 'kept')) return nothing;
  return html`<p class="note" id="own-textures">${textureHint(fate)}</p>`;
}

function hintOf(app: AppView, solution: Solution): string {
  const { ui } = app;
  const { hint } = targets.find(({ id }) => id === ui.target)!;
  if (ui.target !== 'quads') {
    const unit = isAligned(solution)
      ? ' One repeat of an image is one cell; it fits across every seam.'
      : '';
    const set = solution.output.hasGrid ? 0 : writtenSet(app.doc.model!, solution.output);
    return [`${hint}${unit}`, setHint(ui.target, set)].filter(Boolean).join(' ');
  }
  const isThere = isAligned(solution) && solution.grid.mode === 'quad';
  const rest = 'They are made with the cones on grid points; the map that you see stays.';
  return isThere ? hint : `${hint} ${rest}`;
}

function quadButtons(app: AppView): TemplateResult[] {
  const files = [
    ['obj', 'Quad mesh (OBJ)', 'the cells of the grid, with normals'],
    ['glb', 'Quad mesh (GLB)', 'two triangles for each, to look at'],
  ] as const;
  const why = whyNoQuads(app);
  return files.map(
    ([file, label, hint]) =>
      html`<li>
        <button
          type="button"
          class="wide-button"
          data-format="quads-${file}"
          ?disabled=${app.doc.isBusy || why !== ''}
          @click=${() => void saveQuads(app, file)}
        >
          <b>${label}</b><small>${why || `${quadName(app, file)} · ${hint}`}</small>
        </button>
      </li>`,
  );
}

/** Meshes of the file that the download leaves without a map. */
function withoutMap(count: number): string {
  if (count === 0) return '';
  const which = count === 1 ? 'One mesh of the file has' : `${count} meshes of the file have`;
  return ` ${which} no map yet; Run all makes ${count === 1 ? 'it' : 'them'}.`;
}

function summary(app: AppView, solution: Solution): string {
  const mapped = mappedMeshes(app).length;
  const { surfaces } = app.doc.model!.info;
  const missing = withoutMap(surfaces.length - mapped);
  if (mapped > 1)
    return `One file with the new coordinates of ${mapped} meshes; all else stays as it was.${missing}`;
  return `${ofOneMesh(app, solution)}${missing}`;
}

function ofOneMesh(app: AppView, { notes, preserved, result }: Solution): string {
  const { info } = app.doc.model!;
  const stored = info.surfaces[info.surface]?.storedVertices ?? 0;
  const rest = `All else in the file stays as it was${preserved ? `: ${preserved}` : ''}.`;
  if (notes.length > 0) return `${notes.map((note) => noteForPage(note)).join('; ')}. ${rest}`;
  return `${stored} vertices; ${result.uvToVertex.length} texture coordinates, because seams are split.`;
}

export function downloadDialog(app: AppView, solution: Solution): TemplateResult {
  const close = (): void => void (app.ui.dialog = '');
  const source = exportSource(app);
  if (!source) return html``;
  const isGood = isCertified(solution);
  const { isBusy } = app.doc;
  const main = formatFor(app.ui.target, solution.files[0].name);
  const others = formats.filter(({ format }) => format !== main);
  return dialogFrame(
    'downloads',
    isGood ? 'Download' : 'Download uncertified result',
    html`${
        isGood
          ? nothing
          : html`<p class="note bad">
              This map does not pass its checks; see the certificate for which.
            </p>`
      }
      <div class="choices">
        ${targetChooser(app)} ${app.ui.target === 'quads' ? nothing : setChooser(app, solution)}
      </div>
      ${mainButton(app, source)}
      ${app.ui.target === 'quads' ? nothing : html`<p class="note">${summary(app, solution)}</p>`}
      <details id="more-formats">
        <summary>More: other formats, scale, validation</summary>
        <ul class="list" aria-busy=${isBusy}>
          ${others.map((one) => formatButton(app, source, one))} ${quadButtons(app)}
        </ul>
        ${choices(app, solution)} ${validation(app, solution)}
      </details>
      <p class="row end"><button type="button" @click=${close}>Close</button></p>`,
    close,
  );
}
