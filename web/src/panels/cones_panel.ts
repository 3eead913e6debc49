// The Cones panel: number, positions and angles of cones, and the remainder in Gauss–Bonnet.

import { html, nothing, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import { attempt, type App } from '../actions/app';
import { coneSteps, knownCount, setConeStep } from '../actions/cone_slider';
import { deleteCone, select, setK, setOrder } from '../actions/edit_cones';
import { lookAtCone } from '../actions/view';
import { waysToSpend, type ComponentBudget } from '../model/gauss_bonnet';
import { angleText, indexText } from '../model/prescription';
import type { SortKey } from '../model/ui_state';
import { plural } from '../text/format';
import { actionButton } from './action_button';
import { icon } from './icons';
import { keepWhileTyping } from './keep_while_typing';
import { Panel } from './panel';
import './cones_panel.css';

const orderNames: [number, string][] = [
  [1, '1 · no turns'],
  [2, '2 · stripes'],
  [3, '3 · triangles'],
  [4, '4 · quads'],
  [6, '6 · hexagons'],
  [8, '8'],
];
const mostBars = 8;

const stepNames = ['As few as areas allow', 'Few', 'In the middle', 'Many', 'Little distortion'];

/** Who placed the cones, if it was not the slider. */
function ownerOf({ doc }: App): string {
  const { undoKind, canUndo } = doc.history;
  if (undoKind === 'suggest cones') return '';
  if (!canUndo || undoKind === 'import cones') return 'from a file';
  return 'placed by you';
}

class ConesPanel extends Panel {
  /** Position of the slider while it is dragged. */
  #dragged?: number;

  override render(): TemplateResult | typeof nothing {
    const { app } = this;
    const { doc } = app;
    if (!doc.usableModel) return nothing;
    const { cones } = doc.prescription;
    return html`<details open id="panel-cones">
      <summary>Cones<span class="count">${cones.length}</span></summary>
      ${this.#orderChooser()} ${this.#budget()}
      ${(doc.budget?.warnings ?? []).map((text) => html`<p class="note warn">${text}</p>`)}
      <p class="row">
        ${actionButton(app, 'suggest', { className: 'small' })}
        ${actionButton(app, 'balance', { className: 'small' })}
      </p>
      ${this.#slider()} ${cones.length > 0 ? this.#table() : nothing}
      <p class="row">
        ${actionButton(app, 'import-cones', { className: 'small', text: 'Import…' })}
        ${actionButton(app, 'export-cones', { className: 'small', text: 'Export' })}
        ${actionButton(app, 'clear-cones', { className: 'small', text: 'Clear' })}
      </p>
    </details>`;
  }

  #orderChooser(): TemplateResult {
    const { app } = this;
    const { q } = app.doc.prescription;
    const isKnown = orderNames.some(([n]) => n === q);
    const set = (event: Event): void => {
      const input = event.target as HTMLSelectElement | HTMLInputElement;
      void attempt(app, () => setOrder(app, Number(input.value)));
      this.requestUpdate(); // so that the field shows the valid value again
    };
    return html`<div class="row field">
      <label for="q">Symmetry q</label>
      <select id="q" .value=${live(String(q))} @change=${set}>
        ${orderNames.map(
          ([n, name]) => html`<option value=${n} ?selected=${n === q}>${name}</option>`,
        )}
        ${isKnown ? nothing : html`<option value=${q} selected>${q}</option>`}
      </select>
      <input
        id="q-custom"
        type="number"
        min="1"
        max="64"
        aria-label="Symmetry q as a number"
        .value=${keepWhileTyping(String(q))}
        @change=${set}
      />
    </div>`;
  }

  /** Chooses automatic cones by purpose. */
  #slider(): TemplateResult {
    const { app } = this;
    const step = this.#dragged ?? app.doc.coneStep;
    const placed = app.doc.prescription.cones.length;
    const known =
      knownCount(app, step) ?? (this.#dragged === undefined && placed > 0 ? placed : undefined);
    const text = known === undefined ? '' : plural(known, 'cone');
    const owner = this.#dragged === undefined && placed > 0 ? ownerOf(app) : '';
    const at = (event: Event): number => Number((event.target as HTMLInputElement).value);
    return html`<label class="ends ${owner ? 'pale' : ''}" for="cone-step"
        ><span>Fewer</span>
        <input
          id="cone-step"
          type="range"
          min="0"
          max=${coneSteps - 1}
          step="1"
          aria-label="Suggested cones: fewer, or less distortion"
          aria-valuetext="${stepNames[step]}${text ? `, ${text}` : ''}"
          .value=${live(String(step))}
          @input=${(event: Event) => {
            this.#dragged = at(event);
            this.requestUpdate();
          }}
          @change=${(event: Event) => {
            this.#dragged = undefined;
            void attempt(app, () => setConeStep(app, at(event)));
          }}
        />
        <span>Less distortion</span></label
      >
      <p class="note" id="cone-step-count">
        ${
          owner
            ? html`<b>${plural(placed, 'cone')}</b>, ${owner}; the slider replaces them`
            : html`${stepNames[step]}${text ? html`: <b>${text}</b>` : nothing}`
        }
      </p>`;
  }

  #budget(): TemplateResult | TemplateResult[] {
    const { doc } = this.app;
    const components = doc.budget?.components ?? [];
    if (doc.prescription.cones.length > 0 || doc.hasUserCones) {
      if (components.length === 1) return this.#bar(components[0], true);
      const open = components.filter(({ isBalanced }) => !isBalanced);
      const balanced = components.length - open.length;
      return [
        ...open.slice(0, mostBars).map((one) => this.#bar(one, false)),
        ...(balanced > 0 ? [this.#balancedOnes(balanced, components.length)] : []),
      ];
    }
    return html`<p class="note">
      No cones yet. <b>Run</b> suggests them; or click the surface with the Place tool (C).
    </p>`;
  }

  /** One line for all components that need no attention. */
  #balancedOnes(count: number, all: number): TemplateResult {
    const which = count === all ? `All ${all} components` : `${count} of ${all} components`;
    return html`<div class="budget good" data-left="0">
      <p>${which} <strong>${icon('check')}balanced</strong></p>
    </div>`;
  }

  #bar(budget: ComponentBudget, isOnly: boolean): TemplateResult {
    const { have, need, left, openLoops, isBalanced, component } = budget;
    const { q, turnings } = this.app.doc.prescription;
    const most = Math.max(Math.abs(need), Math.abs(have), 1);
    const open = left > 0 ? `${left} left` : `${-left} too much`;
    const taken = openLoops > 0 && left !== 0 ? `the boundary takes ${left}` : 'balanced';
    const ways = isBalanced ? '' : waysToSpend(left, q);
    return html`<div class="budget ${isBalanced ? 'good' : 'open'}" data-left=${left}>
      <p>
        ${isOnly ? '' : `Component ${component + 1}: `}<span class="sum"
          >Σ(q − k)${turnings.length > 0 ? ' + Σl' : ''} = <b>${have}</b> of q·χ =
          <b>${need}</b></span
        >
        <strong>${icon(isBalanced ? 'check' : 'cross')}${isBalanced ? taken : open}</strong>
      </p>
      <meter
        min="0"
        max=${most}
        .value=${Math.min(Math.abs(have), most)}
        aria-label="Budget used"
      ></meter>
      ${ways ? html`<p class="note">Add ${ways}.</p>` : nothing}
    </div>`;
  }

  /** Indices of the cones in the order of the table. */
  #sorted(): number[] {
    const { cones } = this.app.doc.prescription;
    const { sort } = this.app.ui;
    const order = cones.map((_, i) => i);
    if (sort.by === 'vertex') order.sort((a, b) => cones[a].vertex - cones[b].vertex);
    if (sort.by === 'k') order.sort((a, b) => cones[a].k - cones[b].k || a - b);
    return sort.isDown ? order.reverse() : order;
  }

  #column(by: SortKey, title: string): TemplateResult {
    const { ui } = this.app;
    const { sort } = ui;
    const direction = sort.by !== by ? 'none' : sort.isDown ? 'descending' : 'ascending';
    return html`<th scope="col" aria-sort=${direction}>
      <button type="button" class="link" data-sort=${by} @click=${() => ui.sortBy(by)}>
        ${title}${direction === 'none' ? '' : sort.isDown ? ' ↓' : ' ↑'}
      </button>
    </th>`;
  }

  #table(): TemplateResult {
    const { ui, doc } = this.app;
    const { cones } = doc.prescription;
    const shown = this.#sorted().slice(0, ui.mostRows);
    return html`<div class="scroll">
        <table id="cones">
          <thead>
            <tr>
              ${this.#column('number', '#')} ${this.#column('vertex', 'Vertex')}
              ${this.#column('k', 'k')}
              <th scope="col">Angle</th>
              <td></td>
            </tr>
          </thead>
          <tbody>
            ${shown.map((i) => this.#row(i))}
          </tbody>
        </table>
      </div>
      ${
        cones.length > shown.length
          ? html`<p>
              <button type="button" class="small" @click=${() => (ui.mostRows = Infinity)}>
                Show all ${cones.length}
              </button>
            </p>`
          : nothing
      }`;
  }

  #row(i: number): TemplateResult {
    const { app } = this;
    const { doc } = app;
    const { q, cones } = doc.prescription;
    const { vertex, k } = cones[i];
    const state = doc.budget?.cones[i] ?? { isGood: true, text: '' };
    const name = `Cone ${i + 1}`;
    const isSelected = i === doc.selected;
    return html`<tr
        class="${isSelected ? 'selected' : ''} ${state.isGood ? '' : 'bad'}"
        data-cone=${i}
        aria-selected=${isSelected}
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
        <td>${this.#stepper(i, k, name)}</td>
        <td class="angle">${angleText(k, q)}<small>index ${indexText(k, q)}</small></td>
        <td class="acts">
          <button
            type="button"
            class="only-icon plain"
            aria-label="${name}: frame"
            title="Look at it"
            @click=${() => lookAtCone(app, i)}
          >
            ${icon('frame')}
          </button>
          <button
            type="button"
            class="only-icon plain"
            aria-label="${name}: delete"
            @click=${() => void attempt(app, () => deleteCone(app, i))}
          >
            ${icon('cross')}
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

  #stepper(i: number, k: number, name: string): TemplateResult {
    const { app } = this;
    const set = (n: number): void => void attempt(app, () => setK(app, i, n));
    const typed = (event: Event): void => {
      set(Number((event.target as HTMLInputElement).value));
      this.requestUpdate();
    };
    return html`<span class="stepper">
      <button type="button" aria-label="${name}: smaller k" @click=${() => set(k - 1)}>−</button>
      <input
        type="number"
        min="1"
        inputmode="numeric"
        aria-label="${name}: k"
        .value=${keepWhileTyping(String(k))}
        @change=${typed}
      />
      <button type="button" aria-label="${name}: larger k" @click=${() => set(k + 1)}>+</button>
    </span>`;
  }
}
customElements.define('hgp-cones-panel', ConesPanel);
