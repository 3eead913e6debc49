// hgp/gltf-transform: seamless texture coordinates as a transform of a document. Requires
// @gltf-transform/core.

import type { Mesh, Transform } from '@gltf-transform/core';
import type { Client } from './index.js';
import type { LoadOptions, Result, SolveOptions } from './core.js';

export interface SeamlessOptions extends SolveOptions {
  /** The client that solves; its loaded model is replaced by each mesh. */
  client: Client;
  /** The set to write, replaced if it exists; by default the first free one of each mesh. */
  texcoord?: number;
  /** Also write maps that are not certified; by default the transform fails with `no-map`. */
  allowUncertified?: boolean;
  /** Called for every mesh that was solved. */
  onMesh?(mesh: Mesh, result: Result): void;
  weld?: number;
  fix?: LoadOptions['fix'];
  limits?: LoadOptions['limits'];
}

/**
 * `await document.transform(seamless({ client, q: 4 }))`: every mesh gets another set of texture
 * coordinates (TEXCOORD_n). The primitives of a mesh form one surface; points and lines are not changed.
 * Vertices are duplicated along seams; attributes, morph targets and skins are kept.
 */
export function seamless(options: SeamlessOptions): Transform;
