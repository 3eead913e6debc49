// Whoever opens something before the thing before is read gets the last one, and nothing of the one before.

import assert from 'node:assert/strict';
import test from 'node:test';
import { gzipSync } from 'node:zlib';
import { cubeMesh, toGlb, toGltf, toObj } from '../../support/meshes.mjs';
import { examples } from '../../support/page_examples.mjs';
import { replace } from '../../support/replaced.mjs';
import { openPage, skip } from './whole_page.mjs';

const { close, open, openExample, openMain } = await import('../../../web/src/actions/open.ts'); // prettier-ignore
const [example] = examples.filter(({ cones }) => cones?.length > 0);
const cube = toObj(cubeMesh(1));
const sphere = toGlb([cubeMesh(4)]);
const turn = () => new Promise((resolve) => setImmediate(resolve));

/** A file that is read when its gate is opened. */
class HeldFile extends Blob {
  constructor(parts, gate) {
    super(parts);
    this.gate = gate;
  }
  slice(...range) {
    return new HeldFile([super.slice(...range)], this.gate);
  }
  async arrayBuffer() {
    await this.gate;
    return super.arrayBuffer();
  }
}

/** Ways to open something: what is done, and what is there when it is done alone. */
const ways = {
  mesh: (app, file, name) => [open(app, file(`${name}.obj`, cube)), `open ${name}.obj, 0 cones`],
  packed: (app, file, name) => [open(app, file(`${name}.obj.gz`, gzipSync(cube))), `open ${name}.obj, 0 cones`], // prettier-ignore
  'one of several': (app, file, name) => [openMain(app, file(`${name}.off.obj`, cube), `${name}.off.obj`), `open ${name}.off.obj, 0 cones`], // prettier-ignore
  several: (app, file, name) => [open(app, new Map([...file(`${name}.obj`, cube), ...file(`${name}.ply`, cube)])), 'pick-model'], // prettier-ignore
  'without its buffer': (app, file, name) => [open(app, file(`${name}.gltf`, JSON.stringify(toGltf([cubeMesh(1)], { buffer: 'a.bin' }).json))), 'needs-files'], // prettier-ignore
  example: (app) => [
    openExample(app, example),
    `open ${example.file}, ${example.cones.length} cones`,
  ],
  'cones for the open one': (app, file, name) => (app.doc.model ? [open(app, file(`${name}.cones.json`, JSON.stringify({ q: 4, cones: [{ vertex: 1, k: 3 }, { vertex: 2, k: 3 }] }))), `open ${app.doc.model.main}, 2 cones`] : undefined), // prettier-ignore
  closing: (app) => (app.doc.model ? [close(app), 'empty'] : undefined),
};

function whatIsThere({ doc }) {
  const { kind } = doc.state;
  if (kind !== 'open') return kind;
  return `open ${doc.model.main}, ${doc.prescription.cones.length} cones`;
}

/** Until nothing is under way but what waits for a gate. */
async function calm({ doc }) {
  for (let still = 0; still < 25; still = doc.isBusy ? 0 : still + 1) await turn();
}

test('whatever is opened and then overtaken has no effect, be its files read before those of what comes after it or behind them', { skip }, async (t) => {
  const app = await openPage(t);
  const names = Object.keys(ways);
  let count = 0;
  for (const [first, last] of names.flatMap((one) => names.map((two) => [one, two]))) {
    count += 1;
    const isFirstRead = count % 3 === 0;
    const gates = [];
    const held = () => new Promise((resolve) => gates.push(resolve));
    const file = (name, content) => new Map([[name, new HeldFile([content], held())]]);
    replace(t, 'fetch', async () => {
      await held();
      return { ok: true, arrayBuffer: async () => new Uint8Array(sphere).buffer };
    });
    let expected = whatIsThere(app);
    const ends = [];
    for (const way of [first, last]) {
      const [end, state] = ways[way](app, file, `m${count}-${way.length}`) ?? [undefined, expected];
      expected = state;
      ends.push(end);
      for (let i = count % 4; i > 0; i--) await turn();
    }
    while (gates.length > 0) {
      (isFirstRead ? gates.shift() : gates.pop())();
      await calm(app);
    }
    await Promise.all(ends);
    await calm(app);
    assert.equal(whatIsThere(app), expected, `${first}, then ${last}`);
  }
}); // prettier-ignore
