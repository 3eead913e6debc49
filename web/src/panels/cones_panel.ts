// The Cones panel: number, positions and angles of cones, and the remainder in Gauss–Bonnet.

import { html, nothing, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import { attempt, type AppView } from '../actions/app';
import { knownCount, setConeStep } from '../actions/cone_slider';
import { coneSteps } from '../actions/cone_steps';
import { setOrder } from '../actions/edit_cones';
import { waysToSpend, type ComponentBudget } from '../model/gauss_bonnet';
import { plural } from '../text/format';
import { actionButton } from './action_button';
import { icon } from './icons';
import { keepWhileTyping } from './keep_while_typing';
import { Panel } from './panel';
import './cone_table';
import './cones_panel.css';

const orderNames: [number, string][] = [
  [1, '1 · no turns'],
  [2, '2 · stripes'],
  [3, '3 · triangles'],
  [4, '4 · quads'],
  [6, '6 · hexagons'],
  [8, '8'],
];
const maxBars = 8;

const minus = (n: number): string => String(n).replace('-', '−');

/** What cones are counted in: one turn is cut into q equal parts. */
function turnsText(q: number, count: number): string {
  const parts: Record<number, string> = { 1: 'turn', 2: 'half turn', 3: 'third of a turn', 4: 'quarter turn', 5: 'fifth of a turn', 6: 'sixth of a turn', 8: 'eighth of a turn' }; // prettier-ignore
  const one = parts[q];
  if (!one) return `× 1/${q} turn`;
  return count === 1 ? one : one.replace(/^(third|fifth|sixth|eighth)/, '$1s').replace(/turn$/, one.includes('of') ? 'turn' : 'turns'); // prettier-ignore
}

const stepNames = [
  'As few as keep sizes even',
  'Few',
  'In the middle',
  'Many',
  'Little distortion',
];

/** Who placed the cones, if it was not the slider. */
function ownerOf({ doc }: AppView): string {
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
        ${doc.selected >= 0 ? actionButton(app, 'mirror-cone', { className: 'small', text: 'Mirror' }) : nothing}
      </p>
      ${this.#slider()}
      ${cones.length > 0 ? html`<hgp-cone-table .app=${app}></hgp-cone-table>` : nothing}
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
      <label
        for="q"
        title="Into how many equal angles a full turn is divided; cones are multiples of one"
        >Symmetry q</label
      >
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
        ...open.slice(0, maxBars).map((one) => this.#bar(one, false)),
        ...(balanced > 0 ? [this.#balancedOnes(balanced, components.length)] : []),
      ];
    }
    return html`<p class="note">
      No cones yet. <b>Run</b> suggests them; or <span class="for-mouse">click</span
      ><span class="for-fingers">tap</span> the surface with the Place tool<span class="for-mouse">
        (C)</span
      >.
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
    const max = Math.max(Math.abs(need), Math.abs(have), 1);
    const open = left > 0 ? `${left} left` : `${-left} too much`;
    const taken = openLoops > 0 && left !== 0 ? `the boundary takes ${left}` : 'balanced';
    const ways = isBalanced ? '' : waysToSpend(left, q);
    const formula = `The cones have to add up to this: Σ(q − k)${turnings.length > 0 ? ' + Σl' : ''} = ${have} of q·χ = ${need}`;
    return html`<div class="budget ${isBalanced ? 'good' : 'open'}" data-left=${left}>
      <p>
        ${isOnly ? '' : `Component ${component + 1}: `}<span class="sum" title=${formula}
          ><b>${minus(have)}</b> of <b>${minus(need)}</b> ${turnsText(q, need)}</span
        >
        <strong>${icon(isBalanced ? 'check' : 'cross')}${isBalanced ? taken : open}</strong>
      </p>
      <meter
        min="0"
        max=${max}
        .value=${Math.min(Math.abs(have), max)}
        aria-label="Budget used"
      ></meter>
      ${ways ? html`<p class="note">Add ${ways}.</p>` : nothing}
    </div>`;
  }
}
customElements.define('hgp-cones-panel', ConesPanel);
