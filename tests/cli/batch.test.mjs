// docs/batch.md as printed: a batch does every file, leaves what is done alone, and says what failed.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import {
  existsSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  readdirSync,
  rmSync,
  statSync,
  writeFileSync,
} from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import test, { after } from 'node:test';
import { cubeMesh, toObj } from '../support/meshes.mjs';

const hgp =
  process.env.HGP_BIN ?? path.join(import.meta.dirname, '../../build/native-release/bin/hgp');
const folder = mkdtempSync(path.join(os.tmpdir(), 'hgp-batch-'));
after(() => rmSync(folder, { recursive: true }));

const guide = readFileSync(path.join(import.meta.dirname, '../../docs/batch.md'), 'utf8');
const [parallel, left, xargs] = [...guide.matchAll(/```sh\n([^]*?)```/g)].map(([, text]) => text);
const env = { ...process.env, PATH: `${path.dirname(hgp)}:${process.env.PATH}` };
const sh = (script) => {
  try {
    return execFileSync('sh', ['-c', script], {
      cwd: folder,
      env,
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

function ranThrough(script) {
  rmSync(path.join(folder, 'mapped'), { recursive: true, force: true });
  mkdirSync(path.join(folder, 'mapped'));
  sh(script);
  const done = () => readdirSync(path.join(folder, 'mapped')).sort();
  assert.deepEqual(done(), ['a.obj', 'b c.obj', 'd.obj']);
  const time = () => statSync(path.join(folder, 'mapped/a.obj')).mtimeMs;
  const before = time();
  rmSync(path.join(folder, 'mapped/d.obj'));
  sh(script);
  assert.deepEqual(done(), ['a.obj', 'b c.obj', 'd.obj']);
  assert.equal(time(), before, 'what is done is not done again');
}

test('GNU parallel', () => {
  assert.ok(existsSync('/usr/bin/parallel'), 'GNU parallel is not installed: run scripts/setup');
  ranThrough(parallel);
  assert.match(sh(left), /\b1 3\b/, 'one file that cannot be read');
  const report = JSON.parse(readFileSync(path.join(folder, 'reports/a.json'), 'utf8'));
  assert.equal(report.certified, true);
});

test('xargs', () => ranThrough(xargs));
