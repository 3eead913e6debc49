// The Result panel: verdict, three summary numbers, and the checks under Details.

import { html, nothing, type TemplateResult } from 'lit';
import { attempt } from '../actions/app';
import { leaveRepairsOut } from '../actions/repair';
import { run } from '../actions/solve';
import { showPlaces } from '../actions/view';
import type { Solution } from '../model/types';
import {
  componentsOf,
  isCertified,
  reasonsOf,
  shortNumber,
  verdictRows,
  type VerdictRow,
} from '../model/verdict';
import { draggedNote } from '../text/dragged';
import { memoryText, signed } from '../text/format';
import { noteForPage } from '../text/notes';
import { repairsMade } from '../text/repairs';
import { actionButton } from './action_button';
import { icon } from './icons';
import { Panel } from './panel';
import { quadsNote } from './quads_note';
import { sizeRows } from './size_rows';
import './result_panel.css';

type Fact = [name: string, value: string];

/** "90°", "51.4°" */
const shortDegrees = (q: number): string => `${Number((360 / q).toFixed(1))}°`;

/** The length of the seams on the surface, in the unit of the file. */
function seamLength({ seams, result: { positions: p, uvToVertex } }: Solution): number {
  return seams.reduce((sum, { a }) => {
    const [v, w] = a.map((end) => 3 * uvToVertex[end]);
    return sum + Math.hypot(p[w] - p[v], p[w + 1] - p[v + 1], p[w + 2] - p[v + 2]);
  }, 0);
}

function statistics(solution: Solution): Fact[] {
  const { distortion, result, box } = solution;
  const { report, certificate } = result;
  const rounds = report.components.flatMap(
    (one) => (one.rounds as { iterations: number; laplacianEnergy?: number }[]) ?? [],
  );
  const energy = rounds.at(-1)?.laplacianEnergy;
  const parts = componentsOf(certificate).flatMap((one) =>
    one.distortion ? [one.distortion] : [],
  );
  const mu = parts.toSorted((a, b) => b.p95Mu - a.p95Mu)[0];
  const { stretch, area } = distortion;
  const min = Math.min(...parts.map((one) => one.minLogArea));
  const max = Math.max(...parts.map((one) => one.maxLogArea));
  const iterations = rounds.reduce((sum, one) => sum + one.iterations, 0);
  const facts: (Fact | undefined)[] = [
    mu && [`μ${parts.length > 1 ? ' of the worst component' : ''}, mean · 95 % · max`, [mu.meanMu, mu.p95Mu, mu.maxMu].map((x) => x.toFixed(3)).join(' · ')], // prettier-ignore
    ['Stretch σ₁/σ₂, 50 · 95 %', `${stretch.median.toFixed(2)} · ${stretch.p95.toFixed(2)}`],
    ['log₂ area, 5 · 95 %', `${signed(area.p5)} · ${signed(area.p95)}`],
    mu && ['log₂ area, min · max', `${signed(min)} · ${signed(max)}`],
    ['Map, width × height', `${box.width.toPrecision(3)} × ${box.height.toPrecision(3)}`],
    ['Seam length', seamLength(solution).toPrecision(3)],
    energy === undefined ? undefined : ['Energy ‖Lz‖²', shortNumber(energy)],
    ['Rounds · iterations', `${rounds.length} · ${iterations}`],
    ['Stored as', certificate.precision],
    ['Time', `${report.seconds.toFixed(2)} s`],
    ['Peak memory', memoryText(result.memory)],
  ];
  return facts.filter((one) => one !== undefined);
}

const factList = (facts: Fact[]): TemplateResult =>
  html`<dl class="facts">
    ${facts.map(
      ([name, value]) =>
        html`<div>
          <dt>${name}</dt>
          <dd>${value}</dd>
        </div>`,
    )}
  </dl>`;

class ResultPanel extends Panel {
  override render(): TemplateResult | typeof nothing {
    const { doc } = this.app;
    const solution = doc.displayed;
    if (!solution) return nothing;
    const isGood = isCertified(solution);
    return html`<details open id="panel-result" class=${doc.current === solution ? '' : 'stale'}>
      <summary>Result</summary>
      ${this.#banner(solution, isGood)} ${sizeRows(this.app, solution)} ${quadsNote(this.app)}
      ${isGood ? nothing : this.#reasons(solution)} ${this.#dragged(solution)} ${this.#repairs()}
      <p class="row">
        ${this.app.doc.runs.length > 1 ? actionButton(this.app, 'compare', { className: 'small' }) : nothing}
        ${actionButton(this.app, 'copy-link', { className: 'small', text: 'Copy a link' })}
      </p>
      <details id="result-details" ?open=${!isGood}>
        <summary>Details</summary>
        ${this.#table(solution)} ${factList(statistics(solution))}
        <p class="row">${actionButton(this.app, 'save-report', { className: 'small' })}</p>
        ${[...solution.notes, ...solution.result.report.notes].map(
          (note) => html`<p class="note">${noteForPage(note)}</p>`,
        )}
      </details>
    </details>`;
  }

  #banner(solution: Solution, isGood: boolean): TemplateResult {
    const { doc } = this.app;
    const isStale = doc.current !== solution;
    const angles =
      doc.history.undoKind === 'suggest cones'
        ? `every angle is a multiple of ${shortDegrees(solution.prescription.q)}`
        : 'every angle is the one you asked for';
    const text = isGood
      ? `No triangle is folded, ${angles}, every seam fits.`
      : 'This map does not pass all checks. You can still look at it and download it.';
    return html`<div class="verdict ${isGood ? 'good' : 'bad'} ${isStale ? 'stale' : ''}">
      ${icon(isGood ? 'check' : 'cross')}
      <div>
        <b id="verdict">${isGood ? 'Certified' : 'Not certified'}</b>
        <p>${isStale ? 'For the previous cones. ' : ''}${text}</p>
      </div>
    </div>`;
  }

  /** A note that the map is not that of a run. */
  #dragged(solution: Solution): TemplateResult | typeof nothing {
    if (!solution.isDragged) return nothing;
    const runAnew = (): void => void attempt(this.app, () => run(this.app));
    return html`<div class="note" id="dragged">
      <p><b>Dragged.</b> ${draggedNote(solution)}</p>
      <button type="button" class="small" ?disabled=${this.app.doc.isBusy} @click=${runAnew}>
        Run anew
      </button>
    </div>`;
  }

  /** A note next to the verdict that the solved surface differs from the one in the file. */
  #repairs(): TemplateResult | typeof nothing {
    const { app } = this;
    const { model } = app.doc;
    const repairs = model && repairsMade(model.info, model.loaded);
    if (!repairs) return nothing;
    const act = (): void => void attempt(app, () => leaveRepairsOut(app));
    return html`<div class="note" id="repairs">
      <p><b>Repaired first.</b> ${repairs.defects} The triangles in the file stay as they are.</p>
      ${
        repairs.made.length > 0
          ? html`<ul>
              ${repairs.made.map((text) => html`<li>${text}</li>`)}
            </ul>`
          : nothing
      }
      <button type="button" class="small" ?disabled=${app.doc.isBusy} @click=${act}>
        Leave repairs out
      </button>
    </div>`;
  }

  #reasons(solution: Solution): TemplateResult[] {
    return reasonsOf(solution).map(
      ({ message, where = [] }) =>
        html`<p class="note bad">
          ${message}
          ${
            where.length > 0
              ? html`<button
                  type="button"
                  class="small"
                  @click=${() => showPlaces(this.app, where)}
                >
                  Show
                </button>`
              : nothing
          }
        </p>`,
    );
  }

  #table(solution: Solution): TemplateResult {
    return html`<table id="certificate">
      <thead class="visually-hidden">
        <tr>
          <th scope="col">Check</th>
          <th scope="col">Value</th>
          <th scope="col">Passed</th>
        </tr>
      </thead>
      <tbody>
        ${verdictRows(solution).map((row) => this.#row(row))}
      </tbody>
    </table>`;
  }

  #row({ name, value, tolerance, isGood, isFact, where }: VerdictRow): TemplateResult {
    const passed = html`${icon(isGood ? 'check' : 'cross')}<span class="visually-hidden"
        >${isGood ? 'passed' : 'failed'}</span
      >`;
    const show = html`<button
      type="button"
      class="link"
      aria-label="Show worst: ${name}"
      @click=${() => showPlaces(this.app, where)}
    >
      Show worst
    </button>`;
    return html`<tr class=${isGood || isFact ? '' : 'bad'}>
      <th scope="row">${name}<small>${tolerance}</small></th>
      <td>${value} ${where.length > 0 && !isGood ? show : nothing}</td>
      <td class="passed">${isFact && !isGood ? '–' : passed}</td>
    </tr>`;
  }
}
customElements.define('hgp-result-panel', ResultPanel);
