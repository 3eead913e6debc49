// What the package costs: bytes, the time until it can be called, and no price on the first solve.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import path from 'node:path';
import test from 'node:test';
import { limits, measure } from '../../wasm/sizes.mjs';
import { built, root } from './support.mjs';

test('hgp.wasm is as small and as soon there as promised', async (t) => {
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
    import { createClient } from ${JSON.stringify(path.join(built, 'index.js'))};
    import { cubeMesh } from ${JSON.stringify(path.join(root, 'tests/support/meshes.mjs'))};
    const { vertices, triangles } = cubeMesh(24);
    const mesh = { positions: new Float64Array(vertices.flat()),
                   triangles: new Uint32Array(triangles.flat()) };
    const client = await createClient({ warmUp: ${warmUp} });
    await new Promise((done) => setTimeout(done, 1000)); // as long as a person takes to choose a file
    const seconds = [];
    for (let i = 0; i < 4; i++) seconds.push((await client.parametrizeMesh(mesh)).report.seconds);
    console.log(JSON.stringify(seconds));`;
  const printed = execFileSync('node', ['--input-type=module', '-e', script], { encoding: 'utf8' });
  const [first, ...later] = JSON.parse(printed);
  return { first, later: Math.min(...later), factor: first / Math.min(...later) };
}

test('the first solve does not pay for lazy compilation', (t) => {
  // Other programs may be busy: the best of a few tries counts.
  let best = Infinity;
  for (let i = 0; i < 4 && best > 1.5; i++) best = Math.min(best, firstAndLater(true).factor);
  t.diagnostic(`the first solve takes ${best.toFixed(2)} times as long as the best of the next`);
  assert.ok(best <= 2, `${best.toFixed(2)} times as long`);
});
