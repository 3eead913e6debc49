// Reads PLY as hgp writes it: x, y, z of vertices, and per face its corners and a list texcoord of u and v.
// Independent of the writer, like read_uv.ts.

import type { Corners } from '../model/types';

interface Property {
  name: string;
  type: string;
  /** Type of the length, if the property is a list. */
  count?: string;
}
interface Element {
  name: string;
  count: number;
  properties: Property[];
}
type Read = (type: string) => number;

const sizes: Record<string, number> = {
  char: 1,
  uchar: 1,
  int8: 1,
  uint8: 1,
  short: 2,
  ushort: 2,
  int16: 2,
  uint16: 2,
  int: 4,
  uint: 4,
  int32: 4,
  uint32: 4,
  float: 4,
  float32: 4,
  double: 8,
  float64: 8,
};

function binary(bytes: Uint8Array, from: number, isLittle: boolean): Read {
  const view = new DataView(bytes.buffer, bytes.byteOffset);
  let at = from;
  return (type) => {
    const here = at;
    at += sizes[type];
    if (/^(double|float64)$/.test(type)) return view.getFloat64(here, isLittle);
    if (/^float/.test(type)) return view.getFloat32(here, isLittle);
    const isUnsigned = type.startsWith('u');
    if (sizes[type] === 1) return isUnsigned ? view.getUint8(here) : view.getInt8(here);
    if (sizes[type] === 2)
      return isUnsigned ? view.getUint16(here, isLittle) : view.getInt16(here, isLittle);
    return isUnsigned ? view.getUint32(here, isLittle) : view.getInt32(here, isLittle);
  };
}

function text(body: string): Read {
  const words = body
    .replace(/^comment.*$/gm, '')
    .split(/\s+/)
    .filter(Boolean);
  let at = 0;
  return () => Number(words[at++]);
}

function headerOf(bytes: Uint8Array): { format: string; elements: Element[]; length: number } {
  const head = new TextDecoder('latin1').decode(bytes.subarray(0, 1 << 20));
  const end = /^end_header\r?(\n|$)|\rend_header\r/m.exec(head);
  if (!end) throw new Error('it has no PLY header');
  const length = end.index + end[0].length;
  const elements: Element[] = [];
  let format = 'ascii';
  for (const line of head.slice(0, length).split(/[\r\n]+/)) {
    const [word, ...rest] = line.trim().split(/\s+/);
    if (word === 'format') format = rest[0];
    if (word === 'element')
      elements.push({ name: rest[0], count: Number(rest[1]), properties: [] });
    if (word !== 'property') continue;
    const isList = rest[0] === 'list';
    const [type, name] = isList ? [rest[2], rest[3]] : [rest[0], rest[1]];
    elements.at(-1)!.properties.push({ name, type, ...(isList ? { count: rest[1] } : {}) });
  }
  return { format, elements, length };
}

export function readPly(bytes: Uint8Array): Corners {
  const { format, elements, length } = headerOf(bytes);
  const read =
    format === 'ascii'
      ? text(new TextDecoder('latin1').decode(bytes.subarray(length)))
      : binary(bytes, length, format === 'binary_little_endian');
  const places: number[] = [];
  const out = { positions: [] as number[], uv: [] as number[], sizes: [] as number[] };
  for (const { name, count, properties } of elements) {
    for (let row = 0; row < count; row++) {
      const values = new Map<string, number[]>();
      for (const one of properties) {
        const n = one.count ? read(one.count) : 1;
        values.set(
          one.name,
          Array.from({ length: n }, () => read(one.type)),
        );
      }
      if (name === 'vertex') places.push(...['x', 'y', 'z'].map((axis) => values.get(axis)![0]));
      const corners = values.get('vertex_indices') ?? values.get('vertex_index') ?? [];
      if (name !== 'face' || corners.length < 3) continue;
      out.sizes.push(corners.length);
      for (const v of corners) out.positions.push(...places.slice(3 * v, 3 * v + 3));
      for (const x of values.get('texcoord') ?? []) out.uv.push(x);
    }
  }
  const all = { positions: new Float64Array(out.positions), uv: new Float64Array(out.uv) };
  return out.sizes.some((n) => n > 3) ? { ...all, sizes: out.sizes } : all;
}
