// The client: every call runs in a worker, can be cancelled and reports progress. Differences between
// browsers and Node are in the platform layer passed to it.
/// <reference lib="esnext.disposable" preserve="true" />

import { checkOptions } from './check_options.js';
import { compileWith } from './compile.js';
import { defineDisposal } from './disposal.js';
import type { ModelInfo } from './documents.js';
import { HgpError, messageOf, unavailable, usage } from './error.js';
import type { WebSignal, WebUrl, WebWorker } from './globals.js';
import { Model, UvMap } from './handles.js';
import type {
  CombineOptions,
  FileOptions,
  FileSet,
  FileSource,
  InitOptions,
  LoadOptions,
  MeshArrays,
  MeshLoadOptions,
  MeshSolveOptions,
  SolveOptions,
} from './options.js';
import type { Platform } from './platform.js';
import { Queue } from './queue.js';
import type { FileResult, Progress, Result, Written } from './results.js';
import { takeFiles, takeMesh } from './sources.js';
import { takeCombineOptions } from './whole_file.js';
import { wholeWasm } from './whole_wasm.js';

export interface ClientOptions extends InitOptions {
  /** Creates the worker, for bundlers and Content-Security-Policies that must know its URL. */
  createWorker?: () => WebWorker;
  /**
   * URL of worker.js of this package, for bundlers that do not find it. If it is on another origin, a script of the
   * page's own origin imports it.
   */
  workerUrl?: string | WebUrl;
  /**
   * Whether the worker solves a small model when it has started, so that the engine has
   * optimized the solver by the first call. Takes about 0.3 s; by default true.
   */
  warmUp?: boolean;
}

export interface CallOptions {
  /** Aborting terminates the worker immediately; the call rejects with the signal's reason. */
  signal?: WebSignal;
  /**
   * Aborting does not terminate the worker, which keeps what it has prepared: the call rejects immediately, and the
   * worker stops it at its next step. Calls behind it wait until then: for milliseconds, or on large meshes for tenths of a
   * second. In browsers this needs an isolated page, or a policy that allows to read Blobs (connect-src blob:); otherwise
   * they wait until the call would have ended.
   */
  keepWorker?: boolean;
  /** Called at most ten times per second. If it throws, the call is cancelled and rejects with that error. */
  onProgress?: (progress: Progress) => void;
}

/**
 * A worker with the solver. Calls, also those on its models and maps, run one after another in the order made; each is
 * one message to the worker. Arguments are copied when a call is made; a File or Blob is read afterwards.
 */
export class Client implements AsyncDisposable {
  readonly #platform: Platform;
  readonly #queue: Queue;

  private constructor(platform: Platform, queue: Queue) {
    this.#platform = platform;
    this.#queue = queue;
  }

  /** @internal */
  static async start(platform: Platform, options: ClientOptions = {}): Promise<Client> {
    checkOptions('createClient', options);
    const wasmModule = await compileWith(platform, options, wholeWasm);
    const queue = new Queue(platform, wasmModule, options);
    const client = new Client(platform, queue);
    try {
      await client.ready();
    } catch (error) {
      client.terminate();
      if (error instanceof HgpError && error.code !== 'worker-lost') throw error;
      const message = `The worker could not be started: ${messageOf(error)}`;
      throw unavailable(message, error);
    }
    // After the answer. Later workers also benefit, because they use the same compiled module.
    if (options.warmUp ?? true) queue.tell('warmUp');
    return client;
  }

  /** Starts the worker, with the models, if it is not running, so that the next call need not wait for it. */
  async ready(call?: CallOptions): Promise<void> {
    await this.#queue.add({ method: 'ready' }, () => [], call);
  }

  /**
   * Loads a mesh of a file. The model is in the worker's memory until it is disposed of or, at some time, when the
   * program has no reference to it.
   */
  async load(
    source: FileSource | FileSet,
    options: LoadOptions = {},
    call?: CallOptions,
  ): Promise<Model> {
    const prepare = (): Promise<unknown[]> => {
      checkOptions('load', options);
      const copy = structuredClone(options);
      return takeFiles(source, options.name, this.#platform.packed).then((files) => [files, copy]);
    };
    return this.#model('load', prepare, call);
  }

  /**
   * Loads a mesh that is not in a file, such as a three.js geometry. Vertices at equal positions are joined (`weld`).
   */
  loadMesh(mesh: MeshArrays & MeshLoadOptions, call?: CallOptions): Promise<Model> {
    const prepare = (): unknown[] => {
      const { arrays, load, solve } = partsOf('loadMesh', mesh);
      checkOptions('loadMesh', { ...load, ...solve });
      return [takeMesh(arrays), structuredClone(load)];
    };
    return this.#model('loadMesh', prepare, call);
  }

  /**
   * Maps a mesh that is not in a file; nothing stays in the worker. Vertices at equal positions are joined first
   * (`weld`). To write or measure the map, use loadMesh().
   */
  parametrizeMesh(mesh: MeshSolveOptions, call?: CallOptions): Promise<Result> {
    const prepare = (): unknown[] => {
      const { arrays, load, solve } = partsOf('parametrizeMesh', mesh);
      checkOptions('parametrize', solve);
      checkOptions('loadMesh', load);
      return [{ ...takeMesh(arrays), ...structuredClone({ ...load, ...solve }) }];
    };
    return this.#queue.add({ method: 'parametrizeMesh' }, prepare, call);
  }

  /**
   * Maps a mesh of a renderer, for the adapters: in single precision, with vertices at equal positions joined.
   * @internal
   */
  parametrizeRendered(
    mesh: MeshArrays,
    load: LoadOptions,
    solve: SolveOptions,
    call?: CallOptions,
  ): Promise<Result> {
    const prepare = (): unknown[] => {
      checkOptions('load', load);
      checkOptions('parametrize', solve);
      return [takeMesh(mesh), structuredClone(load), structuredClone(solve)];
    };
    return this.#queue.add({ method: 'parametrizeRendered' }, prepare, call);
  }

  /**
   * Maps every mesh of a file and returns the file with all maps, as `hgp param` does; nothing stays in the worker.
   * With `keepGoing`, a mesh without a map does not prevent the others from being written.
   */
  parametrizeFile(
    source: FileSource | FileSet,
    options: FileOptions = {},
    call?: CallOptions,
  ): Promise<FileResult> {
    const prepare = (): Promise<unknown[]> => {
      checkOptions('parametrizeFile', options);
      const copy = structuredClone(options);
      return takeFiles(source, options.name, this.#platform.packed).then((files) => [files, copy]);
    };
    return this.#queue.add({ method: 'parametrizeFile' }, prepare, call);
  }

  /**
   * Writes the maps of several meshes of one file, from which a model was loaded for each, into that file. `certified`
   * is whether all of them are.
   * @param options  for all maps, or for each of them
   */
  combine(
    maps: readonly UvMap[],
    options: CombineOptions | readonly CombineOptions[] = {},
    call?: CallOptions,
  ): Promise<Written> {
    const isList = Array.isArray(maps) && maps.every((map) => map instanceof UvMap);
    const isOwn = isList && maps.every((map) => UvMap.isOf(map, this.#queue));
    const needs = isOwn ? maps.map((map) => UvMap.idOf(map)) : [];
    const prepare = (): unknown[] => {
      if (!isList)
        throw usage('combine takes a list of maps that parametrize() of a model returned');
      if (maps.length === 0) throw usage('combine: there are no maps');
      if (!isOwn) throw usage('combine: a map is of another client; load its file in this one');
      const each = takeCombineOptions(needs.length, options);
      if (!this.#queue.isOfFile(needs[0]))
        throw usage('combine: the maps are of meshes of a file, not of arrays');
      return [needs, each];
    };
    return this.#queue.add({ method: 'combine', needs }, prepare, call);
  }

  /** Terminates the worker and disposes of all models; pending calls reject with `AbortError`. */
  terminate(): void {
    this.#queue.stop();
  }

  [Symbol.asyncDispose](): Promise<void> {
    this.terminate();
    return Promise.resolve();
  }

  async #model(
    method: string,
    prepare: () => unknown[] | Promise<unknown[]>,
    call?: CallOptions,
  ): Promise<Model> {
    const makes = this.#queue.newId();
    const info = await this.#queue.add<ModelInfo>({ method, makes }, prepare, call);
    return new Model(this.#queue, makes, info);
  }
}

/** The arrays, the options of loading and the other options. */
function partsOf(call: string, mesh: MeshSolveOptions) {
  if (typeof (mesh as unknown) !== 'object' || (mesh as unknown) === null) {
    throw usage(`${call} takes { positions, triangles, … }`);
  }
  const { positions, triangles, weld, fix, strict, limits, ...solve } = mesh;
  return { arrays: { positions, triangles }, load: { weld, fix, strict, limits }, solve };
}

defineDisposal(Client.prototype);
