// Checks a written file: the sign of every triangle by exact arithmetic, and whether the two
// sides of every edge differ by a multiple of a quarter turn. Shares no code with the core.

import { readFileSync } from 'node:fs';
import { integerPoints, cross, minus, sign } from '../attack/exact.mjs';
import { readIndependently } from '../gltf/independent.mjs';

/** Tolerances relative to a seam edge's length. Float32 files have larger rounding errors. */
const tolerance = { float64: 1e-6, float32: 1e-2 };

/** v, vt and triangles of an OBJ; polygons become fans, which have the right signs if the polygons are convex. */
function readObj(text) {
  const positions = [];
  const uv = [];
  const triangles = [];
  const corners = [];
  let isOnlyTriangles = true;
  // A backslash at the end of a comment does not continue it.
  const statements = text.replace(/#[^\r\n]*/g, '').replace(/\\\r?\n/g, ' ');
  for (const line of statements.split('\n')) {
    const [key, ...rest] = line.trim().split(/\s+/);
    if (key === 'v') positions.push(rest.slice(0, 3).map(Number));
    else if (key === 'vt') uv.push(rest.slice(0, 2).map(Number));
    else if (key === 'f') {
      const list = rest.map((corner) => corner.split('/').map(Number));
      const at = (i, n) => (i < 0 ? n + i : i - 1);
      isOnlyTriangles &&= list.length === 3;
      for (let k = 1; k + 1 < list.length; k++) {
        const three = [list[0], list[k], list[k + 1]];
        triangles.push(three.map(([v]) => at(v, positions.length)));
        corners.push(three.map(([, vt]) => (vt ? at(vt, uv.length) : -1)));
      }
    }
  }
  return [{ positions, uv, triangles, corners, precision: 'float64', isOnlyTriangles }];
}

/** One map per mesh; vertices at equal positions are joined. */
async function readGltf(file) {
  const { document } = await readIndependently(file);
  return document
    .getRoot()
    .listMeshes()
    .map((mesh) => {
      const map = { positions: [], uv: [], triangles: [], corners: [], precision: 'float32' };
      const vertexAt = new Map();
      const listed = mesh
        .listPrimitives()
        .filter((p) => p.getMode() >= 4 && p.getAttribute('POSITION'));
      const setsOf = (p) => p.listSemantics().filter((s) => s.startsWith('TEXCOORD_'));
      const written = listed.map((p) => setsOf(p).length - 1);
      for (const [n, primitive] of listed.entries()) {
        const position = primitive.getAttribute('POSITION');
        const set = primitive.getAttribute(`TEXCOORD_${written[n]}`);
        if (!set) return { ...map, lacksUv: true };
        const vertices = [];
        for (let i = 0; i < position.getCount(); i++) {
          const key = position
            .getElement(i, [])
            .map((x) => x + 0)
            .join(' ');
          if (!vertexAt.has(key)) vertexAt.set(key, map.positions.push(key) - 1);
          vertices.push(vertexAt.get(key));
        }
        const first = map.uv.length;
        for (let i = 0; i < set.getCount(); i++) {
          const [u, v] = set.getElement(i, []);
          map.uv.push([u, -v]);
        }
        for (const t of trianglesOf(primitive, position.getCount())) {
          map.triangles.push(t.map((i) => vertices[i]));
          map.corners.push(t.map((i) => first + i));
        }
      }
      return map;
    });
}

function trianglesOf(primitive, count) {
  const indices =
    primitive.getIndices()?.getArray() ?? Uint32Array.from({ length: count }, (_, i) => i);
  const mode = primitive.getMode();
  const out = [];
  if (mode === 4) {
    for (let i = 0; i + 2 < indices.length; i += 3) out.push([...indices.subarray(i, i + 3)]);
    return out;
  }
  for (let i = 0; i + 2 < indices.length; i++) {
    const [a, b, c] = [indices[i], indices[i + 1], indices[i + 2]];
    const t = mode === 6 ? [b, c, indices[0]] : i % 2 === 0 ? [a, b, c] : [a, c, b];
    if (new Set(t).size === 3) out.push(t);
  }
  return out;
}

/** The sign of the area, computed exactly if doubles do not determine it. */
function orientation(a, b, c) {
  const left = (b[0] - a[0]) * (c[1] - a[1]);
  const right = (b[1] - a[1]) * (c[0] - a[0]);
  const size = Math.abs(left) + Math.abs(right);
  if (Math.abs(left - right) > 1e-14 * size && size > 1e-280) return Math.sign(left - right);
  const [p, q, r] = integerPoints([a, b, c]).points;
  return Number(sign(cross(minus(q, p), minus(r, p))));
}

/** The signs of all triangles, and the edge whose two sides deviate most from a rotation by a quarter turn. */
export function measure(map, q = 4) {
  const at = (t, k) => map.uv[map.corners[t][k]];
  let notPositive = 0;
  const sides = new Map();
  for (const [t, corners] of map.triangles.entries()) {
    if (map.corners[t].some((i) => i < 0)) return { notPositive: Infinity, worst: Infinity };
    const isReal = new Set(corners).size === 3;
    if (!isReal || orientation(at(t, 0), at(t, 1), at(t, 2)) <= 0) notPositive++;
    for (let k = 0; k < 3; k++) {
      const key = `${corners[k]} ${corners[(k + 1) % 3]}`;
      sides.set(key, sides.has(key) ? null : [t, k]);
    }
  }
  let worst = 0;
  let seams = 0;
  for (const [key, side] of sides) {
    const [a, b] = key.split(' ').map(Number);
    const other = sides.get(`${b} ${a}`);
    if (a > b || !side || !other) continue; // boundary, or an edge with more than two triangles
    const edge = ([t, k]) => {
      const [p, r] = [at(t, k), at(t, (k + 1) % 3)];
      return [r[0] - p[0], r[1] - p[1]];
    };
    const [d, back] = [edge(side), edge(other)];
    const e = [-back[0], -back[1]];
    let best = Infinity;
    for (let r = 0; r < q; r++) {
      const angle = (2 * Math.PI * r) / q;
      const [c, s] =
        q === 4
          ? [Math.round(Math.cos(angle)), Math.round(Math.sin(angle))]
          : [Math.cos(angle), Math.sin(angle)];
      best = Math.min(best, Math.hypot(e[0] - c * d[0] + s * d[1], e[1] - s * d[0] - c * d[1]));
    }
    if (best > 0) seams++;
    worst = Math.max(worst, best / Math.hypot(...d));
  }
  return { notPositive, worst, seams };
}

/** @param outside  number of stored triangles that the certificate does not cover */
export async function checkFile(file, kind, { outside }) {
  const maps = kind === 'gltf' ? await readGltf(file) : readObj(readFileSync(file, 'utf8'));
  let notPositive = 0;
  let worst = 0;
  for (const map of maps) {
    if (map.triangles.length === 0) continue;
    if (map.lacksUv) return { good: false, why: 'a mesh has no uv' };
    const one = measure(map);
    // The core may triangulate a polygon differently; the fan of a concave polygon proves nothing.
    if (map.isOnlyTriangles !== false) notPositive += one.notPositive;
    if (one.worst > tolerance[map.precision]) worst = Math.max(worst, one.worst);
  }
  const facts = { notPositive, outside, worst };
  if (notPositive > outside)
    return {
      good: false,
      why: `${notPositive} triangles are not positive, ${outside} are outside`,
      ...facts,
    };
  if (worst > 0 && outside === 0)
    return { good: false, why: `a seam is off by ${worst} of its edge`, ...facts };
  return { good: true, ...facts };
}
