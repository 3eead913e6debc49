// What the package costs: bytes, the time until it can be called, no price on the first solve, and its speed beside
// the native program.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { limits, measure } from '../../wasm/sizes.mjs';
import { blocks, ring } from '../support/blocks.mjs';
import { cubeMesh, toObj } from '../support/meshes.mjs';
import { runNative, runPackage } from '../support/whole_runs.mjs';
import { built, native, root, scratch } from './support.mjs';

test('hgp.wasm keeps its limits of size and start-up time', async (t) => {
  const { raw, brotli, instantiation } = await measure(built);
  const time = instantiation.toFixed(1);
  t.diagnostic(`${raw} bytes, ${brotli} with brotli, instantiated in ${time} ms`);
  assert.ok(raw <= limits.raw, `${raw} bytes`);
  assert.ok(brotli <= limits.brotli, `${brotli} bytes with brotli`);
  assert.ok(instantiation <= limits.instantiation, `${time} ms`);
});

/** Seconds of the first and of the best later solve, in a process that has not seen the module. */
function firstAndLater(warmUp) {
  const script = `
    import { createClient } from ${JSON.stringify(path.join(built, 'node/index.js'))};
    import { cubeMesh } from ${JSON.stringify(path.join(root, 'tests/support/meshes.mjs'))};
    const { vertices, triangles } = cubeMesh(24);
    const mesh = { positions: new Float64Array(vertices.flat()),
                   triangles: new Uint32Array(triangles.flat()) };
    const client = await createClient({ warmUp: ${warmUp} });
    await new Promise((done) => setTimeout(done, 2000)); // as long as a person takes to choose a file
    const seconds = [];
    for (let i = 0; i < 3; i++) seconds.push((await client.parametrizeMesh(mesh)).report.seconds);
    console.log(JSON.stringify(seconds));`;
  const printed = execFileSync('node', ['--input-type=module', '-e', script], { encoding: 'utf8' });
  const [first, ...later] = JSON.parse(printed);
  return { first, later: Math.min(...later), factor: first / Math.min(...later) };
}

test('the first solve does not pay for lazy compilation', (t) => {
  // The engine optimizes on other threads. Where other programs leave those no time, both kinds of
  // first solve are slow, and what counts is how much is saved; the best of a few tries.
  let warm, cold;
  for (let i = 0; i < 3 && !(warm?.factor <= 2) && !(warm?.first < 0.7 * cold?.first); i++) {
    warm = firstAndLater(true);
    if (warm.factor > 2) cold = firstAndLater(false);
  }
  const times = warm.factor.toFixed(2);
  t.diagnostic(`the first solve takes ${times} times as long as the best of the next`);
  if (cold) t.diagnostic(`without warm-up: ${cold.first} s instead of ${warm.first} s`);
  assert.ok(warm.factor <= 2 || warm.first < 0.7 * cold.first, `${times} times as long`);
});

test('a whole run in WebAssembly takes at most twice the processor time of the native program', (t) => {
  const folder = scratch('cost');
  const meshes = { sphere: toObj(cubeMesh(41)), handle: toObj(blocks(ring, { n: 18 })) };
  const times = Object.entries(meshes).map(([name, text]) => {
    const file = path.join(folder, `${name}.obj`);
    writeFileSync(file, text);
    const { seconds } = runPackage(built, file, 6);
    const out = path.join(folder, 'out.obj');
    const natives = [0, 1, 2].map(() => runNative(native, file, out).seconds);
    return { packaged: Math.min(...seconds), native: Math.min(...natives) };
  });
  const [packaged, natively] = ['packaged', 'native'].map((key) =>
    times.reduce((sum, time) => sum + time[key], 0),
  );
  const ratio = packaged / natively;
  t.diagnostic(`${packaged.toFixed(2)} s against ${natively.toFixed(2)} s: ${ratio.toFixed(2)}`);
  assert.ok(ratio <= 2, `${ratio.toFixed(2)} times`);
});
