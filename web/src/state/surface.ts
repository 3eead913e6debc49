// The loaded surface with what picking, walking and the budget need to know about it. Computed once.

export interface SurfaceArrays {
  positions: Float64Array;
  triangles: Uint32Array;
}

export interface Surface extends SurfaceArrays {
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
}

function cross(p: Float64Array, a: number, b: number, c: number): [number, number, number] {
  const [ux, uy, uz] = [p[b] - p[a], p[b + 1] - p[a + 1], p[b + 2] - p[a + 2]];
  const [vx, vy, vz] = [p[c] - p[a], p[c + 1] - p[a + 1], p[c + 2] - p[a + 2]];
  return [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
}

/** Angle at a, where `area` is twice the area of the triangle. */
function cornerAngle(p: Float64Array, a: number, b: number, c: number, area: number): number {
  const x = (p[b] - p[a]) * (p[c] - p[a]);
  const y = (p[b + 1] - p[a + 1]) * (p[c + 1] - p[a + 1]);
  const z = (p[b + 2] - p[a + 2]) * (p[c + 2] - p[a + 2]);
  return Math.atan2(area, x + y + z);
}

/** Halfedges by undirected edge: the boundary is where an edge has only one. */
function readEdges(triangles: Uint32Array, vertexCount: number): Map<number, number> {
  const count = new Map<number, number>();
  for (let c = 0; c < triangles.length; c++) {
    const a = triangles[c];
    const b = triangles[c % 3 === 2 ? c - 2 : c + 1];
    const key = Math.min(a, b) * vertexCount + Math.max(a, b);
    count.set(key, (count.get(key) ?? 0) + 1);
  }
  return count;
}

function partsOf(triangles: Uint32Array, vertexCount: number): Int32Array {
  const root = Int32Array.from({ length: vertexCount }, (_, v) => v);
  const find = (v: number): number => {
    while (root[v] !== v) v = root[v] = root[root[v]];
    return v;
  };
  for (let t = 0; t < triangles.length; t += 3) {
    const a = find(triangles[t]);
    root[find(triangles[t + 1])] = a;
    root[find(triangles[t + 2])] = a;
  }
  const numbers = new Map<number, number>();
  const part = new Int32Array(vertexCount).fill(-1);
  for (const v of triangles) {
    const r = find(v);
    if (!numbers.has(r)) numbers.set(r, numbers.size);
    part[v] = numbers.get(r)!;
  }
  return part;
}

function diagonalOf(positions: Float64Array): number {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; i++) {
    if (!Number.isFinite(positions[i])) continue;
    low[i % 3] = Math.min(low[i % 3], positions[i]);
    high[i % 3] = Math.max(high[i % 3], positions[i]);
  }
  return Math.hypot(...high.map((h, i) => h - low[i])) || 1;
}

export function makeSurface({ positions, triangles }: SurfaceArrays): Surface {
  const vertexCount = positions.length / 3;
  const valence = new Uint16Array(vertexCount);
  const angle = new Float64Array(vertexCount);
  const sums = new Float64Array(positions.length);
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [3 * triangles[t], 3 * triangles[t + 1], 3 * triangles[t + 2]];
    const n = cross(positions, a, b, c);
    for (const v of [a, b, c]) for (let i = 0; i < 3; i++) sums[v + i] += n[i];
    for (let k = 0; k < 3; k++) valence[triangles[t + k]] += 1;
    const area = Math.sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    angle[a / 3] += cornerAngle(positions, a, b, c, area);
    angle[b / 3] += cornerAngle(positions, b, c, a, area);
    angle[c / 3] += cornerAngle(positions, c, a, b, area);
  }
  const normals = new Float32Array(positions.length);
  for (let v = 0; v < positions.length; v += 3) {
    const length = Math.hypot(sums[v], sums[v + 1], sums[v + 2]) || 1;
    for (let i = 0; i < 3; i++) normals[v + i] = sums[v + i] / length;
  }
  const edges = readEdges(triangles, vertexCount);
  const isBoundary = new Uint8Array(vertexCount);
  const starts = new Uint32Array(vertexCount + 1);
  for (const [key, count] of edges) {
    const [a, b] = [Math.floor(key / vertexCount), key % vertexCount];
    starts[a + 1] += 1;
    starts[b + 1] += 1;
    if (count === 1) isBoundary[a] = isBoundary[b] = 1;
  }
  for (let v = 0; v < vertexCount; v++) starts[v + 1] += starts[v];
  const next = starts.slice();
  const neighbours = new Uint32Array(2 * edges.size);
  for (const key of edges.keys()) {
    const [a, b] = [Math.floor(key / vertexCount), key % vertexCount];
    neighbours[next[a]++] = b;
    neighbours[next[b]++] = a;
  }
  const part = partsOf(triangles, vertexCount);
  const diagonal = diagonalOf(positions);
  return {
    ...{ positions, triangles, vertexCount, valence, isBoundary, part, angle },
    ...{ starts, neighbours, normals, diagonal },
  };
}

/** What bends at v, in degrees: positive on a corner of a cube, negative on a saddle. */
export function defectDegrees(surface: Surface, v: number): number {
  const flat = surface.isBoundary[v] ? Math.PI : 2 * Math.PI;
  return ((flat - surface.angle[v]) * 180) / Math.PI;
}
