// A rounded cube as the views get it, and a map of it in six charts: each face is seen along its axis, turned and beside
// the others. Edges between faces are seams.

import { locatedSurface } from '../../../web/src/services/geometry/placed_surface.ts';
import { boxOf } from '../../../web/src/services/geometry/distortion.ts';
import { cubeMesh } from '../../support/meshes.mjs';
import { plainFacts } from './plain_facts.mjs';

export const mesh = cubeMesh(4);
const facts = plainFacts(mesh);

export function cubeSurface(id = 1) {
  const arrays = {
    positions: Float64Array.from(mesh.vertices.flat()),
    triangles: Uint32Array.from(mesh.triangles.flat()),
  };
  const surface = { id, ...locatedSurface(arrays, facts) };
  surface.places = surface.positions;
  surface.packedNormals = Int8Array.from({ length: 4 * surface.vertexCount }, (_, i) => (i % 4 === 3 ? 0 : Math.round(127 * surface.normals[3 * Math.floor(i / 4) + (i % 4)]))); // prettier-ignore
  Object.assign(surface, { creaseCorners: new Uint32Array(0), creaseNormals: new Int8Array(0) });
  return surface;
}

/** The face of a triangle of the cube, 0 to 5. */
export const faceOf = (t) => Math.floor((6 * t) / mesh.triangles.length);

/** Quarters of a turn by which the chart of a face is turned. */
const turnOf = (face) => (face * face) % 4;

function placeInChart(v, face) {
  const axis = face >> 1;
  const p = mesh.vertices[v];
  // Seen from outside: what is behind is mirrored.
  let [x, y] = [p[(axis + 1) % 3] * (face % 2 ? 1 : -1), p[(axis + 2) % 3]];
  for (let i = 0; i < turnOf(face); i++) [x, y] = [-y, x];
  return [x + 2.5 * face, y + 0.25 * face];
}

/** A solution for the cube, with what the views and the pointer read of it. */
export function cubeSolution(surface, more = {}) {
  const uv = [];
  const uvToVertex = [];
  const known = new Map();
  const endOf = (v, face) => {
    const key = `${v} ${face}`;
    if (!known.has(key)) {
      known.set(key, uvToVertex.length);
      uv.push(...placeInChart(v, face));
      uvToVertex.push(v);
    }
    return known.get(key);
  };
  const cornerToUv = Uint32Array.from(mesh.triangles.flatMap((t, i) => t.map((v) => endOf(v, faceOf(i))))); // prettier-ignore
  const firstOf = new Map();
  const [seams, chains, seamAt] = [[], [], new Map()];
  mesh.triangles.forEach((t, i) =>
    t.forEach((v, k) => {
      const w = t[(k + 1) % 3];
      const key = Math.min(v, w) * surface.vertexCount + Math.max(v, w);
      const first = firstOf.get(key);
      if (first === undefined) return firstOf.set(key, { face: faceOf(i), ends: [v, w] });
      if (first.face === faceOf(i)) return undefined;
      const side = (face) => first.ends.map((end) => endOf(end, face));
      seamAt.set(key, seams.length);
      chains.push(6 * first.face + faceOf(i));
      return seams.push({ a: side(first.face), b: side(faceOf(i)), r: (first.face + faceOf(i)) % 4 }); // prettier-ignore
    }),
  );
  const cornerUv = Float32Array.from([...cornerToUv].flatMap((i) => [uv[2 * i], uv[2 * i + 1]]));
  const result = {
    ...{ uv: Float64Array.from(uv), uvToVertex: Uint32Array.from(uvToVertex), cornerToUv },
    ...{ positions: surface.positions, triangles: surface.triangles },
    certificate: { integerSeams: 0, seamEdges: seams.length },
    ...{ report: { components: [{}] }, cones: { cones: [] } },
  };
  return {
    ...{ id: 7, surfaceId: surface.id, seams, seamAt, chains: Uint32Array.from(chains) },
    ...{ result, cornerUv, box: boxOf(uv), output: { scale: 'solved' } },
    distortion: { uvArea: 4, surfaceArea: 1, flipped: new Uint32Array(0) },
    ...{ sizes: { typicalScale: 1 }, map: {} },
    prescription: { q: 4, cones: [], turnings: [], handles: [] },
    ...more,
  };
}

/** A look with the pattern on, and colours. */
export const look = { pattern: 'checker', overlay: 'none', tiles: 24, steps: 1, seams: 'on', hasWire: false, light: 'studio' }; // prettier-ignore
