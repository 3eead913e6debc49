// Where the module of the whole package is, in a file of its own: bundlers take along what a file names.

/** @internal */
export const wholeWasm = (): URL => new URL('../hgp.wasm', import.meta.url);
