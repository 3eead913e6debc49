// Small aspects of the views: the map of a cone that is dragged, markers, the wipe.

import type { ReadonlyDocument } from '../model/document';
import type { UiState } from '../model/ui_state';
import type { ModelView } from './model_view';
import type { UvView } from './uv_view';

/** Whether the map that is shown is not that of the prescription. */
export const isStale = ({ displayed, current, live }: ReadonlyDocument): boolean =>
  displayed !== undefined && displayed !== current && !live;

/** @param show  shows the solution in a view as before */
export function liveConcern(
  doc: ReadonlyDocument,
  views: readonly (ModelView | UvView)[],
  show: (view: ModelView | UvView) => void,
) {
  return {
    key: () => [doc.live],
    show: () => {
      for (const view of views) {
        view.setLive(doc.live);
        view.canvas.dataset.live = doc.live?.state ?? '';
        if (!doc.live) show(view);
      }
    },
  };
}

interface Sources {
  doc: ReadonlyDocument;
  ui: UiState;
  model: ModelView;
}

/** Markers are faded after Run, until cones are edited again. */
export function markersConcern({ doc, ui, model }: Sources) {
  const areFaded = (): boolean => doc.current !== undefined && ui.tool === 'orbit';
  return { key: () => [areFaded()], show: () => model.setMarkers(areFaded()) };
}

/** The edges that lines follow. */
const featuresConcern = ({ doc, model }: Sources) => ({
  key: () => [doc.features, doc.model?.surface],
  show: () => {
    const { edges = [], rims = [] } = doc.features ?? {};
    model.marks.setFeatures(doc.model?.surface, [...edges, ...rims]);
    model.draw();
  },
});

const wipeConcern = ({ doc, ui, model }: Sources) => ({
  key: () => [ui.wipe, doc.displayed],
  show: () => model.setWipe(doc.displayed ? ui.wipe / 100 : 0),
});

export const lastConcerns = (sources: Sources) => [featuresConcern(sources), wipeConcern(sources)];
