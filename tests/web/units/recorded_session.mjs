// The whole page in the stand-in browser, begun as main.ts begins it, and what a person does in it, step by step. After each
// step, what has changed is written down.

import assert from 'node:assert/strict';
import { gzipSync } from 'node:zlib';
import { cardOf, chosen, copied, loaded, now, resized, saved, screen, served, settle, setScreen, skip, solver, startThreads, viewSize } from './browser_stand_in.mjs'; // prettier-ignore
import { pageLines } from './page_text.mjs';
import { changes, Recording, shortened, valueText } from '../../support/recording.mjs';

export { chosen, copied, now, resized, saved, screen, served, setScreen, skip, solver, viewSize };
console.warn = () => undefined; // failures that sessions provoke

export const $ = (selector, within = document) => within.querySelector(selector);
export const $$ = (selector, within = document) => [...within.querySelectorAll(selector)];
export const textOf = (element) => element?.textContent.replace(/\s+/g, ' ').trim() ?? '';
export const buttonOf = (pattern, within = 'body') => $$(`${within} button`).find((one) => pattern.test(one.textContent)); // prettier-ignore

let app;
let before = [];
let record;
const known = new Set();
/** Ends of states that last: a run that is held back, for instance. */
export const waits = { isOff: false };
const isFree = () => {
  const { doc, ui } = app ?? {};
  if (!doc || waits.isOff) return true;
  const isBusy = doc.isBusy || doc.automatic !== undefined || doc.pendingOutput !== undefined;
  return !isBusy && !ui.holdsCone && !('pending' in document.body.dataset) && doc.state.kind !== 'starting'; // prettier-ignore
};
export const rest = (milliseconds) => settle(isFree, milliseconds);

/** Starts the page as a browser does that has loaded its script. */
export async function begin(name, hash = '') {
  record = new Recording(name, import.meta.dirname);
  location.hash = hash;
  document.body.innerHTML = '<div id="page"></div>';
  await startThreads({
    geometry: () => import('../../../web/src/services/geometry_worker.ts'),
    'glTF validator': () => import('../../../web/src/services/validator_worker.ts'),
  });
  // What the page loads when it needs it is there at once: how long loading takes is up to the machine.
  const { gunzip } = await import('../../../web/src/formats/gzip.ts');
  await gunzip(new File([gzipSync('once')], 'once.gz'));
  await Promise.all([
    import('../../../web/src/views/drawing.ts'),
    import('../../../web/src/views/turning_view.ts'),
    import('three/addons/loaders/GLTFLoader.js'),
    import('three/addons/libs/meshopt_decoder.module.js'),
    import('three/addons/utils/BufferGeometryUtils.js'),
  ]);
  await import('../../../web/src/main.ts');
  app = $('hgp-page').app;
  await loaded(() => app.doc.state.kind !== 'starting');
  await loaded(() => !served.has('hero.bin') || $('canvas.turning') !== null);
  await rest();
  return app;
}

async function savedText({ name, blob }) {
  const bytes = new Uint8Array(await blob.arrayBuffer());
  const isText = /\.(?:obj|json|svg|csv|gltf|txt)$/.test(name) && bytes.length < 600;
  const text = isText ? ` ${JSON.stringify(new TextDecoder().decode(bytes))}` : '';
  // A report has the time that the run took.
  const size = /zip$|report\.json$/.test(name) ? '' : ` ${bytes.length} bytes`;
  return `saved ${name}${isText ? text : size}`;
}

/** Does something, waits for the page to be at rest, and records what has changed. */
export async function step(name, act, milliseconds) {
  const [files, texts, asked] = [saved.length, copied.length, solver.asked.length];
  try {
    await act?.();
    await rest(milliseconds);
  } catch (error) {
    error.message = `“${name}”: ${error.message}`;
    throw error;
  }
  const after = pageLines(app, cardOf);
  record.add(`# ${name}`, ...shortened(changes(before, after), known));
  before = after;
  for (const one of saved.slice(files)) record.add(await savedText(one));
  for (const one of copied.slice(texts)) record.add(`copied ${one}`);
  // When handles are released that nobody has any more is up to the engine.
  for (const { method, args } of solver.asked.slice(asked)) if (method !== 'release') record.add(`asked ${method} ${valueText(args, 3)}`); // prettier-ignore
}

export const finish = () => record.end();

/** Clicks as a person does: what is not there or disabled cannot be clicked. */
export function click(selector) {
  const element = typeof selector === 'string' ? $(selector) : selector;
  assert.ok(element, `${selector} is not on the page`);
  assert.ok(!element.disabled, `${selector} is disabled: ${element.title}`);
  element.click();
}

export function choose(selector, value) {
  const element = typeof selector === 'string' ? $(selector) : selector;
  assert.ok(element, `${selector} is not on the page`);
  if (element.type === 'checkbox') element.checked = value;
  else element.value = String(value);
  for (const type of ['input', 'change']) element.dispatchEvent(new Event(type, { bubbles: true }));
}

export function press(selector, key, more = {}) {
  const target = typeof selector === 'string' ? $(selector) : selector;
  target.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true, cancelable: true, ...more })); // prettier-ignore
}

/** A pointer on a view: the position is in pixels from its corner. */
export function point(view, type, x, y, more = {}) {
  const canvas = $(`#${view}`);
  const box = canvas.getBoundingClientRect();
  const about = { bubbles: true, cancelable: true, pointerId: 1, isPrimary: true, pointerType: 'mouse', button: 0, clientX: box.left + x, clientY: box.top + y, ...more }; // prettier-ignore
  const Kind = type === 'wheel' ? WheelEvent : type === 'dblclick' ? MouseEvent : PointerEvent;
  const event = new Kind(type, about);
  for (const [key, value] of Object.entries(about)) if (event[key] !== value) Object.defineProperty(event, key, { value }); // prettier-ignore
  canvas.dispatchEvent(event);
}

/** A press and a release at one place. */
export function tap(view, x, y, more = {}) {
  point(view, 'pointerdown', x, y, { buttons: 1, ...more });
  point(view, 'pointerup', x, y, more);
}

/** A pointer that is moved with its button held, step by step. */
export async function drag(view, [x, y], [toX, toY], more = {}) {
  waits.isOff = true; // the page holds the cone until it is released
  point(view, 'pointerdown', x, y, { buttons: 1, ...more });
  await rest(20);
  for (const part of [0.3, 0.7, 1]) {
    point(view, 'pointermove', x + part * (toX - x), y + part * (toY - y), { buttons: 1, ...more });
    await rest(20);
  }
  waits.isOff = false;
}

/** Where a vertex is in the 3D view. */
export function placeOf(vertex) {
  const { x, y } = app.views.model.toScreen(vertex);
  return [x, y];
}

/** Opens files as dropping them does. */
export function drop(files) {
  const list = Object.entries(files).map(([name, content]) => new File([content], name));
  const event = new Event('drop', { bubbles: true, cancelable: true });
  const items = list.map((file) => ({ kind: 'file', getAsFile: () => file, webkitGetAsEntry: () => null })); // prettier-ignore
  event.dataTransfer = { files: list, items };
  document.dispatchEvent(event);
}
