#!/usr/bin/env node
// `npx hgp`: the command line of hgp, compiled to WebAssembly from the same sources as the native program. It reads
// and writes files through Node; this script decompresses gzip and loads the decoders of compressed glTF.

import fs from 'node:fs';
import { createRequire } from 'node:module';
import os from 'node:os';
import path from 'node:path';
import { gunzipSync } from 'node:zlib';
import { decodersFor } from '../lib/decoders.js';
import * as platform from './platform.js';

interface CommandLine {
  callMain(words: string[]): void;
}
type Create = (options: { thisProgram: string; wasmBinary: Uint8Array }) => Promise<CommandLine>;

const maxBytes = 2 ** 31; // as in the native program

function end(message: string, code: number): never {
  console.error(`hgp: ${message}`);
  process.exit(code);
}

/** A descriptor of the decompressed file, which has no name and goes away with the process. */
function unpacked(fd: number, open: typeof fs.openSync): number {
  let plain: Buffer | undefined;
  try {
    plain = gunzipSync(fs.readFileSync(fd), { maxOutputLength: maxBytes });
  } catch (error) {
    const isTooLarge = (error as NodeJS.ErrnoException).code === 'ERR_BUFFER_TOO_LARGE';
    if (isTooLarge) end('the input is larger than 2 GiB', 8);
    end(`the gzip data are damaged: ${(error as Error).message}`, 3);
  }
  fs.closeSync(fd);
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'hgp-'));
  const file = path.join(folder, 'plain');
  fs.writeFileSync(file, plain);
  const result = open(file, 'r');
  fs.rmSync(folder, { recursive: true });
  return result;
}

function isGzip(fd: number): boolean {
  if (!fs.fstatSync(fd).isFile()) return false;
  const magic = new Uint8Array(2);
  return fs.readSync(fd, magic, 0, 2, 0) === 2 && magic[0] === 0x1f && magic[1] === 0x8b;
}

/** Files that are opened for reading appear decompressed. */
function readGzip(): void {
  const open = fs.openSync;
  fs.openSync = (name, flags, mode) => {
    const fd = open(name, flags, mode);
    const isRead =
      typeof flags === 'number' ? (flags & 3) === fs.constants.O_RDONLY : flags === 'r';
    return isRead && isGzip(fd) ? unpacked(fd, open) : fd;
  };
}

async function main(words: string[]): Promise<void> {
  const mayBeGltf = words.some((word) => /\.(glb|gltf)(\.gz)?$/i.test(word) || word === '-');
  const needs = { draco: mayBeGltf, meshopt: mayBeGltf };
  Object.assign(globalThis, { hgpDecoders: await decodersFor(needs, platform) });
  const folder = new URL('../cli/', import.meta.url);
  const create = createRequire(import.meta.url)('../cli/cli.cjs') as Create;
  const wasmBinary = fs.readFileSync(new URL('cli.wasm', folder));
  const program = await create({ thisProgram: 'hgp', wasmBinary });
  readGzip();
  try {
    program.callMain(words);
  } catch (error) {
    const { name, status } = error as { name?: string; status?: number };
    if (name !== 'ExitStatus') throw error;
    process.exitCode = status;
  }
}

await main(process.argv.slice(2));
