// The programs for which a download can be made: the file that each needs, and how it is used there.

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

/** 3D programs read OBJ and glTF; a model in another format becomes a GLB. */
export function formatFor(
  id: TargetId,
  written: string,
): Exclude<Format, 'cones' | 'report'> | 'quads' {
  if (id === 'quads') return 'quads';
  if (isGltf(written)) return 'same';
  return id === 'blender' && /\.obj$/i.test(written) ? 'same' : 'glb';
}
