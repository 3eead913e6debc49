// The platform layer for browsers: workers and the files of this package. node/platform.js exports the
// same names; no file that a browser loads mentions a module of Node.

import { unavailable } from './error.js';

/** Imports a file by URL, so that bundlers do not have to split the worker. */
export const importFile = (url) => import(/* @vite-ignore */ /* webpackIgnore: true */ url.href);

export async function readFile(url) {
  const response = await fetch(url);
  if (!response.ok) throw unavailable(`${url}: HTTP ${response.status}`);
  return response.arrayBuffer();
}

export async function compileFile(url) {
  const response = await fetch(url);
  if (!response.ok) throw unavailable(`${url}: HTTP ${response.status}`);
  // Not every static host serves the content type that streaming compilation requires.
  if (response.headers.get('Content-Type')?.startsWith('application/wasm')) {
    return WebAssembly.compileStreaming(response);
  }
  return WebAssembly.compile(await response.arrayBuffer());
}

const slice = 2 ** 20; // bytes copied per task
const large = 4 * slice;

/** A pause between tasks that is not prolonged in hidden tabs, unlike setTimeout. */
const nextTask = () =>
  new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => resolve(port1.close());
    port2.postMessage(0);
  });

/**
 * Bytes in the form in which they are sent to a worker: large ones as a Blob made slice by slice, because posting an
 * array copies all of it in one task of this thread, and so does reading a file. The copy does not change when the
 * file on disk does. The first slice is copied in a task of its own as well.
 * @param {Uint8Array | Blob} source
 */
export async function packed(source) {
  const isBlob = source instanceof Blob;
  const size = isBlob ? source.size : source.length;
  if (isBlob && size <= large) return new Uint8Array(await source.arrayBuffer());
  if (!isBlob && (size <= large || !(source.buffer instanceof ArrayBuffer))) return source;
  const parts = [];
  for (let at = 0; at < size; at += slice) {
    await nextTask();
    const end = at + slice;
    const part = isBlob ? await source.slice(at, end).arrayBuffer() : source.subarray(at, end);
    parts.push(new Blob([/** @type {BlobPart} */ (part)]));
  }
  return new Blob(parts);
}

/** Starts a worker from another origin, such as a CDN, by a script of the page's origin that imports it. */
function workerAt(url) {
  const isElsewhere = new URL(String(url), location.href).origin !== location.origin;
  if (!isElsewhere) return new Worker(url, { type: 'module' });
  const script = new Blob([`import ${JSON.stringify(String(url))};`], { type: 'text/javascript' });
  const local = URL.createObjectURL(script);
  const worker = new Worker(local, { type: 'module' });
  worker.addEventListener('message', () => URL.revokeObjectURL(local), { once: true });
  return worker;
}

/** Starts a worker and wraps it in a common interface: post, onMessage, onLost, idle, busy, terminate. */
export async function startWorker({ createWorker, workerUrl }, createDefault) {
  let worker;
  if (createWorker) worker = createWorker();
  else if (workerUrl) worker = workerAt(workerUrl);
  else worker = createDefault(workerAt);
  return {
    post: (message) => worker.postMessage(message),
    onMessage: (take) => worker.addEventListener('message', ({ data }) => take(data)),
    onLost: (take) => {
      worker.addEventListener('error', (event) => take(event.message ?? 'script error'));
      worker.addEventListener('messageerror', () => take('unreadable message'));
    },
    idle() {},
    busy() {},
    terminate: () => worker.terminate(),
  };
}
