// The loaded surface with what picking, walking and the budget need to know about it. Vertex ids are
// those of the file; what is known about them is what welds and repairs made
// of them, for that is what is solved.

import type { Surface } from '../../model/types';
import { edgesOf, componentsOf } from './adjacency';
import { forEachIndex } from './loops';
import { areaVector, lengthOf } from './triangle';

export interface SurfaceArrays {
  positions: Float64Array;
  triangles: Uint32Array;
  repaired?: {
    triangles: Uint32Array;
    vertexOrigin: Int32Array;
    vertexImage: Int32Array;
  };
}

/** Facts of the surface as it is in the file. */
type SurfaceFacts = Omit<
  Surface,
  'id' | 'places' | 'isMirrored' | 'cornerPositions' | 'cornerNormals'
>;
type Mesh = Pick<Surface, 'positions' | 'triangles' | 'vertexCount'>;
type Facts = Pick<
  Surface,
  'valence' | 'isBoundary' | 'component' | 'angle' | 'starts' | 'neighbours' | 'normals' | 'area'
>;

/** Angle at a, where `area` is twice the area of the triangle. */
function cornerAngle(p: Float64Array, a: number, b: number, c: number, area: number): number {
  const x = (p[b] - p[a]) * (p[c] - p[a]);
  const y = (p[b + 1] - p[a + 1]) * (p[c + 1] - p[a + 1]);
  const z = (p[b + 2] - p[a + 2]) * (p[c + 2] - p[a + 2]);
  return Math.atan2(area, x + y + z);
}

function shapeOf({
  positions: p,
  triangles,
  vertexCount,
}: Mesh): Pick<Facts, 'valence' | 'angle' | 'normals' | 'area'> {
  const valence = new Uint16Array(vertexCount);
  const angle = new Float64Array(vertexCount);
  const sums = new Float64Array(p.length);
  const normal = new Float64Array(3);
  let twice = 0;
  forEachIndex(triangles.length / 3, (t) => {
    const a = 3 * triangles[3 * t];
    const b = 3 * triangles[3 * t + 1];
    const c = 3 * triangles[3 * t + 2];
    areaVector(p, a, b, c, normal);
    for (let k = 0; k < 3; k++) {
      const v = triangles[3 * t + k];
      for (let i = 0; i < 3; i++) sums[3 * v + i] += normal[i];
      valence[v] += 1;
    }
    const area = lengthOf(normal);
    if (Number.isFinite(area)) twice += area;
    angle[a / 3] += cornerAngle(p, a, b, c, area);
    angle[b / 3] += cornerAngle(p, b, c, a, area);
    angle[c / 3] += cornerAngle(p, c, a, b, area);
  });
  const normals = new Float32Array(p.length);
  forEachIndex(vertexCount, (i) => {
    const v = 3 * i;
    const length = Math.sqrt(sums[v] ** 2 + sums[v + 1] ** 2 + sums[v + 2] ** 2) || 1;
    for (let k = 0; k < 3; k++) normals[v + k] = sums[v + k] / length;
  });
  return { valence, angle, normals, area: twice / 2 };
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
  let most = 0;
  forEachIndex(p.length / 3, (v) => {
    const far =
      (p[3 * v] - center[0]) ** 2 +
      (p[3 * v + 1] - center[1]) ** 2 +
      (p[3 * v + 2] - center[2]) ** 2;
    if (far > most) most = far;
  });
  const diagonal = Math.hypot(...high.map((x, k) => x - low[k])) || 1;
  return { center, diagonal, radius: Math.sqrt(most) || diagonal / 2 };
}

function factsOf(mesh: Mesh): Facts {
  const { valence, angle, normals, area } = shapeOf(mesh);
  const { starts, neighbours, isBoundary } = edgesOf(mesh.triangles, mesh.vertexCount);
  const component = componentsOf(mesh.triangles, mesh.vertexCount);
  return { valence, angle, normals, area, starts, neighbours, isBoundary, component };
}

/** Which component each triangle of the file belongs to, where one of its vertices became several. */
function splitComponents(
  triangles: Uint32Array,
  { triangles: repaired, vertexOrigin, vertexImage }: Required<SurfaceArrays>['repaired'],
  component: Int32Array,
): Int32Array {
  const copies = new Uint8Array(vertexImage.length);
  let isAny = false;
  for (const v of vertexOrigin) {
    isAny ||= copies[v] > 0;
    copies[v] = Math.min(copies[v] + 1, 2);
  }
  if (!isAny) return new Int32Array(0);
  const isSplit = (v: number): boolean => copies[v] > 1;
  const keyOf = (corners: number[]): string => corners.sort((a, b) => a - b).join(' ');
  const found = new Map<string, number>();
  for (let t = 0; t < repaired.length; t += 3) {
    const corners = Array.from(repaired.subarray(t, t + 3), (m) => vertexOrigin[m]);
    if (corners.some(isSplit)) found.set(keyOf(corners), component[repaired[t]]);
  }
  return Int32Array.from({ length: triangles.length / 3 }, (_, t) => {
    const corners = Array.from(triangles.subarray(3 * t, 3 * t + 3));
    return corners.some(isSplit) ? (found.get(keyOf(corners)) ?? -1) : -1;
  });
}

/** What is known about a repaired mesh, said of the vertices of the file. */
function pulledBack(
  { valence, angle, normals, area, starts, neighbours, isBoundary, component }: Facts,
  { vertexOrigin, vertexImage }: Required<SurfaceArrays>['repaired'],
): Facts & Pick<Surface, 'meaning'> {
  const count = vertexImage.length;
  const own: Facts = {
    area,
    valence: new Uint16Array(count),
    angle: new Float64Array(count),
    normals: new Float32Array(3 * count),
    isBoundary: new Uint8Array(count),
    component: new Int32Array(count).fill(-1),
    starts: new Uint32Array(count + 1),
    neighbours: new Uint32Array(0),
  };
  const around: number[] = [];
  const meaning = new Int32Array(count).fill(-1);
  for (let v = 0; v < count; v++) {
    const m = vertexImage[v];
    own.starts[v + 1] = own.starts[v];
    if (m < 0) continue;
    meaning[v] = vertexOrigin[m];
    own.valence[v] = valence[m];
    own.angle[v] = angle[m];
    own.isBoundary[v] = isBoundary[m];
    own.component[v] = component[m];
    own.normals.set(normals.subarray(3 * m, 3 * m + 3), 3 * v);
    for (let n = starts[m]; n < starts[m + 1]; n++) around.push(vertexOrigin[neighbours[n]]);
    own.starts[v + 1] = around.length;
  }
  // Of several vertices that repairs made of one, the most is said: any may carry a cone.
  vertexOrigin.forEach((v, m) => {
    if (vertexImage[v] < 0) return;
    own.valence[v] = Math.max(own.valence[v], valence[m]);
    if (!isBoundary[m]) own.isBoundary[v] = 0;
  });
  return { ...own, neighbours: Uint32Array.from(around), meaning };
}

export function surfaceFacts({ positions, triangles, repaired }: SurfaceArrays): SurfaceFacts {
  const vertexCount = positions.length / 3;
  const own = { positions, triangles, vertexCount, ...ballOf(positions) };
  if (!repaired) {
    const meaning = Int32Array.from({ length: vertexCount }, (_, v) => v);
    return { ...own, ...factsOf(own), meaning, splitComponent: new Int32Array(0) };
  }
  const { vertexOrigin } = repaired;
  const moved = new Float64Array(3 * vertexOrigin.length);
  vertexOrigin.forEach((v, m) => moved.set(positions.subarray(3 * v, 3 * v + 3), 3 * m));
  const facts = factsOf({
    positions: moved,
    triangles: repaired.triangles,
    vertexCount: vertexOrigin.length,
  });
  const splitComponent = splitComponents(triangles, repaired, facts.component);
  return { ...own, ...pulledBack(facts, repaired), splitComponent };
}

/** Column by column, as three.js and glTF have it. */
type Matrix = readonly number[];

/** Moves points, or with `w` = 0 directions. */
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

/** The inverse transpose of the linear part, but for its size: what normals are moved by. */
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

/** The same surface where a node of the scene puts it. */
export function placed(
  facts: SurfaceFacts,
  matrix: Matrix,
): SurfaceFacts & Pick<Surface, 'places' | 'isMirrored'> {
  const isThere = matrix.every((x, i) => x === (i % 5 === 0 ? 1 : 0));
  if (isThere) return { ...facts, places: facts.positions.slice(), isMirrored: false };
  const places = movedBy(matrix, facts.positions);
  const turned = normalMatrix(matrix);
  const normals = new Float32Array(facts.normals.length);
  moved([...turned.matrix, 0, 0, 0, 1], facts.normals, normals, 0);
  unit(normals);
  const { center, radius } = ballOf(places);
  return { ...facts, places, normals, center, radius, isMirrored: turned.sign < 0 };
}
