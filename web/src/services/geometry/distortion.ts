// Distortion of each triangle, and sizes.

import type { Box, LeastArea, Quantiles } from '../../model/types';
import { forEachIndex } from './loops';

export interface FaceDistortion {
  /** Ratio of singular values, 1 = angles kept; per triangle. */
  conformal: Float32Array;
  /** log₂ of area scaling relative to the whole; per triangle. */
  area: Float32Array;
  /** Its absolute value. */
  areaSize: Float32Array;
  flipped: Uint32Array;
  uvArea: number;
  surfaceArea: number;
}

export function measureDistortion(p: Float64Array, uv: Float64Array): FaceDistortion {
  const count = uv.length / 6;
  const conformal = new Float32Array(count);
  const area = new Float32Array(count);
  const flipped: number[] = [];
  let uvArea = 0;
  let surfaceArea = 0;
  forEachIndex(count, (t) => {
    const [a, b, c] = [9 * t, 9 * t + 3, 9 * t + 6];
    const e0 = p[b] - p[a];
    const e1 = p[b + 1] - p[a + 1];
    const e2 = p[b + 2] - p[a + 2];
    const f0 = p[c] - p[a];
    const f1 = p[c + 1] - p[a + 1];
    const f2 = p[c + 2] - p[a + 2];
    const length = Math.sqrt(e0 * e0 + e1 * e1 + e2 * e2);
    const x = (e0 * f0 + e1 * f1 + e2 * f2) / length;
    const y = Math.sqrt(Math.max(0, f0 * f0 + f1 * f1 + f2 * f2 - x * x));
    const ux = uv[6 * t + 2] - uv[6 * t];
    const uy = uv[6 * t + 3] - uv[6 * t + 1];
    const vx = uv[6 * t + 4] - uv[6 * t];
    const vy = uv[6 * t + 5] - uv[6 * t + 1];
    // The derivative: columns d/dx and d/dy in the plane of the triangle.
    const j00 = ux / length;
    const j10 = uy / length;
    const j01 = (vx - x * j00) / y;
    const j11 = (vy - x * j10) / y;
    const similar = Math.sqrt((j00 + j11) ** 2 + (j10 - j01) ** 2) / 2;
    const anti = Math.sqrt((j00 - j11) ** 2 + (j10 + j01) ** 2) / 2;
    const signed = (ux * vy - uy * vx) / 2;
    conformal[t] = (similar + anti) / Math.max(Math.abs(similar - anti), 1e-12);
    area[t] = Math.log2(Math.max(Math.abs(signed), 1e-30) / Math.max((length * y) / 2, 1e-30));
    if (!(signed > 0)) flipped.push(t);
    uvArea += Math.abs(signed);
    surfaceArea += (length * y) / 2;
  });
  const mean = Math.log2(uvArea / surfaceArea);
  const areaSize = new Float32Array(count);
  for (let t = 0; t < count; t++) areaSize[t] = Math.abs((area[t] -= mean));
  return { conformal, area, areaSize, flipped: Uint32Array.from(flipped), uvArea, surfaceArea };
}

/** Of values that are sorted here; 0 everywhere where there are none. */
export function quantilesOf(values: Float32Array): Quantiles {
  const sorted = values.slice().sort();
  const last = sorted.length - 1;
  const at = (part: number): number =>
    last < 0 ? 0 : sorted[Math.min(last, Math.floor(part * sorted.length))];
  return { min: at(0), p5: at(0.05), median: at(0.5), p95: at(0.95), p99: at(0.99), max: at(1) };
}

/** `uv`: two numbers per triangle corner, as they are stored. */
export function leastArea(uv: Float64Array): LeastArea {
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
