// Seamless, provably fold-free texture coordinates with cones of your choice.
// In browsers: every call runs in a worker, can be cancelled and reports progress.

import * as browser from './lib/browser.js';
import { Client, type ClientOptions } from './lib/client.js';

export { HgpError, type HgpFailure } from './lib/error.js';
export type { CallOptions, Client, ClientOptions } from './lib/client.js';
export type { Certificate, CheckReport, ModelInfo, Note, Report } from './lib/documents.js';
export type { Drag } from './lib/drag_handle.js';
export type { Model, UvMap } from './lib/handles.js';
export { phrase, type Phrases } from './lib/phrases.js';
export type * from './lib/options.js';
export type * from './lib/results.js';

/** Creates the worker with the exact expression by which bundlers find it. */
function createDefaultWorker(workerAt: (url: string) => Worker): Worker {
  const { origin, protocol } = new URL(import.meta.url);
  // The package is served from another origin (a CDN), from which browsers do not start workers.
  if (protocol.startsWith('http') && origin !== location.origin) {
    return workerAt(import.meta.url.replace(/[^/]*$/, 'worker.js'));
  }
  return new Worker(new URL('./worker.js', import.meta.url), { type: 'module' });
}

const platform = {
  ...browser,
  startWorker: (options: ClientOptions) => browser.startWorker(options, createDefaultWorker),
};

/** Starts a worker with the solver. */
export const createClient = (options?: ClientOptions): Promise<Client> =>
  Client.start(platform, options);
