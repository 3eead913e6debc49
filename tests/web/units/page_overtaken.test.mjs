// Whoever opens something before the last thing is read gets the last thing, and nothing of those before it: whichever of their
// files are read first, and however far they are when they are overtaken.

import assert from 'node:assert/strict';
import test from 'node:test';
import { gzipSync } from 'node:zlib';
import { randomFrom } from '../../mutation/draw.mjs';
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
  mesh: (app, file, name) => [open(app, file(`${name}.obj`, cube)), `open ${name}.obj`],
  packed: (app, file, name) => [open(app, file(`${name}.obj.gz`, gzipSync(cube))), `open ${name}.obj`], // prettier-ignore
  'one of several': (app, file, name) => [openMain(app, file(`${name}.off.obj`, cube), `${name}.off.obj`), `open ${name}.off.obj`], // prettier-ignore
  several: (app, file, name) => [open(app, new Map([...file(`${name}.obj`, cube), ...file(`${name}.ply`, cube)])), 'pick-model'], // prettier-ignore
  'nothing to open': (app, file, name) => [open(app, file(`${name}.doc`, 'x')), 'empty'],
  'without its buffer': (app, file, name) => [open(app, file(`${name}.gltf`, JSON.stringify(toGltf([cubeMesh(1)], { buffer: 'a.bin' }).json))), 'needs-files'], // prettier-ignore
  example: (app) => [openExample(app, example), `open ${example.file}`],
  closing: (app) => (app.doc.model ? [close(app), 'empty'] : undefined),
};

function whatIsThere({ doc }) {
  const { kind } = doc.state;
  if (kind !== 'open') return kind;
  const { main } = doc.model;
  assert.deepEqual(doc.prescription.cones, main === example.file ? example.cones : []);
  if (main === example.file) assert.equal(doc.prescription.q, example.q);
  return `open ${main}`;
}

test('whatever is opened, and however its files are read, in the end there is what was asked for last', { skip }, async (t) => {
  const app = await openPage(t);
  const { doc } = app;
  const random = randomFrom(41);
  const below = (n) => Math.floor(n * random());
  const names = Object.keys(ways);
  for (let round = 0; round < 20; round++) {
    const gates = [];
    const held = () => new Promise((resolve) => gates.push(resolve));
    const file = (name, content) => new Map([[name, new HeldFile([content], held())]]);
    replace(t, 'fetch', async () => {
      await held();
      return { ok: true, arrayBuffer: async () => new Uint8Array(sphere).buffer };
    });
    const [asked, ends] = [[], []];
    let expected = whatIsThere(app);
    const turns = async () => {
      for (let i = below(12); i > 0; i--) await turn();
    };
    const openGate = () => gates.splice(below(gates.length), 1).forEach((give) => give());
    for (let i = 0; i < 2 + below(3); i++) {
      const way = names[below(names.length)];
      const [end, state] = ways[way](app, file, `m${round}-${i}`) ?? [undefined, expected];
      asked.push(way);
      ends.push(end);
      expected = state;
      await turns();
      if (random() < 0.5) openGate();
      await turns();
    }
    let isOver = false;
    void Promise.all(ends).then(() => (isOver = true));
    while (!isOver || doc.isBusy) {
      openGate();
      await turns();
      await turn();
    }
    assert.equal(whatIsThere(app), expected, `${round}: ${asked.join(', ')}`);
  }
}); // prettier-ignore
