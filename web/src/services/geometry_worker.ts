// The worker for lengthy computations other than solving: facts for the panels, comparison with the written file,
// colours, crosses, and trees for picking.

import { zipSync } from 'fflate';
import { BufferAttribute, BufferGeometry } from 'three';
import { MeshBVH } from 'three-mesh-bvh';
import { isGltf } from '../formats/glb';
import type { SerializedBvh } from '../model/scene';
import type { Analysis, OutputFile, Surface } from '../model/types';
import { isMeshoptUsed, type MeshoptDecoder } from '../formats/read_uv';
import { analyse, compareWithFile, urisOf, type FaceValues } from './geometry/analyse';
import { flatCrosses, surfaceCrosses } from './geometry/cross_lines';
import { loopSegments } from './geometry/handle_loops';
import { Mirror } from './geometry/mirror_plane';
import { overlayColours } from './geometry/overlay_colours';
import { poissonSamples, spacingOf, type Sample } from './geometry/poisson_samples';
import { buffersIn, type GeometryCalls, type GeometryMessage } from './geometry/protocol';
import { locatedSurface, movedBy, normalsOf, placed } from './geometry/placed_surface';
import { drawThumbnail } from './geometry/thumbnail';

interface KnownMap {
  surface: number;
  triangles: Uint32Array;
  cornerUv: Float32Array;
  flatPositions: Float32Array;
  distortion: Analysis['distortion'];
  values: FaceValues;
}

const surfaces = new Map<number, Surface>();
const maps = new Map<number, KnownMap>();
const mirrors = new WeakMap<Surface, Mirror>();
let lastSamples: { surface: number; spacing: number; samples: Sample[] } | undefined;

function surfaceOf(id: number): Surface {
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
const copied = (surface: Surface): Surface =>
  Object.fromEntries(
    Object.entries(surface).map(([key, value]) => [
      key,
      ArrayBuffer.isView(value) ? (value as Float32Array).slice() : value,
    ]),
  ) as unknown as Surface;

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

function packedNormals(normals: Float32Array, triangles: Uint32Array): Int8Array {
  const out = new Int8Array(4 * triangles.length);
  for (let c = 0; c < triangles.length; c++) {
    const v = 3 * triangles[c];
    for (let i = 0; i < 3; i++) out[4 * c + i] = Math.round(127 * normals[v + i]);
  }
  return out;
}

const samplesOn = ({ places: positions, triangles }: Surface, spacing: number): Sample[] =>
  poissonSamples({ positions, triangles }, spacing);

function samplesOf(id: number, spacing: number): Sample[] {
  if (lastSamples?.surface !== id || lastSamples.spacing !== spacing) {
    lastSamples = { surface: id, spacing, samples: samplesOn(surfaceOf(id), spacing) };
  }
  return lastSamples.samples;
}

function bvhOf(positions: Float32Array): SerializedBvh {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  const bvh = new MeshBVH(geometry, { indirect: true, targetLeafSize: 10 });
  return MeshBVH.serialize(bvh, { cloneBuffers: false }) as unknown as SerializedBvh;
}

/** The decoder for a file, loaded when the first file needs it. */
async function decoderFor(main: OutputFile): Promise<MeshoptDecoder | undefined> {
  if (!isGltf(main.name) || !isMeshoptUsed(main)) return undefined;
  const { MeshoptDecoder: decoder } = await import('three/addons/libs/meshopt_decoder.module.js');
  await decoder.ready;
  return decoder;
}

const calls: GeometryCalls = {
  surface(id, arrays, facts, matrix) {
    const own = placed(locatedSurface(arrays, facts), matrix);
    const cornerPositions = cornersOf(own.places, own.triangles);
    const cornerNormals = packedNormals(own.normals, own.triangles);
    const surface = { id, ...own, cornerPositions, cornerNormals };
    surfaces.set(id, copied({ ...surface, cornerNormals: new Int8Array(0) }));
    return surface;
  },
  async analyse(id, surface, request) {
    const { map, files } = request;
    const decoder = await decoderFor(files[0]);
    const { analysis, values } = analyse(request, surfaceOf(surface), decoder);
    const { preserved, ...rest } = analysis;
    maps.set(id, {
      surface,
      triangles: map.triangles.slice(),
      cornerUv: rest.cornerUv.slice(),
      flatPositions: rest.flatPositions.slice(),
      distortion: rest.distortion,
      values: { ...values, flipped: values.flipped.slice() },
    });
    return { analysis: { id, ...rest }, preserved, map, files };
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
    const samples = samplesOf(surfaceId, seen);
    const arm = 0.42 * spacing * Math.sqrt(distortion.uvArea / distortion.surfaceArea);
    const { places: positions, triangles } = surface;
    const input = { positions, triangles, cornerUv, samples, arm, spacing: seen, q };
    return { onSurface: surfaceCrosses(input), inMap: flatCrosses(input) };
  },
  thumbnail(id, map, tiles) {
    const { cornerPositions } = surfaceOf(id);
    const cornerUv = map === undefined ? undefined : maps.get(map)?.cornerUv;
    return drawThumbnail({ cornerPositions, cornerUv, tiles });
  },
  part(arrays, matrix) {
    const { positions, triangles } = arrays;
    const seen = cornersOf(movedBy(matrix, positions), triangles);
    const cornerPositions = cornersOf(positions, triangles);
    const cornerNormals = packedNormals(normalsOf(arrays), triangles);
    const shape = { cornerPositions, cornerNormals, tree: bvhOf(cornerPositions) };
    return { picture: drawThumbnail({ cornerPositions: seen }), shape };
  },
  loopSegments: (id, loops) => loops.map((loop) => loopSegments(surfaceOf(id), loop)),
  surfaceBvh: (id) => bvhOf(surfaceOf(id).cornerPositions),
  mapBvh: (id) => bvhOf(mapOf(id).flatPositions),
  opposite(id, vertex) {
    const surface = surfaceOf(id);
    const mirror = mirrors.get(surface) ?? new Mirror(surface);
    mirrors.set(surface, mirror);
    return { vertex: mirror.opposite(vertex), hasPlane: mirror.plane !== undefined };
  },
  forget(oldSurfaces, oldMaps) {
    for (const id of oldSurfaces) surfaces.delete(id);
    for (const id of oldMaps) maps.delete(id);
    if (lastSamples && !surfaces.has(lastSamples.surface)) lastSamples = undefined;
  },
};

async function answer(data: GeometryMessage): Promise<void> {
  const { call, method, args } = data;
  try {
    const result = await (calls[method] as (...all: unknown[]) => unknown)(...args);
    postMessage({ call, result }, { transfer: [...buffersIn(result)] });
  } catch (error) {
    postMessage({ call, error: (error as Error).message });
  }
}

addEventListener('message', ({ data }: MessageEvent<GeometryMessage>) => void answer(data));
