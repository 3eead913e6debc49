// hgp for browsers: every call runs in a worker, can be cancelled and reports progress.

import * as browser from './lib/browser.js';
import { startClient } from './lib/client.js';

export { HgpError } from './lib/error.js';

/** Creates the worker with the exact expression by which bundlers find it. */
function createDefaultWorker(workerAt) {
  const { origin, protocol } = new URL(import.meta.url);
  // The package is served from another origin (a CDN), from which browsers do not start workers.
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
