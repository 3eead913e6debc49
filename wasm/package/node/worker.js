// hgp/worker for Node.

import { parentPort } from 'node:worker_threads';
import { serve } from '../lib/worker.js';
import { createCore } from './core.js';

// On the main thread there is no port.
if (parentPort) {
  const port = parentPort;
  const take = serve(createCore, (message, buffers) => port.postMessage(message, buffers));
  port.on('message', take);
}
