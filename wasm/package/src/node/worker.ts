// hgp/worker for Node.

import { parentPort } from 'node:worker_threads';
import { serve } from '../lib/worker.js';
import { createCore } from './core.js';

// On the main thread there is no port.
if (parentPort) {
  const port = parentPort;
  port.on(
    'message',
    serve(createCore, (message, transfer) => port.postMessage(message, transfer)),
  );
}

export {};
