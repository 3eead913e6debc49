// Frames of a drag, checked from their arrays alone: every triangle positive, every seam a rotation, every angle that
// of the prescription. No code is shared with the solver.

import assert from 'node:assert/strict';
import { measure } from './check_file.mjs';

/** The sum of the angles in the map at every vertex, in turns. */
function turnsAt(triangles, uv, cornerToUv) {
  const turns = new Map();
  for (let corner = 0; corner < triangles.length; corner++) {
    const first = corner - (corner % 3);
    const at = (k) => cornerToUv[first + ((corner - first + k) % 3)];
    const edge = (k) => [0, 1].map((i) => uv[2 * at(k) + i] - uv[2 * at(0) + i]);
    const [[a, b], [c, d]] = [edge(1), edge(2)];
    const angle = Math.atan2(a * d - b * c, a * c + b * d);
    const vertex = triangles[corner];
    turns.set(vertex, (turns.get(vertex) ?? 0) + angle / (2 * Math.PI));
  }
  return turns;
}

function boundaryOf(triangles) {
  const sides = new Set();
  for (let corner = 0; corner < triangles.length; corner++) {
    const next = corner % 3 === 2 ? corner - 2 : corner + 1;
    sides.add(`${triangles[corner]} ${triangles[next]}`);
  }
  const on = new Set();
  for (const side of sides) {
    const [v, w] = side.split(' ');
    if (!sides.has(`${w} ${v}`)) on.add(Number(v)).add(Number(w));
  }
  return on;
}

/** Why a frame, or a result, is not a map with its cones; empty if it is one. */
export function faultOf(triangles, { uv, cornerToUv, cones }) {
  const { q } = cones;
  const threes = (list) =>
    Array.from({ length: list.length / 3 }, (_, t) => [...list.subarray(3 * t, 3 * t + 3)]);
  const points = Array.from({ length: uv.length / 2 }, (_, i) => [uv[2 * i], uv[2 * i + 1]]);
  const map = { triangles: threes(triangles), corners: threes(cornerToUv), uv: points };
  const { notPositive, worst } = measure(map, q);
  if (notPositive > 0) return `${notPositive} triangles are not positive`;
  if (worst > 1e-6) return `a seam is off by ${worst} of its edge`;
  const k = new Map(cones.cones.map((cone) => [cone.vertex, cone.k]));
  const boundary = boundaryOf(triangles);
  for (const [vertex, turns] of turnsAt(triangles, uv, cornerToUv)) {
    const wanted = (k.get(vertex) ?? q) / q;
    if (!boundary.has(vertex) && Math.abs(turns - wanted) > 1e-6)
      return `${turns} turns at vertex ${vertex}, not ${wanted}`;
  }
  return '';
}

/** A walk over n edges from a vertex, as straight as the mesh allows, on vertices where `isFree`. */
export function walk({ positions }, { neighbours, neighbourStart, isBoundary }, from, n, isFree) {
  const at = (v) => [0, 1, 2].map((i) => positions[3 * v + i]);
  const minus = (a, b) => a.map((x, i) => x - b[i]);
  const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
  const path = [];
  let [v, direction] = [from, undefined];
  while (path.length < n) {
    const around = [...neighbours.subarray(neighbourStart[v], neighbourStart[v + 1])].filter(
      (w) => !isBoundary[w] && isFree(w) && !path.includes(w) && w !== from,
    );
    if (around.length === 0) break;
    const cosine = (w) => {
      const d = minus(at(w), at(v));
      return direction ? dot(d, direction) / Math.hypot(...d) : 0;
    };
    const next = around.reduce((best, w) => (cosine(w) > cosine(best) ? w : best));
    direction = minus(at(next), at(v));
    path.push((v = next));
  }
  return path;
}

export function assertCertified(triangles, frame) {
  assert.equal(frame.state ?? 'certified', 'certified', (frame.reasons ?? []).join('; '));
  assert.equal(faultOf(triangles, frame), '');
}
