import assert from 'node:assert/strict';
import test from 'node:test';
import { cornerPositions } from '../../../web/src/views/gathered_attribute.ts';
import { SlicedUploads } from '../../../web/src/views/sliced_uploads.ts';

/** A context whose buffers are arrays; its card takes at once what it is sent, unless `card` is busy. */
function context(card = { isBusy: false }) {
  const bound = new Map();
  const writes = [];
  const fences = new Set();
  const gl = {
    ...{
      ARRAY_BUFFER: 1,
      ELEMENT_ARRAY_BUFFER: 2,
      SYNC_STATUS: 3,
      SIGNALED: 4,
      COPY_WRITE_BUFFER: 5,
    },
    // A fence is passed when what is before it has been sent on; until it is deleted it is kept.
    fenceSync: () => {
      const fence = { isSent: false };
      fences.add(fence);
      return fence;
    },
    getSyncParameter: (fence) => (card.isBusy || !fence.isSent ? 5 : 4),
    deleteSync: (fence) => assert.ok(fences.delete(fence)),
    flush: () => fences.forEach((fence) => (fence.isSent = true)),
    bindBuffer: (target, buffer) => bound.set(target, buffer),
    deleteBuffer: () => undefined,
    bufferData: (target, data) => {
      bound.get(target).bytes = typeof data === 'number' ? new Uint8Array(data) : data;
    },
    bufferSubData: (target, at, data) => {
      writes.push(data.length);
      bound.get(target).bytes.set(data, at);
    },
  };
  return { gl, writes, fences, bound: (target = 1) => bound.get(target) };
}
const megabytes = (n, value) => new Uint8Array(n * 2 ** 20 + 3).fill(value);

function finish(uploads) {
  let frames = 0;
  for (; uploads.isBusy; frames++) uploads.step();
  return frames;
}

test('small arrays are uploaded at once, large ones completely in slices', () => {
  const { gl, writes, bound } = context();
  const uploads = new SlicedUploads(gl);
  const [small, large] = [{}, {}];
  gl.bindBuffer(1, small);
  gl.bufferData(1, megabytes(1, 7), 0);
  assert.equal(uploads.isBusy, false);
  gl.bindBuffer(1, large);
  gl.bufferData(1, megabytes(9, 8), 0);
  assert.equal(uploads.isBusy, true);
  gl.bindBuffer(1, small);
  assert.ok(finish(uploads) >= 1);
  assert.equal(bound(), small); // as it was
  assert.deepEqual(large.bytes, megabytes(9, 8));
  assert.ok(writes.every((length) => length <= 2 ** 20));
});

test('what was sent is passed on at once, and of all marks behind it at most one is kept', () => {
  const { gl, fences } = context();
  const uploads = new SlicedUploads(gl);
  for (let round = 0; round < 3; round++) {
    gl.bindBuffer(1, {});
    gl.bufferData(1, megabytes(9, round), 0);
    while (uploads.isBusy) {
      uploads.step();
      assert.deepEqual([...fences], [{ isSent: true }]);
    }
    assert.equal(uploads.isAtRest(), true);
    assert.equal(fences.size, 0);
    assert.equal(uploads.isAtRest(), false, 'it is asked anew');
    assert.deepEqual([...fences], [{ isSent: true }]);
    assert.equal(uploads.isAtRest(), true);
  }
});

test('values that are gathered are never there as a whole, and arrive completely', () => {
  const { gl, writes } = context();
  const uploads = new SlicedUploads(gl);
  for (const count of [3, 10 ** 6]) {
    const triangles = Uint32Array.from({ length: count }, (_, c) => (7 * c) % 1000);
    const places = Float64Array.from({ length: 3000 }, (_, i) => i / 7);
    const buffer = {};
    gl.bindBuffer(1, buffer);
    gl.bufferData(1, cornerPositions(places, triangles).array, 0);
    finish(uploads);
    const { bytes } = buffer;
    const values = new Float32Array(bytes.buffer, bytes.byteOffset, bytes.length / 4);
    assert.equal(values.length, 3 * count);
    values.forEach((x, i) => x === Math.fround(places[3 * triangles[Math.floor(i / 3)] + (i % 3)]) || assert.fail(`${i}`)); // prettier-ignore
  }
  assert.ok(writes.length > 10 && writes.every((length) => length <= 2 ** 20));
});

test('uploads to a deleted, refilled or lost buffer are dropped', () => {
  const { gl, writes } = context();
  const uploads = new SlicedUploads(gl);
  const buffer = {};
  gl.bindBuffer(1, buffer);
  gl.bufferData(1, megabytes(9, 1), 0);
  gl.deleteBuffer(buffer);
  assert.equal(uploads.isBusy, false);
  gl.bufferData(1, megabytes(9, 1), 0);
  gl.bufferSubData(1, 0, megabytes(9, 2));
  assert.equal(finish(uploads), 0);
  assert.deepEqual(buffer.bytes, megabytes(9, 2));
  gl.bufferData(1, megabytes(9, 3), 0);
  gl.bufferData(1, megabytes(9, 4), 0);
  finish(uploads);
  assert.deepEqual(buffer.bytes, megabytes(9, 4));
  gl.bufferData(1, megabytes(9, 5), 0);
  uploads.forget();
  assert.equal(uploads.isBusy, false);
  assert.ok(writes.length > 0);
});

test('indices are uploaded in slices, too, and what is bound stays bound', () => {
  const { gl, writes, bound } = context();
  const uploads = new SlicedUploads(gl);
  const [indices, corners] = [{}, {}];
  gl.bindBuffer(2, indices);
  gl.bufferData(2, megabytes(9, 1), 0);
  assert.equal(uploads.isBusy, true);
  gl.bindBuffer(1, corners);
  finish(uploads);
  assert.deepEqual(indices.bytes, megabytes(9, 1));
  assert.deepEqual([bound(1), bound(2)], [corners, indices]);
  assert.ok(writes.every((length) => length <= 2 ** 20));
});

test('a busy graphics card is sent nothing more, and the wait for it is limited', async () => {
  const card = { isBusy: true };
  const { gl, writes } = context(card);
  const uploads = new SlicedUploads(gl);
  const buffer = {};
  gl.bindBuffer(1, buffer);
  gl.bufferData(1, megabytes(30, 6), 0);
  uploads.step();
  const first = writes.length;
  assert.ok(first >= 1 && first <= 4, `${first}`);
  for (let i = 0; i < 5; i++) uploads.step();
  assert.equal(writes.length, first);
  await new Promise((resolve) => setTimeout(resolve, 600));
  uploads.step();
  assert.ok(writes.length > first && writes.length <= 2 * 4, `${writes.length}`);
  card.isBusy = false;
  finish(uploads);
  assert.deepEqual(buffer.bytes, megabytes(30, 6));
});

test('whether the card is at rest is known a frame later, and not waited for without end', (t) => {
  const card = { isBusy: true };
  const { gl } = context(card);
  const uploads = new SlicedUploads(gl);
  let now = 1000;
  t.mock.method(performance, 'now', () => now);
  assert.equal(uploads.isAtRest(), false); // it is asked
  assert.equal(uploads.isAtRest(), false);
  card.isBusy = false;
  assert.equal(uploads.isAtRest(), true);
  card.isBusy = true;
  assert.equal(uploads.isAtRest(), false); // asked anew
  now += 5000;
  assert.equal(uploads.isAtRest(), true);
  gl.fenceSync = () => null; // the context is lost
  assert.equal(uploads.isAtRest(), true);
});

test('a frame sends four slices where it has time, one where it has none, and never less', (t) => {
  const upload = (taken) => {
    const { gl, writes } = context();
    let now = 0;
    performance.now = () => (now += taken / 2); // asked once before and once after each slice, or less often
    try {
      const uploads = new SlicedUploads(gl);
      gl.bindBuffer(1, {});
      gl.bufferData(1, megabytes(9, 8), 0);
      const frames = [];
      for (; uploads.isBusy; frames.push(writes.splice(0).length)) uploads.step();
      return frames.filter((count) => count > 0);
    } finally {
      delete performance.now;
    }
  };
  t.after(() => delete performance.now);
  assert.deepEqual(upload(0), [4, 4, 2]);
  assert.deepEqual(upload(40), Array(10).fill(1));
});
