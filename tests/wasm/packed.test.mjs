// What a browser sends to its worker: large files in slices, none of them in the task of the caller.

import assert from 'node:assert/strict';
import path from 'node:path';
import test from 'node:test';
import { built } from './support.mjs';

const { packed } = await import(path.join(built, 'lib/browser.js'));
const { toFileSet, unpacked } = await import(path.join(built, 'lib/sources.js'));

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

test('large bytes become a Blob of slices of 1 MB, the first in a task of its own', async () => {
  const { made, result } = await watching((seen) => {
    const promise = packed(bytes);
    assert.deepEqual(seen, [], 'copied in the task of the caller');
    return promise;
  });
  assert.ok(made.every((size) => size <= slice));
  assert.equal(made.length, 6);
  assert.deepEqual(new Uint8Array(await result.arrayBuffer()), bytes);
});

test('a large file is read in slices, a small one becomes bytes', async () => {
  const file = new Blob([bytes]);
  const source = { main: 'a.obj', files: { 'a.obj': file, 'b.bin': new Blob(['text']) } };
  const { made, read, result } = await watching(() => toFileSet(source, undefined, packed));
  assert.ok(
    [...made, ...read].every((size) => size <= slice),
    `${read}`,
  );
  assert.deepEqual(Buffer.from(result.files.get('b.bin')).toString(), 'text');
  assert.notEqual(result.files.get('a.obj'), file); // the one on disk may change
  const { files } = await unpacked(result);
  assert.deepEqual(files.get('a.obj'), bytes);
});

test('small bytes stay what they are', async () => {
  const small = bytes.subarray(0, slice);
  assert.equal(await packed(small), small);
});
