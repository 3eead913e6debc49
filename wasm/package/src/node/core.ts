// hgp/core for Node: the solver without a worker.

import { compileWith } from '../lib/compile.js';
import { Core } from '../lib/core.js';
import type { WasmModule } from '../lib/globals.js';
import type { InitOptions } from '../lib/options.js';
import * as platform from './platform.js';
import { wholeWasm } from '../lib/whole_wasm.js';

export { Core } from '../lib/core.js';
export { CoreMap } from '../lib/core_map.js';
export { CoreModel } from '../lib/core_model.js';
export { CoreDrag } from '../lib/drag.js';
export { HgpError } from '../lib/error.js';
export { phrase, type Phrases } from '../lib/phrases.js';

export const compile = (options?: InitOptions): Promise<WasmModule> =>
  compileWith(platform, options, wholeWasm);

export const createCore = async (options?: InitOptions): Promise<Core> =>
  Core.make(await compileWith(platform, options, wholeWasm), platform);
