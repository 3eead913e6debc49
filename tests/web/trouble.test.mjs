// What goes wrong is named, and the page goes on.

import assert from 'node:assert/strict';
import test from 'node:test';
import { bumpyDisk } from '../support/disk.mjs';
import { cubeMesh, toGlb, toObj } from '../support/meshes.mjs';
import { drop, state, statusText, useBrowser } from './support.mjs';

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
  const workers = await Promise.all(
    it.page.workers().map(async (worker) => [worker, await worker.evaluate(() => self.name)]),
  );
  const [solver] = workers.find(([, name]) => name === 'hgp solver');
  await solver.evaluate(() =>
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
