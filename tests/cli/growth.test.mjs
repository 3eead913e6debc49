// What grows with a file and what must not: measured against itself in the released build.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import test from 'node:test';
import { cubeMesh, toGlb } from '../support/meshes.mjs';
import { hgp, inFolder } from '../support/program.mjs';

const { folder, put } = inFolder('growth');

/** `count` cubes in a row. */
function row(count) {
  const { vertices, triangles } = cubeMesh(1);
  const lines = [];
  for (let c = 0; c < count; c++) {
    for (const [x, y, z] of vertices) lines.push(`v ${x + 3 * c} ${y} ${z}`);
    for (const t of triangles)
      lines.push(`f ${t.map((v) => v + 1 + vertices.length * c).join(' ')}`);
  }
  return `${lines.join('\n')}\n`;
}

/** The lesser user time of two runs, as others use the machine, too; of the program alone. */
function secondsOf(...args) {
  const times = [0, 1].map(() => {
    const timed = spawnSync(
      '/bin/bash',
      ['-c', 'TIMEFORMAT=%U; time "$0" "$@"', hgp, ...args, '--force', '--quiet'],
      { cwd: folder },
    );
    assert.equal(timed.status, 0, String(timed.stderr));
    return Number(String(timed.stderr).trim());
  });
  return Math.min(...times);
}

test('the cost of a component does not grow with the number of components', () => {
  const seconds = [500, 4000].map((count) => {
    put('row.obj', row(count));
    return secondsOf('param', 'row.obj', '-o', 'row_out.obj');
  });
  // Eight times the components: quadratic cost would be 64 times the time.
  assert.ok(seconds[1] < 16 * (seconds[0] + 0.02), seconds.join(' and '));
});

test('the cost of a mesh does not grow with the number of meshes in a file', () => {
  const seconds = [100, 800].map((count) => {
    put('many.glb', toGlb(Array.from({ length: count }, () => cubeMesh(1))));
    return secondsOf('param', 'many.glb', '-o', 'many_out.glb');
  });
  // Quadratic cost would be 64 times the time; it was 9 s for 800.
  assert.ok(seconds[1] < 16 * (seconds[0] + 0.02), seconds.join(' and '));
});

test('10 000 components take about 4 KB a triangle', () => {
  const count = 10000;
  const lines = [];
  for (let c = 0; c < count; c++) {
    const at = [3 * (c % 100), 3 * Math.floor(c / 100)];
    for (const [x, y, z] of ['000', '100', '010', '001'].map((p) => [...p].map(Number)))
      lines.push(`v ${x + at[0]} ${y + at[1]} ${z}`);
    for (const t of ['021', '013', '123', '032'])
      lines.push(`f ${[...t].map((v) => Number(v) + 1 + 4 * c).join(' ')}`);
  }
  put('many.obj', `${lines.join('\n')}\n`);
  // 4 KB for each of the triangles, and 60 MB of address space for the program and its libraries. The text of the
  // report, which was read as a tree, took another 55 MB; the file of --json, which was copied, takes only itself.
  const limit = 4 * 4 * count + 60000;
  const solve = (extra, ...words) =>
    spawnSync(
      '/bin/bash',
      [
        '-c',
        `ulimit -v ${limit + extra}; exec "$0" param many.obj -o many_out.obj --force "$@"`,
        ...[hgp, ...words],
      ],
      { cwd: folder, encoding: 'utf8', maxBuffer: 1 << 26 },
    );
  const { status, stderr } = solve(0);
  assert.equal(status, 0, stderr);
  // What is listed one by one, and what is only counted.
  assert.match(stderr, /^many.obj {2}40000 triangles, 40000 cones of q = 4/m);
  assert.match(stderr, /\n {2}component 19 [^]*… and 9980 more components, all as asked\n/);
  assert.doesNotMatch(stderr, /component 20 /);
  const json = solve(10000, '--quiet', '--json', 'many.json');
  assert.equal(json.status, 0, json.stderr);
});
