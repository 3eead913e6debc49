// Three things that people come for, from a page that is empty, counted in clicks: what counts is what the page
// receives as trusted clicks.

import assert from 'node:assert/strict';
import { cubeMesh, toGlb } from '../support/meshes.mjs';
import { cubesOnAnEdge } from './shapes.mjs';
import {
  coneCount,
  example,
  openFiles,
  settled,
  state,
  statusText,
  useBrowser,
} from './support.mjs';

const it = useBrowser();
const { test } = it;

async function countClicks() {
  await it.page.evaluate(() => {
    const isCounted = globalThis.clicks !== undefined; // tests share the page
    globalThis.clicks = 0;
    if (isCounted) return;
    const count = ({ isTrusted }) => isTrusted && (globalThis.clicks += 1);
    document.addEventListener('pointerdown', count, true);
  });
}
const clicks = () => it.page.evaluate(() => globalThis.clicks);

test('texture my GLB and see no seam: dropped, one click', async (t) => {
  await countClicks();
  await openFiles(it, { 'box.glb': toGlb([cubeMesh(6)]) });
  await it.page.click('#run');
  await state(it.page, 'certified');
  assert.match(await statusText(it.page), /lines meet at every seam/);
  t.diagnostic(`${await clicks()} click`);
  assert.ok((await clicks()) <= 3);
});

test('eight cones by hand on a pebble: the tool, the places, the rest balanced, Run', async (t) => {
  const { page } = it;
  await example(it, 'pebble');
  await settled(page);
  await countClicks();
  await page.click('#tool-place');
  const box = await page.locator('#view').boundingBox();
  // A ring of six around the middle, and the middle.
  const size = 0.17 * Math.min(box.width, box.height);
  const places = [...Array(6).keys(), undefined].map((i) => {
    const [x, y] =
      i === undefined
        ? [0, 0]
        : [Math.cos((i * Math.PI) / 3), Math.sin((i * Math.PI) / 3)].map((c) => c * size);
    return [box.x + box.width / 2 + x, box.y + box.height / 2 + y];
  });
  for (const [x, y] of places) {
    if ((await coneCount(it)) >= 7) break;
    await page.mouse.click(x, y);
    await page.waitForTimeout(50);
  }
  assert.ok((await coneCount(it)) >= 7);
  const isOpen = await page.locator('#balance').isEnabled();
  if (isOpen) await page.click('#balance');
  await page.waitForSelector('#run:not([aria-disabled="true"])');
  assert.ok((await coneCount(it)) >= 8);
  await page.click('#run');
  await state(page, 'certified', 'not-certified');
  t.diagnostic(`${await clicks()} clicks, ${await coneCount(it)} cones`);
  assert.equal(await page.getAttribute('body', 'data-state'), 'certified');
  assert.ok((await clicks()) <= 20);
});

test('a file that is refused: why, and a map all the same, by one click', async (t) => {
  const { page } = it;
  await countClicks();
  await openFiles(it, { 'broken.obj': cubesOnAnEdge() }, 'invalid');
  assert.match(await page.locator('.defects').innerText(), /\S/);
  await page.click('#repair-and-run');
  await state(page, 'certified');
  t.diagnostic(`${await clicks()} click`);
  assert.ok((await clicks()) <= 2);
});
