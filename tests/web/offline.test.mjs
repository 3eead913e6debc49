// After the first visit the page works without a network; and what it is served with.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { unzipSync } from 'fflate';
import { cubeMesh, toGltf } from '../support/meshes.mjs';
import { headers, isolation } from '../../web/serve.mjs';
import {
  coarseGrid,
  example,
  openFiles,
  pixels,
  pngOf,
  root,
  run,
  saveAs,
  settled,
  share,
  state,
  useBrowser,
} from './support.mjs';

const it = useBrowser({ serviceWorkers: 'allow' });
const { test } = it;
const bare = useBrowser({ serviceWorkers: 'allow', isIsolating: false });

/** What a person does: a textured model dropped, a run, its pattern and its own picture seen, the file saved. */
async function wholeVisit({ page }) {
  const { json, bin } = toGltf([cubeMesh(4)], { image: 'leaf.png' });
  const files = {
    'cube.gltf': JSON.stringify(json),
    'cube.bin': bin,
    'leaf.png': pngOf([[20, 190, 40]]),
  };
  await openFiles(bare, files);
  await coarseGrid(page);
  await run(bare);
  await settled(page);
  const inked = share(await pixels(page, '#view'), (r, g, b) => b > r + 15 && b < 140);
  assert.ok(inked > 0.005, `${inked}`);
  await page.selectOption('#pattern', 'material');
  await page.waitForFunction(() => document.querySelector('#view').dataset.original === 'shown');
  await settled(page);
  const green = share(await pixels(page, '#view'), (r, g, b) => g > r + 30 && g > b + 30);
  assert.ok(green > 0.05, `${green}`);
  const { bytes } = await saveAs(bare, 'same');
  await page.click('#download');
  await page.click('#more-formats > summary');
  await page.click('#validate');
  await page.waitForFunction(() => document.querySelector('#validation').textContent.trim());
  const said = await page.locator('#validation').innerText();
  await page.keyboard.press('Escape');
  return { bytes, said };
}

bare.test(
  'a host without headers: from the second visit on the page is isolated, and nothing else changes',
  async () => {
    const { page, context } = bare;
    const isIsolated = (one) => one.evaluate(() => crossOriginIsolated);
    await page.evaluate(() => navigator.serviceWorker.ready.then(() => undefined));
    assert.equal(await isIsolated(page), false);
    const first = await wholeVisit(bare);
    assert.match(first.said, /no errors|valid/i);

    page.on('dialog', (dialog) => void dialog.accept());
    await page.reload();
    await state(page, 'empty');
    assert.equal(await isIsolated(page), true);
    for (const worker of page.workers()) assert.equal(await isIsolated(worker), true, worker.url());
    assert.ok(page.workers().length > 0);
    const second = await wholeVisit(bare);
    assert.equal(second.said, first.said);
    assert.deepEqual(unzipSync(second.bytes), unzipSync(first.bytes));

    // Without a network too, and the guide beside it.
    await context.setOffline(true);
    await page.reload();
    await state(page, 'empty');
    assert.equal(await isIsolated(page), true);
    await page.goto(`${bare.url}guide.html`, { waitUntil: 'domcontentloaded' });
    assert.equal(await isIsolated(page), true);
    bare.allowed = [/ERR_(INTERNET_DISCONNECTED|FAILED)/]; // the guide's picture is not kept
  },
);

test('after one visit the page opens, solves and shows its guide without a network', async () => {
  const { page, context } = it;
  await page.evaluate(() => navigator.serviceWorker.ready.then(() => undefined));
  await context.setOffline(true);
  await page.reload();
  await state(page, 'empty');
  await example(it, 'sphere');
  await run(it);
  await page.goto(`${it.url}guide.html`, { waitUntil: 'domcontentloaded' });
  assert.match(await page.locator('h1').innerText(), /Guide/);
  it.allowed = [/ERR_(INTERNET_DISCONNECTED|FAILED)/]; // the guide's picture is not kept
});

test('page, server and shipped headers have the same security policy', () => {
  const built = path.join(root, 'build/page');
  const [, meta] = readFileSync(path.join(built, 'index.html'), 'utf8').match(
    /Content-Security-Policy"\s+content="([^"]+)"/,
  );
  const policy = headers['Content-Security-Policy'];
  assert.ok(policy.startsWith(`${meta}; frame-ancestors`), policy);
  assert.ok(readFileSync(path.join(built, '_headers'), 'utf8').includes(policy));
  for (const [name, value] of Object.entries(isolation))
    assert.ok(readFileSync(path.join(built, '_headers'), 'utf8').includes(`  ${name}: ${value}\n`));
  for (const [name, value] of policy.split('; ').map((rule) => rule.split(/ (.*)/))) {
    assert.doesNotMatch(value, /unsafe-inline|'unsafe-eval'|https?:|\*/, name);
  }
});

test('the start page is on the screen before any script: the same words, the same cards', async () => {
  const { page, context, url } = it;
  const read = (one) =>
    one.evaluate(() => {
      const start = document.querySelector('.empty');
      const box = ({ x, y, width }) => [x, y, width].map(Math.round);
      return {
        words: start.innerText.replace(/\s+/g, ' ').trim(),
        pictures: [...start.querySelectorAll('img')].map((img) => img.getAttribute('src')),
        buttons: [...start.querySelectorAll('button')].length,
        lead: box(start.querySelector('.lead').getBoundingClientRect()),
      };
    });
  const later = await read(page);
  const plain = await context.browser().newContext({
    javaScriptEnabled: false,
    viewport: page.viewportSize(),
    deviceScaleFactor: 0.5,
  });
  try {
    const first = await plain.newPage();
    await first.goto(url);
    const { lead, ...before } = await read(first);
    const { lead: leadLater, ...after } = later;
    assert.deepEqual(before, after);
    assert.match(before.words, /^Drop a mesh It comes back with texture coordinates/);
    // Under the bar that the script adds, in the same place.
    assert.deepEqual([lead[0], lead[2]], [leadLater[0], leadLater[2]]);
    assert.ok(Math.abs(lead[1] - leadLater[1]) < 40, `${lead} ${leadLater}`);
  } finally {
    await plain.close();
  }
});

test('on a first visit nothing is sent twice, and what is sent is compressed', async () => {
  const { page, url } = it;
  const sent = await page.evaluate(() => navigator.serviceWorker.ready.then(() =>
    performance.getEntriesByType('resource').map(({ name, encodedBodySize, decodedBodySize }) =>
      ({ name, encodedBodySize, decodedBodySize })))); // prettier-ignore
  const scripts = sent.filter(({ name }) => /\.js$/.test(name));
  assert.ok(scripts.length > 0, url);
  const fetched = await Promise.all(
    scripts.map(({ name }) => fetch(name, { headers: { 'Accept-Encoding': 'br' } })),
  );
  for (const [i, answer] of fetched.entries()) {
    assert.equal(answer.headers.get('content-encoding'), 'br', scripts[i].name);
    assert.match(answer.headers.get('cache-control'), /immutable/, scripts[i].name);
  }
  // The script that the first screen waits for does not contain what draws.
  const main = await (await fetch(scripts.find(({ name }) => /index-/.test(name)).name)).text();
  assert.ok(main.length < 300_000 && !main.includes('WebGLRenderer'), `${main.length} bytes`);
});
