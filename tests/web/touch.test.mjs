// Fingers: one turns the model, a long press places, a tap selects; targets are large.

import assert from 'node:assert/strict';
import path from 'node:path';
import test from 'node:test';
import { cubeMesh, toObj } from '../support/meshes.mjs';
import { pixels, settled, shots, state, useBrowser } from './support.mjs';

const it = useBrowser({
  viewport: { width: 390, height: 844 },
  deviceScaleFactor: 1,
  hasTouch: true,
  isMobile: true,
});

test('by finger: turn, hold to place, tap to select, run', async () => {
  const { page } = it;
  const buffer = Buffer.from(toObj(cubeMesh(10)));
  await page.setInputFiles('#file', { name: 'cube.obj', mimeType: 'text/plain', buffer });
  await state(page, 'ready');
  await settled(page);
  const box = await page.locator('#view').boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const session = await it.context.newCDPSession(page);
  const touch = (type, ...points) =>
    session.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([a, b]) => ({ x: a, y: b })) }); // prettier-ignore
  const before = await pixels(page, '#view');
  await touch('touchStart', [x, y]);
  for (let i = 1; i <= 5; i++) await touch('touchMove', [x + 12 * i, y]);
  await touch('touchEnd');
  await settled(page);
  assert.notDeepEqual((await pixels(page, '#view')).data, before.data);
  assert.equal(await page.locator('#cones').count(), 0);

  await touch('touchStart', [x, y]);
  await page.waitForSelector('tr[data-cone="0"].selected'); // held down all the while
  await touch('touchEnd');
  await touch('touchStart', [box.x + 8, box.y + 8]);
  await touch('touchEnd');
  await page.waitForSelector('tr[data-cone="0"]:not(.selected)');
  // The cone is where the finger was, to the nearest vertex.
  await touch('touchStart', [x, y]);
  await touch('touchEnd');
  await page.waitForSelector('tr[data-cone="0"].selected');
  const heights = await page.$$eval('header button', (all) => all.map((one) => one.offsetHeight));
  const shown = heights.filter((height) => height > 0);
  assert.ok(Math.min(...shown) >= 44, `${heights}`);
  assert.ok((await page.locator('header').boundingBox()).height < 100, 'one row and the name');
  await page.click('#clear-cones');
  await page.click('#suggest');
  await page.waitForSelector('#cones');
  await page.click('#run');
  await state(page, 'certified');
  await page.click('#tab-map');
  await settled(page);
  await page.screenshot({ path: path.join(shots, 'touch-map.png') });
  assert.ok(await page.locator('#map').isVisible());
});
