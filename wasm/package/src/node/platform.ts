// The platform layer for Node, Bun and Deno; see lib/platform.ts.

import { readFile as readLocal } from 'node:fs/promises';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { Worker as NodeWorker } from 'node:worker_threads';
import { linkTo } from '../lib/browser.js';
import type { ClientOptions } from '../lib/client.js';
import type { WorkerLink } from '../lib/platform.js';

/** @internal */
export const importFile = (url: URL): Promise<unknown> =>
  import(/* @vite-ignore */ /* webpackIgnore: true */ url.href);

/**
 * A file by URL (file:, http:, https:, as a string as well) or by path.
 * @internal
 */
export async function readFile(place: URL | string): Promise<ArrayBuffer | Uint8Array> {
  const text = String(place);
  const url = /^[a-z][a-z0-9+.-]+:/i.test(text) ? new URL(text) : pathToFileURL(text);
  if (url.protocol === 'file:') return readLocal(fileURLToPath(url));
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url.href}: HTTP ${response.status}`);
  return response.arrayBuffer();
}

/** @internal */
export const compileFile = async (url: URL | string): Promise<WebAssembly.Module> =>
  WebAssembly.compile((await readFile(url)) as BufferSource);

/** @internal */
export const packed = async (blob: Blob): Promise<Uint8Array> =>
  new Uint8Array(await blob.arrayBuffer());

/** @internal */
export function startWorker({ createWorker, workerUrl }: ClientOptions): WorkerLink {
  // The worker must not inherit the script's flags (--input-type, --test …).
  const worker: unknown = createWorker
    ? createWorker()
    : new NodeWorker(workerUrl ? new URL(workerUrl) : new URL('./worker.js', import.meta.url), {
        execArgv: [],
      });
  if (!(worker instanceof NodeWorker)) return linkTo(worker as Worker); // of Bun and Deno
  return {
    post: (message, transfer) => worker.postMessage(message, transfer),
    onMessage: (take) => void worker.on('message', take),
    onLost: (take) => {
      worker.on('error', (error: Error) => take(error.message));
      worker.on('exit', (code) => take(`exit code ${code}`));
    },
    idle: () => worker.unref(),
    busy: () => worker.ref(),
    terminate: () => void worker.terminate(),
  };
}
