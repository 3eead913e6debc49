// The bar at the top: open, examples, undo, Run, Download.

import { html, nothing, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import { examples } from 'virtual:examples';
import type { App } from '../state/app';
import { redo, undo } from '../state/edit';
import { load } from '../state/load';
import { close, openExample } from '../state/open';
import { cancel, canRun, run } from '../state/run';
import type { Controls } from './controls';
import { icon } from './icons';

export function header(app: App, ui: Controls): TemplateResult {
  const { canUndo, canRedo, undoKind, redoKind } = app.history;
  const isBusy = app.phase === 'running' || app.phase === 'loading';
  return html`<header>
    <h1><span class="mark" aria-hidden="true"></span><span class="name">hgp</span></h1>
    <button type="button" id="open" @click=${() => ui.chooseFiles()} title="Open (Ctrl+O)">
      ${icon('open')}<span class="wide">Open</span>
    </button>
    <div class="menu">
      <button
        type="button"
        id="examples"
        aria-label="Examples"
        aria-haspopup="true"
        aria-expanded=${ui.menu === 'examples'}
        @click=${() => ui.toggleMenu('examples')}
      >
        <span class="wide">Examples</span>${icon('more')}
      </button>
      ${
        ui.menu === 'examples'
          ? html`<ul class="popup">
              ${examples.map(
                (example) =>
                  html`<li>
                    <button
                      type="button"
                      data-example=${example.id}
                      @click=${() => {
                        ui.toggleMenu('');
                        void openExample(app, example);
                      }}
                    >
                      ${example.title}<small>${example.hint}</small>
                    </button>
                  </li>`,
              )}
            </ul>`
          : nothing
      }
    </div>
    <button
      type="button"
      id="undo"
      class="only-icon"
      ?disabled=${!canUndo || isBusy}
      aria-label=${canUndo ? `Undo ${undoKind}` : 'Undo'}
      title="Undo ${undoKind} (Ctrl+Z)"
      @click=${() => undo(app)}
    >
      ${icon('undo')}
    </button>
    <button
      type="button"
      id="redo"
      class="only-icon"
      ?disabled=${!canRedo || isBusy}
      aria-label=${canRedo ? `Redo ${redoKind}` : 'Redo'}
      title="Redo ${redoKind} (Ctrl+Shift+Z)"
      @click=${() => redo(app)}
    >
      ${icon('redo')}
    </button>
    ${ui.isPhone ? nothing : html`${fileParts(app)} ${runButton(app)}`} ${downloadButton(app, ui)}
    <button
      type="button"
      id="help"
      class="only-icon"
      aria-label="Help and shortcuts"
      @click=${() => ui.show('help')}
    >
      ${icon('help')}
    </button>
    <button
      type="button"
      id="theme"
      class="only-icon"
      aria-label="Theme: ${ui.theme}"
      title="Theme: ${ui.theme}"
      @click=${() => ui.nextTheme()}
    >
      ${icon('theme')}
    </button>
  </header>`;
}

/** Which file, which mesh of it, and Close: in the bar at the top, or beside the tabs of a phone. */
export function fileParts(app: App): TemplateResult {
  const name = app.info ? app.main : '';
  return html`<p class="file" title=${name}>${name}</p>
    ${meshChooser(app)} ${closeButton(app)}`;
}

function closeButton(app: App): TemplateResult | typeof nothing {
  if (!app.info) return nothing;
  return html`<button
    type="button"
    id="close"
    class="only-icon plain"
    aria-label="Close ${app.main}"
    title="Close"
    @click=${() => close(app)}
  >
    ${icon('cross')}
  </button>`;
}

/** Another mesh of the same file. */
function meshChooser(app: App): TemplateResult | typeof nothing {
  const { info } = app;
  if (!info || info.surfaces.length < 2) return nothing;
  return html`<select
    id="mesh"
    aria-label="Mesh of this file"
    ?disabled=${app.phase !== 'editing' && app.phase !== 'invalid'}
    .value=${live(String(info.surface))}
    @change=${(event: Event) => void load(app, Number((event.target as HTMLSelectElement).value))}
  >
    ${info.surfaces.map(
      ({ index, name }) =>
        html`<option value=${index} ?selected=${index === info.surface}>
          ${name || `Mesh ${index}`}
        </option>`,
    )}
  </select>`;
}

/** In the bar at the top; on a phone in the one at the bottom, under the thumb whatever the sheet does. */
export function runButton(app: App): TemplateResult {
  if (app.phase === 'running' || app.phase === 'loading') {
    return html`<button type="button" id="cancel" class="strong" @click=${() => cancel(app)}>
      ${icon('cross')}Cancel
    </button>`;
  }
  const isReady = canRun(app);
  const why =
    app.phase === 'empty' || !app.info
      ? 'Open a model first.'
      : app.phase === 'invalid'
        ? 'This mesh cannot be parametrized as it is.'
        : (app.budget?.text ?? '');
  // Not `disabled`: a person must be able to reach the button and read why.
  return html`<button
      type="button"
      id="run"
      class=${app.current?.isCertified ? '' : 'strong'}
      aria-disabled=${!isReady}
      aria-describedby=${isReady ? nothing : 'run-why'}
      title=${isReady ? 'Run (Ctrl+Enter)' : why}
      @click=${() => void run(app)}
    >
      ${icon('run')}Run
    </button>
    <span id="run-why" class="unseen">${isReady ? '' : why}</span>`;
}

function downloadButton(app: App, ui: Controls): TemplateResult {
  const { current } = app;
  const label = current && !current.isCertified ? 'Download uncertified result' : 'Download';
  return html`<button
    type="button"
    id="download"
    class=${current?.isCertified ? 'strong' : ''}
    ?disabled=${!current}
    aria-label=${label}
    title="${label} (Ctrl+S)"
    @click=${() => ui.show('download')}
  >
    ${icon('download')}<span class="wide"
      >${current && !current.isCertified ? 'Download…' : 'Download'}</span
    >
  </button>`;
}
