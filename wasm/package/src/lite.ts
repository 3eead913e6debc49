// hgp/lite: maps and verdicts of arrays, synchronously, with a smaller module.

import * as platform from './lib/browser.js';
import { compileWith } from './lib/compile.js';
import { Lite } from './lib/lite.js';
import type { InitOptions } from './lib/options.js';

export { HgpError, type HgpFailure } from './lib/error.js';
export { Lite } from './lib/lite.js';
export type * from './lib/lite.js';
export type { InitOptions } from './lib/options.js';
export type { Progress } from './lib/results.js';

const liteWasm = (): URL => new URL('./hgp-lite.wasm', import.meta.url);

/** Compiles hgp-lite.wasm and makes a solver. */
export const createLite = async (options?: InitOptions): Promise<Lite> =>
  Lite.make(await compileWith(platform, options, liteWasm, 'hgp-lite.wasm'));
