// The platform layer for browsers: workers and the files of this package. No file that a browser loads mentions a
// module of Node.

import type { ClientOptions } from './client.js';
import { unavailable } from './error.js';
import type { WorkerLink } from './platform.js';

/**
 * What a decoder of this package exports. Where a bundler made a script of it, which has no exports, what it registered
 * under its own name (wasm/decoders.mjs).
 * @internal
 */
export async function importFile(url: URL): Promise<unknown> {
  const imported = (await import(/* @vite-ignore */ /* webpackIgnore: true */ url.href)) as object;
  if (Object.keys(imported).length > 0) return imported;
  const name = url.pathname.replace(/^.*\//, '').replace(/\..*$/, '');
  const registered = Reflect.get(globalThis, Symbol.for('hgp.decoders')) as
    Record<string, unknown> | undefined;
  return registered?.[name];
}

/** @internal */
export async function readFile(url: URL): Promise<ArrayBuffer> {
  const response = await fetch(url);
  if (!response.ok) throw unavailable(`${url.href}: HTTP ${response.status}`);
  return response.arrayBuffer();
}

/** @internal */
export async function compileFile(url: URL | string): Promise<WebAssembly.Module> {
  const response = await fetch(url);
  if (!response.ok) throw unavailable(`${String(url)}: HTTP ${response.status}`);
  // Not every static host serves the content type that streaming compilation requires.
  if (response.headers.get('Content-Type')?.startsWith('application/wasm')) {
    return WebAssembly.compileStreaming(response);
  }
  return WebAssembly.compile(await response.arrayBuffer());
}

const slice = 2 ** 20; // bytes copied per task
const large = 4 * slice;

/** A pause between tasks that is not prolonged in hidden tabs, unlike setTimeout. */
const nextTask = (): Promise<void> =>
  new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(0);
  });

/**
 * A file in the form in which it is sent to a worker: a large one as a Blob made slice by slice, because reading it at
 * once copies all of it in one task of this thread, and so does posting an array. The copy does not change when the
 * file on disk does. The first slice is copied in a task of its own as well.
 * @internal
 */
export async function packed(blob: Blob): Promise<Uint8Array | Blob> {
  if (blob.size <= large) return new Uint8Array(await blob.arrayBuffer());
  const parts: Blob[] = [];
  for (let at = 0; at < blob.size; at += slice) {
    await nextTask();
    parts.push(new Blob([await blob.slice(at, at + slice).arrayBuffer()]));
  }
  return new Blob(parts);
}

/** Starts a worker from another origin, such as a CDN, by a script of the page's origin that imports it. */
function workerAt(url: string | URL): Worker {
  const isElsewhere = new URL(String(url), location.href).origin !== location.origin;
  if (!isElsewhere) return new Worker(url, { type: 'module' });
  const script = new Blob([`import ${JSON.stringify(String(url))};`], { type: 'text/javascript' });
  const local = URL.createObjectURL(script);
  const worker = new Worker(local, { type: 'module' });
  worker.addEventListener('message', () => URL.revokeObjectURL(local), { once: true });
  return worker;
}

/**
 * Wraps a web worker.
 * @internal
 */
export const linkTo = (worker: Worker): WorkerLink => ({
  post: (message, transfer) => worker.postMessage(message, transfer),
  onMessage: (take) =>
    worker.addEventListener('message', ({ data }: MessageEvent<unknown>) => take(data)),
  onLost: (take) => {
    worker.addEventListener('error', ({ message }: Partial<ErrorEvent>) =>
      take(message ?? 'script error'),
    );
    worker.addEventListener('messageerror', () => take('unreadable message'));
  },
  idle: () => undefined,
  busy: () => undefined,
  terminate: () => worker.terminate(),
});

/** @internal */
export function startWorker(
  { createWorker, workerUrl }: ClientOptions,
  createDefault: (at: typeof workerAt) => Worker,
): WorkerLink {
  if (createWorker) return linkTo(createWorker());
  return linkTo(workerUrl ? workerAt(workerUrl) : createDefault(workerAt));
}
