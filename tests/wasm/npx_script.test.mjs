// The script of `npx hgp`, with a stand-in for the compiled program: what it passes on, how files appear that are
// compressed, and how it ends. The program itself is compared with the native one in command_line.test.mjs.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { gzipSync } from 'node:zlib';
import { root, scratch } from './support.mjs';

const folder = scratch('npx');
const temporary = path.join(folder, 'temporary');
fs.mkdirSync(temporary);
const at = (name) => path.join(folder, name);
const support = (name) => path.join(root, 'tests/support', name);

/** What the program was given and did, and how the script ended. */
function run(...words) {
  const hooks = ['typescript.mjs', 'program_stand_in.mjs'].flatMap((name) => ['--import', support(name)]); // prettier-ignore
  const script = path.join(root, 'wasm/package/src/node/cli.ts');
  const env = { ...process.env, TMPDIR: temporary };
  const { status, stdout, stderr } = spawnSync(process.execPath, [...hooks, script, ...words], { env, encoding: 'utf8' }); // prettier-ignore
  const [begin, ...done] = stdout
    .split('\n')
    .filter(Boolean)
    .map((line) => JSON.parse(line));
  assert.deepEqual(fs.readdirSync(temporary), [], 'nothing stays in the folder for such files');
  return { begin, done, status, stderr };
}

test('the program has its name, its module, all words, and the decoders if it may read a glTF', () => {
  for (const [words, decoders] of [
    [['say', 'a b', '--x=1'], []],
    [['say', 'cube.obj', 'my.glb.obj'], []],
    [
      ['say', 'cube.glb'],
      ['draco', 'meshopt'],
    ],
    [
      ['x.obj', 'CUBE.GLTF.gz', 'say'],
      ['draco', 'meshopt'],
    ],
    [
      ['say', '-'],
      ['draco', 'meshopt'],
    ],
  ]) {
    const { begin, done, status, stderr } = run(...words);
    assert.deepEqual({ begin, done, status, stderr }, { begin: { thisProgram: 'hgp', wasm: true, decoders }, done: [words], status: 0, stderr: '' }); // prettier-ignore
  }
});

test('what is opened for reading appears decompressed, whatever its name; all else as it is', () => {
  const packed = gzipSync('some text');
  const files = { 'a.gz': packed, 'a.obj': packed, 'plain.gz': Buffer.from('plain'), one: packed.subarray(0, 1), empty: Buffer.alloc(0), half: Buffer.of(0x1f, 0x8c, 1), other: Buffer.of(0x1e, 0x8b, 1) }; // prettier-ignore
  for (const [name, content] of Object.entries(files)) fs.writeFileSync(at(name), content);
  const { O_RDONLY, O_WRONLY, O_RDWR, O_NOFOLLOW } = fs.constants;
  const words = [];
  const expected = [];
  for (const [name, content] of Object.entries(files))
    for (const flags of ['r', O_RDONLY, O_RDONLY | O_NOFOLLOW, 'r+', O_RDWR, O_WRONLY]) {
      words.push(`open,${at(name)},${flags}`);
      const isRead = flags === 'r' || flags === O_RDONLY || flags === (O_RDONLY | O_NOFOLLOW);
      const text = isRead && content === packed ? 'some text' : flags === O_WRONLY ? '' : content.toString('latin1'); // prettier-ignore
      expected.push({ name: at(name), isFolder: false, content: text, more: 1 });
    }
  words.push(`open,${folder},r`);
  expected.push({ name: folder, isFolder: true, content: '', more: 1 });
  const { done, status, stderr } = run(...words);
  assert.deepEqual(done, expected);
  assert.deepEqual([status, stderr], [0, '']);
  for (const [name, content] of Object.entries(files)) assert.deepEqual(fs.readFileSync(at(name)), content, name); // prettier-ignore
});

test('it ends as the program does; damaged files and those that are too large have their codes', () => {
  for (const status of [0, 1, 5]) assert.deepEqual(run(`end,${status}`).status, status);
  const failed = run('fail,so it is');
  assert.notEqual(failed.status, 0);
  assert.match(failed.stderr, /so it is/);
  for (const [length, status] of [
    [100, 0],
    [101, 8],
  ]) {
    // prettier-ignore
    fs.writeFileSync(at('large.gz'), gzipSync(Buffer.alloc(length, 'x')));
    const ended = run(`open,${at('large.gz')},r`, 'say');
    assert.equal(ended.status, status);
    assert.equal(ended.done.length, status === 0 ? 2 : 0);
    if (status > 0) assert.match(ended.stderr, /^hgp: .+\n$/);
  }
  const whole = gzipSync('x'.repeat(90));
  for (const damaged of [whole.subarray(0, 12), whole.with(12, 255)]) {
    fs.writeFileSync(at('damaged.gz'), damaged);
    const { status, done, stderr } = run(`open,${at('damaged.gz')},r`, 'say');
    assert.deepEqual([status, done], [3, []]);
    assert.match(stderr, /^hgp: .+\n$/);
  }
});
