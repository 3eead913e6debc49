// What lies over the 3D view: tools, pattern, overlay, scale.

import { html, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import { overlays, patterns, type App, type Overlay, type Pattern } from '../state/app';
import type { Controls } from './controls';
import { icon } from './icons';

const patternNames: Record<Pattern, string> = {
  cross: 'Crosses',
  grid: 'Grid',
  checker: 'Checker',
  hex: 'Hexagons',
  circles: 'Circles',
  image: 'Your image…',
  material: 'Original',
  plain: 'None',
};

const overlayNames: Record<Overlay, string> = {
  none: 'No overlay',
  angle: 'Angle distortion',
  area: 'Area distortion',
  seams: 'Distance to seams',
  flips: 'Flips',
};

export function toolbar(app: App, ui: Controls): TemplateResult {
  const { look } = app;
  const tool = (name: 'orbit' | 'place', label: string, key: string): TemplateResult =>
    html`<button
      type="button"
      class="only-icon"
      id="tool-${name}"
      aria-label=${label}
      title="${label} (${key})"
      aria-pressed=${ui.tool === name}
      @click=${() => ui.setTool(name)}
    >
      ${icon(name)}
    </button>`;
  return html`<div class="toolbar" role="toolbar" aria-label="3D view">
    <span class="group">
      ${tool('orbit', 'Orbit', 'C')} ${tool('place', 'Place cones', 'C')}
      <button
        type="button"
        class="only-icon"
        aria-label="Frame all"
        title="Frame all (F)"
        @click=${() => ui.frame()}
      >
        ${icon('frame')}
      </button>
      <button
        type="button"
        class="only-icon"
        id="wire"
        aria-label="Wireframe"
        title="Wireframe (L)"
        aria-pressed=${look.hasWire}
        @click=${() => ui.setLook({ hasWire: !look.hasWire })}
      >
        ${icon('wire')}
      </button>
      <button
        type="button"
        class="only-icon"
        id="seams"
        aria-label="Seams"
        title="Seams (S)"
        aria-pressed=${look.hasSeams}
        @click=${() => ui.setLook({ hasSeams: !look.hasSeams })}
      >
        ${icon('seams')}
      </button>
    </span>
    <span class="group">
      <select
        id="pattern"
        aria-label="Pattern"
        .value=${live(look.pattern)}
        @change=${(event: Event) => ui.choosePattern((event.target as HTMLSelectElement).value as Pattern)}
      >
        ${patterns
          .filter(
            (name) =>
              name !== 'material' || app.shown?.written.files[0].name.match(/\.(glb|gltf)$/i),
          )
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
        @change=${(event: Event) => ui.setLook({ overlay: (event.target as HTMLSelectElement).value as Overlay })}
      >
        ${overlays.map(
          (name) =>
            html`<option value=${name} ?selected=${look.overlay === name}>
              ${overlayNames[name]}
            </option>`,
        )}
      </select>
      <label class="scale">
        <span>Scale</span>
        <input
          id="scale"
          type="range"
          min="0"
          max="100"
          step="1"
          .value=${live(String(ui.sliderOf(look.tiles)))}
          aria-valuetext="${look.tiles.toFixed(0)} tiles across"
          @input=${(event: Event) => ui.setSlider(Number((event.target as HTMLInputElement).value))}
        />
      </label>
    </span>
  </div>`;
}
