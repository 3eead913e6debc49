import assert from 'node:assert/strict';
import test from 'node:test';
import { gzipSync } from 'fflate';
import { unpack } from '../../../web/src/formats/file_set.ts';
import { gunzip, ignoredBytes } from '../../../web/src/formats/gzip.ts';

const text = new TextEncoder().encode('v 0 0 0\n'.repeat(40));
const packed = Buffer.from(gzipSync(text));
const open = (...parts) => gunzip(new Blob(parts));

test('one member, several members, and bytes after the last one', async () => {
  assert.deepEqual(await open(packed), text);
  assert.deepEqual(Buffer.from(await open(packed, packed)), Buffer.concat([text, text]));
  assert.deepEqual(await open(packed, new Uint8Array(512)), text);
  assert.deepEqual(await open(packed, 'signature'), text);
  const ignored = async (...parts) => ignoredBytes(await open(...parts));
  assert.equal(await ignored(packed, 'signature'), 9);
  assert.equal(await ignored(packed, packed, 'x'), 1);
  for (const parts of [[packed], [packed, packed], [packed, new Uint8Array(512)]])
    assert.equal(await ignored(...parts), 0);
  const start = text.slice(0, 80);
  const both = Buffer.concat([text, start]);
  assert.deepEqual(
    Buffer.from(await open(packed, new Uint8Array(512), gzipSync(start), '\0')),
    both,
  );
});

test('any changed or missing byte in a file of several members is detected', async () => {
  const parts = [packed, Buffer.from(gzipSync(text.slice(0, 80))), packed];
  const all = Buffer.concat(parts);
  const whole = Buffer.from(await open(all));
  for (let size = 1; size < all.length; size++) {
    const isWhole = size === packed.length || size === packed.length + parts[1].length;
    const begun = open(all.subarray(0, size)).then((bytes) => Buffer.from(bytes));
    // Less than three bytes of another member are bytes behind the last one.
    const rest = [packed.length, packed.length + parts[1].length].map((end) => size - end);
    if (isWhole || rest.some((more) => more === 1 || more === 2)) {
      const bytes = await begun;
      assert.deepEqual(bytes, whole.subarray(0, bytes.length), `${size}`);
    } else await assert.rejects(begun, /damaged or cut off/, `${size}`);
  }
  const header = [0, 1, 2]; // what says that a member begins; damaged, what follows is no gzip
  const starts = [0, packed.length, packed.length + parts[1].length];
  let accepted = 0;
  for (let at = 0; at < all.length; at++) {
    const inMember = at - starts.findLast((start) => start <= at);
    const wrong = Buffer.from(all);
    wrong[at] ^= 1 << (at % 8);
    const bytes = await open(wrong).then(Buffer.from, () => undefined);
    if (!bytes || bytes.equals(whole)) continue; // a time or a name is another one
    assert.ok(header.includes(inMember), `byte ${at}`);
    assert.deepEqual(bytes, whole.subarray(0, bytes.length));
    accepted += 1;
  }
  assert.ok(accepted <= 6);
});

test('a truncated or changed file is never accepted as complete', async () => {
  for (let size = 1; size < packed.length; size++) {
    await assert.rejects(open(packed.subarray(0, size)), /damaged or cut off/, `${size}`);
  }
  const wrong = Buffer.from(packed);
  wrong[wrong.length - 6] ^= 1; // of the sum
  await assert.rejects(open(wrong), /damaged or cut off/);
  await assert.rejects(open('v 0 0 0\n'), /damaged or cut off/);
});

test('a decompression bomb is detected while it unpacks', async () => {
  const bomb = gzipSync(new Uint8Array(3e7));
  await assert.rejects(open(bomb), /far more than it should/);
  await assert.rejects(open(bomb, packed), /far more than it should/);
});

test('a dropped gzip file is opened as the file inside it', async () => {
  const files = await unpack(new Map([['a/mesh.obj.gz', new Blob([packed])]]));
  assert.deepEqual([...files], [['mesh.obj', text]]);
});
