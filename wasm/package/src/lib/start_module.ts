// Starts a module of Emscripten that has been compiled already, for the whole package and for hgp/lite.

import { messageOf, unavailable } from './error.js';

/** Emscripten's function that makes an instance of a module. */
export type CreateModule<Module> = (options: {
  instantiateWasm(
    imports: WebAssembly.Imports,
    receive: (instance: WebAssembly.Instance) => void,
  ): object;
  print(): void;
  printErr(): void;
  onAbort(reason: unknown): void;
}) => Promise<Module>;

/**
 * Emscripten's glue code does not fetch: it receives the compiled module, so that the same file works in browsers, workers
 * and Node. If instantiation fails, it would wait forever; this rejects with `wasm-unavailable`.
 */
export async function startModule<Module>(
  create: CreateModule<Module>,
  wasmModule: WebAssembly.Module,
): Promise<Module> {
  try {
    return await new Promise<Module>((resolve, reject) => {
      create({
        instantiateWasm(imports, receive) {
          WebAssembly.instantiate(wasmModule, imports).then(receive).catch(reject);
          return {};
        },
        print: () => undefined,
        printErr: () => undefined,
        onAbort: reject,
      }).then(resolve, reject);
    });
  } catch (error) {
    throw unavailable(`The solver could not be started: ${messageOf(error)}`, error);
  }
}
