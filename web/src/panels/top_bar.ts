// The top bar: Open, examples, undo, Run, Download.

import { html, nothing, type TemplateResult } from 'lit';
import { examples } from 'virtual:examples';
import { attempt, type AppView } from '../actions/app';
import { openExample } from '../actions/open';
import { labelOf, perform, whyNotOf } from '../actions/registry';
import { canRepair } from '../model/repairs';
import { actionButton } from './action_button';
import { icon } from './icons';
import { Panel } from './panel';
import './top_bar.css';

/** The file name and Close: in the top bar, or next to the tabs on a phone. */
export function fileParts(app: AppView): TemplateResult {
  const name = app.doc.model?.main ?? '';
  const close = actionButton(app, 'close', { className: 'plain', isIconOnly: true });
  return html`<p class="file" title=${name}>${name}</p>
    ${app.doc.model ? close : nothing}`;
}

/**
 * Run, in the top bar, or on a phone in the bottom bar, where it stays visible at every height of the sheet. It runs
 * all meshes of a file, as the command line does; buttons next to the names of meshes run a single one.
 */
export function runButton(app: AppView): TemplateResult {
  const { doc } = app;
  if (doc.isBusy) return actionButton(app, 'cancel', { className: 'primary' });
  const meshes = doc.model?.info.surfaces.length ?? 0;
  if (meshes > 1) {
    const isDone = doc.stateName === 'certified' && doc.meshes.size === meshes - 1;
    return actionButton(app, 'run-all', { className: isDone ? '' : 'primary', text: 'Run all' });
  }
  return runOneButton(app, 'Run');
}

export function runOneButton(app: AppView, name: string): TemplateResult {
  const { doc } = app;
  const isOnly = (doc.model?.info.surfaces.length ?? 1) === 1;
  if (doc.model && canRepair(doc.model)) {
    return actionButton(app, 'repair-and-run', { className: isOnly ? 'primary' : 'small' });
  }
  const why = whyNotOf(app, 'run');
  // Not `disabled`, so that users can reach the button and read the reason.
  return html`<button
      type="button"
      id="run"
      class=${isOnly ? (doc.stateName === 'certified' ? '' : 'primary') : 'small'}
      aria-disabled=${why !== ''}
      aria-describedby=${why ? 'run-why' : nothing}
      title=${why || 'Run (Ctrl+Enter)'}
      @click=${() => void perform(app, 'run')}
    >
      ${icon('run')}${name}
    </button>
    <span id="run-why" class="visually-hidden">${why}</span>`;
}

class TopBar extends Panel {
  override render(): TemplateResult {
    const { app } = this;
    const { doc, ui } = app;
    const isCertified = doc.stateName === 'certified';
    const isUncertified = doc.stateName === 'not-certified';
    return html`<header>
      <h1><span class="mark" aria-hidden="true"></span><span class="name">hgp</span></h1>
      ${actionButton(app, 'open', { text: html`<span class="wide">Open</span>` })}
      <button type="button" id="examples" aria-label="Examples" popovertarget="example-list">
        <span class="wide">Examples</span>${icon('more')}
      </button>
      ${this.#exampleList()} ${actionButton(app, 'undo', { isIconOnly: true })}
      ${actionButton(app, 'redo', { isIconOnly: true })}
      ${ui.isPhone ? nothing : html`${fileParts(app)} ${runButton(app)}`}
      <button
        type="button"
        id="download"
        class=${isCertified ? 'primary' : ''}
        ?disabled=${whyNotOf(app, 'download') !== ''}
        aria-label=${labelOf(app, 'download')}
        title="${labelOf(app, 'download')} (Ctrl+S)"
        @click=${() => void perform(app, 'download')}
      >
        ${icon('download')}<span class="wide">${isUncertified ? 'Download…' : 'Download'}</span>
      </button>
      ${actionButton(app, 'help', { isIconOnly: true })}
      ${actionButton(app, 'theme', { isIconOnly: true })}
    </header>`;
  }

  #exampleList(): TemplateResult {
    const open = (i: number): void => {
      this.querySelector<HTMLElement>('#example-list')?.hidePopover();
      void attempt(this.app, () => openExample(this.app, examples[i]));
    };
    return html`<ul class="popup" id="example-list" popover aria-label="Examples">
      ${examples.map(
        (example, i) =>
          html`<li>
            <button type="button" data-example=${example.id} @click=${() => open(i)}>
              ${example.title}<small>${example.hint}</small>
            </button>
          </li>`,
      )}
    </ul>`;
  }
}
customElements.define('hgp-top-bar', TopBar);
