// hgp/lite for Node, Bun and Deno.

import { compileWith } from '../lib/compile.js';
import { Lite } from '../lib/lite.js';
import type { InitOptions } from '../lib/options.js';
import * as platform from './platform.js';

export { HgpError } from '../lib/error.js';
export { Lite } from '../lib/lite.js';

const liteWasm = (): URL => new URL('../hgp-lite.wasm', import.meta.url);

export const createLite = async (options?: InitOptions): Promise<Lite> =>
  Lite.make(await compileWith(platform, options, liteWasm, 'hgp-lite.wasm'));
