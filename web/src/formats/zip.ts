// Unpacks ZIP files while they are read, and stops as soon as the limit on bytes is exceeded.

import { Unzip, UnzipInflate } from 'fflate';

/** What an archive may unpack to: bytes, bytes for each of its own, files. */
const limits = { bytes: 2 ** 30, ratio: 200, entries: 10_000 };

/** Bytes per call: the reader recurses once for every file that begins in them. */
const sliceSize = 16384;

function isSafe(name: string): boolean {
  return !/^[/\\]|^[a-z]:|\\|\0/i.test(name) && !name.split('/').includes('..');
}

export async function unzip(archive: Blob, caps = limits): Promise<Map<string, Uint8Array>> {
  const found = new Map<string, Uint8Array>();
  let total = 0;
  let entries = 0;
  let failure: Error | undefined;
  const fail = (message: string): void => {
    failure ??= new Error(message);
  };
  const reader = new Unzip((entry) => {
    if (failure || entry.name.endsWith('/')) return;
    if (++entries > caps.entries) return fail(`This ZIP has more than ${caps.entries} files.`);
    if (!isSafe(entry.name))
      return fail(`This ZIP contains a file outside its folder: ${entry.name}`);
    if (/\.zip$/i.test(entry.name)) return; // nested archives are ignored
    const chunks: Uint8Array[] = [];
    let size = 0;
    entry.ondata = (error, chunk, isLast) => {
      if (error) return fail(`${entry.name} cannot be unpacked: ${error.message}`);
      size += chunk.length;
      total += chunk.length;
      if (total > caps.bytes || total > caps.ratio * Math.max(archive.size, 4096))
        return fail('This ZIP unpacks to far more than it should. Not loaded.');
      chunks.push(chunk);
      if (!isLast) return;
      const bytes = new Uint8Array(size);
      let at = 0;
      for (const part of chunks) {
        bytes.set(part, at);
        at += part.length;
      }
      found.set(entry.name, bytes);
    };
    entry.start();
  });
  reader.register(UnzipInflate);
  const stream = archive.stream().getReader();
  for (;;) {
    const { done, value } = await stream.read();
    try {
      for (let at = 0; value && at < value.length && !failure; at += sliceSize) {
        reader.push(value.subarray(at, at + sliceSize));
      }
      if (done) reader.push(new Uint8Array(0), true);
    } catch (error) {
      fail(`This ZIP cannot be read: ${(error as Error).message}`);
    }
    if (failure) {
      await stream.cancel();
      throw failure;
    }
    if (done) return found;
  }
}
