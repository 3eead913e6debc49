// Boundaries and handles: turning indices l and rotations r, automatic unless prescribed.

import { html, nothing, type TemplateResult } from 'lit';
import { attempt } from '../actions/app';
import { setHandle, setTurning } from '../actions/edit_cones';
import { perform } from '../actions/registry';
import { showPlaces } from '../actions/view';
import { angleText } from '../model/prescription';
import { plural } from '../text/format';
import { keepWhileTyping } from './keep_while_typing';
import { Panel } from './panel';

const few = 8; // up to this many handle loops are listed without a click
const maxRows = 200;

class BoundariesPanel extends Panel {
  #hasAllHandles = false;

  override render(): TemplateResult | typeof nothing {
    const { doc } = this.app;
    const { turnings, handles } = doc.prescription;
    if (!doc.usableModel || turnings.length + handles.length === 0) return nothing;
    const isSaid = [...turnings, ...handles].some((n) => n !== null);
    return html`<details ?open=${turnings.length > 0 || isSaid} id="panel-turnings">
      <summary>
        Boundaries and handles<span class="count">${turnings.length + handles.length}</span>
      </summary>
      ${this.#loops()} ${this.#handles()}
      <p class="note">
        Empty means automatic: boundaries take what the cones leave, and handles follow the smooth
        field. A boundary turns by l · 360°/q, and the map by r · 360°/q around a handle.
      </p>
    </details>`;
  }

  #loops(): TemplateResult {
    const { app } = this;
    const { doc } = app;
    const { q, turnings } = doc.prescription;
    const loops = doc.model!.info.components!.flatMap(({ boundaryLoops }) => boundaryLoops);
    const solved = new Map(doc.current?.result.cones.boundaries?.map(({ loop, l }) => [loop, l]));
    const rows = loops.slice(0, maxRows).map(({ loop, vertices, length, turningAngle, anchor }) => {
      const natural = Math.round((turningAngle / (2 * Math.PI)) * q);
      const l = turnings[loop] ?? null;
      const found = solved.get(loop);
      const now = l !== null ? ` · ${angleText(l, q)}` : found === undefined ? '' : ` · solved with ${found}`; // prettier-ignore
      return html`<div class="row field" data-loop=${loop}>
        <button
          type="button"
          class="link"
          title="Show"
          @click=${() => showPlaces(app, [{ kind: 'loop', id: loop, other: anchor }])}
        >
          Boundary ${loop + 1}
        </button>
        ${this.#stepper(
          `Turning index l of boundary ${loop + 1}`,
          l,
          natural,
          (n) => void attempt(app, () => setTurning(app, loop, n)),
        )}
        <small
          >${vertices} vertices · length ${length.toPrecision(3)} · by its shape
          ${String(natural).replace('-', '−')}${now}</small
        >
      </div>`;
    });
    const hidden = loops.length - rows.length;
    return html`${rows}${hidden > 0 ? html`<p class="note">… and ${plural(hidden, 'more boundary', 'more boundaries')}, which take what the cones leave unless a cone file prescribes them.</p>` : nothing}`;
  }

  #handles(): TemplateResult | typeof nothing {
    const { app } = this;
    const { doc, ui } = app;
    const { q, handles } = doc.prescription;
    if (handles.length === 0) return nothing;
    const solved = new Map(
      doc.current?.result.cones.handles?.map(({ generator, r }) => [generator, r]),
    );
    const isListed = (r: number | null, i: number): boolean =>
      r !== null || i < few || this.#hasAllHandles;
    const rows = handles.map((r, generator) => {
      if (!isListed(r, generator)) return nothing;
      const found = solved.get(generator);
      const free = found === undefined ? 'from the smooth field' : `solved with ${found}`;
      return html`<div class="row field" data-handle=${generator}>
        <button
          type="button"
          class="link"
          title="Show"
          aria-pressed=${ui.handlesShown}
          @click=${() => void perform(app, 'handles')}
        >
          <i class="swatch" data-hue=${generator % 8}></i>Handle loop ${generator + 1}
        </button>
        ${this.#stepper(
          `Rotation r of handle loop ${generator + 1}`,
          r,
          found ?? 0,
          (n) => void attempt(app, () => setHandle(app, generator, n)),
        )}
        <small>${r === null ? free : angleText(r, q)}</small>
      </div>`;
    });
    const hidden = handles.filter((r, i) => !isListed(r, i)).length;
    const showAll = (): void => {
      this.#hasAllHandles = true;
      this.requestUpdate();
    };
    return html`${rows}
    ${
      hidden > 0
        ? html`<p>
            <button type="button" class="small" @click=${showAll}>and ${hidden} more</button>
          </p>`
        : nothing
    }`;
  }

  /** A stepper with an additional value "auto". */
  #stepper(
    name: string,
    value: number | null,
    start: number,
    set: (n: number | null) => void,
  ): TemplateResult {
    const change = (event: Event): void => {
      const { value: text } = event.target as HTMLInputElement;
      set(text.trim() === '' ? null : Number(text));
      this.requestUpdate(); // the field shows what holds, whatever was typed
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
        .value=${keepWhileTyping(value === null ? '' : String(value))}
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
}
customElements.define('hgp-boundaries-panel', BoundariesPanel);
