// Reads texture coordinates back from exactly the bytes that Download saves. This reader shares no code
// with the writer, so the preview shows what the file contains.

import type { Corners, OutputFile } from '../model/types';
import { isGltf, parseGltf, relativeName, splitGlb, surfaceMeshes, type Json } from './glb';
import { readPly } from './read_ply';

interface Place {
  bufferView?: number;
  byteOffset?: number;
  componentType: number;
}
interface Accessor extends Place {
  count: number;
  type: string;
  normalized?: boolean;
  sparse?: { count: number; indices: Place; values: Place };
}
interface Primitive {
  attributes: Record<string, number>;
  indices?: number;
  mode?: number;
}
interface Meshopt {
  buffer: number;
  byteOffset?: number;
  byteLength: number;
  byteStride: number;
  count: number;
  mode: string;
  filter?: string;
}
interface BufferView {
  buffer: number;
  byteOffset?: number;
  byteStride?: number;
  extensions?: Record<string, unknown>;
}
interface Gltf {
  accessors: Accessor[];
  bufferViews: BufferView[];
  buffers: { uri?: string }[];
  meshes: { primitives: Primitive[] }[];
}

/** The decoder for parts of a file that stay compressed; it must be ready. */
export interface MeshoptDecoder {
  decodeGltfBuffer(
    target: Uint8Array,
    count: number,
    size: number,
    source: Uint8Array,
    mode: string,
    filter?: string,
  ): void;
}
const meshoptNames = ['EXT_meshopt_compression', 'KHR_meshopt_compression'];

const widths: Record<string, number> = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };
/** By component type: size, maximum if normalized, reader. */
const readers: Record<number, [number, number, (v: DataView, at: number) => number]> = {
  5120: [1, 127, (v, at) => v.getInt8(at)],
  5121: [1, 255, (v, at) => v.getUint8(at)],
  5122: [2, 32767, (v, at) => v.getInt16(at, true)],
  5123: [2, 65535, (v, at) => v.getUint16(at, true)],
  5125: [4, 1, (v, at) => v.getUint32(at, true)],
  5126: [4, 1, (v, at) => v.getFloat32(at, true)],
};

interface OpenGltf {
  json: Gltf;
  buffers: Uint8Array[];
  decoder?: MeshoptDecoder;
}

/** Opens files that hgp has written, whose structure is known; throws for anything else. */
function openGltf(files: OutputFile[], decoder: MeshoptDecoder | undefined): OpenGltf {
  const [main] = files;
  const json = parseGltf(main) as unknown as Gltf;
  const own = /\.glb$/i.test(main.name) ? splitGlb(main.bytes)!.bin : new Uint8Array(0);
  const buffers = json.buffers.map(({ uri }) => {
    if (uri === undefined) return own;
    const file = files.find((one) => one.name === relativeName(uri));
    if (file) return file.bytes;
    const data = atob(uri.slice(uri.indexOf(',') + 1));
    return Uint8Array.from(data, (c) => c.charCodeAt(0));
  });
  return { json, buffers, decoder };
}

const meshoptOf = ({ extensions = {} }: BufferView): Meshopt | undefined =>
  meshoptNames.map((name) => extensions[name] as Meshopt | undefined).find(Boolean);

export const isMeshoptUsed = (main: OutputFile): boolean => {
  if (!isGltf(main.name)) return false;
  const { extensionsUsed } = parseGltf(main);
  return Array.isArray(extensionsUsed) && meshoptNames.some((one) => extensionsUsed.includes(one));
};

/** The bytes of a buffer view, and its stride if it has one. */
function viewOf({ json, buffers, decoder }: OpenGltf, index: number): [DataView, number?] {
  const view = json.bufferViews[index];
  const packed = meshoptOf(view);
  if (packed) {
    const { buffer, byteOffset = 0, byteLength, byteStride, count, mode, filter } = packed;
    const source = buffers[buffer].subarray(byteOffset, byteOffset + byteLength);
    const target = new Uint8Array(count * byteStride);
    if (!decoder) throw new Error('it is compressed');
    decoder.decodeGltfBuffer(target, count, byteStride, source, mode, filter);
    return [new DataView(target.buffer), view.byteStride ?? byteStride];
  }
  const bytes = buffers[view.buffer];
  const start = bytes.byteOffset + (view.byteOffset ?? 0);
  return [new DataView(bytes.buffer, start), view.byteStride];
}

/** Reads consecutive items from one place. */
function readItems(
  file: OpenGltf,
  { bufferView, byteOffset = 0, componentType }: Place,
  count: number,
  width: number,
): Float64Array {
  const out = new Float64Array(count * width);
  if (bufferView === undefined) return out;
  const [view, byteStride] = viewOf(file, bufferView);
  const [size, , get] = readers[componentType];
  const stride = byteStride ?? size * width;
  for (let i = 0; i < count; i++) {
    for (let k = 0; k < width; k++)
      out[i * width + k] = get(view, byteOffset + i * stride + k * size);
  }
  return out;
}

function readAccessor(file: OpenGltf, index: number): Float64Array {
  const accessor = file.json.accessors[index];
  const { count, type, sparse, normalized, componentType } = accessor;
  const width = widths[type];
  const out = readItems(file, accessor, count, width);
  if (sparse) {
    const at = readItems(file, sparse.indices, sparse.count, 1);
    const values = readItems(file, { ...sparse.values, componentType }, sparse.count, width);
    at.forEach((item, i) => out.set(values.subarray(width * i, width * (i + 1)), width * item));
  }
  const max = readers[componentType][1];
  return normalized ? out.map((x) => Math.max(x / max, -1)) : out;
}

/**
 * Corners of the triangles of a primitive in any mode, in the order of the specification. Degenerate triangles
 * of strips and fans are left out; points and lines have no triangles.
 */
function cornerIndices(list: Float64Array, mode: number): number[] {
  const out: number[] = [];
  for (let i = 2; i < list.length; i++) {
    const [a, b, c] = [list[i - 2], list[i - 1], list[i]];
    const first = mode === 5 ? a : list[0];
    if (first === b || b === c || c === first) continue;
    if (mode === 5) out.push(a, ...(i % 2 ? [c, b] : [b, c]));
    if (mode === 6) out.push(b, c, first);
  }
  return out;
}

/** Corners of one of the meshes with triangles. The highest uv set of a primitive is the new one. */
function readGltf(
  files: OutputFile[],
  mesh: number,
  uvSet: number | undefined,
  decoder: MeshoptDecoder | undefined,
): Corners {
  const file = openGltf(files, decoder);
  const positions: number[] = [];
  const uv: number[] = [];
  const own = surfaceMeshes(file.json as unknown as Json)[mesh];
  for (const { attributes, indices, mode = 4 } of file.json.meshes[own].primitives) {
    if (attributes.POSITION === undefined) continue;
    let set = uvSet ?? 0;
    if (uvSet === undefined) while (attributes[`TEXCOORD_${set + 1}`] !== undefined) set += 1;
    if (attributes[`TEXCOORD_${set}`] === undefined) continue;
    const p = readAccessor(file, attributes.POSITION);
    const t = readAccessor(file, attributes[`TEXCOORD_${set}`]);
    const all = Float64Array.from({ length: p.length / 3 }, (_, i) => i);
    const list = indices === undefined ? all : readAccessor(file, indices);
    for (const v of mode === 4 ? list : cornerIndices(list, mode)) {
      positions.push(p[3 * v], p[3 * v + 1], p[3 * v + 2]);
      uv.push(t[2 * v], 1 - t[2 * v + 1]);
    }
  }
  return { positions: new Float64Array(positions), uv: new Float64Array(uv) };
}

function readObj(bytes: Uint8Array): Corners {
  const text = new TextDecoder().decode(bytes);
  const lineEnd = text.includes('\n') ? '\n' : '\r';
  // A backslash at the end of a comment does not continue it.
  const joined = text.includes('\\')
    ? text.replace(/#[^\r\n]*/g, '').replace(/\\(\r?\n|\r)/g, ' ')
    : text;
  const v: number[] = [];
  const vt: number[] = [];
  const corners: [v: number, vt: number][] = []; // resolved later, since faces may precede their vertices
  const at = (word: string | undefined, count: number): number => {
    const n = Number(word);
    return n < 0 ? count + n : n - 1;
  };
  const sizes: number[] = [];
  const readFace = (words: string[]): void => {
    if (words.length < 3) return;
    sizes.push(words.length);
    for (const word of words) {
      const parts = word.split('/');
      corners.push([at(parts[0], v.length / 3), at(parts[1], vt.length / 2)]);
    }
  };
  for (const line of joined.split(lineEnd)) {
    if (!/^\s*(v|vt|fo?)\s/.test(line)) continue;
    const comment = line.indexOf('#');
    const statement = comment < 0 ? line : line.slice(0, comment);
    const [key, ...words] = statement.trim().split(/\s+/);
    if (key === 'v') v.push(+words[0], +words[1], +words[2]);
    else if (key === 'vt') vt.push(+words[0], +(words[1] ?? 0));
    else readFace(words);
  }
  const all = {
    positions: new Float64Array(3 * corners.length),
    uv: new Float64Array(2 * corners.length),
  };
  corners.forEach(([p, t], i) => {
    for (let k = 0; k < 3; k++) all.positions[3 * i + k] = v[3 * p + k];
    for (let k = 0; k < 2; k++) all.uv[2 * i + k] = vt[2 * t + k];
  });
  return sizes.some((n) => n > 3) ? { ...all, sizes } : all;
}

export const readUv = (
  files: OutputFile[],
  mesh: number,
  uvSet?: number,
  decoder?: MeshoptDecoder,
): Corners => {
  const [{ name, bytes }] = files;
  if (isGltf(name)) return readGltf(files, mesh, uvSet, decoder);
  return /\.ply$/i.test(name) ? readPly(bytes) : readObj(bytes);
};
