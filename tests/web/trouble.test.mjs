// What goes wrong is named, and the page goes on.

import assert from 'node:assert/strict';
import test from 'node:test';
import { bumpyDisk } from '../support/disk.mjs';
import { closeSync, openSync, ftruncateSync, writeSync } from 'node:fs';
import path from 'node:path';
import { cubeMesh, toGlb, toGltf, toObj } from '../support/meshes.mjs';
import { uncertifiable } from './shapes.mjs';
import {
  download,
  drop,
  dropPaths,
  isPink,
  pixels,
  settled,
  share,
  shots,
  solverOf,
  state,
  statusText,
  useBrowser,
} from './support.mjs';

const it = useBrowser();
const failed = async () => {
  await it.page.waitForSelector('#status.error');
  return statusText(it.page);
};

test('a hostile name, an empty file and no mesh at all', async () => {
  const name = '<img src=x onerror=alert(1)>.glb';
  await drop(it, { [name]: toGlb([cubeMesh(3)]) });
  await state(it.page, 'ready');
  assert.equal(await it.page.locator('img').count(), 0);
  assert.equal(await it.page.locator('.file').innerText(), name);
  await drop(it, { 'nothing.obj': '' });
  assert.match(await failed(), /nothing\.obj/);
  await drop(it, { 'page.glb': '<!doctype html><title>not found</title>' });
  assert.match(await failed(), /page\.glb/);
  await drop(it, { 'notes.txt': 'hello' });
  assert.match(await failed(), /holds no mesh/);
  await drop(it, { 'cube.obj': toObj(cubeMesh(3)) });
  await state(it.page, 'ready');
});

test('a non-manifold mesh is shown, its defects are listed, and splitting them is offered', async () => {
  const { vertices, triangles } = cubeMesh(3);
  const fin = [
    ...triangles,
    [0, triangles[0][1] === 0 ? triangles[0][2] : triangles[0][1], vertices.length],
  ];
  await drop(it, { 'fin.obj': toObj({ vertices: [...vertices, [-2, -2, -2]], triangles: fin }) });
  await state(it.page, 'invalid');
  assert.match(await it.page.locator('.defects').innerText(), /more than two triangles/);
  assert.equal(await it.page.locator('#run').getAttribute('aria-disabled'), 'true');
  await it.page.click('[data-show="non-manifold-edge"]');
  await settled(it.page);
  assert.ok(share(await pixels(it.page, '#view', 'defects'), isPink) > 0.0005);
  await it.page.click('[data-fix="split"]');
  await state(it.page, 'ready', 'unbalanced');
});

test('Cancel in the middle of a solve frees the page within 300 ms', async () => {
  await drop(it, { 'disk.obj': bumpyDisk(129) }); // 100 thousand triangles
  await state(it.page, 'ready');
  await it.page.click('#run');
  await state(it.page, 'running');
  await it.page.waitForFunction(() => document.querySelector('#progress')?.value > 0);
  const elapsed = await it.page.evaluate(async () => {
    const begin = performance.now();
    document.querySelector('#cancel').click();
    while (document.body.dataset.state === 'running') await new Promise((r) => setTimeout(r, 5));
    return performance.now() - begin;
  });
  assert.ok(elapsed <= 300, `${elapsed} ms`);
  assert.match(await statusText(it.page), /Cancelled/);
});

test('a worker that dies is replaced; cones and history are intact', async () => {
  await drop(it, { 'cube.obj': toObj(cubeMesh(16)) });
  await state(it.page, 'ready');
  await it.page.click('#suggest');
  await it.page.waitForSelector('#cones');
  const cones = await it.page.locator('#cones tbody tr[data-cone]').count();
  it.allowed = [/the end/];
  await solverOf(it.page).evaluate(() =>
    self.addEventListener('message', () => {
      throw new Error('the end');
    }),
  );
  await it.page.click('#run');
  const text = await failed();
  assert.match(text, /stopped unexpectedly/);
  assert.equal(await it.page.locator('#cones tbody tr[data-cone]').count(), cones);
  await it.page.click('#run');
  await state(it.page, 'certified', 'not-certified');
});

test('a map that is not certified can be seen, is named as such, and saved under that name', async () => {
  const { page } = it;
  await drop(it, { 'cube.obj': toObj(cubeMesh(2)) });
  await state(page, 'ready');
  await drop(it, {
    'hard.cones.json': JSON.stringify({ format: 'hgp-cones', version: 1, ...uncertifiable }),
  });
  await page.waitForSelector('#cones');
  await page.click('#run');
  await state(page, 'not-certified');
  assert.equal(await page.locator('#verdict').innerText(), 'Not certified');
  assert.match(await statusText(page), /Not certified.*can be viewed/);
  assert.match(
    await page.locator('#certificate').innerText(),
    /Flipped triangles[\s\S]*[1-9]\d* of 48/,
  );
  assert.equal(await page.locator('#certificate tr.bad .passed').first().innerText(), 'failed');
  assert.equal(
    await page.locator('#download').getAttribute('aria-label'),
    'Download uncertified result',
  );
  await settled(page);
  await page.selectOption('#overlay', 'flips');
  assert.match(await page.locator('.legend').innerText(), /[1-9]\d* folded, in red/);
  await page.click('[aria-label="Show worst: Flipped triangles"]');
  await settled(page);
  assert.ok(share(await pixels(page, '#view'), isPink) > 0.001);
  const isRed = (r, g, b) => r > g + 60 && Math.abs(g - b) < 30;
  assert.ok(share(await pixels(page, '#view'), isRed) > 0.0005);
  await page.screenshot({ path: path.join(shots, 'not-certified.png') });
  await page.click('#panel-result .note.bad button');
  assert.match(await statusText(page), /shown|Shown/);
  await page.click('#download');
  assert.match(await page.locator('#downloads h2').innerText(), /uncertified/);
  const { bytes } = await download(page, () => page.click('[data-format="report"]'));
  assert.equal(JSON.parse(String(bytes)).certified, false);
});

test('a run that takes longer than allowed is given up, and says so', async () => {
  const { page } = it;
  await drop(it, { 'disk.obj': bumpyDisk(100) });
  await state(page, 'ready');
  await page.click('#panel-solve summary');
  await page.locator('#time-limit').fill('1');
  await page.locator('#time-limit').press('Enter');
  await page.click('#run');
  assert.match(await failed(), /within 1 s/);
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
  await page.click('#run');
  await state(page, 'certified');
  await dropPaths(it, [writeHuge('huge.glb', 600 * 2 ** 20)]);
  assert.match(await failed(), /599 MB.*up to 512 MB.*hgp param/);
  await drop(it, { 'cube.obj': toObj(cubeMesh(3)) });
  await state(page, 'ready');
});
