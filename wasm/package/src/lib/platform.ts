// What differs between browsers and Node: how files of this package are read, and workers. ./browser.ts and
// ../node/platform.ts implement it.

import type { ClientOptions } from './client.js';

/** @internal */
export interface FileReader {
  /** Imports a file by URL, so that bundlers do not have to split the worker. */
  importFile: (url: URL) => Promise<unknown>;
  readFile: (url: URL) => Promise<ArrayBuffer | Uint8Array>;
  compileFile: (url: URL | string) => Promise<WebAssembly.Module>;
}

/** @internal */
export interface WorkerLink {
  post(message: unknown, transfer: ArrayBuffer[]): void;
  onMessage(take: (message: unknown) => void): void;
  onLost(take: (reason: string) => void): void;
  /** A waiting worker must not keep a finished script alive. */
  idle(): void;
  busy(): void;
  terminate(): void;
}

/** @internal */
export interface Platform extends FileReader {
  /** The content of a Blob in the form in which it is sent to a worker, independent of the file on disk. */
  packed: (blob: Blob) => Promise<Uint8Array | Blob>;
  startWorker: (options: ClientOptions) => Promise<WorkerLink> | WorkerLink;
}
