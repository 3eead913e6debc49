import assert from 'node:assert/strict';
import test from 'node:test';
import { zipSync } from 'fflate';
import { unzip } from '../../../web/src/formats/zip.ts';

const text = new TextEncoder().encode('v 0 0 0\n'.repeat(40));
const open = (bytes) => unzip(new Blob([bytes]));

test('files come out byte for byte; folders and archives inside are left out', async () => {
  const found = await open(
    zipSync({ 'a/mesh.obj': text, 'b/': new Uint8Array(0), 'inner.zip': text, empty: new Uint8Array(0) }), // prettier-ignore
  );
  assert.deepEqual([...found.keys()], ['a/mesh.obj', 'empty']);
  assert.deepEqual(found.get('a/mesh.obj'), text);
  assert.equal(found.get('empty').length, 0);
});

test('names that lead out of the folder are refused', async () => {
  for (const name of ['../a.obj', 'a/../../b.obj', '/a.obj', '\\a.obj', '..\\a.obj', 'C:a.obj']) {
    await assert.rejects(open(zipSync({ [name]: text })), /outside its folder/, name);
  }
  // A name is a key of a map and of nothing else.
  const found = await open(zipSync({ ['__proto__/constructor.obj']: text }));
  assert.deepEqual([...found.keys()], ['__proto__/constructor.obj']);
});

test('a truncated file is never accepted as complete', async () => {
  const whole = zipSync({ 'a.obj': text });
  const header = 30 + 'a.obj'.length;
  const directory = 46 + 'a.obj'.length + 22;
  for (let size = header + 1; size < whole.length - directory; size++) {
    await assert.rejects(open(whole.subarray(0, size)), /cannot be|ends in the middle/, `${size}`);
  }
});

test('an unknown method of compression is named', async () => {
  const bytes = Buffer.from(zipSync({ 'a.obj': text }));
  bytes.writeUInt16LE(99, 8);
  await assert.rejects(open(bytes), /a\.obj cannot be unpacked/);
});

test('a ZIP that unpacks to far more than it should is stopped', async () => {
  await assert.rejects(open(zipSync({ 'a.obj': new Uint8Array(3e7) })), /far more than it should/);
});

test('too many files are refused', async () => {
  const files = Object.fromEntries(Array.from({ length: 10_001 }, (_, i) => [`${i}`, text.subarray(0, 1)])); // prettier-ignore
  await assert.rejects(open(zipSync(files, { level: 0 })), /more than 10000 files/);
});
