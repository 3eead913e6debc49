// What was asked goes along when the surface is read again: welded, repaired, in another version; and
// what remains when the model is closed.

import assert from 'node:assert/strict';
import { cubeMesh, toObj } from '../support/meshes.mjs';
import { sentenceOf } from '../support/notes.mjs';
import { crackedCube, flatSquare } from './shapes.mjs';
import {
  coneCount,
  drop,
  example,
  killSolver,
  kOf,
  model,
  modelSays,
  openDetails,
  openFiles,
  openMesh,
  run,
  state,
  statusSays,
  statusText,
  useBrowser,
} from './support.mjs';

const it = useBrowser();
const { test } = it;
const vertices = () => it.page.locator('tr[data-cone] td:nth-of-type(1)').allInnerTexts();

const coneFile = (q, cones, more = {}) => ({
  'mine.cones.json': JSON.stringify({ format: 'hgp-cones', version: 1, q, cones, ...more }),
});

/** A sentence of the page that a note of the core continues. */
const startsThen = (start, code, values) => new RegExp(start + sentenceOf(code, values).source);

async function weld(length) {
  await it.page.locator('#weld').fill(length);
  await it.page.locator('#weld').press('Enter');
}

test('a weld keeps the cones; former boundary vertices become interior; undo reverts both', async () => {
  const { page } = it;
  const mesh = crackedCube();
  await openMesh(it, mesh);
  // The lid lies a hair above the box: its corners are there twice.
  const inner = mesh.vertices.findIndex((p, v) => v >= 8 && p[2] > 0.95);
  const double = mesh.vertices.findLastIndex((p) =>
    p.every((x, i) => Math.abs(x - mesh.vertices[inner][i]) < 1e-4),
  );
  assert.notEqual(double, inner);
  const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((vertex) => ({ vertex, k: 3 }));
  const cones = [...corners, { vertex: inner, k: 4 }, { vertex: double, k: 4 }];
  await drop(it, coneFile(4, cones));
  await page.waitForSelector('#cones');
  assert.equal(await coneCount(it), 10);
  assert.match(await page.locator('#cones').innerText(), /on the boundary/);
  await weld('0.001');
  await modelSays(it, /Components\s*1/);
  await page.waitForSelector('#status.good');
  assert.match(
    await statusText(page),
    startsThen('weld closer than 0\\.001\\. 9 cones kept; ', 'moved-cone-joined', {
      vertex: double,
      other: inner,
    }),
  );
  assert.deepEqual(await vertices(), [0, 1, 2, 3, 4, 5, 6, 7, inner].map(String));
  assert.doesNotMatch(await page.locator('#cones').innerText(), /boundary/);
  await run(it);
  await page.click('#undo');
  await modelSays(it, /Components\s*2/);
  assert.equal(await coneCount(it), 10);
  assert.equal(await page.locator('#verdict').count(), 0); // that map was of another surface
  await page.click('#redo');
  await modelSays(it, /Components\s*1/);
  assert.equal(await coneCount(it), 9);
  await state(page, 'certified'); // without another run
  // The worker has read the file again: a choice of Download finds its way all the same.
  await page.click('#download');
  await openDetails(page, '#more-formats');
  await page.selectOption('#uv-scale', 'fit');
  await page.waitForSelector('#downloads ul:not([aria-busy="true"])', { state: 'attached' });
  assert.equal(await page.locator('#uv-scale').inputValue(), 'fit');
  await state(page, 'certified');
});

test('a repair keeps the cones that still have their vertex', async () => {
  const { page } = it;
  const { vertices: points, triangles } = cubeMesh(3);
  const fin = [...triangles, [triangles[0][0], triangles[0][1], points.length]];
  const mesh = { vertices: [...points, [-2, -2, -2]], triangles: fin };
  await openFiles(it, { 'fin.obj': toObj(mesh) }, 'invalid');
  await page.click('[data-fix="split"]');
  await state(page, 'ready', 'unbalanced');
  const corners = [0, 1, 2, 3, 4, 5, 6, 7];
  await drop(
    it,
    coneFile(
      4,
      corners.map((vertex) => ({ vertex, k: 3 })),
    ),
  );
  await page.waitForSelector('#cones');
  const before = await vertices();
  await weld('0.0001');
  await page.waitForSelector('#status.good');
  assert.match(await statusText(page), /8 cones kept/);
  assert.deepEqual(await vertices(), before);
});

test('a weld keeps the edges that lines follow, and so does its undo', async () => {
  const { page } = it;
  await openMesh(it, cubeMesh(4));
  await page.click('#follow-creases');
  await page.waitForSelector('#features-note');
  const note = await page.innerText('#features-note');
  assert.match(note, /12 creases: 48 edges/);
  await weld('0.0001');
  await page.waitForSelector('#status.good');
  assert.equal(await page.innerText('#features-note'), note);
  await page.click('#undo');
  await page.waitForFunction(() => document.querySelector('#weld').value !== '0.0001');
  await state(page, 'ready', 'unbalanced');
  assert.equal(await page.innerText('#features-note'), note);
});

test('cones are not waited for: files open where the storage of the browser never answers', async () => {
  const { page } = it;
  await page.evaluate(() => {
    IDBFactory.prototype.open = () => new EventTarget();
  });
  await openMesh(it, cubeMesh(3));
  await run(it);
  await page.reload();
  await state(page, 'empty');
  // A database without the page's store, as another program may have made it, gets it.
  await page.evaluate(async () => {
    const ended = (request) => new Promise((resolve) => (request.onsuccess = () => resolve(request.result))); // prettier-ignore
    await ended(indexedDB.deleteDatabase('hgp'));
    (await ended(indexedDB.open('hgp', 1))).close();
    // A slow browser: what reads finds the database as it was when the page begins to write.
    Object.defineProperty(IDBOpenDBRequest.prototype, 'onsuccess', {
      set(then) {
        this.addEventListener('success', (event) => setTimeout(() => then.call(this, event), 500));
      },
    });
  });
  await openMesh(it, cubeMesh(3));
  const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((vertex) => ({ vertex, k: 3 }));
  await drop(it, coneFile(4, corners));
  await page.waitForFunction(async () => {
    const answer = (request) => new Promise((resolve) => (request.onsuccess = () => resolve(request.result))); // prettier-ignore
    const database = await answer(indexedDB.open('hgp'));
    const isThere = database.objectStoreNames.contains('cones');
    const store = isThere && database.transaction('cones').objectStore('cones');
    const count = isThere ? await answer(store.count()) : 0;
    database.close();
    return count > 0;
  });
  await openMesh(it, cubeMesh(4), 'other.obj');
  await openMesh(it, cubeMesh(3));
  await statusSays(it, /You placed 8 cones on this file/);
});

test('a turning index stays with its boundary', async () => {
  const { page } = it;
  const square = flatSquare(8);
  await openMesh(it, square);
  await page.locator('[data-loop="0"] button[aria-label$="larger"]').click();
  assert.equal(await page.locator('[data-loop="0"] input').inputValue(), '4');
  await weld('0.0001');
  await page.waitForSelector('#status.good');
  assert.equal(await page.locator('[data-loop="0"] input').inputValue(), '4');
});

test('a new version of the file keeps the cones whose positions it has', async () => {
  const { page } = it;
  await openFiles(it, { 'part.obj': toObj(cubeMesh(4)) });
  const coarse = cubeMesh(4);
  const corner = 0;
  const middle = coarse.vertices.findIndex(
    ([x, y, z], v) => v >= 8 && x !== y && z < -0.9 && x < -0.1,
  );
  await drop(it, coneFile(4, [{ vertex: corner, k: 3 }, { vertex: middle, k: 5 }])); // prettier-ignore
  await page.waitForSelector('#cones');
  // In the next version the vertices have other numbers, and the one in the middle is gone.
  const fine = cubeMesh(6);
  const last = fine.vertices.length - 1;
  const turned = {
    vertices: fine.vertices.toReversed(),
    triangles: fine.triangles.map((t) => t.map((v) => last - v)),
  };
  await drop(it, { 'part.obj': toObj(turned) });
  await modelSays(it, /Triangles\s*432/);
  await statusSays(
    it,
    startsThen('Another version of part\\.obj\\. 1 cone kept; ', 'moved-cone-gone', {
      vertex: middle,
    }),
  );
  assert.deepEqual(await vertices(), [String(last - corner)]);
  assert.equal(await kOf(it, 0), '3');
  await page.click('#undo');
  assert.equal(await coneCount(it), 0);
  // A file of another name is another model.
  await page.click('#redo');
  await openFiles(it, { 'other.obj': toObj(cubeMesh(3)) });
  assert.equal(await coneCount(it), 0);
});

test('a new version that needs a repair, or that comes after the solver was lost, keeps the cones as well', async () => {
  const { page } = it;
  const at = [0, 1, 2, 3, 4, 5, 6, 7].map((vertex) => ({ vertex, k: 3 }));
  await openFiles(it, { 'part.obj': toObj(cubeMesh(4)) });
  await drop(it, coneFile(4, at));
  await page.waitForSelector('#cones');
  const { vertices: points, triangles } = cubeMesh(6);
  const fin = [...triangles, [triangles[0][0], triangles[0][1], points.length]];
  const broken = { vertices: [...points, [-2, -2, -2]], triangles: fin };
  // What cannot be read at all comes between.
  await drop(it, { 'part.obj': 'v 0 0\nf 1 2 3\n' });
  await page.waitForSelector('#status.error');
  await openFiles(it, { 'part.obj': toObj(broken) }, 'invalid');
  await page.click('[data-fix="split"]');
  await state(page, 'ready');
  assert.match(await statusText(page), /^Another version of part\.obj\. 8 cones kept/);
  assert.equal(await coneCount(it), 8);
  await killSolver(it);
  await openFiles(it, { 'part.obj': toObj(cubeMesh(5)) }, 'empty', 'ready');
  await openFiles(it, { 'part.obj': toObj(cubeMesh(5)) });
  assert.match(await statusText(page), /^Another version of part\.obj\. 8 cones kept/);
  assert.equal(await coneCount(it), 8);
});

test('Close returns to the start page, and one click restores everything', async () => {
  const { page } = it;
  await example(it, 'cube');
  await page.click('tr[data-cone="0"] [aria-label$="larger k"]');
  await page.click('tr[data-cone="1"] [aria-label$="smaller k"]');
  const before = await page.locator('#cones tbody').innerText();
  await page.waitForFunction(() => location.hash.includes('cones='));
  await page.click('#close');
  await state(page, 'empty');
  assert.equal(await page.locator('#close').count(), 0);
  assert.equal(await page.locator('.file').innerText(), '');
  assert.match(await statusText(page), /Closed cube\.glb\. Its cones are kept/);
  await page.waitForFunction(() => location.hash === '');
  assert.equal(await page.locator('#undo').isDisabled(), true);
  await page.click('footer button:has-text("Open it again")');
  await state(page, 'ready');
  assert.equal(await page.locator('#cones tbody').innerText(), before);
  assert.match(await model(it), /Triangles/);
  // Closed while it runs: nothing comes back by itself.
  await page.click('#run');
  await page.click('#close');
  await state(page, 'empty');
  // Another worker is there before anyone needs it.
  while (page.workers().filter((one) => !/geometry/.test(one.url())).length !== 1)
    await page.waitForTimeout(20);
  await example(it, 'sphere');
  assert.match(await page.locator('.file').innerText(), /sphere/);
  await run(it);
});
