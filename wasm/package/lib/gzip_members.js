// Decompresses the members of gzip data and checks the checksum and the size of each [RFC 1952].

const step = 1 << 16; // bytes per step, so that extreme compression ratios are noticed early

const table = Uint32Array.from({ length: 256 }, (_, n) => {
  let c = n;
  for (let bit = 0; bit < 8; bit++) c = c & 1 ? 0xedb88320 ^ (c >>> 1) : c >>> 1;
  return c;
});

function crc32(bytes, before) {
  let c = ~before;
  for (let i = 0; i < bytes.length; i++) c = table[(c ^ bytes[i]) & 255] ^ (c >>> 8);
  return ~c >>> 0;
}

const isMember = (packed, at) =>
  packed[at] === 0x1f && packed[at + 1] === 0x8b && packed[at + 2] === 8;

const noHeader = 'invalid gzip data'; // the decoder's message
const least = 20; // minimum size of a member in bytes
const damaged = () => new Error('damaged or cut off');

/**
 * @typedef {{ Gunzip: any, add: (chunk: Uint8Array) => void, pause?: () => Promise<void> }} How
 *   fflate's Gunzip; a function that receives the chunks, and may throw; a function awaited between slices
 */

/**
 * Decompresses consecutive members. Returns the end of the last one.
 * @param {Uint8Array} packed
 * @param {number} first
 * @param {How} how
 */
async function readRun(packed, first, { Gunzip, add, pause }) {
  const view = new DataView(packed.buffer, packed.byteOffset, packed.length);
  let begin = first;
  let crc = 0;
  let size = 0;
  let failure;
  const endsAt = (end) =>
    view.getUint32(end - 8, true) === crc && view.getUint32(end - 4, true) === size % 2 ** 32;
  const decoder = new Gunzip((chunk) => {
    crc = crc32(chunk, crc);
    size += chunk.length;
    try {
      add(chunk);
    } catch (error) {
      failure = error; // an error of the caller, not of the decoder
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
      await pause?.();
    }
  } catch (error) {
    if (failure) throw failure;
    if (error.message !== noHeader) throw damaged();
    isWhole = false; // the data after a member is not a member
  }
  if (isWhole && packed.length >= begin + least && endsAt(packed.length)) return packed.length;
  // The decoder does not say where the last member ended; its checksum and size mark the end.
  for (let end = begin + least; end <= packed.length; end++) if (endsAt(end)) return end;
  throw damaged();
}

/**
 * Decompresses every member. Zeros between members are skipped; data after the last member that is not gzip is ignored.
 * @param {Uint8Array} packed
 * @param {How} how
 * @return {Promise<number>} the number of ignored bytes
 */
export async function readMembers(packed, how) {
  let at = 0;
  if (!isMember(packed, at)) throw damaged();
  while (isMember(packed, at)) {
    at = await readRun(packed, at, how);
    while (packed[at] === 0) at++;
  }
  return packed.length - at;
}
