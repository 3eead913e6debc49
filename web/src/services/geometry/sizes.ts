// How the sizes of a map vary: the typical stretch and the spread of scales, as the verifier defines them, and the
// places where the pattern is much larger or smaller than elsewhere.

import type { SizePlaces, Sizes } from '../../model/measures';
import type { Surface } from '../../model/types';
import { randomSequence } from './random_sequence';
import { areaOf } from '../../model/triangle';

type Values = ArrayLike<number>;

/** The smallest value such that values up to it have the fraction `share` of all weight; the order of `ids` changes. */
export function weightedQuantile(
  ids: Uint32Array,
  values: Values,
  weights: Values,
  share: number,
): number {
  if (ids.length === 0) return 0;
  let rest = 0;
  for (const i of ids) rest += share * weights[i];
  let [first, last] = [0, ids.length];
  // Anywhere: values that fall and rise again, as those of a symmetric surface may, have their largest ones at fixed places.
  const random = randomSequence(5);
  const any = (): number => values[ids[first + Math.floor(random() * (last - first))]];
  while (last - first > 1) {
    const [x, y, z] = [any(), any(), any()];
    const pivot = Math.max(Math.min(x, y), Math.min(Math.max(x, y), z));
    // Three parts: below the pivot, equal to it, above it.
    let [low, at, high] = [first, first, last];
    let [below, equal] = [0, 0];
    while (at < high) {
      const id = ids[at];
      if (values[id] < pivot) {
        below += weights[id];
        [ids[at++], ids[low]] = [ids[low], id];
        low += 1;
      } else if (values[id] > pivot) {
        high -= 1;
        [ids[at], ids[high]] = [ids[high], id];
      } else {
        equal += weights[id];
        at += 1;
      }
    }
    if (low > first && below >= rest) last = low;
    else if (high === last || below + equal >= rest) return pivot;
    else {
      rest -= below + equal;
      first = high;
    }
  }
  return values[ids[first]];
}

export interface FaceSizes {
  triangles: Uint32Array;
  positions: Float64Array;
  /** σ₁/σ₂ of each triangle. */
  stretch: Values;
  /** log₂ of uv area per surface area of each, at the best global scale. */
  area: Values;
  flipped: Uint32Array;
  /** uv area and surface area of all. */
  uvArea: number;
  surfaceArea: number;
}

type Around = Pick<
  Surface,
  'neighbourStart' | 'neighbours' | 'isBoundary' | 'representative' | 'vertexCount'
>;

/** Within a factor √10 of the typical scale sizes do not stand out. */
const apart = Math.log2(10);
const maxShown = 2000; // triangles
const maxPlaces = 8;
const minVertices = 3; // of a place: fewer are one odd triangle

/** The areas of the triangles; 0 for those that are not positive in the map. */
export function weightsOf(
  faces: Pick<FaceSizes, 'triangles' | 'positions' | 'flipped'>,
): Float64Array {
  const weights = new Float64Array(faces.triangles.length / 3);
  for (let t = 0; t < weights.length; t++) weights[t] = areaOf(faces, t);
  for (const t of faces.flipped) weights[t] = 0; // not measured
  return weights;
}

/** The mean of `area` over the triangles at each vertex of the surface; NaN where there are none. */
function atVertices(
  { triangles, area }: FaceSizes,
  weights: Float64Array,
  { representative, vertexCount }: Around,
): Float64Array {
  const sums = new Float64Array(vertexCount);
  const total = new Float64Array(vertexCount);
  for (let c = 0; c < triangles.length; c++) {
    const v = representative[triangles[c]];
    const t = (c - (c % 3)) / 3;
    if (v < 0 || !(weights[t] > 0)) continue;
    sums[v] += weights[t] * area[t];
    total[v] += weights[t];
  }
  return sums.map((sum, v) => sum / total[v]);
}

/** The connected places where `sign` times the values exceeds a bound: the most extreme vertex inside each. */
function extremes(
  values: Float64Array,
  { sign, bound }: { sign: 1 | -1; bound: number },
  { neighbourStart, neighbours, isBoundary }: Around,
): number[] {
  const isIn = (v: number): boolean => sign * values[v] > bound;
  const seen = new Uint8Array(values.length);
  const found: { vertex: number; count: number }[] = [];
  for (let start = 0; start < values.length; start++) {
    if (seen[start] || !isIn(start)) continue;
    seen[start] = 1;
    const open = [start];
    let best = -1;
    for (const v of open) {
      if (!isBoundary[v] && (best < 0 || sign * values[v] > sign * values[best])) best = v;
      for (let n = neighbourStart[v]; n < neighbourStart[v + 1]; n++) {
        const w = neighbours[n];
        if (seen[w] || !isIn(w)) continue;
        seen[w] = 1;
        open.push(w);
      }
    }
    if (best >= 0 && open.length >= minVertices) found.push({ vertex: best, count: open.length });
  }
  found.sort((a, b) => b.count - a.count || a.vertex - b.vertex);
  return found.slice(0, maxPlaces).map(({ vertex }) => vertex);
}

export function sizesOf(faces: FaceSizes, around: Around): Sizes {
  const weights = weightsOf(faces);
  const ids = Uint32Array.from(weights.keys()).filter((t) => weights[t] > 0);
  const { stretch, area } = faces;
  const at = (share: number): number => weightedQuantile(ids, area, weights, share);
  const middle = at(0.5);
  const total = weights.reduce((sum, x) => sum + x, 0) || 1;
  const values = atVertices(faces, weights, around);
  const places = (sign: 1 | -1): SizePlaces => {
    const bound = sign * middle + apart;
    const inside = ids.filter((t) => sign * area[t] > bound);
    let share = 0;
    for (const t of inside) share += weights[t] / total;
    const triangles = inside.sort((a, b) => sign * (area[b] - area[a])).slice(0, maxShown);
    return { share, triangles, vertices: extremes(values, { sign, bound }, around) };
  };
  // `area` is relative to the mean of logarithms; the same mean of scales gives the typical one in uv per length.
  let mean = 0;
  for (const t of ids) mean += (weights[t] / total) * 2 ** area[t];
  return {
    typicalStretch: weightedQuantile(ids, stretch, weights, 0.5),
    spread: 2 ** ((at(0.95) - at(0.05)) / 2),
    range: 2 ** ((at(0.99) - at(0.01)) / 2),
    typicalScale: Math.sqrt((2 ** middle / (mean || 1)) * (faces.uvArea / faces.surfaceArea)),
    larger: places(-1), // a smaller area in the map shows the pattern larger
    smaller: places(1),
  };
}
