// Boundaries and handles: turning indices l and rotations r, automatic unless someone says otherwise.

import { html, nothing, type TemplateResult } from 'lit';
import type { App } from '../state/app';
import { setHandle, setTurning } from '../state/edit';
import { angleText } from '../state/prescription';
import type { Controls } from './controls';
import { typed } from './typed';

/** A stepper that may also stand on "auto". */
function stepper(
  name: string,
  value: number | null,
  start: number,
  set: (n: number | null) => void,
): TemplateResult {
  const change = (event: Event): void => {
    const { value: text } = event.target as HTMLInputElement;
    set(text.trim() === '' ? null : Number(text));
  };
  const from = value ?? start;
  return html`<span class="stepper">
    <button
      type="button"
      aria-label="${name}: smaller"
      @click=${() => set(value === null ? from : from - 1)}
    >
      −
    </button>
    <input
      type="number"
      aria-label=${name}
      placeholder="auto"
      .value=${typed(value === null ? '' : String(value))}
      @change=${change}
    />
    <button
      type="button"
      aria-label="${name}: larger"
      @click=${() => set(value === null ? from : from + 1)}
    >
      +
    </button>
  </span>`;
}

export function turnings(app: App, ui: Controls): TemplateResult | typeof nothing {
  const { q, turnings: list, handles } = app.asked;
  if (list.length + handles.length === 0) return nothing;
  const loops = app.info!.components!.flatMap(({ boundaryLoops }) => boundaryLoops);
  const found = app.current?.result.cones;
  const asSolved = new Map(found?.boundaries?.map(({ loop, l }) => [loop, l]));
  const rSolved = new Map(found?.handles?.map(({ generator, r }) => [generator, r]));
  return html`<details open id="panel-turnings">
    <summary>
      Boundaries and handles<span class="count">${list.length + handles.length}</span>
    </summary>
    ${loops.slice(0, 40).map(({ loop, vertices, length, turningAngle, anchor }) => {
      const natural = Math.round((turningAngle / (2 * Math.PI)) * q);
      const l = list[loop];
      const solved = asSolved.get(loop);
      return html`<div class="row field" data-loop=${loop}>
        <button
          type="button"
          class="link"
          title="Show"
          @click=${() => ui.showPlaces([{ kind: 'loop', id: loop, other: anchor }])}
        >
          Boundary ${loop + 1}
        </button>
        ${stepper(`Turning index l of boundary ${loop + 1}`, l, natural, (n) => setTurning(app, loop, n))}
        <small
          >${vertices} vertices · length ${length.toPrecision(3)} · by shape
          ${natural}${
            l === null
              ? solved === undefined
                ? ''
                : ` · solved with ${solved}`
              : ` · ${angleText(l, q)}`
          }</small
        >
      </div>`;
    })}
    ${handles.slice(0, 40).map((r, generator) => {
      const solved = rSolved.get(generator);
      return html`<div class="row field" data-handle=${generator}>
        <button
          type="button"
          class="link"
          title="Show"
          aria-pressed=${ui.handlesShown}
          @click=${() => ui.showHandles(!ui.handlesShown)}
        >
          <i class="swatch" data-hue=${generator % 8}></i>Handle loop ${generator + 1}
        </button>
        ${stepper(`Rotation r of handle loop ${generator + 1}`, r, solved ?? 0, (n) => setHandle(app, generator, n))}
        <small
          >${r === null ? (solved === undefined ? 'from the smooth field' : `solved with ${solved}`) : angleText(r, q)}</small
        >
      </div>`;
    })}
    <p class="note">
      Empty means automatic: boundaries take what the cones leave, handles follow the smooth field.
    </p>
  </details>`;
}
