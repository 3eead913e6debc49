// What would hold the main thread up, by what is asked of the graphics card: no program is compiled once a model
// is open, and nothing large goes there at once. Times depend on the card, these do not.

import assert from 'node:assert/strict';
import { bumpyDisk } from '../support/disk.mjs';
import { openFiles, run, settled, state, useBrowser } from './support.mjs';

const it = useBrowser({ acceptDownloads: true }); // a page of its own: its context is watched

/** Notes every program with the state of the page, and the largest array that is handed over. */
function watchContexts() {
  const { prototype } = WebGL2RenderingContext;
  const seen = (globalThis.seen = { programs: [], largest: 0, bytes: 0 });
  const { linkProgram, bufferData, bufferSubData } = prototype;
  prototype.linkProgram = function (program) {
    seen.programs.push(`${this.canvas.id || this.canvas.className} ${document.body.dataset.state}`);
    return linkProgram.call(this, program);
  };
  const take = (bytes) => {
    seen.largest = Math.max(seen.largest, bytes);
    seen.bytes += bytes;
  };
  prototype.bufferData = function (target, data, ...rest) {
    if (ArrayBuffer.isView(data)) take(data.byteLength);
    return bufferData.call(this, target, data, ...rest);
  };
  prototype.bufferSubData = function (target, at, data, ...rest) {
    take(rest[1] ?? data.byteLength);
    return bufferSubData.call(this, target, at, data, ...rest);
  };
}

it.test('programs are ready before they are needed; arrays go to the card in slices', async (t) => {
  const { page } = it;
  await page.addInitScript(watchContexts);
  await page.reload();
  await state(page, 'empty');
  const isWarm = () => globalThis.seen.programs.filter((one) => one.startsWith('map')).length >= 4;
  await page.waitForFunction(isWarm);
  await openFiles(it, { 'disk.obj': bumpyDisk(150) }); // 135 thousand triangles: 4.9 MB of places
  await page.locator('#align').uncheck();
  await run(it);
  await settled(page);
  const { programs, largest, bytes } = await page.evaluate(() => globalThis.seen);
  t.diagnostic(`${(bytes / 1e6).toFixed(1)} MB, ${(largest / 1e6).toFixed(1)} MB at once at most`);
  assert.deepEqual(programs.filter((one) => !/ (starting|empty)$/.test(one)), []); // prettier-ignore
  assert.ok(largest <= 4 * 2 ** 20, `${largest} bytes at once`);
  assert.ok(bytes >= 135_000 * 3 * (12 + 12 + 8), `${bytes} bytes: both views are drawn`);
});
