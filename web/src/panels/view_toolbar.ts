// The toolbar over the 3D view: tools, pattern, overlay, scale, before and after.

import { html, nothing, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import { attempt } from '../actions/app';
import type { ActionId } from '../actions/registry';
import { choosePattern, setLook, sliderOf, tilesOf } from '../actions/view';
import { isGltfModel } from '../formats/glb';
import { hasSteps } from '../model/grid';
import { overlays, patterns, type Overlay, type Pattern } from '../model/types';
import { plural } from '../text/format';
import { actionButton } from './action_button';
import { icon } from './icons';
import { Panel } from './panel';
import { keepRoving, roveFocus } from './roving_focus';
import './view_toolbar.css';

const patternNames: Record<Pattern, string> = {
  checker: 'Checker',
  grid: 'Grid',
  brick: 'Brick',
  wood: 'Wood',
  plaid: 'Plaid',
  cross: 'Crosses',
  hex: 'Hexagons',
  circles: 'Circles',
  image: 'Your image…',
  material: 'Own materials',
  plain: 'None',
};

const overlayNames: Record<Overlay, string> = {
  none: 'No overlay',
  angle: 'Angle distortion',
  area: 'Area distortion',
  seams: 'Distance to seams',
  flips: 'Folded triangles',
};

const maxSteps = 8; // maximum number of tiles along a cell

const valueOf = (event: Event): string => (event.target as HTMLSelectElement).value;

/** The tools shown directly where there is little room; all others are in a menu. */
const fewTools = ['orbit', 'place', 'frame'] as const;
const allTools = [
  ...['orbit', 'place', 'edges', 'frame', 'wire', 'seams'],
  ...['next-light', 'picture', 'turntable'],
] as const;

class ViewToolbar extends Panel {
  override render(): TemplateResult {
    const { app } = this;
    const { isNarrow } = app.ui;
    const tools = (isNarrow ? fewTools : allTools).map((id) =>
      actionButton(app, id, {
        isIconOnly: true,
        domId: id === 'orbit' || id === 'place' || id === 'edges' ? `tool-${id}` : id,
      }),
    );
    return html`<div
        class="toolbar"
        role="toolbar"
        aria-label="3D view"
        @keydown=${roveFocus}
        @focusin=${keepRoving}
      >
        <span class="group tools">${tools}</span>
        ${isNarrow ? this.#menuButton() : nothing}
        ${!isNarrow && app.doc.displayed ? html`<span class="group">${this.#looks()}</span>` : nothing}
      </div>
      ${isNarrow ? this.#menu() : nothing}`;
  }

  #menuButton(): TemplateResult {
    return html`<span class="group"
      ><button type="button" id="view-menu" popovertarget="view-options">
        View${icon('more')}
      </button></span
    >`;
  }

  /** The menu, placed below the picture, so that its effect is visible. */
  #menu(): TemplateResult {
    const { app } = this;
    // With words: fingers get no tooltips.
    const button = (id: ActionId, text?: string): TemplateResult =>
      actionButton(app, id, { className: 'small', text });
    const switches = (
      ['wire', 'seams', 'next-light', 'parallel', 'handles', 'reset-camera'] as const
    ).map((id) => button(id));
    return html`<div class="popup" id="view-options" popover role="group" aria-label="View">
      <p class="row">${switches}${button('edges', 'Choose edges')}</p>
      ${app.doc.displayed ? this.#looks() : nothing}
      <p class="row end">
        ${button('picture')}${button('turntable')}
        <button type="button" class="small" popovertarget="view-options" popovertargetaction="hide">
          Done
        </button>
      </p>
    </div>`;
  }

  /** The scale of the pattern; on an aligned map in whole tiles per cell, since lines meet only then. */
  #scale(): TemplateResult {
    const { app } = this;
    const { look, displayed } = app.doc;
    const isStepped = hasSteps(look, displayed);
    const value = isStepped ? look.steps : sliderOf(look.tiles);
    const text = isStepped
      ? `${plural(look.steps, 'tile')} along a cell`
      : `${look.tiles.toFixed(0)} tiles across`;
    const set = (event: Event): void => {
      const n = Number(valueOf(event));
      setLook(app, isStepped ? { steps: n } : { tiles: tilesOf(n) });
    };
    return html`<label class="scale" title="Scale of the pattern: ${text}">
      ${icon('tiles')}<span>Scale</span>
      <input
        id="scale"
        type="range"
        data-steps=${isStepped}
        min=${isStepped ? 1 : 0}
        max=${isStepped ? maxSteps : 100}
        step="1"
        .value=${live(String(value))}
        aria-valuetext=${text}
        @input=${set}
      />
    </label>`;
  }

  #looks(): TemplateResult {
    const { app } = this;
    const { look, model, displayed } = app.doc;
    const hasMaterials = model !== undefined && isGltfModel(model);
    // The overlay of flips is offered only if there are any, or if it is already shown.
    const hasFlips = look.overlay === 'flips' || (displayed?.distortion.flipped.length ?? 0) > 0;
    return html`<label class="choice"
        ><span>Pattern</span
        ><select
          id="pattern"
          aria-label="Pattern"
          .value=${live(look.pattern)}
          @change=${(event: Event) =>
            void attempt(app, () => choosePattern(app, valueOf(event) as Pattern))}
        >
          ${patterns
            .filter((name) => name !== 'material' || hasMaterials)
            .map(
              (name) =>
                html`<option value=${name} ?selected=${look.pattern === name}>
                  ${patternNames[name]}
                </option>`,
            )}
        </select></label
      >
      <label class="choice"
        ><span>Overlay</span
        ><select
          id="overlay"
          aria-label="Overlay"
          .value=${live(look.overlay)}
          @change=${(event: Event) => setLook(app, { overlay: valueOf(event) as Overlay })}
        >
          ${overlays
            .filter((name) => name !== 'flips' || hasFlips)
            .map(
              (name) =>
                html`<option value=${name} ?selected=${look.overlay === name}>
                  ${overlayNames[name]}
                </option>`,
            )}
        </select></label
      >
      ${this.#scale()}
      <label
        class="scale"
        title="Before and after: how much of the picture shows the model as it was"
      >
        ${icon('wipe')}<span>Before</span>
        <input
          id="wipe"
          type="range"
          min="0"
          max="100"
          step="1"
          aria-label="Before and after"
          .value=${live(String(app.ui.wipe))}
          aria-valuetext="${app.ui.wipe} % of the picture shows the model before"
          @input=${(event: Event) => (app.ui.wipe = Number(valueOf(event)))}
        />
      </label> `;
  }
}
customElements.define('hgp-view-toolbar', ViewToolbar);
