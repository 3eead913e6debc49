// What the tests of the page do as a person does: drop files, press Run, look at the picture.

import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import pngjs from 'pngjs';
import { toObj } from '../support/meshes.mjs';

export { useBrowser } from './browser.mjs';

export const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
export const shots = path.join(root, 'build/screenshots');
const axe = readFileSync(path.join(root, 'node_modules/axe-core/axe.min.js'), 'utf8');

export const state = (page, ...names) =>
  page.waitForSelector(names.map((name) => `body[data-state="${name}"]`).join(','));

/** The worker that solves: the newest, where a cancelled one has not gone yet. */
export const solverOf = (page) =>
  page.workers().findLast((worker) => !/geometry|validator/.test(worker.url()));

export const statusText = (page) => page.locator('#status').innerText();

const program = path.join(root, 'build/native-release/bin/hgp');

/** The command line, which verifies what the page wrote; where it is not built, the test says so. */
export function commandLine(t) {
  if (existsSync(program)) return program;
  t.skip(`${path.relative(root, program)} is not built: part of this test is left out`);
  return undefined;
}

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
/** All rows of the verdict, which are under Details. */
export async function certificate(it) {
  await openDetails(it.page, '#result-details');
  return it.page.locator('#certificate').innerText();
}

/** Opens a section as a person does, where it is closed. */
export async function openDetails(page, selector) {
  if ((await page.getAttribute(selector, 'open')) === null)
    await page.click(`${selector} > summary`);
}
export const coneCount = (it) => it.page.locator('#cones tbody tr[data-cone]').count();
export const kOf = (it, i) => it.page.locator(`tr[data-cone="${i}"] input`).inputValue();

/** Waits until the status line says something: a failure before this one may still stand there. */
export const statusSays = (it, pattern) =>
  it.page.waitForFunction(
    (source) => new RegExp(source).test(document.querySelector('#status')?.innerText),
    pattern.source,
  );

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
    // What the target wants is in front, everything else under More.
    const isInFront = await it.page.isVisible(`dialog [data-format="${format}"]`);
    if (!isInFront) await openDetails(it.page, '#more-formats');
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

/**
 * What axe finds wrong, in all of the page or in some parts; through the debugger, so that the policy
 * of the page stays in force.
 */
export async function violations(page, ...parts) {
  if (!(await page.evaluate(() => 'axe' in globalThis))) await page.evaluate(axe);
  const found = await page.evaluate(
    (include) =>
      globalThis.axe.run(include.length > 0 ? { include } : document, {
        resultTypes: ['violations'],
        runOnly: ['wcag2a', 'wcag2aa', 'wcag21aa', 'wcag22aa', 'best-practice'],
      }),
    parts,
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

/** A grid so coarse that its lines are seen in pictures of few pixels; before Run. */
export async function coarseGrid(page) {
  const slider = page.locator('#cells');
  await slider.fill('30');
  await slider.dispatchEvent('change');
}

/** Coloured seams on the surface, as a person switches them. */
export async function showSeams(page, isOn) {
  if ((await page.getAttribute('#seams', 'aria-pressed')) !== String(isOn))
    await page.click('#seams');
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

/** From now on, the names of what the page asks of its workers: names() tells them, forget() begins anew. */
export async function workerCalls(page) {
  await page.evaluate(() => {
    // The page may be that of an earlier test, which has asked before.
    const isCounted = globalThis.called !== undefined;
    globalThis.called = [];
    if (isCounted) return;
    const { postMessage } = Worker.prototype;
    Worker.prototype.postMessage = function (message, ...rest) {
      // A solver that has lost a map is told in the message how to make it again.
      const again = (message?.restore ?? []).map(({ method }) => method);
      if (message?.method) globalThis.called.push(...again, message.method);
      return postMessage.call(this, message, ...rest);
    };
  });
  return {
    names: () => page.evaluate(() => globalThis.called),
    forget: () => page.evaluate(() => (globalThis.called.length = 0)),
  };
}
