// Crosses whose arms follow u and v: they look right even where lines shift across a seam.

import type { Sample } from './poisson_samples';

export interface CrossInput {
  positions: Float64Array;
  triangles: Uint32Array;
  cornerUv: Float32Array;
  samples: Sample[];
  /** Length of an arm, in uv. */
  arm: number;
  /** Longest arm on the surface. */
  spacing: number;
  q: number;
}

const above = 0.002; // height above the flat map

/** The two sides at the first corner of a triangle in uv, and their cross product. */
function sidesInUv(uv: Float32Array, t: number): [number, number, number, number, number] {
  const [ux, uy] = [uv[6 * t + 2] - uv[6 * t], uv[6 * t + 3] - uv[6 * t + 1]];
  const [vx, vy] = [uv[6 * t + 4] - uv[6 * t], uv[6 * t + 5] - uv[6 * t + 1]];
  return [ux, uy, vx, vy, ux * vy - uy * vx];
}

function* arms({ arm, q }: CrossInput): Generator<[number, number]> {
  for (let k = 0; k < q; k++) {
    const turn = (2 * Math.PI * k) / q;
    yield [arm * Math.cos(turn), arm * Math.sin(turn)];
  }
}

/** Crosses in the map: six numbers per arm. */
export function flatCrosses(input: CrossInput): Float32Array {
  const { samples, cornerUv: uv, q } = input;
  const out = new Float32Array(6 * q * samples.length);
  let at = 0;
  for (const { triangle: t, s, r } of samples) {
    const [ux, uy, vx, vy] = sidesInUv(uv, t);
    const [cx, cy] = [uv[6 * t] + s * ux + r * vx, uv[6 * t + 1] + s * uy + r * vy];
    for (const [x, y] of arms(input)) {
      out.set([cx, cy, above, cx + x, cy + y, above], at);
      at += 6;
    }
  }
  return out;
}

/** Crosses on the surface, each in the plane of its sample's triangle. */
export function surfaceCrosses(input: CrossInput): Float32Array {
  const { samples, cornerUv, positions: p, triangles, spacing, q } = input;
  const out = new Float32Array(6 * q * samples.length);
  let at = 0;
  for (const { triangle: t, s, r, e, f } of samples) {
    const [ux, uy, vx, vy, det] = sidesInUv(cornerUv, t);
    const a = 3 * triangles[3 * t];
    for (const [x, y] of arms(input)) {
      let [ds, dr] = [(x * vy - y * vx) / det, (ux * y - uy * x) / det];
      // Where the map is nearly degenerate, the arm would become so long that it hides the model.
      const far = Math.hypot(ds * e[0] + dr * f[0], ds * e[1] + dr * f[1], ds * e[2] + dr * f[2]);
      const part = Math.min(1, spacing / far);
      [ds, dr] = [part * ds, part * dr];
      for (let m = 0; m < 3; m++) {
        out[at + m] = p[a + m] + s * e[m] + r * f[m];
        out[at + 3 + m] = p[a + m] + (s + ds) * e[m] + (r + dr) * f[m];
      }
      at += 6;
    }
  }
  return out;
}
