// After the first visit the page works without a network; and what it is served with.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { headers } from '../../web/serve.mjs';
import { example, root, run, state, useBrowser } from './support.mjs';

const it = useBrowser({ serviceWorkers: 'allow' });
const { test } = it;

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
