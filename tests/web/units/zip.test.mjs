// ZIP files as the page opens them: byte for byte, whole, within their folder, and not larger than they may be.

import assert from 'node:assert/strict';
import test from 'node:test';
import { Zip, ZipDeflate, zipSync } from 'fflate';
import { unzip } from '../../../web/src/formats/zip.ts';
import { randomFrom } from '../../mutation/draw.mjs';

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

test('files that are read in many parts come out whole, whatever is around them', async () => {
  const random = randomFrom(4);
  const noise = (length) => Uint8Array.from({ length }, () => 256 * random()); // cannot be made smaller
  const files = { 'a.obj': noise(100_000), 'b/c.bin': noise(16_384), 'd.bin': noise(16_385), 'e.obj': text, 'f.bin': noise(40_000) }; // prettier-ignore
  for (const level of [0, 6])
    assert.deepEqual(Object.fromEntries(await open(zipSync(files, { level }))), files);
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
  const header = 30 + 'a.obj'.length;
  const directory = 46 + 'a.obj'.length + 22;
  // One that is written while it is read has its sizes behind its data.
  const parts = [];
  const stream = new Zip((_, part) => parts.push(part));
  const entry = new ZipDeflate('a.obj');
  stream.add(entry);
  entry.push(text, true);
  stream.end();
  const behind = 16;
  const wholes = [zipSync({ 'a.obj': text }, { level: 0 }), zipSync({ 'a.obj': text }), Buffer.concat(parts)]; // prettier-ignore
  for (const [i, whole] of wholes.entries()) {
    assert.deepEqual((await open(whole)).get('a.obj'), text);
    const end = whole.length - directory - (i === 2 ? behind : 0);
    for (let size = header + 1; size < end; size++)
      await assert.rejects(open(whole.subarray(0, size)), /cannot be/, `${size}`); // prettier-ignore
  }
});

test('an unknown method of compression is named', async () => {
  const bytes = Buffer.from(zipSync({ 'a.obj': text }));
  bytes.writeUInt16LE(99, 8);
  await assert.rejects(open(bytes), /a\.obj cannot be unpacked/);
});

test('a ZIP may unpack to two hundred times its size, small ones as if they had four kilobytes, and to no byte more', async () => {
  await assert.rejects(open(zipSync({ 'a.obj': new Uint8Array(3e7) })), /far more than it should/);
  const random = randomFrom(1);
  const noise = Uint8Array.from({ length: 6000 }, () => 256 * random()); // cannot be made smaller
  for (const own of [new Uint8Array(0), noise]) {
    const made = (length) => zipSync({ 'own.bin': own, 'a.obj': new Uint8Array(length) });
    // How long zeros have to be, of whose number the size of the archive depends a little.
    let most = 0;
    for (let i = 0; i < 20; i++) most = 200 * Math.max(4096, made(most).length) - own.length;
    assert.equal(most + own.length, 200 * Math.max(4096, made(most).length));
    assert.equal((await open(made(most))).get('a.obj').length, most);
    const beyond = made(most + 1);
    assert.equal(beyond.length, made(most).length);
    await assert.rejects(open(beyond), /far more than it should/);
  }
});

test('however small it is, a ZIP may unpack to so many bytes in all and to no byte more', async () => {
  const limits = { bytes: 1000, ratio: 200, entries: 10 };
  const three = (last) => new Blob([zipSync({ 'a.obj': new Uint8Array(600), 'b/': [], 'b.obj': new Uint8Array(300), 'c.obj': new Uint8Array(last) })]); // prettier-ignore
  const found = await unzip(three(100), limits);
  assert.deepEqual([...found.values()].map(({ length }) => length), [600, 300, 100]); // prettier-ignore
  await assert.rejects(unzip(three(101), limits), /far more than it should/);
});

test('ten thousand files are taken, not counting folders, and one more is refused', async () => {
  const filesOf = (count) => ({ 'folder/': new Uint8Array(0), ...Object.fromEntries(Array.from({ length: count }, (_, i) => [`${i}.obj`, text.subarray(0, 1)])) }); // prettier-ignore
  const found = await open(zipSync(filesOf(10_000), { level: 0 }));
  assert.equal(found.size, 10_000);
  await assert.rejects(open(zipSync(filesOf(10_001), { level: 0 })), /more than 10000 files/);
});
