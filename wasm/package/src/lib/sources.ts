// Converts files, blobs, buffers and arrays to the solver's input. What the caller owns is copied when the call is
// made: it may change, or be transferred, before the call runs, and a new worker needs it again.

import { describe } from './check_options.js';
import { HgpError, usage } from './error.js';
import type { CoreFiles, FileSet, FileSource, MeshArrays } from './options.js';
import type { Platform } from './platform.js';

/**
 * Files as they are sent to a worker.
 * @internal
 */
export interface PackedFiles {
  main: string;
  files: Map<string, Uint8Array | Blob>;
}

/** A view of the bytes of an ArrayBuffer or of a view of one. A Node Buffer is a view. */
function viewOf(source: unknown): Uint8Array | undefined {
  if (source instanceof Uint8Array) return source;
  if (ArrayBuffer.isView(source)) {
    return new Uint8Array(source.buffer, source.byteOffset, source.byteLength);
  }
  return source instanceof ArrayBuffer ? new Uint8Array(source) : undefined;
}

function copyOfBytes(source: unknown): Uint8Array | undefined {
  try {
    const view = viewOf(source);
    return view && Uint8Array.from(view);
  } catch (error) {
    if (!(error instanceof TypeError)) throw error;
    throw usage('load: the buffer of this file has been transferred and is empty here');
  }
}

/** Bytes are copied now, not when the promise is awaited; a Blob cannot change. */
function taken(source: unknown, pack: Platform['packed']): Promise<Uint8Array | Blob> {
  if (source instanceof Blob) return pack(source);
  const bytes = copyOfBytes(source);
  if (bytes) return Promise.resolve(bytes);
  throw usage(
    `load: a file is a File, Blob, ArrayBuffer, typed array or { main, files }, not ${describe(source)}`,
  );
}

const isSet = (source: unknown): source is FileSet =>
  source !== null && typeof source === 'object' && 'files' in source && source.files !== undefined;

/** @internal */
export function takeFiles(
  source: FileSource | FileSet,
  name: string | undefined,
  pack: Platform['packed'],
): Promise<PackedFiles> {
  if (!isSet(source)) {
    const content = taken(source, pack);
    const main = name ?? (source as { name?: string }).name ?? '';
    return content.then((bytes) => ({ main, files: new Map([[main, bytes]]) }));
  }
  const { main } = source;
  const given = source.files instanceof Map ? source.files : new Map(Object.entries(source.files));
  if (!given.has(main)) throw usage(`load: files has no '${main}', which main names`);
  const contents = [...given].map(([key, value]) =>
    taken(value, pack).then((bytes) => [key, bytes] as const),
  );
  return Promise.all(contents).then((entries) => ({ main, files: new Map(entries) }));
}

/**
 * Checks files as the core takes them.
 * @internal
 */
export function checkFiles(call: string, source: unknown): void {
  const { main, files } = (source ?? {}) as Partial<CoreFiles>;
  // Not by their class: test runners give programs another Uint8Array than the one that files are read into.
  const isBytes = (bytes: Uint8Array): boolean =>
    ArrayBuffer.isView(bytes) && bytes.BYTES_PER_ELEMENT === 1;
  const isOfBytes = files instanceof Map && [...files.values()].every(isBytes);
  if (typeof main !== 'string' || !isOfBytes)
    throw usage(`${call} takes { main, files }: a name, and a Map from names to Uint8Array`);
  if (!files.has(main)) throw usage(`${call}: files has no '${main}', which main names`);
}

/**
 * In the worker: all files as bytes.
 * @internal
 */
export async function unpacked({ main, files }: PackedFiles): Promise<CoreFiles> {
  const plain = new Map<string, Uint8Array>();
  for (const [name, content] of files) {
    plain.set(
      name,
      content instanceof Uint8Array ? content : new Uint8Array(await content.arrayBuffer()),
    );
  }
  return { main, files: plain };
}

const isNumbers = (value: unknown): value is ArrayLike<number> =>
  (Array.isArray(value) && value.every((x) => typeof x === 'number')) ||
  (ArrayBuffer.isView(value) &&
    !(value instanceof DataView) &&
    !(value instanceof BigInt64Array) &&
    !(value instanceof BigUint64Array));

/** @internal */
export interface CheckedMesh {
  positions: ArrayLike<number>;
  triangles: ArrayLike<number>;
}

/**
 * Checks the arrays of a mesh, and adds indices if it has none.
 * @internal
 */
export function checkMesh({ positions, triangles }: MeshArrays): CheckedMesh {
  const fail = (what: string) => usage(`parametrizeMesh: ${what}`);
  if (!isNumbers(positions)) {
    throw fail(`positions are numbers, three per vertex, not ${describe(positions)}`);
  }
  if (positions.length === 0 || positions.length % 3 !== 0) {
    throw fail(`positions are three numbers per vertex; there are ${positions.length}`);
  }
  const vertexCount = positions.length / 3;
  if (triangles === undefined || triangles === null) {
    if (vertexCount % 3 !== 0) {
      throw fail(`without triangles every three vertices are one; there are ${vertexCount}`);
    }
    return { positions, triangles: Uint32Array.from({ length: vertexCount }, (_, i) => i) };
  }
  if (!isNumbers(triangles)) {
    throw fail(`triangles are numbers, three per triangle, not ${describe(triangles)}`);
  }
  if (triangles.length === 0 || triangles.length % 3 !== 0) {
    throw fail(`triangles are three vertices each; there are ${triangles.length} indices`);
  }
  for (let i = 0; i < triangles.length; i++) {
    const v = triangles[i];
    if (!(Number.isInteger(v) && v >= 0 && v < vertexCount)) {
      throw fail(`triangle ${Math.floor(i / 3)} has the vertex ${v}; there are ${vertexCount}`);
    }
  }
  return { positions, triangles };
}

/**
 * A checked copy of the arrays of a mesh.
 * @internal
 */
export function takeMesh(mesh: MeshArrays): CheckedMesh {
  const { positions, triangles } = checkMesh(mesh);
  try {
    return { positions: copyOf(positions), triangles: copyOf(triangles) };
  } catch (error) {
    if (!(error instanceof RangeError)) throw error;
    const message = `There is not enough memory for a copy of ${positions.length / 3} vertices.`;
    throw new HgpError({ code: 'limit', message }, { cause: error });
  }
}

/** Of the same type, so that numbers in single precision take no more memory. */
const copyOf = (numbers: ArrayLike<number>): ArrayLike<number> =>
  ArrayBuffer.isView(numbers) ? (numbers as Float64Array).slice() : Float64Array.from(numbers);
