// The site: every link leads somewhere, nothing is asked of another host, search finds things, models can be turned, and
// all of it works from a folder and without a network. With --full: with the API references, and every page looked at.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import nodeTest, { after, before } from 'node:test';
import pngjs from 'pngjs';
import { brokenLinks } from '../../site/check.mjs';
import { parts, render, slug } from '../../site/markdown.mjs';
import { startChromium } from '../../web/chromium.mjs';
import { serve } from '../wasm/project.mjs';
import { root, shots } from './support.mjs';

const isFull = process.env.HGP_FULL === '1';
const parent = path.join(root, 'build/site-test');
const folder = path.join(parent, 'some/folder'); // not the root of its host
const axe = readFileSync(path.join(root, 'node_modules/axe-core/axe.min.js'), 'utf8');

let server;
let browser;
before(async () => {
  rmSync(parent, { recursive: true, force: true });
  if (isFull) {
    execFileSync('scripts/site', { cwd: root, stdio: 'pipe' });
    execFileSync('node', ['site/build.mjs', '--out', folder], { cwd: root, stdio: 'pipe' });
  } else {
    const args = ['site/build.mjs', '--without-references', '--out', folder];
    execFileSync(process.execPath, args, { cwd: root, stdio: 'pipe' });
  }
  mkdirSync(shots, { recursive: true });
  server = await serve(parent);
  browser = await startChromium();
});
after(async () => {
  await browser?.close();
  server?.close();
});

/** Opens pages in a fresh context; whatever is asked of another host, or goes wrong, is noted. */
async function visit(options, use) {
  const context = await browser.newContext({ reducedMotion: 'reduce', ...options });
  const page = await context.newPage();
  const trouble = [];
  page.on('pageerror', (error) => trouble.push(String(error)));
  page.on('console', (message) => {
    const text = message.text();
    if (
      message.type() === 'error' &&
      !/ERR_INTERNET_DISCONNECTED|error occurred when fetching the script/.test(text)
    )
      trouble.push(text);
  });
  context.on('request', (request) => {
    if (!/^(blob|data):/.test(request.url()) && !request.url().startsWith(server.origin))
      trouble.push(`asked of another host: ${request.url()}`);
  });
  try {
    await use(page, context);
    assert.deepEqual(trouble, []);
  } finally {
    await context.close();
  }
}
const at = (file) => `${server.origin}/some/folder/${file}`;
const test = (name, run) => nodeTest(name, { timeout: 300_000 }, run);

/** How many different colours a picture has, among every 16th of its pixels. */
function colours(bytes) {
  const { data } = pngjs.PNG.sync.read(bytes);
  const seen = new Set();
  for (let i = 0; i < data.length; i += 64)
    seen.add((data[i] << 16) | (data[i + 1] << 8) | data[i + 2]);
  return seen.size;
}

test('headings have the ids that GitHub gives them, and links go where the site has the page', () => {
  assert.equal(slug('What `F_cb` is: q = 4, and ½'), 'what-f_cb-is-q--4-and-½');
  const { html, headings, title } = render(
    '# A *b*\n\n## Twice\n\n## Twice\n\n[in](x.md#a) [out](y.md)\n\n| a |\n|---|\n| `<b>` |\n',
    (href) => (href.startsWith('x') ? 'x.html' : undefined),
  );
  assert.equal(title, 'A b');
  assert.deepEqual(
    headings.map(({ id }) => id),
    ['a-b', 'twice', 'twice-1'],
  );
  assert.match(html, /<a href="x\.html">in<\/a>/);
  assert.match(html, /<span class="in-source" title="in the sources: y\.md">out<\/span>/);
  assert.match(html, /<td><code>&lt;b&gt;<\/code><\/td>/);
  assert.deepEqual(parts(html)[0], { id: 'a-b', heading: 'A b', text: '' });
});

test('cells without words are no headers', () => {
  const corner = render('| | a |\n|---|---|\n| b | c |\n', () => undefined).html;
  assert.match(corner, /<thead><tr><td><\/td><th>a<\/th><\/tr><\/thead>/);
  const none = render('| | |\n|---|---|\n| b | c |\n', () => undefined).html;
  assert.match(none, /<table><tbody><tr><td>b<\/td>/);
});

test('every link leads somewhere; the check finds links that do not, and pages that ask other hosts', () => {
  assert.deepEqual(brokenLinks(folder), []);
  const bad = path.join(root, 'build/site-test-bad');
  mkdirSync(bad, { recursive: true });
  const page = `<a href="no.html">a</a><a href="#no">b</a><img src="https://x.org/a.png"><a href="https://x.org">ok</a>`;
  writeFileSync(path.join(bad, 'a.html'), page);
  assert.equal(brokenLinks(bad).length, 3);
});

test('it holds the page, the guides, five minutes with each tool, the gallery and the licences', () => {
  const files = readdirSync(folder, { recursive: true, encoding: 'utf8' });
  for (const name of [
    ...['index', 'app/index', 'guide', 'not-certified', 'which-tool', 'gallery'].map(
      (one) => `${one}.html`,
    ),
    ...['command-line', 'cpp', 'javascript', 'python', 'blender'].map(
      (one) => `five-minutes/${one}.html`,
    ),
    'THIRD_PARTY_LICENSES.txt',
  ])
    assert.ok(files.includes(name), name);
  if (!isFull) return;
  const reference = (file) => readFileSync(path.join(folder, 'api', file), 'utf8');
  for (const id of ['Distortion.stretch', 'Quads.vertices', 'Seams.r'])
    assert.ok(reference('python/map.html').includes(`id="hgp.${id}"`), `${id} is not described`);
  assert.doesNotMatch(reference('python/mesh.html'), /_SupportsArray|Alias for field/);
  assert.match(reference('js/index.html'), />hgp\/core<\/a><\/td><td>The solver itself/);
});

test('search finds pages by their words, prefers headings, and opens what is chosen with the keyboard', async () => {
  await visit({}, async (page) => {
    await page.goto(at('index.html'));
    await page.keyboard.press('/');
    await page.keyboard.type('not certified');
    const first = page.locator('#found li').first();
    await first.waitFor();
    assert.match(await first.innerText(), /^Not certified: what now/);
    await page.locator('#search').fill('zzzz');
    assert.match(await page.locator('#found').innerText(), /Nothing has “zzzz”/);
    await page.locator('#search').fill('exit cod');
    await page.keyboard.press('Enter');
    await page.waitForURL(/cli\.html#exit-codes$/);
  });
});

test('models of the gallery are drawn, turn with the keys and change their pattern', async () => {
  await visit({ viewport: { width: 1280, height: 800 } }, async (page) => {
    await page.goto(at('gallery.html'));
    const cube = page.locator('#cube');
    const model = cube.locator('canvas.model');
    await cube.locator('canvas.model[data-drawn]').waitFor();
    await cube.locator('canvas.map[data-drawn]').waitFor();
    const before = await model.screenshot();
    assert.ok(colours(before) > 50, `${colours(before)} colours`);
    assert.ok(colours(await cube.locator('canvas.map').screenshot()) > 5);
    const change = async (act) => {
      await model.evaluate((canvas) => delete canvas.dataset.drawn);
      await act();
      await cube.locator('canvas.model[data-drawn]').waitFor();
      return model.screenshot();
    };
    const turned = await change(async () => {
      await model.focus();
      await page.keyboard.press('ArrowLeft');
    });
    assert.ok(!turned.equals(before));
    const plaid = await change(() => cube.locator('select').selectOption('plaid'));
    assert.ok(!plaid.equals(turned));
    writeFileSync(path.join(shots, 'site-gallery.png'), await page.screenshot());
  });
});

test('after one visit it works without a network, with the page and its solver', async () => {
  await visit({ serviceWorkers: 'allow' }, async (page, context) => {
    await page.goto(at('index.html'));
    await page.evaluate(() => navigator.serviceWorker.ready.then(() => undefined));
    await context.setOffline(true);
    await page.goto(at('which-tool.html'));
    assert.equal(await page.locator('h1').innerText(), 'Which tool to use');
    await page.goto(at('gallery.html'));
    await page.locator('#figure canvas.model[data-drawn]').waitFor();
    await page.goto(at('app/'));
    await page.waitForSelector('body[data-state="empty"]');
    await page.click('[data-card="cube"]');
    await page.waitForSelector('body[data-state="ready"]');
    await page.click('#run');
    await page.waitForSelector('body[data-state="certified"]', { timeout: 120_000 });
  });
});

test('pages fit on phones and screens, in the light and in the dark, and are accessible', async () => {
  const all = isFull
    ? readdirSync(folder, { recursive: true, encoding: 'utf8' }).filter(
        (name) => name.endsWith('.html') && !name.startsWith('app/'),
      )
    : ['index.html', 'gallery.html', 'guide.html', 'five-minutes/python.html'];
  for (const [name, width, colorScheme] of [
    ['screen', 1280, 'light'],
    ['phone-dark', 390, 'dark'],
  ])
    await visit(
      { viewport: { width, height: 800 }, colorScheme, bypassCSP: true },
      async (page) => {
        for (const file of all) {
          await page.goto(at(file));
          const [wide, title] = await page.evaluate(() => [
            document.documentElement.scrollWidth,
            document.querySelector('main h1')?.innerText,
          ]);
          assert.ok(wide <= width, `${file}: ${wide} wide on a screen of ${width}`);
          assert.ok(title, `${file} has no title`);
          const picture = await page.screenshot();
          assert.ok(colours(picture) > 8, file);
          writeFileSync(
            path.join(shots, `site-${file.replaceAll(/\W+/g, '-')}-${name}.png`),
            picture,
          );
          await page.evaluate(axe);
          const { violations } = await page.evaluate(() => globalThis.axe.run());
          assert.deepEqual(
            violations.map(({ id, nodes }) => `${file}: ${id}: ${nodes[0].html.slice(0, 200)}`),
            [],
          );
        }
      },
    );
});
