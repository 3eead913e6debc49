// Reads texture coordinates back from the very bytes that Download saves. A reader of its own: what
// the preview shows is what is in the file.

import { inSteps, pause } from './breath';

export interface Corners {
  /** Per triangle corner, three numbers. */
  positions: Float32Array;
  /** Per triangle corner, two numbers, v pointing up. */
  uv: Float32Array;
}

export interface OutputFile {
  name: string;
  bytes: Uint8Array;
}

interface Accessor {
  bufferView?: number;
  byteOffset?: number;
  componentType: number;
  count: number;
  type: string;
}
interface Primitive {
  attributes: Record<string, number>;
  indices?: number;
  mode?: number;
}
interface Gltf {
  accessors: Accessor[];
  bufferViews: { buffer: number; byteOffset?: number; byteStride?: number }[];
  buffers: { uri?: string }[];
  meshes: { primitives: Primitive[] }[];
}

const widths: Record<string, number> = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };
const readers: Record<number, [number, (v: DataView, at: number) => number]> = {
  5120: [1, (v, at) => v.getInt8(at)],
  5121: [1, (v, at) => v.getUint8(at)],
  5122: [2, (v, at) => v.getInt16(at, true)],
  5123: [2, (v, at) => v.getUint16(at, true)],
  5125: [4, (v, at) => v.getUint32(at, true)],
  5126: [4, (v, at) => v.getFloat32(at, true)],
};

function openGltf(files: OutputFile[]): { json: Gltf; buffers: Uint8Array[] } {
  const [{ bytes, name }] = files;
  const text = (part: Uint8Array): string => new TextDecoder().decode(part);
  if (!name.toLowerCase().endsWith('.glb')) {
    const json = JSON.parse(text(bytes)) as Gltf;
    const buffers = json.buffers.map(({ uri = '' }) => {
      const file = files.find((one) => one.name === decodeURIComponent(uri));
      if (file) return file.bytes;
      const data = atob(uri.slice(uri.indexOf(',') + 1));
      return Uint8Array.from(data, (c) => c.charCodeAt(0));
    });
    return { json, buffers };
  }
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const length = view.getUint32(12, true);
  const json = JSON.parse(text(bytes.subarray(20, 20 + length))) as Gltf;
  return { json, buffers: [bytes.subarray(28 + length)] };
}

function readAccessor({ json, buffers }: ReturnType<typeof openGltf>, index: number): Float64Array {
  const { bufferView, byteOffset = 0, componentType, count, type } = json.accessors[index];
  const width = widths[type];
  const out = new Float64Array(count * width);
  if (bufferView === undefined) return out;
  const { buffer, byteOffset: start = 0, byteStride } = json.bufferViews[bufferView];
  const bytes = buffers[buffer];
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const [size, get] = readers[componentType];
  const stride = byteStride ?? size * width;
  for (let i = 0; i < count; i++) {
    for (let k = 0; k < width; k++) {
      out[i * width + k] = get(view, start + byteOffset + i * stride + k * size);
    }
  }
  return out;
}

/** Corners of one mesh; the uv set is the highest that all primitives have, which is the new one. */
async function readGltf(files: OutputFile[], mesh: number, uvSet?: number): Promise<Corners> {
  const file = openGltf(files);
  const positions: number[] = [];
  const uv: number[] = [];
  for (const { attributes, indices, mode = 4 } of file.json.meshes[mesh].primitives) {
    if (mode !== 4) continue;
    let set = uvSet ?? 0;
    if (uvSet === undefined) while (attributes[`TEXCOORD_${set + 1}`] !== undefined) set += 1;
    if (attributes[`TEXCOORD_${set}`] === undefined) continue;
    const p = readAccessor(file, attributes.POSITION);
    await pause();
    const t = readAccessor(file, attributes[`TEXCOORD_${set}`]);
    const corners = indices === undefined ? undefined : readAccessor(file, indices);
    await inSteps(corners?.length ?? p.length / 3, (c) => {
      const v = corners ? corners[c] : c;
      positions.push(p[3 * v], p[3 * v + 1], p[3 * v + 2]);
      uv.push(t[2 * v], 1 - t[2 * v + 1]);
    });
  }
  return { positions: new Float32Array(positions), uv: new Float32Array(uv) };
}

async function readObj(bytes: Uint8Array): Promise<Corners> {
  const text = new TextDecoder().decode(bytes);
  await pause();
  const joined = text.includes('\\') ? text.replace(/\\\r?\n/g, ' ') : text;
  const lines = joined.split('\n');
  await pause();
  const v: number[] = [];
  const vt: number[] = [];
  const positions: number[] = [];
  const uv: number[] = [];
  const at = (word: string | undefined, count: number): number => {
    const n = Number(word);
    return n < 0 ? count + n : n - 1;
  };
  const readFace = (words: string[]): void => {
    for (let k = 2; k < words.length; k++) {
      for (const word of [words[0], words[k - 1], words[k]]) {
        const parts = word.split('/');
        const p = 3 * at(parts[0], v.length / 3);
        const t = 2 * at(parts[1], vt.length / 2);
        positions.push(v[p], v[p + 1], v[p + 2]);
        uv.push(vt[t], vt[t + 1]);
      }
    }
  };
  await inSteps(lines.length, (i) => {
    const line = lines[i];
    if (!/^(v|vt|f)[ \t]/.test(line)) return;
    const [key, ...words] = line.trim().split(/[ \t]+/);
    if (key === 'v') v.push(+words[0], +words[1], +words[2]);
    else if (key === 'vt') vt.push(+words[0], +(words[1] ?? 0));
    else readFace(words);
  });
  return { positions: new Float32Array(positions), uv: new Float32Array(uv) };
}

export function readBack(files: OutputFile[], mesh: number, uvSet?: number): Promise<Corners> {
  const isObj = files[0].name.toLowerCase().endsWith('.obj');
  return isObj ? readObj(files[0].bytes) : readGltf(files, mesh, uvSet);
}
