// Lists the content of a written glTF besides the texture coordinates, all of which is unchanged.

import { objectsIn, type Json } from './glb';

const length = (list: unknown): number => (Array.isArray(list) ? list.length : 0);

/** "3 materials, 1 skin, 52 morph targets"; empty if there is none. */
export function summarizePreserved(json: Json): string {
  const primitives = objectsIn(json.meshes).flatMap((mesh) => objectsIn(mesh.primitives));
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
