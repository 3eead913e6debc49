// Values at the corners of triangles that are never there as a whole: they are gathered from those at the vertices slice
// by slice, while they are uploaded. At a million triangles, the positions of all corners are 36 MB.

import { BufferAttribute } from 'three';
import type { Surface } from '../model/types';

/** Elements `first` to `last` − 1, gathered. */
type Gather = (first: number, last: number) => ArrayBufferView;

interface Gathered {
  readonly byteLength: number;
  /** A part that begins at a byte where a slice ended and has at most so many bytes. */
  slice(begin: number, maxBytes: number): Uint8Array;
}

const sources = new WeakMap<object, Gathered>();

/** What an array stands for, if it is that of an attribute whose values are gathered. */
export const gatheredFor = (array: unknown): Gathered | undefined =>
  typeof array === 'object' && array !== null ? sources.get(array) : undefined;

/** Slices are copied before the next one is gathered; what is larger is one upload of a whole array. */
let scratch = new ArrayBuffer(0);
const maxScratch = 2 ** 20;
function room(bytes: number): ArrayBuffer {
  if (bytes > maxScratch) return new ArrayBuffer(bytes);
  if (scratch.byteLength < bytes) scratch = new ArrayBuffer(bytes);
  return scratch;
}

/** `empty` tells three.js the type of the values. */
export class GatheredAttribute extends BufferAttribute {
  constructor(
    empty: Float32Array | Int8Array | Uint32Array,
    { count, itemSize, gather }: { count: number; itemSize: number; gather: Gather },
  ) {
    super(empty, itemSize, empty instanceof Int8Array);
    Object.assign(this, { count });
    const bytesEach = itemSize * empty.BYTES_PER_ELEMENT;
    sources.set(empty, {
      byteLength: count * bytesEach,
      slice(begin, maxBytes) {
        const first = begin / bytesEach;
        const last = Math.min(count, first + Math.floor(maxBytes / bytesEach));
        const { buffer, byteOffset, byteLength } = gather(first, last);
        return new Uint8Array(buffer as ArrayBuffer, byteOffset, byteLength);
      },
    });
  }
}

/** Three numbers at each corner. */
export function cornerPositions(places: Float64Array, triangles: Uint32Array): BufferAttribute {
  const gather: Gather = (first, last) => {
    const count = 3 * (last - first);
    const out = new Float32Array(room(4 * count), 0, count);
    for (let c = first, at = 0; c < last; c++) {
      const v = 3 * triangles[c];
      out[at++] = places[v];
      out[at++] = places[v + 1];
      out[at++] = places[v + 2];
    }
    return out;
  };
  return new GatheredAttribute(new Float32Array(0), { count: triangles.length, itemSize: 3, gather }); // prettier-ignore
}

const wordsOf = (bytes: Int8Array): Int32Array =>
  new Int32Array(bytes.buffer, bytes.byteOffset, bytes.length / 4);

/** The place of the first of ascending values that is not less than `value`. */
function lowerBound(ascending: Uint32Array, value: number): number {
  let low = 0;
  let high = ascending.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (ascending[middle] < value) low = middle + 1;
    else high = middle;
  }
  return low;
}

type Normals = Pick<Surface, 'packedNormals' | 'triangles' | 'creaseCorners' | 'creaseNormals'>;

/** Four bytes at each corner: those of its vertex, or its own along a crease. */
export function cornerNormals(surface: Normals): BufferAttribute {
  const { triangles, creaseCorners } = surface;
  const [words, own] = [wordsOf(surface.packedNormals), wordsOf(surface.creaseNormals)];
  const gather: Gather = (first, last) => {
    const count = last - first;
    const out = new Int32Array(room(4 * count), 0, count);
    for (let c = first; c < last; c++) out[c - first] = words[triangles[c]];
    const end = lowerBound(creaseCorners, last);
    for (let i = lowerBound(creaseCorners, first); i < end; i++) out[creaseCorners[i] - first] = own[i]; // prettier-ignore
    return out;
  };
  return new GatheredAttribute(new Int8Array(0), { count: triangles.length, itemSize: 4, gather });
}

/** Indices of the ends of every side of triangles whose corners are numbered one after the other. */
export function triangleSides(corners: number): BufferAttribute {
  const gather: Gather = (first, last) => {
    const count = last - first;
    const out = new Uint32Array(room(4 * count), 0, count);
    for (let i = first; i < last; i++) {
      const c = i >> 1;
      const next = c % 3 === 2 ? c - 2 : c + 1;
      out[i - first] = i % 2 === 0 ? c : next;
    }
    return out;
  };
  return new GatheredAttribute(new Uint32Array(0), { count: 2 * corners, itemSize: 1, gather });
}

/** Texture coordinates that are positions in the plane, too: one array and one buffer for both. */
export class FlatAttribute extends BufferAttribute {
  constructor(uv: Float32Array) {
    super(uv, 2);
  }
  override getZ(): number {
    return 0;
  }
}
