// The calls that the page makes to the geometry worker.

import type { SurfaceFacts } from 'hgp';
import type { ScenePart, SerializedBvh } from '../../model/scene';
import type { Analysis, OutputFile, Overlay, Surface } from '../../model/types';
import type { AnalysisRequest, CompareRequest, MapArrays } from './analyse';
import type { Plane } from './mirror_plane';
import type { SurfaceArrays } from './placed_surface';

type OfSurface = 'positions' | 'triangles';
/** A map without the arrays that its surface has, too, which both sides keep once. */
export type LeanMap = Omit<MapArrays, OfSurface> & {
  [K in OfSurface]: MapArrays[K] | undefined;
};

export interface GeometryCalls {
  /** Prepares a surface for display, with the solver's facts; the worker keeps it under its id. */
  surface(
    id: number,
    arrays: SurfaceArrays,
    facts: SurfaceFacts,
    matrix: readonly number[],
  ): Surface;
  /** Analyses a map of a surface; transferred arrays are returned. */
  analyse(
    id: number,
    surface: number,
    request: Omit<AnalysisRequest, 'map'> & { map: LeanMap },
  ): Promise<{ analysis: Analysis; preserved: string; map: LeanMap; files: OutputFile[] }>;
  /** How the map in a file differs from the given one, empty if it does not. Nothing is transferred. */
  compare(request: CompareRequest): Promise<{ difference: string }>;
  /** Relative names in a written .gltf, and the areas in uv and on the surface; both for writing. */
  urisOf(main: OutputFile): { uris: string[]; main: OutputFile };
  /** Several files as one ZIP; nothing is transferred. */
  zip(files: OutputFile[]): { zip: Uint8Array };
  overlay(id: number, overlay: Overlay): Uint8Array;
  crosses(id: number, tiles: number, q: number): { onSurface: Float32Array; inMap: Float32Array };
  /** A thumbnail of a surface, with a map if one is given. */
  thumbnail(surface: number, map?: number, tiles?: number): Uint8ClampedArray<ArrayBuffer>;
  /** A mesh to be drawn beside others, which the worker does not keep, and a thumbnail of it. */
  part(
    arrays: SurfaceArrays,
    matrix: readonly number[],
  ): {
    picture: Uint8ClampedArray<ArrayBuffer>;
    shape: Pick<ScenePart, 'cornerPositions' | 'cornerNormals' | 'tree'>;
  };
  /** Lines along the solver's loops, which are given by two vertices for each crossed edge. */
  loopSegments(surface: number, loops: Uint32Array[]): Float32Array[];
  /** A tree over the triangles of a surface, or of the flat map, for picking. */
  surfaceBvh(surface: number): SerializedBvh;
  mapBvh(id: number): SerializedBvh;
  /** The vertex opposite to one in the plane of symmetry: itself if it is on the plane, −1 if there is none. */
  opposite(surface: number, vertex: number): { vertex: number; hasPlane: boolean };
  /** Per vertex the one at its mirror image in a plane, up to a distance: itself in the plane, −1 if there is none. */
  images(surface: number, plane: Plane, distance: number): Int32Array;
  forget(surfaces: number[], maps: number[]): void;
}

export type GeometryMethod = keyof GeometryCalls;

export interface GeometryMessage {
  call: number;
  method: GeometryMethod;
  args: unknown[];
}

export interface GeometryAnswer {
  call: number;
  result?: unknown;
  error?: string;
}

/** The buffers of all typed arrays in a value, which are transferred instead of copied. */
export function buffersIn(value: unknown, found = new Set<ArrayBuffer>()): Set<ArrayBuffer> {
  if (value instanceof ArrayBuffer) found.add(value);
  else if (ArrayBuffer.isView(value)) found.add(value.buffer as ArrayBuffer);
  else if (typeof value === 'object' && value !== null) {
    for (const part of Object.values(value)) buffersIn(part, found);
  }
  return found;
}
