// A grid as the material of the mapped mesh, so that the map is seen wherever the file is opened. All
// else in the file keeps its bytes.

import { zlibSync } from 'fflate';
import { Splice, type Place } from './json_places';
import type { OutputFile } from './readback';

const side = 64; // pixels of the image, which shows two by two tiles
const lineWidth = 3;
const colours = [
  [233, 237, 242],
  [205, 214, 224],
  [29, 63, 99],
]; // paper, shade, lines

const crcTable = Int32Array.from({ length: 256 }, (_, n) => {
  let c = n;
  for (let k = 0; k < 8; k++) c = c & 1 ? (c >>> 1) ^ 0xedb88320 : c >>> 1;
  return c;
});

function chunk(kind: string, data: Uint8Array): Uint8Array {
  const out = new Uint8Array(12 + data.length);
  const view = new DataView(out.buffer);
  view.setUint32(0, data.length);
  out.set(new TextEncoder().encode(kind), 4);
  out.set(data, 8);
  let crc = -1;
  for (const byte of out.subarray(4, 8 + data.length)) {
    crc = (crc >>> 8) ^ crcTable[(crc ^ byte) & 255];
  }
  view.setUint32(8 + data.length, ~crc >>> 0);
  return out;
}

/** As a PNG with a palette. */
function gridImage(): Uint8Array {
  const half = side / 2;
  const rows = new Uint8Array(side * (side + 1)); // each with a filter byte of 0
  for (let y = 0; y < side; y++) {
    for (let x = 0; x < side; x++) {
      const isLine = x % half < lineWidth || y % half < lineWidth;
      const isShade = Math.floor(x / half) !== Math.floor(y / half);
      rows[y * (side + 1) + 1 + x] = isLine ? 2 : isShade ? 1 : 0;
    }
  }
  const head = new Uint8Array(13);
  const view = new DataView(head.buffer);
  view.setUint32(0, side);
  view.setUint32(4, side);
  head.set([8, 3, 0, 0, 0], 8); // eight bits, palette
  const parts = [
    new Uint8Array([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]),
    chunk('IHDR', head),
    chunk('PLTE', Uint8Array.from(colours.flat())),
    chunk('IDAT', zlibSync(rows, { level: 9 })),
    chunk('IEND', new Uint8Array(0)),
  ];
  return joined(parts);
}

function joined(parts: Uint8Array[]): Uint8Array {
  const out = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    out.set(part, at);
    at += part.length;
  }
  return out;
}

interface Asked {
  mesh: number;
  /** Without it the last set of each primitive, which is the new one. */
  uvSet?: number;
  /** Tiles per unit of uv. */
  tiles: number;
}

/** The last set that a primitive has without a gap. */
function lastSet(attributes: Place): number {
  let set = 0;
  while (attributes.members!.has(`TEXCOORD_${set + 1}`)) set += 1;
  return set;
}

/** `image` says where the picture is; the rest is the same for all kinds of glTF. */
function assign(splice: Splice, image: object, { mesh, uvSet, tiles }: Asked): void {
  const { members } = splice.root;
  const primitives = members!.get('meshes')!.items![mesh].members!.get('primitives')!.items!;
  const attributesOf = (primitive: Place): Place => primitive.members!.get('attributes')!;
  const texCoord = uvSet ?? lastSet(attributesOf(primitives[0]));
  const source = splice.add('images', { name: 'hgp grid', mimeType: 'image/png', ...image });
  const sampler = splice.add('samplers', { wrapS: 10497, wrapT: 10497, magFilter: 9729, minFilter: 9987 }); // prettier-ignore
  const index = splice.add('textures', { name: 'hgp grid', sampler, source });
  const scale = Number((tiles / 2).toPrecision(6));
  const material = splice.add('materials', {
    name: 'hgp grid',
    pbrMetallicRoughness: {
      baseColorTexture: {
        ...{ index, texCoord },
        extensions: { KHR_texture_transform: { scale: [scale, scale] } },
      },
      metallicFactor: 0,
      roughnessFactor: 0.9,
    },
  });
  for (const primitive of primitives) {
    const has = attributesOf(primitive).members!.has(`TEXCOORD_${texCoord}`);
    if (has) splice.set(primitive, 'material', material);
  }
}

function needTransform(splice: Splice, text: string): void {
  const used = (JSON.parse(text) as { extensionsUsed?: string[] }).extensionsUsed ?? [];
  if (!used.includes('KHR_texture_transform'))
    splice.add('extensionsUsed', 'KHR_texture_transform');
}

const decode = (bytes: Uint8Array): string => new TextDecoder().decode(bytes);
const padded = (bytes: Uint8Array, by: number): Uint8Array => {
  const out = new Uint8Array(Math.ceil(bytes.length / 4) * 4).fill(by);
  out.set(bytes);
  return out;
};

function inGlb(bytes: Uint8Array, asked: Asked): Uint8Array {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const jsonLength = view.getUint32(12, true);
  const text = decode(bytes.subarray(20, 20 + jsonLength));
  const binAt = 20 + jsonLength;
  const binLength = view.getUint32(binAt, true);
  const bin = bytes.subarray(binAt + 8, binAt + 8 + binLength);
  const rest = bytes.subarray(binAt + 8 + binLength);
  const picture = gridImage();
  const splice = new Splice(text);
  const byteLength = picture.length;
  const bufferView = splice.add('bufferViews', { buffer: 0, byteOffset: binLength, byteLength });
  splice.set(splice.root.members!.get('buffers')!.items![0], 'byteLength', binLength + byteLength);
  assign(splice, { bufferView }, asked);
  needTransform(splice, text);
  const json = padded(new TextEncoder().encode(splice.result), 0x20);
  const more = padded(joined([bin, picture]), 0);
  const head = new DataView(new ArrayBuffer(20));
  const total = 28 + json.length + more.length + rest.length;
  [0x46546c67, 2, total, json.length, 0x4e4f534a].forEach((n, i) => head.setUint32(4 * i, n, true));
  const between = new DataView(new ArrayBuffer(8));
  between.setUint32(0, more.length, true);
  between.setUint32(4, 0x004e4942, true);
  const parts = [new Uint8Array(head.buffer), json, new Uint8Array(between.buffer), more, rest];
  return joined(parts);
}

function inGltf(bytes: Uint8Array, asked: Asked): Uint8Array {
  const text = decode(bytes);
  const splice = new Splice(text);
  const uri = `data:image/png;base64,${btoa(String.fromCharCode(...gridImage()))}`;
  assign(splice, { uri }, asked);
  needTransform(splice, text);
  return new TextEncoder().encode(splice.result);
}

/** Files of a glTF, the main one first, with the grid; other formats as they are. */
export function withGrid(files: OutputFile[], asked: Asked): OutputFile[] {
  const [{ name, bytes }, ...others] = files;
  const isGlb = /\.glb$/i.test(name);
  if (!isGlb && !/\.gltf$/i.test(name)) return files;
  return [{ name, bytes: isGlb ? inGlb(bytes, asked) : inGltf(bytes, asked) }, ...others];
}
