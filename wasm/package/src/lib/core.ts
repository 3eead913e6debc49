// The solver itself, synchronous: for use inside your own worker. Arguments and results are plain values, except the
// handles: a CoreModel is a loaded mesh, a CoreMap a map of one. Both are in the memory of WebAssembly until free().

import createModule, { type Module, type Session } from '../module.js';
import { checkOptions } from './check_options.js';
import type { CoreMap } from './core_map.js';
import { CoreModel, type Loaded } from './core_model.js';
import { decodersFor } from './decoders.js';
import type { ModelInfo } from './documents.js';
import { messageOf, unavailable, usage, valueOf } from './error.js';
import { toGlb } from './glb.js';
import { decompressed } from './gzip.js';
import type {
  CombineOptions,
  CoreFiles,
  FileOptions,
  LoadOptions,
  MeshArrays,
  MeshLoadOptions,
  MeshSolveOptions,
  SolveOptions,
} from './options.js';
import type { FileReader } from './platform.js';
import type { FileResult, Progress, Result, Written } from './results.js';
import { checkFiles, checkMesh } from './sources.js';
import { startModule } from './start_module.js';
import { jsonOf } from './to_core.js';
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

/** Copies of the files beside a .gltf that may be pictures: all but the buffers that exporters write. */
const picturesOf = ({ main, files }: CoreFiles): Map<string, Uint8Array> =>
  new Map(
    [...files]
      .filter(([name]) => name !== main && !name.endsWith('.bin'))
      .map(([name, bytes]) => [name, Uint8Array.from(bytes)]),
  );

/** The numbers of a map that is not needed any more. */
function resultOf(map: CoreMap): Result {
  map.free();
  return map.data;
}

/**
 * The default file name of write(): that of the file, with the extension of what is written. Formats that can only be
 * read become OBJ, and a file may have the extension of another format.
 */
function nameFor(main: string, format: string, target?: LoadOptions['target']): string {
  const extension = target ?? (format === 'glb' || format === 'gltf' ? format : 'obj');
  const file = main.split('/').pop() ?? '';
  const stem = file.replace(/\.(obj|off|ply|stl|gltf|glb|vrm)$/i, '');
  const isKept = stem && file.slice(stem.length).toLowerCase() === `.${extension}`;
  return isKept ? file : `${stem || 'mesh'}.${extension}`;
}

/** The solver. Calls are synchronous, except prepare(), and throw HgpError. */
export class Core {
  readonly #module: Module;
  readonly #platform: FileReader;
  #decoders: object = {};

  /** Called during calls; returning false cancels the call. It can neither use the model of the call nor free it. */
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
    checkFiles('prepare', source);
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
  load(source: CoreFiles, options: LoadOptions = {}): CoreModel {
    checkFiles('load', source);
    checkOptions('load', options);
    const { main, files, notes = [] } = source;
    const { name: _name, ...asked } = options;
    const names = [...files.keys()];
    return this.#open(options, (session) => {
      const contents = [...files.values()];
      const loaded = session.load(main, names, contents, this.#decoders, JSON.stringify(asked));
      const info = jsonOf(loaded) as ModelInfo;
      const { format } = info.file;
      if (options.target === 'ply' && format !== 'ply')
        throw usage(`load: target is 'ply' for PLY files only; this one is read as ${format}`);
      return {
        info: { ...info, notes: [...notes, ...info.notes] },
        name: nameFor(main, format, options.target),
        sides: format === 'gltf' ? picturesOf(source) : undefined,
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

  #open(options: LoadOptions, load: (session: Session) => Loaded): CoreModel {
    const session = new this.#module.Session();
    try {
      return new CoreModel(this, session, { ...load(session), options });
    } catch (error) {
      session.delete();
      throw error;
    }
  }
}
