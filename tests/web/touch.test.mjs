// Fingers: one turns the model, a long press places, a tap selects, two zoom; targets are large, and
// the panels are a sheet.

import assert from 'node:assert/strict';
import path from 'node:path';
import { cubeMesh, toObj } from '../support/meshes.mjs';
import { pixels, run, settled, shots, state, useBrowser, violations } from './support.mjs';

const it = useBrowser({
  viewport: { width: 390, height: 844 },
  deviceScaleFactor: 1,
  hasTouch: true,
  isMobile: true,
});
const { test } = it;

/** Sends touches as a screen does. */
async function fingers() {
  const session = await it.context.newCDPSession(it.page);
  return (type, ...points) =>
    session.send('Input.dispatchTouchEvent', {
      type,
      touchPoints: points.map(([x, y], id) => ({ x, y, id })),
    });
}

async function openCube() {
  const buffer = Buffer.from(toObj(cubeMesh(10)));
  await it.page.setInputFiles('#file', { name: 'cube.obj', mimeType: 'text/plain', buffer });
  await state(it.page, 'ready');
  await settled(it.page);
}

test('by finger: turn, hold to place, tap to select, run', async () => {
  const { page } = it;
  await openCube();
  const box = await page.locator('#view').boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const touch = await fingers();
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
  await run(it);
  await page.click('#tab-map');
  await settled(page);
  await page.screenshot({ path: path.join(shots, 'touch-map.png') });
  assert.ok(await page.locator('#map').isVisible());
});

test('by finger: a cone is dragged, and its map with it', async () => {
  const { page } = it;
  await openCube();
  await run(it);
  const vertex = () => page.locator('tr[data-cone="0"] td').first().innerText();
  const before = await vertex();
  const touch = await fingers();
  const dragged = page.locator('#dragged');
  // A finger that comes before the view has moved to the cone turns the model instead.
  for (let attempt = 0; attempt < 3 && !(await dragged.isVisible()); attempt++) {
    await page.click('tr[data-cone="0"] [aria-label$="frame"]');
    await page.click('#tab-surface');
    await settled(page);
    const box = await page.locator('#view').boundingBox();
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await touch('touchStart', [x, y]);
    for (let i = 1; i <= 5; i++) await touch('touchMove', [x + 12 * i, y]);
    await touch('touchEnd');
    await dragged.waitFor({ timeout: 15_000 }).catch(() => undefined);
  }
  assert.ok(await dragged.isVisible());
  await state(page, 'certified');
  assert.notEqual(await vertex(), before);
});

test('by finger with the Place tool: a tap places, a movement turns', async () => {
  const { page } = it;
  await openCube();
  await page.tap('#tool-place');
  const box = await page.locator('#view').boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const touch = await fingers();
  await touch('touchStart', [x, y]);
  await touch('touchEnd');
  await page.waitForSelector('tr[data-cone="0"]');
  await touch('touchStart', [x + 40, y]);
  for (let i = 1; i <= 5; i++) await touch('touchMove', [x + 40 - 12 * i, y + 30]);
  await touch('touchEnd');
  await settled(page);
  assert.equal(await page.locator('tr[data-cone]').count(), 1);
});

/** Where what is not background begins and ends, in pixels of the picture. */
function extent({ data, width, height }) {
  const edge = 4; // pixels
  const corner = 4 * (edge * width + edge);
  const paper = [...data.subarray(corner, corner + 3)];
  let [left, right, top, bottom] = [width, 0, height, 0];
  for (let y = edge; y < height - edge; y++) {
    for (let x = edge; x < width - edge; x++) {
      const at = 4 * (y * width + x);
      if (paper.every((colour, k) => Math.abs(data[at + k] - colour) < 12)) continue;
      [left, right] = [Math.min(left, x), Math.max(right, x)];
      [top, bottom] = [Math.min(top, y), Math.max(bottom, y)];
    }
  }
  return {
    width: right - left,
    height: bottom - top,
    x: (left + right) / 2,
    y: (top + bottom) / 2,
  };
}

test('two fingers in the UV view: dragging moves it, spreading enlarges it', async () => {
  const { page } = it;
  await openCube();
  await run(it);
  await page.tap('#view-menu');
  await page.selectOption('#pattern', 'plain');
  await page.tap('#view-options [popovertargetaction="hide"]');
  await page.click('#tab-map');
  await page.evaluate(() => (document.querySelector('hgp-map-scale').hidden = true));
  await settled(page);
  const touch = await fingers();
  const box = await page.locator('#map').boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const before = extent(await pixels(page, '#map'));
  // Towards each other first, so that all of the map stays in sight.
  await touch('touchStart', [x - 80, y], [x + 80, y]);
  for (let i = 1; i <= 8; i++) await touch('touchMove', [x - 80 + 5 * i, y], [x + 80 - 5 * i, y]);
  await touch('touchEnd');
  await settled(page);
  const smaller = extent(await pixels(page, '#map'));
  assert.ok(
    Math.abs(smaller.width / before.width - 0.5) < 0.08,
    `${smaller.width} of ${before.width}`,
  );
  await touch('touchStart', [x - 40, y], [x + 40, y]);
  for (let i = 1; i <= 6; i++) await touch('touchMove', [x - 40 + 5 * i, y - 5 * i], [x + 40 + 5 * i, y - 5 * i]); // prettier-ignore
  await touch('touchEnd');
  await settled(page);
  const moved = extent(await pixels(page, '#map', 'touch-pinch'));
  assert.ok(Math.abs(moved.width / smaller.width - 1) < 0.05);
  assert.ok(Math.abs(moved.x - smaller.x - 30) < 4, `${moved.x - smaller.x}`);
  assert.ok(Math.abs(moved.y - smaller.y + 30) < 4, `${moved.y - smaller.y}`);
  // What was placed or selected meanwhile: nothing.
  assert.equal(await page.locator('tr.selected').count(), 0);
});

test('Repair and run is where Run is', async () => {
  const { page } = it;
  const { vertices, triangles } = cubeMesh(4);
  const buffer = Buffer.from(toObj({ vertices, triangles: [...triangles, triangles[9]] }));
  await page.setInputFiles('#file', { name: 'twice.obj', mimeType: 'text/plain', buffer });
  await state(page, 'invalid');
  const box = await page.locator('footer #repair-and-run').boundingBox();
  assert.ok(box.y > 760 && box.y + box.height <= 844 && box.x > 250 && box.x + box.width <= 390);
  const words = await page.$eval('footer #repair-and-run', (button) => {
    const range = document.createRange();
    range.selectNodeContents(button);
    return range.getBoundingClientRect().toJSON();
  });
  assert.ok(words.top >= box.y && words.bottom <= box.y + box.height, 'its words are inside');
  const text = await page.locator('#status').boundingBox();
  assert.ok(text.x + text.width <= box.x, 'the status is beside it');
  await page.tap('#repair-and-run');
  await state(page, 'certified');
});

test('the View menu has all picture settings, under the picture, and a tap beside it closes it', async () => {
  const { page } = it;
  await openCube();
  // Before Run: what there is to choose then.
  await page.tap('#view-menu');
  assert.equal(await page.locator('#pattern').count(), 0);
  assert.ok(await page.locator('#view-options #wire').isVisible());
  await page.tap('#view-options [popovertargetaction="hide"]');
  await run(it);
  await settled(page);
  const before = await pixels(page, '#view');
  await page.tap('#view-menu');
  const menu = await page.locator('#view-options').boundingBox();
  const view = await page.locator('#view').boundingBox();
  assert.ok(menu.y >= view.y + view.height - 2, `${menu.y}: the picture stays in sight`);
  assert.ok(menu.x >= 0 && menu.x + menu.width <= 390 && menu.y + menu.height <= 844);
  const items = '#view-options :is(button, select, input)';
  const heights = await page.$$eval(items, (all) => all.map((one) => one.offsetHeight));
  assert.ok(heights.length >= 9 && Math.min(...heights) >= 44, `${heights}`);
  const widths = await page.$$eval(items, (all) => all.map((one) => one.offsetWidth));
  assert.ok(Math.min(...widths) >= 44, `${widths}`);
  const texts = await page.locator('#view-options button').allInnerTexts();
  assert.ok(
    texts.every((text) => text.trim().length > 3),
    `${texts}`,
  ); // fingers get no tooltips
  await page.selectOption('#pattern', 'grid');
  await page.tap('#view-options #wire');
  await settled(page);
  assert.notDeepEqual((await pixels(page, '#view')).data, before.data);
  assert.equal(await page.getAttribute('#wire', 'aria-pressed'), 'true');
  await page.screenshot({ path: path.join(shots, 'touch-view-menu.png') });
  assert.deepEqual(await violations(page), []);
  await page.touchscreen.tap(view.x + 20, view.y + view.height - 20);
  await page.waitForSelector('#view-options', { state: 'hidden' });
  // Nothing of the toolbar is beyond the edge, on the smallest of phones, too.
  await page.setViewportSize({ width: 320, height: 640 });
  await settled(page);
  const last = await page.locator('#view-menu').boundingBox();
  assert.ok(last.x + last.width <= 320, `${last.x + last.width}`);
});

test('the panels are a sheet, pressed or dragged to three heights; Run is always visible', async () => {
  const { page } = it;
  await openCube();
  const height = async () => (await page.locator('aside').boundingBox()).height;
  /** In the corner next to the thumb, and nothing lies over it. */
  const isRunSeen = async () => {
    const box = await page.locator('#run').boundingBox();
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    const top = await page.evaluate(([a, b]) => document.elementFromPoint(a, b)?.closest('button')?.id, [x, y]); // prettier-ignore
    return (
      top === 'run' && box.height >= 44 && box.y > 760 && box.y + box.height <= 844 && box.x > 250
    );
  };
  const half = await height();
  assert.ok(await isRunSeen());
  await page.click('#suggest');
  await page.waitForSelector('#cones');
  // Only the sheet scrolls: below the page there is nothing.
  const pageHeight = await page.evaluate(() => document.documentElement.scrollHeight);
  assert.equal(pageHeight, 844);
  assert.ok(half > 250 && half < 450, `${half}`);
  const view = (await page.locator('#view').boundingBox()).height;
  await page.screenshot({ path: path.join(shots, 'sheet-half.png') });
  await page.click('#sheet');
  const full = await height();
  assert.ok(full > 580, `${full}`);
  assert.ok(await isRunSeen());
  await page.screenshot({ path: path.join(shots, 'sheet-full.png') });
  await page.click('#sheet');
  assert.ok((await height()) < 60);
  assert.equal(await page.locator('#sheet').getAttribute('aria-expanded'), 'false');
  assert.equal(await page.locator('#suggest').isVisible(), false);
  assert.ok((await page.locator('#view').boundingBox()).height > view + 200);
  await settled(page);
  await page.screenshot({ path: path.join(shots, 'sheet-peek.png') });
  assert.deepEqual(await violations(page), []);
  // A dialog is in the middle: nothing widens the page unseen.
  await page.click('#help');
  const dialog = await page.locator('#help-dialog').boundingBox();
  assert.ok(Math.abs(dialog.x + dialog.width / 2 - 195) < 2, `${dialog.x}`);
  const words = await page.locator('#help-dialog').innerText();
  assert.match(words, /Two fingers/);
  assert.doesNotMatch(words, /Ctrl|Single-key/, 'no keys where there is no keyboard');
  await page.screenshot({ path: path.join(shots, 'touch-help.png') });
  await page.keyboard.press('Escape');
  // A finger pulls it up: a little is half, far is all.
  const touch = await fingers();
  const handle = await page.locator('#sheet').boundingBox();
  const [x, y] = [handle.x + handle.width / 2, handle.y + handle.height / 2];
  const pull = async (from, to) => {
    await touch('touchStart', [x, from]);
    for (let i = 1; i <= 5; i++) await touch('touchMove', [x, from + ((to - from) * i) / 5]);
    await touch('touchEnd');
  };
  await pull(y, y - 300);
  await page.waitForSelector('main[data-sheet="half"]');
  assert.ok(Math.abs((await height()) - half) < 2);
  const top = (await page.locator('#sheet').boundingBox()).y + 20;
  await pull(top, top - 320);
  await page.waitForSelector('main[data-sheet="full"]');
  // And by keyboard.
  await page.locator('#sheet').focus();
  await page.keyboard.press('Enter');
  await page.waitForSelector('main[data-sheet="peek"]');
  assert.ok(await isRunSeen());
  await run(it);
});
