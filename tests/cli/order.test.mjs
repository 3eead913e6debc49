// A map does not depend on how the file lists the surface: in every format that is read, with triangles and vertices in
// another order and triangles that start at another corner, it is the same map up to a q-fold turn, with the same cones.
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

const conesAt = (q, ids) => ids.flatMap((v) => ['--cone', `${v}:${(3 * q) / 4}`]);

/** What is asked for, by name: words of the command line for the ids of the corners. */
const requests = {
  'given cones, q = 4': [4, (ids) => conesAt(4, ids)],
  'given cones, q = 2': [2, (ids) => ids.slice(0, 4).flatMap((v) => ['--cone', `${v}:1`])],
  'automatic cones, q = 4': [4, () => []],
  'automatic cones, q = 3': [3, () => []],
  'cones along the curvature': [4, () => ['--align']],
  'few cones': [4, () => ['--cones-for', 'few']],
};

for (const [name, [q, words]] of Object.entries(requests))
  test(`the order of a file turns its map by a multiple of a ${q}-fold turn: ${name}`, () => {
    const mapOf = (file, ids) => {
      good('param', at(file), '-o', at('out.obj'), '-f', '-q', '--q', q, words(ids));
      return edgesOf(readFileSync(at('out.obj'), 'utf8'));
    };
    put('first.obj', toObj(surface));
    const first = mapOf('first.obj', cornersOf([0, 1, 2, 3, 4, 5, 6, 7]));
    let seed = 11;
    for (const [format, write] of Object.entries(writers)) {
      const { mesh, idOf } = reordered(surface, (seed += 7));
      put(`other.${format}`, write(mesh));
      // STL has no vertices: hgp numbers them as they occur first.
      const seen = [...new Set(mesh.triangles.flat())];
      const ids = format === 'stl' ? idOf.map((v) => seen.indexOf(v)) : idOf;
      assertSameUpToATurn(first, mapOf(`other.${format}`, cornersOf(ids)), q, `${format}, ${name}`);
    }
  });
