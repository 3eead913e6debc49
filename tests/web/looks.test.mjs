// Accessibility in every state and both themes, with a picture of each.

import assert from 'node:assert/strict';
import path from 'node:path';
import { cubeMesh, toGlb, toGltf, toObj } from '../support/meshes.mjs';
import { uncertifiable } from './shapes.mjs';
import {
  drop,
  killSolver,
  openDetails,
  openFiles,
  run,
  settled,
  shots,
  solverOf,
  state,
  useBrowser,
  violations,
} from './support.mjs';

const it = useBrowser({ viewport: { width: 1440, height: 900 } });
const { test } = it;

/** All of the page, or only the parts that are not as they were when all of it was looked at. */
async function check(name, ...parts) {
  await settled(it.page);
  await it.page.screenshot({ path: path.join(shots, `${name}.png`) });
  assert.deepEqual(await violations(it.page, ...parts), [], name);
}

test('axe reports no accessibility violations in any state', async () => {
  const { page } = it;
  await check('state-empty');
  await page.click('#examples');
  await check('state-menu', 'header');
  await page.click('[data-example="cube"]');
  await state(page, 'ready');
  await check('state-ready');
  await page.click('tr[data-cone="2"] [aria-label$="larger k"]');
  await state(page, 'unbalanced');
  await check('state-unbalanced', 'header', '#panel-cones', 'footer');
  await page.click('#undo');
  await run(it);
  await page.selectOption('#overlay', 'angle');
  await check('state-certified');
  await page.click('#download');
  await openDetails(page, '#more-formats');
  await check('state-download', 'dialog');
  await page.keyboard.press('Escape');
  for (const [name, button] of [
    ['help', undefined],
    ['palette', '#help-palette'],
    ['log', '#help-log'],
  ]) {
    await page.click('#help');
    if (button) await page.click(button);
    await check(`state-${name}`, 'dialog');
    assert.equal(await page.evaluate(() => document.querySelector('dialog').scrollTop), 0);
    await page.keyboard.press('Escape');
  }
  await page.click('#preview-quads');
  await page.waitForSelector('#quads-note');
  await check('state-quads', '#pane-surface', '#panel-result');
  await page.click('#hide-quads');
  await page.click('#tool-edges');
  await check('state-edges', '#pane-surface', 'footer');
  await page.click('#tool-orbit');
  await page.click('tr[data-cone="2"] [aria-label$="delete"]');
  await state(page, 'stale');
  await check('state-stale', 'header', '#pane-surface', '#panel-result', '#panel-cones', 'footer');
});

test('axe reports no violations for missing, several or unusable files, and in dark mode', async () => {
  const { page } = it;
  await page.emulateMedia({ colorScheme: 'dark', reducedMotion: 'reduce' });
  const { json } = toGltf([cubeMesh(2)], { image: 'wood.png' });
  await drop(it, { 'cube.gltf': JSON.stringify(json) });
  await state(page, 'needs-files');
  await check('dark-needs-files', 'dialog');
  await drop(it, { 'two.glb': toGlb([cubeMesh(2), cubeMesh(3)]) });
  await state(page, 'ready');
  await check('dark-mesh-strip', 'header', 'nav');
  await openFiles(it, { 'open.obj': `${toObj(cubeMesh(2))}f 1 9 10\n` }, 'invalid');
  await check('dark-invalid', 'header', 'aside', 'footer');
  await openFiles(it, { 'cube.obj': toObj(cubeMesh(6)) });
  await run(it);
  await check('dark-certified');
});

/** Holds the solver up, so that what lies between can be looked at. It waits and computes nothing. */
function hold(milliseconds) {
  const sleep = (time) => {
    const memory = new WebAssembly.Memory({ initial: 1, maximum: 1, shared: true });
    Atomics.wait(new Int32Array(memory.buffer), 0, 0, time);
  };
  void solverOf(it.page)
    .evaluate(sleep, milliseconds)
    .catch(() => {}); // Cancel ends it
}

test('axe reports no violations while loading, while running, without the worker, without a certificate', async () => {
  const { page } = it;
  await page.goto(it.url);
  await state(page, 'empty');
  hold(20_000);
  await drop(it, { 'cube.obj': toObj(cubeMesh(2)) });
  await state(page, 'loading');
  await check('state-loading', 'header', 'footer');
  await page.click('#cancel');
  await state(page, 'empty');
  await openFiles(it, { 'cube.obj': toObj(cubeMesh(2)) });
  hold(20_000);
  await run(it, 'running');
  // What is edited now is refused, with a way out.
  await page.locator('#q').selectOption('6');
  assert.equal(await page.locator('#q').inputValue(), '4');
  await page.waitForSelector('footer button:has-text("Cancel and edit")');
  assert.match(await page.locator('footer').innerText(), /cones are locked while the solver runs/);
  await check('state-running', 'header', 'footer');
  // One key pressed by mistake does not end what may have taken minutes.
  await page.keyboard.press('Escape');
  await page.waitForSelector('footer button:has-text("Cancel the run")');
  await state(page, 'running');
  await page.keyboard.press('Escape');
  await state(page, 'ready');
  await drop(it, {
    'hard.cones.json': JSON.stringify({ format: 'hgp-cones', version: 1, ...uncertifiable }),
  });
  await page.waitForSelector('#cones');
  await run(it, 'not-certified');
  await check('state-not-certified', 'header', '#panel-result', 'footer');
  await killSolver(it);
  await page.click('#run');
  await page.waitForSelector('#status.error');
  assert.match(await page.locator('#status').innerText(), /stopped unexpectedly/);
  await check('state-worker-lost', 'header', 'footer');
});

test('the guide is a page of its own', async () => {
  const { page } = it;
  await page.goto(`${it.url}guide.html`);
  assert.match(await page.locator('h1').innerText(), /Guide/);
  assert.deepEqual(await violations(page), []);
});
