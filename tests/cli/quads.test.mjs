// Quad meshes from outside: the files that `hgp quads` writes, counted by nothing of the project's own.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { NodeIO } from '@gltf-transform/core';
import validator from 'gltf-validator';
import { cubeMesh, toObj } from '../support/meshes.mjs';
import { hgp, inFolder, shared } from '../support/program.mjs';

const { folder } = inFolder('quads');

/** m × n vertices of a torus with radii 1 and r, wavy so that nothing is symmetric. */
function torus(m, n, r) {
  const vertices = [];
  const triangles = [];
  for (let i = 0; i < m; i++)
    for (let j = 0; j < n; j++) {
      const [a, b] = [(2 * Math.PI * i) / m, (2 * Math.PI * j) / n];
      const s = r * (1 + 0.15 * Math.sin(3 * a + b));
      const d = 1 + s * Math.cos(b);
      vertices.push([d * Math.cos(a), d * Math.sin(a), s * Math.sin(b)]);
      const at = (k, l) => ((k + m) % m) * n + ((l + n) % n);
      triangles.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
      triangles.push([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
    }
  return { vertices, triangles };
}

const stretched = (mesh, s) => ({
  ...mesh,
  vertices: mesh.vertices.map((p) => p.map((x, k) => x * s[k])),
});

function put(name, mesh) {
  writeFileSync(path.join(folder, name), toObj(mesh));
  return path.join(folder, name);
}

const isFull = process.env.HGP_FULL === '1';
/** They take more than half of the time. */
const large = [
  ['odedstein-meshes/nefertiti-lowres.obj.gz', 2],
  ['BFF/kitten.obj.gz', 0],
  ['ConformalIdealDelaunay/elephant.obj.gz', -4],
];

/** Closed surfaces: a file and the Euler characteristic it has. */
const models = [
  [put('ball.obj', cubeMesh(8)), 2],
  [put('fine.obj', cubeMesh(20)), 2],
  [put('loaf.obj', stretched(cubeMesh(12), [3, 1, 0.7])), 2],
  [put('disc.obj', stretched(cubeMesh(12), [1, 1, 0.3])), 2],
  [put('cigar.obj', stretched(cubeMesh(14), [0.4, 0.5, 2])), 2],
  [put('ring.obj', torus(48, 20, 0.4)), 0],
  [put('thin.obj', torus(60, 16, 0.15)), 0],
  [put('fat.obj', torus(40, 40, 0.8)), 0],
  ...[
    ['OptCuts/horse_f10000.obj', 2],
    ['odedstein-meshes/spot_low_resolution.obj', 2],
    ['gltf/moon.glb', 2],
    ['geometry-central/bob_small.ply', 0],
    ['Directional/697224__sf.obj', 0],
    ['Directional/eight.off', -2],
    ['gp-js/double-torus.obj', -2],
    ['SWN/DoubleTorusWithLoops.obj.gz', -2],
    ['wildmeshing-data/100071_sf.obj', -4],
    ...(isFull ? large : []),
  ].map(([name, euler]) => [path.join(shared, name), euler]),
];

/** What every one must be: pure, manifold, closed, of this Euler characteristic and these valences. */
function checkQuads(text, euler, cones, name) {
  const rows = text.split('\n').map((line) => line.split(' '));
  const points = rows.filter((r) => r[0] === 'v').map((r) => r.slice(1).map(Number));
  const faces = rows
    .filter((r) => r[0] === 'f')
    .map((r) => r.slice(1).map((c) => Number(c.split('/')[0]) - 1));
  assert.ok(faces.length > 0, name);
  const next = new Map(); // per directed edge: where its quad goes on
  for (const face of faces) {
    assert.equal(face.length, 4, `${name}: not a quad`);
    assert.equal(new Set(face).size, 4, `${name}: a corner twice`);
    face.forEach((a, k) => {
      const edge = `${a} ${face[(k + 1) % 4]}`;
      assert.ok(!next.has(edge), `${name}: edge ${edge} twice`);
      next.set(edge, face[(k + 3) % 4]);
    });
  }
  for (const edge of next.keys())
    assert.ok(next.has(edge.split(' ').reverse().join(' ')), `${name}: open at ${edge}`);
  assert.equal(points.length - next.size / 2 + faces.length, euler, `${name}: V − E + F`);
  const valence = new Array(points.length).fill(0);
  const start = [];
  for (const edge of next.keys()) {
    const [a, b] = edge.split(' ').map(Number);
    valence[a]++;
    start[a] = b;
  }
  valence.forEach((n, v) => {
    assert.ok(n > 0, `${name}: vertex ${v} has no face`);
    let [b, steps] = [start[v], 0];
    do {
      b = next.get(`${v} ${b}`); // the edge before v in the quad: the next one around v
      steps++;
    } while (b !== start[v] && steps <= n);
    assert.equal(steps, n, `${name}: two fans at vertex ${v}`);
  });
  const ascending = (list) => list.sort((a, b) => a - b);
  assert.deepEqual(
    ascending(valence.filter((n) => n !== 4)),
    ascending(cones),
    `${name}: valences`,
  );
  assert.ok(points.flat().every(Number.isFinite));
}

test('around a handle of two cells, strips are cut so that no two edges have the same ends', () => {
  const file = put('hoop.obj', torus(60, 16, 0.05));
  const out = path.join(folder, 'hoop-quads.obj');
  for (const [cells, most, cuts] of [
    [40, 4, true],
    [80, 2, true],
    [160, 1.1, false],
  ]) {
    const run = spawnSync(hgp, ['quads', file, '--cells', `${cells}`, '-o', out], {
      encoding: 'utf8',
    });
    assert.equal(run.status, 0, run.stderr);
    const text = readFileSync(out, 'utf8');
    checkQuads(text, 0, [], `hoop, ${cells} cells`);
    const count = text.match(/^f /gm).length;
    assert.ok(count <= most * cells, `${count} quads for ${cells} cells`);
    assert.equal(/strips? of quads (is|are) cut lengthwise/.test(run.stderr), cuts, run.stderr);
  }
});

test('quads are as many as asked for, within a tenth, also where a component has few cells', () => {
  const surfaces = [
    ['hoop.obj', torus(60, 16, 0.05)],
    ['ring.obj', torus(48, 20, 0.4)],
    ['thin.obj', torus(60, 16, 0.15)],
    ['loaf.obj', stretched(cubeMesh(12), [3, 1, 0.7])],
    ['cigar.obj', stretched(cubeMesh(14), [0.4, 0.5, 2])],
  ];
  const out = path.join(folder, 'counted.obj');
  for (const [name, mesh] of surfaces) {
    const file = put(name, mesh);
    for (const cells of [320, 640, 1000, 3000]) {
      const run = spawnSync(hgp, ['quads', file, '--cells', `${cells}`, '-o', out, '--force'], {
        encoding: 'utf8',
      });
      assert.equal(run.status, 0, run.stderr);
      const count = readFileSync(out, 'utf8').match(/^f /gm).length;
      assert.ok(Math.abs(count / cells - 1) <= 0.1, `${name}: ${count} quads for ${cells}`);
    }
  }
});

/** Coefficient of variation of the areas of the quads in an OBJ. */
function unevenness(text) {
  const rows = text.split('\n').map((line) => line.split(' '));
  const points = rows.filter((r) => r[0] === 'v').map((r) => r.slice(1).map(Number));
  const areas = rows
    .filter((r) => r[0] === 'f')
    .map((r) => {
      const [a, b, c, d] = r.slice(1).map((word) => points[Number(word.split('/')[0]) - 1]);
      const [p, q] = [c.map((x, k) => x - a[k]), d.map((x, k) => x - b[k])];
      return Math.hypot(...[0, 1, 2].map((k) => p[k] * q[(k + 1) % 3] - p[(k + 1) % 3] * q[k])) / 2;
    });
  const mean = areas.reduce((sum, x) => sum + x, 0) / areas.length;
  return Math.sqrt(areas.reduce((sum, x) => sum + (x - mean) ** 2, 0) / areas.length) / mean;
}

test('quads take the options of param, and a number of cells where none is given', () => {
  const file = put('pear.obj', stretched(cubeMesh(16), [1, 0.6, 2.2]));
  const out = path.join(folder, 'pear-quads.obj');
  const report = path.join(folder, 'pear.json');
  const run = (...options) => {
    const done = spawnSync(hgp, ['quads', file, '-o', out, '--json', report, ...options], {
      encoding: 'utf8',
    });
    assert.equal(done.status, 0, `${options}: ${done.stderr}`);
    const text = readFileSync(out, 'utf8');
    const { cones } = JSON.parse(readFileSync(report, 'utf8')).cones;
    checkQuads(
      text,
      2,
      cones.map((c) => c.k),
      `${options}`,
    );
    return { text, quads: text.match(/^f /gm).length };
  };
  const plain = run();
  assert.ok(plain.quads > 600 && plain.quads < 1100, `${plain.quads} quads for about 800 cells`);
  const even = run('--improve', 'area');
  assert.ok(unevenness(even.text) < 0.8 * unevenness(plain.text));
  for (const options of [
    ['--align', '--cells', '3000'],
    ['--method', 'soft', '--cells', '1500'],
    ['--cones-for', 'few', '--cells', '1500'],
    ['--refine', '--cells', '1500'],
  ])
    run(...options);
  writeFileSync(out, readFileSync(file));
  const replaced = (...options) => spawnSync(hgp, ['quads', out, '-o', out, ...options]).status;
  assert.equal(replaced(), 2);
  assert.equal(replaced('--force'), 0);
});

test('a name that quads are not written to is refused before anything is solved', () => {
  const file = put('small.obj', cubeMesh(4));
  for (const name of ['quads.gltf', 'quads', 'quads.stl', 'quads.obj.txt']) {
    const out = path.join(folder, name);
    const run = spawnSync(hgp, ['quads', file, '--cells', '60', '-o', out], { encoding: 'utf8' });
    assert.equal(run.status, 2, run.stderr);
    assert.match(run.stderr, /\.obj or \.ply, or as \.glb/);
    assert.ok(!existsSync(out));
  }
  const upper = path.join(folder, 'QUADS.OBJ');
  const run = spawnSync(hgp, ['quads', file, '--cells', '60', '-o', upper], { encoding: 'utf8' });
  assert.equal(run.status, 0, run.stderr);
  assert.match(readFileSync(upper, 'utf8'), /^f /m);
});

for (const [file, euler] of models) {
  const name = path.basename(file);
  const options = existsSync(file) ? {} : { skip: `${file} is not here` };
  test(`quads of ${name} are pure, manifold and of valence k at cones`, options, async () => {
    const out = path.join(folder, 'out.obj');
    const report = path.join(folder, 'report.json');
    const run = (target) =>
      spawnSync(hgp, ['quads', file, '--cells', '6000', '-o', target, '--json', report], {
        encoding: 'utf8',
      });
    const asObj = run(out);
    assert.equal(asObj.status, 0, asObj.stderr);
    const { cones } = JSON.parse(readFileSync(report, 'utf8')).cones;
    checkQuads(
      readFileSync(out, 'utf8'),
      euler,
      cones.map((c) => c.k),
      name,
    );
    const glb = path.join(folder, 'out.glb');
    assert.equal(run(glb).status, 0);
    const bytes = new Uint8Array(readFileSync(glb));
    const { issues } = await validator.validateBytes(bytes);
    assert.deepEqual([issues.numErrors, issues.numWarnings], [0, 0], JSON.stringify(issues));
    const document = await new NodeIO().readBinary(bytes);
    const [primitive] = document.getRoot().listMeshes()[0].listPrimitives();
    const quads = readFileSync(out, 'utf8').match(/^f /gm).length;
    assert.equal(primitive.getIndices().getCount(), 6 * quads);
    // glTF has triangles only: the same quads are in an OBJ beside it.
    const beside = readFileSync(path.join(folder, 'out-quads.obj'), 'utf8');
    assert.equal(beside, readFileSync(out, 'utf8'));
  });
}
