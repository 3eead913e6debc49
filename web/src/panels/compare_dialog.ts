// The Compare dialog: the last runs beside one another, with the numbers that tell them apart.

import { html, nothing, type TemplateResult } from 'lit';
import { attempt, type AppView } from '../actions/app';
import { returnTo } from '../actions/compare_runs';
import { compareRuns } from '../model/compare';
import type { Solution } from '../model/types';
import { dialogFrame } from './dialog_frame';

export function compareDialog(app: AppView): TemplateResult {
  const { doc, ui } = app;
  const { runs, displayed } = doc;
  const close = (): void => void (ui.dialog = '');
  const choose = (solution: Solution): void => {
    close();
    void attempt(app, () => returnTo(app, solution));
  };
  return dialogFrame(
    'compare-dialog',
    'Compare runs',
    html`<div class="scroll-x">
        <table id="runs">
          <thead>
            <tr>
              <td></td>
              ${runs.map(
                (one, i) =>
                  html`<th scope="col">
                    Run ${i + 1}${one === displayed ? html`<small>shown</small>` : nothing}
                  </th>`,
              )}
            </tr>
          </thead>
          <tbody>
            ${compareRuns(runs).map(
              ({ name, cells }) =>
                html`<tr>
                  <th scope="row">${name}</th>
                  ${cells.map(
                    ({ text, isBest }) =>
                      html`<td class=${isBest ? 'best' : ''}>
                        ${text}${isBest ? html`<span class="visually-hidden">, the best</span>` : nothing}
                      </td>`,
                  )}
                </tr>`,
            )}
          </tbody>
          <tfoot>
            <tr>
              <td></td>
              ${runs.map(
                (one, i) =>
                  html`<td>
                    <button
                      type="button"
                      class="small"
                      data-run=${i}
                      ?disabled=${one === doc.current || doc.isBusy}
                      aria-label="Show run ${i + 1}"
                      @click=${() => choose(one)}
                    >
                      Show
                    </button>
                  </td>`,
              )}
            </tr>
          </tfoot>
        </table>
      </div>
      <p class="note">
        The last three runs are kept. Show brings back the cones and settings of a run.
      </p>
      <p class="row end">
        <button type="button" class="primary" autofocus @click=${close}>Close</button>
      </p>`,
    close,
  );
}
