// The whole page as one template; small files make its parts.

import { html, nothing, type TemplateResult } from 'lit';
import type { App } from '../state/app';
import { examples } from 'virtual:examples';
import { open, openExample } from '../state/open';
import { filesOfInput } from '../state/files';
import { stageName } from '../state/run';
import type { Controls } from './controls';
import { fileParts, header, runButton } from './header';
import { picture } from './icons';
import { inspector } from './inspector';
import { dialogs } from './dialogs';
import { legend } from './legend';
import { sheetHandle } from './sheet';
import { toolbar } from './toolbar';

function emptyState(app: App, ui: Controls): TemplateResult {
  return html`<section class="empty" aria-label="Start">
    <h2>Drop a mesh</h2>
    <p class="lead">It comes back with seamless texture coordinates that fold nowhere.</p>
    <p>GLB, glTF, OBJ, PLY, STL, OFF, a folder or a ZIP.<br />Files stay on this computer.</p>
    <p class="row">
      <button type="button" class="strong" id="choose" @click=${() => ui.chooseFiles()}>
        Choose files
      </button>
      <button type="button" id="choose-folder" @click=${() => ui.chooseFolder()}>
        Choose a folder
      </button>
    </p>
    <h3>or try an example</h3>
    <ul class="cards">
      ${examples.map(
        (example) =>
          html`<li>
            <button
              type="button"
              class="card"
              data-card=${example.id}
              @click=${() => void openExample(app, example)}
            >
              ${picture(example.id)}
              <b>${example.title}</b><small>${example.hint}</small>
            </button>
          </li>`,
      )}
    </ul>
  </section>`;
}

function statusLine(app: App, ui: Controls): TemplateResult {
  const { progress, message } = app;
  const seconds = progress ? (performance.now() - progress.begin) / 1000 : 0;
  const left =
    progress && seconds > 5 && progress.fraction > 0.05
      ? ` · about ${Math.ceil((seconds * (1 - progress.fraction)) / progress.fraction)} s left`
      : '';
  const said = progress
    ? `${progress.title}: ${stageName(progress.stage)}`
    : (message?.text ?? resting(app));
  return html`<footer>
    <p id="status" role="status" class=${progress ? '' : (message?.kind ?? '')}>${said}</p>
    <p id="aside" role="status">${progress ? message?.text : ''}</p>
    ${message?.actions?.map(
      ({ label, do: act }) =>
        html`<button type="button" class="small" @click=${act}>${label}</button>`,
    )}
    ${
      progress
        ? html`<span class="detail" aria-hidden="true">${progress.detail}</span>
            <progress
              id="progress"
              max="1"
              .value=${progress.fraction}
              aria-label="Progress"
            ></progress>
            <span class="detail clock" aria-hidden="true">${seconds.toFixed(0)} s${left}</span>`
        : nothing
    }
    <button type="button" class="small log-button" id="log" @click=${() => ui.show('log')}>
      Log
    </button>
    ${ui.isPhone ? runButton(app) : nothing}
  </footer>`;
}

function resting(app: App): string {
  switch (app.state) {
    case 'starting':
      return 'Starting…';
    case 'empty':
      return 'Ready.';
    case 'stale':
      return 'The result is for the previous cones. Run again, or undo.';
    case 'invalid':
    case 'needs-files':
    case 'pick-mesh':
      return '';
    default: {
      const count = app.asked.cones.length;
      if (count === 0 && !app.isExplicit) return 'No cones yet: Run suggests them first.';
      const text = app.budget?.text ?? '';
      return app.budget?.isReady
        ? `${text} · ${count} ${count === 1 ? 'cone' : 'cones'} · ready`
        : text;
    }
  }
}

export function page(app: App, ui: Controls): TemplateResult {
  const hasModel = app.surface !== undefined;
  return html`
    ${header(app, ui)}
    <main id="drop" class=${hasModel ? 'has-model' : 'no-model'} data-sheet=${ui.sheet}>
      <div class="tabs" ?hidden=${!hasModel}>
        <div role="tablist" aria-label="Views">
          ${(['surface', 'map'] as const).map(
            (name) =>
              html`<button
                type="button"
                role="tab"
                id="tab-${name}"
                aria-controls="pane-${name}"
                aria-selected=${ui.tab === name}
                @click=${() => ui.setTab(name)}
              >
                ${name === 'surface' ? '3D view' : 'UV view'}
              </button>`,
          )}
        </div>
        ${ui.isPhone ? fileParts(app) : nothing}
      </div>
      <section
        class="pane"
        id="pane-surface"
        aria-label="3D view"
        data-shown=${ui.tab === 'surface'}
        ?hidden=${!hasModel}
      >
        ${toolbar(app, ui)}
        <canvas
          id="view"
          tabindex="0"
          role="img"
          aria-label=${ui.describe()}
          aria-describedby="keys"
        ></canvas>
        <p id="keys" class="unseen">
          Arrows orbit. C switches to placing cones. Question mark lists all keys.
        </p>
        <p class="hover" ?hidden=${ui.hover === ''}>${ui.hover}</p>
        ${legend(app)}
        ${
          app.shown && !['plain', 'material'].includes(app.look.pattern)
            ? html`<p class="honest">
                Directions and spacing continue across seams; lines may shift, because the cone
                points are not on an integer grid.
              </p>`
            : nothing
        }
        ${app.state === 'stale' ? html`<p class="badge">Result is for the previous cones</p>` : nothing}
      </section>
      <div
        class="splitter"
        id="splitter"
        role="separator"
        tabindex="0"
        aria-orientation="vertical"
        aria-label="Width of the 3D view"
        aria-valuenow=${ui.split}
        aria-valuemin="20"
        aria-valuemax="80"
        ?hidden=${!hasModel}
      ></div>
      <section
        class="pane"
        id="pane-map"
        aria-label="UV view"
        data-shown=${ui.tab === 'map'}
        ?hidden=${!hasModel}
      >
        <canvas
          id="map"
          tabindex="0"
          role="img"
          aria-label=${app.shown ? 'UV view: the map laid flat. Arrows move, plus and minus zoom.' : 'UV view: no map yet'}
        ></canvas>
        ${app.shown ? nothing : html`<p class="hint">The flat map appears here after Run.</p>`}
      </section>
      ${hasModel ? html`<aside aria-label="Inspector">${sheetHandle(ui)} ${inspector(app, ui)}</aside>` : emptyState(app, ui)}
    </main>
    ${statusLine(app, ui)} ${dialogs(app, ui)}
    <input
      id="file"
      type="file"
      multiple
      hidden
      aria-label="Choose files"
      @change=${(event: Event) => {
        const input = event.target as HTMLInputElement;
        void open(app, filesOfInput([...(input.files ?? [])])).finally(() => (input.value = ''));
      }}
    />
    <input
      id="folder"
      type="file"
      webkitdirectory
      hidden
      aria-label="Choose a folder"
      @change=${(event: Event) => {
        const input = event.target as HTMLInputElement;
        void open(app, filesOfInput([...(input.files ?? [])])).finally(() => (input.value = ''));
      }}
    />
  `;
}
