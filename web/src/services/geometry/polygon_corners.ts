// Compares the polygons of a file with the solver's triangles, however it triangulated them: the corners of
// every triangle are found among those of its polygon.

import type { Corners } from '../../model/types';

/** The polygon corner that corresponds to a triangle corner: at the same position, with the nearest uv. */
function cornerOf(
  file: Corners,
  [first, count]: [number, number],
  map: Corners,
  corner: number,
): number {
  let best = -1;
  let smallest = [Infinity, Infinity];
  for (let i = 0; i < count; i++) {
    const far = (a: Float64Array, b: Float64Array, width: number): number => {
      let sum = 0;
      for (let k = 0; k < width; k++) {
        sum = Math.max(sum, Math.abs(a[width * (first + i) + k] - b[width * corner + k]));
      }
      return sum;
    };
    const place = far(file.positions, map.positions, 3);
    const uv = far(file.uv, map.uv, 2);
    if (place < smallest[0] || (place === smallest[0] && uv < smallest[1]))
      [best, smallest] = [i, [place, uv]];
  }
  return best;
}

/** Whether triangles cover a polygon: each side belongs to one of them, each diagonal to two. */
function coversPolygon(triples: number[][], ring: number[]): boolean {
  const sides = new Set<string>();
  for (const triple of triples) {
    if (new Set(triple).size < 3) continue; // degenerate, from a corner that occurs twice
    for (let k = 0; k < 3; k++) {
      const key = `${triple[k]} ${triple[(k + 1) % 3]}`;
      if (sides.has(key)) return false;
      sides.add(key);
    }
  }
  const around = ring.filter((i, at) => i !== ring[(at + 1) % ring.length]);
  const own = new Set(around.map((i, at) => `${i} ${around[(at + 1) % around.length]}`));
  if (![...own].every((key) => sides.has(key))) return sides.size === 0; // all of them are degenerate
  return [...sides].every((key) => own.has(key) || sides.has(key.split(' ').reverse().join(' ')));
}

/** For each corner of a polygon, the first one at the same position. */
function firstAtPlace({ positions }: Corners, first: number, count: number): number[] {
  const isSame = (i: number, j: number): boolean =>
    [0, 1, 2].every((k) => positions[3 * (first + i) + k] === positions[3 * (first + j) + k]);
  return Array.from({ length: count }, (_, i) => {
    for (let j = 0; j < i; j++) if (isSame(i, j)) return j;
    return i;
  });
}

/**
 * The file's corners arranged as the map's triangles; undefined if the triangles are not a triangulation of
 * the file's polygons.
 */
export function triangulatedLike(file: Corners, map: Corners): Corners | undefined {
  const { sizes } = file;
  if (!sizes) return file;
  if (sizes.reduce((sum, n) => sum + 3 * (n - 2), 0) !== map.uv.length / 2) return undefined;
  const out = {
    positions: new Float64Array(map.positions.length),
    uv: new Float64Array(map.uv.length),
  };
  let [first, corner] = [0, 0];
  for (const n of sizes) {
    const triples: number[][] = [];
    for (let t = 0; t < n - 2; t++) {
      const triple = [0, 1, 2].map((k) => cornerOf(file, [first, n], map, corner + k));
      triple.forEach((i, k) => {
        const [from, to] = [first + i, corner + k];
        out.positions.set(file.positions.subarray(3 * from, 3 * from + 3), 3 * to);
        out.uv.set(file.uv.subarray(2 * from, 2 * from + 2), 2 * to);
      });
      triples.push(triple);
      corner += 3;
    }
    const ring = firstAtPlace(file, first, n);
    const parts = triples.map((triple) => triple.map((i) => ring[i]));
    if (n > 3 && !coversPolygon(parts, ring)) return undefined;
    first += n;
  }
  return out;
}
