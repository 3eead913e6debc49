// The solver itself, synchronous: for use inside your own worker. All arguments and results are plain
// values; the only C++ object, the session with its loaded model, is owned by Core and
// freed by `free()`.

import createModule from '../module.js';
import { decodersFor } from './decoders.js';
import { HgpError, unavailable, usage } from './error.js';
import { decompressed } from './gzip.js';
import { checkConeFile, checkCones, checkOptions } from './options.js';
import { toMeshArrays } from './sources.js';
import { warmUpMesh } from './warm_up.js';
import { parametrizeFile } from './whole_file.js';

/** The text of a glTF or of the first chunk of a GLB; undefined for other files. */
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

/**
 * Makes a Core from a compiled module. Rejects with `wasm-unavailable` if it cannot be instantiated.
 * @param platform  how files of this package are read (see ../core.js and ../node/core.js)
 */
export async function coreOf(wasmModule, platform) {
  const module = await new Promise((resolve, reject) => {
    createModule({
      // Emscripten's glue code does not fetch: it receives the compiled module, so that the same file works in
      // browsers, workers and Node. If instantiation fails, it would wait forever.
      instantiateWasm(imports, receive) {
        WebAssembly.instantiate(wasmModule, imports).then(receive).catch(reject);
        return {};
      },
      print() {},
      printErr() {},
      onAbort: reject,
    }).then(resolve, reject);
  }).catch((error) => {
    throw unavailable(`The solver could not be started: ${error?.message ?? error}`, error);
  });
  return new Core(module, platform);
}

/** The default file name of write(): formats that can only be read become OBJ. */
function nameFor(main, format) {
  const stem = main.split('/').pop();
  if (format === 'glb' || format === 'gltf') return stem || `mesh.${format}`;
  return stem.replace(/\.(off|ply|stl)$/i, '.obj') || 'mesh.obj';
}

/** The same for another format: "x.flat.obj" of "x.glb". */
function exportName(name, format) {
  const stem = name.replace(/\.[^.]*$/, '') || 'mesh';
  return `${stem}.${format === 'flat-obj' ? 'flat.obj' : format}`;
}

/**
 * The options with the field file in the session's form: all three members are set, q is 0 if the file has its own.
 * @param {{ field?: import('../core.js').ConeFile, [option: string]: unknown }} options
 */
function withField({ field, ...options }) {
  if (!field) return options;
  const { name = '', text, q = 0 } = field;
  return { ...options, field: { name, text, q } };
}

/** LoadOptions::kWeldNever of the core. */
const neverWeld = -2;

export class Core {
  #module;
  #platform;
  #session;
  #decoders = {};
  #name = 'mesh.obj'; // default name of the result of write()

  /** Called with { stage, fraction, iteration, residual, round, maxRounds }; return false to cancel. */
  onProgress;

  /** Private: use createCore(). */
  constructor(module, platform) {
    this.#module = module;
    this.#platform = platform;
    this.#session = new module.Session();
  }

  get version() {
    return this.#module.version();
  }

  /** Size of the linear memory in bytes; it never shrinks. */
  get memory() {
    return this.#module.HEAPU8.length;
  }

  /**
   * Asynchronous preparation for load(): decompresses gzip, and loads the decoders that the file needs.
   * @param {import('../core.js').CoreFiles} given
   * @param {import('../core.js').LoadOptions} [options]
   * @return the files to load
   */
  async prepare(given, { limits } = {}) {
    const prepared = await decompressed(given, limits?.bytes, this.#platform);
    const json = gltfJson(prepared.files.get(prepared.main));
    if (!json) return prepared;
    const needs = this.#reply(this.#module.neededDecoders(json));
    try {
      this.#decoders = await decodersFor(needs, this.#platform);
    } catch (error) {
      const message = `A decoder of compressed glTF could not be loaded: ${error.message}`;
      throw unavailable(message, error);
    }
    return prepared;
  }

  /** Makes the engine optimize the solver by a small solve, which does not affect the loaded model. */
  warmUp() {
    const other = new Core(this.#module, this.#platform);
    other.loadMesh(warmUpMesh());
    other.parametrize();
    other.free();
  }

  load({ main, files, notes = [] }, options = {}) {
    checkOptions('load', options);
    const names = [...files.keys()];
    const info = this.#json(
      this.#live.load(main, names, [...files.values()], this.#decoders, options),
    );
    this.#name = nameFor(main, info.file.format);
    return notes.length > 0 ? { ...info, notes: [...notes, ...info.notes] } : info;
  }

  /**
   * Loads a mesh given as arrays. Vertices at equal positions are joined unless `weld` is false.
   * @param {import('../core.js').MeshArrays} mesh
   * @param {import('../core.js').MeshLoadOptions} [options]
   */
  loadMesh(mesh, { weld = 0, ...options } = {}) {
    const { positions, triangles } = toMeshArrays(mesh);
    const rest = weld === false ? options : { ...options, weld };
    checkOptions('load', rest);
    const asked = weld === false ? { ...options, weld: neverWeld } : rest;
    const info = this.#json(this.#live.loadMesh(positions, triangles, asked));
    this.#name = 'mesh.obj';
    return info;
  }

  inspect() {
    return this.#json(this.#live.inspect());
  }

  /** The loaded surface, usable or not. */
  surface() {
    return this.#reply(this.#live.surface());
  }

  /** A cone file of any known format as hgp-cones of the loaded surface. */
  readCones(file) {
    checkConeFile('readCones', file);
    const { name = '', text, q = 0 } = file;
    return this.#json(this.#live.readCones(name, text, q));
  }

  /** The cones stored in the file, or null. */
  embeddedCones() {
    const { json } = this.#reply(this.#live.embeddedCones());
    return json === undefined ? null : JSON.parse(json);
  }

  suggestCones(options = {}) {
    checkOptions('suggestCones', options);
    return this.#json(this.#live.suggestCones(options, this.#progress()));
  }

  check(cones) {
    checkCones('check', cones);
    return this.#json(this.#live.check(JSON.stringify(cones)));
  }

  /** @param {import('../core.js').SolveOptions} [options] */
  parametrize(options = {}) {
    checkOptions('parametrize', options);
    const { cones, ...rest } = options;
    const text = cones ? JSON.stringify(cones) : '';
    const reply = this.#reply(this.#live.parametrize(text, withField(rest), this.#progress()));
    const seams = [];
    for (let i = 0; i < reply.seams.length; i += 5) {
      const [a0, a1, b0, b1, r] = reply.seams.subarray(i, i + 5);
      seams.push({ a: [a0, a1], b: [b0, b1], r });
    }
    const report = JSON.parse(reply.report);
    const { certificate, cones: completed } = report;
    return { ...reply, seams, report, certificate, cones: completed, memory: this.memory };
  }

  /**
   * Maps every mesh of a file and returns the file with all maps. Afterwards the given file is loaded.
   * @param {import('../core.js').CoreFiles} source  as returned by prepare()
   * @param {import('../core.js').FileOptions} [options]
   */
  parametrizeFile(source, options = {}) {
    return parametrizeFile(this, source, options);
  }

  /** @param {import('../core.js').VerifyOptions} [options] */
  verify(options = {}) {
    checkOptions('verify', options);
    const { cones, ...rest } = options;
    return this.#json(this.#live.verify(cones ? JSON.stringify(cones) : '', withField(rest)));
  }

  write(options = {}) {
    checkOptions('write', options);
    const { format = 'same' } = options;
    const name = format === 'same' ? this.#name : exportName(this.#name, format);
    const { files, ...rest } = this.#reply(this.#live.write({ name, ...options }));
    return { name: files[0].name, bytes: files[0].bytes, files, ...rest };
  }

  /** Distortion per triangle, overlaps, and the seam to which each seam edge belongs. */
  measure() {
    return this.#reply(this.#live.measure());
  }

  /** Facts about the vertices and triangles of the loaded surface, usable or not. */
  facts() {
    return this.#reply(this.#live.facts());
  }

  /** The boundary loops and handle generators, in the order of their numbers. */
  loops() {
    return this.#reply(this.#live.loops());
  }

  /** Keeps the current result under a name for recall(). */
  keep(name) {
    this.#live.keep(`${name}`);
  }

  /** Makes a kept result the current one; false if it is not available. */
  recall(name) {
    return this.#live.recall(`${name}`);
  }

  quads(options = {}) {
    checkOptions('quads', options);
    const name = options.name ?? 'quads.obj';
    return { name, ...this.#reply(this.#live.quads(name)) };
  }

  /** Frees the model. The object cannot be used afterwards. */
  free() {
    this.#session?.delete();
    this.#session = undefined;
  }

  get #live() {
    if (this.#session) return this.#session;
    throw usage('this core has been freed');
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
