// hgp/worker for browsers.

import { createCore } from './core.js';
import { serve } from './lib/worker.js';

if ('WorkerGlobalScope' in globalThis) {
  const take = serve(createCore, (message, buffers) => globalThis.postMessage(message, buffers));
  globalThis.addEventListener('message', ({ data }) => take(data));
}
