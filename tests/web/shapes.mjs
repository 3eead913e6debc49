import { cubeMesh } from '../support/meshes.mjs';
import { drop, openMesh } from './support.mjs';

/** A flat square of n × n fields in the plane z = 0, seen from +z; the middle vertex where n is even. */
export function flatSquare(n) {
  const vertices = [];
  const triangles = [];
  for (let j = 0; j <= n; j++)
    for (let i = 0; i <= n; i++) vertices.push([(2 * i) / n - 1, (2 * j) / n - 1, 0]);
  const at = (i, j) => j * (n + 1) + i;
  for (let j = 0; j < n; j++) {
    for (let i = 0; i < n; i++) {
      const [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
      if ((i + j) % 2) triangles.push([a, b, c], [a, c, d]);
      else triangles.push([a, b, d], [b, c, d]);
    }
  }
  return { vertices, triangles, middle: at(n / 2, n / 2) };
}

/** A torus of a × b fields around the z axis. */
export function torusMesh(a, b) {
  const vertices = [];
  const triangles = [];
  const at = (i, j) => (j % b) * a + (i % a);
  for (let j = 0; j < b; j++) {
    for (let i = 0; i < a; i++) {
      const [u, v] = [(2 * Math.PI * i) / a, (2 * Math.PI * j) / b];
      const r = 1 + 0.4 * Math.cos(v);
      vertices.push([r * Math.cos(u), r * Math.sin(u), 0.4 * Math.sin(v)]);
      const [p, q, s, t] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
      triangles.push([p, q, s], [p, s, t]);
    }
  }
  return { vertices, triangles };
}

/** On cubeMesh(2), 48 triangles: cones that no map of its vertices can have. */
export const uncertifiable = {
  q: 2,
  cones: [
    ...[7, 14, 15].map((vertex) => ({ vertex, k: 5 })),
    ...[0, 24, 6, 23, 11, 19, 1, 8, 2, 3, 20, 10, 21].map((vertex) => ({ vertex, k: 1 })),
  ],
};

/** A cube whose sides have seams of their own: vertices doubled along one edge by a little. */
export function crackedCube() {
  const { vertices, triangles } = cubeMesh(3);
  const doubles = new Map();
  const cracked = triangles.map((triangle) => {
    const isUp = triangle.every((v) => vertices[v][2] > 0.9);
    return triangle.map((v) => {
      if (!isUp) return v;
      if (!doubles.has(v)) {
        doubles.set(v, vertices.length);
        vertices.push(vertices[v].map((x) => x + 1e-5));
      }
      return doubles.get(v);
    });
  });
  return { vertices, triangles: cracked };
}

/** An OBJ of quads: two cubes that share an edge, where four faces meet; one that repairs take apart. */
export function cubesOnAnEdge() {
  const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [i & 1, (i >> 1) & 1, i >> 2]);
  const lines = [];
  const ids = new Map();
  const idOf = (place) => {
    const key = place.join(' ');
    if (!ids.has(key)) {
      ids.set(key, ids.size + 1);
      lines.push(`v ${key}`);
    }
    return ids.get(key);
  };
  const quads = ['0 2 3 1', '4 5 7 6', '0 1 5 4', '2 6 7 3', '0 4 6 2', '1 3 7 5'];
  const faces = [];
  for (const shift of [
    [0, 0, 0],
    [1, 1, 0],
  ]) {
    const id = corners.map((corner) => idOf(corner.map((x, k) => x + shift[k])));
    for (const quad of quads)
      faces.push(
        `f ${quad
          .split(' ')
          .map((i) => id[i])
          .join(' ')}`,
      );
  }
  return `${[...lines, ...faces].join('\n')}\n`;
}

/** A ball with bumps: where they are low, few cones map it well; where they are high, more are needed. */
export function bumpyBall(n, height, waves) {
  const mesh = cubeMesh(n);
  const middle = [0, 1, 2].map(
    (i) => mesh.vertices.reduce((sum, p) => sum + p[i], 0) / mesh.vertices.length,
  );
  for (const p of mesh.vertices) {
    const away = p.map((x, i) => x - middle[i]);
    const [x, y, z] = away.map((d) => d / Math.hypot(...away));
    const r = 1 + height * Math.sin(waves * x) * Math.sin(waves * y + 1) * Math.cos(waves * z);
    [x, y, z].forEach((d, i) => (p[i] = d * r));
  }
  return mesh;
}

/** A sheet of squares that is bent like an arch, whose triangles are mirror images of each other across x = 0. */
export function arch(n) {
  const vertices = [];
  for (let j = 0; j <= n; j++)
    for (let i = -n; i <= n; i++)
      vertices.push([i / n, j / n, 0.4 * Math.cos((2 * i) / n) * (1 + j / n)]);
  const triangles = [];
  for (let j = 0; j < n; j++)
    for (let i = 0; i < 2 * n; i++) {
      const a = j * (2 * n + 1) + i;
      const [b, c, d] = [a + 1, a + 2 * n + 2, a + 2 * n + 1];
      if (i < n === j < n / 2) triangles.push([a, b, c], [a, c, d]);
      else triangles.push([a, b, d], [b, c, d]);
    }
  return { vertices, triangles };
}

/** A box with horns, its own mirror image in one plane only, turned and moved; and the normal of that plane. */
export function hornedBox(turn, shift) {
  const mesh = cubeMesh(8);
  const xs = mesh.vertices.map(([x]) => x);
  const middle = (Math.min(...xs) + Math.max(...xs)) / 2;
  for (const p of mesh.vertices) {
    const side = Math.abs(p[0] - middle);
    p[1] = 1.7 * p[1] + (p[1] > 0 ? p[1] * (1.5 * side ** 2 + 0.3 * p[2]) : 0);
    p[2] = 0.6 * p[2] + 0.05 * p[1] ** 2;
  }
  const [c, s] = [Math.cos(turn), Math.sin(turn)];
  for (const p of mesh.vertices) {
    const [x, y, z] = p;
    [p[0], p[1], p[2]] = [c * x - s * z + shift, y - 2 * shift, s * x + c * z + 0.3];
  }
  return { mesh, normal: [c, 0, s] };
}

/** Opens a rounded cube with half turns in the middle of four faces: front, back, right and left. */
export async function openCubeWithCones(it) {
  const mesh = cubeMesh(16);
  const middle = (axis, sign) =>
    mesh.vertices.findIndex((p) => p.every((x, i) => Math.abs(x - (i === axis ? sign : 0)) < 1e-9));
  const places = [middle(2, 1), middle(2, -1), middle(0, 1), middle(0, -1)];
  const cones = places.map((vertex) => ({ vertex, k: 2 }));
  await openMesh(it, mesh);
  await drop(it, {
    'faces.cones.json': JSON.stringify({ format: 'hgp-cones', version: 1, q: 4, cones }),
  });
  await it.page.waitForSelector('tr[data-cone="3"]');
}
