// Compiles the module from the place that the options specify, by default from the file of this package.

import { HgpError, messageOf, unavailable } from './error.js';
import type { InitOptions } from './options.js';
import type { FileReader } from './platform.js';

/** @internal */
export async function compileWith(
  platform: FileReader,
  { wasmModule, wasmBinary, wasmUrl }: InitOptions = {},
): Promise<WebAssembly.Module> {
  if (wasmModule) return wasmModule;
  try {
    if (wasmBinary) return await WebAssembly.compile(wasmBinary as BufferSource);
    return await platform.compileFile(wasmUrl ?? new URL('../hgp.wasm', import.meta.url));
  } catch (error) {
    if (error instanceof HgpError) throw error;
    throw unavailable(`hgp.wasm could not be loaded: ${messageOf(error)}`, error);
  }
}
