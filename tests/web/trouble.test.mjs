// What goes wrong is named, and the page goes on.

import assert from 'node:assert/strict';
import { bumpyDisk } from '../support/disk.mjs';
import { closeSync, openSync, ftruncateSync, writeSync } from 'node:fs';
import path from 'node:path';
import { cubeMesh, toGlb, toGltf, toObj } from '../support/meshes.mjs';
import { uncertifiable } from './shapes.mjs';
import {
  coarseGrid,
  certificate,
  coneCount,
  download,
  drop,
  dropPaths,
  example,
  failure,
  isPink,
  kOf,
  killSolver,
  openDetails,
  openFiles,
  pixels,
  run,
  saveAs,
  settled,
  share,
  shots,
  state,
  statusSays,
  statusText,
  useBrowser,
} from './support.mjs';

const it = useBrowser();
const { test } = it;

test('a hostile name, an empty file and no mesh at all', async () => {
  const name = '<img src=x onerror=alert(1)>.glb';
  await openFiles(it, { [name]: toGlb([cubeMesh(3)]) });
  assert.equal(await it.page.locator('img').count(), 0);
  assert.equal(await it.page.locator('.file').innerText(), name);
  await drop(it, { 'nothing.obj': '' });
  await statusSays(it, /nothing\.obj/);
  await drop(it, { 'page.glb': '<!doctype html><title>not found</title>' });
  await statusSays(it, /page\.glb/);
  await drop(it, { 'notes.txt': 'hello' });
  await statusSays(it, /holds no mesh/);
  await openFiles(it, { 'cube.obj': toObj(cubeMesh(3)) });
});

test('a non-manifold mesh is shown, its defects are listed, and splitting them is offered', async () => {
  const { vertices, triangles } = cubeMesh(3);
  const fin = [
    ...triangles,
    [0, triangles[0][1] === 0 ? triangles[0][2] : triangles[0][1], vertices.length],
  ];
  await openFiles(
    it,
    { 'fin.obj': toObj({ vertices: [...vertices, [-2, -2, -2]], triangles: fin }) },
    'invalid',
  );
  assert.match(await it.page.locator('.defects').innerText(), /more than two triangles/);
  assert.equal(await it.page.locator('#run').count(), 0); // repairs come first
  assert.equal(await it.page.locator('#repair-and-run').isEnabled(), true);
  await it.page.click('[data-show="non-manifold-edge"]');
  await settled(it.page);
  assert.ok(share(await pixels(it.page, '#view', 'defects'), isPink) > 0.0005);
  await it.page.click('[data-fix="split"]');
  await state(it.page, 'ready', 'unbalanced');
});

test('a refused mesh has a map after one click: repaired, run, and undone step by step', async () => {
  const { page } = it;
  const { vertices, triangles } = cubeMesh(4);
  const turned = triangles.map(([a, b, c], t) => (t === 5 ? [a, c, b] : [a, b, c]));
  const mesh = { vertices, triangles: [...turned, triangles[9]] }; // and one twice
  await openFiles(it, { 'bad.obj': toObj(mesh) }, 'invalid');
  assert.match(await page.locator('.defects').innerText(), /opposite orientation|Duplicate/);
  await page.click('#repair-and-run');
  await state(page, 'certified', 'not-certified');
  // Banner, status and every row agree, whatever they say.
  const isGood = (await page.locator('#verdict').innerText()) === 'Certified';
  await certificate(it);
  const failed = await page.locator('#certificate tr.bad').count();
  assert.equal(isGood, failed === 0);
  assert.equal(await page.locator('#status.good').count(), isGood ? 1 : 0);
  const label = await page.locator('#download').getAttribute('aria-label');
  assert.equal(label, isGood ? 'Download' : 'Download uncertified result');
  // What was wrong and what was done, where the verdict is read; and without it, by one click.
  const made = await page.locator('#repairs').innerText();
  assert.match(made, /Repaired first\. 1 face repeats another one[^.]*\. The triangles/);
  assert.match(made, /1 face turned over/);
  assert.doesNotMatch(made, /first:|\d–\d|--fix/);
  await page.click('#repairs button');
  await state(page, 'invalid');
  assert.equal(await page.locator('#repairs').count(), 0);
  await page.click('#undo'); // and this, too, can be taken back: the map is there again
  await state(page, 'certified', 'not-certified');
  assert.equal(await page.locator('#repairs').count(), 1);
});

test('components that touch are joined by one click where a note says so', async () => {
  const { page } = it;
  const { vertices, triangles } = cubeMesh(3);
  // Two halves that share positions along their boundary, and no vertex.
  const halves = [true, false].map((isUp) =>
    triangles.filter((t) => t.every((v) => vertices[v][2] > 0.2) === isUp),
  );
  const count = vertices.length;
  const mesh = {
    vertices: [...vertices, ...vertices],
    triangles: [...halves[0], ...halves[1].map((t) => t.map((v) => v + count))],
  };
  await openFiles(it, { 'halves.obj': toObj(mesh) });
  const panel = page.locator('#panel-model');
  assert.match(await panel.innerText(), /joining would make 2 parts into 1/);
  assert.doesNotMatch(await panel.innerText(), /--/);
  await page.click('#weld-now');
  await statusSays(it, /Done: join equal positions/);
  assert.match(await panel.innerText(), /Components\s+1/);
  assert.equal(await page.locator('#weld-now').count(), 0);
  await run(it);
  await page.click('#undo');
});

test('a repair that is not enough is not recommended again', async () => {
  const { page } = it;
  // The projective plane: turning faces cannot make two sides of one.
  const faces = '1 2 3 1 3 4 1 4 5 1 5 6 1 6 2 2 3 5 3 4 6 4 5 2 5 6 3 6 2 4'.match(/\d \d \d/g);
  const points = ['0 0 1', '1 0 0', '0 1 0', '-1 0 0', '0 -1 0', '0 0 -1'];
  const text = `${points.map((p) => `v ${p}\n`).join('')}${faces.map((f) => `f ${f}\n`).join('')}`;
  await openFiles(it, { 'plane.obj': text }, 'invalid');
  await page.click('[data-fix="orient"]');
  await page.waitForSelector('[data-fix="all"]');
  assert.equal(await page.locator('[data-fix="orient"]').count(), 0);
  await page.click('[data-fix="all"]');
  await state(page, 'ready');
  await run(it);
  assert.match(
    await page.locator('#repairs').innerText(),
    /1 one-sided component cut along \d+ edges/,
  );
});

test('one failed component is counted, and the others are certified', async () => {
  const { page } = it;
  const bad = cubeMesh(2);
  const good = cubeMesh(3);
  const count = bad.vertices.length;
  const pair = {
    vertices: [...bad.vertices, ...good.vertices.map(([x, y, z]) => [x + 5, y, z])],
    triangles: [...bad.triangles, ...good.triangles.map((t) => t.map((v) => v + count))],
  };
  const corners = [0, 3, 5, 6].map((corner) => ({ vertex: count + corner, k: 1 }));
  await openFiles(it, { 'pair.obj': toObj(pair) });
  const file = {
    format: 'hgp-cones',
    version: 1,
    q: 2,
    cones: [...uncertifiable.cones, ...corners],
  };
  await drop(it, { 'pair.cones.json': JSON.stringify(file) });
  await page.waitForSelector('#cones');
  await run(it, 'not-certified');
  assert.match(await statusText(page), /1 of 2 components pass/);
});

test('an exception that nothing has caught is reported, and so is a rejected promise', async () => {
  const { page } = it;
  it.allowed = [/by accident/, /on purpose/];
  await page.evaluate(() => void setTimeout(() => { throw new Error('by accident'); })); // prettier-ignore
  assert.match(await failure(it), /Something went wrong: by accident/);
  await page.evaluate(() => void Promise.reject(new Error('on purpose')));
  await statusSays(it, /Something went wrong: on purpose/);
});

test('an exception in a view is reported, and the other views continue', async () => {
  const { page } = it;
  await example(it, 'cube');
  await settled(page);
  // Markers cannot be drawn once.
  await page.evaluate(() => {
    const { prototype } = CanvasRenderingContext2D;
    const { fillText } = prototype;
    prototype.fillText = () => {
      prototype.fillText = fillText;
      throw new Error('no ink');
    };
  });
  await page.click('tr[data-cone="0"] [aria-label$="larger k"]');
  assert.match(await failure(it), /view could not be updated: no ink/);
  const frames = () => page.$eval('#view', (view) => Number(view.dataset.frames));
  const before = await frames();
  await page.click('tr[data-cone="1"] [aria-label$="larger k"]');
  await settled(page);
  assert.ok((await frames()) > before);
});

test('JSON files that are not glTF are refused by the solver without a crash', async () => {
  const { page } = it;
  for (const text of ['null', '[]', '{"buffers":[null]}', '{"images":[null],"meshes":[null]}']) {
    await drop(it, { 'odd.gltf': text });
    await page.waitForSelector('#status.error');
    assert.match(await statusText(page), /odd\.gltf/, text);
    await openFiles(it, { 'cube.obj': toObj(cubeMesh(2)) });
  }
});

test('an example that cannot be fetched is reported with the reason', async () => {
  const { page } = it;
  it.allowed = [/ERR_FAILED|Failed to load/];
  await page.route('**/examples/*', (route) => route.abort());
  await page.click('[data-card="torus"]');
  assert.match(await failure(it), /example could not be read/);
  await page.unroute('**/examples/*');
  await example(it, 'torus');
});

test('WebAssembly that cannot start is reported with advice', async () => {
  const { page } = it;
  it.allowed = [/./];
  await page.route('**/*.wasm', (route) => route.fulfill({ body: 'no module', contentType: 'application/wasm' })); // prettier-ignore
  await page.goto('about:blank');
  await page.goto(it.url);
  await state(page, 'failed');
  assert.match(await failure(it), /solver could not start/);
  await page.unroute('**/*.wasm');
});

test('while a dialog is open no key acts behind it: no undo, no run, no key of the view', async () => {
  const { page } = it;
  await example(it, 'cube');
  await page.click('tr[data-cone="0"] [aria-label$="larger k"]');
  await page.click('#help');
  for (const key of ['Control+z', 'Control+Enter', 'Control+k']) await page.keyboard.press(key);
  assert.equal(await kOf(it, 0), '4');
  assert.equal(await page.locator('#palette-dialog').count(), 0);
  await page.keyboard.press('Escape');
  await page.keyboard.press('Control+z');
  assert.equal(await kOf(it, 0), '3');
  // A symmetry that there is none of is refused aloud.
  await page.locator('#q-custom').fill('65');
  await page.locator('#q-custom').press('Enter');
  assert.match(await failure(it), /from 1 to 64, not 65/);
  assert.equal(await page.locator('#q-custom').inputValue(), '4');
});

test('a worker that dies is replaced; cones and history are intact', async () => {
  await openFiles(it, { 'cube.obj': toObj(cubeMesh(16)) });
  await it.page.click('#suggest');
  await it.page.waitForSelector('#cones');
  const cones = await coneCount(it);
  await killSolver(it);
  await it.page.click('#run');
  const text = await failure(it);
  assert.match(text, /stopped unexpectedly/);
  assert.equal(await coneCount(it), cones);
  await run(it, 'certified', 'not-certified');
});

test('a map that is not certified can be seen, is named as such, and saved under that name', async () => {
  const { page } = it;
  await openFiles(it, { 'cube.obj': toObj(cubeMesh(2)) });
  await drop(it, {
    'hard.cones.json': JSON.stringify({ format: 'hgp-cones', version: 1, ...uncertifiable }),
  });
  await page.waitForSelector('#cones');
  await run(it, 'not-certified');
  assert.equal(await page.locator('#verdict').innerText(), 'Not certified');
  assert.match(await statusText(page), /Not certified.*can be viewed/);
  assert.match(await certificate(it), /Flipped triangles[\s\S]*[1-9]\d* of 48/);
  assert.equal(await page.locator('#certificate tr.bad .passed').first().innerText(), 'failed');
  assert.equal(
    await page.locator('#download').getAttribute('aria-label'),
    'Download uncertified result',
  );
  await settled(page);
  await page.selectOption('#overlay', 'flips');
  assert.match(await page.locator('.legend').innerText(), /Folded triangles\s+[1-9]\d*, in red/);
  await openDetails(page, '#result-details');
  await page.click('[aria-label="Show worst: Flipped triangles"]');
  await settled(page);
  assert.ok(share(await pixels(page, '#view'), isPink) > 0.001);
  const isRed = (r, g, b) => r > g + 60 && Math.abs(g - b) < 30;
  assert.ok(share(await pixels(page, '#view'), isRed) > 0.0005);
  await page.screenshot({ path: path.join(shots, 'not-certified.png') });
  await page.click('#panel-result .note.bad button');
  assert.match(
    await statusText(page),
    /^Shown: |^[1-9]\d* (places are shown|triangles are outlined), in pink/,
  );
  await page.click('#download');
  assert.match(await page.locator('#downloads h2').innerText(), /uncertified/);
  await openDetails(page, '#more-formats');
  const { bytes } = await download(page, () => page.click('[data-format="report"]'));
  assert.equal(JSON.parse(String(bytes)).certified, false);
});

test('a run beyond its time limit is stopped and reported', async () => {
  const { page } = it;
  await openFiles(it, { 'disk.obj': bumpyDisk(100) });
  await page.click('#solve-more > summary');
  await page.locator('#time-limit').fill('1');
  await page.locator('#time-limit').press('Enter');
  await page.click('#run');
  assert.match(await failure(it), /within 1 s/);
  await state(page, 'ready');
});

/** A GLB of a cube and very much that nobody needs: the disk holds no bytes for the rest. */
function writeHuge(name, size) {
  const { json, bin } = toGltf([cubeMesh(4)]);
  const length = size - 1024 * 1024;
  delete json.buffers[0].uri;
  json.buffers[0].byteLength = length;
  const raw = JSON.stringify(json);
  const text = raw.padEnd(Math.ceil(raw.length / 4) * 4);
  const head = Buffer.alloc(28 + text.length);
  const total = head.length + length;
  [0x46546c67, 2, total, text.length, 0x4e4f534a].forEach((n, i) => head.writeUInt32LE(n, 4 * i));
  head.write(text, 20);
  head.writeUInt32LE(length, 20 + text.length);
  head.writeUInt32LE(0x004e4942, 24 + text.length);
  const file = path.join(it.folder, name);
  const handle = openSync(file, 'w');
  writeSync(handle, head);
  writeSync(handle, bin);
  ftruncateSync(handle, total);
  closeSync(handle);
  return file;
}

test('a file of 200 MB is read; one of 600 MB is refused with the numbers', async () => {
  const { page } = it;
  await dropPaths(it, [writeHuge('large.glb', 200 * 2 ** 20)]);
  await state(page, 'ready', 'empty');
  await page.waitForFunction(
    () => document.body.dataset.state !== 'empty' || document.querySelector('#status.error'),
  );
  await state(page, 'ready');
  await run(it);
  await dropPaths(it, [writeHuge('huge.glb', 600 * 2 ** 20)]);
  assert.match(await failure(it), /599 MB.*up to 512 MB.*hgp param/);
  await openFiles(it, { 'cube.obj': toObj(cubeMesh(3)) });
});

/** Takes the graphics card away from a view, or gives it back. */
const context = (act, id) =>
  it.page.evaluate(
    ([name, canvas]) => {
      const gl = document.querySelector(canvas).getContext('webgl2');
      const lose = (globalThis.lose ??= new Map());
      if (!lose.has(canvas)) lose.set(canvas, gl.getExtension('WEBGL_lose_context'));
      lose.get(canvas)[name]();
    },
    [act, id],
  );

test('a lost graphics context is reported, is restored by itself, and shows the same picture', async () => {
  const { page } = it;
  await example(it, 'cube');
  await coarseGrid(page);
  await run(it);
  await settled(page);
  const isLine = (r, g, b) => b > r + 15 && b < 140;
  for (const view of ['#view', '#map']) {
    const before = share(await pixels(page, view), isLine);
    assert.ok(before > 0.01, `${view}: ${before}`);
    await context('loseContext', view);
    assert.match(await failure(it), /graphics card lost the picture/);
    // Edits go on meanwhile.
    await page.click('tr[data-cone="0"] [aria-label$="larger k"]');
    await state(page, 'stale');
    await page.click('#undo');
    await state(page, 'certified');
    await context('restoreContext', view);
    await page.waitForFunction(() => /picture is back/.test(document.querySelector('#status').textContent)); // prettier-ignore
    await settled(page);
    const after = share(await pixels(page, view, `restored${view.replace('#', '-')}`), isLine);
    assert.ok(Math.abs(after - before) < 0.2 * before, `${view}: ${before} → ${after}`);
  }
});

test('leaving the page asks for confirmation only where something would be lost', async () => {
  const { page } = it;
  /** Whether the page would ask. */
  const asks = () =>
    page.evaluate(() => !dispatchEvent(new Event('beforeunload', { cancelable: true })));
  await example(it, 'cube');
  assert.equal(await asks(), false); // the example is as it came
  await page.click('tr[data-cone="0"] [aria-label$="larger k"]');
  assert.equal(await asks(), true);
  // The browser's own question, once; whoever stays has everything.
  const seen = [];
  page.on('dialog', (dialog) => {
    seen.push(dialog.type());
    void dialog.dismiss();
  });
  await page.evaluate(() => void setTimeout(() => location.reload()));
  await page.waitForEvent('dialog');
  assert.deepEqual(seen, ['beforeunload']);
  assert.equal(await kOf(it, 0), '4');
  await page.click('#undo');
  await run(it);
  await saveAs(it, 'same');
  assert.equal(await asks(), false);
});

test('a file that is dropped while the solver is still on its way is opened when it is there', async () => {
  const { page } = it;
  let go;
  const gate = new Promise((resolve) => (go = resolve));
  await page.route(/\.wasm$/, async (route) => {
    await gate;
    await route.continue();
  });
  // Whether drops are listened to by the time that the page replaces the first screen.
  await page.addInitScript(() => {
    const listen = document.addEventListener.bind(document);
    let isListening = false;
    document.addEventListener = (kind, ...rest) => {
      isListening ||= kind === 'drop';
      listen(kind, ...rest);
    };
    const observer = new MutationObserver(() => {
      if (!document.querySelector('hgp-page')) return;
      globalThis.listensFirst = isListening;
      observer.disconnect();
    });
    observer.observe(document, { childList: true, subtree: true });
  });
  await page.reload({ waitUntil: 'commit' });
  // The first screen is there before the script that takes drops.
  await page.waitForFunction(() => customElements.get('hgp-status-bar'));
  // The browser delivers no drag before it has painted.
  await page.waitForFunction(() => performance.getEntriesByType('paint').length > 0);
  assert.equal(await page.evaluate(() => globalThis.listensFirst), true);
  await drop(it, { 'early.obj': toObj(cubeMesh(3)) });
  await statusSays(it, /still starting; early\.obj is opened then/);
  assert.equal(await page.getAttribute('body', 'data-state'), 'starting');
  go();
  await state(page, 'ready');
  assert.equal(await page.locator('.file').innerText(), 'early.obj');
  await page.unroute(/\.wasm$/);
});
