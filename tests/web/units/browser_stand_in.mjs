// A browser for the whole page, of which nothing depends on the machine: a document of happy-dom, a clock that only tests
// advance, a graphics card that takes everything and draws nothing, a database in memory, the geometry worker in this
// thread and the solver in one of Node's. Answers of the solver can be held back, or replaced.

import { existsSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { Worker as NodeWorker } from 'node:worker_threads';
import { Window } from 'happy-dom';
import { graphicsCard } from './graphics_stand_in.mjs';
import { database } from './database_stand_in.mjs';

process.env.TZ = 'UTC';
const root = path.resolve(import.meta.dirname, '../../..');
const built = path.join(root, 'build/package/node/worker.js');
export const skip = existsSync(built)
  ? false
  : 'build/package is not there: build hgp_package first';

/** Of Node, for targets of events that are no elements. */
const NodeEvent = Event;
const real = { setTimeout, setImmediate, clearTimeout, fetch, Date };
const define = (name, value, on = globalThis) =>
  Object.defineProperty(on, name, { value, writable: true, configurable: true });

// The clock. Timers with a delay wait for it; those without run at once, and count as work.
const start = real.Date.UTC(2026, 0, 5, 9);
let clock = 1000;
let working = 0;
let lastTimer = 0;
const timers = new Map();
const frames = new Map();
export const now = () => clock;
define('performance', { now: () => clock, mark() {}, measure() {} });
define('Date', class extends real.Date {
  constructor(...all) {
    if (all.length > 0) super(...all);
    else super(start + clock);
  }
  static now = () => start + clock;
  // Whatever the machine's language.
  toLocaleString = () => `${this.toISOString()} as there`;
  toLocaleTimeString = () => `${this.toISOString().slice(11, 19)} as there`;
  toLocaleDateString = () => `${this.toISOString().slice(0, 10)} as there`;
}); // prettier-ignore
function later(act, delay, repeat, all) {
  const id = ++lastTimer;
  if (delay > 0) timers.set(id, { act: () => act(...all), due: clock + delay, repeat });
  else {
    working += 1;
    const timer = real.setTimeout(() => {
      if (!timers.delete(id)) return;
      working -= 1;
      act(...all);
    });
    timers.set(id, { end: () => (real.clearTimeout(timer), (working -= 1)), due: Infinity });
  }
  return id;
}
function forget(id) {
  timers.get(id)?.end?.();
  timers.delete(id);
}

export const window = new Window({ url: 'https://hgp.example/', width: 1400, height: 900 });
const taken = ['document', 'customElements', 'localStorage', 'location', 'history', 'MutationObserver', 'CSSStyleSheet', 'Event', 'CustomEvent', 'Node', 'Element', 'ShadowRoot', 'Document', 'DocumentFragment', 'Text', 'Comment', 'NodeFilter', 'FileList', 'DataTransfer']; // prettier-ignore
for (const name of Object.getOwnPropertyNames(window)) {
  const isClass = /^(HTML|SVG)\w*Element$|^\w+Event$/.test(name);
  if (isClass || taken.includes(name)) define(name, window[name]);
}
define('window', globalThis);
define('self', globalThis);
for (const name of ['addEventListener', 'removeEventListener', 'dispatchEvent', 'getComputedStyle'])
  define(name, window[name].bind(window));
define('setTimeout', (act, delay = 0, ...all) => later(act, delay, 0, all));
define('setInterval', (act, delay, ...all) => later(act, delay, delay, all));
define('clearTimeout', forget);
define('clearInterval', forget);
define('requestAnimationFrame', (act) => (frames.set(++lastTimer, act), lastTimer));
define('cancelAnimationFrame', (id) => void frames.delete(id));
define('devicePixelRatio', 1);

// The screen: its width, and what its user prefers.
export const screen = { width: 1400, dark: false, still: true };
const queries = new Set();
class Query extends EventTarget {
  constructor(media) {
    super();
    this.media = media;
    queries.add(this);
  }
  get matches() {
    const [, side, pixels] = this.media.match(/(min|max)-width: (\d+)px/) ?? [];
    if (side) return side === 'max' ? screen.width <= pixels : screen.width >= pixels;
    if (this.media.includes('dark')) return screen.dark;
    return this.media.includes('reduced-motion') && screen.still;
  }
}
define('matchMedia', (media) => new Query(media));
export function setScreen(part) {
  const before = [...queries].map((one) => one.matches);
  Object.assign(screen, part);
  [...queries].forEach((one, i) => {
    if (one.matches !== before[i])
      one.dispatchEvent(Object.assign(new NodeEvent('change'), { matches: one.matches }));
  });
}

const observers = new Set();
define('ResizeObserver', class {
  constructor(act) {
    this.act = act;
    observers.add(this);
  }
  observe() {}
  unobserve() {}
  disconnect() {
    observers.delete(this);
  }
}); // prettier-ignore
export const resized = () => observers.forEach(({ act }) => act([]));

// Sizes, which happy-dom does not know: views are beside each other, half the window each.
const isShown = (canvas) => canvas.isConnected && !canvas.closest('[hidden]');
const canvasPrototype = window.HTMLCanvasElement.prototype;
export const viewSize = { width: 600, height: 400 };
const left = ({ id }) => (id === 'map' ? 700 : 50);
for (const side of ['width', 'height'])
  Object.defineProperty(canvasPrototype, `client${side === 'width' ? 'Width' : 'Height'}`, {
    configurable: true,
    get() {
      return isShown(this) ? viewSize[side] : 0;
    },
  });
canvasPrototype.getBoundingClientRect = function box() {
  const { width, height } = viewSize;
  return { left: left(this), top: 80, right: left(this) + width, bottom: 80 + height, width, height }; // prettier-ignore
};
const cards = new WeakMap();
const allCards = new Set();
export const cardOf = (canvas) => cards.get(canvas);
canvasPrototype.getContext = function context(kind, options) {
  if (!cards.has(this)) {
    cards.set(this, Object.assign(graphicsCard(this, kind), { options }));
    allCards.add(cards.get(this));
  }
  return cards.get(this).context;
};
canvasPrototype.toBlob = (done) => done(new Blob(['a picture'], { type: 'image/png' }));
define('createImageBitmap', async (blob) => ({ width: 4, height: 4, size: blob.size, close() {} }));
define('ImageData', class {
  constructor(data, width, height) {
    Object.assign(this, { data, width, height });
  }
}); // prettier-ignore
window.HTMLDialogElement.prototype.showModal = function showModal() {
  this.setAttribute('open', '');
};
for (const name of ['showPopover', 'hidePopover', 'togglePopover'])
  window.HTMLElement.prototype[name] = function popover() {
    this.toggleAttribute('data-popover', name === 'showPopover');
  };
window.HTMLElement.prototype.setPointerCapture = () => undefined;
window.HTMLElement.prototype.releasePointerCapture = () => undefined;
window.HTMLElement.prototype.scrollIntoView = () => undefined;

/** What was given to the user: names and contents of files, and texts of the clipboard. */
export const saved = [];
export const copied = [];
/** The file that the user chooses next. */
export const chosen = { file: undefined };
const urls = new Map();
URL.createObjectURL = (blob) => {
  const url = `blob:hgp/${urls.size}`;
  urls.set(url, blob);
  return url;
};
URL.revokeObjectURL = () => undefined;
window.HTMLAnchorElement.prototype.click = function click() {
  const blob = urls.get(this.href);
  if (blob) saved.push({ name: this.download, blob });
};
window.HTMLInputElement.prototype.click = ((own) =>
  function click() {
    if (this.type !== 'file') return own.call(this);
    Object.defineProperty(this, 'files', { value: chosen.file ? [chosen.file] : [], configurable: true }); // prettier-ignore
    this.dispatchEvent(new Event(chosen.file ? 'change' : 'cancel'));
  })(window.HTMLInputElement.prototype.click);
const clipboard = { writeText: async (text) => void copied.push(text) };
define('navigator', { clipboard, platform: 'test', userAgent: 'test', language: 'en', languages: ['en'], hardwareConcurrency: 2 }); // prettier-ignore
define(
  'indexedDB',
  database((act) => later(act, 0, 0, [])),
);

/** Files that the page's server has, by address. */
export const served = new Map();
define('fetch', async (place) => {
  const url = String(place?.url ?? place);
  if (url.startsWith('file:')) return new Response(readFileSync(new URL(url)));
  if (urls.has(url)) return new Response(urls.get(url));
  const bytes = served.get(url.replace(/^https:\/\/hgp\.example\/|^\.\//, ''));
  return bytes ? new Response(bytes) : new Response('', { status: 404 });
});

/** Counts what a promise waits for as work, until it settles. */
function counted(on, name) {
  const own = on[name];
  on[name] = function call(...all) {
    working += 1;
    const made = own.apply(this, all);
    const end = () => (working -= 1);
    made.then(end, end);
    return made;
  };
}
counted(Blob.prototype, 'arrayBuffer');
counted(Blob.prototype, 'text');
counted(Response.prototype, 'arrayBuffer');
counted(ReadableStreamDefaultReader.prototype, 'read');
counted(globalThis, 'fetch');
counted(Object.getPrototypeOf(crypto.subtle), 'digest');

// The workers. That of the geometry and the validator run in this thread: messages are cloned, what is transferred is lost.
class ThreadWorker extends EventTarget {
  #pending = 0;
  constructor(take, messages) {
    super();
    this.take = take;
    messages.add(this);
    this.end = () => {
      messages.delete(this);
      working -= this.#pending;
      this.#pending = 0;
    };
  }
  postMessage(message, transfer = []) {
    const data = structuredClone(message, { transfer });
    this.#pending += 1;
    working += 1;
    real.setImmediate(() => this.#pending > 0 && this.take.now({ data }));
  }
  receive(data) {
    if (this.#pending === 0) return;
    this.#pending -= 1;
    working -= 1;
    this.dispatchEvent(Object.assign(new NodeEvent('message'), { data }));
    this.onmessage?.({ data });
  }
  terminate() {
    this.end();
  }
}
async function threadOf(source) {
  const [take, workers] = [{}, new Set()];
  const own = [globalThis.addEventListener, globalThis.postMessage];
  const post = (message, { transfer = [] } = {}) => {
    const data = structuredClone(message, { transfer });
    real.setImmediate(() => [...workers].at(-1)?.receive(data));
  };
  define('addEventListener', (_, listener) => (take.now = listener));
  define('postMessage', post);
  await source();
  define('addEventListener', own[0]);
  // Of two workers, each has its own.
  return { post, start: () => new ThreadWorker(take, workers) };
}

/** The solver: what it is asked, and answers that are held back. */
export const solver = {
  isHeld: false,
  held: [],
  asked: [],
  workers: new Set(),
  /** Changes an answer before the page has it. */
  change: undefined,
  /** Gives the page all that was held back. */
  release() {
    this.isHeld = false;
    for (const give of this.held.splice(0)) give();
  },
  /** Answers the call that the solver has. */
  answer(answer) {
    for (const worker of this.workers) worker.give({ id: worker.call, ...answer });
  },
  /** The worker ends by itself. */
  lose(message) {
    for (const worker of this.workers) worker.dispatchEvent(Object.assign(new NodeEvent('error'), { message })); // prettier-ignore
  },
};
class SolverWorker extends EventTarget {
  call = 0;
  method = '';
  isWaiting = false;
  constructor() {
    super();
    solver.workers.add(this);
    this.worker = new NodeWorker(pathToFileURL(built), { execArgv: [] });
    this.worker.on('message', (data) => {
      if (data.progress) return; // how many there are depends on the machine
      const isHeld = solver.isHeld && data.id === this.call && this.method !== 'ready';
      if (!isHeld) return this.give(data);
      // The page waits; nothing else is going on.
      solver.held.push(() => this.give(data));
      this.settle(true);
    });
    this.worker.unref();
  }
  give(data) {
    if (!solver.workers.has(this)) return;
    solver.change?.(data);
    if (data.id === this.call && !data.progress) this.settle();
    this.dispatchEvent(Object.assign(new NodeEvent('message'), { data }));
  }
  settle(isWaiting = false) {
    if (this.call !== 0 && !this.isWaiting) working -= 1;
    if (!isWaiting) this.call = 0;
    this.isWaiting = isWaiting;
  }
  postMessage(message, transfer) {
    if (message.id > 0) {
      [this.call, this.method] = [message.id, message.method];
      working += 1;
      solver.asked.push(message);
    }
    this.worker.postMessage(message, transfer);
  }
  terminate() {
    this.settle();
    solver.workers.delete(this);
    void this.worker.terminate();
  }
}
const threads = {};
define('Worker', function Worker(_, { name } = {}) {
  return name in threads ? threads[name].start() : new SolverWorker();
});
/** Loads what runs in workers, after everything that these need is there. */
export async function startThreads(sources) {
  for (const [name, source] of Object.entries(sources)) {
    threads[name] = await threadOf(source);
  }
  // Both post by the same name: the answer of the geometry has a call.
  const [geometry, validator] = [threads.geometry, threads['glTF validator']];
  define('postMessage', (message, more) => ('call' in message ? geometry : validator).post(message, more)); // prettier-ignore
}

/** Whatever is ready happens; while something is being worked on, without burning time. */
const turn = (isCalm) =>
  new Promise((resolve) => (isCalm ? real.setImmediate(resolve) : real.setTimeout(resolve, 2)));

/** Until something is there whose loading cannot be seen. */
export async function loaded(isThere) {
  const end = real.Date.now() + 60_000;
  while (!isThere() && real.Date.now() < end) await turn(false);
}

/** Until nothing is being worked on; `isFree` tells what else has to end. */
async function quiet(isFree) {
  const end = real.Date.now() + 60_000;
  for (let calm = 0; calm < 40;) {
    await turn(working === 0 && isFree());
    calm = working === 0 && isFree() ? calm + 1 : 0;
    if (real.Date.now() > end) throw new Error('The page does not come to rest.');
  }
}

/** Lets everything happen that happens within some milliseconds of the clock. */
export async function settle(isFree, milliseconds = 1000) {
  const end = clock + milliseconds;
  for (let drawn = 0; ;) {
    await quiet(isFree);
    if (frames.size > 0 && drawn < 40) {
      drawn += 1;
      clock += 16;
      const all = [...frames.values()];
      frames.clear();
      for (const card of allCards) card.isOver = true;
      for (const act of all) act(clock);
      continue;
    }
    const [id, timer] = [...timers].reduce((a, b) => (b[1].due < a[1].due ? b : a), [0, { due: Infinity }]); // prettier-ignore
    if (timer.due > end) break;
    clock = Math.max(clock, timer.due);
    if (timer.repeat) timer.due += timer.repeat;
    else timers.delete(id);
    timer.act();
  }
  clock = Math.max(clock, end);
}
