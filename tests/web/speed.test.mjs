// How fast, and how free the page is meanwhile. Times are those of the page itself, measured in it.

import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { brotliCompressSync, constants } from 'node:zlib';
import { createCore } from '../../build/package/node/core.js';
import { bumpyDisk } from '../support/disk.mjs';
import { openFiles, root, run, settled, state, statusText, useBrowser } from './support.mjs';

// Composed as on a machine with a graphics card, only in software: otherwise every picture is read
// back on the page's main thread, which no user's browser does.
const flags = ['--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'];
const it = useBrowser({ flags, deviceScaleFactor: 1, antialias: true });
const { test } = it;
const built = path.join(root, 'build/page');

// Bounds are those of a quiet machine, times how busy this one is, which the solver alone tells in the same minute: by
// how much its time exceeds its processor time. A shared machine stalls at any moment; only under --full the bounds are
// those of the promise, otherwise there is twice the room.
const isFull = process.env.HGP_FULL === '1';
const room = isFull ? 1 : 2;

/** How many times longer everything takes than on a quiet machine. */
async function busyness() {
  const core = await createCore();
  const [begin, used] = [performance.now(), process.cpuUsage()];
  const bytes = new TextEncoder().encode(bumpyDisk(58));
  const model = core.load({ main: 'disk.obj', files: new Map([['disk.obj', bytes]]) });
  model.parametrize({ q: 4 }).write();
  const elapsed = performance.now() - begin;
  const { user, system } = process.cpuUsage(used);
  return Math.max(1, elapsed / ((user + system) / 1000));
}

test('page and wasm together are under 1.5 MB as they are sent; interactive within two seconds', async (t) => {
  const files = readdirSync(path.join(built, 'assets'));
  // Loaded when a file needs them, or when asked to validate.
  const onRequest = /^(GLTFLoader|validator_worker|draco_decoder|meshopt_decoder|fflate)\b/;
  const eager = files.filter((name) => !onRequest.test(name));
  const params = { [constants.BROTLI_PARAM_QUALITY]: 9 }; // as the server does
  const sent = (name) =>
    brotliCompressSync(readFileSync(path.join(built, 'assets', name)), { params }).length;
  const bytes = eager.reduce((sum, name) => sum + sent(name), 0);
  assert.ok(bytes <= 1.5e6, `${bytes} bytes`);
  const { page } = it;
  const before = await busyness();
  await page.reload();
  await state(page, 'empty');
  const ready = await page.evaluate(() => performance.getEntriesByName('hgp-ready')[0].startTime);
  t.diagnostic(`${(bytes / 1e6).toFixed(2)} MB, interactive after ${ready.toFixed(0)} ms`);
  const busy = Math.max(before, await busyness());
  assert.ok(ready <= 2000 * busy * room, `${ready} ms, ${busy.toFixed(1)} times as busy`);
});

/** One pass from an empty page: how long, and the longest task of the page until the picture is there. */
async function pass() {
  const { page } = it;
  await page.goto(it.url);
  await page.reload();
  await state(page, 'empty');
  await page.evaluate(() => {
    const { body } = document;
    const states = [[body.dataset.state, 0]];
    const seen = (globalThis.seen = { states, drawn: 0, tasks: [] });
    seen.take = (entries) =>
      seen.tasks.push(...entries.map(({ startTime, duration }) => [startTime, duration]));
    seen.observer = new PerformanceObserver((list) => seen.take(list.getEntries()));
    seen.observer.observe({ type: 'longtask' });
    new MutationObserver(() => {
      const now = performance.now();
      if (seen.states.at(-1)[0] !== body.dataset.state) seen.states.push([body.dataset.state, now]);
      if (!document.querySelector('[data-pending]')) seen.drawn = now;
    }).observe(body, { subtree: true, attributeFilter: ['data-state', 'data-pending'] });
  });
  await openFiles(it, { 'disk.obj': bumpyDisk(58) }); // 20 184 triangles
  await run(it);
  await settled(page);
  const { tasks, states, drawn } = await page.evaluate(() => {
    const { observer, take, ...rest } = globalThis.seen;
    take(observer.takeRecords());
    return rest;
  });
  const at = (name) => states.find(([one]) => one === name)[1];
  const isSolving = ([begin]) => begin > at('running') && begin < drawn;
  const solving = tasks.filter(isSolving);
  const long = solving.map(([begin, duration]) => {
    const since = begin - at('running');
    const phase = begin > at('certified') ? 'showing' : 'solving';
    return `${duration.toFixed(0)} ms at ${since.toFixed(0)} ms, ${phase}`;
  });
  // The person's own time between the drop and the click is not the page's.
  const read = at('ready') - at('loading');
  const solve = drawn - at('running');
  const longest = Math.max(0, ...solving.map(([, duration]) => duration));
  return { read, solve, elapsed: read + solve, longest, long };
}

test('20 thousand triangles: from drop to the textured result, and no long task while it solves', async (t) => {
  let busy = await busyness();
  let best = { elapsed: Infinity, longest: Infinity };
  const isFine = () => best.elapsed <= 3000 * busy * room && best.longest <= 50 * busy * room;
  for (let i = 0; i < 3 && !isFine(); i++) {
    const one = await pass();
    const [read, solve] = [one.read, one.solve].map((x) => x.toFixed(0));
    t.diagnostic(`read ${read} ms, run ${solve} ms, long tasks: ${one.long.join('; ') || 'none'}`);
    best = {
      elapsed: Math.min(best.elapsed, one.elapsed),
      longest: Math.min(best.longest, one.longest),
    };
    busy = Math.max(busy, await busyness());
  }
  t.diagnostic(`${busy.toFixed(1)} times as busy as a quiet machine`);
  assert.ok(best.longest <= 50 * busy * room, `a task of ${best.longest} ms while solving`);
  assert.ok(best.elapsed <= 3000 * busy * room, `${best.elapsed} ms`);
});

test('Cancel in the middle of a solve frees the page within 300 ms', async () => {
  await openFiles(it, { 'disk.obj': bumpyDisk(129) }); // 100 thousand triangles
  await run(it, 'running');
  await it.page.waitForFunction(() => document.querySelector('#progress')?.value > 0);
  const elapsed = await it.page.evaluate(async () => {
    const begin = performance.now();
    document.querySelector('#cancel').click();
    while (document.body.dataset.state === 'running') await new Promise((r) => setTimeout(r, 5));
    return performance.now() - begin;
  });
  assert.ok(elapsed <= 300, `${elapsed} ms`);
  assert.match(await statusText(it.page), /Cancelled/);
});
