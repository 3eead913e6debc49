// All dialogs but Download: missing files, choice of a model, the command palette, help, the log.

import { html, nothing, type TemplateResult } from 'lit';
import type { ActionGroup } from '../actions/action';
import { attempt, type AppView } from '../actions/app';
import { giveUp, loadWithoutImages, openMain, supply } from '../actions/open';
import { actionIds, actions, labelOf, perform, whyNotOf, type ActionId } from '../actions/registry';
import type { DocumentState } from '../model/document';
import { actionButton } from './action_button';
import { compareDialog } from './compare_dialog';
import { downloadDialog } from './download_dialog';
import { dialogFrame } from './dialog_frame';
import { icon } from './icons';
import { Panel } from './panel';
import './dialogs.css';

type StateOf<K extends DocumentState['kind']> = Extract<DocumentState, { kind: K }>;

function missingFiles(app: AppView, { main, missing }: StateOf<'needs-files'>): TemplateResult {
  const isNeeded = missing.some((file) => file.isNeeded);
  const browse = (name: string) => (event: Event) => {
    const file = (event.target as HTMLInputElement).files?.[0];
    if (file) void attempt(app, () => supply(app, new Map([[name, file]])));
  };
  const stop = (): void => giveUp(app);
  const items = missing.map(
    ({ name, isNeeded: must }) =>
      html`<li>
        <span><code>${name}</code><small>${must ? 'needed' : 'image'}</small></span>
        <label class="button small"
          >Browse<input
            type="file"
            class="visually-hidden"
            aria-label="Browse for ${name}"
            @change=${browse(name)}
        /></label>
      </li>`,
  );
  const goOn = html`<button
    type="button"
    class="primary"
    id="without-images"
    @click=${() => void attempt(app, () => loadWithoutImages(app))}
  >
    Continue without images
  </button>`;
  return dialogFrame(
    'needs-files',
    'Some files are missing',
    html`<p>
        “${main}” refers to files that are missing.
        <span class="for-mouse">Drop them on the page, or browse:</span
        ><span class="for-fingers">Choose each one:</span>
      </p>
      <ul class="list">
        ${items}
      </ul>
      <p class="row end">
        <button type="button" @click=${stop}>Cancel</button>
        ${isNeeded ? nothing : goOn}
      </p>`,
    stop,
  );
}

function whichModel(app: AppView, { files, candidates }: StateOf<'pick-model'>): TemplateResult {
  const stop = (): void => giveUp(app);
  return dialogFrame(
    'pick-model',
    'Which model?',
    html`<ul class="list">
        ${candidates.map(
          (name) =>
            html`<li>
              <button
                type="button"
                class="wide-button"
                @click=${() => void attempt(app, () => openMain(app, files, name))}
              >
                ${name}
              </button>
            </li>`,
        )}
      </ul>
      <p class="row end"><button type="button" @click=${stop}>Cancel</button></p>`,
    stop,
  );
}

/** Gestures, which are not in the registry of actions. */
const gestures: [string, string][] = [
  ['Arrows', 'orbit; with Shift pan; Page Up, Page Down zoom'],
  ['Arrows, Enter', 'with the Place tool: walk over the vertices, place'],
  ['1–9', 'k of the selected cone'],
  ['Alt', 'with the Place tool: at the nearest vertex instead of a corner nearby'],
  ['Escape', 'put a dragged cone back, deselect; twice: cancel a run'],
  ['Double click', 'centre that place'],
];

const touches: [string, string][] = [
  ['Drag', 'turn the model, or move the UV view; on a cone: move the cone, and its map follows'],
  ['Two fingers', 'zoom and move the view'],
  ['Hold', 'place a cone there'],
  ['Tap', 'select a cone; with the Place tool: place one; on another mesh: work on it'],
  ['Tap an edge', 'while edges are chosen: lines follow its chain up to the next corner'],
];

const keyList = (rows: [string, string][], className: string): TemplateResult =>
  html`<dl class="keys ${className}">
    ${rows.map(
      ([key, what]) =>
        html`<div>
          <dt><kbd>${key}</kbd></dt>
          <dd>${what}</dd>
        </div>`,
    )}
  </dl>`;

function help(app: AppView): TemplateResult {
  const { ui } = app;
  const close = (): void => void (ui.dialog = '');
  const keyed = actionIds.filter((id) => actions[id].keys);
  const rows: [string, string][] = keyed.map((id) => [
    actions[id].keys!.join(' or '),
    labelOf(app, id),
  ]);
  return dialogFrame(
    'help-dialog',
    'Help and shortcuts',
    // The first row has the focus: on a button at the end, the list would open scrolled to it.
    html`<p class="note" tabindex="-1" autofocus>
        <span class="for-mouse">Single keys work while a view has the focus.</span
        ><span class="for-fingers">On the model and in the UV view:</span>
      </p>
      ${keyList(touches, 'for-fingers')} ${keyList([...rows, ...gestures], 'for-mouse')}
      <p class="for-mouse">
        <label class="tick"
          ><input
            type="checkbox"
            .checked=${ui.hasKeys}
            @change=${(event: Event) => ui.setKeys((event.target as HTMLInputElement).checked)}
          />
          Single-key shortcuts</label
        >
      </p>
      <p class="row">
        ${actionButton(app, 'theme', { domId: 'help-theme', className: 'small' })}
        ${actionButton(app, 'log', { domId: 'help-log', className: 'small' })}
        ${actionButton(app, 'palette', { domId: 'help-palette', className: 'small' })}
      </p>
      <p><a href="./guide.html">Guide: cones, certificate, Blender, three.js, quads</a></p>
      <p>
        <a href="./THIRD_PARTY_LICENSES.txt">Third-party software in this page, and its licences</a>
      </p>
      <p class="row end">
        <button type="button" class="primary" autofocus @click=${close}>Close</button>
      </p>`,
    close,
  );
}

function log({ doc, ui }: AppView): TemplateResult {
  const close = (): void => void (ui.dialog = '');
  return dialogFrame(
    'log-dialog',
    'Log',
    html`${doc.log.length === 0 ? html`<p class="note">No messages yet.</p>` : nothing}
      <ol
        class="log"
        tabindex="0"
        aria-label="Messages, the newest first"
        ?hidden=${doc.log.length === 0}
      >
        ${doc.log
          .toReversed()
          .map(
            ({ time, text }) =>
              html`<li>
                <time datetime=${time.toISOString()}>${time.toLocaleTimeString()}</time> ${text}
              </li>`,
          )}
      </ol>
      <p class="row end">
        <button type="button" class="primary" autofocus @click=${close}>Close</button>
      </p>`,
    close,
  );
}

const groups: ActionGroup[] = ['Run', 'File', 'Cones', 'View', 'Page'];

class Dialogs extends Panel {
  #query = '';

  override render(): TemplateResult | typeof nothing {
    const { doc, ui } = this.app;
    const { state } = doc;
    if (state.kind === 'needs-files') return missingFiles(this.app, state);
    if (state.kind === 'pick-model') return whichModel(this.app, state);
    if (ui.dialog === 'download' && doc.current) return downloadDialog(this.app, doc.current);
    if (ui.dialog === 'compare') return compareDialog(this.app);
    if (ui.dialog === 'log') return log(this.app);
    if (ui.dialog === 'help') return help(this.app);
    if (ui.dialog === 'palette') return this.#palette();
    return nothing;
  }

  override updated(): void {
    for (const dialog of this.querySelectorAll('dialog')) if (!dialog.open) dialog.showModal();
  }

  /** The actions that match the words typed so far. */
  #found(): ActionId[] {
    const words = this.#query.toLowerCase().split(/\s+/);
    const isFound = (id: ActionId): boolean =>
      words.every((word) => labelOf(this.app, id).toLowerCase().includes(word));
    return groups.flatMap((group) =>
      actionIds.filter((id) => actions[id].group === group && id !== 'palette' && isFound(id)),
    );
  }

  #palette(): TemplateResult {
    const { app } = this;
    const close = (): void => {
      this.#query = '';
      app.ui.dialog = '';
    };
    const choose = (id: ActionId): void => {
      close();
      void perform(app, id);
    };
    const type = (event: Event): void => {
      this.#query = (event.target as HTMLInputElement).value;
      this.requestUpdate();
    };
    const found = this.#found();
    const first = found.find((id) => whyNotOf(app, id) === '');
    const enter = (event: KeyboardEvent): void => {
      if (event.key !== 'Enter' || !first) return;
      event.preventDefault();
      choose(first);
    };
    return dialogFrame(
      'palette-dialog',
      'All actions',
      html`<input
          type="search"
          id="palette-query"
          aria-label="Find an action"
          placeholder="Type to search"
          autofocus
          @input=${type}
          @keydown=${enter}
        />
        <ul class="list palette">
          ${found.map(
            (id) =>
              html`<li>
                <button
                  type="button"
                  class="wide-button ${id === first ? 'first' : ''}"
                  data-action=${id}
                  ?disabled=${whyNotOf(app, id) !== ''}
                  title=${whyNotOf(app, id)}
                  @click=${() => choose(id)}
                >
                  <span class="row"
                    >${actions[id].icon ? icon(actions[id].icon) : nothing}${labelOf(app, id)}</span
                  >
                  <small><kbd>${actions[id].keys?.[0] ?? ''}</kbd></small>
                </button>
              </li>`,
          )}
        </ul>`,
      close,
    );
  }
}
customElements.define('hgp-dialogs', Dialogs);
