// The mirror images of vertices in a plane across which the solver has found the surface to be symmetric.

import type { Surface } from '../../model/types';
import { reflected, type Plane } from './mirror_plane';
import { NearestVertex } from './nearest_vertex';

type Shape = Pick<Surface, 'positions' | 'representative' | 'diagonal' | 'vertexCount'>;

const rounding = 1e-9; // of the diagonal

/** Per vertex the one at its mirror image, up to a distance: itself in the plane; −1 if there is none. */
export function mirrorImages(shape: Shape, plane: Plane, distance: number): Int32Array {
  const { positions, representative, diagonal, vertexCount } = shape;
  const own: number[] = [];
  for (let v = 0; v < vertexCount; v++) if (representative[v] === v) own.push(v);
  const nearest = new NearestVertex(positions, own, 2 * distance + rounding * diagonal);
  const images = new Int32Array(vertexCount).fill(-1);
  for (const v of own) {
    const [x, y, z] = positions.subarray(3 * v, 3 * v + 3);
    images[v] = nearest.of(reflected(plane, [x, y, z]));
  }
  return images;
}
