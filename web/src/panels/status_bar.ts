// The status bar: one sentence, buttons for it, and the progress of a run.

import { html, nothing, type TemplateResult } from 'lit';
import { attempt, type AppView } from '../actions/app';
import type { Job, Message } from '../model/types';
import { stopAutomatic } from '../actions/follow_edits';
import { runSteps, stageName, stepIndex } from '../text/stages';
import { plural } from '../text/format';
import { actionButton } from './action_button';
import { Panel } from './panel';
import { runButton } from './top_bar';
import './status_bar.css';

const patience = 10; // seconds of a run after which the page offers a notification

/** The text while nothing is running. */
function restingText({ doc }: AppView): string {
  switch (doc.stateName) {
    case 'starting':
      return 'Starting…';
    case 'failed':
      return 'The solver could not start.';
    case 'empty':
      return 'Ready.';
    case 'stale':
      if (doc.budget && !doc.budget.isReady && !doc.choosesCones) return doc.budget.text;
      return 'The result is for the previous cones. Run again, or undo.';
    case 'renewing':
      return `The map of these cones is being made: ${stageName(doc.automatic?.stage ?? '').toLowerCase()}`;
    case 'invalid':
    case 'needs-files':
    case 'pick-model':
      return '';
    default: {
      const { cones } = doc.prescription;
      if (cones.length === 0 && !doc.hasUserCones) return 'No cones yet: Run suggests them first.';
      if (doc.stateName === 'ready' && doc.askedFeatures && doc.choosesCones)
        return 'Run chooses cones that fit the edges that lines follow.';
      const text = doc.budget?.text ?? '';
      return doc.budget?.isReady ? `${text} · ${plural(cones.length, 'cone')} · ready` : text;
    }
  }
}

class StatusBar extends Panel {
  override render(): TemplateResult {
    const { app } = this;
    const { doc, ui } = app;
    const { job, message } = doc;
    const said = job
      ? `${job.title}: ${stageName(job.stage)}`
      : (message?.text ?? restingText(app));
    return html`<footer>
      <p id="status" role="status" class=${job ? '' : (message?.kind ?? '')}>${said}</p>
      <p id="aside" role="status">${job ? message?.text : ''}</p>
      ${this.#actions(message)} ${job ? this.#progress(job) : this.#stop()}
      ${actionButton(app, 'log', { className: 'small log-button' })}
      ${ui.isPhone ? runButton(app) : nothing}
    </footer>`;
  }

  #actions(message: Message | undefined): TemplateResult[] {
    return (message?.actions ?? []).map(
      ({ label, run }) =>
        html`<button type="button" class="small" @click=${() => void attempt(this.app, run)}>
          ${label}
        </button>`,
    );
  }

  #stop(): TemplateResult | typeof nothing {
    if (!this.app.doc.automatic) return nothing;
    return html`<button
      type="button"
      class="small"
      id="stop"
      @click=${() => void attempt(this.app, () => stopAutomatic(this.app))}
    >
      Stop
    </button>`;
  }

  #progress(job: Job): TemplateResult {
    const seconds = (this.app.ui.now - job.begin) / 1000;
    const { secondsLeft } = job;
    const left = secondsLeft === undefined ? '' : ` · about ${Math.ceil(secondsLeft)} s left`;
    return html`${job.kind === 'run' ? this.#steps(job) : nothing}
      <span class="detail" aria-hidden="true">${job.detail}</span>
      <progress id="progress" max="1" .value=${job.fraction} aria-label="Progress"></progress>
      <span class="detail clock" aria-hidden="true"
        >${Math.max(0, seconds).toFixed(0)} s${left}</span
      >
      ${seconds > patience ? this.#notifyButton() : nothing}`;
  }

  #steps({ stage }: Job): TemplateResult {
    const at = stepIndex(stage);
    return html`<ol class="steps" aria-hidden="true">
      ${runSteps.map(
        (step, i) =>
          html`<li class=${i < at ? 'done' : i === at ? 'now' : ''}>${stageName(step)}</li>`,
      )}
    </ol>`;
  }

  #notifyButton(): TemplateResult | typeof nothing {
    if (!('Notification' in globalThis) || Notification.permission !== 'default') return nothing;
    const ask = async (): Promise<void> => {
      await Notification.requestPermission();
      this.requestUpdate();
    };
    return html`<button
      type="button"
      class="small"
      id="notify"
      @click=${() => void attempt(this.app, ask)}
    >
      Tell me when it is done
    </button>`;
  }
}
customElements.define('hgp-status-bar', StatusBar);
