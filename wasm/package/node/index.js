// hgp for Node, Bun and Deno: every call runs in a worker, can be cancelled and reports progress.

import { startClient } from '../lib/client.js';
import * as platform from './platform.js';

export { HgpError } from '../lib/error.js';

export const createClient = (options) => startClient(platform, options);
