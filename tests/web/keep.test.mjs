// What a user takes along or comes back to: pictures, a film, runs beside one another, purposes, recent files, a link.

import assert from 'node:assert/strict';
import pngjs from 'pngjs';
import { cubeMesh, toObj } from '../support/meshes.mjs';
import { bumpyBall } from './shapes.mjs';
import {
  coneCount,
  download,
  drop,
  example,
  openFiles,
  run,
  settled,
  share,
  state,
  statusSays,
  statusText,
  useBrowser,
} from './support.mjs';

const it = useBrowser({ permissions: ['clipboard-read', 'clipboard-write'] });
const { test } = it;

const camera = () => it.page.evaluate(() => new URLSearchParams(location.hash).get('camera'));

test('a picture is the 3D view, 2048 pixels wide, with nothing behind the model; the view stays as it is', async () => {
  const { page } = it;
  await example(it, 'cube');
  await run(it);
  await settled(page);
  const size = () => page.evaluate(() => [document.querySelector('#view').width, document.querySelector('#view').height]); // prettier-ignore
  const before = await size();
  const { name, bytes } = await download(page, () => page.click('#picture'));
  assert.equal(name, 'cube.png');
  const picture = pngjs.PNG.sync.read(bytes);
  assert.ok(picture.width >= 2040, `${picture.width}`);
  let clear = 0;
  for (let at = 3; at < picture.data.length; at += 4) if (picture.data[at] === 0) clear += 4;
  assert.ok(clear > 0.2 * picture.data.length && clear < 0.9 * picture.data.length, `${clear}`);
  assert.ok(share(picture, (r, g, b) => r > 180 && g > 100 && b < 120) > 0.05); // the checkers
  assert.deepEqual(await size(), before);
});

test('a turntable is a film of one turn, after which the camera is where it was', async () => {
  const { page } = it;
  await example(it, 'cube');
  await page.waitForFunction(() => location.hash.includes('camera='));
  const before = await camera();
  const { name, bytes } = await download(page, () => page.click('#turntable'));
  assert.equal(name, 'cube.webm');
  assert.equal(bytes.subarray(0, 4).toString('hex'), '1a45dfa3'); // EBML, of which WebM is made
  assert.ok(bytes.length > 5000, `${bytes.length}`);
  await page.locator('#view').focus();
  await page.keyboard.press('l'); // anything that writes the address again
  await page.waitForTimeout(600);
  assert.equal(await camera(), before);
});

test('a turntable can be stopped, and is then not saved', async () => {
  const { page } = it;
  await example(it, 'cube');
  await page.click('#turntable');
  await page.click('footer button:has-text("Stop")');
  await statusSays(it, /stopped and not saved/);
  assert.equal(await page.getAttribute('#turntable', 'aria-label'), 'Save a turntable');
});

test('runs are beside one another with their numbers; Show brings back cones and settings', async () => {
  const { page } = it;
  await openFiles(it, { 'ball.obj': toObj(bumpyBall(10, 0.12, 3)) });
  await run(it);
  assert.equal(await page.locator('#compare').count(), 0);
  const few = await coneCount(it);
  await page.locator('#cone-step').fill('2');
  await page.waitForFunction((n) => document.querySelectorAll('#cones tr[data-cone]').length > n, few); // prettier-ignore
  const more = await coneCount(it);
  await run(it);
  await page.click('#compare');
  const hidden = (all) => all.map((one) => one.scrollWidth - one.clientWidth);
  assert.deepEqual(await page.$$eval('#compare-dialog, #compare-dialog div', hidden), [0, 0]);
  const cells = async (name) => (await page.locator(`#runs tr:has(th:text-is("${name}")) td`).allInnerTexts()).map((text) => text.trim().replace(/\s+,/, ',')); // prettier-ignore
  assert.deepEqual(await cells('Cones'), [`${few}, the best`, String(more)]);
  const stretch = await cells('Typical stretch');
  assert.equal(stretch.length, 2);
  assert.match(stretch[1], /the best/);
  assert.match(await page.locator('#runs thead').innerText(), /Run 1\s+Run 2\s*shown/);
  await page.click('[aria-label="Show run 1"]');
  await state(page, 'certified');
  assert.equal(await coneCount(it), few);
  assert.equal(await page.locator('dialog').count(), 0);
  await page.click('#undo');
  assert.equal(await coneCount(it), more);
});

test('purposes: a tiling texture, a quad mesh, few cones, each by one click, and a map is made anew', async () => {
  const { page } = it;
  await openFiles(it, { 'ball.obj': toObj(bumpyBall(10, 0.12, 3)) });
  const isOn = (id) => page.getAttribute(`[data-preset="${id}"]`, 'aria-pressed');
  assert.equal(await isOn('tiling'), 'true');
  await run(it);
  await page.click('[data-preset="quads"]');
  await state(page, 'certified');
  assert.equal(await page.inputValue('#grid-mode'), 'quad');
  assert.deepEqual([await isOn('tiling'), await isOn('quads')], ['false', 'true']);
  await page.click('[data-preset="tiling"]');
  await state(page, 'certified');
  assert.equal(await page.inputValue('#grid-mode'), 'tile');
  const few = await coneCount(it);
  await page.locator('#cone-step').fill('4');
  await page.waitForFunction((n) => document.querySelectorAll('#cones tr').length - 1 > n, few);
  await page.click('[data-preset="few"]');
  await state(page, 'certified');
  assert.equal(await coneCount(it), few);
});

test('recent files are on the start page after a reload, open by one click, and are forgotten by another', async () => {
  const { page } = it;
  await openFiles(it, { 'mine.obj': toObj(cubeMesh(4)) });
  await page.waitForTimeout(300);
  await page.reload();
  await state(page, 'empty');
  await page.waitForSelector('[data-recent]');
  assert.deepEqual(await page.locator('[data-recent]').allInnerTexts(), ['mine.obj']);
  await page.click('[data-recent]');
  await state(page, 'ready');
  await page.waitForFunction(() => /mine\.obj/.test(document.querySelector('.file').innerText));
  await page.click('#close');
  await page.click('#forget-recent');
  await page.waitForSelector('.recent', { state: 'detached' });
  await page.reload();
  await state(page, 'empty');
  await page.waitForTimeout(300);
  assert.equal(await page.locator('.recent').count(), 0);
});

test('a link carries cones and settings to whoever has the file', async () => {
  const { page } = it;
  const files = { 'ball.obj': toObj(cubeMesh(4)) };
  await openFiles(it, files);
  await run(it);
  await page.click('[data-preset="quads"]');
  await state(page, 'certified');
  const cones = await page.locator('#cones tbody').innerText();
  await page.click('#copy-link');
  await statusSays(it, /Copied: a link.*needs the file ball\.obj/);
  const link = await page.evaluate(() => navigator.clipboard.readText());
  await page.goto('about:blank');
  await page.goto(link);
  await state(page, 'empty');
  assert.match(await statusText(page), /Open the file that this link is about/);
  await drop(it, files);
  await page.waitForSelector('#cones tbody tr');
  assert.equal(await page.locator('#cones tbody').innerText(), cones);
  assert.equal(await page.inputValue('#grid-mode'), 'quad');
  await run(it);
});
