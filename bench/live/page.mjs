// node bench/live/page.mjs MESH… [--drags N] [--steps N] [--wait MS]: cones dragged in a real browser, as a table
// (bench/LIVE.md). Needs the built page (npm run build:page). Chromium draws by software, with the solver's worker on
// the same processors, so that frames are slower here than where a graphics card draws.

import { readFileSync } from 'node:fs';
import path from 'node:path';
import { parseArgs } from 'node:util';
import { gunzipSync } from 'node:zlib';
import { startChromium } from '../../web/chromium.mjs';
import { serve } from '../../web/serve.mjs';
import { randomFrom } from '../../tests/mutation/draw.mjs';

const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: {
    drags: { type: 'string', default: '6' },
    steps: { type: 'string', default: '12' },
    wait: { type: 'string', default: '40' }, // between two movements of the mouse
    seed: { type: 'string', default: '1' },
  },
});
const [drags, steps, wait, seed] = ['drags', 'steps', 'wait', 'seed'].map((key) =>
  Number(values[key]),
);

/** Notes what the page asks of its workers and what they answer, with times. */
function watchWorkers() {
  const calls = new Map();
  globalThis.answered = [];
  globalThis.Worker = class extends Worker {
    constructor(...args) {
      super(...args);
      this.addEventListener('message', ({ data }) => {
        const call = calls.get(data.id);
        if (!call || data.progress) return;
        calls.delete(data.id);
        const live = data.result?.frame?.state ?? data.result?.state;
        const ms = performance.now() - call.begin;
        globalThis.answered.push({ method: call.method, ms, state: live, isError: !!data.error });
      });
    }
    postMessage(message, ...rest) {
      const { id, method, args } = message ?? {};
      if (/^(dragTo|endDrag|beginDrag|parametrize)$/.test(method)) {
        // The same place again: the map comes nearer to a cone that is out of its reach.
        const isNearer = method === 'dragTo' && args[0] === this.vertex;
        this.vertex = method === 'dragTo' ? args[0] : undefined;
        calls.set(id, { method: isNearer ? 'nearer' : method, begin: performance.now() });
      }
      super.postMessage(message, ...rest);
    }
  };
}

const state = (page, ...names) =>
  page.waitForSelector(names.map((name) => `body[data-state="${name}"]`).join(','), {
    timeout: 30e3,
  });

/** Waits until nothing has been left to draw for some frames. */
const settled = (page) =>
  page.evaluate(async () => {
    for (let still = 0; still < 10;) {
      await new Promise((resolve) => requestAnimationFrame(resolve));
      still = document.querySelector('[data-pending]') ? 0 : still + 1;
    }
  });

const quantile = (list, part) =>
  list.length === 0 ? 0 : list.toSorted((a, b) => a - b)[Math.floor(part * (list.length - 1))];
const ms = (x) => x.toFixed(0);

/** Drags one cone from the middle of the view along a line, and drops it. */
async function dragOnce(page, random) {
  const closed = page.locator('[data-group] [aria-expanded="false"]');
  while ((await closed.count()) > 0) await closed.first().click();
  const cones = page.locator('tr[data-cone]');
  const one = Math.floor(random() * (await cones.count()));
  await cones.nth(one).locator('[aria-label$="frame"]').click();
  await settled(page); // the camera moves there
  const box = await page.locator('#view').boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const angle = 2 * Math.PI * random();
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let i = 1; i <= steps; i++) {
    await page.mouse.move(x + 4 * i * Math.cos(angle), y + 4 * i * Math.sin(angle));
    await page.waitForTimeout(wait);
  }
  await page.mouse.up();
  await state(page, 'certified', 'stale', 'unbalanced');
  if ((await page.getAttribute('body', 'data-state')) !== 'certified') {
    await page.keyboard.press('Control+z'); // where no map could follow the cone, it goes back
    await state(page, 'certified');
  }
}

async function rowOf(browser, url, file) {
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
  await page.addInitScript(watchWorkers);
  await page.goto(url);
  await state(page, 'empty');
  const name = path.basename(file).replace(/\.gz$/, '');
  const bytes = readFileSync(file);
  const buffer = file.endsWith('.gz') ? gunzipSync(bytes) : bytes;
  const given = { name, mimeType: 'application/octet-stream', buffer };
  await page.setInputFiles('input[type="file"]', [given]);
  await state(page, 'ready');
  if (await page.isChecked('#automatic')) await page.click('#automatic');
  await page.click('#run');
  await state(page, 'certified');
  const triangles = await page.evaluate(() => document.querySelector('#panel-model').innerText);
  await page.evaluate(() => (globalThis.answered.length = 0));
  const random = randomFrom(seed);
  for (let i = 0; i < drags; i++) await dragOnce(page, random);
  const answers = await page.evaluate(() => globalThis.answered);
  await page.close();
  const of = (method) => answers.filter((one) => one.method === method && !one.isError);
  const frames = of('dragTo');
  const count = (live) => frames.filter((frame) => frame.state === live).length;
  const times = frames.map((frame) => frame.ms);
  const [, shown] = triangles.match(/Triangles\s+([\d\s]+)\n/) ?? [];
  return [
    name,
    shown?.trim(),
    frames.length,
    ...[count('certified'), count('fails'), count('heat')],
    `${ms(quantile(times, 0.5))} (${ms(quantile(times, 0.95))})`,
    ms(quantile(of('beginDrag').map((one) => one.ms), 0.5)), // prettier-ignore
    `${of('nearer').length} (${ms(
      quantile(
        of('nearer').map((one) => one.ms),
        0.5,
      ),
    )})`,
    `${of('endDrag').length} of ${of('beginDrag').length}`,
    ms(quantile(of('endDrag').map((one) => one.ms), 0.5)), // prettier-ignore
  ];
}

const { url, server } = await serve({ port: 0 });
const browser = await startChromium('--use-angle=swiftshader', '--enable-unsafe-swiftshader');
const heads = ['mesh', 'triangles', 'frames', 'certified', 'fail', 'heat', 'frame, ms (p95)', 'prepare, ms', 'nearer (ms)', 'dropped and stored', 'store, ms']; // prettier-ignore
console.log(`| ${heads.join(' | ')} |\n|---|${'--:|'.repeat(heads.length - 1)}`);
for (const file of positionals) console.log(`| ${(await rowOf(browser, url, file)).join(' | ')} |`);
await browser.close();
server.close();
