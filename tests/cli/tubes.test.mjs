// Few cones and all handles given on a long tube: maps that lead to others end with one crushed triangle beside a vertex
// that turns once too often, while a cone turns once too little.
import assert from 'node:assert/strict';
import test from 'node:test';
import { toObj } from '../support/meshes.mjs';
import { inFolder } from '../support/program.mjs';

const { put, run, read } = inFolder('tubes');

/** A closed tube of a × b fields, its radius much less than its length. */
function tube(a, b, radius) {
  const vertices = [];
  const triangles = [];
  const at = (i, j) => (j % b) * a + (i % a);
  for (let j = 0; j < b; j++)
    for (let i = 0; i < a; i++) {
      const [u, v] = [(2 * Math.PI * i) / a, (2 * Math.PI * j) / b];
      const r = 1 + radius * Math.cos(v);
      vertices.push([r * Math.cos(u), r * Math.sin(u), radius * Math.sin(v)]);
      const [p, q, s, t] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
      triangles.push([p, q, s], [p, s, t]);
    }
  return { vertices, triangles };
}

test('three cones and both handles on a long tube are certified', () => {
  const file = put('tube.obj', toObj(tube(48, 6, 0.08)));
  for (const [q, cones, handles] of [
    [8, ['148:7', '64:6', '250:11'], ['0:6', '1:6']],
    [12, ['136:9', '231:11', '249:16'], ['0:0', '1:8']],
  ]) {
    const asked = [...cones.map((cone) => ['--cone', cone]), ...handles.map((turn) => ['--handle', turn])].flat(); // prettier-ignore
    const done = run('param', file, '--q', `${q}`, asked, '-o', 'map.obj', '--force', '--reproducible'); // prettier-ignore
    assert.equal(done.code, 0, done.err);
  }
});

test('handles that are left open turn otherwise where their smoothest turns have no map, and the report says so', () => {
  for (const [a, b, radius, q, cones] of [
    [32, 6, 0.08, 4, ['62:2', '26:6', '74:4', '107:4']],
    [24, 8, 0.15, 3, ['120:1', '99:5', '4:3', '79:3']],
  ]) {
    const file = put('open.obj', toObj(tube(a, b, radius)));
    const asked = cones.flatMap((cone) => ['--cone', cone]);
    const all = ['--q', `${q}`, ...asked, '-o', 'map.obj', '--force', '--reproducible'];
    const done = run('param', file, all, '--json', 'open.json');
    assert.equal(done.code, 0, done.err);
    const [component] = JSON.parse(read('open.json')).components;
    assert.match(component.rounds.at(-1).method, /^other handles: /);
    assert.ok(component.rounds.some(({ method }) => /^untangled/.test(method)));
  }
});
