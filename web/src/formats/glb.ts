// glTF in its two shapes: the chunks of a GLB, and the JSON document, parsed once per file. What is in
// the JSON is anybody's guess: every reader here takes it as `unknown`.

import type { Files, OutputFile } from '../model/types';

const magic = 0x46546c67;

export interface GlbChunks {
  json: Uint8Array;
  bin: Uint8Array;
  /** Chunks of other kinds, with their heads. */
  rest: Uint8Array;
}

/** Nothing where the bytes are no GLB with a JSON chunk that is all there. */
export function splitGlb(bytes: Uint8Array): GlbChunks | undefined {
  if (bytes.length < 20) return undefined;
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (view.getUint32(0, true) !== magic) return undefined;
  const binAt = 20 + view.getUint32(12, true);
  if (binAt > bytes.length) return undefined;
  const json = bytes.subarray(20, binAt);
  if (binAt + 8 > bytes.length) return { json, bin: new Uint8Array(0), rest: new Uint8Array(0) };
  const end = binAt + 8 + view.getUint32(binAt, true);
  return { json, bin: bytes.subarray(binAt + 8, end), rest: bytes.subarray(end) };
}

export const isGltf = (name: string): boolean => /\.(glb|gltf)$/i.test(name);

export async function bytesOf(file: Blob | Uint8Array): Promise<Uint8Array> {
  return file instanceof Uint8Array ? file : new Uint8Array(await file.arrayBuffer());
}

export type Json = Readonly<Record<string, unknown>>;

export const isObject = (value: unknown): value is Json =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

/** The items of a list that are objects; others stay as empty objects, so that indices hold. */
export const objectsIn = (value: unknown): Json[] =>
  Array.isArray(value) ? value.map((one) => (isObject(one) ? one : {})) : [];

/** The document of a .glb or .gltf; an empty one where it is none, for the solver says why. */
export function parseGltf({ name, bytes }: OutputFile): Json {
  try {
    const text = /\.glb$/i.test(name) ? (splitGlb(bytes)?.json ?? new Uint8Array(0)) : bytes;
    const json: unknown = JSON.parse(new TextDecoder().decode(text));
    return isObject(json) ? json : {};
  } catch {
    return {};
  }
}

/** The meshes that are surfaces to the solver, in its order: those with triangles that have positions. */
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

/** Relative, inside the folder, decoded once; undefined for everything else. */
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
const mostHead = 64 * 2 ** 20; // bytes of a GLB in which its JSON ends

/** The same for a file that was dropped: read and parsed the first time only. */
export function gltfOf(files: Files, name: string): Promise<Json> {
  const file = files.get(name);
  if (!file || !isGltf(name)) return Promise.resolve({});
  let json = parsed.get(file);
  if (!json) {
    const isLong = file instanceof Blob && /\.glb$/i.test(name);
    json = bytesOf(isLong ? file.slice(0, mostHead) : file).then((bytes) =>
      parseGltf({ name, bytes }),
    );
    parsed.set(file, json);
  }
  return json;
}
