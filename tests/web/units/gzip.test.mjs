import assert from 'node:assert/strict';
import test from 'node:test';
import { gzipSync } from 'fflate';
import { unpack } from '../../../web/src/formats/file_set.ts';
import { gunzip } from '../../../web/src/formats/gzip.ts';

const text = new TextEncoder().encode('v 0 0 0\n'.repeat(40));
const packed = Buffer.from(gzipSync(text));
const open = (...parts) => gunzip(new Blob(parts));

test('one member, several, and what some tools put behind the last', async () => {
  assert.deepEqual(await open(packed), text);
  assert.deepEqual(Buffer.from(await open(packed, packed)), Buffer.concat([text, text]));
  assert.deepEqual(await open(packed, new Uint8Array(512)), text);
  assert.deepEqual(await open(packed, 'signature'), text);
});

test('a file that is cut short anywhere, or changed, is never taken for a whole one', async () => {
  for (let size = 1; size < packed.length; size++) {
    await assert.rejects(open(packed.subarray(0, size)), /damaged or cut off/, `${size}`);
  }
  const wrong = Buffer.from(packed);
  wrong[wrong.length - 6] ^= 1; // of the sum
  await assert.rejects(open(wrong), /damaged or cut off/);
  await assert.rejects(open('v 0 0 0\n'), /damaged or cut off/);
});

test('a bomb is noticed while it unpacks', async () => {
  const bomb = gzipSync(new Uint8Array(3e7));
  await assert.rejects(open(bomb), /far more than it should/);
  await assert.rejects(open(bomb, packed), /far more than it should/);
});

test('dropped, it is the file that is inside', async () => {
  const files = await unpack(new Map([['a/mesh.obj.gz', new Blob([packed])]]));
  assert.deepEqual([...files], [['mesh.obj', text]]);
});
