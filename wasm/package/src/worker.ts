// The worker's script for browsers has no exports; give its URL to `createWorker` where a bundler or a
// Content-Security-Policy needs to know it: new Worker(url, { type: 'module' }).

import { createCore } from './core.js';
import { serve } from './lib/worker.js';

if ('WorkerGlobalScope' in globalThis) {
  const take = serve(createCore, (message, transfer) =>
    globalThis.postMessage(message, { transfer }),
  );
  globalThis.addEventListener('message', ({ data }: MessageEvent<unknown>) => take(data));
}

export {};
