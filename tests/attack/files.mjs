// OBJ and GLB of a map, written and read back by code of their own.

import { packGlb, openFile } from '../gltf/container.mjs';

export function writeObj(map) {
  const lines = [];
  for (const p of map.positions) lines.push(`v ${p.join(' ')}`);
  for (const p of map.uv) lines.push(`vt ${p.join(' ')}`);
  for (const [t, corners] of map.triangles.entries())
    lines.push(`f ${corners.map((v, k) => `${v + 1}/${map.corners[t][k] + 1}`).join(' ')}`);
  return `${lines.join('\n')}\n`;
}

export function readObj(text) {
  const map = { positions: [], triangles: [], uv: [], corners: [], precision: 'float64' };
  for (const line of text.split('\n')) {
    const [key, ...rest] = line.trim().split(/\s+/);
    if (key === 'v') map.positions.push(rest.slice(0, 3).map(Number));
    if (key === 'vt') map.uv.push(rest.slice(0, 2).map(Number));
    if (key !== 'f') continue;
    const corners = rest.map((corner) => corner.split('/').map((n) => Number(n) - 1));
    map.triangles.push(corners.map(([v]) => v));
    map.corners.push(corners.map(([, vt]) => vt));
  }
  return map;
}

/** A GLB vertex for every pair of vertex and uv. */
export function writeGlb(map) {
  const numbers = new Map();
  const indices = [];
  for (const [t, corners] of map.triangles.entries())
    for (let k = 0; k < 3; k++) {
      const key = `${corners[k]} ${map.corners[t][k]}`;
      if (!numbers.has(key)) numbers.set(key, [numbers.size, corners[k], map.corners[t][k]]);
      indices.push(numbers.get(key)[0]);
    }
  const count = numbers.size;
  const bin = new Uint8Array(20 * count + 4 * indices.length);
  const positions = new Float32Array(bin.buffer, 0, 3 * count);
  const uvs = new Float32Array(bin.buffer, 12 * count, 2 * count);
  new Uint32Array(bin.buffer, 20 * count).set(indices);
  for (const [n, vertex, uv] of numbers.values()) {
    positions.set(map.positions[vertex], 3 * n);
    const [u, v] = map.uv[uv];
    uvs.set([u, map.vIs === '-v' ? -v : 1 - v], 2 * n);
  }
  const bounds = (pick) => [0, 1, 2].map((n) => pick(positions.filter((_, i) => i % 3 === n)));
  const least = (list) => list.reduce((a, b) => Math.min(a, b));
  const most = (list) => list.reduce((a, b) => Math.max(a, b));
  const view = (byteOffset, byteLength) => ({ buffer: 0, byteOffset, byteLength });
  const json = {
    asset: { version: '2.0' },
    scenes: [{ nodes: [0] }],
    scene: 0,
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0, TEXCOORD_0: 1 }, indices: 2 }] }],
    accessors: [
      {
        ...{ bufferView: 0, componentType: 5126, count, type: 'VEC3' },
        ...{ min: bounds(least), max: bounds(most) },
      },
      { bufferView: 1, componentType: 5126, count, type: 'VEC2' },
      { bufferView: 2, componentType: 5125, count: indices.length, type: 'SCALAR' },
    ],
    bufferViews: [
      view(0, 12 * count),
      view(12 * count, 8 * count),
      view(20 * count, 4 * indices.length),
    ],
    buffers: [{ byteLength: bin.length }],
  };
  return packGlb(json, bin);
}

/** As much of glTF as `writeGlb` and hgp use: float32 attributes, one mesh. Equal positions are one vertex. */
export function readGlb(bytes) {
  const { text, bin } = openFile(bytes);
  const json = JSON.parse(text);
  const copy = new Uint8Array(bin); // with a buffer of its own
  const array = (index) => {
    const { bufferView, byteOffset = 0, count, componentType, type } = json.accessors[index];
    const view = json.bufferViews[bufferView];
    const width = { SCALAR: 1, VEC2: 2, VEC3: 3 }[type];
    const Type = { 5126: Float32Array, 5125: Uint32Array, 5123: Uint16Array }[componentType];
    const begin = (view.byteOffset ?? 0) + byteOffset;
    const stride = view.byteStride ?? width * Type.BYTES_PER_ELEMENT;
    const list = [];
    for (let i = 0; i < count; i++) {
      const at = begin + i * stride;
      list.push([...new Type(copy.buffer.slice(at, at + width * Type.BYTES_PER_ELEMENT))]);
    }
    return list;
  };
  const [primitive] = json.meshes[0].primitives;
  const sets = Object.keys(primitive.attributes).filter((name) => name.startsWith('TEXCOORD_'));
  const stored = array(primitive.attributes.POSITION);
  const map = { positions: [], triangles: [], uv: [], corners: [], precision: 'float32' };
  // v with the picture's top at 0, up to the integer 1: sides and areas are the same.
  map.uv = array(primitive.attributes[sets.sort().at(-1)]).map(([u, v]) => [u, -v]);
  const vertexAt = new Map();
  const welded = stored.map((p) => {
    const key = p.map((x) => x + 0).join(' ');
    if (!vertexAt.has(key)) vertexAt.set(key, map.positions.push(p) - 1);
    return vertexAt.get(key);
  });
  const indices = array(primitive.indices).flat();
  for (let i = 0; i < indices.length; i += 3) {
    const corners = indices.slice(i, i + 3);
    map.triangles.push(corners.map((n) => welded[n]));
    map.corners.push(corners);
  }
  return map;
}
