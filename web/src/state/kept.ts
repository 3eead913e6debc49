// What a written glTF holds beside the texture coordinates: all of it is as it was.

import { isGltf, readGltfJson } from './files';
import type { OutputFile } from './readback';

type List = unknown[] | undefined;

interface Whole {
  materials?: List;
  textures?: List;
  skins?: List;
  animations?: List;
  cameras?: List;
  extensionsUsed?: List;
  meshes?: { primitives?: { targets?: List }[] }[];
}

const length = (list: List): number => (Array.isArray(list) ? list.length : 0);

/** "3 materials, 1 skin, 52 morph targets"; empty where there is nothing, or no glTF. */
export async function keptIn({ name, bytes }: OutputFile): Promise<string> {
  if (!isGltf(name)) return '';
  const json = (await readGltfJson(name, bytes)) as Whole;
  const primitives = (json.meshes ?? []).flatMap((mesh) => mesh.primitives ?? []);
  const counts: [number, string][] = [
    [length(json.materials), 'material'],
    [length(json.textures), 'texture'],
    [length(json.skins), 'skin'],
    [length(json.animations), 'animation'],
    [primitives.reduce((sum, { targets }) => sum + length(targets), 0), 'morph target'],
    [length(json.cameras), 'camera'],
    [length(json.extensionsUsed), 'extension'],
  ];
  return counts
    .filter(([count]) => count > 0)
    .map(([count, what]) => `${count} ${what}${count === 1 ? '' : 's'}`)
    .join(', ');
}
