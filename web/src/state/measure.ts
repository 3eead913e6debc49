// Distortion of each triangle, and sizes.

import type { Result } from 'hgp';
import { inSteps, pause } from './breath';
import type { Corners } from './readback';

export interface Distortion {
  /** Ratio of singular values, 1 = angles kept; per triangle. */
  conformal: Float32Array;
  /** log₂ of area scaling relative to the whole; per triangle. */
  area: Float32Array;
  /** Its absolute value. */
  areaSize: Float32Array;
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
  // What panels and overlays will ask for, one sort a step.
  for (const values of [conformal, area, areaSize]) {
    await pause();
    quantile(values, 0.5);
  }
  return { conformal, area, areaSize, flipped, uvArea, surfaceArea };
}

const sortedOf = new WeakMap<Float32Array, Float32Array>();

/** Sorted once, however often it is asked about; the values do not change afterwards. */
export function quantile(values: Float32Array, part: number): number {
  if (values.length === 0) return 0;
  let sorted = sortedOf.get(values);
  if (!sorted) sortedOf.set(values, (sorted = values.slice().sort()));
  return sorted[Math.min(sorted.length - 1, Math.floor(part * sorted.length))];
}

/** As many tiles per unit of uv as the page shows of its patterns. */
export function tilesPerUnit(
  { surface, look }: { surface?: { diagonal: number }; look: { tiles: number } },
  { positions: p, triangles, uv, cornerToUv }: Result,
): number {
  let [onSurface, inMap] = [0, 0];
  for (let c = 0; c < triangles.length; c += 3) {
    const a = 3 * triangles[c];
    const [e, f] = [1, 2].map((k) => {
      const b = 3 * triangles[c + k];
      return [p[b] - p[a], p[b + 1] - p[a + 1], p[b + 2] - p[a + 2]];
    });
    const n = [e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]];
    onSurface += Math.sqrt(n[0] ** 2 + n[1] ** 2 + n[2] ** 2);
    const [i, j, k] = cornerToUv.subarray(c, c + 3);
    const across = (uv[2 * j] - uv[2 * i]) * (uv[2 * k + 1] - uv[2 * i + 1]);
    inMap += Math.abs(across - (uv[2 * j + 1] - uv[2 * i + 1]) * (uv[2 * k] - uv[2 * i]));
  }
  return look.tiles / (Math.sqrt(inMap / onSurface) * (surface?.diagonal ?? 1));
}

export interface LeastArea {
  /** In the map, of the triangle that has least of it; negative where it is folded over. */
  area: number;
  /** Of all triangles. */
  mean: number;
  triangle: number;
}

/** On the numbers as they were judged, not as they are drawn. */
export async function leastArea({
  uv,
  cornerToUv,
}: {
  uv: Float64Array;
  cornerToUv: Uint32Array;
}): Promise<LeastArea> {
  const count = cornerToUv.length / 3;
  let area = Infinity;
  let triangle = -1;
  let sum = 0;
  await inSteps(count, (t) => {
    const a = 2 * cornerToUv[3 * t];
    const b = 2 * cornerToUv[3 * t + 1];
    const c = 2 * cornerToUv[3 * t + 2];
    const across = (uv[b] - uv[a]) * (uv[c + 1] - uv[a + 1]);
    const signed = (across - (uv[b + 1] - uv[a + 1]) * (uv[c] - uv[a])) / 2;
    sum += signed;
    if (signed < area) [area, triangle] = [signed, t];
  });
  return { area, mean: sum / count, triangle };
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
    const u = uv[i];
    const v = uv[i + 1];
    if (u < x0) x0 = u;
    if (u > x1) x1 = u;
    if (v < y0) y0 = v;
    if (v > y1) y1 = v;
  }
  return { x: x0, y: y0, width: x1 - x0, height: y1 - y0 };
}
