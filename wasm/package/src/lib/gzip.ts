// Decompresses gzip, including all members, up to a limit.

import { HgpError, messageOf } from './error.js';
import { readMembers, type HowToUnpack } from './gzip_members.js';
import type { Note } from './documents.js';
import type { CoreFiles } from './options.js';
import type { FileReader } from './platform.js';

const isGzip = (bytes: Uint8Array): boolean =>
  bytes.length > 2 && bytes[0] === 0x1f && bytes[1] === 0x8b;

const defaultLimit = 2 ** 31; // bytes, as in the solver

/**
 * The files, with gzip decompressed and .gz removed from names; and notes.
 * @internal
 */
export async function decompressed(
  { main, files }: CoreFiles,
  limit: number | undefined,
  platform: FileReader,
): Promise<CoreFiles> {
  if (![...files.values()].some(isGzip)) return { main, files };
  const plain = new Map<string, Uint8Array>();
  const notes: Note[] = [];
  let plainMain = main;
  for (const [name, bytes] of files) {
    const isCompressed = isGzip(bytes);
    const plainName = isCompressed ? name.replace(/\.gz$/i, '') : name;
    const content = isCompressed
      ? await gunzip(bytes, limit ?? defaultLimit, platform, notes)
      : bytes;
    plain.set(plainName, content);
    if (name === main) plainMain = plainName;
  }
  return { main: plainMain, files: plain, notes };
}

/** Decompresses with fflate's streaming decoder, which is loaded on first use. */
async function gunzip(
  bytes: Uint8Array,
  limit: number,
  platform: FileReader,
  notes: Note[],
): Promise<Uint8Array> {
  const url = new URL('../decoders/fflate.js', import.meta.url);
  const { Gunzip } = (await platform.importFile(url)) as Pick<HowToUnpack, 'Gunzip'>;
  const chunks: Uint8Array[] = [];
  let size = 0;
  const add = (chunk: Uint8Array): void => {
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
      notes.push({ code: 'read-gzip-longer', numbers: { bytes: ignored }, words: {}, where: [] });
  } catch (error) {
    if (error instanceof HgpError) throw error;
    const message = `The gzip data are ${messageOf(error)}.`;
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
