// Decompresses the members of gzip data and checks the checksum and the size of each [RFC 1952].

const step = 1 << 16; // bytes per step, so that extreme compression ratios are noticed early

const table = Uint32Array.from({ length: 256 }, (_, n) => {
  let c = n;
  for (let bit = 0; bit < 8; bit++) c = c & 1 ? 0xedb88320 ^ (c >>> 1) : c >>> 1;
  return c;
});

function crc32(bytes: Uint8Array, before: number): number {
  let c = ~before;
  for (let i = 0; i < bytes.length; i++) c = table[(c ^ bytes[i]) & 255] ^ (c >>> 8);
  return ~c >>> 0;
}

const isMember = (packed: Uint8Array, at: number): boolean =>
  packed[at] === 0x1f && packed[at + 1] === 0x8b && packed[at + 2] === 8;

const noHeader = 'invalid gzip data'; // the decoder's message
const minBytes = 20; // of a member
const damaged = (): Error => new Error('damaged or cut off');

/** fflate's streaming decoder. */
export interface Gunzip {
  push(chunk: Uint8Array, isLast: boolean): void;
  onmember?: (offset: number) => void;
}

export interface HowToUnpack {
  Gunzip: new (take: (chunk: Uint8Array) => void) => Gunzip;
  /** Receives the chunks, and may throw. */
  add: (chunk: Uint8Array) => void;
  /** Awaited between slices. */
  pause?: () => Promise<void>;
}

/** Decompresses consecutive members. Returns the end of the last one. */
async function readRun(packed: Uint8Array, first: number, how: HowToUnpack): Promise<number> {
  const view = new DataView(packed.buffer, packed.byteOffset, packed.length);
  let begin = first;
  let crc = 0;
  let size = 0;
  const failures: unknown[] = [];
  const endsAt = (end: number): boolean =>
    view.getUint32(end - 8, true) === crc && view.getUint32(end - 4, true) === size % 2 ** 32;
  const decoder = new how.Gunzip((chunk) => {
    crc = crc32(chunk, crc);
    size += chunk.length;
    try {
      how.add(chunk);
    } catch (error) {
      failures.push(error); // of the caller, not of the decoder
      throw error;
    }
  });
  decoder.onmember = (offset) => {
    begin = first + offset;
    if (!endsAt(begin)) throw damaged();
    crc = size = 0;
  };
  let isWhole = true;
  try {
    for (let at = first; at < packed.length; at += step) {
      decoder.push(packed.subarray(at, at + step), at + step >= packed.length);
      await how.pause?.();
    }
  } catch (error) {
    if (failures.length > 0) throw failures[0];
    if ((error as Error).message !== noHeader) throw damaged();
    isWhole = false; // the data after a member is not a member
  }
  if (isWhole && packed.length >= begin + minBytes && endsAt(packed.length)) return packed.length;
  // The decoder does not say where the last member ended; its checksum and size mark the end.
  for (let end = begin + minBytes; end <= packed.length; end++) if (endsAt(end)) return end;
  throw damaged();
}

/**
 * Decompresses every member. Zeros between members are skipped; data after the last member that is not gzip is ignored.
 * @return the number of ignored bytes
 */
export async function readMembers(packed: Uint8Array, how: HowToUnpack): Promise<number> {
  let at = 0;
  if (!isMember(packed, at)) throw damaged();
  while (isMember(packed, at)) {
    at = await readRun(packed, at, how);
    while (packed[at] === 0) at++;
  }
  return packed.length - at;
}
