// The worker for lengthy computations other than solving: facts for the panels, comparison with the written file,
// colours, crosses, and trees for picking.

import { zipSync } from 'fflate';
import { BufferAttribute, BufferGeometry } from 'three';
import { MeshBVH } from 'three-mesh-bvh';
import type { SerializedBvh } from '../model/scene';
import type { Analysis, OutputFile, Surface } from '../model/types';
import { isMeshoptUsed, type MeshoptDecoder } from '../formats/read_uv';
import { analyse, compareWithFile, urisOf, type FaceValues } from './geometry/analyse';
import { creaseNormals } from './geometry/crease_normals';
import { flatCrosses, surfaceCrosses } from './geometry/cross_lines';
import { flatPositions } from './geometry/flat_positions';
import { loopSegments } from './geometry/handle_loops';
import { mirrorImages } from './geometry/mirror_images';
import { Mirror } from './geometry/mirror_plane';
import { overlayColours } from './geometry/overlay_colours';
import { poissonSamples, spacingOf, type Sample } from './geometry/poisson_samples';
import { buffersIn, type GeometryCalls, type GeometryMessage } from './geometry/protocol';
import {
  locatedSurface,
  movedBy,
  normalsOf,
  placed,
  type SurfaceArrays,
} from './geometry/placed_surface';
import { drawThumbnail } from './geometry/thumbnail';

interface KnownMap {
  surface: number;
  triangles: Uint32Array;
  cornerUv: Float32Array;
  distortion: Analysis['distortion'];
  values: FaceValues;
}

/** What is kept of a surface: the arrays from which calls compute. */
type Kept = Pick<
  Surface,
  | 'positions'
  | 'places'
  | 'triangles'
  | 'vertexCount'
  | 'representative'
  | 'isBoundary'
  | 'neighbourStart'
  | 'neighbours'
  | 'radius'
  | 'diagonal'
>;

const surfaces = new Map<number, Kept>();
const maps = new Map<number, KnownMap>();
const mirrors = new WeakMap<Kept, Mirror>();
/** Those of one surface; they go with it. */
let lastSamples = new WeakMap<Kept, { spacing: number; samples: Sample[] }>();

function surfaceOf(id: number): Kept {
  const found = surfaces.get(id);
  if (!found) throw new Error('this surface is not known any more');
  return found;
}
function mapOf(id: number): KnownMap {
  const found = maps.get(id);
  if (!found) throw new Error('this map is not known any more');
  return found;
}

/** Copies of a surface's arrays, which stay here while the page gets its own. */
function kept({ positions, places, triangles, ...rest }: Omit<Kept, 'id'>): Kept {
  const own = positions.slice();
  const { vertexCount, radius, diagonal } = rest;
  return {
    positions: own,
    places: places === positions ? own : places.slice(),
    triangles: triangles.slice(),
    representative: rest.representative.slice(),
    isBoundary: rest.isBoundary.slice(),
    neighbourStart: rest.neighbourStart.slice(),
    neighbours: rest.neighbours.slice(),
    vertexCount,
    radius,
    diagonal,
  };
}

const isSame = (a: ArrayLike<number>, b: ArrayLike<number>): boolean => {
  if (a.length !== b.length) return false;
  for (let i = 0; i < a.length; i++) if (!Object.is(a[i], b[i])) return false;
  return true;
};

function cornersOf(values: ArrayLike<number>, triangles: Uint32Array): Float32Array {
  const out = new Float32Array(3 * triangles.length);
  for (let c = 0; c < triangles.length; c++) {
    const v = 3 * triangles[c];
    out[3 * c] = values[v];
    out[3 * c + 1] = values[v + 1];
    out[3 * c + 2] = values[v + 2];
  }
  return out;
}

/** Four bytes per vertex. */
function packed(normals: Float32Array): Int8Array {
  const out = new Int8Array((normals.length / 3) * 4);
  for (let v = 0; v < normals.length / 3; v++) {
    for (let i = 0; i < 3; i++) out[4 * v + i] = Math.round(127 * normals[3 * v + i]);
  }
  return out;
}

/** Normals along creases, packed. */
function creasesOf(
  { positions, triangles, repaired }: SurfaceArrays,
  normals: Float32Array,
): Pick<Surface, 'creaseCorners' | 'creaseNormals'> {
  const shaded = { positions, triangles, normals, joined: repaired?.vertexImage };
  const found = creaseNormals(shaded);
  return { creaseCorners: found.corners, creaseNormals: packed(found.normals) };
}

/** Four bytes for each corner. */
function packedAtCorners(arrays: SurfaceArrays): Int8Array {
  const { triangles } = arrays;
  const normals = normalsOf(arrays);
  const atVertices = new Int32Array(packed(normals).buffer);
  const words = Int32Array.from(triangles, (v) => atVertices[v]);
  const { creaseCorners, creaseNormals } = creasesOf(arrays, normals);
  const own = new Int32Array(creaseNormals.buffer);
  creaseCorners.forEach((c, i) => (words[c] = own[i]));
  return new Int8Array(words.buffer);
}

const samplesOn = ({ places: positions, triangles }: Kept, spacing: number): Sample[] =>
  poissonSamples({ positions, triangles }, spacing);

function samplesOf(surface: Kept, spacing: number): Sample[] {
  const known = lastSamples.get(surface);
  if (known?.spacing === spacing) return known.samples;
  const samples = samplesOn(surface, spacing);
  lastSamples = new WeakMap([[surface, { spacing, samples }]]);
  return samples;
}

/** A tree over triangles; without `triangles`, three positions are one. */
function bvhOf(positions: Float32Array | Float64Array, triangles?: Uint32Array): SerializedBvh {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  if (triangles) geometry.setIndex(new BufferAttribute(triangles, 1));
  const bvh = new MeshBVH(geometry, { indirect: true, targetLeafSize: 10 });
  const serialized = MeshBVH.serialize(bvh, { cloneBuffers: false }) as unknown as SerializedBvh;
  return { ...serialized, index: null }; // what is answered is given away, and the surface needs its triangles
}

/** The decoder for a file, loaded when the first file needs it. */
async function decoderFor(main: OutputFile): Promise<MeshoptDecoder | undefined> {
  if (!isMeshoptUsed(main)) return undefined;
  const { MeshoptDecoder: decoder } = await import('three/addons/libs/meshopt_decoder.module.js');
  await decoder.ready;
  return decoder;
}

const calls: GeometryCalls = {
  surface(id, arrays, facts, matrix) {
    const own = placed(locatedSurface(arrays, facts), matrix);
    surfaces.set(id, kept(own));
    const creases = creasesOf({ ...arrays, positions: own.places }, own.normals);
    return { id, ...own, packedNormals: packed(own.normals), ...creases };
  },
  async analyse(id, surface, request) {
    const { files } = request;
    const decoder = await decoderFor(files[0]);
    const known = surfaceOf(surface);
    const map = {
      ...request.map,
      positions: request.map.positions ?? known.positions,
      triangles: request.map.triangles ?? known.triangles,
    };
    const { analysis, values } = analyse({ ...request, map }, known, decoder);
    const { preserved, ...rest } = analysis;
    const hasPositions = isSame(map.positions, known.positions);
    const hasTriangles = isSame(map.triangles, known.triangles);
    maps.set(id, {
      surface,
      triangles: hasTriangles ? known.triangles : map.triangles.slice(),
      cornerUv: rest.cornerUv.slice(),
      distortion: rest.distortion,
      values: { ...values, flipped: values.flipped.slice() },
    });
    const lean = {
      ...map,
      positions: hasPositions ? undefined : map.positions,
      triangles: hasTriangles ? undefined : map.triangles,
    };
    return { analysis: { id, ...rest }, preserved, map: lean, files };
  },
  async compare(request) {
    return { difference: compareWithFile(request, await decoderFor(request.files[0])) };
  },
  urisOf: (main) => ({ uris: urisOf(main), main }),
  zip: (files) => ({ zip: zipSync(Object.fromEntries(files.map((f) => [f.name, f.bytes]))) }),
  overlay(id, overlay) {
    const { values, distortion, triangles } = mapOf(id);
    return overlayColours(overlay, values, distortion, triangles);
  },
  crosses(id, tiles, q) {
    const { surface: surfaceId, cornerUv, distortion } = mapOf(id);
    const surface = surfaceOf(surfaceId);
    const spacing = spacingOf(surface, tiles);
    const seen = (spacing * 2 * surface.radius) / surface.diagonal; // as displayed
    const samples = samplesOf(surface, seen);
    const arm = 0.42 * spacing * Math.sqrt(distortion.uvArea / distortion.surfaceArea);
    const { places: positions, triangles } = surface;
    const input = { positions, triangles, cornerUv, samples, arm, spacing: seen, q };
    return { onSurface: surfaceCrosses(input), inMap: flatCrosses(input) };
  },
  thumbnail(id, map, tiles) {
    const { places, triangles } = surfaceOf(id);
    const cornerPositions = cornersOf(places, triangles);
    const cornerUv = map === undefined ? undefined : maps.get(map)?.cornerUv;
    return drawThumbnail({ cornerPositions, cornerUv, tiles });
  },
  part(arrays, matrix) {
    const { positions, triangles } = arrays;
    const seen = cornersOf(movedBy(matrix, positions), triangles);
    const cornerPositions = cornersOf(positions, triangles);
    const cornerNormals = packedAtCorners(arrays);
    const shape = { cornerPositions, cornerNormals, tree: bvhOf(cornerPositions) };
    return { picture: drawThumbnail({ cornerPositions: seen }), shape };
  },
  loopSegments: (id, loops) => loops.map((loop) => loopSegments(surfaceOf(id), loop)),
  surfaceBvh(id) {
    const { places, triangles } = surfaceOf(id);
    return bvhOf(places, triangles);
  },
  mapBvh: (id) => bvhOf(flatPositions(mapOf(id).cornerUv)),
  opposite(id, vertex) {
    const surface = surfaceOf(id);
    const mirror = mirrors.get(surface) ?? new Mirror(surface);
    mirrors.set(surface, mirror);
    return { vertex: mirror.opposite(vertex), hasPlane: mirror.plane !== undefined };
  },
  images: (id, plane, distance) => mirrorImages(surfaceOf(id), plane, distance),
  forget(oldSurfaces, oldMaps) {
    for (const id of oldSurfaces) surfaces.delete(id);
    for (const id of oldMaps) maps.delete(id);
  },
};

/** Regular expressions keep the text in which they last found something: that of a file must not stay. */
const forgetText = (): boolean => /^/.test('');

async function answer(data: GeometryMessage): Promise<void> {
  const { call, method, args } = data;
  try {
    const result = await (calls[method] as (...all: unknown[]) => unknown)(...args);
    postMessage({ call, result }, { transfer: [...buffersIn(result)] });
  } catch (error) {
    postMessage({ call, error: (error as Error).message });
  }
  forgetText();
}

addEventListener('message', ({ data }: MessageEvent<GeometryMessage>) => void answer(data));
