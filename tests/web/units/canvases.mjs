// Canvases of views without a browser: their graphics card draws nothing, and frames come when a test says so.

import { graphicsCard } from './graphics_stand_in.mjs';

/** What was painted on canvases that are in no window: pictures of markers, which all views share. */
export const painted = [];
const brush = new Proxy({}, { get: (_, name) => (...all) => void painted.push([name, ...all]), set: () => true }); // prettier-ignore
/** A document that has such canvases and nothing else. */
export const paper = { createElement: () => ({ getContext: () => brush }) };

/** What a test looks for among the calls of a graphics card. */
const noted = new Set([
  'bufferSubData',
  'clear',
  'clearColor',
  'drawArrays',
  'drawElements',
  'scissor',
]);

/** A canvas that is shown at (20, 10) of the window, as large as `size` says. */
export class Canvas extends EventTarget {
  style = {};
  dataset = {};
  /** Calls of the card, the oldest first. */
  calls = [];
  #card;
  constructor(width = 200, height = 100) {
    super();
    Object.assign(this, { clientWidth: width, clientHeight: height, width: 1, height: 1 });
    this.ownerDocument = new EventTarget();
    this.root = new EventTarget();
  }
  getRootNode = () => this.root;
  focus() {}
  setPointerCapture() {}
  releasePointerCapture() {}
  getBoundingClientRect() {
    const { clientWidth: width, clientHeight: height } = this;
    return { left: 20, top: 10, right: 20 + width, bottom: 10 + height, width, height };
  }
  getContext(kind, options) {
    if (this.#card) return this.#card;
    this.options = options;
    const { context } = graphicsCard(this, kind);
    const note = (name, all) => this.calls.push([name, ...all]);
    this.#card = new Proxy(context, {
      get(target, name) {
        const value = target[name];
        if (!noted.has(name)) return value;
        return (...all) => {
          note(name, all);
          return value(...all);
        };
      },
    });
    return this.#card;
  }
  /** What the card was told since this was asked for last. */
  taken() {
    return this.calls.splice(0);
  }
}

const isDraw = ([name]) => name.startsWith('draw');
/** How many things were drawn by these calls. */
export const drawsIn = (calls) => calls.filter(isDraw).length;
/** Whether a canvas is empty after these calls. */
export const endsEmpty = (calls) => calls.findLastIndex(([name]) => name === 'clear') > calls.findLastIndex(isDraw); // prettier-ignore

/** Of the last frame: views remember it. */
let time = 0;

/** Runs a test in a window of canvases; afterwards everything is as it was. */
export async function withCanvases(act) {
  const waiting = new Map();
  let last = 0;
  const observed = new Map();
  const own = {
    requestAnimationFrame: (one) => (waiting.set(++last, one), last),
    cancelAnimationFrame: (id) => void waiting.delete(id),
    ResizeObserver: class {
      constructor(one) {
        this.one = one;
      }
      observe(canvas) {
        observed.set(canvas, this.one);
      }
    },
    devicePixelRatio: 1,
    matchMedia: () => ({ matches: true }),
    document: globalThis.document ?? paper,
  };
  const before = Object.fromEntries(Object.keys(own).map((name) => [name, Object.getOwnPropertyDescriptor(globalThis, name)])); // prettier-ignore
  for (const [name, value] of Object.entries(own))
    Object.defineProperty(globalThis, name, { value, writable: true, configurable: true });
  const frame = () => {
    const all = [...waiting.values()];
    waiting.clear();
    time += 16;
    for (const one of all) one(time);
    return all.length;
  };
  /** Frames until none is asked for; how many there were. */
  const rest = (most = 40) => {
    let count = 0;
    while (waiting.size > 0 && count < most) count += Math.sign(frame());
    return count;
  };
  try {
    return await act({ frame, rest, resized: (canvas) => observed.get(canvas)([]) });
  } finally {
    for (const [name, one] of Object.entries(before)) {
      if (one) Object.defineProperty(globalThis, name, one);
      else delete globalThis[name];
    }
  }
}
