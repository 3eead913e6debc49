// How Run is done, what it will take, and the command line that does the same.

import { html, nothing, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import type { SolveSettings } from '../model/types';
import { estimateFor } from '../text/estimate';
import { actionButton } from './action_button';
import { keepWhileTyping } from './keep_while_typing';
import { Panel } from './panel';

const textOf = (event: Event): string => (event.target as HTMLInputElement).value;

function wholeNumber(event: Event, low: number, high: number): number | undefined {
  const n = Number(textOf(event));
  return Number.isFinite(n) && n >= low ? Math.min(Math.round(n), high) : undefined;
}

class SolvePanel extends Panel {
  override render(): TemplateResult | typeof nothing {
    const { doc } = this.app;
    if (!doc.usableModel) return nothing;
    return html`<details id="panel-solve">
      <summary>Solve</summary>
      ${this.#limits()} ${this.#frames()}
      <p>
        <label class="tick">
          <input
            type="checkbox"
            id="quality"
            .checked=${live(doc.solve.quality)}
            @change=${(event: Event) => this.#set({ quality: (event.target as HTMLInputElement).checked })}
          />
          Less distortion
        </label>
        <small>The report says how harmonic the map is.</small>
      </p>
      ${this.#estimate()}
      <p>${actionButton(this.app, 'copy-command', { className: 'small' })}</p>
    </details>`;
  }

  #set(part: Partial<SolveSettings>): void {
    const { doc } = this.app;
    doc.solve = { ...doc.solve, ...part };
    this.requestUpdate();
  }

  #limits(): TemplateResult {
    const { rounds, timeLimit } = this.app.doc.solve;
    return html`<div class="row field">
        <label for="rounds">Rounds at most</label>
        <input
          id="rounds"
          type="number"
          min="1"
          max="100"
          .value=${keepWhileTyping(String(rounds))}
          @change=${(event: Event) => this.#set({ rounds: wholeNumber(event, 1, 100) ?? rounds })}
        />
        <small>of solve, judge, repair</small>
      </div>
      <div class="row field">
        <label for="time-limit">Time limit</label>
        <input
          id="time-limit"
          type="number"
          min="1"
          placeholder="none"
          .value=${keepWhileTyping(timeLimit === undefined ? '' : String(timeLimit))}
          @change=${(event: Event) => this.#set({ timeLimit: wholeNumber(event, 1, 86_400) })}
        />
        <small>seconds; what is not done by then is given up</small>
      </div>`;
  }

  #frames(): TemplateResult {
    const { field, solve } = this.app.doc;
    return html`<div class="row field">
      <label for="frames">Frames</label>
      <select
        id="frames"
        ?disabled=${!field}
        @change=${(event: Event) => this.#set({ frames: textOf(event) as SolveSettings['frames'] })}
      >
        <option value="auto" .selected=${live(solve.frames === 'auto')}>Auto</option>
        <option value="file" .selected=${live(solve.frames === 'file')}>From file</option>
      </select>
      ${actionButton(this.app, 'import-cones', { domId: 'field-file', className: 'small', text: 'Field file…' })}
      <small
        >Auto follows the cones; a cross field (.rawfield, .rosy, .ffield) brings its cones and its
        turns along boundaries and handles, and From file takes its directions, too</small
      >
    </div>`;
  }

  #estimate(): TemplateResult {
    const { needed, takes, isTight } = estimateFor(this.app.doc.model!.info);
    return html`<dl class="facts" id="estimate">
        <div>
          <dt>Memory, about</dt>
          <dd>${needed}</dd>
        </div>
        <div>
          <dt>Time, about</dt>
          <dd>${takes}</dd>
        </div>
      </dl>
      ${
        isTight
          ? html`<p class="note bad">
              Over 80 % of what a browser gives. Use the command below: it has no such limit.
            </p>`
          : nothing
      }`;
  }
}
customElements.define('hgp-solve-panel', SolvePanel);
