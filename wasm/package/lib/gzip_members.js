// The members of gzip data, each held to the sum and the size that it states [RFC 1952].

const step = 1 << 16; // what is compressed a thousandfold is noticed early

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

const noHeader = 'invalid gzip data'; // as the decoder says it
const least = 20; // bytes of a member
const damaged = () => new Error('damaged or cut off');

/**
 * @typedef {{ Gunzip: any, add: (chunk: Uint8Array) => void, pause?: () => Promise<void> }} How
 *   fflate's Gunzip; what takes the chunks, and may throw; what is awaited between slices
 */

/**
 * Members without anything between them. Returns where the last one ends.
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
      failure = error; // of the caller, and not of the decoder
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
    isWhole = false; // after a member comes what is none
  }
  if (isWhole && packed.length >= begin + least && endsAt(packed.length)) return packed.length;
  // The decoder does not tell where the last member ended: it did where its sum and its size are.
  for (let end = begin + least; end <= packed.length; end++) if (endsAt(end)) return end;
  throw damaged();
}

/**
 * Decompresses every member. Zeros between members are skipped; behind the last, what is not gzip is ignored.
 * @param {Uint8Array} packed
 * @param {How} how
 * @return {Promise<number>} ignored bytes
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
