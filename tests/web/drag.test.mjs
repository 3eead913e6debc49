// A cone that is dragged over a map, as a person does it: the map follows, says in which state it is, and is the result
// when the cone is dropped.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import path from 'node:path';
import { openCubeWithCones } from './shapes.mjs';
import {
  commandLine,
  pixels,
  run,
  saveAs,
  settled,
  shots,
  state,
  statusText,
  useBrowser,
  workerCalls,
} from './support.mjs';

const it = useBrowser();
const { test } = it;

const vertexOf = (i) => it.page.locator(`tr[data-cone="${i}"] td`).first().innerText();

/** A map of a rounded cube, with a cone in the middle of the 3D view; returns where it is. */
async function mapped() {
  const { page } = it;
  await openCubeWithCones(it);
  await run(it);
  await settled(page);
  await page.click('tr[data-cone="0"] [aria-label$="frame"]');
  await settled(page);
  const box = await page.locator('#view').boundingBox();
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

/** Notes the states that the page shows, from now on. */
const noteStates = (page) =>
  page.evaluate(() => {
    const canvas = document.querySelector('#map');
    globalThis.liveStates = [];
    const note = () => globalThis.liveStates.push(canvas.dataset.live);
    globalThis.liveWatch = new MutationObserver(note);
    globalThis.liveWatch.observe(canvas, { attributeFilter: ['data-live'] });
  });

const liveIs = (page, ...states) =>
  page.waitForFunction(
    (wanted) => wanted.includes(document.querySelector('#map').dataset.live),
    states,
  );

test('the map follows the hand, and is the result when the cone is dropped', async (t) => {
  const { page } = it;
  const { x, y } = await mapped();
  const before = await vertexOf(0);
  const map = await pixels(page, '#map');
  await noteStates(page);
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let i = 1; i <= 8; i++) {
    await page.mouse.move(x + 8 * i, y + 3 * i);
    await page.waitForTimeout(30);
  }
  await state(page, 'dragging');
  await liveIs(page, 'certified');
  assert.match(await page.locator('#live').innerText(), /Passes every check · not stored yet/);
  await page.screenshot({ path: path.join(shots, 'drag-certified.png') });
  const under = await pixels(page, '#map');
  assert.notDeepEqual(under.data, map.data, 'the map has moved');
  await page.mouse.up();
  await state(page, 'certified');
  await settled(page);
  const states = await page.evaluate(() => globalThis.liveStates);
  assert.ok(states.includes('certified'), states.join());
  assert.equal(states.at(-1), '');
  assert.notEqual(await vertexOf(0), before);
  assert.match(await statusText(page), /The dragged map is the result/);
  assert.match(
    await page.locator('#dragged').innerText(),
    /its bytes depend on the path.*Run.*depends on nothing else/s,
  );
  await page.screenshot({ path: path.join(shots, 'drag-dropped.png') });

  // What is saved is verified by the command line, for the cones that it contains.
  const saved = await saveAs(it, 'same');
  const program = commandLine(t);
  if (program) {
    const file = path.join(it.folder, 'dragged.obj');
    writeFileSync(file, saved.bytes ?? saved);
    const verdict = execFileSync(program, ['verify', file], { encoding: 'utf8' });
    assert.match(verdict, /certified/i);
  }

  // Undo brings the map before back, redo that of the drag, both without a run.
  await page.keyboard.press('Control+z');
  await state(page, 'certified');
  assert.equal(await vertexOf(0), before);
  assert.equal(await page.locator('#dragged').count(), 0);
  await page.keyboard.press('Control+Shift+z');
  await page.waitForSelector('#dragged');
});

test('while the pointer rests on a cone its drag is prepared', async () => {
  const { page } = it;
  const { x, y } = await mapped();
  const calls = await workerCalls(page);
  const begun = async () => (await calls.names()).filter((name) => name === 'beginDrag').length;
  const isBegun = async (count) => {
    while ((await begun()) < count) await page.waitForTimeout(20);
  };
  await page.mouse.move(x, y);
  await isBegun(1);
  await page.mouse.down();
  for (let i = 1; i <= 6; i++) await page.mouse.move(x + 6 * i, y);
  await liveIs(page, 'certified');
  await page.mouse.up();
  await page.waitForSelector('#dragged');
  await settled(page);
  assert.equal(await begun(), 1);
  // Once more, and given up where the pointer leaves.
  await calls.forget();
  await page.mouse.move(x + 36, y - 1);
  await isBegun(1);
  await page.mouse.move(5, 5);
  while (!(await calls.names()).includes('release')) await page.waitForTimeout(20);
});

test('a cone that is put back with Escape leaves the map as it was', async () => {
  const { page } = it;
  const { x, y } = await mapped();
  const before = await vertexOf(0);
  await page.mouse.move(0, 0);
  const map = await pixels(page, '#map');
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let i = 1; i <= 6; i++) await page.mouse.move(x + 8 * i, y);
  await liveIs(page, 'certified');
  await page.keyboard.press('Escape');
  await page.mouse.up();
  await state(page, 'certified');
  await liveIs(page, '');
  await settled(page);
  assert.equal(await vertexOf(0), before);
  await page.click('tr[data-cone="0"] [aria-label$="frame"]'); // undo selects nothing
  await page.mouse.move(0, 0);
  await settled(page);
  assert.deepEqual((await pixels(page, '#map')).data, map.data);
});

test('two drags in a row, the second before the first is stored', async () => {
  const { page } = it;
  const { x, y } = await mapped();
  const drag = async (x0, y0, dx, dy, count = 5) => {
    await page.mouse.move(x0, y0);
    await page.mouse.down();
    for (let i = 1; i <= count; i++) await page.mouse.move(x0 + dx * i, y0 + dy * i);
  };
  await drag(x, y, 8, 0);
  await liveIs(page, 'certified');
  await page.mouse.up();
  await drag(x + 40, y, 0, 8);
  await page.mouse.up();
  const last = await vertexOf(0);
  const isStored = async () => {
    await page.waitForFunction(
      () =>
        document.body.dataset.state === 'certified' &&
        document.querySelector('#map').dataset.live === '' &&
        document.querySelector('#dragged'),
    );
    await settled(page);
  };
  await isStored();
  assert.equal(await vertexOf(0), last);
  assert.equal(await page.locator('#dragged').count(), 1);

  // Three without a pause: each waits for the one before.
  for (const [i, dx] of [-6, -5, -7].entries()) {
    await drag(x + 40 - 24 * i, y + 40, dx, 0, 4);
    await page.mouse.up();
  }
  const end = await vertexOf(0);
  assert.notEqual(end, last);
  await isStored();
  assert.equal(await vertexOf(0), end);
});
