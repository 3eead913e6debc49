// The platform layer for Node, Bun and Deno; see lib/browser.js.

import { readFile as readLocal } from 'node:fs/promises';
import { Worker } from 'node:worker_threads';
import { fileURLToPath, pathToFileURL } from 'node:url';

export const importFile = (url) => import(/* @vite-ignore */ /* webpackIgnore: true */ url.href);

/** A file by URL (file:, http:, https:, as a string as well) or by path. */
export async function readFile(place) {
  const text = String(place);
  const url = /^[a-z][a-z0-9+.-]+:/i.test(text) ? new URL(text) : pathToFileURL(text);
  if (url.protocol === 'file:') return readLocal(fileURLToPath(url));
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url}: HTTP ${response.status}`);
  return response.arrayBuffer();
}

export const compileFile = async (url) => WebAssembly.compile(await readFile(url));

/** Starts a worker and wraps it in a common interface: post, onMessage, onLost, idle, busy, terminate. */
export async function startWorker({ createWorker, workerUrl }) {
  // The worker must not inherit the script's flags (--input-type, --test …).
  const worker = createWorker
    ? createWorker()
    : new Worker(workerUrl ? new URL(workerUrl) : new URL('./worker.js', import.meta.url), {
        execArgv: [],
      });
  if (!(worker instanceof Worker)) return faceOfWebWorker(worker);
  return {
    post: (message) => worker.postMessage(message),
    onMessage: (take) => worker.on('message', take),
    onLost: (take) => {
      worker.on('error', (error) => take(error.message));
      worker.on('exit', (code) => take(`exit code ${code}`));
    },
    // A waiting worker must not keep a finished script alive.
    idle: () => worker.unref(),
    busy: () => worker.ref(),
    terminate: () => void worker.terminate(),
  };
}

/** The same interface for the web workers of Bun and Deno. */
const faceOfWebWorker = (worker) => ({
  post: (message) => worker.postMessage(message),
  onMessage: (take) => worker.addEventListener('message', ({ data }) => take(data)),
  onLost: (take) => worker.addEventListener('error', (event) => take(event.message)),
  idle() {},
  busy() {},
  terminate: () => worker.terminate(),
});
