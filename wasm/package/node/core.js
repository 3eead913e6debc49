// hgp/core for Node: the solver without a worker.

import { compileWith } from '../lib/compile.js';
import { coreOf } from '../lib/core.js';
import * as platform from './platform.js';

export { Core } from '../lib/core.js';
export { HgpError } from '../lib/error.js';

export const compile = (options) => compileWith(platform, options);

export async function createCore(options) {
  return coreOf(await compile(options), platform);
}
