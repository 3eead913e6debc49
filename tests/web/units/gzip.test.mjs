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

test('a decompression bomb is detected while it unpacks, and the rest of it is not unpacked', async (t) => {
  const bomb = gzipSync(new Uint8Array(3e7));
  const ended = t.mock.method(ReadableStreamDefaultReader.prototype, 'cancel');
  t.after(() => assert.equal(ended.mock.callCount(), 2));
  await assert.rejects(open(bomb), /far more than it should/);
  await assert.rejects(open(bomb, packed), /far more than it should/);
});

test('a dropped gzip file is opened as the file inside it', async () => {
  const files = await unpack(new Map([['a/mesh.obj.gz', new Blob([packed])]]));
  assert.deepEqual([...files], [['mesh.obj', text]]);
});

test('what unpacks to two hundred times its size is read, at least to 800 kB; one byte more is refused', async () => {
  const most = 200 * 4096;
  const zeros = (size) => gzipSync(new Uint8Array(size));
  for (const behind of ['', 'x', zeros(0)]) {
    assert.equal((await open(zeros(most), behind)).length, most);
    await assert.rejects(open(zeros(most + 1), behind), RangeError);
  }
  // Of a larger file what counts is its own size.
  const noise = Uint8Array.from({ length: 9000 }, (_, i) => (i * i * 2654435761) >>> 11);
  const padded = (size) => gzipSync(Buffer.concat([noise, Buffer.alloc(size)]));
  const { length } = padded(most);
  assert.ok(length > 8192, `${length}`);
  assert.equal((await open(padded(1.5 * most))).length, noise.length + 1.5 * most);
  await assert.rejects(open(padded(200 * 2 * length)), RangeError);
}); // prettier-ignore

test('several members are unpacked in tasks of twenty milliseconds of the clock, and between them others have their turn', async (t) => {
  const noise = new Uint8Array(2 ** 21).map((_, i) => Math.imul(i * i + 1, 2654435761) >>> 13);
  const one = gzipSync(noise, { level: 0 });
  let clock = 0;
  const [own, begins] = [globalThis.setTimeout, []];
  t.mock.method(performance, 'now', () => (clock += 3));
  t.mock.method(globalThis, 'setTimeout', (act, ...all) => own(() => (begins.push(clock), act()), ...all)); // prettier-ignore
  const bytes = await open(one, one);
  t.mock.restoreAll();
  assert.equal(bytes.length, 2 * noise.length);
  assert.ok(begins.length > 2, `${begins}`);
  begins.slice(1).forEach((at, i) => {
    const lasted = at - begins[i];
    assert.ok(lasted >= 20 && lasted < 30, `${lasted}`);
  });
}); // prettier-ignore
