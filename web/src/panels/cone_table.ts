// The table of cones. Where there are many, cones of one angle are one line, which opens.

import { html, nothing, type TemplateResult } from 'lit';
import { attempt } from '../actions/app';
import { deleteCone, select, setK } from '../actions/edit_cones';
import { lookAtCone } from '../actions/view';
import { angleText, indexText } from '../model/prescription';
import type { SortKey } from '../model/ui_state';
import { plural } from '../text/format';
import { icon } from './icons';
import { keepWhileTyping } from './keep_while_typing';
import { Panel } from './panel';
import { keepOneStop, moveInTable, stopAt } from './table_focus';

/** More cones are counted by angle. */
const maxListed = 20;

class ConeTable extends Panel {
  /** Indices of the cones in the order of the table. */
  #sorted(): number[] {
    const { cones } = this.app.doc.prescription;
    const { sort } = this.app.ui;
    const order = cones.map((_, i) => i);
    if (sort.by === 'vertex') order.sort((a, b) => cones[a].vertex - cones[b].vertex);
    if (sort.by === 'k') order.sort((a, b) => cones[a].k - cones[b].k);
    return sort.isDown ? order.reverse() : order;
  }

  #column(by: SortKey, title: string, hint = ''): TemplateResult {
    const { ui } = this.app;
    const { sort } = ui;
    const direction = sort.by !== by ? 'none' : sort.isDown ? 'descending' : 'ascending';
    return html`<th scope="col" aria-sort=${direction}>
      <button
        type="button"
        class="link"
        data-sort=${by}
        title=${hint}
        @click=${() => ui.sortBy(by)}
      >
        ${title}${direction === 'none' ? '' : sort.isDown ? ' ↓' : ' ↑'}
      </button>
    </th>`;
  }

  override render(): TemplateResult {
    const { ui, doc } = this.app;
    const { cones } = doc.prescription;
    const isGrouped = cones.length > maxListed;
    const sorted = this.#sorted();
    const shown = sorted.slice(0, ui.maxRows);
    return html`<div class="scroll">
        <table id="cones" @keydown=${moveInTable} @focusin=${stopAt}>
          <thead>
            <tr>
              ${this.#column('number', '#')} ${this.#column('vertex', 'Vertex')}
              ${this.#column('k', 'k', 'The angle of the cone, in parts of a full turn: q of them are 360°')}
              <th scope="col">Angle</th>
              <td></td>
            </tr>
          </thead>
          <tbody>
            ${isGrouped ? this.#groups(sorted) : shown.map((i) => this.#row(i))}
          </tbody>
        </table>
      </div>
      ${
        !isGrouped && cones.length > shown.length
          ? html`<p>
              <button type="button" class="small" @click=${() => (ui.maxRows = Infinity)}>
                Show all ${cones.length}
              </button>
            </p>`
          : nothing
      }`;
  }

  protected override updated(): void {
    keepOneStop(this.querySelector('#cones'));
  }

  /** One line for the cones of each angle; those that are open, selected or wrong are listed below it. */
  #groups(sorted: readonly number[]): TemplateResult[] {
    const { doc, ui } = this.app;
    const { cones, q } = doc.prescription;
    const kinds = [...new Set(cones.map(({ k }) => k))].sort((a, b) => a - b);
    return kinds.map((k) => {
      const members = sorted.filter((i) => cones[i].k === k);
      const isOpen = ui.openGroups.has(k);
      const isTold = (i: number): boolean =>
        isOpen || i === doc.selected || doc.budget?.cones[i]?.isGood === false;
      return html`<tr class="kind" data-group=${k}>
          <th scope="rowgroup" colspan="5">
            <button
              type="button"
              class="link"
              aria-expanded=${isOpen}
              @click=${() => this.#toggle(k)}
            >
              <span class="shape" data-sign=${Math.sign(q - k)} aria-hidden="true"></span>
              ${plural(members.length, 'cone')} of ${angleText(k, q)}, k = ${k}
            </button>
          </th>
        </tr>
        ${members.filter(isTold).map((i) => this.#row(i))}`;
    });
  }

  #toggle(k: number): void {
    const { ui } = this.app;
    const open = new Set(ui.openGroups);
    if (!open.delete(k)) open.add(k);
    ui.openGroups = open;
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
customElements.define('hgp-cone-table', ConeTable);
