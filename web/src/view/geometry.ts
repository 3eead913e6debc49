// From the solver's arrays to what WebGL draws: one vertex per triangle corner, so that texture
// coordinates may differ on the two sides of a seam.

import { BufferAttribute, BufferGeometry } from 'three';

export interface TexturedMesh {
  positions: Float64Array;
  triangles: Uint32Array;
  uv?: Float64Array;
  cornerToUv?: Uint32Array;
}

/** Smooth normals, weighted by area, per vertex of the surface: seams of uv must not show in them. */
function vertexNormals(positions: Float64Array, triangles: Uint32Array): Float64Array {
  const normals = new Float64Array(positions.length);
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [3 * triangles[t], 3 * triangles[t + 1], 3 * triangles[t + 2]];
    const e = [0, 1, 2].map((i) => positions[b + i] - positions[a + i]);
    const f = [0, 1, 2].map((i) => positions[c + i] - positions[a + i]);
    const n = [e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]];
    for (const corner of [a, b, c]) for (let i = 0; i < 3; i++) normals[corner + i] += n[i];
  }
  return normals;
}

/** Scales uv so that `tiles` unit squares have the area of the whole surface. */
function uvScale(mesh: Required<TexturedMesh>, tiles: number): number {
  let area = 0;
  for (let t = 0; t < mesh.cornerToUv.length; t += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => 2 * mesh.cornerToUv[t + k]);
    const { uv } = mesh;
    const [ax, ay, bx, by] = [uv[a], uv[a + 1], uv[b] - uv[a], uv[b + 1] - uv[a + 1]];
    area += Math.abs(bx * (uv[c + 1] - ay) - by * (uv[c] - ax)) / 2;
  }
  return area > 0 ? Math.sqrt(tiles / area) : 1;
}

export function toGeometry(mesh: TexturedMesh, tiles: number): BufferGeometry {
  const corners = mesh.triangles.length;
  const position = new Float32Array(3 * corners);
  const normal = new Float32Array(3 * corners);
  const normals = vertexNormals(mesh.positions, mesh.triangles);
  for (let c = 0; c < corners; c++) {
    const v = 3 * mesh.triangles[c];
    const length = Math.hypot(normals[v], normals[v + 1], normals[v + 2]) || 1;
    for (let i = 0; i < 3; i++) {
      position[3 * c + i] = mesh.positions[v + i];
      normal[3 * c + i] = normals[v + i] / length;
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(position, 3));
  geometry.setAttribute('normal', new BufferAttribute(normal, 3));
  if (mesh.uv && mesh.cornerToUv) {
    const scale = uvScale(mesh as Required<TexturedMesh>, tiles);
    const uv = new Float32Array(2 * corners);
    for (let c = 0; c < corners; c++) {
      uv[2 * c] = mesh.uv[2 * mesh.cornerToUv[c]] * scale;
      uv[2 * c + 1] = mesh.uv[2 * mesh.cornerToUv[c] + 1] * scale;
    }
    geometry.setAttribute('uv', new BufferAttribute(uv, 2));
  }
  return geometry;
}
