// Cones of one's own along features: `check` and `param` refuse the same ones, and what does not add up is refused before
// anything is solved.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { cubeMesh, toObj } from '../support/meshes.mjs';
import { inFolder } from '../support/program.mjs';

const { at, put, run } = inFolder('features-cones');
const report = () => JSON.parse(readFileSync(at('r.json'), 'utf8'));
const conesOf = (cones) => [...cones].flatMap(([v, k]) => ['--cone', `${v}:${k}`]);
const check = (cones, ...more) => run('check', 'in.obj', '--creases', ...conesOf(cones), ...more);
const param = (cones, ...more) => run('param', 'in.obj', '--creases', ...conesOf(cones), '-o', 'out.obj', '--force', '--json', 'r.json', ...more); // prettier-ignore

const cube = cubeMesh(6);
const corners = [0, 1, 2, 3, 4, 5, 6, 7];
const own = () => new Map(corners.map((v) => [v, 3]));

test('cones that need split edges are no contradiction for check', () => {
  put('in.obj', toObj(cube));
  assert.equal(check(own()).code, 0);
  assert.equal(param(own()).code, 0);
  const inside = cube.vertices.findIndex((_, v) => v > 7 && cube.triangles.filter((t) => t.includes(v)).length === 6); // prettier-ignore
  const codes = corners.map((corner) => {
    const cones = own();
    cones.delete(corner); // three triangles at some corners: too few for four quarter turns
    cones.set(inside, 3);
    const checked = check(cones).code;
    const mapped = param(cones).code;
    assert.ok(checked === 0 ? [0, 6].includes(mapped) : mapped === checked, `${checked} ${mapped}`);
    return checked;
  });
  assert.deepEqual(codes, codes.map(() => 0)); // prettier-ignore
});

test('a cone with fewer quarter turns than features leave it is refused at its place by both', () => {
  put('in.obj', toObj(cube));
  const cones = own();
  cones.set(corners[0], 2);
  cones.set(corners[5], 4);
  assert.equal(check(cones).code, 5);
  assert.equal(param(cones).code, 5);
  assert.deepEqual(report().where.map(({ id }) => id), [corners[0]]); // prettier-ignore
});

test('cones of a later component that do not add up are refused before the first is solved', () => {
  const { vertices, triangles } = cube;
  const n = vertices.length;
  put('in.obj', toObj({ vertices: [...vertices, ...vertices.map(([x, y, z]) => [x + 50, y, z])], triangles: [...triangles, ...triangles.map((t) => t.map((v) => v + n))] })); // prettier-ignore
  const cones = own();
  for (const v of corners.slice(1)) cones.set(v + n, 3);
  for (const features of [['--creases'], []]) {
    const { code, err } = run('param', 'in.obj', ...features, ...conesOf(cones), '-o', 'out.obj', '--force'); // prettier-ignore
    assert.equal(code, 5);
    assert.match(err, /component 1/);
    assert.doesNotMatch(err, /\bsolve\b/);
  }
  cones.set(corners[0] + n, 3);
  assert.equal(param(cones).code, 0);
});
