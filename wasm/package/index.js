// hgp for browsers: every call runs in a worker, can be cancelled and reports progress.

import * as browser from './lib/browser.js';
import { startClient } from './lib/client.js';

export { HgpError } from './lib/error.js';

/** Bundlers find the worker by exactly this expression. */
function createDefaultWorker(workerAt) {
  const { origin, protocol } = new URL(import.meta.url);
  // Served as it is from another origin (a CDN), which browsers start no worker of.
  if (protocol.startsWith('http') && origin !== location.origin) {
    return workerAt(import.meta.url.replace(/[^/]*$/, 'worker.js'));
  }
  return new Worker(new URL('./worker.js', import.meta.url), { type: 'module' });
}

const platform = {
  ...browser,
  startWorker: (options) => browser.startWorker(options, createDefaultWorker),
};

export const createClient = (options) => startClient(platform, options);
