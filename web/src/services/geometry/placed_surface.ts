// The loaded surface for display: normals, a bounding sphere, and the placement by a node of the scene. Facts about
// its vertices come from the solver.

import type { Surface as Arrays, SurfaceFacts } from 'hgp';
import type { Surface } from '../../model/types';
import { forEachIndex } from './loops';
import { areaVector } from '../../model/triangle';

export type SurfaceArrays = Arrays;

/** The surface in the coordinates of its mesh. */
type Located = Omit<
  Surface,
  'id' | 'places' | 'isMirrored' | 'packedNormals' | 'creaseCorners' | 'creaseNormals'
>;

/** Vertex normals: area-weighted means over the triangles at each vertex. */
function vertexNormals(p: Float64Array, triangles: Uint32Array): Float32Array {
  const sums = new Float64Array(p.length);
  const normal = new Float64Array(3);
  forEachIndex(triangles.length / 3, (t) => {
    const corners = triangles.subarray(3 * t, 3 * t + 3);
    areaVector(p, 3 * corners[0], 3 * corners[1], 3 * corners[2], normal);
    for (const v of corners) for (let i = 0; i < 3; i++) sums[3 * v + i] += normal[i];
  });
  const normals = new Float32Array(p.length);
  forEachIndex(p.length / 3, (i) => {
    const v = 3 * i;
    const length = Math.sqrt(sums[v] ** 2 + sums[v + 1] ** 2 + sums[v + 2] ** 2) || 1;
    for (let k = 0; k < 3; k++) normals[v + k] = sums[v + k] / length;
  });
  return normals;
}

/** Normals of the surface as it is solved, whose triangles are oriented consistently. */
export function normalsOf({ positions, triangles, repaired }: SurfaceArrays): Float32Array {
  if (!repaired) return vertexNormals(positions, triangles);
  const { vertexOrigin, vertexImage } = repaired;
  const moved = new Float64Array(3 * vertexOrigin.length);
  vertexOrigin.forEach((v, m) => moved.set(positions.subarray(3 * v, 3 * v + 3), 3 * m));
  const normals = vertexNormals(moved, repaired.triangles);
  const own = new Float32Array(positions.length);
  vertexImage.forEach((m, v) => {
    if (m >= 0) own.set(normals.subarray(3 * m, 3 * m + 3), 3 * v);
  });
  return own;
}

function ballOf(p: Float64Array): Pick<Surface, 'center' | 'radius' | 'diagonal'> {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  forEachIndex(p.length / 3, (v) => {
    for (let k = 0; k < 3; k++) {
      const x = p[3 * v + k];
      if (!Number.isFinite(x)) continue;
      if (x < low[k]) low[k] = x;
      if (x > high[k]) high[k] = x;
    }
  });
  const center = low.map((x, k) => (x + high[k]) / 2) as [number, number, number];
  let max = 0;
  forEachIndex(p.length / 3, (v) => {
    const far =
      (p[3 * v] - center[0]) ** 2 +
      (p[3 * v + 1] - center[1]) ** 2 +
      (p[3 * v + 2] - center[2]) ** 2;
    if (far > max && far < Infinity) max = far;
  });
  const diagonal = Math.hypot(...high.map((x, k) => x - low[k])) || 1;
  return { center, diagonal, radius: Math.sqrt(max) || diagonal / 2 };
}

export function locatedSurface(arrays: SurfaceArrays, facts: SurfaceFacts): Located {
  const { positions, triangles } = arrays;
  const vertexCount = positions.length / 3;
  return {
    positions,
    triangles,
    vertexCount,
    normals: normalsOf(arrays),
    ...ballOf(positions),
    ...facts,
  };
}

/** A matrix by columns, as in three.js and glTF. */
type Matrix = readonly number[];

/** Transforms points or, with `w` = 0, directions. */
function moved(
  m: Matrix,
  from: ArrayLike<number>,
  out: Float64Array | Float32Array,
  w: 0 | 1,
): void {
  for (let v = 0; v < from.length; v += 3) {
    const [x, y, z] = [from[v], from[v + 1], from[v + 2]];
    for (let i = 0; i < 3; i++) out[v + i] = m[i] * x + m[4 + i] * y + m[8 + i] * z + w * m[12 + i];
  }
}

export function movedBy(matrix: Matrix, positions: Float64Array): Float64Array {
  const out = new Float64Array(positions.length);
  moved(matrix, positions, out, 1);
  return out;
}

/** The inverse transpose of the linear part up to scale, which transforms normals. */
function normalMatrix(m: Matrix): { matrix: number[]; sign: number } {
  const column = (i: number): number[] => [m[4 * i], m[4 * i + 1], m[4 * i + 2]];
  const cross = ([a, b, c]: number[], [x, y, z]: number[]): number[] => [
    b * z - c * y,
    c * x - a * z,
    a * y - b * x,
  ];
  const [a, b, c] = [column(0), column(1), column(2)];
  const [x, y, z] = [cross(b, c), cross(c, a), cross(a, b)];
  const sign = Math.sign(a[0] * x[0] + a[1] * x[1] + a[2] * x[2]) || 1;
  const matrix = [x, y, z].flatMap((one) => [...one.map((value) => sign * value), 0]);
  return { matrix, sign };
}

function unit(values: Float32Array): void {
  for (let v = 0; v < values.length; v += 3) {
    const length = Math.hypot(values[v], values[v + 1], values[v + 2]) || 1;
    for (let i = 0; i < 3; i++) values[v + i] /= length;
  }
}

/** The same surface as placed by a node of the scene. */
export function placed(
  surface: Located,
  matrix: Matrix,
): Located & Pick<Surface, 'places' | 'isMirrored'> {
  const isThere = matrix.every((x, i) => x === (i % 5 === 0 ? 1 : 0));
  if (isThere) return { ...surface, places: surface.positions, isMirrored: false };
  const places = movedBy(matrix, surface.positions);
  const turned = normalMatrix(matrix);
  const normals = new Float32Array(surface.normals.length);
  moved([...turned.matrix, 0, 0, 0, 1], surface.normals, normals, 0);
  unit(normals);
  const { center, radius } = ballOf(places);
  return { ...surface, places, normals, center, radius, isMirrored: turned.sign < 0 };
}
