// All meshes of a file: which one is open, and the state of each.

import { html, nothing, type TemplateResult } from 'lit';
import { attempt } from '../actions/app';
import { switchMesh } from '../actions/load';
import type { Model } from '../model/types';
import { isCertified } from '../model/verdict';
import { thumbnailSize } from '../services/geometry/thumbnail';
import { count } from '../text/format';
import { icon } from './icons';
import { Panel } from './panel';
import { keepRoving, roveFocus } from './roving_focus';
import { runOneButton } from './top_bar';
import './mesh_strip.css';

type MeshState = 'certified' | 'not-certified' | 'unusable' | 'open' | 'waiting';

const stateTexts: Record<MeshState, string> = {
  certified: 'certified',
  'not-certified': 'not certified',
  unusable: 'cannot be used as it is',
  open: 'not run yet',
  waiting: 'not run yet',
};

const stateIcons: Partial<Record<MeshState, Parameters<typeof icon>[0]>> = {
  certified: 'check',
  'not-certified': 'cross',
  unusable: 'warning',
};

class MeshStrip extends Panel {
  readonly #drawn = new WeakMap<HTMLCanvasElement, Uint8ClampedArray>();

  override render(): TemplateResult | typeof nothing {
    const { app } = this;
    const { model } = app.doc;
    if (!model || model.info.surfaces.length < 2) return nothing;
    const { surfaces } = model.info;
    return html`<nav class="mesh-strip" aria-label="Meshes of this file">
      <span class="meshes" @keydown=${roveFocus} @focusin=${keepRoving}>
        ${surfaces.map(({ index, name, triangles }) => {
          const state = this.#stateOf(index, model);
          const isOpen = index === model.info.surface;
          return html`<button
            type="button"
            class="small"
            data-mesh=${index}
            data-mesh-state=${state}
            aria-current=${isOpen}
            ?disabled=${app.doc.isBusy}
            title="${count(triangles)} triangles, ${this.#why(index) || stateTexts[state]}"
            @click=${() => void attempt(app, () => switchMesh(app, index))}
          >
            ${
              app.doc.thumbnails.has(index)
                ? html`<canvas
                    width=${thumbnailSize}
                    height=${thumbnailSize}
                    data-thumbnail=${index}
                  ></canvas>`
                : nothing
            }
            ${stateIcons[state] ? icon(stateIcons[state]) : nothing}
            <span>${name || `Mesh ${index}`}</span>
            <span class="visually-hidden">, ${stateTexts[state]}</span>
          </button>`;
        })}
      </span>
      ${app.doc.isBusy ? nothing : runOneButton(app, 'Run this one')}
    </nav>`;
  }

  override updated(): void {
    const { thumbnails } = this.app.doc;
    for (const canvas of this.querySelectorAll<HTMLCanvasElement>('[data-thumbnail]')) {
      const picture = thumbnails.get(Number(canvas.dataset.thumbnail));
      if (!picture || this.#drawn.get(canvas) === picture) continue;
      this.#drawn.set(canvas, picture);
      const data = new ImageData(new Uint8ClampedArray(picture), thumbnailSize);
      canvas.getContext('2d')?.putImageData(data, 0, 0);
    }
  }

  #why(index: number): string {
    const seen = this.app.doc.summaries.find((one) => one.index === index);
    return seen && !seen.isUsable ? seen.why : '';
  }

  #stateOf(index: number, { info }: Model): MeshState {
    const { doc } = this.app;
    const isOpen = index === info.surface;
    const solution = isOpen ? doc.displayed : doc.meshes.get(index)?.solutions.at(-1);
    if (solution) return isCertified(solution) ? 'certified' : 'not-certified';
    if (isOpen) return info.usable ? 'open' : 'unusable';
    return this.#why(index) ? 'unusable' : 'waiting';
  }
}
customElements.define('hgp-mesh-strip', MeshStrip);
