// Types that a project has only if it uses the declarations of the DOM or of Node; without them, what is used of them.

/** WebAssembly.Module, if it is declared. */
export type WasmModule = typeof globalThis extends {
  WebAssembly: { Module: { prototype: infer T } };
}
  ? T
  : object;

/** Worker, if it is declared. */
export type WebWorker = typeof globalThis extends { Worker: { prototype: infer T } } ? T : object;

/** URL, if it is declared. */
export type WebUrl = typeof globalThis extends { URL: { prototype: infer T } }
  ? T
  : { readonly href: string };

interface AnyBlob {
  readonly size: number;
  arrayBuffer(): Promise<ArrayBuffer>;
}

/** Blob, if it is declared. */
export type WebBlob = typeof globalThis extends { Blob: { prototype: infer T } } ? T : AnyBlob;

/** File, if it is declared. */
export type WebFile = typeof globalThis extends { File: { prototype: infer T } }
  ? T
  : AnyBlob & { readonly name: string };

/** AbortSignal, if it is declared. */
export type WebSignal = typeof globalThis extends { AbortSignal: { prototype: infer T } }
  ? T
  : { readonly aborted: boolean };
