// The solver itself, synchronous: for use inside your own worker. Arguments and results are plain values, except the
// handles: a CoreModel is a loaded mesh, a CoreMap a map of one. Both are in the memory of WebAssembly until free().

import createModule, {
  type Module,
  type Session,
  type SessionResult,
  type StoredResult,
  type WholeFile,
} from '../module.js';
import {
  checkConeFile,
  checkCones,
  checkFeatures,
  checkOptions,
  checkVertex,
} from './check_options.js';
import { decodersFor } from './decoders.js';
import { defineDisposal } from './disposal.js';
import { CoreDrag, type DragPath } from './drag.js';
import type { Certificate, CheckReport, ModelInfo, Note, Report } from './documents.js';
import { messageOf, unavailable, usage, valueOf } from './error.js';
import { toGlb } from './glb.js';
import { decompressed } from './gzip.js';
import type {
  CombineOptions,
  ConeFile,
  Cones,
  CoreFiles,
  FeatureFile,
  FeatureListOptions,
  Features,
  FileOptions,
  LoadOptions,
  MeshArrays,
  MeshLoadOptions,
  MeshSolveOptions,
  QuadOptions,
  SolveOptions,
  SuggestOptions,
  VerifyOptions,
  WriteOptions,
} from './options.js';
import type { FileReader } from './platform.js';
import { MapData } from './map_data.js';
import type {
  FeatureList,
  FileResult,
  Loops,
  Measures,
  MovedCones,
  Placements,
  Progress,
  Quads,
  Result,
  Surface,
  SurfaceFacts,
  Written,
} from './results.js';
import { checkMesh } from './sources.js';
import { startModule } from './start_module.js';
import { warmUpMesh } from './warm_up.js';
import { combine, parametrizeFile, takeCombineOptions } from './whole_file.js';

/** The text of a glTF or of the first chunk of a GLB; undefined for other files. */
function gltfJson(bytes: Uint8Array | undefined): Uint8Array | undefined {
  if (!bytes) return undefined;
  const starts = (text: string, at: number): boolean =>
    Array.from(text).every((c, i) => bytes[at + i] === c.charCodeAt(0));
  if (starts('glTF', 0)) {
    const size = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
    return bytes.length < 20 ? undefined : bytes.subarray(20, 20 + size.getUint32(12, true));
  }
  let first = bytes[0] === 0xef ? 3 : 0; // a byte order mark
  while (first < 1024 && ' \t\r\n'.includes(String.fromCharCode(bytes[first]))) first++;
  return starts('{', first) ? bytes : undefined;
}

/** The default file name of write(): formats that can only be read become OBJ. */
function nameFor(main: string, format: string): string {
  const stem = main.split('/').pop() ?? '';
  if (format === 'glb' || format === 'gltf') return stem || `mesh.${format}`;
  return stem.replace(/\.(off|ply|stl)$/i, '.obj') || 'mesh.obj';
}

/** The same for another format: "x.flat.obj" of "x.glb". */
function exportName(name: string, format: string): string {
  const stem = name.replace(/\.[^.]*$/, '') || 'mesh';
  return `${stem}.${format === 'flat-obj' ? 'flat.obj' : format}`;
}

/** Features in the session's form: a file. */
function listFile(features: Features | FeatureFile): FeatureFile {
  if ('text' in features) {
    const { name = '', text = '' } = features as Partial<FeatureFile>;
    return { name, text };
  }
  return { name: 'features.json', text: JSON.stringify({ q: 4, features }) };
}

/** Files in the session's form: all members of each are set, q is 0 if a field has its own. */
function filesOf(field?: ConeFile, features?: Features | FeatureFile): object {
  const { name = '', text, q = 0 } = (field ?? {}) as Partial<ConeFile>;
  return {
    ...(field && { field: { name, text, q } }),
    ...(features && { features: listFile(features) }),
  };
}

/** The numbers of a map that is not needed any more. */
function resultOf(map: CoreMap): Result {
  map.free();
  return map.data;
}

const jsonOf = (reply: { json: string } | { error: string }): unknown =>
  JSON.parse(valueOf(reply as { json: string }).json);

/** The options as the core's table has them: 'auto' is a mode without a number of cells. */
function forCore({ grid, ...options }: Pick<SolveOptions, 'grid'>): object {
  if (grid === undefined) return options;
  const { cells, spacing, mode = 'tile' } = grid === 'auto' ? {} : grid;
  const isAutomatic = grid === 'auto' || cells === 'auto';
  const asked = typeof cells === 'number' ? { cells } : {};
  if (isAutomatic) return { ...options, grid: { mode } };
  return {
    ...options,
    grid: { ...asked, ...(spacing === undefined ? {} : { spacing }), ...(grid.mode && { mode }) },
  };
}

/** The callback in the form in which the core calls it. */
function progressCall(onProgress: Core['onProgress']) {
  if (!onProgress) return undefined;
  return (
    stage: string,
    fraction: number,
    iteration: number,
    residual: number,
    round: number,
    maxRounds: number,
  ): boolean => onProgress({ stage, fraction, iteration, residual, round, maxRounds }) !== false;
}

/** The solver. Calls are synchronous, except prepare(), and throw HgpError. */
export class Core {
  readonly #module: Module;
  readonly #platform: FileReader;
  #decoders: object = {};

  /** Called during calls; returning false cancels the call. */
  onProgress: ((progress: Progress) => unknown) | undefined;

  private constructor(module: Module, platform: FileReader) {
    this.#module = module;
    this.#platform = platform;
  }

  /**
   * Rejects with `wasm-unavailable` if the module cannot be instantiated.
   * @param platform  how files of this package are read
   * @internal
   */
  static async make(wasmModule: WebAssembly.Module, platform: FileReader): Promise<Core> {
    return new Core(await startModule(createModule, wasmModule), platform);
  }

  get version(): string {
    return this.#module.version();
  }

  /** @internal */
  get module(): Module {
    return this.#module;
  }

  /** Size of the linear memory in bytes; it never shrinks. */
  get memory(): number {
    return this.#module.HEAPU8.length;
  }

  /** Makes the engine optimize the solver by a small solve (about 0.3 s), so that the first call is not slow. */
  warmUp(): void {
    const { onProgress } = this;
    this.onProgress = undefined;
    try {
      this.parametrizeMesh(warmUpMesh());
    } finally {
      this.onProgress = onProgress;
    }
  }

  /**
   * Asynchronous preparation for load(), which is synchronous: decompresses gzip, and loads the decoders of compressed
   * glTF. Resolves to the files to load.
   */
  async prepare(source: CoreFiles, options: Pick<LoadOptions, 'limits'> = {}): Promise<CoreFiles> {
    const prepared = await decompressed(source, options.limits?.bytes, this.#platform);
    const json = gltfJson(prepared.files.get(prepared.main));
    if (!json) return prepared;
    const needs = valueOf(this.#module.neededDecoders(json));
    try {
      this.#decoders = await decodersFor(needs, this.#platform);
    } catch (error) {
      const message = `A decoder of compressed glTF could not be loaded: ${messageOf(error)}`;
      throw unavailable(message, error);
    }
    return prepared;
  }

  /** Loads a mesh of a file. */
  load({ main, files, notes = [] }: CoreFiles, options: LoadOptions = {}): CoreModel {
    checkOptions('load', options);
    const { name: _name, ...asked } = options;
    const names = [...files.keys()];
    return this.#open(options, (session) => {
      const contents = [...files.values()];
      const loaded = session.load(main, names, contents, this.#decoders, JSON.stringify(asked));
      const info = jsonOf(loaded) as ModelInfo;
      return {
        info: notes.length > 0 ? { ...info, notes: [...notes, ...info.notes] } : info,
        name: nameFor(main, info.file.format),
      };
    });
  }

  /** Loads a mesh given as arrays. */
  loadMesh(mesh: MeshArrays, options: MeshLoadOptions = {}): CoreModel {
    checkOptions('loadMesh', options);
    const { positions, triangles } = checkMesh(mesh);
    const { weld = 0, ...rest } = options;
    const asked: LoadOptions = { ...rest, weld: weld === false ? 'none' : weld };
    return this.#open(asked, (session) => {
      const info = jsonOf(
        session.loadMesh(positions, triangles, JSON.stringify(asked)),
      ) as ModelInfo;
      return { info, name: 'mesh.obj' };
    });
  }

  /** Loads a mesh given as arrays, maps it and frees it. */
  parametrizeMesh(mesh: MeshSolveOptions): Result {
    const { positions, triangles, weld, fix, strict, limits, ...solve } = mesh;
    const model = this.loadMesh({ positions, triangles }, { weld, fix, strict, limits });
    try {
      return resultOf(model.parametrize(solve));
    } finally {
      model.free();
    }
  }

  /**
   * The same for a mesh of a renderer: in single precision, in which it is drawn, with vertices at equal positions
   * joined. Vertex ids are those after the join.
   * @internal
   */
  parametrizeRendered(mesh: MeshArrays, load: LoadOptions, solve: SolveOptions): Result {
    const { positions, triangles } = checkMesh(mesh);
    const files = new Map([['mesh.glb', toGlb(positions, triangles)]]);
    const model = this.load({ main: 'mesh.glb', files }, load);
    try {
      return resultOf(model.parametrize(solve));
    } finally {
      model.free();
    }
  }

  /** Maps every mesh of a file from prepare() and returns the file with all maps. */
  parametrizeFile(source: CoreFiles, options: FileOptions = {}): FileResult {
    checkOptions('parametrizeFile', options);
    return parametrizeFile(this, source, options);
  }

  /**
   * Writes the maps of several meshes of one file, from which a model was loaded for each, into that file.
   * @param options  for all maps, or for each of them
   */
  combine(
    maps: readonly CoreMap[],
    options: CombineOptions | readonly CombineOptions[] = {},
  ): Written {
    return combine(this, maps, takeCombineOptions(maps.length, options));
  }

  #open(
    options: LoadOptions,
    load: (session: Session) => { info: ModelInfo; name: string },
  ): CoreModel {
    const session = new this.#module.Session();
    try {
      const { info, name } = load(session);
      return new CoreModel(this, session, { info, name, options });
    } catch (error) {
      session.delete();
      throw error;
    }
  }
}

/** A loaded mesh. */
export class CoreModel {
  readonly #core: Core;
  #session: Session | undefined;

  /** The facts and defects of the mesh. */
  readonly info: ModelInfo;
  /**
   * Those with which it was loaded.
   * @internal
   */
  readonly options: LoadOptions;
  /**
   * The default name of the result of write().
   * @internal
   */
  readonly defaultName: string;

  /** @internal */
  constructor(
    core: Core,
    session: Session,
    { info, name, options }: { info: ModelInfo; name: string; options: LoadOptions },
  ) {
    this.#core = core;
    this.#session = session;
    this.info = info;
    this.defaultName = name;
    this.options = options;
  }

  /** The facts and defects of the mesh. */
  inspect(): ModelInfo {
    return jsonOf(this.#live.inspect()) as ModelInfo;
  }

  /** The loaded surface, usable or not, to which vertex and triangle ids refer. */
  surface(): Surface {
    return valueOf(this.#live.surface());
  }

  /** Facts about the vertices and triangles of the surface, usable or not. */
  facts(): SurfaceFacts {
    return valueOf(this.#live.facts());
  }

  /** By mesh of the file, how its nodes use it; empty in formats without nodes. */
  placements(): Placements[] {
    return valueOf(this.#live.placements()).meshes;
  }

  /** The boundary loops and handle generators, in the order of their numbers. */
  loops(): Loops {
    return valueOf(this.#live.loops());
  }

  /** A cone file of any known format as cones of the surface. */
  readCones(file: ConeFile): Cones {
    checkConeFile('readCones', file);
    const { name = '', text, q = 0 } = file as Partial<ConeFile>;
    return jsonOf(this.#live.readCones(name, text ?? '', q)) as Cones;
  }

  /** The cones stored in the file, or null. */
  embeddedCones(): Cones | null {
    const { json } = valueOf(this.#live.embeddedCones());
    return json === undefined ? null : (JSON.parse(json) as Cones);
  }

  /** Automatic cones. */
  suggestCones(options: SuggestOptions = {}): Cones {
    checkOptions('suggestCones', options);
    return jsonOf(this.#live.suggestCones(JSON.stringify(options), this.#progress())) as Cones;
  }

  /** The cones with those that Gauss–Bonnet misses, placed where they cause the least distortion. */
  balanceCones(cones: Cones): Cones {
    checkCones('balanceCones', cones);
    return jsonOf(this.#live.balanceCones(JSON.stringify(cones))) as Cones;
  }

  /**
   * The cones of another reading or version of this surface on this one: by number where both have the same vertices and
   * triangles, otherwise by exact position.
   */
  transferCones(cones: Cones, from: CoreModel): MovedCones {
    checkCones('transferCones', cones);
    const { json, lost } = valueOf(this.#live.transferCones(JSON.stringify(cones), from.#live));
    return { cones: JSON.parse(json) as Cones, lost: JSON.parse(lost) as Note[] };
  }

  /** Checks cones against Gauss–Bonnet in exact integers; solves nothing. */
  check(cones: Cones): CheckReport {
    checkCones('check', cones);
    return jsonOf(this.#live.check(JSON.stringify(cones))) as CheckReport;
  }

  /**
   * The logarithm of the conformal factor that the map of these cones follows, by surface vertex: a preview in a part of
   * the time of parametrize(). NaN on components for which nothing is prescribed.
   */
  logScale(cones: Cones): Float32Array {
    checkCones('logScale', cones);
    return valueOf(this.#live.logScale(JSON.stringify(cones))).logScale;
  }

  /**
   * The edges that features mean on this mesh, rims included, as a file of a name: `.json` (hgp-cones with positions),
   * `.sharp`, `.obj` (`l` lines), otherwise rows of two vertices.
   */
  listFeatures(
    features: Features | FeatureFile,
    { name = 'features.json', ...rest }: FeatureListOptions = {},
  ): FeatureList {
    checkFeatures('listFeatures', features);
    checkOptions('listFeatures', { name, ...rest });
    const { notes, ...list } = valueOf(this.#live.features(listFile(features), name));
    return { name, ...list, notes: JSON.parse(notes) as Note[] };
  }

  /** Solves, and verifies the map as it will be stored; without `cones` they are chosen automatically. */
  parametrize(options: SolveOptions = {}): CoreMap {
    checkOptions('parametrize', options);
    const { cones, field, features, ...rest } = options;
    const session = this.#live;
    const text = cones ? JSON.stringify(cones) : '';
    const asked = JSON.stringify(forCore(rest));
    return this.#mapOf(
      session.parametrize(text, filesOf(field, features), asked, this.#progress()),
    );
  }

  /**
   * The map that was dropped at the end of a drag, which is the session's result.
   * @internal
   */
  dropped(): CoreMap {
    return this.#mapOf(this.#live.result());
  }

  /**
   * The map of parametrize() after drags, each given by its cone and its path.
   * @internal
   */
  dragged(options: SolveOptions, drags: readonly [number, DragPath][]): CoreMap {
    return drags.reduce((map, [cone, path]) => {
      const drag = map.beginDrag(cone);
      try {
        return drag.repeat(path).endDrag();
      } finally {
        drag.free();
        map.free();
      }
    }, this.parametrize(options));
  }

  /**
   * Maps every mesh of its file.
   * @internal
   */
  parametrizeFile({ write = {}, ...solve }: Omit<FileOptions, keyof LoadOptions>): WholeFile {
    const { onProgress } = this.#core;
    let [mesh, meshes] = [0, 1];
    const onMesh = (...now: [number, number]): void => void ([mesh, meshes] = now);
    const report = onProgress && ((p: Progress) => onProgress({ ...p, mesh, meshes }));
    const [options, how] = [forCore(solve), { name: this.defaultName, ...write }];
    const texts = [options, how].map((one) => JSON.stringify(one)) as [string, string];
    return valueOf(this.#live.parametrizeFile(...texts, progressCall(report), onMesh));
  }

  /** Verifies texture coordinates in the file. */
  verify(options: VerifyOptions = {}): Certificate {
    checkOptions('verify', options);
    const { cones, field, features, ...rest } = options;
    const text = cones ? JSON.stringify(cones) : '';
    const reply = this.#live.verify(text, filesOf(field, features), JSON.stringify(rest));
    return jsonOf(reply) as Certificate;
  }

  /**
   * The session with a result as its current one.
   * @internal
   */
  showing(result: StoredResult): Session {
    const session = this.#live;
    if (!session.use(result)) throw usage('the map is of another surface');
    return session;
  }

  /** Frees the model. Neither it nor its maps can be used afterwards. */
  free(): void {
    this.#session?.delete();
    this.#session = undefined;
  }

  [Symbol.dispose](): void {
    this.free();
  }

  get #live(): Session {
    if (this.#session) return this.#session;
    throw usage('this model has been freed');
  }

  #mapOf(reply: SessionResult | { error: string }): CoreMap {
    const numbers = valueOf(reply);
    const seams: Result['seams'] = [];
    for (let i = 0; i < numbers.seams.length; i += 5) {
      const [a0, a1, b0, b1, r] = numbers.seams.subarray(i, i + 5);
      seams.push({ a: [a0, a1], b: [b0, b1], r });
    }
    const report = JSON.parse(numbers.report) as Report;
    const { certificate, cones } = report;
    const { memory, module } = this.#core;
    const solved = numbers.solved ?? {
      triangles: numbers.triangles,
      uvTriangles: numbers.cornerToUv,
      origin: Uint32Array.from({ length: numbers.triangles.length / 3 }, (_, f) => f),
    };
    const result = {
      ...numbers,
      solved,
      seams,
      report,
      certificate,
      cones: cones as Cones,
      memory,
    };
    return new CoreMap(this, module, this.#live.storedResult(), result);
  }

  #progress() {
    return progressCall(this.#core.onProgress);
  }
}

/** A map of a model: its numbers, and calls that write and measure it. */
export class CoreMap extends MapData {
  /** @internal */
  readonly model: CoreModel;
  readonly #module: Module;
  #stored: StoredResult | undefined;

  /** @internal */
  constructor(model: CoreModel, module: Module, stored: StoredResult, result: Result) {
    super(result);
    this.model = model;
    this.#module = module;
    this.#stored = stored;
  }

  /**
   * Starts to drag a cone of this map, which must be certified and not on a refined mesh. This prepares the
   * neighbourhood of the cone, which takes a part of the time of parametrize().
   */
  beginDrag(vertex: number): CoreDrag {
    checkVertex('beginDrag', vertex);
    return new CoreDrag(this.#module, this, vertex);
  }

  /** The original file with the new texture coordinates and otherwise unchanged, or another format. */
  write(options: WriteOptions = {}): Written {
    checkOptions('write', options);
    const { format = 'same' } = options;
    const { defaultName } = this.model;
    const name = format === 'same' ? defaultName : exportName(defaultName, format);
    const reply = this.current().write(JSON.stringify({ name, ...options }));
    const { files, notes, xref, certified } = valueOf(reply);
    const told = JSON.parse(notes) as Note[];
    return { name: files[0].name, bytes: files[0].bytes, files, notes: told, xref, certified };
  }

  /** Distortion per triangle, overlaps, and the seam to which each seam edge belongs. */
  measure(): Measures {
    return valueOf(this.current().measure());
  }

  /** The cells of a map aligned in quad mode; throws `no-map` if it is not aligned. */
  quads(options: QuadOptions = {}): Quads {
    checkOptions('quads', options);
    const { name = 'quads.obj' } = options;
    return { name, ...valueOf(this.current().quads(name)) };
  }

  /**
   * The session of its model with this map as its current result.
   * @internal
   */
  current(): Session {
    return this.model.showing(this.#live);
  }

  /** Frees the map, of which only the numbers can be used afterwards. */
  free(): void {
    this.#stored?.delete();
    this.#stored = undefined;
  }

  [Symbol.dispose](): void {
    this.free();
  }

  get #live(): StoredResult {
    if (this.#stored) return this.#stored;
    throw usage('this map has been freed');
  }
}

defineDisposal(CoreModel.prototype);
defineDisposal(CoreMap.prototype);
