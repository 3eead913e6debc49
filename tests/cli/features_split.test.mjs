// Features of plain CAD: triangles between three of them, and edges that join them. Edges are split, as is said, and the map
// along all features is read from the files, by nothing of the project's own.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { inFolder } from '../support/program.mjs';

const { at, put, read, good } = inFolder('features-split');

/** A polygon, extruded; its caps are fans from their first corner. */
function prism(corners, height = 1) {
  const n = corners.length;
  const vertices = [0, height].flatMap((z) => corners.map(([x, y]) => [x, y, z]));
  const triangles = [];
  for (let i = 1; i + 1 < n; i++) triangles.push([0, i + 1, i], [n, n + i, n + i + 1]);
  for (let i = 0; i < n; i++) {
    const j = (i + 1) % n;
    triangles.push([i, j, n + j], [i, n + j, n + i]);
  }
  return { vertices, triangles };
}
const regular = (n) =>
  Array.from({ length: n }, (_, i) => [
    Math.fround(Math.cos((2 * Math.PI * i) / n)),
    Math.fround(Math.sin((2 * Math.PI * i) / n)),
  ]);
const tetrahedron = {
  vertices: [[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]], // prettier-ignore
  triangles: [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]], // prettier-ignore
};
const split = {
  'three sides': prism(regular(3)),
  'six sides': prism(regular(6), 2),
  'eight sides': prism(regular(8), 2),
  wedge: prism([[0, 0], [3, 0], [0, 1.5]], 2), // prettier-ignore
  tetrahedron,
};
const whole = {
  box: prism([[0, 0], [3, 0], [3, 2], [0, 2]]), // prettier-ignore
  'five sides': prism(regular(5), 2),
  'twelve sides': prism(regular(12), 2),
};

const lines = (rows, word = '') => rows.map((row) => word + row.join(' ')).join('\n');
const formats = {
  obj: ({ vertices, triangles }) =>
    `${lines(vertices, 'v ')}\n${lines(triangles.map((t) => t.map((i) => i + 1)), 'f ')}\n`, // prettier-ignore
  ply: ({ vertices, triangles }) =>
    `ply\nformat ascii 1.0\nelement vertex ${vertices.length}\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nelement face ${triangles.length}\nproperty list uchar int vertex_indices\nend_header\n${lines(vertices.map((p, i) => [...p, 10 * i]))}\n${lines(triangles.map((t) => [3, ...t]))}\n`, // prettier-ignore
};

/** Positions and uv by corner of an OBJ of triangles. */
function mapped(name) {
  const [v, vt, faces] = [[], [], []];
  for (const line of read(name).split('\n')) {
    const [word, ...rest] = line.trim().split(/\s+/);
    if (word === 'v') v.push(rest.slice(0, 3).map(Number));
    if (word === 'vt') vt.push(rest.map(Number));
    if (word === 'f') faces.push(rest.map((c) => c.split('/').map((i) => Number(i) - 1)));
  }
  return { v, vt, faces };
}

const minus = (p, q) => p.map((x, i) => x - q[i]);
const cross = ([a, b, c], [d, e, f]) => [b * f - c * e, c * d - a * f, a * e - b * d];
const dot = (p, q) => p.reduce((sum, x, i) => sum + x * q[i], 0);
const unit = (p) => p.map((x) => x / Math.sqrt(dot(p, p)));

/** Sharp edges of the split surface are those of the given one, and straight on both sides. */
function checkStraight({ v, vt, faces }) {
  const normal = faces.map(([a, b, c]) =>
    unit(cross(minus(v[b[0]], v[a[0]]), minus(v[c[0]], v[a[0]]))),
  );
  const sides = new Map();
  faces.forEach((corners, f) => {
    const [a, b, c] = corners.map(([, i]) => vt[i]);
    assert.ok((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0, 'positive');
    corners.forEach(([p, i], k) => {
      const [q, j] = corners[(k + 1) % 3];
      sides.set(`${p} ${q}`, { f, twin: `${q} ${p}`, a: vt[i], b: vt[j] });
    });
  });
  let count = 0;
  for (const { f, twin, a, b } of sides.values()) {
    if (dot(normal[f], normal[sides.get(twin).f]) > Math.cos(Math.PI / 6)) continue;
    assert.notEqual(a[0] === b[0], a[1] === b[1], 'a sharp edge is straight, bit for bit');
    count++;
  }
  assert.ok(count > 0);
}

for (const [name, shape] of Object.entries(split)) {
  test(`${name}: edges are split, and all creases are straight in the OBJ`, () => {
    put('in.obj', formats.obj(shape));
    good('param', 'in.obj', '--creases', '-o', 'out.obj', '--json', 'report.json', '--embed-cones', '--force'); // prettier-ignore
    const report = JSON.parse(read('report.json'));
    const out = mapped('out.obj');
    assert.equal(report.input.triangles, shape.triangles.length);
    assert.equal(report.refined.triangles, out.faces.length);
    assert.ok(out.faces.length > shape.triangles.length);
    assert.deepEqual(out.v.slice(0, shape.vertices.length), shape.vertices, 'vertices keep ids');
    assert.ok(report.notes.some(({ code }) => code === 'features-split'));
    checkStraight(out);
    good('verify', 'out.obj', '--json', 'verdict.json');
    const { components } = JSON.parse(read('verdict.json'));
    assert.ok(components.every(({ features }) => features.chains === features.straightChains));
    good('check', 'in.obj', '--creases');
    // What is given as a list is split alike.
    good('features', 'in.obj', '--creases', '-o', 'list.json');
    good('param', 'in.obj', '--features', 'list.json', '-o', 'again.obj', '--force');
    const data = (name) => read(name).replace(/^#.*\n/gm, '');
    assert.equal(data('again.obj'), data('out.obj'));
  });

  test(`${name}: the same as PLY and GLB, which verify`, () => {
    put('in.ply', formats.ply(shape));
    good('param', 'in.ply', '--creases', '-o', 'out.ply', '--force');
    good('verify', 'out.ply');
    const text = readFileSync(at('out.ply'), 'latin1');
    const count = Number(/element vertex (\d+)/.exec(text)[1]);
    const rows = text.slice(text.indexOf('end_header\n') + 11).split('\n').slice(0, count).map((row) => row.trim().split(' ').map(Number)); // prettier-ignore
    assert.deepEqual(rows.slice(0, shape.vertices.length).map((row) => row[3]), shape.vertices.map((_, i) => 10 * i)); // prettier-ignore
    for (const [, , , red] of rows) assert.ok(red >= 0 && red <= 10 * shape.vertices.length);
    put('in.obj', formats.obj(shape));
    good('param', 'in.obj', '--creases', '-o', 'out.glb', '--embed-cones', '--force');
    good('verify', 'out.glb', '--json', 'verdict.json');
    const { components } = JSON.parse(read('verdict.json'));
    assert.ok(components.every(({ features }) => features.chains === features.straightChains));
  });
}

for (const [name, shape] of Object.entries(whole))
  test(`${name}: nothing is split where nothing has to be`, () => {
    put('in.obj', formats.obj(shape));
    good('param', 'in.obj', '--creases', '-o', 'out.obj', '--json', 'report.json', '--force');
    assert.equal(JSON.parse(read('report.json')).refined, null);
    const out = mapped('out.obj');
    assert.equal(out.faces.length, shape.triangles.length);
    checkStraight(out);
  });
