// The two forms of glTF: the chunks of a GLB and the JSON document, parsed once per file. The JSON may have
// any content, so every reader here treats it as `unknown`.

import type { Files, OutputFile } from '../model/types';

const magic = new TextEncoder().encode('glTF');
const isGlb = (bytes: Uint8Array): boolean => magic.every((code, i) => bytes[i] === code);

export interface GlbChunks {
  json: Uint8Array;
  bin: Uint8Array;
  /** Other chunks, with their headers. */
  rest: Uint8Array;
}

/** Undefined if the bytes are not a GLB with a complete JSON chunk. */
export function splitGlb(bytes: Uint8Array): GlbChunks | undefined {
  if (bytes.length < 20 || !isGlb(bytes)) return undefined;
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const binAt = 20 + view.getUint32(12, true);
  if (binAt > bytes.length) return undefined;
  const json = bytes.subarray(20, binAt);
  if (binAt + 8 > bytes.length) return { json, bin: new Uint8Array(0), rest: new Uint8Array(0) };
  const end = binAt + 8 + view.getUint32(binAt, true);
  return { json, bin: bytes.subarray(binAt + 8, end), rest: bytes.subarray(end) };
}

/** Of a file that was written, whose name always tells. */
export const isGltf = (name: string): boolean => /\.(glb|gltf)$/i.test(name);

/** Of a file that was opened, whose name may be wrong: what the solver found in it. */
export const isGltfModel = ({ info }: { info: { file: { format: string } } }): boolean =>
  /^(glb|gltf)$/.test(info.file.format);

export async function bytesOf(file: Blob | Uint8Array): Promise<Uint8Array> {
  return file instanceof Uint8Array ? file : new Uint8Array(await file.arrayBuffer());
}

export type Json = Readonly<Record<string, unknown>>;

export const isObject = (value: unknown): value is Json =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

/** The items of a list; items that are not objects become empty objects, so that indices stay valid. */
export const objectsIn = (value: unknown): Json[] =>
  Array.isArray(value) ? value.map((one) => (isObject(one) ? one : {})) : [];

/** The document of a .glb or .gltf; empty if it is invalid, since the solver reports why. */
export function parseGltf({ bytes }: Pick<OutputFile, 'bytes'>): Json {
  try {
    const text = isGlb(bytes) ? (splitGlb(bytes)?.json ?? new Uint8Array(0)) : bytes;
    const json: unknown = JSON.parse(new TextDecoder().decode(text));
    return isObject(json) ? json : {};
  } catch {
    return {};
  }
}

/** The meshes that the solver treats as surfaces, in its order: those with triangles that have positions. */
export const surfaceMeshes = (json: Json): number[] =>
  objectsIn(json.meshes).flatMap((mesh, index) => {
    const hasTriangles = objectsIn(mesh.primitives).some(
      ({ mode = 4, attributes }) =>
        (mode === 4 || mode === 5 || mode === 6) &&
        isObject(attributes) &&
        attributes.POSITION !== undefined,
    );
    return hasTriangles ? [index] : [];
  });

/** The decoded name of a URI that is relative and inside the folder; undefined for all others. */
export function relativeName(uri: string): string | undefined {
  let name: string;
  try {
    name = decodeURIComponent(uri);
  } catch {
    return undefined;
  }
  if (/^[a-z][a-z0-9+.-]*:|^[/\\]|\\|\0/i.test(name)) return undefined;
  const parts = name.split('/').filter((part) => part !== '.');
  return parts.includes('..') ? undefined : parts.join('/');
}

const parsed = new WeakMap<Blob | Uint8Array, Promise<Json>>();
const maxHead = 64 * 2 ** 20; // bytes at the beginning of a GLB that must contain its JSON

/**
 * What of a file may be a document: of a GLB the JSON chunk with the header before it, since the buffers behind it may
 * be large and are not needed; of a file whose first character begins an object, all; of others nothing.
 */
async function documentIn(file: Blob): Promise<Uint8Array> {
  const start = await bytesOf(file.slice(0, 64));
  if (isGlb(start) && start.length >= 20) {
    const length = new DataView(start.buffer).getUint32(12, true);
    return bytesOf(file.slice(0, Math.min(20 + length, maxHead)));
  }
  const text = new TextDecoder().decode(start); // without the mark of its byte order
  return text.trimStart().startsWith('{') ? bytesOf(file) : new Uint8Array(0);
}

/** The same for a dropped file, whose name may be wrong, and which is read and parsed only once. */
export function gltfOf(files: Files, name: string): Promise<Json> {
  const file = files.get(name);
  if (!file) return Promise.resolve({});
  let json = parsed.get(file);
  if (!json) {
    const bytes = documentIn(file instanceof Blob ? file : new Blob([file as BlobPart]));
    json = bytes.then((all) => parseGltf({ bytes: all }));
    parsed.set(file, json);
  }
  return json;
}
