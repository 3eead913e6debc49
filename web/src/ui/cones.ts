// Cones: how many, where, how strong, and what is left of the budget.

import { html, nothing, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import type { App } from '../state/app';
import type { PartBudget } from '../state/budget';
import { waysToSpend } from '../state/budget';
import { clearCones, deleteCone, putRestOnSelected, select, setK, setOrder } from '../state/edit';
import { coneFile, save } from '../state/exports';
import { angleText, indexText } from '../state/prescription';
import { suggest } from '../state/run';
import type { Controls } from './controls';
import { icon } from './icons';
import { typed } from './typed';

const orders: [number, string][] = [
  [1, '1 · no turns'],
  [2, '2 · stripes'],
  [3, '3 · triangles'],
  [4, '4 · quads'],
  [6, '6 · hexagons'],
  [8, '8'],
];

function chooser(app: App): TemplateResult {
  const { q } = app.asked;
  const isKnown = orders.some(([n]) => n === q);
  const set = (event: Event): void => {
    const input = event.target as HTMLSelectElement | HTMLInputElement;
    setOrder(app, Number(input.value));
    app.changed();
  };
  return html`<div class="row field">
    <label for="q">Symmetry q</label>
    <select id="q" .value=${live(String(q))} @change=${set}>
      ${orders.map(([n, name]) => html`<option value=${n} ?selected=${n === q}>${name}</option>`)}
      ${isKnown ? nothing : html`<option value=${q} selected>${q}</option>`}
    </select>
    <input
      id="q-custom"
      type="number"
      min="1"
      max="64"
      aria-label="Symmetry q as a number"
      .value=${typed(String(q))}
      @change=${set}
    />
  </div>`;
}

function bar(app: App, budget: PartBudget, isOnly: boolean): TemplateResult {
  const { have, need, left, openLoops, isBalanced, part } = budget;
  const most = Math.max(Math.abs(need), Math.abs(have), 1);
  const text = isBalanced
    ? openLoops > 0 && left !== 0
      ? `the boundary takes ${left}`
      : 'balanced'
    : left > 0
      ? `${left} left`
      : `${-left} too much`;
  const ways = isBalanced ? '' : waysToSpend(left, app.asked.q);
  return html`<div class="budget ${isBalanced ? 'good' : 'open'}" data-left=${left}>
    <p>
      ${isOnly ? '' : `Part ${part + 1}: `}<span class="sum"
        >Σ(q − k)${app.asked.turnings.length > 0 ? ' + Σl' : ''} = <b>${have}</b> of q·χ =
        <b>${need}</b></span
      >
      <strong>${icon(isBalanced ? 'check' : 'cross')}${text}</strong>
    </p>
    <meter
      min="0"
      max=${most}
      .value=${Math.min(Math.abs(have), most)}
      aria-label="Budget used"
    ></meter>
    ${ways ? html`<p class="note">Spend it with ${ways}.</p>` : nothing}
  </div>`;
}

function row(app: App, ui: Controls, i: number): TemplateResult {
  const { q, cones: list } = app.asked;
  const { vertex, k } = list[i];
  const state = app.budget?.cones[i] ?? { isGood: true, text: '' };
  const name = `Cone ${i + 1}`;
  return html`<tr
      class="${i === app.selected ? 'selected' : ''} ${state.isGood ? '' : 'bad'}"
      data-cone=${i}
      aria-selected=${i === app.selected}
    >
      <th scope="row">
        <button
          type="button"
          class="link"
          aria-label="${name}: select"
          @click=${() => select(app, i)}
        >
          <span class="shape" data-sign=${Math.sign(q - k)} aria-hidden="true"></span>${i + 1}
        </button>
      </th>
      <td>${vertex}</td>
      <td>
        <span class="stepper">
          <button type="button" aria-label="${name}: smaller k" @click=${() => setK(app, i, k - 1)}>
            −
          </button>
          <input
            type="number"
            min="1"
            inputmode="numeric"
            aria-label="${name}: k"
            .value=${typed(String(k))}
            @change=${(event: Event) => setK(app, i, Number((event.target as HTMLInputElement).value))}
          />
          <button type="button" aria-label="${name}: larger k" @click=${() => setK(app, i, k + 1)}>
            +
          </button>
        </span>
      </td>
      <td class="angle">${angleText(k, q)}<small>index ${indexText(k, q)}</small></td>
      <td class="acts">
        <button
          type="button"
          class="only-icon plain"
          aria-label="${name}: frame"
          title="Look at it"
          @click=${() => ui.lookAt(i)}
        >
          ${icon('frame')}
        </button>
        <button
          type="button"
          class="only-icon plain"
          aria-label="${name}: delete"
          @click=${() => deleteCone(app, i)}
        >
          ${icon('remove')}
        </button>
      </td>
    </tr>
    ${
      state.text === 'ok'
        ? nothing
        : html`<tr class="why ${state.isGood ? '' : 'bad'}">
            <td colspan="5">${state.text}</td>
          </tr>`
    }`;
}

/** Indices of the cones in the order of the table. */
function sorted({ asked }: App, { sort }: Controls): number[] {
  const order = asked.cones.map((_, i) => i);
  const { cones: list } = asked;
  if (sort.by === 'vertex') order.sort((a, b) => list[a].vertex - list[b].vertex);
  if (sort.by === 'k') order.sort((a, b) => list[a].k - list[b].k || a - b);
  return sort.isDown ? order.reverse() : order;
}

function column(ui: Controls, by: Controls['sort']['by'], title: string): TemplateResult {
  const { sort } = ui;
  const direction = sort.by !== by ? 'none' : sort.isDown ? 'descending' : 'ascending';
  return html`<th scope="col" aria-sort=${direction}>
    <button type="button" class="link" data-sort=${by} @click=${() => ui.sortBy(by)}>
      ${title}${direction === 'none' ? '' : sort.isDown ? ' ↓' : ' ↑'}
    </button>
  </th>`;
}

export function cones(app: App, ui: Controls): TemplateResult {
  const list = app.asked.cones;
  const parts = app.budget?.parts ?? [];
  const isUnbalanced = parts.some(({ isBalanced }) => !isBalanced);
  const shown = sorted(app, ui).slice(0, ui.mostRows);
  return html`<details open id="panel-cones">
    <summary>Cones<span class="count">${list.length}</span></summary>
    ${chooser(app)}
    ${
      list.length > 0 || app.isExplicit
        ? parts.slice(0, 8).map((part) => bar(app, part, parts.length === 1))
        : html`<p class="note">
            No cones yet. <b>Run</b> suggests them; or click the surface with the Place tool (C).
          </p>`
    }
    ${(app.budget?.warnings ?? []).map((text) => html`<p class="note warn">${text}</p>`)}
    <p class="row">
      <button type="button" class="small" id="suggest" @click=${() => void suggest(app)}>
        Suggest cones
      </button>
      <button
        type="button"
        class="small"
        id="rest"
        ?disabled=${app.selected < 0 || !isUnbalanced}
        @click=${() => putRestOnSelected(app)}
      >
        Put rest on selected
      </button>
    </p>
    ${
      list.length === 0
        ? nothing
        : html`<div class="scroll">
            <table id="cones">
              <thead>
                <tr>
                  ${column(ui, 'number', '#')} ${column(ui, 'vertex', 'Vertex')}
                  ${column(ui, 'k', 'k')}
                  <th scope="col">Angle</th>
                  <td></td>
                </tr>
              </thead>
              <tbody>
                ${shown.map((i) => row(app, ui, i))}
              </tbody>
            </table>
          </div>`
    }
    ${
      list.length > shown.length
        ? html`<p>
            <button type="button" class="small" @click=${() => ui.showMoreRows()}>
              Show all ${list.length}
            </button>
          </p>`
        : nothing
    }
    <p class="row">
      <label class="tick">
        <input
          type="checkbox"
          id="keep-balanced"
          .checked=${app.keepsBalanced}
          @change=${(event: Event) => {
            app.keepsBalanced = (event.target as HTMLInputElement).checked;
            app.changed();
          }}
        />
        Keep balanced
      </label>
    </p>
    <p class="row">
      <button type="button" class="small" id="import-cones" @click=${() => ui.chooseConeFile()}>
        Import…
      </button>
      <button
        type="button"
        class="small"
        id="export-cones"
        ?disabled=${list.length === 0}
        @click=${() => save(coneFile(app))}
      >
        Export
      </button>
      <button
        type="button"
        class="small"
        id="clear-cones"
        ?disabled=${list.length === 0}
        @click=${() => clearCones(app)}
      >
        Clear
      </button>
    </p>
  </details>`;
}
