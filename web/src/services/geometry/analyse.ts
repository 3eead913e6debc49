// Computes what the page shows about a map, from the written file and from the certified
// numbers. Runs in the geometry worker.

import type { Measures, Result } from 'hgp';
import { isGltf, objectsIn, parseGltf } from '../../formats/glb';
import { summarizePreserved } from '../../formats/preserved_content';
import { readUv, type MeshoptDecoder } from '../../formats/read_uv';
import type { Analysis, Corners, OutputFile, Surface } from '../../model/types';
import { boxOf, smallestArea, quantilesOf } from './distortion';
import { forEachIndex } from './loops';
import { triangulatedLike } from './polygon_corners';

import { distanceToSeams } from './seam_distance';
import { sizesOf, weightsOf } from './sizes';

export type MapArrays = Pick<
  Result,
  'positions' | 'triangles' | 'uv' | 'cornerToUv' | 'uvToVertex' | 'seams'
>;

export interface AnalysisRequest {
  map: MapArrays;
  /** Measurements of the map by the solver. */
  measures: Measures;
  /** The written files and those to which they refer, the main file first. */
  files: OutputFile[];
  mesh: number;
  uvSet?: number;
}

export type CompareRequest = Omit<AnalysisRequest, 'measures'>;

/** Values per triangle and per vertex from which overlays are coloured. */
export interface FaceValues extends Pick<Measures, 'stretch' | 'area' | 'flipped'> {
  /** The absolute value of `area`. */
  areaSize: Float32Array;
  seamDistance: Float32Array;
}

export type Analysed = Omit<Analysis, 'id'> & { preserved: string };

function cornersOf({ positions, triangles, uv, cornerToUv }: MapArrays): Corners {
  const out = {
    positions: new Float64Array(3 * triangles.length),
    uv: new Float64Array(2 * triangles.length),
  };
  forEachIndex(triangles.length, (c) => {
    for (let i = 0; i < 3; i++) out.positions[3 * c + i] = positions[3 * triangles[c] + i];
    for (let i = 0; i < 2; i++) out.uv[2 * c + i] = uv[2 * cornerToUv[c] + i];
  });
  return out;
}

const slack = 2e-6; // relative to the largest number, for float32 positions and 1 − v

/** The difference between two sets of corners, in words; empty if they are equal. */
export function differenceOf(file: Corners, map: Corners): string {
  const far = (x: Float64Array, y: Float64Array): number => {
    let largest = 1;
    let apart = 0;
    for (let i = 0; i < x.length; i++) {
      largest = Math.max(largest, Math.abs(y[i]));
      const d = Math.abs(x[i] - y[i]);
      if (!(d <= apart)) apart = Number.isNaN(d) ? Infinity : d;
    }
    return apart / largest;
  };
  if (file.uv.length !== map.uv.length) {
    return `${file.uv.length / 6} triangles with the map are in the file, not ${map.uv.length / 6}`;
  }
  const uv = far(file.uv, map.uv);
  if (uv > slack) return `coordinates are off by ${uv.toExponential(1)} of their size`;
  const positions = far(file.positions, map.positions);
  return positions > slack ? `positions are off by ${positions.toExponential(1)}` : '';
}

/** The file's corners, and how they differ from those of the map; no corners if the file cannot be read. */
function readBack(
  { files, mesh, uvSet }: CompareRequest,
  map: Corners,
  decoder: MeshoptDecoder | undefined,
): [string, Corners?] {
  try {
    const read = triangulatedLike(readUv(files, mesh, uvSet, decoder), map);
    if (!read) return ['its polygons are not those that were solved'];
    return [differenceOf(read, map), read];
  } catch (error) {
    return [`the written file cannot be read back: ${(error as Error).message}`];
  }
}

/** How the map in a file differs from the given one; empty if it does not. */
export const compareWithFile = (
  request: CompareRequest,
  decoder: MeshoptDecoder | undefined,
): string => readBack(request, cornersOf(request.map), decoder)[0];

type Edges = Pick<
  Surface,
  'neighbourStart' | 'neighbours' | 'vertexCount' | 'isBoundary' | 'representative'
>;

export function analyse(
  request: AnalysisRequest,
  edges: Edges,
  decoder?: MeshoptDecoder,
): { analysis: Analysed; values: FaceValues } {
  const { map, files } = request;
  const own = cornersOf(map);
  const [difference, read] = readBack(request, own, decoder);
  const isSameAsFile = difference === '';
  const cornerUv = Float32Array.from(isSameAsFile ? read!.uv : own.uv);
  const { overlaps, seamChains: chains, ...faces } = request.measures;
  const areaSize = faces.area.map(Math.abs);
  const surface = { ...edges, positions: map.positions };
  const seamDistance = distanceToSeams(surface, map.seams, map.uvToVertex);
  const { flipped, uvArea, surfaceArea } = faces;
  const weights = weightsOf({ flipped, triangles: map.triangles, positions: map.positions });
  const analysis: Analysed = {
    isSameAsFile,
    difference,
    cornerUv,
    distortion: {
      stretch: quantilesOf(faces.stretch, weights),
      area: quantilesOf(faces.area, weights),
      areaSize: quantilesOf(areaSize, weights),
      seamDistance: quantilesOf(seamDistance),
      flipped,
      uvArea,
      surfaceArea,
    },
    sizes: sizesOf({ ...faces, triangles: map.triangles, positions: map.positions }, edges),
    // From the file's map if it could be read.
    smallestArea: smallestArea(read && read.uv.length === own.uv.length ? read.uv : own.uv),
    overlaps,
    chains,
    box: boxOf(map.uv),
    preserved: isGltf(files[0].name) ? summarizePreserved(parseGltf(files[0])) : '',
  };
  return { analysis, values: { ...faces, areaSize, seamDistance } };
}

/** The URIs of other files in a written .gltf. */
export function urisOf(main: OutputFile): string[] {
  if (!/\.gltf$/i.test(main.name)) return [];
  const { buffers, images } = parseGltf(main);
  return [...objectsIn(buffers), ...objectsIn(images)].flatMap(({ uri }) =>
    typeof uri === 'string' && !uri.startsWith('data:') ? [uri] : [],
  );
}
