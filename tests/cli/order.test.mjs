// The map with given cones does not depend on how the file lists the surface: in every format that is read, with triangles
// and vertices in another order and triangles that start at another corner, it is the same map up to a q-fold turn.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { cubeMesh, toGlb, toGltf, toObj, toOff, toPly, toStl } from '../support/meshes.mjs';
import { inFolder } from '../support/program.mjs';

const { at, put, good } = inFolder('order');

/** Numbers from 0 to n − 1 in an order that follows from the seed. */
function shuffled(n, seed) {
  const order = Array.from({ length: n }, (_, i) => i);
  let state = seed;
  for (let i = n - 1; i > 0; i--) {
    state = (state * 48271) % 2147483647;
    const j = state % (i + 1);
    [order[i], order[j]] = [order[j], order[i]];
  }
  return order;
}

/** A bent and uneven box without symmetries, as float32 has its places. */
function bent() {
  const { vertices, triangles } = cubeMesh(7);
  const place = ([x, y, z]) =>
    [1.7 * x + 0.2 * z * z, y * (1 + 0.15 * x), 0.8 * z + 0.1 * Math.sin(2 * x + y)].map(
      Math.fround,
    );
  return { vertices: vertices.map(place), triangles };
}

/** The same surface, listed in another order; `idOf[v]` is the new id of vertex v. */
function reordered({ vertices, triangles }, seed) {
  const order = shuffled(vertices.length, seed);
  const idOf = [];
  order.forEach((old, id) => (idOf[old] = id));
  const rows = shuffled(triangles.length, seed + 1).map((row, i) => {
    const t = triangles[row].map((v) => idOf[v]);
    return [0, 1, 2].map((k) => t[(k + i) % 3]);
  });
  return { mesh: { vertices: order.map((old) => vertices[old]), triangles: rows }, idOf };
}

const keyOf = (p) => p.map((x) => x.toFixed(5)).join(' ');

/** Per directed edge of a triangle, named by its ends and the third corner: the edge in the map. */
function edgesOf(text) {
  const v = [];
  const vt = [];
  const edges = new Map();
  for (const line of text.split('\n')) {
    const [kind, ...rest] = line.trim().split(/\s+/);
    if (kind === 'v') v.push(keyOf(rest.slice(0, 3).map(Number)));
    if (kind === 'vt') vt.push(rest.slice(0, 2).map(Number));
    if (kind !== 'f') continue;
    const corners = rest.map((c) => c.split('/').map((n) => Number(n) - 1));
    corners.forEach((c, k) => {
      const [d, e] = [corners[(k + 1) % 3], corners[(k + 2) % 3]];
      const to = [0, 1].map((i) => vt[d[1]][i] - vt[c[1]][i]);
      edges.set([c, d, e].map((x) => v[x[0]]).join('|'), to);
    });
  }
  return edges;
}

/** z^q of a complex number. */
function power([x, y], q) {
  let [a, b] = [1, 0];
  for (let i = 0; i < q; i++) [a, b] = [a * x - b * y, a * y + b * x];
  return [a, b];
}

function assertSameUpToATurn(first, second, q, what) {
  assert.equal(second.size, first.size, what);
  for (const [key, a] of first) {
    const b = second.get(key);
    assert.ok(b, `${what}: ${key}`);
    const size = a[0] * a[0] + a[1] * a[1];
    // b / a is a q-th root of 1
    const turn = [(a[0] * b[0] + a[1] * b[1]) / size, (a[0] * b[1] - a[1] * b[0]) / size];
    const [x, y] = power(turn, q);
    assert.ok(Math.hypot(x - 1, y) < 1e-3, `${what}: an edge turned and scaled by ${turn}`);
  }
}

const writers = {
  obj: (mesh) => toObj(mesh),
  off: (mesh) => toOff(mesh),
  ply: (mesh) => toPly(mesh),
  stl: (mesh) => toStl(mesh),
  glb: (mesh) => toGlb([mesh]),
  gltf: (mesh) => {
    const { json, bin } = toGltf([mesh]);
    put('cube.bin', bin);
    return typeof json === 'string' ? json : JSON.stringify(json);
  },
};

const surface = bent();
/** The vertices at the eight corners. */
const cornersOf = (idOf) => [0, 1, 2, 3, 4, 5, 6, 7].map((v) => idOf[v]);

for (const q of [4, 2])
  test(`the order of a file turns its map by a multiple of a ${q}-fold turn, in every format`, () => {
    const conesAt = (ids) => ids.flatMap((v) => ['--cone', `${v}:${(3 * q) / 4}`]);
    const cones = q === 4 ? conesAt : (ids) => ids.slice(0, 4).flatMap((v) => ['--cone', `${v}:1`]);
    put('first.obj', toObj(surface));
    good(
      'param',
      at('first.obj'),
      '-o',
      at('first.out.obj'),
      '-q',
      '--q',
      q,
      cones(cornersOf([0, 1, 2, 3, 4, 5, 6, 7])),
    );
    const first = edgesOf(readFileSync(at('first.out.obj'), 'utf8'));
    let seed = 11;
    for (const [format, write] of Object.entries(writers)) {
      const { mesh, idOf } = reordered(surface, (seed += 7));
      put(`other.${format}`, write(mesh));
      // STL has no vertices: hgp numbers them as they occur first.
      const seen = [...new Set(mesh.triangles.flat())];
      const ids = format === 'stl' ? idOf.map((v) => seen.indexOf(v)) : idOf;
      good(
        'param',
        at(`other.${format}`),
        '-o',
        at('other.out.obj'),
        '-f',
        '-q',
        '--q',
        q,
        cones(cornersOf(ids)),
      );
      assertSameUpToATurn(
        first,
        edgesOf(readFileSync(at('other.out.obj'), 'utf8')),
        q,
        `${format}, q = ${q}`,
      );
    }
  });
