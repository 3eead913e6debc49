// Loaded before the script of `npx hgp` (tests/wasm/npx_script.test.mjs): in place of the compiled program one that
// tells what it was given and does what its words say. A limit of 2 GiB is one of a hundred bytes.

import fs from 'node:fs';
import Module, { syncBuiltinESMExports } from 'node:module';
import zlib from 'node:zlib';

const { gunzipSync } = zlib;
const { readFileSync, readSync, readdirSync, fstatSync } = fs;
const load = Module._load;
const say = (what) => console.log(JSON.stringify(what));
const wasm = 'not really WebAssembly';

zlib.gunzipSync = (bytes, { maxOutputLength }) => gunzipSync(bytes, { maxOutputLength: (100 * maxOutputLength) / 2 ** 31 }); // prettier-ignore
fs.readFileSync = (place, ...more) => place instanceof URL && place.href.endsWith('/cli/cli.wasm') ? Buffer.from(wasm) : readFileSync(place, ...more); // prettier-ignore
syncBuiltinESMExports();

const openFiles = () => readdirSync('/proc/self/fd').length;

function open(name, flags) {
  const before = openFiles();
  const fd = fs.openSync(name, /^\d+$/.test(flags) ? Number(flags) : flags);
  const isFolder = fstatSync(fd).isDirectory();
  const bytes = Buffer.alloc(isFolder ? 0 : 1000);
  let length = 0;
  try {
    length = readSync(fd, bytes, 0, bytes.length, 0);
  } catch {
    // It is open for writing only, or a folder.
  }
  say({ name, isFolder, content: bytes.toString('latin1', 0, length), more: openFiles() - before });
  fs.closeSync(fd);
}

function callMain(words) {
  const doing = { open, say: () => say(words), end: (status) => { throw Object.assign(new Error('end'), { name: 'ExitStatus', status: Number(status) }); }, fail: (text) => { throw new Error(text); } }; // prettier-ignore
  for (const word of words) {
    const [what, ...how] = word.split(',');
    doing[what]?.(...how);
  }
}

Module._load = (request, ...more) =>
  request === '../cli/cli.cjs'
    ? async ({ thisProgram, wasmBinary }) => {
        say({ thisProgram, wasm: Buffer.from(wasmBinary).toString() === wasm, decoders: Object.keys(globalThis.hgpDecoders).sort() }); // prettier-ignore
        return { callMain };
      }
    : load(request, ...more);
