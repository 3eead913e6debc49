// hgp for Node, Bun and Deno: every call runs in a worker, can be cancelled and reports progress.

import { Client, type ClientOptions } from '../lib/client.js';
import * as platform from './platform.js';

export { HgpError } from '../lib/error.js';
export { phrase, type Phrases } from '../lib/phrases.js';

export const createClient = (options?: ClientOptions): Promise<Client> =>
  Client.start(platform, options);
