// A person in a hurry: drops, runs, edits and closes while other things are under way.

import assert from 'node:assert/strict';
import { gzipSync, zipSync } from 'fflate';
import { bumpyDisk } from '../support/disk.mjs';
import { cubeMesh, toObj } from '../support/meshes.mjs';
import {
  certificate,
  coneCount,
  drop,
  example,
  failure,
  openDetails,
  openFiles,
  run,
  saveAs,
  state,
  statusText,
  useBrowser,
} from './support.mjs';

const it = useBrowser();
const { test } = it;
const opened = (name) => it.page.waitForSelector(`.file[title="${name}"]`);

test('of two files dropped one after the other the second is opened', async () => {
  await drop(it, { 'large.obj': bumpyDisk(60) });
  await drop(it, { 'small.obj': toObj(cubeMesh(3)) });
  await opened('small.obj');
  await state(it.page, 'ready');
  await run(it);
  assert.match(await certificate(it), /of 108/);
});

test('an open page continues to work when its files are gone from the server', async () => {
  const { page, context } = it;
  const started = page.waitForResponse(/geometry_worker/); // before there is a model
  await page.reload();
  await state(page, 'empty');
  await started;
  const gone = '**/assets/*worker*';
  await context.route(gone, (route) => route.fulfill({ status: 404, body: 'not here' }));
  await openFiles(it, { 'cube.obj': toObj(cubeMesh(3)) });
  await run(it);
  assert.match(await certificate(it), /of 108/);
  await context.unroute(gone);
});

test('gzip: one wrong byte, in one member or in the second of two, is reported', async () => {
  const text = new TextEncoder().encode(toObj(cubeMesh(3)));
  const [a, b] = [text.slice(0, 900), text.slice(900)].map((part) => Buffer.from(gzipSync(part)));
  const one = Buffer.from(gzipSync(text));
  for (const packed of [one, Buffer.concat([a, b])]) {
    for (const back of [1, 5, 40]) {
      const wrong = Buffer.from(packed);
      wrong[wrong.length - back] ^= 1;
      await drop(it, { 'wrong.obj.gz': wrong });
      await it.page.waitForSelector('#status.error');
      assert.match(await statusText(it.page), /damaged or cut off/);
      await it.page.keyboard.press('Escape');
    }
    await openFiles(it, { 'right.obj.gz': packed });
    await opened('right.obj');
  }
});

test('during a run nothing is edited and nothing is run twice; another file ends it', async () => {
  const { page } = it;
  await openFiles(it, { 'disk.obj': bumpyDisk(150) });
  // Twice, before the page can answer the first.
  await page.evaluate(() => [1, 2].forEach(() => document.querySelector('#run').click()));
  await state(page, 'running');
  for (const key of ['z', 'Shift+z', 'z', 'y', 'Enter'])
    await page.keyboard.press(`Control+${key}`);
  await page.click('#suggest');
  await page.locator('#weld').fill('0.01');
  await page.locator('#weld').press('Enter');
  await page.waitForSelector('footer button:has-text("Cancel and edit")');
  assert.equal(await page.locator('#weld').inputValue(), '');
  await state(page, 'running');
  // Escape closes the dialog and nothing else.
  await page.click('#help');
  await page.keyboard.press('Escape');
  await page.waitForSelector('#help-dialog', { state: 'detached' });
  await state(page, 'running');
  await openFiles(it, { 'cube.obj': toObj(cubeMesh(3)) });
  await opened('cube.obj');
  assert.equal(await coneCount(it), 0);
  await run(it);
});

test('a half-typed number stays while the page redraws', async () => {
  const { page } = it;
  await openFiles(it, { 'disk.obj': bumpyDisk(129) });
  await page.click('#solve-more > summary');
  await page.click('#run');
  await state(page, 'running');
  const rounds = page.locator('#rounds');
  await rounds.fill('7'); // typed, not left
  await page.waitForFunction(() =>
    /Solving/.test(document.querySelector('footer .steps .now')?.textContent ?? ''),
  );
  await state(page, 'certified');
  assert.equal(await rounds.inputValue(), '7');
  await rounds.press('Tab');
  await page.locator('#quality').check();
  assert.equal(await rounds.inputValue(), '7');
});

test('after Close during a run or a read, one click restores everything', async () => {
  const { page } = it;
  await openFiles(it, { 'disk.obj': bumpyDisk(129) });
  await run(it, 'running');
  await page.click('#close');
  await state(page, 'empty');
  await page.click('footer button:has-text("Open it again")');
  await state(page, 'ready');
  await page.locator('#weld').fill('0.0001');
  await page.locator('#weld').press('Enter');
  await page.click('#close');
  await state(page, 'empty');
  assert.match(await statusText(page), /Closed disk\.obj/);
});

test('Download options changed faster than they are written: the last choices are saved', async () => {
  const { page } = it;
  await example(it, 'cube');
  await run(it);
  await page.click('#download');
  await openDetails(page, '#more-formats');
  await page.selectOption('#uv-scale', 'unit');
  await page.selectOption('#uv-scale', 'fit');
  await page.uncheck('#embed-cones');
  await page.selectOption('#uv-scale', 'unit');
  await page.waitForSelector('#downloads ul:not([aria-busy="true"])', { state: 'attached' });
  assert.equal(await page.locator('#uv-scale').inputValue(), 'unit');
  assert.equal(await page.locator('#embed-cones').isChecked(), false);
  await page.keyboard.press('Escape');
  await state(page, 'certified');
  const { bytes } = await saveAs(it, 'same');
  assert.doesNotMatch(bytes.toString('latin1'), /"hgp":\{/);
  const report = JSON.parse(String((await saveAs(it, 'report')).bytes));
  assert.equal(report.options.scale, 'unit');
});

test('ZIP files that are invalid, empty, truncated, or full of archives', async () => {
  const text = new TextEncoder().encode(toObj(cubeMesh(2)));
  const zip = Buffer.from(zipSync({ 'a.obj': text }));
  const unknown = Buffer.from(zip);
  unknown[8] = 12; // a compression that nobody here knows
  for (const [name, content, answer] of [
    ['none.zip', 'no archive at all', /“none\.zip” holds no mesh/],
    ['empty.zip', zipSync({}), /“empty\.zip” holds no mesh/],
    ['cut.zip', zip.subarray(0, zip.length / 2), /ZIP (cannot be read|ends in the middle)/],
    ['unknown.zip', unknown, /a\.obj cannot be unpacked/],
    ['inner.zip', zipSync({ 'b.zip': zip }), /“inner\.zip” holds no mesh/],
    ['back.zip', zipSync({ '..\\a.obj': text }), /outside its folder/],
    ['bomb.zip', zipSync({ 'a.obj': new Uint8Array(3e7) }), /far more than it should/],
  ]) {
    await drop(it, { [name]: content });
    await it.page.waitForFunction((pattern) => new RegExp(pattern).test(document.querySelector('#status.error')?.textContent), answer.source); // prettier-ignore
  }
  assert.match(await failure(it), /far more/);
  await openFiles(it, { 'names.zip': zipSync({ '__proto__/constructor.obj': text }) });
  await opened('constructor.obj');
});

test('gzip: unpacked as ZIP is, several members too; damaged ones are refused', async () => {
  const text = new TextEncoder().encode(toObj(cubeMesh(2)));
  const [head, tail] = [text.subarray(0, 300), text.subarray(300)].map((part) => gzipSync(part));
  await openFiles(it, { 'cube.obj.gz': Buffer.concat([head, tail]) });
  await opened('cube.obj');
  await run(it);
  assert.match(await certificate(it), /of 48/);
  const { name } = await saveAs(it, 'same');
  assert.equal(name, 'cube.obj');
  await drop(it, { 'cut.obj.gz': gzipSync(text).subarray(0, 200) });
  assert.match(await failure(it), /damaged or cut off/);
});

test('in another tab the end of a long run is announced in the title and by a notification', async () => {
  const { page } = it;
  await example(it, 'cube');
  const title = await page.title();
  await page.evaluate(() => {
    const now = performance.now.bind(performance);
    globalThis.later = 0;
    performance.now = () => now() + globalThis.later;
    globalThis.told = [];
    globalThis.Notification = class {
      static permission = 'granted';
      constructor(name, { body }) {
        globalThis.told.push(`${name}: ${body}`);
      }
    };
    Object.defineProperty(document, 'hidden', { value: true, configurable: true });
    document.querySelector('#run').click();
    globalThis.later = 11_000; // a long run
  });
  await state(page, 'certified');
  assert.equal(await page.title(), '● Certified · hgp');
  assert.deepEqual(await page.evaluate(() => globalThis.told), ['hgp: Certified']);
  await page.evaluate(() => dispatchEvent(new Event('focus')));
  assert.equal(await page.title(), title);
  // A short one is not worth a call.
  await page.evaluate(() => document.querySelector('#run').click());
  await state(page, 'certified');
  await page.waitForFunction(() => document.title.startsWith('●'));
  assert.equal(await page.evaluate(() => globalThis.told.length), 1);
  await page.reload();
});
