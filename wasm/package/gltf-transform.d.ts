// hgp/gltf-transform: seamless texture coordinates as a transform over a document. Needs
// @gltf-transform/core.

import type { Mesh, Transform } from '@gltf-transform/core';
import type { Client } from './index.js';
import type { LoadOptions, Result, SolveOptions } from './core.js';

export interface SeamlessOptions extends SolveOptions {
  /** Whose loaded model is replaced, mesh by mesh. */
  client: Client;
  /** The set to write, replaced where it is there; by default the first free one of each mesh. */
  texcoord?: number;
  /** Write maps that are not certified, too; by default the transform throws (`no-map`). */
  allowUncertified?: boolean;
  /** Called for every mesh that was solved. */
  onMesh?(mesh: Mesh, result: Result): void;
  weld?: number;
  fix?: LoadOptions['fix'];
  limits?: LoadOptions['limits'];
}

/**
 * `await document.transform(seamless({ client, q: 4 }))`: every mesh gets one more set of texture
 * coordinates (TEXCOORD_n). The primitives of a mesh are one surface; points and lines are left alone.
 * Vertices are duplicated along seams; attributes, morph targets and skins are kept.
 */
export function seamless(options: SeamlessOptions): Transform;
