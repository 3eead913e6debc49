// A grid as the material of the mapped mesh, so that the map is seen wherever the file is opened. All
// else in the file keeps its bytes.

import type { OutputFile } from '../model/types';
import { concatBytes, makeGlb, splitGlb } from './glb';
import { gridImage } from './grid_image';
import { withObjGrid } from './grid_material_obj';
import { JsonEditor, type JsonSpan } from './json_edit';

export interface GridOptions {
  mesh: number;
  /** Without it the last set of each primitive, which is the new one. */
  uvSet?: number;
  /** Tiles per unit of uv. */
  tiles: number;
}

/** The last set that a primitive has without a gap. */
function lastSet(attributes: JsonSpan): number {
  let set = 0;
  while (attributes.members!.has(`TEXCOORD_${set + 1}`)) set += 1;
  return set;
}

/** `image` says where the picture is; the rest is the same for all kinds of glTF. */
function assign(editor: JsonEditor, image: object, { mesh, uvSet, tiles }: GridOptions): void {
  const { members } = editor.root;
  const primitives = members!.get('meshes')!.items![mesh].members!.get('primitives')!.items!;
  const attributesOf = (primitive: JsonSpan): JsonSpan => primitive.members!.get('attributes')!;
  const texCoord = uvSet ?? lastSet(attributesOf(primitives[0]));
  const source = editor.add('images', { name: 'hgp grid', mimeType: 'image/png', ...image });
  const sampler = editor.add('samplers', { wrapS: 10497, wrapT: 10497, magFilter: 9729, minFilter: 9987 }); // prettier-ignore
  const index = editor.add('textures', { name: 'hgp grid', sampler, source });
  const scale = Number((tiles / 2).toPrecision(6));
  const material = editor.add('materials', {
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
    if (has) editor.set(primitive, 'material', material);
  }
}

function needTransform(editor: JsonEditor, text: string): void {
  const used = (JSON.parse(text) as { extensionsUsed?: string[] }).extensionsUsed ?? [];
  if (!used.includes('KHR_texture_transform'))
    editor.add('extensionsUsed', 'KHR_texture_transform');
}

const decode = (bytes: Uint8Array): string => new TextDecoder().decode(bytes);
function inGlb(bytes: Uint8Array, options: GridOptions, picture: Uint8Array): Uint8Array {
  const { json, bin, rest } = splitGlb(bytes)!;
  const text = decode(json);
  const editor = new JsonEditor(text);
  const byteLength = picture.length;
  const bufferView = editor.add('bufferViews', { buffer: 0, byteOffset: bin.length, byteLength });
  const buffer = editor.root.members!.get('buffers')!.items![0];
  editor.set(buffer, 'byteLength', bin.length + byteLength);
  assign(editor, { bufferView }, options);
  needTransform(editor, text);
  return makeGlb(editor.result, concatBytes([bin, picture]), rest);
}

function inGltf(bytes: Uint8Array, options: GridOptions, picture: Uint8Array): Uint8Array {
  const text = decode(bytes);
  const editor = new JsonEditor(text);
  const uri = `data:image/png;base64,${btoa(String.fromCharCode(...picture))}`;
  assign(editor, { uri }, options);
  needTransform(editor, text);
  return new TextEncoder().encode(editor.result);
}

/** Files, the main one first, with the grid. */
export async function withGrid(files: OutputFile[], options: GridOptions): Promise<OutputFile[]> {
  const [main, ...others] = files;
  const { name, bytes } = main;
  const picture = await gridImage();
  if (/\.obj$/i.test(name)) return [...withObjGrid(main, options.tiles, picture), ...others];
  if (/\.glb$/i.test(name)) return [{ name, bytes: inGlb(bytes, options, picture) }, ...others];
  if (/\.gltf$/i.test(name))
    return [{ name, bytes: inGltf(bytes, options, picture) as Uint8Array }, ...others];
  return files;
}
