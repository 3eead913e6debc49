// Cones by mouse and by keyboard, the budget, undo, and what survives a reload.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import path from 'node:path';
import { cubeMesh, toObj } from '../support/meshes.mjs';
import { bumpyBall, hornedBox } from './shapes.mjs';
import {
  commandLine,
  coneCount,
  download,
  drop,
  example,
  kOf,
  openFiles,
  run,
  saveAs,
  settled,
  state,
  statusText,
  useBrowser,
  workerCalls,
} from './support.mjs';

const it = useBrowser();
const { test } = it;
const vertexOf = (i) => it.page.locator(`tr[data-cone="${i}"] td`).first().innerText();

test('where sizes differ ten times, one click adds cones there, and the numbers before stay in view', async () => {
  const { page } = it;
  const mesh = cubeMesh(8);
  for (const p of mesh.vertices) p[2] *= 4; // a tower, with all its cones at one end
  await openFiles(it, { 'tower.obj': toObj(mesh) });
  const low = [...mesh.vertices.keys()].filter((v) => mesh.vertices[v][2] <= Math.min(...mesh.vertices.map((p) => p[2])) + 1.01); // prettier-ignore
  const cones = [0, 4, 8, 12, 16, 20, 24, 28].map((i) => ({ vertex: low[i], k: 3 }));
  await drop(it, { 'low.cones.json': JSON.stringify({ format: 'hgp-cones', version: 1, q: 4, cones }) }); // prettier-ignore
  await page.waitForSelector('tr[data-cone="7"]');
  // The slider does not claim them.
  assert.match(await page.innerText('#cone-step-count'), /^8 cones, from a file/);
  await run(it);
  const sizes = () => page.locator('#size').innerText();
  const first = Number(/× (\d+)/.exec(await sizes())[1]);
  assert.ok(first > 3, await sizes());
  assert.match(await page.innerText('#sizes-differ'), /times larger in some places than in others/);
  await page.click('#sizes-differ button >> text=Show');
  assert.match(await statusText(page), /triangles are outlined|Shown: triangle/);
  await page.click('#sizes-differ button >> text=/Add .* and run/');
  await page.waitForSelector('#size .before');
  const [, before, after] = /× (\d+).*now:\s*× ([\d.]+)/s.exec(await sizes());
  assert.equal(Number(before), first);
  assert.ok(Number(after) < 0.6 * first, await sizes());
  await page.click('#undo'); // one step
  assert.equal(await coneCount(it), 8);
  // The pointer shows the local size.
  const box = await page.locator('#view').boundingBox();
  await page.click('#seams'); // so that it is not about a seam
  await settled(page);
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.waitForFunction(() =>
    /pattern × [\d.]+ · [\d.]+ cells per unit/.test(document.querySelector('.hover').innerText),
  );
});

async function openCube() {
  await openFiles(it, { 'cube.obj': toObj(cubeMesh(8)) });
  await settled(it.page);
}

test('by mouse: place, select, drag, delete, undo, redo', async () => {
  await openCube();
  const box = await it.page.locator('#view').boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  // From further away, where vertices are near every pointer.
  await it.page.mouse.move(x, y);
  for (let i = 0; i < 8; i++) await it.page.mouse.wheel(0, 120);
  await settled(it.page);
  await it.page.click('#tool-place');
  await it.page.mouse.click(x, y);
  await it.page.waitForSelector('tr[data-cone="0"].selected');
  const vertex = await vertexOf(0);
  await it.page.mouse.click(x + 90, y + 20);
  await it.page.waitForSelector('tr[data-cone="1"].selected');
  const second = await vertexOf(1);
  assert.notEqual(second, vertex);

  // Drag the second cone along the surface: one step of undo, and the camera stays.
  await settled(it.page);
  await it.page.mouse.move(x + 90, y + 20);
  const { left, top } = await it.page.evaluate(() =>
    document.querySelector('#view').getBoundingClientRect(),
  );
  assert.ok(left >= 0 && top >= 0);
  await it.page.mouse.down();
  for (let i = 1; i <= 6; i++) await it.page.mouse.move(x + 90, y + 20 - 15 * i);
  await it.page.mouse.up();
  const moved = await vertexOf(1);
  assert.notEqual(moved, second);
  await it.page.keyboard.press('Control+z');
  assert.equal(await vertexOf(1), second);
  await it.page.keyboard.press('Control+Shift+z');
  assert.equal(await vertexOf(1), moved);

  // Escape in the middle of a drag puts the cone back.
  await settled(it.page);
  await it.page.mouse.move(x + 90, y - 70);
  await it.page.click('tr[data-cone="1"] [aria-label$="frame"]');
  await settled(it.page);
  await it.page.mouse.move(x, y);
  await it.page.mouse.down();
  for (let i = 1; i <= 6; i++) await it.page.mouse.move(x - 15 * i, y + 5 * i);
  assert.notEqual(await vertexOf(1), moved);
  await it.page.keyboard.press('Escape');
  assert.equal(await vertexOf(1), moved);
  await it.page.mouse.move(x - 100, y - 100);
  await it.page.mouse.up();
  assert.equal(await vertexOf(1), moved);

  await it.page.click('tr[data-cone="1"] [aria-label$="delete"]');
  assert.equal(await coneCount(it), 1);
  await it.page.click('#undo');
  assert.equal(await coneCount(it), 2);
});

test('by keyboard alone: open an example, place three cones, run, download', async () => {
  const { page } = it;
  await page.locator('[data-card="sphere"]').focus();
  await page.keyboard.press('Enter');
  await state(page, 'ready');
  await page.locator('#clear-cones').focus();
  await page.keyboard.press('Enter');
  await page.waitForSelector('.budget[data-left="12"]');
  await page.locator('#view').focus();
  await page.keyboard.press('c');
  await page.waitForFunction(() =>
    /vertex \d+, valence/.test(document.querySelector('#status').textContent),
  );
  for (let cone = 0; cone < 3; cone++) {
    await page.keyboard.press('Enter');
    await page.keyboard.press('2');
    for (let i = 0; i < 8; i++) await page.keyboard.press(cone === 0 ? 'ArrowLeft' : 'ArrowDown');
  }
  assert.equal(await coneCount(it), 3);
  for (let i = 0; i < 3; i++) assert.equal(await kOf(it, i), '2');
  await page.waitForSelector('.budget.good');
  const focused = () => page.evaluate(() => document.activeElement.id);
  // Tab leaves the view: no trap.
  await page.keyboard.press('Tab');
  assert.notEqual(await focused(), 'view');
  await page.keyboard.press('Control+Enter');
  await state(page, 'certified');
  await page.locator('#view').focus();
  // U goes to the other view and back.
  await page.keyboard.press('u');
  await page.waitForFunction(() => document.activeElement.id === 'map');
  await page.keyboard.press('u');
  await page.waitForFunction(() => document.activeElement.id === 'view');
  await page.keyboard.press('Control+s');
  const { name } = await download(page, () => page.keyboard.press('Enter'));
  assert.equal(name, 'sphere.glb');
});

test('the budget shows what is left and how to balance it; q converts where that is exact', async () => {
  const { page } = it;
  await example(it, 'cube');
  assert.equal(await coneCount(it), 8);
  await page.waitForSelector('.budget.good');
  await page.click('tr[data-cone="0"] [aria-label$="larger k"]');
  await page.waitForSelector('.budget[data-left="1"]');
  assert.match(
    await page.locator('.budget').innerText(),
    /^7 of 8 quarter turns[\s\S]*1 left[\s\S]*k = 3/,
  );
  assert.equal(await page.locator('#run').getAttribute('aria-disabled'), 'true');
  assert.match(await page.locator('#run-why').textContent(), /1 left/);
  await page.click('#balance');
  await page.waitForSelector('.budget.good');
  assert.equal(await coneCount(it), 9);
  assert.match(await statusText(page), /1 cone added, with k = 3/);
  await page.click('#undo');
  await page.click('tr[data-cone="0"] [aria-label$="smaller k"]');
  await page.waitForSelector('.budget.good');
  await page.selectOption('#q', '8');
  assert.equal(await kOf(it, 0), '6');
  await page.selectOption('#q', '3'); // 6·3/8 is no integer
  assert.match(await statusText(page), /are not whole multiples of 360/);
  assert.equal(await kOf(it, 0), '6');
  await page.keyboard.press('Control+z');
  assert.equal(await kOf(it, 0), '3');
});

test('export, clear, import; and cones are offered again after a reload', async () => {
  const { page } = it;
  await openCube();
  await page.click('#suggest');
  await page.waitForSelector('#cones');
  const count = await coneCount(it);
  const file = await download(page, () => page.click('#export-cones'));
  await page.click('#clear-cones');
  await page.waitForSelector('#cones', { state: 'detached' });
  await drop(it, { 'mine.cones.json': file.bytes });
  await page.waitForSelector('#cones');
  assert.equal(await coneCount(it), count);
  // The address of the page has them, once it is written; they are taken when the file is open again.
  await page.waitForFunction(() => location.hash.includes('cones='));
  page.on('dialog', (dialog) => void dialog.accept());
  await page.reload();
  await state(page, 'empty');
  await openCube();
  await page.waitForSelector('#cones');
  assert.equal(await coneCount(it), count);
  // A visit without this address: they are offered.
  await page.goto('about:blank');
  await page.goto(it.url);
  await state(page, 'empty');
  await openCube();
  await page.click('footer button:has-text("Restore")');
  assert.equal(await coneCount(it), count);
});

test('a stale result is marked as such, and undo restores its map without a run', async () => {
  const { page } = it;
  await example(it, 'cube');
  await run(it);
  await page.click('tr[data-cone="0"] [aria-label$="larger k"]');
  await state(page, 'stale');
  assert.match(await page.locator('.badge').innerText(), /previous cones/);
  await page.click('#undo');
  await state(page, 'certified');
});

test('after undo its map is saved in every format without another run', async (t) => {
  const { page } = it;
  const calls = await workerCalls(page);
  await example(it, 'sphere'); // q = 6: single precision rounds its rotations off
  await run(it);
  const before = await saveAs(it, 'obj');
  await page.click('tr[data-cone="0"] [aria-label$="smaller k"]');
  await page.click('tr[data-cone="1"] [aria-label$="larger k"]');
  await run(it, 'certified', 'not-certified');
  await page.click('#undo');
  await page.click('#undo');
  await state(page, 'certified');
  await calls.forget();
  const after = await saveAs(it, 'obj');
  assert.deepEqual(after.bytes, before.bytes);
  const called = await calls.names();
  assert.ok(called.includes('write') && !called.includes('parametrize'), `${called}`);
  const program = commandLine(t);
  if (program) {
    const file = path.join(it.folder, 'sphere-after-undo.obj');
    writeFileSync(file, after.bytes);
    const verified = spawnSync(program, ['verify', file, '--q', '6'], { encoding: 'utf8' });
    assert.equal(verified.status, 0, verified.stdout + verified.stderr);
  }
  await page.reload();
});

test('the slider from fewer cones to less distortion chooses cones and shows how many', async () => {
  const { page } = it;
  await example(it, 'pebble');
  const slide = async (step) => {
    const slider = page.locator('#cone-step');
    await slider.fill(String(step));
    await slider.dispatchEvent('change');
    await state(page, 'ready');
    await page.waitForFunction(() =>
      /: \d+ cones$/.test(document.querySelector('#cone-step-count').innerText),
    );
    const said = Number(/(\d+) cones$/.exec(await page.locator('#cone-step-count').innerText())[1]);
    await page.waitForFunction(
      (n) => document.querySelector('#panel-cones .count').innerText === String(n),
      said,
    );
    return said;
  };
  const few = await slide(0);
  const balanced = await slide(2);
  const between = await slide(1);
  await page.waitForTimeout(600); // changes within half a second are one step of undo
  const many = await slide(4);
  assert.ok(
    few < between && between < balanced && balanced <= many,
    `${few} ${between} ${balanced} ${many}`,
  );
  // Back at once, with one step of undo.
  await page.click('#undo');
  await page.waitForFunction((n) => document.querySelector('#panel-cones .count').innerText === String(n), between); // prettier-ignore
  await run(it);
});

test('the slider from angles to areas lowers distortion and appears in the command line', async () => {
  const { page } = it;
  await example(it, 'pebble');
  await run(it);
  const areas = async () => {
    await page.click('#result-details > summary');
    const text = await page.locator('#result-details').innerText();
    await page.click('#result-details > summary');
    return /log₂ area, 5 · 95 %\s*([−\d.]+) · ([−\d.]+)/.exec(text).slice(1).map((x) => Number(x.replace('−', '-'))); // prettier-ignore
  };
  const [low, high] = await areas();
  const shown = () => page.evaluate(() => ['stretch', 'size'].map((id) => Number(/[\d.]+/.exec(document.querySelector(`#${id} > span`).innerText)[0]))); // prettier-ignore
  const before = await shown();
  await page.locator('#quality').check();
  assert.equal(await page.getAttribute('body', 'data-state'), 'stale');
  await run(it);
  const after = await shown();
  // Sizes fall, and stretch, which is small here, hardly rises; in the middle of the slider it would be twice as large.
  assert.ok(after[0] < 1.3 * before[0] && after[1] <= before[1], `${before} to ${after}`);
  const slider = page.locator('#improve');
  await slider.fill('1');
  await slider.dispatchEvent('change');
  assert.equal(await slider.getAttribute('aria-valuetext'), 'areas');
  await run(it);
  const [lower, higher] = await areas();
  assert.ok(higher - lower < 0.8 * (high - low), `${low} ${high} to ${lower} ${higher}`);
  await page.locator('#quality').uncheck();
  assert.equal(await page.getAttribute('body', 'data-state'), 'certified'); // the map before is there
});

test('Run takes as few cones as make a good map, otherwise more; the slider says which', async () => {
  const { page } = it;
  const slider = page.locator('#cone-step');
  await openFiles(it, { 'low.obj': toObj(bumpyBall(10, 0.12, 3)) });
  await run(it);
  const few = await coneCount(it);
  assert.ok(few > 0 && few < 8, `${few}`);
  assert.match(await page.innerText('#cone-step-count'), new RegExp(`^As few .*: ${few} cones$`));
  assert.equal(await slider.inputValue(), '0');
  assert.ok(parseFloat(await page.innerText('#stretch')) <= 15);
  await openFiles(it, { 'high.obj': toObj(bumpyBall(14, 0.25, 5)) });
  await run(it);
  assert.ok((await coneCount(it)) > few);
  assert.equal(await slider.inputValue(), '2');
  assert.match(await page.innerText('#cone-step-count'), /^In the middle: \d+ cones$/);
  assert.ok(parseFloat(await page.innerText('#stretch')) <= 15);
});

/** Cones at vertices of the open mesh, by default far apart. */
const dropCones = (ks, at = ks.map((_, i) => 5 * i)) =>
  drop(it, { 'many.cones.json': JSON.stringify({ format: 'hgp-cones', version: 1, q: 4, cones: ks.map((k, i) => ({ vertex: at[i], k })) }) }); // prettier-ignore

test('X mirrors the selected cone, as one step of undo; what cannot be mirrored is said', async () => {
  const { page } = it;
  const first = 'Cone 1: select';
  await openFiles(it, { 'box.obj': toObj(hornedBox(0.4, 0.3).mesh) });
  await dropCones([3], [7]);
  await page.click(`[aria-label="${first}"]`);
  await page.locator('#view').focus();
  await page.keyboard.press('x');
  await page.waitForSelector('tr[data-cone="1"].selected');
  assert.equal(await kOf(it, 1), '3');
  assert.equal(await vertexOf(1), '6'); // the first eight vertices are the corners, 6 and 7 apart in x
  await page.keyboard.press('x'); // and back
  await page.waitForSelector('tr[data-cone="0"].selected');
  assert.equal(await coneCount(it), 2);
  await page.click('#undo');
  assert.equal(await coneCount(it), 1);
  const odd = cubeMesh(8);
  for (const p of odd.vertices) {
    const [x, y, z] = p;
    [p[0], p[1], p[2]] = [x + 0.35 * y + 0.04 * z * z, y * (1 + 0.08 * x) + 0.3 * z, 1.4 * z + 0.1 * x * y]; // prettier-ignore
  }
  await openFiles(it, { 'odd.obj': toObj(odd) });
  await dropCones([3]);
  await page.click(`[aria-label="${first}"]`);
  await page.click('#mirror-cone');
  await page.waitForSelector('#status.error');
  assert.match(await statusText(page), /not its own mirror image/);
});

test('a click near the corner of a box places the cone on it, with Alt at the nearest vertex', async () => {
  const { page } = it;
  const box = cubeMesh(8);
  for (const p of box.vertices) {
    const most = Math.max(...p.map(Math.abs));
    p.forEach((x, i) => (p[i] = x / most));
  }
  await openFiles(it, { 'box.obj': toObj(box) });
  await settled(page);
  await page.click('#tool-place');
  // From far away, where the corner is within reach of its neighbours.
  const view = await page.locator('#view').boundingBox();
  await page.mouse.move(view.x + view.width / 2, view.y + view.height / 2);
  for (let i = 0; i < 10; i++) await page.mouse.wheel(0, 120);
  await settled(page);
  // Along a line from the middle to the corner that is nearest to the eye, above and to the right: (1, 1, 1) is vertex 7.
  const nearest = async (options) => {
    const placed = new Set();
    for (let far = 0; far < 40; far += 4) {
      await page.mouse.move(view.x + view.width / 2 + far, view.y + view.height / 2 - far);
      if (options) await page.keyboard.down('Alt');
      await page.mouse.down();
      await page.mouse.up();
      if (options) await page.keyboard.up('Alt');
      if ((await coneCount(it)) === 0) continue;
      placed.add(Number(await vertexOf(0)));
      await page.click('#clear-cones');
      await page.waitForSelector('#cones', { state: 'detached' });
    }
    return placed;
  };
  const snapped = await nearest(false);
  assert.ok(snapped.has(7), `${[...snapped]}`);
  const exact = await nearest(true);
  assert.ok(exact.size > snapped.size, `${[...exact]} and ${[...snapped]}`);
});

test('up to twenty cones are listed, more are counted by angle; a count opens, and what is selected is listed', async () => {
  const { page } = it;
  await openCube();
  await dropCones(Array(20).fill(3));
  await page.waitForSelector('tr[data-cone="19"]');
  assert.equal(await page.locator('#cones .kind').count(), 0);
  await dropCones([...Array(15).fill(3), ...Array(8).fill(5)]);
  await page.waitForSelector('#cones .kind');
  const groups = await page.locator('#cones .kind').allInnerTexts();
  assert.deepEqual(groups.map((text) => text.trim()), ['15 cones of 270°, k = 3', '8 cones of 450°, k = 5']); // prettier-ignore
  assert.equal(await coneCount(it), 0);
  await page.click('[data-group="5"] button');
  assert.equal(await coneCount(it), 8);
  await page.click('[data-group="5"] button');
  await page.locator('#view').focus();
  await page.keyboard.press('n'); // the next cone
  assert.equal(await coneCount(it), 1);
  await page.click('tr[data-cone] [aria-label$="delete"]');
  await page.waitForFunction(() => /14 cones of 270°/.test(document.querySelector('#cones').innerText)); // prettier-ignore
});

test('the table of cones is one stop for Tab; arrows, Home and End move in it, and a number keeps its arrows', async () => {
  const { page } = it;
  await example(it, 'cube');
  const focused = () =>
    page.evaluate(() => {
      const { activeElement: at } = document;
      return [at.closest('tr')?.dataset.cone, at.getAttribute('aria-label') ?? at.id].join(' ');
    });
  await page.locator('#cone-step').focus();
  await page.keyboard.press('Tab');
  assert.equal(await focused(), '0 Cone 1: select');
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('ArrowDown');
  assert.equal(await focused(), '2 Cone 3: select');
  await page.keyboard.press('End');
  assert.equal(await focused(), '2 Cone 3: delete');
  await page.keyboard.press('Home');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowRight');
  assert.equal(await focused(), '2 Cone 3: k');
  await page.keyboard.press('ArrowUp'); // a larger k
  assert.equal(await focused(), '2 Cone 3: k');
  assert.equal(await kOf(it, 2), '4');
  await page.keyboard.press('Tab');
  assert.equal(await page.evaluate(() => document.activeElement.closest('table')), null);
  await page.keyboard.press('Shift+Tab'); // back to where it was
  assert.equal(await focused(), '2 Cone 3: k');
});

test('the UV view has a bar as long as it says, in cells, which follows the zoom', async () => {
  const { page } = it;
  await example(it, 'cube');
  await run(it);
  const bar = async () => {
    await settled(page);
    const cells = Number(/^([\d.]+) cells?$/.exec((await page.innerText('.map-scale')).trim())[1]);
    return (await page.locator('.map-scale i').boundingBox()).width / cells;
  };
  await page.waitForSelector('.map-scale');
  const before = await bar();
  await page.locator('#map').focus();
  for (let i = 0; i < 6; i++) await page.keyboard.press('PageUp');
  const after = await bar();
  assert.ok(Math.abs((after / before) * 0.85 ** 6 - 1) < 0.05, `${before} to ${after} pixels`);
});
