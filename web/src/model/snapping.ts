// Corners and tips near a pointer: a cone belongs exactly there, and hardly any click hits the one vertex.

import type { Surface } from './types';

type Around = Pick<Surface, 'neighbourStart' | 'neighbours' | 'isBoundary' | 'angle'>;

/** Curvature of a vertex and its neighbours from which on it is a corner or a tip, in radians. */
const sharp = Math.PI / 7;
/** A corner must be this many times as sharp as the vertex under the pointer. */
const clearly = 1.3;
const maxVertices = 400;

const defect = ({ angle, isBoundary }: Around, v: number): number =>
  isBoundary[v] ? 0 : 2 * Math.PI - angle[v];

/** How pointed the surface is at v: its own curvature counts twice, so that of two neighbours the tip is chosen. */
function sharpness(surface: Around, v: number): number {
  let sum = 2 * defect(surface, v);
  for (let n = surface.neighbourStart[v]; n < surface.neighbourStart[v + 1]; n++)
    sum += defect(surface, surface.neighbours[n]);
  return Math.abs(sum) / 2;
}

/** Whether no neighbour is more pointed: the side of a corner out of reach is none itself. */
function isPeak(surface: Around, v: number, pointed: number): boolean {
  for (let n = surface.neighbourStart[v]; n < surface.neighbourStart[v + 1]; n++)
    if (sharpness(surface, surface.neighbours[n]) > pointed) return false;
  return true;
}

/** The corner or tip near a vertex, or else the vertex. `isNear`: whether a vertex is near enough to the pointer. */
export function cornerNear(
  surface: Around,
  vertex: number,
  isNear: (v: number) => boolean,
): number {
  const seen = new Set([vertex]);
  const open = [vertex];
  const first = sharpness(surface, vertex);
  let best = vertex;
  let max = Math.max(sharp, clearly * first);
  for (let at = 0; at < open.length && open.length < maxVertices; at++) {
    for (let n = surface.neighbourStart[open[at]]; n < surface.neighbourStart[open[at] + 1]; n++) {
      const v = surface.neighbours[n];
      if (seen.has(v) || !isNear(v)) continue;
      seen.add(v);
      open.push(v);
      const pointed = surface.isBoundary[v] ? 0 : sharpness(surface, v);
      if (pointed > max && isPeak(surface, v, pointed)) [best, max] = [v, pointed];
    }
  }
  return best;
}
