// Prints what a visitor downloads, and says when it is more than was promised (the package's tests insist).

import { readFileSync } from 'node:fs';
import path from 'node:path';
import { brotliCompressSync } from 'node:zlib';

const limits = { raw: 1.5 * 2 ** 20, brotli: 450 * 1024 };
const wasm = readFileSync(path.join(process.argv[2], 'hgp.wasm'));
const sizes = { raw: wasm.length, brotli: brotliCompressSync(wasm).length };
const kib = (bytes) => `${Math.round(bytes / 1024)} KiB`;
console.log(`hgp.wasm: ${kib(sizes.raw)}, ${kib(sizes.brotli)} with brotli`);
for (const [kind, limit] of Object.entries(limits)) {
  if (sizes[kind] > limit) {
    console.error(`hgp.wasm is over its limit of ${kib(limit)} (${kind})`);
  }
}
