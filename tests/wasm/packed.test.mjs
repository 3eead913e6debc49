// What a browser sends to its worker: bytes as they were when the call was made, and large files in slices, none of
// them in the task of the caller.

import assert from 'node:assert/strict';
import path from 'node:path';
import test from 'node:test';
import { built } from './support.mjs';

const { packed } = await import(path.join(built, 'lib/browser.js'));
const { takeFiles, unpacked } = await import(path.join(built, 'lib/sources.js'));

const slice = 2 ** 20;
const bytes = Uint8Array.from({ length: 5 * slice + 7 }, (_, i) => (i * 2654435761) >>> 13);

/** Notes the size of every Blob that is made, and of every one that is read. */
async function watching(use) {
  const made = [];
  const read = [];
  const Plain = globalThis.Blob;
  const { arrayBuffer } = Plain.prototype;
  globalThis.Blob = class extends Plain {
    static [Symbol.hasInstance](one) {
      return Function.prototype[Symbol.hasInstance].call(Plain, one);
    }
    constructor(parts, ...rest) {
      super(parts, ...rest);
      if (parts.every((part) => !(part instanceof Plain))) made.push(this.size);
    }
  };
  Plain.prototype.arrayBuffer = function () {
    read.push(this.size);
    return arrayBuffer.call(this);
  };
  try {
    const result = use(made);
    return { made, read, result: await result };
  } finally {
    globalThis.Blob = Plain;
    Plain.prototype.arrayBuffer = arrayBuffer;
  }
}

test('a large file is read in slices of 1 MB, the first in a task of its own; a small one at once', async () => {
  const file = new Blob([bytes]);
  const source = { main: 'a.obj', files: { 'a.obj': file, 'b.bin': new Blob(['text']) } };
  const { made, read, result } = await watching((seen) => {
    const promise = takeFiles(source, undefined, packed);
    assert.deepEqual(seen, [], 'read in the task of the caller');
    return promise;
  });
  assert.ok(
    [...made, ...read].every((size) => size <= slice),
    `${read}`,
  );
  assert.equal(made.length, 6);
  assert.deepEqual(Buffer.from(result.files.get('b.bin')).toString(), 'text');
  assert.notEqual(result.files.get('a.obj'), file); // the one on disk may change
  const { files } = await unpacked(result);
  assert.deepEqual(files.get('a.obj'), bytes);
});

test('bytes are copied when the call is made, whatever they are part of', async () => {
  const shared = new Uint8Array(new SharedArrayBuffer(8));
  const part = bytes.slice(0, 100).subarray(10, 20);
  const sources = { small: bytes.slice(0, 9), whole: bytes.slice().buffer, shared, part };
  const before = Object.entries(sources).map(([name, one]) => [name, new Uint8Array(one).slice()]);
  const promise = takeFiles({ main: 'small', files: sources }, undefined, packed);
  for (const one of [sources.small, shared, part]) one.fill(77);
  structuredClone(0, { transfer: [sources.whole] });
  const { files } = await promise;
  assert.equal(before.length, 4);
  for (const [name, expected] of before) assert.deepEqual(files.get(name), expected, name);
  assert.equal(files.get('part').buffer.byteLength, 10, 'and no more than that');
  assert.ok(!(files.get('shared').buffer instanceof SharedArrayBuffer));
});
