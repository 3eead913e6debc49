// A browser for the tests of the page: real Chromium, real files, and no message of the console
// forgiven — violations of the Content-Security-Policy arrive there.

import assert from 'node:assert/strict';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, afterEach, before, beforeEach } from 'node:test';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';
import pngjs from 'pngjs';
import { serve } from '../../web/serve.mjs';
import { toObj } from '../support/meshes.mjs';

export const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
export const shots = path.join(root, 'build/screenshots');
const axe = readFileSync(path.join(root, 'node_modules/axe-core/axe.min.js'), 'utf8');

/** What tests of one file may leave behind, taken away: storage, size, colours, a lost network. */
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
    ...{ pattern: 'cross', overlay: 'none', scale: '45', q: '4', rounds: '12', 'time-limit': '' },
    'q-custom': '4',
  };
  const isValue = ([id, value]) => find(`#${id}`)?.value === value;
  const pressed = [...document.querySelectorAll('.toolbar [aria-pressed="true"]')].map(
    ({ id }) => id,
  );
  return (
    find('#close') !== null &&
    find('dialog, #cancel, .popup, input:checked, th[aria-sort$="scending"]') === null &&
    Object.entries(values).every(isValue) &&
    `${pressed}` === 'tool-orbit,seams' &&
    find('#tab-surface').ariaSelected === 'true' &&
    find('#splitter').ariaValueNow === '58' &&
    find('main').dataset.sheet === 'half' &&
    document.documentElement.dataset.theme === 'auto'
  );
}

/**
 * Closes the model as a person does, which is as good as another page where nothing else was changed;
 * otherwise does nothing and says so.
 */
async function closed(page) {
  if (!page.url().startsWith('http') || !(await page.evaluate(isPlain).catch(() => false)))
    return false;
  await page.mouse.move(0, 0);
  await page.click('#close');
  await state(page, 'empty');
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

/**
 * Sets up hooks and returns an object that has the page of the current test: one page for a whole file,
 * opened anew, or closed and empty, for each test.
 */
export function useBrowser({
  viewport = { width: 1100, height: 700 },
  flags = [],
  deviceScaleFactor = 0.5, // a quarter of the pixels that software has to paint
  serviceWorkers = 'block', // precaching would only slow the other tests down
  ...more
} = {}) {
  const it = { allowed: [] };
  let server, browser;
  let problems = [];
  before(async () => {
    mkdirSync(shots, { recursive: true });
    it.folder = mkdtempSync(path.join(tmpdir(), 'hgp-web-'));
    ({ server, url: it.url } = await serve({ port: 0 }));
    const executablePath = ['/usr/bin/chromium', '/usr/bin/google-chrome'].find(existsSync);
    const args = ['--no-sandbox', '--disable-background-networking', '--disable-dev-shm-usage'];
    args.push(...flags);
    browser = await chromium.launch({ executablePath, args });
    it.context = await browser.newContext({
      ...{ viewport, serviceWorkers, acceptDownloads: true, reducedMotion: 'reduce' },
      ...{ deviceScaleFactor, ...more },
    });
    it.page = await it.context.newPage();
    it.page.setDefaultTimeout(Number(process.env.HGP_TIMEOUT ?? 20_000));
    it.page.on('console', (message) => message.type() === 'error' && problems.push(message.text()));
    it.page.on('pageerror', (error) => problems.push(error.message));
    it.page.on('request', (request) => {
      const target = new URL(request.url());
      const isOwn = ['blob:', 'data:'].includes(target.protocol);
      if (!isOwn && target.origin !== new URL(it.url).origin) {
        problems.push(`request to ${target.origin}`);
      }
    });
  });
  after(async () => {
    await browser?.close();
    server?.close();
    rmSync(it.folder, { recursive: true, force: true });
  });
  beforeEach(async () => {
    const isClosed = await closed(it.page);
    await clean(it.page, it.context, { origin: new URL(it.url).origin, viewport });
    if (!isClosed) await it.page.goto(it.url);
    problems = [];
    it.allowed = [];
    await state(it.page, 'empty');
  });
  afterEach(() => {
    const unexpected = problems.filter((text) => !it.allowed.some((pattern) => pattern.test(text)));
    assert.deepEqual(unexpected, []);
  });
  return it;
}

export const state = (page, ...names) =>
  page.waitForSelector(names.map((name) => `body[data-state="${name}"]`).join(','));

/** The worker that solves: the newest, where a cancelled one has not gone yet. */
export const solverOf = (page) => page.workers().at(-1);

export const statusText = (page) => page.locator('#status').innerText();

/** Writes files and drops them on the page through the browser's own drag and drop. */
export async function drop(it, files) {
  const paths = Object.entries(files).map(([name, content]) => {
    const file = path.join(it.folder, name);
    mkdirSync(path.dirname(file), { recursive: true });
    writeFileSync(file, content);
    return file;
  });
  await dropPaths(it, paths);
}

/** Drops files and waits for what comes of it. */
export async function openFiles(it, files, ...states) {
  await drop(it, files);
  await state(it.page, ...(states.length > 0 ? states : ['ready']));
}

export const openMesh = (it, mesh, name = 'mesh.obj') =>
  openFiles(it, { [name]: toObj(mesh) }, 'ready', 'unbalanced');

export async function example(it, name) {
  await it.page.click(`[data-card="${name}"]`);
  await state(it.page, 'ready');
}

export async function run(it, ...states) {
  await it.page.click('#run');
  await state(it.page, ...(states.length > 0 ? states : ['certified']));
}

export const model = (it) => it.page.locator('#panel-model').innerText();
export const certificate = (it) => it.page.locator('#certificate').innerText();
export const coneCount = (it) => it.page.locator('#cones tbody tr[data-cone]').count();
export const kOf = (it, i) => it.page.locator(`tr[data-cone="${i}"] input`).inputValue();

/** Waits until the panel of the model says something. */
export const modelSays = (it, pattern) =>
  it.page.waitForFunction(
    (source) => new RegExp(source).test(document.querySelector('#panel-model')?.innerText),
    pattern.source,
  );

/** The worker's next message kills it. */
export async function killSolver(it) {
  it.allowed = [/the end/];
  await solverOf(it.page).evaluate(() =>
    self.addEventListener('message', () => {
      throw new Error('the end');
    }),
  );
}

/** Saves in a format of the Download dialog. */
export const saveAs = (it, format) =>
  download(it.page, async () => {
    await it.page.click('#download');
    await it.page.click(`[data-format="${format}"]`);
  });

/** The text of the status line, once it is an error. */
export async function failure(it) {
  await it.page.waitForSelector('#status.error');
  return statusText(it.page);
}

export async function dropPaths(it, paths) {
  const session = await it.page.context().newCDPSession(it.page);
  const data = { items: [], files: paths, dragOperationsMask: 1 };
  for (const type of ['dragEnter', 'dragOver', 'drop']) {
    await session.send('Input.dispatchDragEvent', { type, x: 400, y: 400, data });
  }
  await session.detach();
}

/** What axe finds wrong; through the debugger, so that the policy of the page stays in force. */
export async function violations(page) {
  if (!(await page.evaluate(() => 'axe' in globalThis))) await page.evaluate(axe);
  const found = await page.evaluate(() =>
    globalThis.axe.run({
      resultTypes: ['violations'],
      runOnly: ['wcag2a', 'wcag2aa', 'wcag21aa', 'wcag22aa', 'best-practice'],
    }),
  );
  return found.violations.map(
    ({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html.slice(0, 160)).join(' | ')}`,
  );
}

/** The picture of an element as { data, width, height }. */
export async function pixels(page, selector, name) {
  const png = await page.locator(selector).screenshot();
  if (name) writeFileSync(path.join(shots, `${name}.png`), png);
  return pngjs.PNG.sync.read(png);
}

/** Waits until three frames have gone by with nothing left to draw. */
export async function settled(page) {
  await page.evaluate(async () => {
    const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));
    for (let still = 0; still < 3;) {
      await frame();
      still = document.querySelector('[data-pending]') ? 0 : still + 1;
    }
  });
}

/** Share of pixels that pass a test of their colour. */
export function share({ data }, passes) {
  let count = 0;
  for (let i = 0; i < data.length; i += 4)
    if (passes(data[i], data[i + 1], data[i + 2])) count += 1;
  return count / (data.length / 4);
}

/** The colour of highlights. */
export const isPink = (r, g, b) => r > 220 && g < 110 && b > 100 && b < 200;

/** A one-coloured PNG, or one with four fields. */
export function pngOf(colours, size = 16) {
  const png = new pngjs.PNG({ width: size, height: size });
  for (let y = 0; y < size; y++) {
    for (let x = 0; x < size; x++) {
      const field = (x < size / 2 ? 0 : 1) + (y < size / 2 ? 0 : 2);
      png.data.set([...colours[field % colours.length], 255], 4 * (y * size + x));
    }
  }
  return pngjs.PNG.sync.write(png);
}

/** Saves what a click downloads; resolves to its name and bytes. */
export async function download(page, click) {
  const [saved] = await Promise.all([page.waitForEvent('download'), click()]);
  return { name: saved.suggestedFilename(), bytes: readFileSync(await saved.path()) };
}
