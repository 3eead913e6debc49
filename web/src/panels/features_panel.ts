// Part of the Solve panel: which edges become straight lines.

import type { ModelInfo } from 'hgp';
import { html, nothing, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import { attempt } from '../actions/app';
import { keepCones } from '../actions/edit_cones';
import {
  clearFeatures,
  exportFeatures,
  followCreases,
  followRims,
  mirrorMap,
} from '../actions/features';
import { featuresText, hasEdges, hasFeatures, hasLongCreases } from '../model/features';
import { isSilent } from '../model/prescription';
import { plural } from '../text/format';
import { Panel } from './panel';

class FeaturesPanel extends Panel {
  override render(): TemplateResult | typeof nothing {
    const { doc } = this.app;
    const model = doc.usableModel;
    if (!model) return nothing;
    const { features, isBusy } = doc;
    const isPossible = doc.prescription.q === 4;
    const loops = model.info.boundaryLoops ?? 0;
    const tick = (id: string, text: string, isOn: boolean, set: (isOn: boolean) => unknown) =>
      html`<label class="tick">
        <input
          type="checkbox"
          id=${id}
          ?disabled=${!isPossible || isBusy}
          .checked=${live(isOn)}
          @change=${(event: Event) =>
            void attempt(this.app, () => set((event.target as HTMLInputElement).checked))}
        />
        ${text}
      </label>`;
    const { hasCreases = false, hasRims = false, isSymmetric = false } = features ?? {};
    const hasMirror = (model.info.mirrors ?? []).length > 0;
    return html`<p>
        ${tick('follow-creases', 'Lines follow creases', hasCreases, (isOn) => followCreases(this.app, isOn))}
        ${loops > 0 ? tick('follow-rims', 'Lines follow rims', hasRims, (isOn) => followRims(this.app, isOn)) : nothing}
        ${hasMirror ? tick('symmetric', 'Symmetric map', isSymmetric, (isOn) => mirrorMap(this.app, isOn)) : nothing}
        <small
          >${isPossible ? this.#hint(model.info) : `Lines along edges need q = 4, not ${doc.prescription.q}.`}</small
        >
      </p>
      ${features && isPossible ? this.#chosen(loops) : nothing}
      ${features && isPossible && !isSilent(doc.prescription) ? html`<p>${tick('keep-cones', 'Keep the cones that are placed', !doc.choosesCones, (isOn) => keepCones(this.app, isOn))}</p>` : nothing}`;
  }

  #hint(info: ModelInfo): string {
    const { features, choosesCones } = this.app.doc;
    const found = info.features?.creaseChains ?? 0;
    const isOffered = hasLongCreases(info) && !features;
    const keeps = features !== undefined && !choosesCones;
    const pairs = features?.isSymmetric ? ' Cones are placed and moved in pairs.' : '';
    return `${isOffered ? `This model has ${plural(found, 'long crease')}. ` : ''}These edges become straight lines of the map, exactly; Run ${keeps ? 'keeps the cones that are placed' : 'chooses cones that fit'}.${pairs}`;
  }

  #chosen(loops: number): TemplateResult | typeof nothing {
    const { doc } = this.app;
    const { features, current, isBusy } = doc;
    if (!features || !hasFeatures(features)) return nothing;
    const text = featuresText(features, loops);
    const { length } = features.edges;
    const inside = length > 0 ? `: ${plural(length, 'edge')} inside the surface` : '';
    const isDone = current?.features !== undefined && current.result.certificate.certified;
    return html`<p class="note" id="features-note">
      ${isDone ? text[0].toUpperCase() + text.slice(1) : `After Run, ${text}`}${inside}.
      ${hasEdges(features) ? this.#exporter() : nothing}
      <button
        type="button"
        class="small"
        id="features-clear"
        ?disabled=${isBusy}
        @click=${() => clearFeatures(this.app)}
      >
        None
      </button>
    </p>`;
  }

  #exporter(): TemplateResult {
    return html`<button
      type="button"
      class="small"
      id="features-export"
      @click=${() => void attempt(this.app, () => exportFeatures(this.app))}
    >
      Save the list
    </button>`;
  }
}
customElements.define('hgp-features-panel', FeaturesPanel);
