// Edges that lines follow, on another reading of the surface.

import type { Cones } from 'hgp';
import { edgesAlong, EdgeMap, hasFeatures, type FeatureChoice } from '../model/features';
import type { Surface } from '../model/types';
import { count, plural } from '../text/format';
import type { App } from './app';

let known: { surface: Surface; map: EdgeMap } | undefined;

/** Edges of the open surface, made when first needed. */
export function edgeMap({ doc }: App): EdgeMap | undefined {
  const surface = doc.usableModel?.surface;
  if (!surface) return undefined;
  if (known?.surface !== surface) known = { surface, map: new EdgeMap(surface) };
  return known.map;
}

/** Takes the choice from another reading of the open surface; tells what became of it. */
export function keepFeatures(app: App, before: FeatureChoice | undefined): string {
  const map = edgeMap(app);
  if (!before || !map) return '';
  const kept = map.kept(before);
  app.doc.features = hasFeatures(kept) ? kept : undefined;
  const lost = before.edges.length - kept.edges.length;
  if (lost > 0)
    return ` ${count(lost)} of ${plural(before.edges.length, 'edge')} that lines follow are gone.`;
  return before.hasRims && !kept.hasRims
    ? ' There is no rim any more that lines could follow.'
    : '';
}

/** What is said of them after the number of cones. */
export const andLines = ', with edges that lines follow';

/** Takes the edges of cones that were read from a file, which are then kept along them; whether there are any. */
export function takeFeaturesOf(app: App, { features }: Cones): boolean {
  const map = edgeMap(app);
  const edges = edgesAlong(features);
  if (!map || (edges.length === 0 && !features?.rims)) return false;
  const hasRims = features?.rims === true || edges.some((edge) => map.isRim(edge));
  takeFeatures(app, { hasCreases: false, hasRims, edges, keepsCones: true });
  return app.doc.features !== undefined;
}

/** Takes a choice from elsewhere, as far as the open surface has its edges. */
export function takeFeatures(app: App, choice: Omit<FeatureChoice, 'rims'>): void {
  keepFeatures(app, { ...choice, rims: [] });
}
