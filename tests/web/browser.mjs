// A browser for the tests of the page: real Chromium, and no message of the console forgiven —
// violations of the Content-Security-Policy arrive there. Starting a browser and compiling the solver
// takes longer than most tests, so tests of one process share pages that are alike.

import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import nodeTest, { after } from 'node:test';
import { fileURLToPath } from 'node:url';
import { startChromium } from '../../web/chromium.mjs';
import { serve } from '../../web/serve.mjs';

const shots = fileURLToPath(new URL('../../build/screenshots', import.meta.url));
const isEmpty = (page) => page.waitForSelector('body[data-state="empty"]');

/** What a test may leave behind, taken away: storage, size, colours, a lost network. */
async function clean(page, context, { origin, viewport }) {
  page.removeAllListeners('dialog');
  await context.setOffline(false);
  await page.emulateMedia({ colorScheme: 'light', reducedMotion: 'reduce' });
  if (viewport) await page.setViewportSize(viewport);
  const session = await context.newCDPSession(page);
  const storageTypes = 'local_storage,indexeddb';
  await session.send('Storage.clearDataForOrigin', { origin, storageTypes });
  await session.detach();
}

/** Whether everything that outlives a model is as on a fresh page. */
function isPlain() {
  const find = (selector) => document.querySelector(selector);
  const values = {
    ...{ q: '4', rounds: '12', 'time-limit': '', 'q-custom': '4' },
    ...(find('#pattern') ? { pattern: 'checker', overlay: 'none', wipe: '0' } : {}),
    ...(find('#scale') ? { scale: find('#scale').dataset.steps === 'true' ? '1' : '45' } : {}),
    ...(find('#grid-mode') ? { 'grid-mode': 'tile', 'cone-step': '2' } : {}),
  };
  const isValue = ([id, value]) => find(`#${id}`)?.value === value;
  const pressed = [...document.querySelectorAll('.toolbar [aria-pressed="true"]')].map(
    ({ id }) => id,
  );
  const sorted = find('th[aria-sort$="scending"]');
  return (
    find('#close') !== null &&
    find('#view').dataset.seams !== 'on' &&
    find('#view').dataset.seams !== 'off' &&
    find('#align:not(:checked):not(:disabled)') === null &&
    find('#cells-automatic:not([hidden])') === null &&
    find(
      'dialog, #cancel, :popover-open, input:checked:not(#align), th[aria-sort="descending"]',
    ) === null &&
    (sorted === null || sorted.contains(find('[data-sort="number"]'))) &&
    Object.entries(values).every(isValue) &&
    pressed.filter((id) => id !== 'seams').join() === 'tool-orbit' &&
    find('#tab-surface').ariaSelected === 'true' &&
    find('#splitter').ariaValueNow === '58' &&
    find('main').dataset.sheet === 'half' &&
    document.documentElement.dataset.theme === 'auto'
  );
}

/** Chooses an option where that can be done and was not. */
async function choose(page, select, value) {
  if (!(await page.isVisible(select))) return;
  if ((await page.inputValue(select)) !== value) await page.selectOption(select, value);
}

/** Puts back what tests often change, by the same controls. */
async function tidy(page) {
  if (await page.$('#downloads, #help-dialog, #log-dialog')) await page.keyboard.press('Escape');
  if (await page.isVisible('#tab-surface')) await page.click('#tab-surface');
  await choose(page, '#q', '4');
  await choose(page, '#grid-mode', 'tile');
  if (!(await page.isVisible('#wire'))) return;
  await choose(page, '#pattern', 'checker');
  await choose(page, '#overlay', 'none');
  for (const [button, pressed] of [
    ['#wire', 'false'],
    ['#tool-orbit', 'true'],
  ]) {
    // prettier-ignore
    if ((await page.getAttribute(button, 'aria-pressed')) !== pressed) await page.click(button);
  }
  if (!(await page.isVisible('#scale'))) return;
  const usualScale = (await page.getAttribute('#scale', 'data-steps')) === 'true' ? '1' : '45';
  if ((await page.inputValue('#scale')) !== usualScale)
    await page.locator('#scale').fill(usualScale);
  if ((await page.inputValue('#wipe')) !== '0') await page.locator('#wipe').fill('0');
}

/**
 * Closes the model as a person does, which is as good as another page where nothing else was changed;
 * otherwise does nothing and says so.
 */
async function closed(page) {
  if (!page.url().startsWith('http')) return false;
  if (await page.$('#close')) await tidy(page);
  if (!(await page.evaluate(isPlain).catch(() => false))) return false;
  await page.mouse.move(0, 0);
  await page.click('#close');
  await isEmpty(page);
  // What Close keeps in the browser is kept by then.
  await page.evaluate(
    () =>
      new Promise((resolve) => {
        const opening = indexedDB.open('hgp');
        opening.onsuccess = opening.onerror = () => resolve(opening.result?.close());
      }),
  );
  return true;
}

/** Where files are written, once for the process. */
let folder;
/** Where the page is served: by a host that isolates it, and by one that does not. */
const places = new Map();
function open(isIsolating) {
  mkdirSync(shots, { recursive: true });
  folder ??= mkdtempSync(path.join(tmpdir(), 'hgp-web-'));
  if (!places.has(isIsolating)) places.set(isIsolating, serve({ port: 0, isIsolating }));
  return places.get(isIsolating);
}

const browsers = new Map();
function browserWith(flags) {
  const key = flags.join(' ');
  if (!browsers.has(key)) browsers.set(key, startChromium('--disable-dev-shm-usage', ...flags));
  return browsers.get(key);
}

/** Collects what must not happen. */
function watch(page, url, problems) {
  page.on('console', (message) => message.type() === 'error' && problems.push(message.text()));
  page.on('pageerror', (error) => problems.push(error.message));
  page.on('request', (request) => {
    const target = new URL(request.url());
    const isOwn = ['blob:', 'data:'].includes(target.protocol);
    if (!isOwn && target.origin !== new URL(url).origin) {
      problems.push(`request to ${target.origin}`);
    }
  });
}

/** Whether a run follows an edit by itself must not depend on how fast this machine is. */
function onlyByRun() {
  try {
    localStorage.setItem('hgp-automatic', 'off');
  } catch {
    // Where nothing can be stored, tests do not edit.
  }
}

/**
 * A graphics card filters the studio for reflections in no time; software takes as long for it, whenever a page shows
 * its first glTF, as for the rest of a test. Here it takes fewer samples, and reflections are grainier.
 */
function fewSamples() {
  const { prototype } = WebGL2RenderingContext;
  const { shaderSource } = prototype;
  const cheaper = (text) => {
    if (!text.includes('#define SHADER_NAME PMREMGGX')) return text;
    return text.replace('SAMPLES 256u', 'SAMPLES 16u').replaceAll(/\b([xy]) \+\+/g, '$1 += 4');
  };
  prototype.shaderSource = function (shader, text) {
    shaderSource.call(this, shader, cheaper(text));
  };
}

const pages = new Map();
async function openPage(flags, { isAutomatic, isIsolating, antialias, ...options }) {
  const { url } = await open(isIsolating);
  const browser = await browserWith(flags);
  const context = await browser.newContext({
    ...{ acceptDownloads: true, reducedMotion: 'reduce', ...options },
  });
  if (!isAutomatic) await context.addInitScript(onlyByRun);
  if (!antialias) await context.addInitScript(fewSamples);
  const page = await context.newPage();
  page.setDefaultTimeout(Number(process.env.HGP_TIMEOUT ?? 60_000));
  const problems = [];
  watch(page, url, problems);
  return { context, page, problems };
}

async function closeAll() {
  for (const browser of browsers.values()) await (await browser).close();
  for (const place of places.values()) (await place).server.close();
  if (folder) rmSync(folder, { recursive: true, force: true });
}
// With one file, after its tests; in a lane, after its files.
if (globalThis.atEnd) globalThis.atEnd.push(closeAll);
else after(closeAll);

/**
 * Returns an object with `test`, and with the page of the current test: the same for all tests that
 * want the same kind, opened anew, or closed and empty, for each.
 */
export function useBrowser({
  viewport = { width: 1100, height: 700 },
  flags = [],
  deviceScaleFactor = 0.5, // a quarter of the pixels that software has to paint
  antialias = false, // with it, software has to paint four times as many
  serviceWorkers = 'block', // precaching would only slow the other tests down
  isAutomatic = false, // whether the page decides about runs after edits, as it does for everybody
  isIsolating = true, // whether the host sends the headers that isolate the page, which few static hosts do
  ...more
} = {}) {
  const it = { allowed: [] };
  const options = {
    deviceScaleFactor,
    serviceWorkers,
    isAutomatic,
    isIsolating,
    antialias,
    ...more,
  };
  const all = antialias ? flags : ['--webgl-antialiasing-mode=none', ...flags];
  const key = JSON.stringify([all, options]);
  const prepare = async () => {
    const { url } = await open(isIsolating);
    if (!pages.has(key)) pages.set(key, await openPage(all, { viewport, ...options }));
    const { page, context, problems } = pages.get(key);
    Object.assign(it, { url, folder, page, context, allowed: [] });
    const isClosed = await closed(page);
    await clean(page, context, { origin: new URL(url).origin, viewport });
    if (!isClosed) await page.goto(url);
    problems.length = 0;
    await isEmpty(page);
    return problems;
  };
  it.test = (name, body) =>
    nodeTest(name, async (t) => {
      try {
        const problems = await prepare();
        await body(t);
        const isAllowed = (text) => it.allowed.some((pattern) => pattern.test(text));
        assert.deepEqual(problems.filter((text) => !isAllowed(text)), []); // prettier-ignore
      } catch (error) {
        // Nothing of what went wrong here shall reach the next test.
        await it.context?.close().catch(() => {});
        pages.delete(key);
        throw error;
      }
    });
  return it;
}
