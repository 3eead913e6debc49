// The worker: one Core, one call at a time.

import { Core, CoreMap, CoreModel } from './core.js';
import { HgpError, messageOf, type HgpFailure } from './error.js';
import type {
  CombineOptions,
  FileOptions,
  InitOptions,
  LoadOptions,
  MeshArrays,
  MeshLoadOptions,
  MeshSolveOptions,
  SolveOptions,
} from './options.js';
import type { Answer, Call, Recipe } from './protocol.js';
import type { Progress } from './results.js';
import { unpacked, type PackedFiles } from './sources.js';
import { failureOf } from './whole_file.js';

const progressInterval = 100; // milliseconds: at most ten reports a second

type Post = (message: Answer, transfer: ArrayBuffer[]) => void;

/** The buffers of all typed arrays in a result, which are transferred instead of copied. */
function buffersOf(value: unknown, found = new Set<ArrayBuffer>()): Set<ArrayBuffer> {
  if (ArrayBuffer.isView(value)) found.add(value.buffer as ArrayBuffer);
  else if (value !== null && typeof value === 'object') {
    for (const part of Object.values(value) as unknown[])
      if (typeof part === 'object') buffersOf(part, found);
  }
  return found;
}

function throttled(report: (progress: Progress) => void): (progress: Progress) => boolean {
  let last = -Infinity;
  return (progress) => {
    const now = performance.now();
    if (now - last >= progressInterval) {
      last = now;
      report(progress);
    }
    return true;
  };
}

/** Methods of the handles that can be called by messages. */
const methodsOfModel = [
  ...['inspect', 'surface', 'facts', 'loops', 'readCones', 'embeddedCones'],
  ...['suggestCones', 'check', 'parametrize', 'verify'],
];
const methodsOfMap = ['write', 'measure', 'quads'];

/** The core with the models and maps that clients refer to by number. */
class Server {
  readonly #core: Core;
  readonly #models = new Map<number, CoreModel>();
  readonly #maps = new Map<number, { map: CoreMap; of: number }>();

  constructor(core: Core) {
    this.#core = core;
  }

  get has(): number[] {
    return [...this.#models.keys(), ...this.#maps.keys()];
  }

  async perform({ method, on, makes, args, restore }: Call): Promise<unknown> {
    for (const recipe of restore) {
      const made = await this.#make(recipe);
      // Its numbers are in the program already.
      if (made instanceof CoreMap) structuredClone(0, { transfer: [...buffersOf(made.data)] });
    }
    if (makes !== undefined) {
      const made = await this.#make({
        id: makes,
        method,
        args,
        ...(on === undefined ? {} : { on }),
      });
      return made instanceof CoreMap ? made.data : made.info;
    }
    if (on !== undefined) return this.#callHandle(on, method, args);
    const core = this.#core;
    switch (method) {
      case 'ready':
        return true;
      case 'warmUp':
        core.warmUp();
        return undefined;
      case 'parametrizeMesh':
        return core.parametrizeMesh(args[0] as MeshSolveOptions);
      case 'parametrizeRendered':
        return core.parametrizeRendered(
          args[0] as MeshArrays,
          args[1] as LoadOptions,
          args[2] as SolveOptions,
        );
      case 'parametrizeFile': {
        const options = args[1] as FileOptions;
        const files = await core.prepare(await unpacked(args[0] as PackedFiles), options);
        return core.parametrizeFile(files, options);
      }
      case 'combine': {
        const files = await core.prepare(await unpacked(args[0] as PackedFiles));
        const maps = (args[1] as number[]).flatMap((id) => this.#maps.get(id)?.map ?? []);
        return core.combine(files, maps, args[2] as CombineOptions[]);
      }
      case 'release':
        this.#release(args[0] as number);
        return undefined;
      default:
        throw new HgpError({ code: 'usage', message: `no such call: ${method}` });
    }
  }

  set onProgress(report: Core['onProgress']) {
    this.#core.onProgress = report;
  }

  async #make({ id, method, on, args }: Recipe): Promise<CoreModel | CoreMap> {
    if (on !== undefined) {
      const map = this.#callHandle(on, method, args) as CoreMap;
      this.#maps.set(id, { map, of: on });
      return map;
    }
    const model =
      method === 'load'
        ? await this.#load(args[0] as PackedFiles, args[1] as LoadOptions)
        : this.#core.loadMesh(args[0] as MeshArrays, args[1] as MeshLoadOptions);
    this.#models.set(id, model);
    return model;
  }

  /** A file may have to be decompressed or need decoders. */
  async #load(files: PackedFiles, options: LoadOptions): Promise<CoreModel> {
    return this.#core.load(await this.#core.prepare(await unpacked(files), options), options);
  }

  #callHandle(id: number, method: string, args: unknown[]): unknown {
    const handle = this.#models.get(id) ?? this.#maps.get(id)?.map;
    const methods = handle instanceof CoreModel ? methodsOfModel : methodsOfMap;
    if (!handle || !methods.includes(method))
      throw new HgpError({ code: 'usage', message: `no such call: ${method}` });
    const calls = handle as unknown as Record<string, (...args: unknown[]) => unknown>;
    return calls[method](...args);
  }

  #release(id: number): void {
    for (const [other, { map, of }] of [...this.#maps]) {
      if (other !== id && of !== id) continue;
      map.free();
      this.#maps.delete(other);
    }
    this.#models.get(id)?.free();
    this.#models.delete(id);
  }
}

/**
 * Handles messages one after another: the module may still be compiling when the second one arrives.
 * @internal
 */
export function serve(
  createCore: (options: InitOptions) => Promise<Core>,
  post: Post,
): (message: unknown) => void {
  let server: Server | undefined;
  const handle = async (call: Call): Promise<void> => {
    const { id, wantsProgress } = call;
    try {
      if (call.method === 'init') {
        server = new Server(await createCore({ wasmModule: call.args[0] as WebAssembly.Module }));
        return;
      }
      if (!server) throw new Error('the worker was not initialized');
      server.onProgress = wantsProgress
        ? throttled((progress) => post({ id, progress }, []))
        : undefined;
      const result = await server.perform(call);
      if (id !== 0) post({ id, result, has: server.has }, [...buffersOf(result)]);
    } catch (error) {
      // What is not an HgpError is a fault of the solver, whose state is then unknown.
      if (!(error instanceof HgpError)) post({ id: 0, error: faultOf(error) }, []);
      else post({ id, error: failureOf(error), has: server?.has ?? [] }, []);
    }
  };
  let last = Promise.resolve();
  return (message) => {
    last = last.then(() => handle(message as Call));
  };
}

const faultOf = (error: unknown): HgpFailure => ({ code: 'internal', message: messageOf(error) });
