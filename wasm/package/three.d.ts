// hgp/three: a BufferGeometry with seamless texture coordinates. Requires three.

import type { BufferGeometry, LineSegments } from 'three';
import type { CallOptions, Client } from './index.js';
import type { Certificate, LoadOptions, Result, SolveOptions } from './core.js';

export interface GeometryOptions extends SolveOptions {
  /** The attribute to write; by default `uv`. */
  attribute?: string;
  /** Join vertices closer than this; by default those at equal positions. */
  weld?: number;
  fix?: LoadOptions['fix'];
  limits?: LoadOptions['limits'];
}

export interface ParametrizedGeometry {
  /**
   * A copy in which vertices are duplicated along the seams. Triangles keep their order; groups, morph
   * targets, skin weights and all other attributes are kept. Always indexed.
   */
  geometry: BufferGeometry;
  /** The seams on the surface, in the default material. */
  seams: LineSegments;
  /** Certificate of the coordinates as stored in the attribute, in float32. */
  certificate: Certificate;
  result: Result;
}

/**
 * Texture coordinates for a three.js geometry; v points up, as textures in three.js expect. Vertices at
 * equal positions are joined, because renderers split them where normals or old texture coordinates differ. Replaces
 * the client's loaded model. To draw the result, use `geometry` in a mesh.
 */
export function parametrizeGeometry(
  client: Client,
  geometry: BufferGeometry,
  options?: GeometryOptions,
  call?: CallOptions,
): Promise<ParametrizedGeometry>;
