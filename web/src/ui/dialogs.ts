// Everything that asks: missing files, which model, which mesh, what to download, help.

import { html, nothing, type TemplateResult } from 'lit';
import type { App } from '../state/app';
import { formats, make, save } from '../state/exports';
import { load, loadWithoutImages, openMain, supply } from '../state/open';
import type { Controls } from './controls';

function frame(id: string, title: string, body: TemplateResult, close: () => void): TemplateResult {
  return html`<dialog id=${id} aria-labelledby="${id}-title" @cancel=${close} @close=${close}>
    <h2 id="${id}-title">${title}</h2>
    ${body}
  </dialog>`;
}

function missingFiles(app: App): TemplateResult {
  const isNeeded = app.missing.some((file) => file.isNeeded);
  const browse = (name: string) => (event: Event) => {
    const file = (event.target as HTMLInputElement).files?.[0];
    if (file) void supply(app, new Map([[name, file]]));
  };
  const stop = (): void => {
    if (app.phase !== 'needs-files') return;
    app.phase = 'empty';
    app.changed();
  };
  return frame(
    'needs-files',
    'Some files are missing',
    html`<p>“${app.main}” names files that are not here. Drop them on the page, or browse:</p>
      <ul class="list">
        ${app.missing.map(
          ({ name, isNeeded: must }) =>
            html`<li>
              <span><code>${name}</code><small>${must ? 'needed' : 'image'}</small></span>
              <label class="button small"
                >Browse<input
                  type="file"
                  class="unseen"
                  aria-label="Browse for ${name}"
                  @change=${browse(name)}
              /></label>
            </li>`,
        )}
      </ul>
      <p class="row end">
        <button type="button" @click=${stop}>Cancel</button>
        ${
          isNeeded
            ? nothing
            : html`<button
                type="button"
                class="strong"
                id="without-images"
                @click=${() => void loadWithoutImages(app)}
              >
                Continue without images
              </button>`
        }
      </p>`,
    stop,
  );
}

function whichModel(app: App): TemplateResult {
  const stop = (): void => {
    if (app.phase !== 'pick-mesh') return;
    app.phase = 'empty';
    app.candidates = [];
    app.changed();
  };
  return frame(
    'pick-model',
    'Which model?',
    html`<ul class="list">
        ${app.candidates.map(
          (name) =>
            html`<li>
              <button type="button" class="wide-button" @click=${() => void openMain(app, name)}>
                ${name}
              </button>
            </li>`,
        )}
      </ul>
      <p class="row end"><button type="button" @click=${stop}>Cancel</button></p>`,
    stop,
  );
}

function whichMesh(app: App): TemplateResult {
  const info = app.info!;
  const keep = (): void => {
    if (app.phase !== 'pick-mesh') return;
    app.phase = info.usable ? 'editing' : 'invalid';
    app.changed();
  };
  return frame(
    'pick-mesh',
    'Which mesh?',
    html`<p>
        The file holds ${info.surfaces.length} meshes. Primitives of one mesh are one surface.
      </p>
      <ul class="list">
        ${info.surfaces.map(
          ({ index, name, triangles, vertices }) =>
            html`<li>
              <button
                type="button"
                class="wide-button"
                data-mesh=${index}
                aria-current=${index === info.surface}
                ?autofocus=${index === info.surface}
                @click=${() => (index === info.surface ? keep() : void load(app, index))}
              >
                <b>${name || `Mesh ${index}`}</b>
                <small
                  >${triangles} triangles, ${vertices}
                  vertices${index === info.surface ? ' · suggested' : ''}</small
                >
              </button>
            </li>`,
        )}
      </ul>`,
    keep,
  );
}

function downloads(app: App, ui: Controls): TemplateResult {
  const solved = app.current;
  const close = (): void => ui.show('');
  if (!solved) return html``;
  const { info } = app;
  const stored = info?.surfaces[info.surface]?.storedVertices ?? 0;
  return frame(
    'downloads',
    solved.isCertified ? 'Download' : 'Download uncertified result',
    html`<p class="note">
        ${stored} stored vertices; ${solved.result.uvToVertex.length} texture vertices, since seams
        are split. The cones are embedded, so that the file opens here again as it is.
      </p>
      <ul class="list">
        ${formats.map(({ format, label, hint }) => {
          const name = format === 'same' ? solved.written.files[0].name : hint;
          return html`<li>
            <button
              type="button"
              class="wide-button"
              data-format=${format}
              ?autofocus=${format === 'same'}
              @click=${() => {
                save(make(app, solved, format));
                app.isUnsaved = false;
                close();
              }}
            >
              <b>${label}</b><small>${format === 'same' ? `${name} · ${hint}` : hint}</small>
            </button>
          </li>`;
        })}
      </ul>
      <p class="row end"><button type="button" @click=${close}>Close</button></p>`,
    close,
  );
}

const keys: [string, string][] = [
  ['Ctrl+O', 'open'],
  ['Ctrl+Enter', 'run'],
  ['Ctrl+S', 'download'],
  ['Ctrl+Z, Ctrl+Shift+Z', 'undo, redo'],
  ['Escape', 'deselect; cancel a run'],
  ['C', 'Place tool: arrows walk over the vertices, Enter places'],
  ['Arrows', 'orbit; with Shift pan; Page Up, Page Down zoom'],
  ['N, P', 'next, previous cone'],
  ['1–9, +, −', 'set k, change k'],
  ['Delete', 'remove the cone'],
  ['F, R', 'frame, reset the camera'],
  ['G, H', 'next pattern, next overlay'],
  ['L, S', 'wireframe, seams'],
  ['U', 'UV view'],
];

function help(ui: Controls): TemplateResult {
  const close = (): void => ui.show('');
  return frame(
    'help-dialog',
    'Keys',
    html`<p class="note">Single keys work while a view has the focus.</p>
      <dl class="keys">
        ${keys.map(
          ([key, what]) =>
            html`<div>
              <dt><kbd>${key}</kbd></dt>
              <dd>${what}</dd>
            </div>`,
        )}
      </dl>
      <p>
        <label class="tick"
          ><input
            type="checkbox"
            .checked=${ui.hasKeys}
            @change=${(event: Event) => ui.setKeys((event.target as HTMLInputElement).checked)}
          />
          Single-key shortcuts</label
        >
      </p>
      <p><a href="./guide.html">Guide: cones, certificate, Blender, three.js, quads</a></p>
      <p class="row end">
        <button type="button" class="strong" autofocus @click=${close}>Close</button>
      </p>`,
    close,
  );
}

export function dialogs(app: App, ui: Controls): TemplateResult | typeof nothing {
  if (app.phase === 'needs-files') return missingFiles(app);
  if (app.phase === 'pick-mesh')
    return app.candidates.length > 0 ? whichModel(app) : whichMesh(app);
  if (ui.dialog === 'download' && app.current) return downloads(app, ui);
  if (ui.dialog === 'help') return help(ui);
  return nothing;
}
