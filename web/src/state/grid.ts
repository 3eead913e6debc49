// A grid as the material of the mapped mesh, so that the map is seen wherever the file is opened. All
// else in the file keeps its bytes.

import { gridImage, joined } from './grid_image';
import { withObjGrid } from './grid_obj';
import { Splice, type Place } from './json_places';
import type { OutputFile } from './readback';

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

/** Files, the main one first, with the grid. */
export function withGrid(files: OutputFile[], asked: Asked): OutputFile[] {
  const [main, ...others] = files;
  const { name, bytes } = main;
  if (/\.obj$/i.test(name)) return [...withObjGrid(main, asked.tiles), ...others];
  const isGlb = /\.glb$/i.test(name);
  if (!isGlb && !/\.gltf$/i.test(name)) return files;
  return [{ name, bytes: isGlb ? inGlb(bytes, asked) : inGltf(bytes, asked) }, ...others];
}
