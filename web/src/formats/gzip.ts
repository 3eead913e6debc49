// Unpacks gzip while it is read, and stops as soon as the limit on bytes is exceeded.

import { Gunzip } from 'fflate';
import { readMembers } from 'hgp/gzip';

const caps = { bytes: 2 ** 30, ratio: 200 };
const longestTask = 20;
const tooLarge = 'This gzip file unpacks to far more than it should. Not loaded.';

const ignoredBehind = new WeakMap<Blob | Uint8Array, number>();

/** Collects chunks, and throws if they exceed the limit. */
function collector(packed: number): { add: (chunk: Uint8Array) => void; all: () => Uint8Array } {
  const chunks: Uint8Array[] = [];
  const max = Math.min(caps.bytes, caps.ratio * Math.max(packed, 4096));
  let size = 0;
  return {
    add(chunk) {
      size += chunk.length;
      if (size > max) throw new RangeError(tooLarge);
      chunks.push(chunk);
    },
    all() {
      const bytes = new Uint8Array(size);
      let at = 0;
      for (const chunk of chunks) {
        bytes.set(chunk, at);
        at += chunk.length;
      }
      return bytes;
    },
  };
}

const endsWith = (packed: Uint8Array, bytes: Uint8Array): Uint8Array | undefined =>
  new DataView(packed.buffer).getUint32(packed.length - 4, true) === bytes.length
    ? bytes
    : undefined;

/**
 * Unpacks with the browser's own decoder, which verifies the checksum but reads only one member: further bytes are an
 * error in some engines and ignored in others. Undefined if the file does not end with the size of the result.
 */
async function oneMember(packed: Uint8Array): Promise<Uint8Array | undefined> {
  const { add, all } = collector(packed.length);
  const source = new Blob([packed as BlobPart]).stream();
  const stream = source.pipeThrough(new DecompressionStream('gzip')).getReader();
  try {
    for (;;) {
      const { done, value } = await stream.read();
      if (!done) add(value);
      else return endsWith(packed, all());
    }
  } finally {
    void stream.cancel().catch(() => {});
  }
}

/** Unpacks several members, or a file with bytes after the last one, in short tasks. */
async function severalMembers(packed: Uint8Array): Promise<Uint8Array> {
  const { add, all } = collector(packed.length);
  let begin = performance.now();
  const pause = async (): Promise<void> => {
    if (performance.now() - begin < longestTask) return;
    await new Promise((resolve) => setTimeout(resolve));
    begin = performance.now();
  };
  const ignored = await readMembers(packed, { Gunzip, add, pause });
  const bytes = all();
  ignoredBehind.set(bytes, ignored);
  return bytes;
}

/** The number of bytes after the gzip data from which a file was unpacked. */
export const ignoredBytes = (file: Blob | Uint8Array | undefined): number =>
  (file && ignoredBehind.get(file)) ?? 0;

export async function gunzip(file: Blob): Promise<Uint8Array> {
  const packed = new Uint8Array(await file.arrayBuffer());
  try {
    const bytes = await oneMember(packed);
    if (bytes) return bytes;
  } catch (failure) {
    if (failure instanceof RangeError) throw failure;
  }
  try {
    return await severalMembers(packed);
  } catch (failure) {
    if (failure instanceof RangeError) throw failure;
    throw new Error('This gzip file is damaged or cut off.');
  }
}
