// Prints the download size and start-up time of the package, and whether they exceed the documented limits, which
// the package's tests enforce.

import { readFileSync } from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { brotliCompressSync } from 'node:zlib';

export const limits = { raw: 2.3e6, brotli: 650e3, instantiation: 100, lite: 1.1e6 };

/** Bytes of hgp.wasm, raw and compressed, and the milliseconds from its bytes to a first call. */
export async function measure(folder) {
  const wasmBinary = readFileSync(path.join(folder, 'hgp.wasm'));
  const { createCore } = await import(pathToFileURL(path.join(folder, 'node/core.js')));
  let instantiation = Infinity;
  for (let i = 0; i < 3; i++) {
    const begin = performance.now();
    await createCore({ wasmBinary });
    instantiation = Math.min(instantiation, performance.now() - begin);
  }
  const brotli = brotliCompressSync(wasmBinary).length;
  return { raw: wasmBinary.length, brotli, instantiation };
}

if (import.meta.filename === process.argv[1]) {
  const { raw, brotli, instantiation } = await measure(path.resolve(process.argv[2]));
  const kilobytes = (bytes) => `${(bytes / 1e3).toFixed(0)} kB`;
  console.log(
    `hgp.wasm: ${kilobytes(raw)} (limit ${kilobytes(limits.raw)}), ${kilobytes(brotli)} with brotli ` +
      `(limit ${kilobytes(limits.brotli)}), instantiated in ${instantiation.toFixed(0)} ms`,
  );
  if (raw > limits.raw || brotli > limits.brotli) console.error('hgp.wasm is over its limit');
  const lite = readFileSync(path.join(process.argv[2], 'hgp-lite.wasm')).length;
  console.log(`hgp-lite.wasm: ${kilobytes(lite)} (limit ${kilobytes(limits.lite)})`);
}
