// Facts about a surface that need no worker.

import { areaOf } from './triangle';
import type { Surface } from './types';

/** The angle defect at v in degrees: positive at a corner of a cube, negative at a saddle. */
export function defectDegrees(surface: Surface, v: number): number {
  return (defect(surface, v) * 180) / Math.PI;
}

function defect(surface: Surface, v: number): number {
  return (surface.isBoundary[v] ? Math.PI : 2 * Math.PI) - surface.angle[v];
}

/** Length in the map per length on the surface, in one triangle; `uv`: two numbers per corner. */
export function scaleAt(
  surface: Pick<Surface, 'positions' | 'triangles'>,
  uv: ArrayLike<number>,
  t: number,
): number {
  const at = 6 * t;
  const [dx, dy, ex, ey] = [uv[at + 2] - uv[at], uv[at + 3] - uv[at + 1], uv[at + 4] - uv[at], uv[at + 5] - uv[at + 1]]; // prettier-ignore
  return Math.sqrt(Math.abs(dx * ey - dy * ex) / (2 * areaOf(surface, t)));
}

const reach = 0.03; // as a fraction of the diagonal
const maxVertices = 600;

/** Vertices within a small distance along edges, the vertex itself first. */
export function neighbourhood(surface: Surface, vertex: number): number[] {
  const { positions: p, neighbourStart, neighbours, diagonal } = surface;
  const seen = new Set([vertex]);
  const found = [vertex];
  const far = (v: number): number =>
    Math.hypot(...[0, 1, 2].map((i) => p[3 * v + i] - p[3 * vertex + i]));
  for (let at = 0; at < found.length && found.length < maxVertices; at++) {
    for (let n = neighbourStart[found[at]]; n < neighbourStart[found[at] + 1]; n++) {
      const w = neighbours[n];
      const isFirstRing = at === 0;
      if (seen.has(w) || (!isFirstRing && far(w) > reach * diagonal)) continue;
      seen.add(w);
      found.push(w);
    }
  }
  return found;
}

/** The curvature around v in radians: the sum of defects over a neighbourhood, in which noise cancels. */
export function curvatureAround(surface: Surface, vertex: number): number {
  return neighbourhood(surface, vertex)
    .filter((v) => !surface.isBoundary[v])
    .reduce((sum, v) => sum + defect(surface, v), 0);
}
