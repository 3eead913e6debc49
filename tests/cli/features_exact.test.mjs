// Every feature edge is straight, bit for bit, in the numbers that OBJ, PLY and GLB store, at every scale: dangling
// ends, closed loops without corners, many creases at a vertex, creases that end on rims, flat pieces. The files are read
// here, by nothing of the project's own.
import assert from 'node:assert/strict';
import test from 'node:test';
import { readers } from '../support/mapped_corners.mjs';
import { inFolder } from '../support/program.mjs';

const { at, put, good } = inFolder('features-exact');

/** n × m squares over places of a grid; `wraps`: the first column follows the last. */
function sheet(n, m, place, wraps = false) {
  const columns = wraps ? n : n + 1;
  const id = (i, j) => (i % columns) * (m + 1) + j;
  const vertices = [];
  for (let i = 0; i < columns; i++) for (let j = 0; j <= m; j++) vertices.push(place(i, j));
  const triangles = [];
  for (let i = 0; i < n; i++)
    for (let j = 0; j < m; j++) {
      const [a, b, c, d] = [id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)];
      triangles.push([a, b, c], [a, c, d]);
    }
  return { vertices, triangles, id };
}

const flat = sheet(8, 8, (i, j) => [i, 1.1 * j, 0]);
const hill = sheet(8, 8, (i, j) => [i, j, 0.4 * Math.sin(0.7 * i) * Math.cos(0.5 * j)]);
const turn = (i, j) => [Math.cos((i * Math.PI) / 8), Math.sin((i * Math.PI) / 8), 0.3 * j];
const tube = sheet(16, 6, turn, true);
const two = {
  vertices: [...hill.vertices, ...flat.vertices.map(([x, y, z]) => [x + 20, y, z])],
  triangles: [...hill.triangles, ...flat.triangles.map((t) => t.map((v) => v + hill.vertices.length))], // prettier-ignore
};
const run = (count, edge) => Array.from({ length: count }, (_, i) => edge(i));
const { id } = hill;
const ring = run(16, (i) => [tube.id(i, 3), tube.id(i + 1, 3)]);
const spokes = [[1, 0], [0, 1], [1, 1], [-1, 0], [0, -1], [-1, -1]]; // prettier-ignore
const cases = {
  'dangling ends': [hill, run(3, (i) => [id(2 + i, 4), id(3 + i, 4)])],
  'a closed loop without corners, and rims like it': [tube, ring],
  'three creases at a vertex': [hill, spokes.slice(0, 3).map(([x, y]) => [id(4, 4), id(4 + x, 4 + y)])], // prettier-ignore
  'six creases at a vertex': [hill, spokes.map(([x, y]) => [id(4, 4), id(4 + x, 4 + y)])],
  'creases that end on rims': [hill, [...run(8, (i) => [id(i, 3), id(i + 1, 3)]), ...run(3, (j) => [id(5, j), id(5, j + 1)])]], // prettier-ignore
  'a component that is one flat patch': [two, []],
};

const float = Math.fround;
const placeOf = (p) => p.map(float).join(' ');
const keyOf = (p, q) => [placeOf(p), placeOf(q)].sort().join(' | ');

const toPly = (v, f) =>
  ['ply', 'format ascii 1.0', `element vertex ${v.length}`, 'property double x', 'property double y', 'property double z', `element face ${f.length}`, 'property list uchar int vertex_indices', 'end_header', ...v.map((p) => p.join(' ')), ...f.map((t) => `3 ${t.join(' ')}`), ''].join('\n'); // prettier-ignore
const toObj = (v, f) =>
  [...v.map((p) => `v ${p.join(' ')}`), ...f.map((t) => `f ${t.map((i) => i + 1).join(' ')}`), ''].join('\n'); // prettier-ignore

for (const [what, [{ vertices, triangles }, edges]] of Object.entries(cases))
  test(`${what}: straight in the stored bits of every format, at every scale`, () => {
    const sides = new Map();
    for (const t of triangles)
      for (let k = 0; k < 3; k++) {
        const pair = [t[k], t[(k + 1) % 3]].sort((a, b) => a - b).join(' ');
        sides.set(pair, (sides.get(pair) ?? 0) + 1);
      }
    const rims = [...sides].filter(([, n]) => n === 1).map(([pair]) => pair.split(' ').map(Number));
    put('list.txt', edges.map((edge) => edge.join(' ')).join('\n'));
    for (const scale of [1e-5, 1, 3e4]) {
      const placed = vertices.map((p) => p.map((x) => float(x * scale)));
      const asked = new Set([...edges, ...rims].map(([a, b]) => keyOf(placed[a], placed[b])));
      put('in.obj', toObj(placed, triangles));
      put('in.ply', toPly(placed, triangles));
      for (const [source, target] of [
        ['in.obj', 'out.obj'],
        ['in.ply', 'out.ply'],
        ['in.obj', 'out.glb'],
      ]) {
        // prettier-ignore
        const list = edges.length > 0 ? ['--features', 'list.txt'] : [];
        // Vertices of a GLB have new ids: the list is given by positions.
        if (target === 'out.glb' && list.length > 0) {
          good('features', 'in.obj', ...list, '-o', 'list.json');
          list[1] = 'list.json';
        }
        good('param', source, ...list, '--rims', '-o', target, '--force');
        let found = 0;
        for (const corners of readers[target.slice(4)](at(target))) {
          const [a, b, c] = corners.map(([, uv]) => uv);
          assert.ok((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0, target);
          corners.forEach(([p, uv], k) => {
            const [q, other] = corners[(k + 1) % 3];
            if (!asked.has(keyOf(p, q))) return;
            found++;
            assert.notEqual(uv[0] === other[0], uv[1] === other[1], `${target}, scale ${scale}`);
          });
        }
        assert.equal(found, 2 * edges.length + rims.length, `${target}, scale ${scale}`);
      }
    }
  });
