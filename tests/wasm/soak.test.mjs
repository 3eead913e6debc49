// Many runs in one worker over mixed meshes: memory is flat, and every run of a case gives the bytes of its
// first one. 30 runs, 200 under HGP_FULL.

import assert from 'node:assert/strict';
import test from 'node:test';
import { blocks, ring } from '../support/blocks.mjs';
import { bumpyDisk } from '../support/disk.mjs';
import { cubeMesh, toGlb, toObj, toOff, toPly, toStl } from '../support/meshes.mjs';
import { bytesOf, withClient } from './support.mjs';

const runs = process.env.HGP_FULL ? 200 : 30;

/** [name, bytes, options of the solve, whether it is cancelled] */
const cases = [
  ['disk.obj', bytesOf(bumpyDisk(16)), { boundary: 'convex' }],
  ['cube.glb', new Uint8Array(toGlb([cubeMesh(5)])), {}],
  ['pair.glb', new Uint8Array(toGlb([cubeMesh(2), cubeMesh(4)])), { q: 6 }],
  ['ring.obj', bytesOf(toObj(blocks(ring, { n: 2 }))), {}],
  ['cube.off', bytesOf(toOff(cubeMesh(4))), { improve: 'isometric' }],
  ['cube.ply', bytesOf(toPly(cubeMesh(3))), { grid: { cells: 100 } }],
  ['cube.stl', bytesOf(toStl(cubeMesh(3))), { conesFor: 'few' }],
  ['open.obj', bytesOf(toObj(blocks(ring, { n: 1, open: ['0 0 +z'] }))), {}],
  ['broken.obj', bytesOf('v 0 0 0\nf 1 2 3\n'), {}],
  ['wrong.obj', bytesOf(bumpyDisk(6)), { cones: { q: 4, cones: [{ vertex: 40, k: 0 }] } }],
];

const sameBytes = (a, b) => Buffer.compare(Buffer.from(a), Buffer.from(b)) === 0;

test(`${runs} runs in one worker give the same results, and memory does not grow`, () =>
  withClient(async (client) => {
    const first = [];
    let settled = 0;
    let last = 0;
    let certified = 0;
    for (let run = 0; run < runs; run++) {
      const k = run % cases.length;
      const [name, bytes, options] = cases[k];
      let now;
      let model;
      try {
        model = await client.load(bytes, { name });
        const result = await model.parametrize(options);
        const written = await result.write({ allowUncertified: true, embedCones: true });
        last = result.memory;
        certified += result.certificate.certified ? 1 : 0;
        now = { certified: result.certificate.certified, name: written.name, bytes: written.bytes };
      } catch (error) {
        now = { code: error.code, message: error.message, bytes: [] };
      }
      await model?.dispose();
      first[k] ??= now;
      assert.ok(sameBytes(now.bytes, first[k].bytes), `${name}, run ${run}`);
      assert.deepEqual({ ...now, bytes: 0 }, { ...first[k], bytes: 0 }, `${name}, run ${run}`);
      if (run === 2 * cases.length - 1) settled = last;
    }
    console.log(`${runs} runs, ${certified} certified; memory ${settled} -> ${last} bytes`);
    assert.equal(last, settled);
    assert.deepEqual(
      first.map(({ certified: isCertified, code }) => code ?? isCertified),
      [true, true, true, true, true, true, true, true, 'malformed', 'prescription'],
    );
  }));
