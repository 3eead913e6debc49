// The Solve panel: the main options of Run; under More, limits and the equivalent
// command line.

import { html, nothing, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import { attempt } from '../actions/app';
import { isAutomatic } from '../actions/follow_edits';
import { isPreset, presets, usePreset } from '../actions/presets';
import { realign, setSolve } from '../actions/solve';
import { canAlign, gridOutcome } from '../model/grid';
import type { GridSettings, SolveSettings } from '../model/types';
import { noteForPage } from '../text/notes';
import { estimateFor } from '../text/estimate';
import { count } from '../text/format';
import { actionButton } from './action_button';
import './features_panel';
import { keepWhileTyping } from './keep_while_typing';
import { Panel } from './panel';
import './solve_panel.css';

const textOf = (event: Event): string => (event.target as HTMLInputElement).value;
const isChecked = (event: Event): boolean => (event.target as HTMLInputElement).checked;

function wholeNumber(event: Event, low: number, high: number): number | undefined {
  const n = Number(textOf(event));
  return Number.isFinite(n) && n >= low ? Math.min(Math.round(n), high) : undefined;
}

/** Where the slider is until a run has chosen a number. */
const usualCells = 1000;

/** Position of the density slider: 0 to 100 for 10 to 100 000 cells. */
const sliderOfCells = (cells: number): number => Math.round(25 * (Math.log10(cells) - 1));
const cellsOfSlider = (slider: number): number => Number((10 ** (1 + slider / 25)).toPrecision(2));

/**
 * The balance of Less distortion, until the slider is moved: nearer to angles, where sizes become more even and stretch falls
 * unless it was small. Over 19 models stretch became 0.74 and the spread of sizes 0.82 times that of the map as solved (1.98 and 0.70 at 0).
 */
const gentle = -0.75;

class SolvePanel extends Panel {
  /** Position of the slider while it is dragged. */
  #dragged?: number;

  override render(): TemplateResult | typeof nothing {
    const { doc } = this.app;
    if (!doc.usableModel) return nothing;
    return html`<details open id="panel-solve">
      <summary>Solve</summary>
      ${this.#automatic()} ${this.#presets()} ${this.#grid()}
      <hgp-features-panel .app=${this.app}></hgp-features-panel>
      ${this.#improve()}
      <details id="solve-more">
        <summary>More: limits, frames, command line</summary>
        ${this.#limits()} ${this.#frames()} ${this.#estimate()}
        <p class="row">${actionButton(this.app, 'copy-command', { className: 'small' })}</p>
      </details>
    </details>`;
  }

  #set(part: Partial<SolveSettings>): void {
    setSolve(this.app, part);
  }

  #setGrid(part: Partial<GridSettings>): void {
    void attempt(this.app, () => realign(this.app, part));
  }

  #presets(): TemplateResult {
    const { app } = this;
    return html`<p class="row presets" role="group" aria-label="Settings for a purpose">
      ${presets.map(
        ({ id, label, hint }) =>
          html`<button
            type="button"
            class="small"
            data-preset=${id}
            title=${hint}
            aria-pressed=${isPreset(app, id)}
            ?disabled=${app.doc.isBusy || (id !== 'few' && !canAlign(app.doc.prescription.q))}
            @click=${() => void attempt(app, () => usePreset(app, id))}
          >
            ${label}
          </button>`,
      )}
    </p>`;
  }

  #automatic(): TemplateResult {
    const { app } = this;
    return html`<p>
      <label class="tick">
        <input
          type="checkbox"
          id="automatic"
          .checked=${live(isAutomatic(app))}
          @change=${(event: Event) => app.ui.setAutomatic(isChecked(event))}
        />
        Run automatically
      </label>
      <small
        >After every change. Until you choose, it is on where the first run takes under 2 s.</small
      >
    </p>`;
  }

  #grid(): TemplateResult {
    const { doc } = this.app;
    const { grid } = doc.solve;
    const { q } = doc.prescription;
    const isPossible = canAlign(q);
    return html`<p>
        <label class="tick">
          <input
            type="checkbox"
            id="align"
            ?disabled=${!isPossible || doc.isBusy}
            .checked=${live(grid.isOn && isPossible)}
            @change=${(event: Event) => this.#setGrid({ isOn: isChecked(event) })}
          />
          Align to grid
        </label>
        <small
          >${isPossible ? 'Lines of a texture meet at every seam.' : `Squares need q = 2 or 4, not ${q}.`}</small
        >
      </p>
      ${grid.isOn && isPossible ? html`${this.#density()} ${this.#mode()} ${this.#outcome()}` : nothing}`;
  }

  #density(): TemplateResult {
    const { doc } = this.app;
    const { grid } = doc.solve;
    const cells = this.#dragged ?? grid.cells ?? doc.current?.cells;
    const shown = cells === undefined ? 'automatic' : count(cells);
    return html`<div class="row field">
      <label for="cells">Cells, about</label>
      <output for="cells" id="cells-shown">${shown}</output>
      <button
        type="button"
        class="link"
        id="cells-automatic"
        ?hidden=${grid.cells === undefined}
        ?disabled=${doc.isBusy}
        @click=${() => this.#setGrid({ cells: undefined })}
      >
        Automatic
      </button>
      <input
        id="cells"
        type="range"
        min="0"
        max="100"
        step="1"
        ?disabled=${doc.isBusy}
        .value=${live(String(sliderOfCells(cells ?? usualCells)))}
        aria-valuetext=${cells === undefined ? 'automatic' : `${shown} cells`}
        @input=${(event: Event) => {
          this.#dragged = cellsOfSlider(Number(textOf(event)));
          this.requestUpdate();
        }}
        @change=${(event: Event) => {
          this.#dragged = undefined;
          this.#setGrid({ cells: cellsOfSlider(Number(textOf(event))) });
        }}
      />
    </div>`;
  }

  #mode(): TemplateResult {
    const { doc } = this.app;
    const { mode } = doc.solve.grid;
    return html`<div class="row field">
      <label for="grid-mode">Lines are for</label>
      <select
        id="grid-mode"
        ?disabled=${doc.isBusy}
        @change=${(event: Event) => this.#setGrid({ mode: textOf(event) as GridSettings['mode'] })}
      >
        <option value="tile" .selected=${live(mode === 'tile')}>a texture that tiles</option>
        <option value="quad" .selected=${live(mode === 'quad')}>
          a quad mesh: cones on grid points
        </option>
      </select>
    </div>`;
  }

  /** The outcome of alignment for the map that is shown. */
  #outcome(): TemplateResult | typeof nothing {
    const { doc } = this.app;
    const outcome = doc.current && gridOutcome(doc.current);
    if (!outcome) return nothing;
    const { isAligned, cells, cellsPerCone, spacing, reason, workingCells } = outcome;
    if (isAligned) {
      const each = Number.isFinite(cellsPerCone)
        ? `, ${cellsPerCone.toFixed(0)} for each cone`
        : '';
      return html`<p class="note" id="grid-outcome">
        ${count(cells)} cells${each}; each is ${spacing.toPrecision(3)} units of the file wide.
      </p>`;
    }
    const better = (): void => this.#setGrid({ cells: workingCells });
    return html`<p class="note warn" id="grid-outcome">
      Not aligned: ${reason ? noteForPage(reason) : 'no whole numbers were found for its seams'}.
      ${
        workingCells > 0
          ? html`<button type="button" class="small" id="denser" @click=${better}>
              Use ${count(workingCells)} cells
            </button>`
          : nothing
      }
    </p>`;
  }

  #improve(): TemplateResult {
    const { improve } = this.app.doc.solve;
    const isOn = improve !== undefined;
    const balance = improve ?? 0;
    const word = balance === 0 ? 'both' : balance < 0 ? 'angles' : 'areas';
    const text = Math.abs(balance) === 1 || balance === 0 ? word : `more for ${word}`;
    return html`<p>
        <label class="tick">
          <input
            type="checkbox"
            id="quality"
            .checked=${live(isOn)}
            @change=${(event: Event) => this.#set({ improve: isChecked(event) ? gentle : undefined })}
          />
          Less distortion
        </label>
        <small>Takes longer; the map stays certified.</small>
      </p>
      ${
        isOn
          ? html`<label class="ends" for="improve"
              ><span>Angles</span>
              <input
                id="improve"
                type="range"
                min="-1"
                max="1"
                step="0.25"
                aria-label="What is kept: angles or areas"
                aria-valuetext=${text}
                .value=${live(String(balance))}
                @change=${(event: Event) => this.#set({ improve: Number(textOf(event)) })}
              />
              <span>Areas</span></label
            >`
          : nothing
      }`;
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
        <small>of solve, verify, repair</small>
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
        <small>seconds; a run that takes longer is given up</small>
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
      ${actionButton(this.app, 'import-cones', { domId: 'field-file', className: 'small', text: 'Field file…', hint: 'Open a direction field' })}
      <small
        >Auto: a smooth field that fits the cones. The file of a cross field (.rawfield, .rosy,
        .ffield) brings its cones and turns; From file follows its directions, too.</small
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
