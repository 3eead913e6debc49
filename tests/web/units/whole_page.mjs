// The whole page without a browser: its panels in a document of happy-dom, its actions and its geometry worker as they
// are, the solver of the built package. There are no views. What needs layout, a GPU or real input is tested in tests/web.

import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import path from 'node:path';
import { Window } from 'happy-dom';

const built = path.resolve(import.meta.dirname, '../../../build/package/node/index.js');
export const skip = existsSync(built)
  ? false
  : 'build/package is not there: build hgp_package first';

const window = new Window({ url: 'https://hgp.example/', width: 1400, height: 900 });
const taken = ['document', 'customElements', 'matchMedia', 'localStorage', 'location', 'history', 'MutationObserver', 'requestAnimationFrame', 'cancelAnimationFrame', 'ResizeObserver', 'getComputedStyle', 'CSSStyleSheet', 'Event', 'CustomEvent', 'Node', 'Element', 'ShadowRoot', 'Document', 'DocumentFragment', 'Text', 'Comment', 'NodeFilter']; // prettier-ignore
for (const name of Object.getOwnPropertyNames(window)) {
  const isClass = /^(HTML|SVG)\w*Element$|^\w+Event$/.test(name);
  if (isClass || taken.includes(name))
    Object.defineProperty(globalThis, name, { value: window[name], writable: true, configurable: true }); // prettier-ignore
}
globalThis.window = window;
for (const name of [
  'addEventListener',
  'removeEventListener',
  'dispatchEvent',
  'matchMedia',
  'getComputedStyle',
])
  // prettier-ignore
  globalThis[name] = window[name].bind(window);

/** What was given to the user: names and contents of files, and texts of the clipboard. */
export const saved = [];
export const copied = [];
const clipboard = { writeText: async (text) => void copied.push(text) };
Object.defineProperty(globalThis, 'navigator', { value: { clipboard, platform: 'test', userAgent: 'test', language: 'en', hardwareConcurrency: 2 }, configurable: true }); // prettier-ignore
globalThis.ImageData = class {};
URL.createObjectURL = (blob) => {
  saved.push({ blob });
  return `blob:${saved.length - 1}`;
};
URL.revokeObjectURL = () => undefined;
window.HTMLAnchorElement.prototype.click = function click() {
  const at = Number(this.href.match(/blob:(?:null\/)?(\d+)/)?.[1]);
  if (saved[at]) saved[at].name = this.download;
};
window.HTMLDialogElement.prototype.showModal = function showModal() {
  this.setAttribute('open', '');
};

// The geometry worker in this thread; messages are cloned, and what is transferred is lost to the sender.
let toWorker;
const toPage = new Set();
const own = globalThis.addEventListener;
globalThis.postMessage = (message, { transfer = [] } = {}) => {
  const data = structuredClone(message, { transfer });
  setImmediate(() => toPage.forEach((listener) => listener({ data })));
};
globalThis.addEventListener = (_, listener) => (toWorker = listener);
await import('../../../web/src/services/geometry_worker.ts');
globalThis.addEventListener = own;
globalThis.Worker = class {
  addEventListener(type, listener) {
    if (type === 'message') toPage.add(listener);
  }
  postMessage(message, transfer = []) {
    const data = structuredClone(message, { transfer });
    setImmediate(() => toWorker({ data }));
  }
  terminate() {}
};

const { createClient } = await import(built);
const { Document } = await import('../../../web/src/model/document.ts');
const { UiState } = await import('../../../web/src/model/ui_state.ts');
const { GeometryClient } = await import('../../../web/src/services/geometry_client.ts');
const { actions } = await import('../../../web/src/actions/registry.ts');
const { open } = await import('../../../web/src/actions/open.ts');
await import('../../../web/src/panels/app_page.ts');
await import('../../../web/src/panels/top_bar.ts');

export const $ = (selector, within = document) => within.querySelector(selector);
export const $$ = (selector, within = document) => [...within.querySelectorAll(selector)];
export const textOf = (element) => element?.textContent.replace(/\s+/g, ' ').trim() ?? '';
export const say = (app) => textOf($('hgp-status-bar')) || app.doc.message?.text;

/** Waits until the page is drawn as the document is now. */
export async function drawn() {
  for (let i = 0; i < 4; i++) {
    await new Promise((resolve) => setTimeout(resolve));
    await Promise.all($$('*').map((element) => element.updateComplete));
  }
}

export async function until(condition, what = 'a state', seconds = 60) {
  const end = Date.now() + 1000 * seconds;
  while (!condition()) {
    if (Date.now() > end) assert.fail(`${what} does not come about`);
    await new Promise((resolve) => setTimeout(resolve, 5));
  }
  await drawn();
}

/** Opens the page; it is ended with the test. */
export async function openPage(t) {
  localStorage.clear();
  saved.length = 0;
  copied.length = 0;
  toPage.clear();
  const client = await createClient();
  const app = { doc: new Document(), ui: new UiState(), geometry: new GeometryClient(), client, views: undefined }; // prettier-ignore
  app.doc.state = { kind: 'empty' };
  const page = document.createElement('hgp-page');
  page.app = app;
  document.body.replaceChildren(page);
  t.after(() => {
    page.remove();
    client.terminate();
  });
  await drawn();
  return app;
}

/** Clicks as a person does: what is not there or disabled cannot be clicked. */
export async function click(selector) {
  const element = typeof selector === 'string' ? $(selector) : selector;
  assert.ok(element, `${selector} is not on the page`);
  assert.ok(!element.disabled, `${selector} is disabled: ${element.title}`);
  element.click();
  await drawn();
}

export async function choose(selector, value) {
  const element = typeof selector === 'string' ? $(selector) : selector;
  assert.ok(element, `${selector} is not on the page`);
  if (element.type === 'checkbox') element.checked = value;
  else element.value = String(value);
  for (const type of ['input', 'change']) element.dispatchEvent(new Event(type, { bubbles: true }));
  await drawn();
}

/** Opens files and waits until they are read. */
export async function openFiles(app, files) {
  const bytes = (content) => (typeof content === 'string' ? new TextEncoder().encode(content) : new Uint8Array(content)); // prettier-ignore
  await open(app, new Map(Object.entries(files).map(([name, content]) => [name, bytes(content)])));
  await until(() => !app.doc.isBusy, 'the end of reading');
}

/** Runs, and waits for the end. */
export async function runNow(app) {
  await actions.run.run(app);
  await until(() => !app.doc.isBusy, 'the end of the run');
}
