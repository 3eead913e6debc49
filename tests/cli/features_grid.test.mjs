// Plain CAD whose triangles have all corners on features: with a grid all of these go to grid lines, which may leave no
// triangle room. The certified mesh then has split edges, and its quads follow every crease.
import assert from 'node:assert/strict';
import test from 'node:test';
import { toObj } from '../support/meshes.mjs';
import { inFolder } from '../support/program.mjs';

const { put, read, run, good } = inFolder('features-grid');

// A block from which a box, a bore and a corner are cut: positions, and triangles by numbers from 1.
const positions = `
  0 2 1 | 0 1 2 | 0 2 2 | 0 0 1 | 0 0 2 | 0 1 0 | 0 0 0 | 0 2 0 | 2 0 1 | 2 0 2 | 1 0 2 | 1 0 0 | 2 0 0 |
  1.47 0.78 2 | 1.47 1.62 2 | 1.29 1.22 2 | 2 0.78 2 | 1.29 1.62 2 | 0.75 1.22 2 | 0.75 2 2 | 1.47 2 1.49 |
  1.4 2 1.5 | 1.47 2 1.5 | 0.75 2 1.44 | 1.78 2 1.3 | 1.78 2 1.49 | 1.44 2 1.29 | 0.75 2 0.89 | 1.29 2 0.89 |
  1.29 2 1.14 | 1 2 0 | 2 2 0 | 2 2 0.65 | 2 2 1.3 | 2 1 0 | 2 0.78 1.49 | 2 1.64 1.3 | 2 1.64 1.49 |
  0.75 1.22 1.44 | 0.75 1.22 0.89 | 1.22 1.22 1.58 | 1.29 1.22 1.57 | 1.04 1.22 1.5 | 0.99 1.22 1.32 |
  1.1 1.22 1.16 | 1.29 1.22 0.89 | 1.29 1.22 1.14 | 1.29 1.62 1.57 | 1.47 1.62 1.5 | 1.4 1.62 1.5 |
  1.47 1.39 1.49 | 1.47 0.78 1.49 | 1.78 1.64 1.3 | 1.78 1.64 1.49 | 1.22 1.11 1.58 | 1.04 1.11 1.5 |
  0.99 1.11 1.3 | 1.12 1.11 1.15 | 1.31 1.11 1.15 | 1.39 1.11 1.5 | 1.44 1.11 1.3`;
const triangles = `
  1 2 3 | 4 5 2 | 6 2 1 | 6 4 2 | 7 4 6 | 8 6 1 | 9 10 11 | 4 11 5 | 4 9 11 | 12 4 7 | 12 9 4 | 13 9 12 |
  14 15 16 | 14 10 17 | 18 16 15 | 11 10 14 | 19 11 14 | 19 14 16 | 3 19 20 | 2 19 3 | 2 11 19 | 2 5 11 |
  21 22 23 | 24 3 20 | 25 21 26 | 27 22 21 | 27 21 25 | 1 3 24 | 28 1 24 | 29 30 27 | 8 28 31 | 8 1 28 |
  32 31 33 | 31 29 33 | 31 28 29 | 33 25 34 | 33 29 25 | 29 27 25 | 12 35 13 | 31 35 12 | 31 32 35 | 6 12 7 |
  6 31 12 | 8 31 6 | 36 17 10 | 37 38 36 | 9 36 10 | 33 34 37 | 35 33 37 | 35 37 36 | 35 36 9 | 13 35 9 |
  32 33 35 | 24 20 19 | 39 24 19 | 40 28 24 | 40 24 39 | 41 19 16 | 42 41 16 | 43 19 41 | 39 19 43 |
  44 39 43 | 40 39 44 | 40 44 45 | 46 45 47 | 46 40 45 | 42 16 18 | 48 42 18 | 48 18 15 | 49 50 48 |
  49 48 15 | 49 51 21 | 21 23 49 | 51 49 15 | 51 15 14 | 51 14 52 | 36 14 17 | 52 14 36 | 53 37 34 |
  25 53 34 | 53 25 26 | 53 26 54 | 54 36 38 | 21 54 26 | 51 52 36 | 51 36 54 | 51 54 21 | 50 49 23 |
  22 50 23 | 43 41 55 | 56 43 55 | 44 43 56 | 57 44 56 | 45 44 57 | 58 45 57 | 47 45 58 | 59 47 58 |
  55 41 42 | 55 42 60 | 22 27 50 | 48 50 42 | 61 60 42 | 50 61 42 | 47 59 61 | 50 47 61 | 50 27 30 |
  47 50 30 | 29 47 30 | 29 46 47 | 40 46 29 | 28 40 29 | 53 54 38 | 37 53 38 | 57 56 55 | 59 55 60 |
  59 60 61 | 58 57 55 | 58 55 59`;
const table = (text) =>
  text.split('|').map((row) => row.trim().split(/\s+/).map(Number)); // prettier-ignore
const block = {
  vertices: table(positions),
  triangles: table(triangles).map((corners) => corners.map((i) => i - 1)),
};

const minus = (p, q) => p.map((x, i) => x - q[i]);
const dot = (p, q) => p.reduce((sum, x, i) => sum + x * q[i], 0);
const cross = ([a, b, c], [d, e, f]) => [b * f - c * e, c * d - a * f, a * e - b * d];
const length = (p) => Math.sqrt(dot(p, p));

/** Edges with a dihedral angle above 30°, as pairs of positions. */
function creasesOf({ vertices: v, triangles: faces }) {
  const normals = faces.map(([a, b, c]) => {
    const n = cross(minus(v[b], v[a]), minus(v[c], v[a]));
    return n.map((x) => x / length(n));
  });
  const faceOf = new Map();
  faces.forEach((corners, f) => corners.forEach((a, k) => faceOf.set(`${a} ${corners[(k + 1) % 3]}`, f))); // prettier-ignore
  return [...faceOf.keys()]
    .map((key) => key.split(' ').map(Number))
    .filter(([a, b]) => a < b)
    .filter(
      ([a, b]) =>
        dot(normals[faceOf.get(`${a} ${b}`)], normals[faceOf.get(`${b} ${a}`)]) <
        Math.cos(Math.PI / 6),
    ) // prettier-ignore
    .map(([a, b]) => [v[a], v[b]]);
}

function distance(p, [a, b]) {
  const along = minus(b, a);
  const t = Math.min(1, Math.max(0, dot(minus(p, a), along) / dot(along, along)));
  return length(minus(p, a.map((x, i) => x + t * along[i]))); // prettier-ignore
}

test('a block whose triangles leave the grid no room: quads along every crease, all around', () => {
  put('in.obj', toObj(block));
  good('quads', 'in.obj', '--creases', '-o', 'out.obj', '--json', 'report.json', '--force');
  const report = JSON.parse(read('report.json'));
  assert.ok(report.notes.some(({ code }) => code === 'features-split'));
  const rows = read('out.obj').split('\n').map((row) => row.trim().split(/\s+/)); // prettier-ignore
  const of = (word) => rows.filter(([first]) => first === word).map(([, ...rest]) => rest);
  const v = of('v').map((row) => row.slice(0, 3).map(Number));
  const quads = of('f').map((row) => row.map((corner) => Number.parseInt(corner, 10) - 1));
  assert.ok(quads.length > 0 && quads.every((corners) => new Set(corners).size === 4));
  const sides = new Set(quads.flatMap((corners) => corners.map((a, k) => `${a} ${corners[(k + 1) % 4]}`))); // prettier-ignore
  assert.equal(sides.size, 4 * quads.length, 'no side twice');
  for (const side of sides) assert.ok(sides.has(side.split(' ').reverse().join(' ')), 'closed');
  const edges = [...sides].map((side) => side.split(' ').map((i) => v[i]));
  for (const [a, b] of creasesOf(block))
    for (const t of [0, 0.3, 0.5, 0.8, 1]) {
      const p = a.map((x, i) => x + t * (b[i] - x));
      assert.ok(Math.min(...edges.map((edge) => distance(p, edge))) < 2e-6, `${p}`);
    }
});

/** A plate of unit squares with n × n square holes. */
function perforated(n) {
  const size = 2 * n + 1;
  const isHole = (i, j) => i % 2 === 1 && j % 2 === 1;
  const isSolid = (i, j) => i >= 0 && j >= 0 && i < size && j < size && !isHole(i, j);
  const ids = new Map();
  const vertices = [];
  const id = (...p) => {
    const key = p.join(' ');
    if (!ids.has(key)) ids.set(key, vertices.push(p) - 1);
    return ids.get(key);
  };
  const triangles = [];
  const quad = (a, b, c, d) => triangles.push([a, b, c], [a, c, d]);
  for (let i = 0; i < size; i++)
    for (let j = 0; j < size; j++) {
      if (!isSolid(i, j)) continue;
      quad(id(i, j, 1), id(i + 1, j, 1), id(i + 1, j + 1, 1), id(i, j + 1, 1));
      quad(id(i, j, 0), id(i, j + 1, 0), id(i + 1, j + 1, 0), id(i + 1, j, 0));
      const side = (a, b, c, d) => quad(id(a, b, 0), id(c, d, 0), id(c, d, 1), id(a, b, 1));
      if (!isSolid(i, j - 1)) side(i, j, i + 1, j);
      if (!isSolid(i + 1, j)) side(i + 1, j, i + 1, j + 1);
      if (!isSolid(i, j + 1)) side(i + 1, j + 1, i, j + 1);
      if (!isSolid(i - 1, j)) side(i, j + 1, i, j);
    }
  return { vertices, triangles };
}

test('many cones along features get many cells where their number is not given', () => {
  put('plate.obj', toObj(perforated(3)));
  const quadsOf = (...options) => {
    good('quads', 'plate.obj', '--creases', '-o', 'out.obj', '--json', 'report.json', '--force', ...options); // prettier-ignore
    return read('out.obj');
  };
  const automatic = quadsOf();
  const { options, components, cones } = JSON.parse(read('report.json'));
  assert.equal(cones.cones.length, 80);
  assert.equal(options.grid.cells, 20 * 80);
  assert.ok(components[0].grid.cellsPerCone > 14, `${components[0].grid.cellsPerCone}`);
  assert.equal(quadsOf('--cells', '1600'), automatic, 'the number in the report is the one taken');
  quadsOf('--cells', '400');
  const given = JSON.parse(read('report.json'));
  assert.equal(given.options.grid.cells, 400);
  assert.ok(given.components[0].grid.cells < 0.6 * components[0].grid.cells);
});

test('a number of cells that is advised works', () => {
  put('in.obj', toObj(block));
  const runAt = (cells) =>
    run(['quads', 'in.obj', '--creases', '--cells', `${cells}`, '-o', 'out.obj', '--json', 'report.json', '--force']); // prettier-ignore
  for (const cells of [40, 100, 250, 600, 1500]) {
    const { code } = runAt(cells);
    if (code === 0) continue;
    assert.equal(code, 6);
    const { workingCells } = JSON.parse(read('report.json')).components[0].grid;
    assert.ok(workingCells > cells, `${cells}`);
    assert.equal(runAt(workingCells).code, 0, `${cells}: ${workingCells}`);
  }
});
