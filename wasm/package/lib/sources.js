// Converts files, blobs, buffers and arrays to the solver's input.

import { describe } from './options.js';
import { usage } from './error.js';

/** Bytes of a File, Blob, ArrayBuffer or view of one. A Node Buffer is a view. */
async function bytesOf(source) {
  if (source instanceof Uint8Array) return source;
  if (ArrayBuffer.isView(source)) {
    return new Uint8Array(source.buffer, source.byteOffset, source.byteLength);
  }
  if (source instanceof ArrayBuffer) return new Uint8Array(source);
  if (typeof source?.arrayBuffer === 'function') return new Uint8Array(await source.arrayBuffer());
  throw usage(
    `load: a file is a File, Blob, ArrayBuffer, typed array or { main, files }, not ${describe(source)}`,
  );
}

/**
 * File, Blob, bytes or FileSet → { main, files: Map<name, bytes, or the result of `pack` for bytes or a Blob> }.
 * @param {object} source
 * @param {string | undefined} name
 * @param {(source: Uint8Array | Blob) => Promise<Uint8Array | Blob>} [pack]
 */
export async function toFileSet(source, name, pack) {
  const take = async (value) => {
    if (!pack) return bytesOf(value);
    return pack(value instanceof Blob ? value : await bytesOf(value));
  };
  if (source === null || typeof source !== 'object' || source.files === undefined) {
    const bytes = await take(source);
    const main = name ?? source.name ?? '';
    return { main, files: new Map([[main, bytes]]) };
  }
  const given = source.files instanceof Map ? source.files : new Map(Object.entries(source.files));
  if (!given.has(source.main)) {
    throw usage(`load: files has no '${source.main}', which main names`);
  }
  const files = new Map();
  for (const [key, value] of given) files.set(key, await take(value));
  return { main: source.main, files };
}

/** In the worker: converts the results of `pack` back to bytes. */
export async function unpacked({ main, files }) {
  const plain = new Map();
  for (const [name, value] of files) plain.set(name, await bytesOf(value));
  return { main, files: plain };
}

const isNumbers = (value) =>
  (Array.isArray(value) && value.every((x) => typeof x === 'number')) ||
  (ArrayBuffer.isView(value) &&
    !(value instanceof DataView) &&
    !(value instanceof BigInt64Array) &&
    !(value instanceof BigUint64Array));

/**
 * Checks the arrays of a mesh, and adds indices if it has none.
 * @param {import('../core.js').MeshArrays} mesh  positions: 3 per vertex; triangles: 3 vertices per
 *   triangle; if absent, every three consecutive vertices are a triangle
 */
export function toMeshArrays({ positions, triangles }) {
  if (!isNumbers(positions)) {
    throw usage(
      `parametrizeMesh: positions are numbers, three per vertex, not ${describe(positions)}`,
    );
  }
  if (positions.length === 0 || positions.length % 3 !== 0) {
    throw usage(
      `parametrizeMesh: positions are three numbers per vertex; there are ${positions.length}`,
    );
  }
  const vertexCount = positions.length / 3;
  if (triangles === undefined || triangles === null) {
    if (vertexCount % 3 !== 0) {
      throw usage(
        `parametrizeMesh: without triangles every three vertices are one; there are ${vertexCount}`,
      );
    }
    triangles = Uint32Array.from({ length: vertexCount }, (_, i) => i);
  }
  if (!isNumbers(triangles)) {
    throw usage(
      `parametrizeMesh: triangles are numbers, three per triangle, not ${describe(triangles)}`,
    );
  }
  if (triangles.length === 0 || triangles.length % 3 !== 0) {
    throw usage(
      `parametrizeMesh: triangles are three vertices each; there are ${triangles.length} indices`,
    );
  }
  for (let i = 0; i < triangles.length; i++) {
    const v = triangles[i];
    if (!(Number.isInteger(v) && v >= 0 && v < vertexCount)) {
      throw usage(
        `parametrizeMesh: triangle ${Math.floor(i / 3)} has the vertex ${v}; there are ${vertexCount}`,
      );
    }
  }
  return { positions, triangles };
}
