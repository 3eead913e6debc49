// Which triangles of the map lie on top of others. Local injectivity allows that: neighbours never
// overlap, distant parts may.

import type { Overlaps } from '../../model/types';
import { boxOf } from './distortion';
import { forEachIndex } from './loops';

const mostPairs = 200_000;

/** Whether an edge of triangle s has all of triangle t on its outer side. */
function isSeparated(uv: Float32Array, s: number, t: number, slack: number): boolean {
  for (let k = 0; k < 3; k++) {
    const a = 6 * s + 2 * k;
    const b = 6 * s + 2 * ((k + 1) % 3);
    const c = 6 * s + 2 * ((k + 2) % 3);
    const x = uv[a];
    const y = uv[a + 1];
    const nx = y - uv[b + 1];
    const ny = uv[b] - x;
    const inner = nx * (uv[c] - x) + ny * (uv[c + 1] - y) < 0 ? -1 : 1;
    const limit = slack * Math.sqrt(nx * nx + ny * ny);
    let outside = 0;
    for (let o = 6 * t; o < 6 * t + 6; o += 2) {
      if (inner * (nx * (uv[o] - x) + ny * (uv[o + 1] - y)) <= limit) outside += 1;
    }
    if (outside === 3) return true;
  }
  return false;
}

/** Two triangles share area where no edge of either separates them. */
const sharesArea = (uv: Float32Array, s: number, t: number, slack: number): boolean =>
  !isSeparated(uv, s, t, slack) && !isSeparated(uv, t, s, slack);

export function findOverlaps(uv: Float32Array, cornerToUv: Uint32Array): Overlaps {
  const count = uv.length / 6;
  const { x, y, width, height } = boxOf(uv);
  const size = Math.max(width, height) || 1;
  const side = Math.max(1, Math.min(1024, Math.floor(Math.sqrt(count))));
  const step = size / side;
  const slack = 1e-6 * size; // seams of float32 touch with the last bits of their numbers
  const cells = new Map<number, number[]>();
  const first = new Int32Array(2 * count); // cell of each triangle's lowest column and row
  const last = new Int32Array(2 * count);
  forEachIndex(count, (t) => {
    for (let axis = 0; axis < 2; axis++) {
      const from = axis === 0 ? x : y;
      const a = uv[6 * t + axis];
      const b = uv[6 * t + 2 + axis];
      const c = uv[6 * t + 4 + axis];
      first[2 * t + axis] = Math.floor((Math.min(a, b, c) - from) / step);
      last[2 * t + axis] = Math.floor((Math.max(a, b, c) - from) / step);
    }
  });
  const isIn = new Uint8Array(count);
  let pairs = 0;
  forEachIndex(count, (t) => {
    if (pairs >= mostPairs) return;
    for (let j = first[2 * t + 1]; j <= last[2 * t + 1]; j++) {
      for (let i = first[2 * t]; i <= last[2 * t]; i++) {
        const key = j * (side + 2) + i;
        const known = cells.get(key);
        if (!known) {
          cells.set(key, [t]);
          continue;
        }
        for (const s of known) {
          // Each pair once: in the first cell that both are in.
          if (Math.max(first[2 * s], first[2 * t]) !== i) continue;
          if (Math.max(first[2 * s + 1], first[2 * t + 1]) !== j) continue;
          if (touches(cornerToUv, s, t) || !sharesArea(uv, s, t, slack)) continue;
          pairs += 1;
          isIn[s] = isIn[t] = 1;
        }
        known.push(t);
      }
    }
  });
  const triangles: number[] = [];
  isIn.forEach((is, t) => is && triangles.push(t));
  return { pairs, triangles: Uint32Array.from(triangles), isMore: pairs >= mostPairs };
}

function touches(cornerToUv: Uint32Array, s: number, t: number): boolean {
  for (let i = 3 * s; i < 3 * s + 3; i++) {
    for (let j = 3 * t; j < 3 * t + 3; j++) if (cornerToUv[i] === cornerToUv[j]) return true;
  }
  return false;
}
