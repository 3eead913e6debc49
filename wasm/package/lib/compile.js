// Compiles the module from the place that the options specify, by default from the file of this package.

import { HgpError, unavailable } from './error.js';

/**
 * @param {{ compileFile: (url: string | URL) => Promise<WebAssembly.Module> }} platform
 * @param {import('../core.js').InitOptions} [options]
 */
export async function compileWith(platform, { wasmModule, wasmBinary, wasmUrl } = {}) {
  if (wasmModule) return wasmModule;
  try {
    if (wasmBinary) return await WebAssembly.compile(wasmBinary);
    return await platform.compileFile(wasmUrl ?? new URL('../hgp.wasm', import.meta.url));
  } catch (error) {
    if (error instanceof HgpError) throw error;
    throw unavailable(`hgp.wasm could not be loaded: ${error.message}`, error);
  }
}
