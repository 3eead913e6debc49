// What came out as quads, while they are shown on the model.

import { html, nothing, type TemplateResult } from 'lit';
import { attempt, type AppView } from '../actions/app';
import { downloadQuads, hideQuads, previewQuads, whyNoQuads } from '../actions/quads';
import { valencesOf } from '../model/quad_shape';
import { count, plural } from '../text/format';
import { askedFor, quadFaults } from '../text/quads';

export function quadsNote(app: AppView): TemplateResult | typeof nothing {
  const { doc } = app;
  const { quads, current } = doc;
  if (!current || whyNoQuads(app) !== '') return nothing;
  const show = (): void => void attempt(app, () => previewQuads(app));
  if (quads?.of !== current || !quads.isShown) {
    const isGrid = current.grid.isOn;
    return isGrid
      ? html`<p class="row">
          <button
            type="button"
            class="small"
            id="preview-quads"
            ?disabled=${doc.isBusy}
            @click=${show}
          >
            Preview as quads
          </button>
        </p>`
      : nothing;
  }
  const { counts } = valencesOf(quads.shape);
  const irregular = [...counts].filter(([k]) => k !== 4).sort(([a], [b]) => a - b);
  const { made } = quads;
  const save = (file: 'obj' | 'glb') => (): void =>
    void attempt(app, () => downloadQuads(app, file));
  return html`<div class="note" id="quads-note">
    <p>
      <b>${plural(made.quads, 'quad')}.</b>
      ${askedFor(made, quads.asked, current.prescription.cones.length)}
    </p>
    <dl class="facts">
      <div>
        <dt>Vertices with 4 edges</dt>
        <dd>${count(counts.get(4) ?? 0)}</dd>
      </div>
      ${irregular.map(
        ([k, n]) =>
          html`<div>
            <dt>with ${k}</dt>
            <dd>${count(n)}</dd>
          </div>`,
      )}
      <div>
        <dt>Folded</dt>
        <dd id="quads-folded">
          ${made.foldedInSpace === 0 ? 'none' : html`${count(made.foldedInSpace)}, in pink`}
        </dd>
      </div>
    </dl>
    ${quadFaults(made).map((text) => html`<p>${text}</p>`)}
    <p class="row">
      <button type="button" class="small" id="save-quads-obj" @click=${save('obj')}>
        Save OBJ
      </button>
      <button type="button" class="small" id="save-quads-glb" @click=${save('glb')}>
        Save GLB
      </button>
      <button type="button" class="small" id="hide-quads" @click=${() => hideQuads(app)}>
        Back to the map
      </button>
    </p>
  </div>`;
}
