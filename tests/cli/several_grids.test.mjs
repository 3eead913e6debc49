// A file of several meshes with one grid: every component is aligned, or the run ends with 6 and says which is not.
import assert from 'node:assert/strict';
import test from 'node:test';
import { Random } from '../attack/random.mjs';
import { cubeMesh, toGlb } from '../support/meshes.mjs';
import { inFolder } from '../support/program.mjs';
import { flatSquare, torusMesh } from '../web/shapes.mjs';

const { put, run, read } = inFolder('several-grids');

const scaled = ({ vertices, triangles }, size) => ({
  vertices: vertices.map((point) => point.map((x) => size * x)),
  triangles,
});

test('with several meshes every component is aligned, or the run ends with 6 and says why not', () => {
  const random = new Random(6);
  const shapes = [cubeMesh(3), cubeMesh(4), torusMesh(12, 8), flatSquare(6)];
  let aligned = 0;
  for (let n = 0; n < 8; n++) {
    const meshes = Array.from({ length: 3 }, () =>
      scaled(shapes[random.integer(0, 3)], 10 ** (random.integer(0, 20) / 10 - 1)),
    );
    const file = put(`${n}.glb`, toGlb(meshes));
    const [cells, mode] = [[60, 400, 2000][n % 3], ['tile', 'quad'][n % 2]];
    const done = run('param', file, '--cells', `${cells}`, '--grid-mode', mode, '-o', 'map.glb', '--force', '--json', 'map.json'); // prettier-ignore
    const components = JSON.parse(read('map.json')).meshes.flatMap(({ document }) => document.components); // prettier-ignore
    assert.equal(components.length, 3);
    const all = components.every(({ grid }) => grid?.aligned);
    assert.equal(done.code, all ? 0 : 6, `${cells} ${mode}: ${done.err}`);
    for (const { grid } of components) if (!grid?.aligned) assert.ok(grid?.reason, done.err);
    if (!all) continue;
    aligned++;
  }
  assert.ok(aligned >= 4, `${aligned} of 8 files are aligned`);
});
