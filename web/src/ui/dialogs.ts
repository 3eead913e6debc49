// Everything that asks: missing files, which model, which mesh, what to download, help.

import { html, nothing, type TemplateResult } from 'lit';
import type { App } from '../state/app';
import { load } from '../state/load';
import { loadWithoutImages, openMain, supply } from '../state/open';
import type { Controls } from './controls';
import { downloads } from './download';

export function frame(
  id: string,
  title: string,
  body: TemplateResult,
  close: () => void,
): TemplateResult {
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
      <div class="scroll">
        <table id="meshes">
          <thead>
            <tr>
              <th scope="col">Mesh</th>
              <th scope="col">Triangles</th>
              <th scope="col">Instances</th>
              <th scope="col">Parts</th>
              <th scope="col">Manifold</th>
            </tr>
          </thead>
          <tbody>
            ${info.surfaces.map(({ index, name, triangles, notes }) => {
              const seen = app.survey.find((one) => one.index === index);
              const isBest = index === info.surface;
              return html`<tr class=${isBest ? 'selected' : ''}>
                <th scope="row">
                  <button
                    type="button"
                    class="wide-button"
                    data-mesh=${index}
                    aria-current=${isBest}
                    ?autofocus=${isBest}
                    @click=${() => (isBest ? keep() : void load(app, index))}
                  >
                    ${name || `Mesh ${index}`}${isBest ? html`<small>suggested</small>` : nothing}
                  </button>
                  ${notes.length > 0 ? html`<small>${notes.join('; ')}</small>` : nothing}
                </th>
                <td>${triangles}</td>
                <td>${seen?.instances ?? '–'}</td>
                <td>${seen?.parts || '–'}</td>
                <td>${seen ? (seen.isUsable ? 'yes' : `no: ${seen.why}`) : '–'}</td>
              </tr>`;
            })}
          </tbody>
        </table>
      </div>
      <p class="row end"><button type="button" @click=${keep}>Use the suggested one</button></p>`,
    keep,
  );
}

const keys: [string, string][] = [
  ['Ctrl+O', 'open'],
  ['Ctrl+Enter', 'run'],
  ['Ctrl+S', 'download'],
  ['Ctrl+Z, Ctrl+Shift+Z or Ctrl+Y', 'undo, redo'],
  ['Escape', 'put a dragged cone back, deselect; twice: cancel a run'],
  ['C', 'Place tool: arrows walk over the vertices, Enter places'],
  ['Arrows', 'orbit; with Shift pan; Page Up, Page Down zoom'],
  ['N, P', 'next, previous cone'],
  ['1–9, +, −', 'set k, change k'],
  ['Delete', 'remove the cone'],
  ['F, R', 'frame the selected cone or all; reset the camera'],
  ['G, H', 'next pattern, next overlay'],
  ['L, S, O', 'wireframe, seams, parallel projection'],
  ['U', 'to the UV view and back'],
  ['Double click', 'bring that place to the middle'],
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
      <p>
        <button type="button" class="small" @click=${() => ui.nextTheme()}>
          Theme: ${ui.theme}
        </button>
        <button type="button" class="small" @click=${() => ui.show('log')}>Log</button>
      </p>
      <p><a href="./guide.html">Guide: cones, certificate, Blender, three.js, quads</a></p>
      <p class="row end">
        <button type="button" class="strong" autofocus @click=${close}>Close</button>
      </p>`,
    close,
  );
}

function log(app: App, ui: Controls): TemplateResult {
  const close = (): void => ui.show('');
  return frame(
    'log-dialog',
    'Log',
    html`<ol class="log" tabindex="0" aria-label="Messages, the newest first">
        ${app.log
          .toReversed()
          .map(
            ({ time, text }) =>
              html`<li>
                <time datetime=${time.toISOString()}>${time.toLocaleTimeString()}</time> ${text}
              </li>`,
          )}
      </ol>
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
  if (ui.dialog === 'download' && app.current) return downloads(app, ui, app.current);
  if (ui.dialog === 'log') return log(app, ui);
  if (ui.dialog === 'help') return help(ui);
  return nothing;
}
