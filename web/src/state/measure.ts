// Distortion of each triangle and how much of the map lies on top of itself.

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

export function measure({ positions: p, uv }: Corners): Distortion {
  const count = uv.length / 6;
  const conformal = new Float32Array(count);
  const area = new Float32Array(count);
  const flipped: number[] = [];
  let uvArea = 0;
  let surfaceArea = 0;
  for (let t = 0; t < count; t++) {
    const [a, b, c] = [9 * t, 9 * t + 3, 9 * t + 6];
    const e = [p[b] - p[a], p[b + 1] - p[a + 1], p[b + 2] - p[a + 2]];
    const f = [p[c] - p[a], p[c + 1] - p[a + 1], p[c + 2] - p[a + 2]];
    const length = Math.hypot(e[0], e[1], e[2]);
    const x = (e[0] * f[0] + e[1] * f[1] + e[2] * f[2]) / length;
    const y = Math.sqrt(Math.max(0, f[0] ** 2 + f[1] ** 2 + f[2] ** 2 - x * x));
    const [ux, uy] = [uv[6 * t + 2] - uv[6 * t], uv[6 * t + 3] - uv[6 * t + 1]];
    const [vx, vy] = [uv[6 * t + 4] - uv[6 * t], uv[6 * t + 5] - uv[6 * t + 1]];
    // The derivative: columns d/dx and d/dy in the plane of the triangle.
    const [j00, j10] = [ux / length, uy / length];
    const [j01, j11] = [(vx - x * j00) / y, (vy - x * j10) / y];
    const similar = Math.hypot(j00 + j11, j10 - j01) / 2;
    const anti = Math.hypot(j00 - j11, j10 + j01) / 2;
    const signed = (ux * vy - uy * vx) / 2;
    conformal[t] = (similar + anti) / Math.max(Math.abs(similar - anti), 1e-12);
    area[t] = Math.log2(Math.max(Math.abs(signed), 1e-30) / Math.max((length * y) / 2, 1e-30));
    if (!(signed > 0)) flipped.push(t);
    uvArea += Math.abs(signed);
    surfaceArea += (length * y) / 2;
  }
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

/** Samples the map on a grid and counts places that more than one triangle covers. */
export function overlapShare(uv: Float32Array, size = 384): number {
  const { x, y, width, height } = boxOf(uv);
  const step = Math.max(width, height) / size || 1;
  const counts = new Uint8Array((size + 1) * (size + 1));
  for (let t = 0; t < uv.length; t += 6) {
    const q = [0, 1, 2].map((k) => [(uv[t + 2 * k] - x) / step, (uv[t + 2 * k + 1] - y) / step]);
    const rows = [Math.min(q[0][1], q[1][1], q[2][1]), Math.max(q[0][1], q[1][1], q[2][1])];
    for (let j = Math.ceil(rows[0] - 0.5); j + 0.5 < rows[1]; j++) {
      // Where the row through the centres crosses the triangle.
      let [from, to] = [Infinity, -Infinity];
      for (let k = 0; k < 3; k++) {
        const [[ax, ay], [bx, by]] = [q[k], q[(k + 1) % 3]];
        if (ay > j + 0.5 === by > j + 0.5) continue;
        const at = ax + ((j + 0.5 - ay) / (by - ay)) * (bx - ax);
        from = Math.min(from, at);
        to = Math.max(to, at);
      }
      for (let i = Math.ceil(from - 0.5); i + 0.5 < to; i++) {
        const cell = j * (size + 1) + i;
        if (counts[cell] < 255) counts[cell] += 1;
      }
    }
  }
  let covered = 0;
  let twice = 0;
  for (const count of counts) {
    if (count > 0) covered += 1;
    if (count > 1) twice += 1;
  }
  return covered === 0 ? 0 : twice / covered;
}
