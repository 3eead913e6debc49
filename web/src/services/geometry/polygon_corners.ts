// Polygons of a file beside the triangles that the solver made of them, in whatever way: the corners of
// every triangle are found among those of its polygon.

import type { Corners } from '../../formats/read_uv';

/** The corner of a polygon that a corner of a triangle is: the same place, and of those the nearest uv. */
function cornerOf(
  file: Corners,
  [first, count]: [number, number],
  map: Corners,
  corner: number,
): number {
  let best = -1;
  let least = [Infinity, Infinity];
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
    if (place < least[0] || (place === least[0] && uv < least[1])) [best, least] = [i, [place, uv]];
  }
  return best;
}

/** Whether triangles over n corners cover a polygon: each side is a side of one of them, each diagonal of two. */
function coversPolygon(triples: number[][], n: number): boolean {
  const sides = new Set<string>();
  for (const triple of triples) {
    for (let k = 0; k < 3; k++) {
      const [a, b] = [triple[k], triple[(k + 1) % 3]];
      const key = `${a} ${b}`;
      if (a === b || sides.has(key)) return false;
      sides.add(key);
    }
  }
  for (let i = 0; i < n; i++) if (!sides.has(`${i} ${(i + 1) % n}`)) return false;
  return [...sides].every((key) => {
    const [a, b] = key.split(' ').map(Number);
    return b === (a + 1) % n || sides.has(`${b} ${a}`);
  });
}

/**
 * The file's corners in the triangles of the map; undefined where its polygons are not those that the
 * triangles are parts of.
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
    if (n > 3 && !coversPolygon(triples, n)) return undefined;
    first += n;
  }
  return out;
}
