// The model that turns on the empty page, with a map made by the solver itself while the page is built.

import { createCore } from '../build/package/node/core.js';
import { examples } from './examples.mjs';

function vertexNormals(positions, triangles) {
  const sums = new Float64Array(positions.length);
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [3 * triangles[t], 3 * triangles[t + 1], 3 * triangles[t + 2]];
    const side = (v) => [0, 1, 2].map((i) => positions[v + i] - positions[a + i]);
    const [e, f] = [side(b), side(c)];
    const n = [e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]];
    for (const v of [a, b, c]) for (let i = 0; i < 3; i++) sums[v + i] += n[i];
  }
  for (let v = 0; v < sums.length; v += 3) {
    const length = Math.hypot(sums[v], sums[v + 1], sums[v + 2]) || 1;
    for (let i = 0; i < 3; i++) sums[v + i] /= length;
  }
  return sums;
}

/** Counts, positions, normals, uv, triangles of a map: as views/turning_view.ts reads them. */
export function modelBytes({ positions, uv, cornerToUv, uvToVertex, triangles }) {
  const normals = vertexNormals(positions, triangles);
  const count = uvToVertex.length;
  const out = new ArrayBuffer(8 + 32 * count + 4 * cornerToUv.length);
  new Uint32Array(out, 0, 2).set([count, cornerToUv.length]);
  const at = (values, width, offset, from) => {
    const view = new Float32Array(out, offset, width * count);
    for (let i = 0; i < count; i++)
      for (let k = 0; k < width; k++) view[width * i + k] = values[width * from(i) + k];
  };
  at(positions, 3, 8, (i) => uvToVertex[i]);
  at(normals, 3, 8 + 12 * count, (i) => uvToVertex[i]);
  at(uv, 2, 8 + 24 * count, (i) => i);
  new Uint32Array(out, 8 + 32 * count).set(cornerToUv);
  return new Uint8Array(out);
}

/** The model of the empty page; uv in tiles. */
export async function heroModel() {
  const { bytes, file } = examples().find(({ id }) => id === 'figure');
  const core = await createCore();
  const model = core.load({ main: file, files: new Map([[file, new Uint8Array(bytes)]]) });
  const map = model.parametrize({
    q: 4,
    grid: { spacing: 0.14 }, // of the surface; one unit of uv is one tile
  });
  const { certified, integerSeams, seamEdges } = map.certificate;
  if (!certified || integerSeams !== seamEdges)
    throw new Error('the model of the empty page is not certified and aligned');
  return modelBytes(map);
}
