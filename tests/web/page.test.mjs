// The page as a person uses it, in real Chromium: a file is dropped, a textured mesh is seen.

import assert from 'node:assert/strict';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import test, { after, before, beforeEach, afterEach } from 'node:test';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';
import pngjs from 'pngjs';
import { serve } from '../../web/serve.mjs';
import { bumpyDisk } from '../support/disk.mjs';

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
const shots = path.join(root, 'build/screenshots');
mkdirSync(shots, { recursive: true });

let server, url, browser, page, problems;

before(async () => {
  ({ server, url } = await serve({ port: 0 }));
  const executablePath = ['/usr/bin/chromium', '/usr/bin/google-chrome'].find(existsSync);
  browser = await chromium.launch({
    executablePath,
    args: ['--no-sandbox', '--disable-background-networking', '--disable-dev-shm-usage'],
  });
});

after(async () => {
  await browser?.close();
  server?.close();
});

beforeEach(async () => {
  problems = [];
  page = await browser.newPage({ viewport: { width: 1024, height: 768 } });
  page.on('console', (message) => {
    if (message.type() === 'error') problems.push(message.text());
  });
  page.on('pageerror', (error) => problems.push(error.message));
  page.on('request', (request) => {
    const target = new URL(request.url());
    if (!['blob:', 'data:'].includes(target.protocol) && target.origin !== new URL(url).origin) {
      problems.push(`request to ${target.origin}`);
    }
  });
  await page.goto(url);
  await page.waitForSelector('body[data-state="empty"]');
});

afterEach(async () => {
  await page.close();
  // Violations of the Content-Security-Policy arrive as console errors.
  assert.deepEqual(problems, []);
});

/** Drops a file on the page as the browser does: with a real DataTransfer. */
async function drop(name, text) {
  const transfer = await page.evaluateHandle(
    ([fileName, content]) => {
      const data = new DataTransfer();
      data.items.add(new File([content], fileName));
      return data;
    },
    [name, text],
  );
  await page.dispatchEvent('main', 'drop', { dataTransfer: transfer });
}

/** Share of the pixels that are near a colour, in the picture of the 3D view. */
async function colours(name) {
  const file = path.join(shots, name);
  writeFileSync(file, await page.locator('#view').screenshot());
  const { data, width, height } = pngjs.PNG.sync.read(readFileSync(file));
  let dark = 0;
  let light = 0;
  for (let i = 0; i < data.length; i += 4) {
    const [r, g, b] = data.subarray(i, i + 3);
    if (b > r + 15 && b < 200) dark += 1; // the checker's blue, under any light
    if (r > b + 60 && g > b + 30) light += 1; // its amber
  }
  return { dark: dark / (width * height), light: light / (width * height) };
}

test('a dropped OBJ is solved in the worker and shown with a checker texture', async () => {
  await drop('disk.obj', bumpyDisk(40));
  await page.waitForSelector('body[data-state="result"]', { timeout: 30000 });
  await page.waitForFunction(() => Number(document.querySelector('#view').dataset.triangles) > 0);
  await page.waitForTimeout(500);
  const seen = await colours('disk.png');
  await page.screenshot({ path: path.join(shots, 'page.png') });
  assert.ok(
    seen.dark > 0.05 && seen.light > 0.05,
    `both colours of the texture: ${JSON.stringify(seen)}`,
  );
  assert.ok(Math.abs(Math.log(seen.dark / seen.light)) < Math.log(2), JSON.stringify(seen));
  assert.match(await page.locator('#result').innerText(), /certified/);
  assert.doesNotMatch(await page.locator('#result').innerText(), /not certified/);
});

test('a file that is no mesh is named as such and the page goes on', async () => {
  await drop('<img src=x onerror=alert(1)>.obj', 'this is not a mesh');
  await page.waitForSelector('body[data-state="error"]');
  assert.equal(await page.locator('img').count(), 0);
  await drop('disk.obj', bumpyDisk(12));
  await page.waitForSelector('body[data-state="result"]', { timeout: 30000 });
});

test('has no accessibility violations that axe can find', async () => {
  const axe = readFileSync(path.join(root, 'node_modules/axe-core/axe.min.js'), 'utf8');
  await page.evaluate(axe); // through the debugger, not the page: the policy stays in force
  const { violations } = await page.evaluate(() => globalThis.axe.run());
  assert.deepEqual(
    violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html).join(' ')}`),
    [],
  );
});
