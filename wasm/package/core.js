// The solver itself, synchronous: for use inside your own worker. Everything that goes in or comes
// out is a plain value; the one C++ object, the session with its loaded model, is owned by Core and
// freed by `free()`.

import { decodersFor } from './decoders.js';
import createModule from './module.js';
import { warmUpMesh } from './warm_up.js';

/** An error with the same code on the page, in this package and on the command line. */
export class HgpError extends Error {
  constructor({ code, message, stage, where }) {
    super(message);
    this.name = 'HgpError';
    this.code = code;
    this.details = { stage, where };
  }
}

const isNode = typeof process === 'object' && Boolean(process.versions?.node);

/** Compiles hgp.wasm, from wherever the options say; by default the file beside this one. */
export async function compile({ wasmModule, wasmBinary, wasmUrl } = {}) {
  if (wasmModule) return wasmModule;
  if (wasmBinary) return WebAssembly.compile(wasmBinary);
  if (isNode) {
    const { readFile } = await import(/* @vite-ignore */ 'node:fs/promises');
    return WebAssembly.compile(await readFile(wasmUrl ?? new URL('./hgp.wasm', import.meta.url)));
  }
  const response = await fetch(wasmUrl ?? new URL('./hgp.wasm', import.meta.url));
  if (!response.ok) {
    throw new HgpError({ code: 'wasm-unavailable', message: `hgp.wasm: HTTP ${response.status}` });
  }
  // Not every static host serves the type that streaming compilation insists on.
  if (response.headers.get('Content-Type')?.startsWith('application/wasm')) {
    return WebAssembly.compileStreaming(response);
  }
  return WebAssembly.compile(await response.arrayBuffer());
}

/** The text of a glTF, the first chunk of a GLB; nothing for files of other kinds. */
function gltfJson(bytes) {
  if (!bytes) return undefined;
  const starts = (text, at) => [...text].every((c, i) => bytes[at + i] === c.charCodeAt(0));
  if (starts('glTF', 0)) {
    const size = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
    return bytes.length < 20 ? undefined : bytes.subarray(20, 20 + size.getUint32(12, true));
  }
  let first = bytes[0] === 0xef ? 3 : 0; // a byte order mark
  while (first < 1024 && ' \t\r\n'.includes(String.fromCharCode(bytes[first]))) first++;
  return starts('{', first) ? bytes : undefined;
}

/** `field` and `frames` as the session takes them. */
function fieldOptions({ field, frames = 'auto' }) {
  const refuse = (message) => {
    throw new HgpError({ code: 'usage', message });
  };
  if (frames !== 'auto' && frames !== 'file') refuse(`frames is 'auto' or 'file', not ${frames}`);
  if (frames === 'file' && !field) refuse("frames: 'file' needs the field it comes from (field)");
  if (!field) return {};
  const { name = '', text, q = 0 } = field;
  if (typeof text !== 'string') refuse('field needs the text of a field file: { name, text }');
  return { field: { name, text, q }, frames };
}

export async function createCore(options = {}) {
  const wasmModule = await compile(options);
  const module = await createModule({
    // The glue never fetches: it gets the compiled module, which makes one file serve browsers,
    // workers and Node alike.
    instantiateWasm(imports, receive) {
      WebAssembly.instantiate(wasmModule, imports).then((instance) => receive(instance));
      return {};
    },
    print() {},
    printErr() {},
  });
  return new Core(module);
}

export class Core {
  #module;
  #session;
  #decoders = {};
  #name = 'mesh.obj'; // of what write() makes, where the caller gives none

  /** Called with { stage, fraction, iteration, residual, round, maxRounds }; return false to cancel. */
  onProgress;

  constructor(module) {
    this.#module = module;
    this.#session = new module.Session();
  }

  get version() {
    return this.#module.version();
  }

  /** Bytes of the linear memory; it grows and never shrinks. */
  get memory() {
    return this.#module.HEAPU8.length;
  }

  /** Loads the decoders that the file needs, if any; load() itself never waits. */
  async prepare({ main, files }) {
    const json = gltfJson(files.get(main));
    if (!json) return;
    const needs = this.#reply(this.#module.neededDecoders(json));
    try {
      this.#decoders = await decodersFor(needs);
    } catch (error) {
      const message = `A decoder of compressed glTF could not be loaded: ${error.message}`;
      throw new HgpError({ code: 'wasm-unavailable', message });
    }
  }

  /** Makes the engine optimize the solver, by a small solve beside the loaded model. */
  warmUp() {
    const other = new Core(this.#module);
    other.loadMesh(warmUpMesh());
    other.parametrize();
    other.free();
  }

  load({ main, files }, options = {}) {
    const names = [...files.keys()];
    // Formats that can only be read are answered with an OBJ.
    this.#name =
      main
        .split('/')
        .pop()
        .replace(/\.(off|ply|stl)$/i, '.obj') || 'mesh.obj';
    return this.#json(this.#live.load(main, names, [...files.values()], this.#decoders, options));
  }

  loadMesh({ positions, triangles }, options = {}) {
    this.#name = 'mesh.obj';
    return this.#json(this.#live.loadMesh(positions, triangles, options));
  }

  inspect() {
    return this.#json(this.#live.inspect());
  }

  /** The loaded surface, usable or not. */
  surface() {
    return this.#reply(this.#live.surface());
  }

  /** A cone file of any known kind as hgp-cones of the loaded surface. */
  readCones({ name, text, q = 0 }) {
    return this.#json(this.#live.readCones(name, text, q));
  }

  /** The cones that are stored inside the file, or null. */
  embeddedCones() {
    const { json } = this.#reply(this.#live.embeddedCones());
    return json === undefined ? null : JSON.parse(json);
  }

  suggestCones(options = {}) {
    return this.#json(this.#live.suggestCones(options, this.#progress()));
  }

  check(cones) {
    return this.#json(this.#live.check(JSON.stringify(cones)));
  }

  parametrize({ cones, field, frames, ...rest } = {}) {
    const text = cones ? JSON.stringify(cones) : '';
    const options = { ...rest, ...fieldOptions({ field, frames }) };
    const reply = this.#reply(this.#live.parametrize(text, options, this.#progress()));
    const seams = [];
    for (let i = 0; i < reply.seams.length; i += 5) {
      const [a0, a1, b0, b1, r] = reply.seams.subarray(i, i + 5);
      seams.push({ a: [a0, a1], b: [b0, b1], r });
    }
    const report = JSON.parse(reply.report);
    const { certificate, cones: solved } = report;
    return { ...reply, seams, report, certificate, cones: solved, memory: this.memory };
  }

  verify({ cones, field, ...rest } = {}) {
    const options = { ...rest, ...fieldOptions({ field }) };
    return this.#json(this.#live.verify(cones ? JSON.stringify(cones) : '', options));
  }

  write(options = {}) {
    const { files, notes, xref } = this.#reply(this.#live.write({ name: this.#name, ...options }));
    return { name: files[0].name, bytes: files[0].bytes, files, notes, xref };
  }

  /** Frees the model. The object cannot be used afterwards. */
  free() {
    this.#session?.delete();
    this.#session = undefined;
  }

  get #live() {
    if (this.#session) return this.#session;
    throw new HgpError({ code: 'usage', message: 'this core has been freed' });
  }

  #progress() {
    const { onProgress } = this;
    if (!onProgress) return undefined;
    return (stage, fraction, iteration, residual, round, maxRounds) =>
      onProgress({ stage, fraction, iteration, residual, round, maxRounds }) !== false;
  }

  #reply(reply) {
    if (reply.error !== undefined) throw new HgpError(JSON.parse(reply.error));
    return reply;
  }

  #json(reply) {
    return JSON.parse(this.#reply(reply).json);
  }
}

Core.prototype[Symbol.dispose ?? Symbol.for('Symbol.dispose')] = Core.prototype.free;
