// gzip, unpacked while it is read and stopped as soon as it asks for too much.

import { Gunzip } from 'fflate';

const caps = { bytes: 2 ** 30, ratio: 200 };
const sliceSize = 2 ** 16; // what is compressed a thousandfold is noticed early

const noHeader = 'invalid gzip data'; // as the decoder says it
const tooLarge = 'This gzip file unpacks to far more than it should. Not loaded.';

/** Collects chunks, and throws once there are too many of them. */
function collector(packed: number): { add(chunk: Uint8Array): void; all(): Uint8Array } {
  const chunks: Uint8Array[] = [];
  const most = Math.min(caps.bytes, caps.ratio * Math.max(packed, 4096));
  let size = 0;
  return {
    add(chunk) {
      size += chunk.length;
      if (size > most) throw new RangeError(tooLarge);
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

/** The browser's own decoder checks the sum at the end, but takes one member and nothing after it. */
async function oneMember(packed: Uint8Array): Promise<Uint8Array> {
  const { add, all } = collector(packed.length);
  const source = new Blob([packed as BlobPart]).stream();
  const stream = source.pipeThrough(new DecompressionStream('gzip')).getReader();
  try {
    for (;;) {
      const { done, value } = await stream.read();
      if (done) return all();
      add(value);
    }
  } finally {
    void stream.cancel().catch(() => {});
  }
}

/**
 * Of several members, or with padding behind the last: all there are. Nothing where there is one and
 * nothing behind it, for that the browser should have taken.
 */
function severalMembers(packed: Uint8Array): Uint8Array | undefined {
  const { add, all } = collector(packed.length);
  let isMore = false;
  const reader = new Gunzip((chunk) => add(chunk));
  reader.onmember = () => (isMore = true);
  try {
    for (let at = 0; at < packed.length; at += sliceSize) {
      reader.push(packed.subarray(at, at + sliceSize), at + sliceSize >= packed.length);
    }
  } catch (error) {
    if ((error as Error).message !== noHeader) throw error;
    isMore = true; // after a whole member comes what is none
  }
  const bytes = all();
  return isMore && bytes.length > 0 ? bytes : undefined;
}

export async function gunzip(file: Blob): Promise<Uint8Array> {
  const packed = new Uint8Array(await file.arrayBuffer());
  let bytes: Uint8Array | undefined;
  try {
    return await oneMember(packed);
  } catch (failure) {
    if (failure instanceof RangeError) throw failure;
  }
  try {
    bytes = severalMembers(packed);
  } catch (failure) {
    if (failure instanceof RangeError) throw failure;
  }
  if (!bytes) throw new Error('This gzip file is damaged or cut off.');
  return bytes;
}
