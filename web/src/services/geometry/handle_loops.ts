// The loops around handles, found by the solver, as lines on the surface.

import type { Surface } from '../../model/types';

/** Segments from the midpoint of each crossed edge to the next, six numbers each. */
export function loopSegments(
  { places: p }: Pick<Surface, 'places'>,
  crossed: Uint32Array,
): Float32Array {
  const count = crossed.length / 2;
  const out = new Float32Array(6 * count);
  for (let e = 0; e < count; e++) {
    const before = (e + count - 1) % count;
    for (let i = 0; i < 3; i++) {
      const middle = (p[3 * crossed[2 * e] + i] + p[3 * crossed[2 * e + 1] + i]) / 2;
      out[6 * e + i] = middle;
      out[6 * before + 3 + i] = middle;
    }
  }
  return out;
}
