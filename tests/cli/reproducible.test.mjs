// --reproducible: a processor without fused multiply-add gives the same bytes as one that has it. The C library
// can be made to believe that it runs on such a one (GLIBC_TUNABLES), and then its own functions do differ.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import test, { after } from 'node:test';
import { blocks, eight } from '../support/blocks.mjs';
import { bumpyDisk } from '../support/disk.mjs';
import { cubeMesh, toGlb, toObj } from '../support/meshes.mjs';

const hgp =
  process.env.HGP_BIN ?? path.join(import.meta.dirname, '../../build/native-release/bin/hgp');
const folder = mkdtempSync(path.join(os.tmpdir(), 'hgp-reproducible-'));
after(() => rmSync(folder, { recursive: true }));

const older = 'glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4,-AVX2_Usable,-FMA_Usable,-FMA4_Usable';
const meshes = {
  'disk.obj': bumpyDisk(10),
  'eight.obj': toObj(blocks(eight, { n: 3 })),
  'cube.glb': toGlb([cubeMesh(6)]),
};
for (const [name, content] of Object.entries(meshes))
  writeFileSync(path.join(folder, name), content);

function bytesOf(name, options, tunables) {
  const env = { ...process.env };
  delete env.GLIBC_TUNABLES;
  if (tunables) env.GLIBC_TUNABLES = tunables;
  const out = `out${path.extname(name)}`;
  const args = ['param', name, '-o', out, ...options];
  const { status, stderr } = spawnSync(hgp, args, { cwd: folder, env, encoding: 'utf8' });
  assert.equal(status, 0, stderr);
  assert.doesNotMatch(stderr, /--reproducible/);
  return readFileSync(path.join(folder, out));
}

test('the same bytes with and without fused multiply-add in the C library', (t) => {
  let differed = 0;
  for (const name of Object.keys(meshes)) {
    for (const more of [[], ['--improve', 'isometric']]) {
      const [new_, old] = [null, older].map((tunables) => bytesOf(name, [...more, '--reproducible'], tunables)); // prettier-ignore
      assert.ok(new_.equals(old), `${name} ${more}`);
      differed += !bytesOf(name, more, null).equals(bytesOf(name, more, older));
    }
  }
  t.diagnostic(`without the option ${differed} of 6 differ`);
  if (differed === 0) t.diagnostic('this processor has no fused multiply-add: nothing was shown');
});

test('standard input survives, and other tunables do', () => {
  const env = { ...process.env, GLIBC_TUNABLES: 'glibc.malloc.arena_max=2' };
  const { status, stdout } = spawnSync(hgp, ['param', '-', '-o', '-', '-q', '--reproducible'], {
    input: meshes['disk.obj'],
    encoding: 'utf8',
    env,
  });
  assert.equal(status, 0);
  assert.match(stdout, /\nvt /);
});
