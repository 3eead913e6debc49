// Memory: flat over many runs, and running out of it is an error like any other.

import assert from 'node:assert/strict';
import test from 'node:test';
import { blocks, ring } from '../support/blocks.mjs';
import { bumpyDisk } from '../support/disk.mjs';
import { cubeMesh, toGlb, toObj } from '../support/meshes.mjs';
import { asFiles, bytesOf, compile, createCore, HgpError } from './support.mjs';

test('memory does not grow over fifty runs of every kind of call', async () => {
  const core = await createCore();
  const disk = asFiles('disk.obj', bytesOf(bumpyDisk(20)));
  const cube = asFiles('cube.glb', new Uint8Array(toGlb([cubeMesh(5)])));
  const disk3 = new Float64Array([0, 0, 0, 1, 0, 0, 0, 1, 0]);
  const broken = asFiles('x.obj', bytesOf('v 0 0 0\nf 1 2 3\n'));
  const cancelled = asFiles('ring.obj', bytesOf(toObj(blocks(ring, { n: 3 }))));
  const run = () => {
    assert.throws(() => core.load(broken), HgpError);
    const flat = core.load(disk);
    const polygon = flat.parametrize({ boundary: 'convex' });
    polygon.write();
    const model = core.load(cube);
    const cones = model.suggestCones({ q: 4 });
    model.check(cones);
    const map = model.parametrize({ cones });
    map.write({ embedCones: true });
    const ring_ = core.load(cancelled);
    core.onProgress = () => false;
    assert.throws(() => ring_.parametrize(), { code: 'cancelled' });
    core.onProgress = undefined;
    for (const handle of [map, polygon, flat, model, ring_]) handle.free();
    assert.throws(() => map.write(), { code: 'usage' });
    assert.throws(() => model.inspect(), { code: 'usage' });
    core.parametrizeMesh({ positions: disk3, triangles: [0, 1, 2] });
  };
  for (let i = 0; i < 5; i++) run();
  const settled = core.memory;
  for (let i = 0; i < 45; i++) run();
  assert.equal(core.memory, settled);
});

test('freed models leave their memory to the next', async () => {
  const core = await createCore();
  const load = () => core.load(asFiles('disk.obj', bytesOf(bumpyDisk(60)))).free();
  load();
  const settled = core.memory;
  for (let i = 0; i < 20; i++) load();
  assert.equal(core.memory, settled);
});

/** Runs with a memory that may grow by `bytes` and no further. */
function withRoom(bytes, use) {
  const { grow } = WebAssembly.Memory.prototype;
  let left = bytes;
  WebAssembly.Memory.prototype.grow = function (pages) {
    left -= 65536 * pages;
    if (left < 0) throw new RangeError('no more memory');
    return grow.call(this, pages);
  };
  try {
    return use();
  } finally {
    WebAssembly.Memory.prototype.grow = grow;
  }
}

test('a failed allocation is the error `limit`, wherever it happens, and the core keeps working', async () => {
  const wasmModule = await compile();
  const disk = bytesOf(bumpyDisk(70));
  const stages = new Set();
  for (const room of [0, 4, 8, 12, 20, 28, 36].map((mb) => mb * 2 ** 20)) {
    const core = await createCore({ wasmModule });
    const work = () => {
      const model = core.load(asFiles('disk.obj', disk));
      core.onProgress = ({ stage }) => void stages.add(stage);
      model.parametrize({ q: 4 }).write({ allowUncertified: true });
    };
    try {
      withRoom(room, work);
    } catch (error) {
      assert.ok(error instanceof HgpError, `${error.stack}`);
      assert.equal(error.code, 'limit', error.message);
      assert.match(error.message, /memory/);
      const small = core.load(asFiles('small.obj', bytesOf(bumpyDisk(4))));
      assert.equal(small.parametrize({ boundary: 'convex' }).certificate.certified, true);
    }
  }
  assert.ok(stages.size > 2, `the memory ran out before ${[...stages]}`);
});

test('more than four gigabytes are refused before anything is read', async () => {
  const core = await createCore();
  for (const length of [6e8, 4.2e9]) {
    const positions = Object.assign(new Float64Array(0), {});
    Object.defineProperty(positions, 'length', { value: length });
    assert.throws(() => core.loadMesh({ positions, triangles: new Uint32Array(3) }), {
      code: 'limit',
    });
  }
  core.load(asFiles('small.obj', bytesOf(bumpyDisk(4))));
});

test('limits given by the caller are respected', async () => {
  const core = await createCore();
  const files = asFiles('disk.obj', bytesOf(bumpyDisk(10)));
  assert.throws(() => core.load(files, { limits: { triangles: 100 } }), { code: 'limit' });
  assert.throws(() => core.load(files, { limits: { bytes: 100 } }), { code: 'limit' });
  core.load(files, { limits: { triangles: 600 } });
});
