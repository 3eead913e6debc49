// The worker: one Core, one call at a time. Messages in: { id, method, args, wantsProgress };
// messages out: { id, result }, { id, error } or { id, progress }.

import { createCore, HgpError } from './core.js';

const isBrowser = typeof WorkerGlobalScope !== 'undefined';
const progressInterval = 100; // milliseconds: at most ten reports a second

let core; // a promise

const methods = new Set([
  'load',
  'loadMesh',
  'inspect',
  'surface',
  'readCones',
  'embeddedCones',
  'suggestCones',
  'check',
  'parametrize',
  'verify',
  'write',
]);

/** The buffers of all typed arrays in a result: they move instead of being copied. */
function buffersOf(value, found = new Set()) {
  if (ArrayBuffer.isView(value)) found.add(value.buffer);
  else if (value && typeof value === 'object') {
    for (const part of Object.values(value)) if (typeof part === 'object') buffersOf(part, found);
  }
  return found;
}

function throttled(report) {
  let last = -Infinity;
  return (progress) => {
    const now = performance.now();
    if (now - last >= progressInterval) {
      last = now;
      report(progress);
    }
    return true;
  };
}

async function handle(post, { id, method, args, wantsProgress }) {
  try {
    if (method === 'init') {
      core = createCore({ wasmModule: args[0] });
      await core;
      return;
    }
    const ready = await core;
    if (method === 'ready') return post({ id, result: true }, []);
    if (method === 'warmUp') return ready.warmUp();
    if (!methods.has(method)) {
      throw new HgpError({ code: 'usage', message: `no such call: ${method}` });
    }
    ready.onProgress = wantsProgress
      ? throttled((progress) => post({ id, progress }, []))
      : undefined;
    if (method === 'load') await ready.prepare(args[0]);
    const result = ready[method](...args);
    if (id !== 0) post({ id, result }, [...buffersOf(result)]);
  } catch (error) {
    const { code = 'internal', message = String(error), details } = error;
    const isLost = !(error instanceof HgpError);
    post({ id: isLost ? 0 : id, error: { code, message, ...details } }, []);
  }
}

// Calls wait for one another: the first may still be compiling when the second arrives.
let last = Promise.resolve();
const listen = (post) => (message) => {
  last = last.then(() => handle(post, message));
};

if (isBrowser) {
  const take = listen((message, buffers) => globalThis.postMessage(message, buffers));
  globalThis.addEventListener('message', ({ data }) => take(data));
} else {
  // Not awaited: bundlers that make classic scripts of workers know no `await` at the top.
  import(/* @vite-ignore */ 'node:worker_threads').then(({ parentPort }) => {
    const take = listen((message, buffers) => parentPort.postMessage(message, buffers));
    parentPort.on('message', take);
  });
}
