// The solver itself, synchronous: for use inside your own worker.

import * as platform from './lib/browser.js';
import { compileWith } from './lib/compile.js';
import { Core } from './lib/core.js';
import type { WasmModule } from './lib/globals.js';
import type { InitOptions } from './lib/options.js';
import { wholeWasm } from './lib/whole_wasm.js';

export { Core } from './lib/core.js';
export { CoreMap } from './lib/core_map.js';
export { CoreModel } from './lib/core_model.js';
export { CoreDrag } from './lib/drag.js';
export { HgpError, type HgpFailure } from './lib/error.js';
export type { Certificate, CheckReport, ModelInfo, Note, Report } from './lib/documents.js';
export { phrase, type Phrases } from './lib/phrases.js';
export type * from './lib/options.js';
export type * from './lib/results.js';

/** Compiles hgp.wasm, for several cores or workers. */
export const compile = (options?: InitOptions): Promise<WasmModule> =>
  compileWith(platform, options, wholeWasm);

export const createCore = async (options?: InitOptions): Promise<Core> =>
  Core.make(await compileWith(platform, options, wholeWasm), platform);
