// Distortion of each triangle, and sizes.

import { inSteps } from './breath';
import type { Corners } from './readback';

export interface Distortion {
  /** Ratio of singular values, 1 = angles kept; per triangle. */
  conformal: Float32Array;
  /** log₂ of area scaling relative to the whole; per triangle. */
  area: Float32Array;
  flipped: number[];
  uvArea: number;
  surfaceArea: number;
}

export async function measure({ positions: p, uv }: Corners): Promise<Distortion> {
  const count = uv.length / 6;
  const conformal = new Float32Array(count);
  const area = new Float32Array(count);
  const flipped: number[] = [];
  let uvArea = 0;
  let surfaceArea = 0;
  await inSteps(count, (t) => {
    const [a, b, c] = [9 * t, 9 * t + 3, 9 * t + 6];
    const e = [p[b] - p[a], p[b + 1] - p[a + 1], p[b + 2] - p[a + 2]];
    const f = [p[c] - p[a], p[c + 1] - p[a + 1], p[c + 2] - p[a + 2]];
    const length = Math.sqrt(e[0] ** 2 + e[1] ** 2 + e[2] ** 2);
    const x = (e[0] * f[0] + e[1] * f[1] + e[2] * f[2]) / length;
    const y = Math.sqrt(Math.max(0, f[0] ** 2 + f[1] ** 2 + f[2] ** 2 - x * x));
    const [ux, uy] = [uv[6 * t + 2] - uv[6 * t], uv[6 * t + 3] - uv[6 * t + 1]];
    const [vx, vy] = [uv[6 * t + 4] - uv[6 * t], uv[6 * t + 5] - uv[6 * t + 1]];
    // The derivative: columns d/dx and d/dy in the plane of the triangle.
    const [j00, j10] = [ux / length, uy / length];
    const [j01, j11] = [(vx - x * j00) / y, (vy - x * j10) / y];
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
  for (let t = 0; t < count; t++) area[t] -= mean;
  return { conformal, area, flipped, uvArea, surfaceArea };
}

export function quantile(values: Float32Array, part: number): number {
  if (values.length === 0) return 0;
  const sorted = Float32Array.from(values).sort();
  return sorted[Math.min(sorted.length - 1, Math.floor(part * sorted.length))];
}

export interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

export function boxOf(uv: ArrayLike<number>): Box {
  let [x0, y0, x1, y1] = [Infinity, Infinity, -Infinity, -Infinity];
  for (let i = 0; i < uv.length; i += 2) {
    x0 = Math.min(x0, uv[i]);
    x1 = Math.max(x1, uv[i]);
    y0 = Math.min(y0, uv[i + 1]);
    y1 = Math.max(y1, uv[i + 1]);
  }
  return { x: x0, y: y0, width: x1 - x0, height: y1 - y0 };
}
