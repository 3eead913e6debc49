// How fast, and how free the page is meanwhile. Times are those of the page itself, measured in it.

import assert from 'node:assert/strict';
import { readdirSync, statSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { bumpyDisk } from '../support/disk.mjs';
import { drop, root, state, useBrowser } from './support.mjs';

// Composed as on a machine with a graphics card, only in software: otherwise every picture is read
// back on the page's main thread, which no user's browser does.
const flags = ['--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'];
const it = useBrowser({ flags });
const built = path.join(root, 'build/page');

test('page and wasm together are under 3 MB; interactive within two seconds', async (t) => {
  const files = readdirSync(path.join(built, 'assets'));
  const eager = files.filter((name) => !name.startsWith('GLTFLoader'));
  const bytes = eager.reduce(
    (sum, name) => sum + statSync(path.join(built, 'assets', name)).size,
    0,
  );
  assert.ok(bytes <= 3e6, `${bytes} bytes`);
  const { page } = it;
  await page.reload();
  await state(page, 'empty');
  const ready = await page.evaluate(() => performance.getEntriesByName('hgp-ready')[0].startTime);
  t.diagnostic(`${(bytes / 1e6).toFixed(2)} MB, interactive after ${ready.toFixed(0)} ms`);
  assert.ok(ready <= 2000, `${ready} ms`);
});

test('20 thousand triangles: from drop to the textured result, and no long task while it solves', async (t) => {
  const { page } = it;
  await page.evaluate(() => {
    const seen = (globalThis.seen = { tasks: [], states: [[document.body.dataset.state, 0]] });
    new PerformanceObserver((list) => {
      for (const { startTime, duration } of list.getEntries())
        seen.tasks.push([startTime, duration]);
    }).observe({ type: 'longtask' });
    new MutationObserver(() =>
      seen.states.push([document.body.dataset.state, performance.now()]),
    ).observe(document.body, { attributes: true, attributeFilter: ['data-state'] });
  });
  await drop(it, { 'disk.obj': bumpyDisk(58) }); // 20 184 triangles
  await state(page, 'ready');
  await page.click('#run');
  await state(page, 'certified');
  const { tasks, states } = await page.evaluate(async () => {
    await new Promise((resolve) => setTimeout(resolve, 100)); // observers report late
    return globalThis.seen;
  });
  const at = (name) => states.find(([one]) => one === name)[1];
  // The task that shows the result is the first after the solve.
  const isSolving = ([begin, duration]) =>
    begin > at('running') && begin + duration < at('certified');
  const solving = tasks.filter(isSolving);
  const longest = Math.max(0, ...solving.map(([, duration]) => duration));
  // The person's own time between the drop and the click is not the page's.
  const elapsed = at('ready') - at('loading') + at('certified') - at('running');
  t.diagnostic(
    `read ${(at('ready') - at('loading')).toFixed(0)} ms, run ${(at('certified') - at('running')).toFixed(0)} ms, ` +
      `longest task while solving ${longest.toFixed(0)} ms; all: ${tasks.map(([b, d]) => `${b.toFixed(0)}+${d.toFixed(0)}`).join(' ')}`,
  );
  assert.ok(longest <= 50, `a task of ${longest} ms while solving`);
  assert.ok(elapsed <= 3000, `${elapsed} ms`);
});
