/// <reference types="vite/client" />
declare module 'hgp/worker?worker&url' {
  const url: string;
  export default url;
}
declare module 'hgp/lib/gzip_members.js' {
  interface Reading {
    Gunzip: typeof import('fflate').Gunzip;
    add(chunk: Uint8Array): void;
    pause?(): Promise<void>;
  }
  /** Returns how many bytes after the last member are ignored. */
  export function readMembers(packed: Uint8Array, how: Reading): Promise<number>;
}
declare module 'virtual:examples' {
  export type Example = import('../examples.mjs').Example;
  export const examples: Example[];
}
