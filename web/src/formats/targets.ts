// The programs for which a download can be made: the file that each needs, and how it is used there.

import type { TextureFate } from '../model/texture_fate';
import type { TargetId } from '../model/ui_state';
import type { Format } from './exports';
import { isGltf } from './glb';

export interface Target {
  id: TargetId;
  label: string;
  /** How to use the file there. */
  hint: string;
}

export const targets: readonly Target[] = [
  {
    id: 'blender',
    label: 'Blender',
    hint: 'File › Import, then give the material an image texture and leave it at Repeat.',
  },
  {
    id: 'three',
    label: 'three.js and the web',
    hint: 'GLTFLoader reads it; set wrapS and wrapT of the texture to RepeatWrapping.',
  },
  {
    id: 'engine',
    label: 'A game engine',
    hint: 'Import the GLB, and let the texture repeat.',
  },
  {
    id: 'quads',
    label: 'Quad mesh',
    hint: 'The cells of the grid as quads, for subdivision and modelling.',
  },
];

/** How a program is told to read a set of coordinates other than the first; empty for the first. */
export function setHint(id: TargetId, set: number): string {
  if (set === 0 || id === 'quads') return '';
  if (id === 'blender') {
    const name = `UVMap.${String(set).padStart(3, '0')}`;
    return `The new coordinates are the UV map “${name}”: name it in a UV Map node before the image texture, or make it the active one in the mesh’s data.`;
  }
  if (id === 'three')
    return `The new coordinates are set ${set}: texture.channel = ${set} for each texture that you add for them.`;
  return `The new coordinates are UV channel ${set}, where the first is 0 (Unreal: coordinate index ${set}; Unity: UV${set}; Godot: ${set === 1 ? 'UV2' : 'none beyond UV2, so replace TEXCOORD_0'}).`;
}

const hints: Record<TextureFate, string> = {
  kept: 'The file’s own textures stay on the old coordinates and look as before; textures that you add can use the new ones.',
  moved:
    'The file’s own textures now use the new coordinates. They were painted for the old ones and will not fit; to keep their look, keep the old coordinates, or bake the textures (in Blender: Bake, with the old UV map on the image nodes and the new one active).',
  unseen:
    'The file’s own textures now use the new coordinates, because the ones they asked for are missing from this mesh or have no area; all old coordinates are kept.',
};

/** What becomes of textures that were painted for the old coordinates. */
export const textureHint = (fate: TextureFate): string => hints[fate];

/** 3D programs read OBJ and glTF; a model in another format becomes a GLB. */
export function formatFor(
  id: TargetId,
  written: string,
): Exclude<Format, 'cones' | 'report'> | 'quads' {
  if (id === 'quads') return 'quads';
  if (isGltf(written)) return 'same';
  return id === 'blender' && /\.obj$/i.test(written) ? 'same' : 'glb';
}
