// Compiles a module from the place that the options specify, by default from a file of this package. Each entry names its
// own, so that bundlers take only that along.

import { HgpError, messageOf, unavailable } from './error.js';
import type { InitOptions } from './options.js';
import type { FileReader } from './platform.js';

/** @internal */
export async function compileWith(
  platform: FileReader,
  { wasmModule, wasmBinary, wasmUrl }: InitOptions = {},
  file: () => URL,
  name = 'hgp.wasm',
): Promise<WebAssembly.Module> {
  if (wasmModule) return wasmModule;
  try {
    if (wasmBinary) return await WebAssembly.compile(wasmBinary as BufferSource);
    return await platform.compileFile(wasmUrl ?? file());
  } catch (error) {
    if (error instanceof HgpError) throw error;
    throw unavailable(`${name} could not be loaded: ${messageOf(error)}`, error);
  }
}
