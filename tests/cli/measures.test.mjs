// --faces and --loops: what there is to see of a map and of a surface, as tables.
import assert from 'node:assert/strict';
import test from 'node:test';
import { toObj } from '../support/meshes.mjs';
import { inFolder } from '../support/program.mjs';
import { torusMesh } from '../web/shapes.mjs';

const { put, read, good, run } = inFolder('measures');

test('--faces: a line for each triangle, in agreement with the certificate', () => {
  const mesh = torusMesh(14, 9);
  put('torus.obj', toObj(mesh));
  good('param', 'torus.obj', '-o', 'm.obj', '--faces', 'faces.csv', '--json', 'r.json');
  const [head, ...rows] = read('faces.csv').trim().split('\n');
  assert.equal(head, 'triangle,stretch,log2_area,overlaps');
  assert.equal(rows.length, mesh.triangles.length);
  const values = rows.map((row) => row.split(',').map(Number));
  values.forEach(([t], i) => assert.equal(t, i));
  const { distortion, overlap } = JSON.parse(read('r.json')).certificate.components[0];
  // μ = (σ₁ − σ₂) / (σ₁ + σ₂), of the ratio that the table has.
  const mu = Math.max(...values.map(([, s]) => (s - 1) / (s + 1)));
  assert.ok(Math.abs(mu - distortion.maxMu) < 1e-6, `${mu} ${distortion.maxMu}`);
  const areas = values.map(([, , area]) => area);
  const span = Math.max(...areas) - Math.min(...areas);
  assert.ok(Math.abs(span - (distortion.maxLogArea - distortion.minLogArea)) < 1e-5, `${span}`);
  const isAny = values.some(([, , , isIn]) => isIn === 1);
  if (overlap.share > 0.001) assert.ok(isAny);
});

test('--loops: closed walks that a prescription can name', () => {
  put('torus.obj', toObj(torusMesh(12, 8)));
  good('inspect', 'torus.obj', '--loops', 'loops.json');
  const { boundaries, handles } = JSON.parse(read('loops.json'));
  assert.deepEqual(boundaries, []);
  assert.equal(handles.length, 2);
  const { triangles } = torusMesh(12, 8);
  for (const edges of handles) {
    // Edges that follow one another belong to one triangle.
    edges.forEach((edge, i) => {
      const all = [...edge, ...edges[(i + 1) % edges.length]];
      assert.ok(
        triangles.some((t) => all.every((v) => t.includes(v))),
        `${all}`,
      );
    });
  }
  assert.equal(run('inspect', 'torus.obj', '--loops', 'torus.obj').code, 2);
});

test('inspect: the size of a mesh is that of its finite vertices', () => {
  const mesh = torusMesh(12, 8);
  const size = (name) => {
    good('inspect', name, '--json', 'inspect.json');
    return JSON.parse(read('inspect.json')).diagonal;
  };
  put('torus.obj', toObj(mesh));
  put('unused.obj', `${toObj(mesh)}\nv nan 0 0\nv 0 inf 0\n`);
  assert.ok(size('torus.obj') > 1);
  assert.equal(size('unused.obj'), size('torus.obj'));
});

test('with several components the log₂ areas are those of each, and a reason names its component', () => {
  const one = torusMesh(12, 8);
  const big = one.vertices.map((p) => p.map((x) => 3 * x + 20));
  const shift = one.vertices.length;
  const mesh = {
    vertices: [...one.vertices, ...big],
    triangles: [...one.triangles, ...one.triangles.map((t) => t.map((v) => v + shift))],
  };
  put('two.obj', toObj(mesh));
  good('param', 'two.obj', '-o', 'two-map.obj', '--faces', 'faces.csv', '--json', 'r.json');
  const areas = read('faces.csv').trim().split('\n').slice(1).map((row) => Number(row.split(',')[2])); // prettier-ignore
  JSON.parse(read('r.json')).certificate.components.forEach(({ distortion }, p) => {
    const own = areas.slice(p * one.triangles.length, (p + 1) * one.triangles.length);
    assert.ok(Math.abs(Math.min(...own) - distortion.minLogArea) < 1e-5, `component ${p}`);
    assert.ok(Math.abs(Math.max(...own) - distortion.maxLogArea) < 1e-5, `component ${p}`);
  });
  const lines = read('two-map.obj').trim().split('\n');
  const last = lines.findLastIndex((line) => line.startsWith('vt '));
  lines[last] = 'vt 1000 1000';
  put('torn.obj', `${lines.join('\n')}\n`);
  assert.equal(run('verify', 'torn.obj', '--json', 'torn.json').code, 6);
  const { components, triangles, flipped } = JSON.parse(read('torn.json'));
  assert.deepEqual(components[0].reasons, []);
  const { message } = components[1].reasons.find(({ rule }) => rule === 'orientation');
  assert.ok(
    message.startsWith(`In component 1: ${flipped} of ${triangles / 2} triangles`),
    message,
  );
});
