// `hgp cones`: given cones are completed, and moved to another version of the mesh; what cannot be is refused or told.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { cubeMesh, toGlb, toObj } from '../support/meshes.mjs';
import { inFolder } from '../support/program.mjs';

const { at, put, good, run } = inFolder('cones');

const conesOf = (list, q = 4) =>
  JSON.stringify({
    format: 'hgp-cones',
    version: 1,
    q,
    cones: list.map(([vertex, k]) => ({ vertex, k })),
  });
const read = (name) => JSON.parse(readFileSync(at(name), 'utf8'));

test('the cones of a file are completed, kept, and give a certified map', () => {
  put('cube.obj', toObj(cubeMesh(5)));
  put('mine.json', conesOf([[60, 5]])); // prettier-ignore
  good('cones', at('cube.obj'), '--balance', at('mine.json'), '-o', at('all.json'));
  const { cones } = read('all.json');
  assert.equal(cones.length, 10);
  assert.ok(cones.some(({ vertex, k }) => vertex === 60 && k === 5));
  good('check', at('cube.obj'), '--cones', at('all.json'));
  good('param', at('cube.obj'), '--cones', at('all.json'), '-o', at('out.obj'));
  good('verify', at('out.obj'), '--cones', at('all.json'));
});

test('what no vertex can take is refused as a prescription, with the number', () => {
  put('tiny.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n');
  put('many.json', conesOf([0, 1, 2].map((vertex) => [vertex, 5]))); // prettier-ignore
  const { code: status, err: stderr } = run('cones', at('tiny.obj'), '--balance', at('many.json'));
  assert.equal(status, 5);
  assert.match(stderr, /11·360°\/4 are missing/);
});

test('cones move to a version with other numbers; the options belong together', () => {
  const mesh = cubeMesh(3);
  const last = mesh.vertices.length - 1;
  const triangles = mesh.triangles.map((t) => t.map((v) => last - v));
  put('old.obj', toObj(mesh));
  put('new.obj', toObj({ vertices: [...mesh.vertices].reverse(), triangles }));
  put('old.json', conesOf([[4, 3], [9, 5]])); // prettier-ignore
  const ways = ['--transfer', at('old.json'), '--from', at('old.obj')];
  const { err: stderr } = good('cones', at('new.obj'), ...ways, '-o', at('new.json'));
  assert.equal(stderr, '');
  const moved = read('new.json').cones.map(({ vertex, k }) => [vertex, k]);
  assert.deepEqual(moved, [[last - 4, 3], [last - 9, 5]]); // prettier-ignore
  assert.equal(run('cones', at('new.obj'), '--transfer', at('old.json')).code, 2);
  assert.equal(run('cones', at('new.obj'), '--from', at('old.obj')).code, 2);
  const both = run('cones', at('new.obj'), ...ways, '--balance', at('old.json'));
  assert.equal(both.code, 2);
  // No output replaces what is read.
  assert.equal(run('cones', at('new.obj'), ...ways, '-o', at('old.obj')).code, 2);
});

/** The sum of the areas of all triangles. */
const areaOf = ({ vertices, triangles }) =>
  triangles.reduce((sum, t) => {
    const [a, b, c] = t.map((v) => vertices[v]);
    const [u, v] = [b, c].map((p) => p.map((x, k) => x - a[k]));
    const normal = [0, 1, 2].map(
      (k) => u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3],
    );
    return sum + Math.hypot(...normal) / 2;
  }, 0);

test('--cells auto: another word is refused, and the meshes of a file have cells of one size', () => {
  const cubes = [cubeMesh(6), cubeMesh(4)];
  put('two.glb', toGlb(cubes));
  put('cube.obj', toObj(cubeMesh(6)));
  assert.equal(run('param', at('cube.obj'), '--cells', 'many', '-o', at('x.obj')).code, 2);
  assert.equal(run('param', at('cube.obj'), '--cells', '0', '-o', at('x.obj')).code, 2);
  const both = run('param', at('cube.obj'), '--cells', 'auto', '--grid', '1', '-o', at('x.obj'));
  assert.equal(both.code, 2);
  good('param', at('two.glb'), '--cells', 'auto', '-o', at('grid.glb'), '--json', at('two.json'));
  const { meshes } = read('two.json');
  meshes.forEach(({ document }, i) => {
    const perArea = document.options.grid.cells / areaOf(cubes[i]);
    assert.ok(Math.abs(perArea / (800 / areaOf(cubes[0])) - 1) < 1e-3, `${perArea} cells`);
    assert.ok(document.components.every(({ grid }) => grid.aligned));
  });
  const quads = ['quads', at('cube.obj'), '--force', '-o'];
  good(...quads, at('a.obj'));
  good(...quads, at('b.obj'), '--cells', 'auto');
  assert.equal(readFileSync(at('a.obj'), 'utf8'), readFileSync(at('b.obj'), 'utf8'));
});

test('inspect says how often the nodes of a glTF show a mesh', () => {
  put('one.glb', toGlb([cubeMesh(2), cubeMesh(1)]));
  const { out: stdout } = good('inspect', at('one.glb'), '--json', '-');
  for (const { uses, mirrored } of JSON.parse(stdout).surfaces)
    assert.deepEqual([uses, mirrored], [1, false]);
});

test('another number of cones than asked for is told, and only then', () => {
  put('cube.obj', toObj(cubeMesh(5)));
  const told = (...args) => good('cones', at('cube.obj'), '--no-progress', ...args, '-o', at('few.json')).err; // prettier-ignore
  for (const asked of [1, 8, 10_000]) {
    const err = told('--count', asked);
    const placed = read('few.json').cones.length;
    assert.equal(err !== '', placed !== asked, `${asked}: ${err}`);
    if (err) assert.match(err, new RegExp(`\\b${asked}\\b.*\\b${placed}\\b`));
  }
  assert.equal(told('--count', 1, '--quiet'), '');
  assert.equal(told(), '');
});

test('a component is named once where cones for it cannot be chosen', () => {
  const { vertices, triangles } = cubeMesh(2);
  const moved = vertices.map(([x, y, z]) => [x + 5, y, z]);
  const second = triangles.map((t) => t.map((v) => v + vertices.length));
  const two = { vertices: [...vertices, ...moved], triangles: [...triangles, ...second] };
  put('two.obj', toObj(two));
  for (const args of [
    ['cones', at('two.obj')],
    ['param', at('two.obj'), '-o', at('two.out.obj')],
  ]) {
    const { code, err } = run(...args, '--q', 1, '--no-progress');
    assert.equal(code, 5);
    assert.equal(err.split('component').length, 2, err);
  }
});
