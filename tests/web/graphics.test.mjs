// What would hold the main thread up, by what is asked of the graphics card and sent to workers: no program is
// compiled once a model is open, nothing large goes to the card at once, and nothing large is copied for a
// worker. Times depend on the card and on what else runs, these do not.

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

/** Notes the largest array that a message to a worker copies: what is not lent, wherever in it. */
function watchWorkers() {
  const { prototype } = Worker;
  const { postMessage } = prototype;
  const seen = (globalThis.sent = { messages: 0, lent: 0, copied: 0 });
  const arraysIn = (value, found = new Set()) => {
    if (ArrayBuffer.isView(value)) found.add(value.buffer);
    else if (value instanceof Map || Array.isArray(value))
      value.forEach((one) => arraysIn(one, found)); // prettier-ignore
    else if (value && Object.getPrototypeOf(value) === Object.prototype)
      Object.values(value).forEach((one) => arraysIn(one, found));
    return found;
  };
  prototype.postMessage = function (message, lent = []) {
    seen.messages += 1;
    for (const buffer of arraysIn(message)) {
      const kind = lent.includes(buffer) ? 'lent' : 'copied';
      seen[kind] = Math.max(seen[kind], buffer.byteLength);
    }
    return postMessage.call(this, message, lent);
  };
}

it.test('programs are ready before they are needed; arrays go to the card in slices', async (t) => {
  const { page } = it;
  await page.addInitScript(watchContexts);
  await page.addInitScript(watchWorkers);
  await page.reload();
  await state(page, 'empty');
  const isWarm = () => globalThis.seen.programs.filter((one) => one.startsWith('map')).length >= 4;
  await page.waitForFunction(isWarm);
  const text = bumpyDisk(150); // 135 thousand triangles: 4.9 MB of places
  assert.ok(text.length > 5e6);
  await openFiles(it, { 'disk.obj': text });
  await page.locator('#align').uncheck();
  await run(it);
  await settled(page);
  const { programs, largest, bytes } = await page.evaluate(() => globalThis.seen);
  t.diagnostic(`${(bytes / 1e6).toFixed(1)} MB, ${(largest / 1e6).toFixed(1)} MB at once at most`);
  const { messages, lent, copied } = await page.evaluate(() => globalThis.sent);
  t.diagnostic(`${messages} messages, ${(copied / 1e6).toFixed(1)} MB copied at once at most`);
  assert.ok(copied <= 4 * 2 ** 20, `${copied} bytes are copied for a worker`);
  assert.ok(lent >= 135_000 * 12, `${lent} bytes at most are lent`);
  assert.deepEqual(programs.filter((one) => !/ (starting|empty)$/.test(one)), []); // prettier-ignore
  assert.ok(largest <= 4 * 2 ** 20, `${largest} bytes at once`);
  // Of each corner: position, normal, and texture coordinates for both views, where they are positions, too.
  const expected = 135_000 * 3 * (12 + 4 + 8 + 8);
  assert.ok(bytes >= expected, `${bytes} bytes: both views are drawn`);
  assert.ok(bytes <= 1.2 * expected, `${bytes} bytes: nothing is uploaded twice`);
});

/** Notes frames, new sizes of canvases and what is drawn on them, in their order. */
function watchFrames() {
  const seen = (globalThis.frames = []);
  const request = requestAnimationFrame;
  let last = -1;
  globalThis.requestAnimationFrame = (act) =>
    request((time) => {
      if (time !== last) seen.push('frame');
      last = time;
      act(time);
    });
  const { prototype } = HTMLCanvasElement;
  const width = Object.getOwnPropertyDescriptor(prototype, 'width');
  Object.defineProperty(prototype, 'width', {
    ...width,
    set(value) {
      if (this.id) seen.push(`size ${this.id}`);
      width.set.call(this, value);
    },
  });
  const context = WebGL2RenderingContext.prototype;
  for (const name of ['drawArrays', 'drawElements', 'drawArraysInstanced']) {
    const draw = context[name];
    context[name] = function (...all) {
      if (this.canvas.id) seen.push(`draw ${this.canvas.id}`);
      return draw.apply(this, all);
    };
  }
}

/** What was noted since the last time, by frame. */
async function framesSince(page) {
  const all = await page.evaluate(() => globalThis.frames.splice(0));
  return `start ${all.join(' ')}`.split('frame').map((frame) => frame.trim());
}

it.test(
  'each canvas takes a new size in a frame of its own; a picture never goes away for a frame',
  async () => {
    const { page } = it;
    await page.addInitScript(watchFrames);
    await page.reload();
    await state(page, 'empty');
    await page.waitForTimeout(500); // programs are compiled on canvases of 16 × 16
    await framesSince(page);
    await openFiles(it, { 'disk.obj': bumpyDisk(20) });
    await run(it);
    await settled(page);
    const isSize = (frame) => frame.includes('size ');
    const opening = (await framesSince(page)).filter(isSize);
    // First buffers have nothing to draw; then the model makes room for the map.
    assert.deepEqual(opening.slice(0, 1), ['size view']);
    assert.ok(opening.includes('size map'), `${opening}`);
    for (const frame of opening.slice(1)) assert.match(frame, /^size (map|view( draw view)+)$/);
    for (const [width, height] of [
      [1100, 600],
      [1100, 700],
    ]) {
      await page.setViewportSize({ width, height });
      await page.waitForTimeout(200);
      await settled(page);
      const resized = (await framesSince(page)).filter(isSize);
      assert.ok(resized.length >= 2, `${resized}`);
      for (const frame of resized) assert.match(frame, /^size (view|map)( draw \1)+$/);
    }
  },
);

it.test('on a screen with smaller pixels the views are drawn with them', async () => {
  const { page } = it;
  await openFiles(it, { 'disk.obj': bumpyDisk(6) });
  await run(it);
  const session = await page.context().newCDPSession(page);
  const { width, height } = page.viewportSize();
  for (const deviceScaleFactor of [2, 1]) {
    // Another size, because this emulation sends no event for other pixels alone.
    const size = { width: width - 20 * deviceScaleFactor, height };
    const metrics = { ...size, deviceScaleFactor, mobile: false };
    await session.send('Emulation.setDeviceMetricsOverride', metrics);
    for (const id of ['view', 'map']) {
      await page.waitForFunction(
        ([name, factor]) => {
          const canvas = document.getElementById(name);
          return canvas.width === factor * canvas.clientWidth;
        },
        [id, deviceScaleFactor],
      );
    }
  }
  await session.detach();
});
