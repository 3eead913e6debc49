// Edits without dragging: the scale at once, then the certified map by itself. It is that of a fresh page, and never in
// the way of a drag.

import assert from 'node:assert/strict';
import path from 'node:path';
import { cubeMesh } from '../support/meshes.mjs';
import { openCubeWithCones } from './shapes.mjs';
import {
  drop,
  kOf,
  openDetails,
  openMesh,
  run,
  saveAs,
  settled,
  shots,
  state,
  statusText,
  useBrowser,
  workerCalls,
} from './support.mjs';

const it = useBrowser({ isAutomatic: true });
const plain = useBrowser({ isAutomatic: true, isIsolating: false });
const { test } = it;

const liveIs = (page, ...states) =>
  page.waitForFunction(
    (wanted) => wanted.includes(document.querySelector('#map').dataset.live),
    states,
  );

/** A map with eight cones, and automatic runs as asked. */
async function mapped(isOn, mesh = cubeMesh(16), one = it) {
  const { page } = one;
  await openMesh(one, mesh);
  await run(one);
  await page.locator('#automatic').setChecked(isOn);
  await settled(page);
}

/** Sets k of a cone as a person does. */
async function setK(i, k, { page } = it) {
  const input = page.locator(`tr[data-cone="${i}"] input`);
  await input.fill(String(k));
  await input.press('Enter');
}

/** Two cones change by opposite amounts, so that Gauss-Bonnet holds again; returns the first one's k before. */
async function turnTwo(one = it) {
  const [k, other] = [Number(await kOf(one, 0)), Number(await kOf(one, 1))];
  await setK(0, k + 1, one);
  await state(one.page, 'stale', 'unbalanced', 'renewing');
  await setK(1, other - 1, one);
  return k;
}

const savedBytes = async () => {
  const saved = await saveAs(it, 'same');
  return Buffer.from(saved.bytes ?? saved);
};

/** The middle of the 3D view, where framing a cone shows it. */
async function framed(i, { page } = it) {
  await page.click(`tr[data-cone="${i}"] [aria-label$="frame"]`);
  await settled(page);
  const box = await page.locator('#view').boundingBox();
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

/** Calls of a method do not reach the worker until the function that this resolves to is called. */
async function hold(page, method) {
  await page.evaluate((method) => {
    const { postMessage } = Worker.prototype;
    globalThis.held = [];
    globalThis.goOn = () => {
      Worker.prototype.postMessage = postMessage;
      for (const send of globalThis.held) send();
    };
    Worker.prototype.postMessage = function (message, ...rest) {
      const send = () => postMessage.call(this, message, ...rest);
      if (message?.method === method) globalThis.held.push(send);
      else send();
    };
  }, method);
  return () => page.evaluate(() => globalThis.goOn());
}

/** Notes what the page shows from now on: state and map. */
const watchStates = (page) =>
  page.evaluate(() => {
    globalThis.seen = [];
    const note = () =>
      globalThis.seen.push(
        `${document.body.dataset.state}:${document.querySelector('#map').dataset.live}`,
      );
    const watch = new MutationObserver(note);
    watch.observe(document.body, { attributeFilter: ['data-state'] });
    watch.observe(document.querySelector('#map'), { attributeFilter: ['data-live'] });
  });

test('a change of two cones shows the scale at once and the certified map without Run, as a fresh page makes it', async () => {
  const { page } = it;
  await mapped(true);
  await watchStates(page);
  const goOn = await hold(page, 'parametrize');
  await turnTwo();
  await liveIs(page, 'heat');
  await settled(page);
  assert.match(await page.locator('#live').innerText(), /Scale only: the map is being made/);
  await page.screenshot({ path: path.join(shots, 'edit-heat.png') });
  await goOn();
  await state(page, 'certified');
  await liveIs(page, '');
  assert.match(await statusText(page), /^Certified/);
  const seen = await page.evaluate(() => globalThis.seen);
  assert.ok(seen.includes('renewing:heat'), seen.join());
  const bytes = await savedBytes();

  // On a page of its own, with these cones from the start and by Run alone.
  await page.keyboard.press('Escape');
  await page.evaluate(() => indexedDB.deleteDatabase('hgp'));
  await page.goto(it.url);
  await state(page, 'empty');
  await mapped(false);
  await turnTwo();
  await state(page, 'stale');
  await run(it);
  assert.ok(bytes.equals(await savedBytes()), 'the same bytes');
});

test('undo and redo show the maps that are there, and no run is made', async () => {
  const { page } = it;
  await mapped(true, cubeMesh(6));
  const k = await turnTwo();
  await state(page, 'certified');
  await settled(page);
  const calls = await workerCalls(page);
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await state(page, 'certified');
  assert.equal(await kOf(it, 0), String(k));
  await page.keyboard.press('Control+Shift+z');
  await page.keyboard.press('Control+Shift+z');
  await state(page, 'certified');
  assert.equal(await kOf(it, 0), String(k + 1));
  await settled(page);
  const made = (await calls.names()).filter((name) => /parametrize|load/.test(name));
  assert.deepEqual(made, []);
});

async function yieldsToDrag(one) {
  const { page } = one;
  await mapped(true, cubeMesh(16), one);
  const { x, y } = await framed(2, one);
  const workers = page.workers().length;
  let ended = 0;
  page.on('worker', (worker) => worker.once('close', () => (ended += 1)));
  const calls = await workerCalls(page);
  const goOn = await hold(page, 'parametrize');
  await turnTwo(one);
  await page.waitForFunction(() => globalThis.held.length === 1);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 12, y);
  await page.mouse.move(x + 24, y + 4);
  assert.notEqual(await page.getAttribute('body', 'data-state'), 'renewing');
  await goOn();
  await page.mouse.up();
  // The run of the new place follows by itself.
  await state(page, 'certified');
  assert.equal(page.workers().length, workers);
  assert.equal(ended, 0);
  const names = await calls.names();
  assert.equal(names.filter((name) => name === 'parametrize').length, 2, names.join());
  assert.ok(!names.includes('load'), 'nothing is read again');
}

test('a run that an edit has started yields to a cone that is dragged, in the same worker', async () => {
  await yieldsToDrag(it);
  assert.equal(await it.page.evaluate(() => crossOriginIsolated), true);
});

// Not shared memory, but a Blob that is revoked tells the worker.
plain.test('so it does where the host does not isolate the page', async () => {
  await yieldsToDrag(plain);
  assert.equal(await plain.page.evaluate(() => crossOriginIsolated), false);
});

/** A cube of three triangles for each: of its vertices, two of three have three triangles. */
function spiked() {
  const { vertices, triangles } = cubeMesh(8);
  const all = [...vertices];
  const split = triangles.flatMap(([a, b, c]) => {
    const m = all.push([0, 1, 2].map((i) => (all[a][i] + all[b][i] + all[c][i]) / 3)) - 1;
    return [
      [a, b, m],
      [b, c, m],
      [c, a, m],
    ];
  });
  const at = (...p) =>
    vertices.reduce((best, v, i) => {
      const far = (w) => Math.hypot(...w.map((one, j) => one - p[j]));
      return far(v) < far(vertices[best]) ? i : best;
    }, 0);
  const corners = [-1, 1].flatMap((x) => [-1, 1].flatMap((y) => [-1, 1].map((z) => at(x, y, z))));
  const few = [...corners, at(0, -0.5, -1), at(0, 0.5, -1)].map((vertex) => ({ vertex, k: 3 }));
  const cones = {
    format: 'hgp-cones',
    version: 1,
    q: 4,
    cones: [{ vertex: at(0, 0, 1), k: 6 }, ...few],
  };
  return { mesh: { vertices: all, triangles: split }, cones };
}

test('where a cone has too few triangles its frame fails and shows which; dropped there, the page says why', async () => {
  const { page } = it;
  const { mesh, cones } = spiked();
  await openMesh(it, mesh);
  await drop(it, { 'few.cones.json': JSON.stringify(cones) });
  await page.waitForSelector('tr[data-cone="10"]');
  await run(it);
  await page.locator('#automatic').setChecked(true);
  const ks = await Promise.all([...cones.cones.keys()].map((i) => kOf(it, i)));
  const { x, y } = await framed(ks.indexOf('6'));
  await page.mouse.move(x, y);
  await page.mouse.down();
  let far = 0;
  const shown = () => page.getAttribute('#map', 'data-live');
  while ((await shown()) !== 'fails' && far < 120) {
    far += 3;
    await page.mouse.move(x + far, y + far / 4);
    await page.waitForTimeout(60);
  }
  assert.equal(await shown(), 'fails');
  assert.match(await page.locator('#live').innerText(), /Does not pass: \d+ triangles? folded/);
  await settled(page);
  await page.screenshot({ path: path.join(shots, 'edit-fails.png') });
  await page.mouse.up();
  await liveIs(page, '');
  await state(page, 'stale');
  assert.match(await statusText(page), /3 triangles; k = 6 would need a corner above 180°/);
});

test('who cancels a run, stops a map or sets a limit that is too short, asks for the next run', async () => {
  const { page } = it;
  await mapped(true);
  const goOn = await hold(page, 'parametrize');
  const asked = () => page.evaluate(() => globalThis.held.length);
  await turnTwo();
  await page.waitForFunction(() => globalThis.held.length === 1);
  await page.click('#stop');
  await state(page, 'stale');
  assert.match(await statusText(page), /^Stopped\. Run makes the map of these cones\./);
  // Nothing begins by itself, not even after other changes of the page.
  await page.selectOption('#pattern', 'brick');
  await settled(page);
  await page.waitForTimeout(300);
  assert.equal(await page.getAttribute('body', 'data-state'), 'stale');
  const before = await asked();
  // The same after a run that the user cancels.
  await page.click('#run');
  await state(page, 'running');
  await page.click('#cancel');
  await state(page, 'stale');
  await page.waitForTimeout(300);
  assert.equal(await page.getAttribute('body', 'data-state'), 'stale');
  assert.match(await statusText(page), /^Cancelled/);
  // A limit that is set begins it anew, and ends it.
  await openDetails(page, '#solve-more');
  await page.fill('#time-limit', '1');
  await page.press('#time-limit', 'Enter');
  await state(page, 'renewing');
  await state(page, 'stale');
  assert.match(await statusText(page), /^No map of this edit within 1 second\. Run makes it\./);
  assert.ok((await asked()) >= before);
  await goOn();
  await page.waitForTimeout(300);
  assert.equal(await page.getAttribute('body', 'data-state'), 'stale');
  await page.fill('#time-limit', '');
  await page.press('#time-limit', 'Enter');
  await state(page, 'certified');
});

test('a cone that leaps and is dropped there has its map from a run, also where maps do not follow edits', async () => {
  const { page } = it;
  await openCubeWithCones(it);
  await run(it);
  await page.locator('#automatic').setChecked(false);
  await settled(page);
  const { x, y } = await framed(0);
  const vertex = () => page.locator('tr[data-cone="0"] td').first().innerText();
  const before = await vertex();
  const goOn = await hold(page, 'dragTo'); // else a slow machine lets the hand rest there, and the map arrives
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 110, y + 10);
  await page.mouse.up();
  await goOn();
  await state(page, 'dragging', 'stale', 'renewing');
  await state(page, 'certified');
  await page.waitForFunction(() => document.querySelector('#map').dataset.live === '');
  assert.notEqual(await vertex(), before);
  assert.equal(await page.locator('#dragged').count(), 0, 'its bytes do not depend on the path');
  assert.match(await statusText(page), /Certified/);

  await turnTwo(); // another edit waits for Run
  await settled(page);
  await state(page, 'stale');
});
