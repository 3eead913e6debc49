// What the page asks of the geometry worker, call by call.

import type { SurfaceFacts } from 'hgp';
import type { Cone } from '../../model/prescription';
import type { Analysis, OutputFile, Overlay, Surface } from '../../model/types';
import type { AnalysisRequest, CompareRequest, MapArrays } from './analyse';
import type { SurfaceArrays } from './placed_surface';

export interface SerializedBvh {
  roots: ArrayBuffer[];
  index: null;
  indirectBuffer: Uint32Array | Uint16Array | null;
}

export interface GeometryCalls {
  /** A surface as it is drawn, with what the solver knows of it; the worker keeps it under its id. */
  surface(
    id: number,
    arrays: SurfaceArrays,
    facts: SurfaceFacts,
    matrix: readonly number[],
  ): Surface;
  /** Everything about a map of a surface; what was lent comes back. */
  analyse(
    id: number,
    surface: number,
    request: AnalysisRequest,
  ): Promise<{ analysis: Analysis; preserved: string; map: MapArrays; files: OutputFile[] }>;
  /** Why a file does not hold a map, empty where it does. Nothing is lent. */
  compare(request: CompareRequest): Promise<{ difference: string }>;
  /** Relative names in a written .gltf, and the areas in uv and on the surface; both for writing. */
  urisOf(main: OutputFile): { uris: string[]; main: OutputFile };
  /** Several files as one; nothing is lent. */
  zip(files: OutputFile[]): { zip: Uint8Array };
  overlay(id: number, overlay: Overlay): Uint8Array;
  crosses(id: number, tiles: number, q: number): { onSurface: Float32Array; inMap: Float32Array };
  /** A small picture of a surface, with its map where one is named. */
  thumbnail(surface: number, map?: number, tiles?: number): Uint8ClampedArray<ArrayBuffer>;
  /** The same of a mesh that the worker does not keep. */
  thumbnailOf(arrays: SurfaceArrays, matrix: readonly number[]): Uint8ClampedArray<ArrayBuffer>;
  /** Lines along the loops of the solver: two vertices for each edge that they cross. */
  loopSegments(surface: number, loops: Uint32Array[]): Float32Array[];
  /** For picking: over the triangles of a surface, or of the flat map. */
  surfaceBvh(surface: number): SerializedBvh;
  mapBvh(id: number): SerializedBvh;
  balance(surface: number, q: number, cones: readonly Cone[], left: [number, number][]): Cone[];
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

/** The buffers of all typed arrays in a value: they move instead of being copied. */
export function buffersIn(value: unknown, found = new Set<ArrayBuffer>()): Set<ArrayBuffer> {
  if (value instanceof ArrayBuffer) found.add(value);
  else if (ArrayBuffer.isView(value)) found.add(value.buffer as ArrayBuffer);
  else if (typeof value === 'object' && value !== null) {
    for (const part of Object.values(value)) buffersIn(part, found);
  }
  return found;
}
