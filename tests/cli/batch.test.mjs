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
const [parallel, left, xargs, slurm] = [...guide.matchAll(/```sh\n([^]*?)```/g)].map(
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

/** `all` runs the batch once; again, it does only what is missing. */
function ranThrough(all) {
  rmSync(path.join(folder, 'mapped'), { recursive: true, force: true });
  mkdirSync(path.join(folder, 'mapped'));
  all();
  const done = () =>
    readdirSync(path.join(folder, 'mapped'))
      .filter((name) => name.endsWith('.obj'))
      .sort();
  assert.deepEqual(done(), ['a.obj', 'b c.obj', 'd.obj']);
  const time = () => statSync(path.join(folder, 'mapped/a.obj')).mtimeMs;
  const before = time();
  rmSync(path.join(folder, 'mapped/d.obj'));
  all();
  assert.deepEqual(done(), ['a.obj', 'b c.obj', 'd.obj']);
  assert.equal(time(), before, 'what is done is not done again');
}

test('GNU parallel', () => {
  assert.ok(existsSync('/usr/bin/parallel'), 'GNU parallel is not installed: run scripts/setup');
  ranThrough(() => sh(parallel));
  assert.match(sh(left), /^3 .*meshes\/broken\.obj.*\n$/, 'one file that cannot be read, by name');
  const report = JSON.parse(readFileSync(path.join(folder, 'reports/a.json'), 'utf8'));
  assert.equal(report.certified, true);
});

test('xargs', () => ranThrough(() => sh(xargs)));

const lists = () => {
  const names = readdirSync(path.join(folder, 'meshes'));
  writeFileSync(path.join(folder, 'list.txt'), names.map((name) => `meshes/${name}\n`).join(''));
};
/** Of the hundred tasks those that have a line of the list; the others find nothing to do. */
const tasks = [0, 1, 2, 3, 4];

test('the script of the Slurm array, task by task', () => {
  lists();
  ranThrough(() => {
    for (const task of tasks) sh(slurm, { SLURM_ARRAY_TASK_ID: String(task) });
  });
  const json = readFileSync(path.join(folder, 'mapped/b c.obj.json'), 'utf8');
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
