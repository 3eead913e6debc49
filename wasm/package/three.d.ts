// hgp/three: a BufferGeometry with seamless texture coordinates. Needs three.

import type { BufferGeometry, LineSegments } from 'three';
import type { CallOptions, Client } from './index.js';
import type { Certificate, LoadOptions, Result, SolveOptions } from './core.js';

export interface GeometryOptions extends SolveOptions {
  /** The attribute to write; by default `uv`. */
  attribute?: string;
  /** Join vertices closer than this; by default those at the same place. */
  weld?: number;
  fix?: LoadOptions['fix'];
  limits?: LoadOptions['limits'];
}

export interface ParametrizedGeometry {
  /**
   * A copy: vertices are cut along the seams, the triangles keep their order, and so do groups, morph
   * targets, skin weights and every other attribute. Indexed, whether the original was or not.
   */
  geometry: BufferGeometry;
  /** The seams on the surface, in the default material. */
  seams: LineSegments;
  /** Of the coordinates as they are stored in the attribute, in float32. */
  certificate: Certificate;
  result: Result;
}

/**
 * Texture coordinates for a three.js geometry; v points up, as three's textures expect. Vertices at the
 * same place are one (renderers split them along normals and old texture coordinates); the client's
 * loaded model is replaced. Draws nothing: give `geometry` to a mesh of your own.
 */
export function parametrizeGeometry(
  client: Client,
  geometry: BufferGeometry,
  options?: GeometryOptions,
  call?: CallOptions,
): Promise<ParametrizedGeometry>;
