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
