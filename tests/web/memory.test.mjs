// What the workers of the page still have: counted in the messages that the page sends them.

import assert from 'node:assert/strict';
import { cubeMesh, toGlb, toObj } from '../support/meshes.mjs';
import { torusMesh } from './shapes.mjs';
import { drop, openFiles, run, settled, state, statusSays, useBrowser } from './support.mjs';

const it = useBrowser();
const { test } = it;

/** From now on, counts what each worker was told to make and has not been told to forget. */
async function census(page) {
  await page.evaluate(() => {
    const { postMessage, terminate } = Worker.prototype;
    const has = { surfaces: new Set(), drawn: new Set(), models: new Set(), maps: new Map() };
    globalThis.has = has;
    const takes = {
      surface: ({ call, args }) => call && has.surfaces.add(args[0]), // not that of the solver
      analyse: ({ args }) => has.drawn.add(args[0]),
      forget({ args: [surfaces, maps] }) {
        for (const id of surfaces) has.surfaces.delete(id);
        for (const id of maps) has.drawn.delete(id);
      },
      load: ({ makes }) => has.models.add(makes),
      parametrize: ({ makes, on }) => has.maps.set(makes, on),
      release({ args: [id] }) {
        has.models.delete(id);
        for (const [map, on] of [...has.maps]) if (map === id || on === id) has.maps.delete(map);
      },
    };
    Worker.prototype.postMessage = function (message, ...rest) {
      takes[message?.method]?.(message);
      return postMessage.call(this, message, ...rest);
    };
    Worker.prototype.terminate = function () {
      has.models.clear();
      has.maps.clear();
      return terminate.call(this);
    };
  });
  /** Waits until there is as much of everything as expected. */
  return async (expected, what) => {
    const now = () =>
      page.evaluate(() => Object.fromEntries(Object.entries(globalThis.has).map(([k, { size }]) => [k, size]))); // prettier-ignore
    for (let tries = 0; tries < 100; tries++) {
      if (JSON.stringify(await now()) === JSON.stringify(expected)) return;
      await page.waitForTimeout(50);
    }
    assert.deepEqual(await now(), expected, what);
  };
}

/** Bytes of all arrays that the page and each of its workers hold, by the worker's name. */
async function heldBytes({ context, page }) {
  const session = await context.newCDPSession(page);
  const workers = new Map();
  const answers = new Map();
  session.on('Target.attachedToTarget', ({ sessionId, targetInfo }) => workers.set(sessionId, targetInfo.url)); // prettier-ignore
  session.on('Target.receivedMessageFromTarget', ({ sessionId, message }) => {
    const { id, result } = JSON.parse(message);
    answers.get(`${sessionId} ${id}`)?.(result);
  });
  await session.send('Target.setAutoAttach', { autoAttach: true, waitForDebuggerOnStart: false, flatten: false }); // prettier-ignore
  let calls = 0;
  const ask = (sessionId, method) => {
    const id = ++calls;
    const answer = new Promise((resolve) => answers.set(`${sessionId} ${id}`, resolve));
    const message = JSON.stringify({ id, method });
    void session.send('Target.sendMessageToTarget', { sessionId, message });
    return answer;
  };
  const bytesOf = async (send) => {
    await send('HeapProfiler.collectGarbage');
    return (await send('Runtime.getHeapUsage')).backingStorageSize;
  };
  const held = { page: await bytesOf((method) => session.send(method)) };
  for (const [sessionId, url] of workers) {
    const name = /geometry/.test(url) ? 'geometry' : 'others';
    held[name] = (held[name] ?? 0) + (await bytesOf((method) => ask(sessionId, method)));
  }
  await session.detach();
  return held;
}

const close = async (page) => {
  await page.keyboard.press('Control+k');
  await page.keyboard.type('Close ');
  await page.keyboard.press('Enter');
  await state(page, 'empty');
};

test('open, run and close, again and again: nothing stays', async () => {
  const { page } = it;
  const counted = await census(page);
  for (let cycle = 0; cycle < 4; cycle++) {
    await openFiles(it, { 'cube.obj': toObj(cubeMesh(4)) });
    await run(it);
    await counted({ surfaces: 1, drawn: 1, models: 1, maps: 1 }, `cycle ${cycle}`);
    await close(page);
    await counted({ surfaces: 0, drawn: 0, models: 0, maps: 0 }, `cycle ${cycle}, closed`);
  }
});

test('arrays of a large model are there once in the page and once in its worker', async (t) => {
  const { page } = it;
  const n = 70;
  const triangles = 12 * n ** 2;
  const empty = await heldBytes(it);
  await openFiles(it, { 'cube.obj': toObj(cubeMesh(n)) });
  await page.locator('#align').uncheck();
  await settled(page);
  const open = await heldBytes(it);
  await run(it);
  await settled(page);
  const solved = await heldBytes(it);
  const each = (after, before) => (name) => (after[name] - before[name]) / triangles;
  const [model, map] = [each(open, empty), each(solved, open)];
  // Of the page's, 49 are the file, 87 the written one, and up to 18 a slice; an array of three numbers per corner would be 36.
  // Of the worker's, 12 are triangles, 12 positions, 14 neighbours, 2.5 facts of vertices; one more number per corner would be 12.
  const limits = { model: { page: 142, geometry: 42 }, map: { page: 172, geometry: 44 } };
  for (const [what, bytes] of Object.entries({ model, map })) {
    for (const [where, limit] of Object.entries(limits[what])) {
      t.diagnostic(`${what}, ${where}: ${bytes(where).toFixed(1)} bytes per triangle`);
      assert.ok(bytes(where) > 0 && bytes(where) <= limit, `${what}, ${where}: ${bytes(where)}`);
    }
  }
});

test('one file after another, without closing: the last one stays', async () => {
  const { page } = it;
  const counted = await census(page);
  for (const n of [3, 4, 5]) {
    await drop(it, { [`cube${n}.obj`]: toObj(cubeMesh(n)) });
    await page.waitForFunction((name) => document.title !== '' && document.body.innerText.includes(name), `cube${n}.obj`); // prettier-ignore
    await state(page, 'ready');
    await run(it);
  }
  await counted({ surfaces: 1, drawn: 1, models: 1, maps: 1 });
});

test('runs with other cones: as many maps stay as undo shows', async () => {
  const { page } = it;
  const counted = await census(page);
  await openFiles(it, { 'cube.obj': toObj(cubeMesh(6)) });
  await page.click('#suggest'); // one cone at every corner
  await run(it);
  for (let turn = 0; turn < 4; turn++) {
    await page.click('tr[data-cone="0"] [aria-label$="smaller k"]');
    await page.click('tr[data-cone="1"] [aria-label$="larger k"]');
    await run(it, 'certified', 'not-certified');
    if (turn === 3) break;
    await page.click('tr[data-cone="0"] [aria-label$="larger k"]');
    await page.click('tr[data-cone="1"] [aria-label$="smaller k"]');
    await page.click(`tr[data-cone="${turn + 2}"] [aria-label$="smaller k"]`);
    await page.click('tr[data-cone="0"] [aria-label$="larger k"]');
    await run(it, 'certified', 'not-certified');
  }
  await counted({ surfaces: 1, drawn: 3, models: 1, maps: 3 });
});

test('a file of several meshes: each that was open keeps its map, until the file is closed', async () => {
  const { page } = it;
  const counted = await census(page);
  await openFiles(it, { 'two.glb': toGlb([cubeMesh(3), torusMesh(12, 8)]) });
  await counted({ surfaces: 1, drawn: 0, models: 1, maps: 0 });
  await page.click('header #run-all');
  await statusSays(it, /2 meshes certified/);
  await counted({ surfaces: 2, drawn: 2, models: 2, maps: 2 });
  await close(page);
  await counted({ surfaces: 0, drawn: 0, models: 0, maps: 0 });
});
