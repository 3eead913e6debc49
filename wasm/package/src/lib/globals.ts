// Types that a project has only if it uses the DOM's declarations.

/** WebAssembly.Module, if it is declared. */
export type WasmModule = typeof globalThis extends {
  WebAssembly: { Module: { prototype: infer T } };
}
  ? T
  : object;

/** Worker, if it is declared. */
export type WebWorker = typeof globalThis extends { Worker: { prototype: infer T } } ? T : object;
