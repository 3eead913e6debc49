// Summaries of a map in a few numbers.

import type { SmallestArea, Quantiles } from '../../model/measures';
import type { Box } from '../../model/types';
import { forEachIndex } from './loops';
import { weightedQuantile } from './sizes';

/**
 * The quantiles of values: those of triangles by area, as the certificate has them, where `weights` are their areas, and
 * of those alone that have one; all 0 if there are none.
 */
export function quantilesOf(values: Float32Array, weights?: Float64Array): Quantiles {
  const each = weights ?? new Float64Array(values.length).fill(1);
  const ids = Uint32Array.from(values.keys()).filter((i) => each[i] > 0);
  const at = (share: number): number => weightedQuantile(ids, values, each, share);
  let [min, max] = [Infinity, -Infinity];
  for (const i of ids) {
    if (values[i] < min) min = values[i];
    if (values[i] > max) max = values[i];
  }
  if (ids.length === 0) [min, max] = [0, 0];
  return { min, p5: at(0.05), median: at(0.5), p95: at(0.95), p99: at(0.99), max };
}

/** Areas of a map. `uv`: two numbers per triangle corner, as stored. */
export function smallestArea(uv: Float64Array): SmallestArea {
  const count = uv.length / 6;
  let area = Infinity;
  let triangle = -1;
  let sum = 0;
  let [negative, zero, smallestPositive] = [0, 0, Infinity];
  forEachIndex(count, (t) => {
    const a = 6 * t;
    const across = (uv[a + 2] - uv[a]) * (uv[a + 5] - uv[a + 1]);
    const signed = (across - (uv[a + 3] - uv[a + 1]) * (uv[a + 4] - uv[a])) / 2;
    sum += signed;
    if (signed < area) [area, triangle] = [signed, t];
    if (signed > 0) smallestPositive = Math.min(smallestPositive, signed);
    else if (signed < 0) negative += 1;
    else zero += 1;
  });
  return { area, mean: sum / count, triangle, negative, zero, smallestPositive };
}

export function boxOf(uv: ArrayLike<number>): Box {
  let [x0, y0, x1, y1] = [Infinity, Infinity, -Infinity, -Infinity];
  for (let i = 0; i < uv.length; i += 2) {
    const u = uv[i];
    const v = uv[i + 1];
    if (u < x0) x0 = u;
    if (u > x1) x1 = u;
    if (v < y0) y0 = v;
    if (v > y1) y1 = v;
  }
  return { x: x0, y: y0, width: x1 - x0, height: y1 - y0 };
}
