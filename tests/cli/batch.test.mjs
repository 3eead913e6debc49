// docs/batch.md as printed: a batch does every file, leaves what is done alone, and says what failed.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import {
  existsSync,
  mkdirSync,
  readFileSync,
  readdirSync,
  rmSync,
  statSync,
  writeFileSync,
} from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { cubeMesh, toObj } from '../support/meshes.mjs';
import { hgp, inFolder } from '../support/program.mjs';

const { folder } = inFolder('batch');

const guide = readFileSync(path.join(import.meta.dirname, '../../docs/batch.md'), 'utf8');
const [parallel, left, again, xargs, slurm] = [...guide.matchAll(/```sh\n([^]*?)```/g)].map(
  ([, text]) => text,
);
const env = { ...process.env, PATH: `${path.dirname(hgp)}:${process.env.PATH}` };
const sh = (script, more = {}) => {
  try {
    return execFileSync('sh', ['-c', script], {
      cwd: folder,
      env: { ...env, ...more },
      encoding: 'utf8',
      stdio: 'pipe',
    });
  } catch (error) {
    // parallel and xargs end with an error when a file failed, as one does here.
    return error.stdout;
  }
};

mkdirSync(path.join(folder, 'meshes'));
for (const [name, n] of Object.entries({ 'a.obj': 2, 'b c.obj': 3, 'd.obj': 4 })) {
  writeFileSync(path.join(folder, 'meshes', name), toObj(cubeMesh(n)));
}
writeFileSync(path.join(folder, 'meshes/broken.obj'), 'v 0 0 0\nf 1 2 3\n');
// A name that occurs twice, in different folders.
mkdirSync(path.join(folder, 'meshes/sub dir'));
writeFileSync(path.join(folder, 'meshes/sub dir/a.obj'), toObj(cubeMesh(3)));

/** `all` runs the batch once; again, it does only what is missing. */
function ranThrough(all) {
  rmSync(path.join(folder, 'mapped'), { recursive: true, force: true });
  mkdirSync(path.join(folder, 'mapped'));
  all();
  const mapped = path.join(folder, 'mapped/meshes');
  const done = () =>
    readdirSync(mapped, { recursive: true })
      .filter((name) => name.endsWith('.obj'))
      .sort();
  const every = ['a.obj', 'b c.obj', 'd.obj', 'sub dir/a.obj'];
  assert.deepEqual(done(), every);
  const time = () => statSync(path.join(mapped, 'a.obj')).mtimeMs;
  const before = time();
  rmSync(path.join(mapped, 'd.obj'));
  all();
  assert.deepEqual(done(), every);
  assert.equal(time(), before, 'what is done is not done again');
}

test('GNU parallel', () => {
  assert.ok(existsSync('/usr/bin/parallel'), 'GNU parallel is not installed: run scripts/setup');
  ranThrough(() => sh(parallel));
  assert.equal(sh(left), '3 meshes/broken.obj\n');
  const report = (name) => JSON.parse(readFileSync(path.join(folder, `reports/meshes/${name}`)));
  assert.equal(report('a.json').certified, true);
  assert.equal(report('sub dir/a.json').certified, true);
  assert.equal(report('broken.json').file, 'meshes/broken.obj');
  assert.equal(sh(again), '', 'nothing ended with 6');
});

test('xargs', () => ranThrough(() => sh(xargs)));

const lists = () => {
  const names = readdirSync(path.join(folder, 'meshes'), { recursive: true }).filter((name) =>
    name.endsWith('.obj'),
  );
  writeFileSync(path.join(folder, 'list.txt'), names.map((name) => `meshes/${name}\n`).join(''));
};
/** Of the hundred tasks those that have a line of the list; the others find nothing to do. */
const tasks = [0, 1, 2, 3, 4, 5];

test('the script of the Slurm array, task by task', () => {
  lists();
  ranThrough(() => {
    for (const task of tasks) sh(slurm, { SLURM_ARRAY_TASK_ID: String(task) });
  });
  const json = readFileSync(path.join(folder, 'mapped/meshes/b c.obj.json'), 'utf8');
  assert.equal(JSON.parse(json).certified, true);
});

test('the script of the Kubernetes Job, task by task, with /data as it is here', () => {
  lists();
  const [, block] = guide.match(/```yaml\n([^]*?)```/);
  const [, indent, script] = block.match(/- \|\n( +)([^]*?)\n +resources:/);
  const here = script
    .replaceAll(`\n${indent}`, '\n')
    .replaceAll('/data/list.txt', 'list.txt')
    .replaceAll('/data/', '');
  assert.doesNotMatch(here, /data/);
  ranThrough(() => {
    for (const task of tasks) sh(here, { JOB_COMPLETION_INDEX: String(task) });
  });
});
