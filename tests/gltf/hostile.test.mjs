// Every broken or malicious file ends in the promised code and message: no crash, no hang, no
// allocation beyond the cap.

import assert from 'node:assert/strict';
import { mkdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { harmlessFiles, hostileFiles } from './hostile_files.mjs';
import { hasMeshes, isWasm, meshes, runProbe, scratch } from './probe.mjs';

const folder = path.join(scratch, 'hostile');
mkdirSync(folder, { recursive: true });
const caps = ['--max-bytes', `${256 << 20}`, '--max-triangles', '200000'];

function store({ name, bytes }) {
  const file = path.join(folder, name);
  writeFileSync(file, bytes);
  return file;
}

const hostile = hostileFiles();
// One process for all: whoever crashes is the last line.
const results = runProbe([...caps, ...hostile.map(store)], { seconds: 300 });

test('the suite has at least its minimum size', () => {
  assert.ok(hostile.length >= 60, `${hostile.length} files`);
  assert.equal(new Set(hostile.map(({ name }) => name)).size, hostile.length);
});

hostile.forEach(({ name, exit, code, message }, i) => {
  test(name, () => {
    const result = results[i];
    assert.ok(result, 'the run ended before this file');
    assert.equal(result.crashed, undefined);
    assert.equal(path.basename(result.file), name);
    const isUndecodable = isWasm && /^(draco|meshopt)/.test(name) && result.code === 'unsupported';
    if (isUndecodable) {
      assert.match(result.message, /no decoder/);
      return;
    }
    assert.equal(result.ok, false, 'must be refused');
    assert.deepEqual([result.exit, result.code], [exit, code], result.message);
    assert.match(result.message, message);
    assert.ok(result.message.length < 1000, 'messages stay short');
  });
});

test('odd but legal files are read', () => {
  const harmless = harmlessFiles();
  const read = runProbe([...caps, ...harmless.map(store)]);
  harmless.forEach(({ name }, i) =>
    assert.equal(read[i]?.ok, true, `${name}: ${read[i]?.message}`),
  );
});

test('optional data', { skip: hasMeshes ? false : `${meshes} is not there` }, () => {
  const shared = (name) => path.join(meshes, 'gltf', name);
  const [index, buffer] = runProbe([
    shared('IndexOutOfRange/IndexOutOfRange.gltf'),
    shared('invalid-buffer-index.gltf'),
  ]);
  assert.equal(index.exit, 3);
  assert.match(index.message, /\/meshes\/0\/primitives\/0\/indices: entry 0 is 255/);
  assert.equal(buffer.exit, 3);
  assert.match(buffer.message, /\/bufferViews\/1\/buffer/);
});
