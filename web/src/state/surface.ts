// The loaded surface with what picking, walking and the budget need to know about it. Computed once,
// in steps. Vertex ids are those of the file; what is known about them is what welds and repairs made
// of them, for that is what is solved.

import { inSteps } from './breath';
import { edgesOf, partsOf } from './connect';
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

export interface Surface {
  positions: Float64Array;
  triangles: Uint32Array;
  vertexCount: number;
  /** Triangles at each vertex. */
  valence: Uint16Array;
  isBoundary: Uint8Array;
  /** Connected part of each vertex; parts are numbered by their smallest triangle. */
  part: Int32Array;
  /** Sum of the triangle angles at each vertex, in radians. */
  angle: Float64Array;
  /** Neighbours of v: neighbours[starts[v]] … neighbours[starts[v + 1] − 1]. */
  starts: Uint32Array;
  neighbours: Uint32Array;
  normals: Float32Array;
  diagonal: number;
  /** A ball around it. */
  center: [number, number, number];
  radius: number;
  /** The vertex that a vertex is one with, itself in most cases; −1 where it was removed. */
  meaning: Int32Array;
}

type Mesh = Pick<Surface, 'positions' | 'triangles' | 'vertexCount'>;
type Facts = Pick<
  Surface,
  'valence' | 'isBoundary' | 'part' | 'angle' | 'starts' | 'neighbours' | 'normals'
>;

/** Angle at a, where `area` is twice the area of the triangle. */
function cornerAngle(p: Float64Array, a: number, b: number, c: number, area: number): number {
  const x = (p[b] - p[a]) * (p[c] - p[a]);
  const y = (p[b + 1] - p[a + 1]) * (p[c + 1] - p[a + 1]);
  const z = (p[b + 2] - p[a + 2]) * (p[c + 2] - p[a + 2]);
  return Math.atan2(area, x + y + z);
}

async function shapeOf({
  positions: p,
  triangles,
  vertexCount,
}: Mesh): Promise<Pick<Facts, 'valence' | 'angle' | 'normals'>> {
  const valence = new Uint16Array(vertexCount);
  const angle = new Float64Array(vertexCount);
  const sums = new Float64Array(p.length);
  const normal = new Float64Array(3);
  await inSteps(triangles.length / 3, (t) => {
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
    angle[a / 3] += cornerAngle(p, a, b, c, area);
    angle[b / 3] += cornerAngle(p, b, c, a, area);
    angle[c / 3] += cornerAngle(p, c, a, b, area);
  });
  const normals = new Float32Array(p.length);
  await inSteps(vertexCount, (i) => {
    const v = 3 * i;
    const length = Math.sqrt(sums[v] ** 2 + sums[v + 1] ** 2 + sums[v + 2] ** 2) || 1;
    for (let k = 0; k < 3; k++) normals[v + k] = sums[v + k] / length;
  });
  return { valence, angle, normals };
}

async function ballOf(p: Float64Array): Promise<Pick<Surface, 'center' | 'radius' | 'diagonal'>> {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  await inSteps(p.length / 3, (v) => {
    for (let k = 0; k < 3; k++) {
      const x = p[3 * v + k];
      if (!Number.isFinite(x)) continue;
      if (x < low[k]) low[k] = x;
      if (x > high[k]) high[k] = x;
    }
  });
  const center = low.map((x, k) => (x + high[k]) / 2) as [number, number, number];
  let most = 0;
  await inSteps(p.length / 3, (v) => {
    const far =
      (p[3 * v] - center[0]) ** 2 +
      (p[3 * v + 1] - center[1]) ** 2 +
      (p[3 * v + 2] - center[2]) ** 2;
    if (far > most) most = far;
  });
  const diagonal = Math.hypot(...high.map((x, k) => x - low[k])) || 1;
  return { center, diagonal, radius: Math.sqrt(most) || diagonal / 2 };
}

async function factsOf(mesh: Mesh): Promise<Facts> {
  const { valence, angle, normals } = await shapeOf(mesh);
  const { starts, neighbours, isBoundary } = await edgesOf(mesh.triangles, mesh.vertexCount);
  const part = await partsOf(mesh.triangles, mesh.vertexCount);
  return { valence, angle, normals, starts, neighbours, isBoundary, part };
}

/** What is known about a repaired mesh, said of the vertices of the file. */
function pulledBack(
  { valence, angle, normals, starts, neighbours, isBoundary, part }: Facts,
  { vertexOrigin, vertexImage }: Required<SurfaceArrays>['repaired'],
): Facts & Pick<Surface, 'meaning'> {
  const count = vertexImage.length;
  const own: Facts = {
    valence: new Uint16Array(count),
    angle: new Float64Array(count),
    normals: new Float32Array(3 * count),
    isBoundary: new Uint8Array(count),
    part: new Int32Array(count).fill(-1),
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
    own.part[v] = part[m];
    own.normals.set(normals.subarray(3 * m, 3 * m + 3), 3 * v);
    for (let n = starts[m]; n < starts[m + 1]; n++) around.push(vertexOrigin[neighbours[n]]);
    own.starts[v + 1] = around.length;
  }
  return { ...own, neighbours: Uint32Array.from(around), meaning };
}

export async function makeSurface({
  positions,
  triangles,
  repaired,
}: SurfaceArrays): Promise<Surface> {
  const vertexCount = positions.length / 3;
  const own = { positions, triangles, vertexCount, ...(await ballOf(positions)) };
  if (!repaired) {
    const meaning = Int32Array.from({ length: vertexCount }, (_, v) => v);
    return { ...own, ...(await factsOf(own)), meaning };
  }
  const { vertexOrigin } = repaired;
  const moved = new Float64Array(3 * vertexOrigin.length);
  vertexOrigin.forEach((v, m) => moved.set(positions.subarray(3 * v, 3 * v + 3), 3 * m));
  const facts = await factsOf({
    positions: moved,
    triangles: repaired.triangles,
    vertexCount: vertexOrigin.length,
  });
  return { ...own, ...pulledBack(facts, repaired) };
}

/** What bends at v, in degrees: positive on a corner of a cube, negative on a saddle. */
export function defectDegrees(surface: Surface, v: number): number {
  const flat = surface.isBoundary[v] ? Math.PI : 2 * Math.PI;
  return ((flat - surface.angle[v]) * 180) / Math.PI;
}
