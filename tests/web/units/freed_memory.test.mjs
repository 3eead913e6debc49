// What the workers keep: everything of the open mesh, and of those that wait the small ones, as far as there is room.

import assert from 'node:assert/strict';
import test from 'node:test';
import { Document } from '../../../web/src/model/document.ts';
import { freeUnused, watchMemory } from '../../../web/src/actions/free_unused.ts';
import { randomFrom } from '../../mutation/draw.mjs';

let last = 0;
/** A mesh with its maps, which note that they were freed. */
function meshOf(triangles, maps, bytes = 10) {
  const freed = new Set();
  const solver = { name: 'solver', dispose: () => freed.add('model') };
  const surface = { id: ++last };
  const files = new Map([['a.obj', { size: bytes }]]);
  const model = { info: { triangles }, solver, surface, files };
  const solutions = Array.from({ length: maps }, (_, i) => ({
    ...{ id: ++last, surfaceId: surface.id },
    map: { model: solver, dispose: () => freed.add(`map ${i}`) },
  }));
  return { model, solutions, freed, size: triangles * (1 + maps) };
}

/** Opens meshes one after the other, each of which then waits; what the geometry worker was told to keep. */
function opened(meshes) {
  let kept;
  const geometry = { keepOnly: (surfaces, maps) => (kept = { surfaces, maps }) };
  const doc = { meshes: new Map(), solutions: [], model: undefined, previous: undefined };
  const app = { doc, geometry };
  meshes.forEach((one, i) => {
    if (i > 0) doc.meshes.set(i - 1, meshes[i - 1]);
    Object.assign(doc, { model: one.model, solutions: one.solutions });
    freeUnused(app);
    assert.equal(one.freed.size, 0, 'nothing of the open mesh');
  });
  return { app, doc, kept: () => kept };
}

test('of the meshes that wait the smallest are kept, as many as there is room for; all are still drawn', () => {
  const random = randomFrom(12);
  const room = 500_000;
  for (let round = 0; round < 20; round++) {
    const meshes = Array.from({ length: 8 }, () => meshOf(Math.ceil(200_000 * random() ** 2), Math.floor(3 * random()))); // prettier-ignore
    const { kept } = opened(meshes);
    const waiting = meshes.slice(0, -1).sort((a, b) => a.size - b.size);
    let sum = 0;
    for (const { size, solutions, freed } of waiting) {
      sum += size;
      const all = ['model', ...solutions.map((_, i) => `map ${i}`)];
      assert.deepEqual([...freed].sort(), sum <= room ? [] : all.sort(), `${size} of ${sum}`);
    }
    assert.deepEqual([...kept().surfaces].sort((a, b) => a - b), meshes.map(({ model }) => model.surface.id)); // prettier-ignore
    assert.equal(kept().maps.size, meshes.flatMap(({ solutions }) => solutions).length);
  }
});

test('large files are kept up to a total as well', () => {
  const large = 100 * 2 ** 20;
  const meshes = [meshOf(10, 0, large), meshOf(20, 0, large), meshOf(5, 0, 10), meshOf(1, 0)];
  opened(meshes);
  assert.deepEqual(meshes.map(({ freed }) => freed.size), [0, 1, 0, 0]); // prettier-ignore
});

test('there is room for half a million triangles and 128 MB, to the last triangle and byte', () => {
  const rooms = { triangles: 500_000, bytes: 128 * 2 ** 20 };
  for (const [what, room] of Object.entries(rooms)) {
    for (const parts of [1, 2, 3, 7]) {
      for (const beyond of [-1, 0, 1]) {
        // Meshes that fill the room together, the last one, which is the largest, with a little less or more.
        const sizes = Array.from({ length: parts }, () => Math.floor(room / parts));
        sizes[parts - 1] += room - sizes.reduce((sum, x) => sum + x, 0) + beyond;
        const made = sizes.map((size, i) => (what === 'triangles' ? meshOf(size, 0, 0) : meshOf(1 + i, 0, size))); // prettier-ignore
        const open = meshOf(1, 0, 0);
        opened([...made, open]);
        const isKept = made.map(({ freed }) => freed.size === 0);
        if (beyond <= 0) assert.ok(isKept.every(Boolean), `${parts} of ${what}, ${beyond}`);
        else assert.equal(isKept.filter((is) => !is).length, 1, `${parts} of ${what}, ${beyond}`);
      }
    }
  }
});

test('a map that is not shown any more is freed alone; an earlier state of the mesh stays as long as a map has it', () => {
  const [before, now] = [meshOf(10, 2), meshOf(10, 1)];
  const { app, doc } = opened([before]);
  Object.assign(doc, { model: now.model, solutions: [before.solutions[1], ...now.solutions] });
  freeUnused(app);
  assert.deepEqual([...before.freed], ['map 0']);
  doc.solutions = now.solutions;
  freeUnused(app);
  assert.deepEqual([...before.freed].sort(), ['map 0', 'map 1', 'model']);
  // The version before of a file, from which cones are moved.
  doc.previous = { model: now.model };
  Object.assign(doc, { model: undefined, solutions: [] });
  freeUnused(app);
  assert.deepEqual([...now.freed], ['map 0']);
  doc.previous = undefined;
  freeUnused(app);
  assert.deepEqual([...now.freed].sort(), ['map 0', 'model']);
});

test('memory is freed once after changes, in a task of its own, and never while something is under way', (t) => {
  t.mock.timers.enable({ apis: ['setTimeout'] });
  const doc = new Document();
  let count = 0;
  const end = watchMemory({ doc, geometry: { keepOnly: () => (count += 1) } });
  const freed = () => {
    t.mock.timers.tick(1000);
    const times = count;
    count = 0;
    return times;
  };
  assert.equal(freed(), 1);
  for (let i = 0; i < 3; i++) doc.meshes = new Map();
  doc.solutions = [];
  assert.equal(count, 0, 'not at once');
  assert.equal(freed(), 1);
  for (const work of ['job', 'automatic']) {
    doc[work] = { kind: 'run' };
    doc.solutions = [];
    assert.equal(freed(), 0, `during ${work}`);
    doc[work] = undefined;
    assert.equal(freed(), 1, `after ${work}`);
    // Work that begins between a change and the task.
    doc.solutions = [];
    doc[work] = { kind: 'run' };
    assert.equal(freed(), 0);
    doc[work] = undefined;
    assert.equal(freed(), 1);
  }
  end();
  doc.solutions = [];
  assert.equal(freed(), 0, 'ended');
});
