// Decompresses gzip, including all members, up to a limit.

import { HgpError } from './error.js';
import { readMembers } from './gzip_members.js';

const isGzip = (bytes) => bytes.length > 2 && bytes[0] === 0x1f && bytes[1] === 0x8b;

const defaultLimit = 2 ** 31; // bytes, as in the solver

/** The files, with gzip decompressed and .gz removed from names; and notes. */
export async function decompressed({ main, files }, limit = defaultLimit, platform) {
  if (![...files.values()].some(isGzip)) return { main, files };
  const plain = new Map();
  const notes = [];
  let plainMain = main;
  for (const [name, bytes] of files) {
    const isCompressed = isGzip(bytes);
    const plainName = isCompressed ? name.replace(/\.gz$/i, '') : name;
    plain.set(plainName, isCompressed ? await gunzip(bytes, limit, platform, notes) : bytes);
    if (name === main) plainMain = plainName;
  }
  return { main: plainMain, files: plain, notes };
}

/** Decompresses with fflate's streaming decoder, which is loaded on first use. */
async function gunzip(bytes, limit, platform, notes) {
  const { Gunzip } = await platform.importFile(new URL('../decoders/fflate.js', import.meta.url));
  const chunks = [];
  let size = 0;
  const add = (chunk) => {
    size += chunk.length;
    if (size > limit) {
      const message = `The file is larger than ${limit} bytes when decompressed (limits.bytes).`;
      throw new HgpError({ code: 'limit', message });
    }
    chunks.push(chunk);
  };
  try {
    const ignored = await readMembers(bytes, { Gunzip, add });
    if (ignored > 0)
      notes.push(`ignored: ${ignored} byte${ignored === 1 ? '' : 's'} after the gzip data`);
  } catch (error) {
    if (error instanceof HgpError) throw error;
    const message = `The gzip data are ${error.message}.`;
    throw new HgpError({ code: 'malformed', message });
  }
  const all = new Uint8Array(size);
  let at = 0;
  for (const chunk of chunks) {
    all.set(chunk, at);
    at += chunk.length;
  }
  return all;
}
