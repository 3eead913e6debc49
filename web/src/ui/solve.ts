// How Run is done, what it will take, and the command line that does the same.

import { html, nothing, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import type { App, SolveSettings } from '../state/app';
import { copyCommand, estimateOf } from '../state/estimate';
import type { Controls } from './controls';
import { typed } from './typed';

export function solve(app: App, ui: Controls): TemplateResult {
  const { needed, takes, isTight } = estimateOf(app);
  const set = (part: Partial<SolveSettings>): void => {
    app.solve = { ...app.solve, ...part };
    app.changed();
  };
  const whole = (event: Event, low: number, high: number): number | undefined => {
    const n = Number((event.target as HTMLInputElement).value);
    return Number.isFinite(n) && n >= low ? Math.min(Math.round(n), high) : undefined;
  };
  const { rounds, quality, frames, timeLimit } = app.solve;
  return html`<details id="panel-solve">
    <summary>Solve</summary>
    <div class="row field">
      <label for="rounds">Rounds at most</label>
      <input
        id="rounds"
        type="number"
        min="1"
        max="100"
        .value=${typed(String(rounds))}
        @change=${(event: Event) => set({ rounds: whole(event, 1, 100) ?? rounds })}
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
        .value=${typed(timeLimit === undefined ? '' : String(timeLimit))}
        @change=${(event: Event) => set({ timeLimit: whole(event, 1, 86_400) })}
      />
      <small>seconds; what is not done by then is given up</small>
    </div>
    <div class="row field">
      <label for="frames">Frames</label>
      <select
        id="frames"
        ?disabled=${!app.field}
        @change=${(event: Event) => set({ frames: (event.target as HTMLSelectElement).value as SolveSettings['frames'] })}
      >
        <option value="auto" .selected=${live(frames === 'auto')}>Auto</option>
        <option value="file" .selected=${live(frames === 'file')}>From file</option>
      </select>
      <button type="button" class="small" id="field-file" @click=${() => ui.chooseConeFile()}>
        Field file…
      </button>
      <small
        >Auto follows the cones; a cross field (.rawfield, .rosy, .ffield) brings its cones and its
        turns along boundaries and handles, and From file takes its directions, too</small
      >
    </div>
    <p>
      <label class="tick">
        <input
          type="checkbox"
          id="quality"
          .checked=${quality}
          @change=${(event: Event) => set({ quality: (event.target as HTMLInputElement).checked })}
        />
        Less distortion
      </label>
      <small>The map is then no longer harmonic.</small>
    </p>
    <dl class="facts" id="estimate">
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
    }
    <p>
      <button type="button" class="small" id="copy-command" @click=${() => void copyCommand(app)}>
        Copy the command that does this
      </button>
    </p>
  </details>`;
}
