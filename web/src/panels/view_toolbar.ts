// What lies over the 3D view: tools, pattern, overlay, scale, before and after.

import { html, nothing, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import { attempt } from '../actions/app';
import { choosePattern, setLook, sliderOf, tilesOf } from '../actions/view';
import { isGltf } from '../formats/glb';
import { hasSteps } from '../model/grid';
import { overlays, patterns, type Overlay, type Pattern } from '../model/types';
import { plural } from '../text/format';
import { actionButton } from './action_button';
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
  flips: 'Flips',
};

const mostSteps = 8; // tiles along a cell

const valueOf = (event: Event): string => (event.target as HTMLSelectElement).value;

class ViewToolbar extends Panel {
  override render(): TemplateResult {
    const { app } = this;
    const tools = (['orbit', 'place', 'frame', 'wire', 'seams'] as const).map((id) =>
      actionButton(app, id, {
        isIconOnly: true,
        domId: id === 'orbit' || id === 'place' ? `tool-${id}` : id,
      }),
    );
    return html`<div
      class="toolbar"
      role="toolbar"
      aria-label="3D view"
      @keydown=${roveFocus}
      @focusin=${keepRoving}
    >
      <span class="group">${tools}</span>
      ${app.doc.displayed ? this.#looks() : nothing}
    </div>`;
  }

  /** Of the pattern: in whole tiles per cell where lines meet, as they do only then. */
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
    return html`<label class="scale">
      <span>Scale</span>
      <input
        id="scale"
        type="range"
        data-steps=${isStepped}
        min=${isStepped ? 1 : 0}
        max=${isStepped ? mostSteps : 100}
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
    const hasMaterials = model !== undefined && isGltf(model.main);
    // Flips are worth a look only where there are any, or where one looks already.
    const hasFlips = look.overlay === 'flips' || (displayed?.distortion.flipped.length ?? 0) > 0;
    return html`<span class="group">
      <select
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
      </select>
      <select
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
      </select>
      ${this.#scale()}
      <label class="scale">
        <span>Before</span>
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
      </label>
    </span>`;
  }
}
customElements.define('hgp-view-toolbar', ViewToolbar);
