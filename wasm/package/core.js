// hgp/core for browsers: the solver without a worker.

import * as platform from './lib/browser.js';
import { compileWith } from './lib/compile.js';
import { coreOf } from './lib/core.js';

export { Core } from './lib/core.js';
export { HgpError } from './lib/error.js';

export const compile = (options) => compileWith(platform, options);

export async function createCore(options) {
  return coreOf(await compile(options), platform);
}
