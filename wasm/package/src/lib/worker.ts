// The worker: one Core, one call at a time.

import { Core } from './core.js';
import { CoreMap } from './core_map.js';
import { CoreModel } from './core_model.js';
import { CoreDrag, type DragPath } from './drag.js';
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
import { stopTest } from './leash.js';
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

/** What the core calls during a call; undefined if nobody listens and nothing can stop it. */
function progressOf(
  { wantsProgress, leash }: Call,
  report: (progress: Progress) => void,
): Core['onProgress'] {
  const listen = wantsProgress ? throttled(report) : undefined;
  if (!leash) return listen;
  const isStopped = stopTest(leash);
  return (progress) => {
    listen?.(progress);
    return !isStopped();
  };
}

/** Methods of the handles that can be called by messages. */
const methodsOfModel = [
  ...['inspect', 'surface', 'facts', 'loops', 'placements', 'readCones', 'embeddedCones'],
  ...['suggestCones', 'balanceCones', 'transferCones', 'listFeatures', 'check', 'logScale'],
  ...['parametrize', 'verify', 'dragged'],
];
const methodsOfMap = ['write', 'measure', 'quads', 'beginDrag'];
const methodsOfDrag = ['dragTo', 'endDrag'];

/** Milliseconds without a call after which a drag prepares what the next positions need. */
const rest = 80;

/** The core with the models and maps that clients refer to by number. */
class Server {
  readonly #core: Core;
  readonly #models = new Map<number, CoreModel>();
  readonly #maps = new Map<number, { map: CoreMap; of: number }>();
  readonly #drags = new Map<number, { drag: CoreDrag; of: number }>();

  constructor(core: Core) {
    this.#core = core;
  }

  get has(): number[] {
    return [...this.#models.keys(), ...this.#maps.keys(), ...this.#drags.keys()];
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
      if (made instanceof CoreDrag) return undefined;
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
        const maps = (args[0] as number[]).flatMap((id) => this.#maps.get(id)?.map ?? []);
        return core.combine(maps, args[1] as CombineOptions[]);
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

  async #make({ id, method, on, args }: Recipe): Promise<CoreModel | CoreMap | CoreDrag> {
    if (on !== undefined) {
      const [first, path] = args as [number, DragPath?];
      const made = this.#callHandle(on, method, method === 'beginDrag' ? [first] : args);
      if (made instanceof CoreDrag) {
        this.#drags.set(id, { drag: made, of: on });
        return path ? made.repeat(path) : made;
      }
      const of = method === 'endDrag' ? this.#modelOf(on) : on;
      this.#maps.set(id, { map: made as CoreMap, of });
      return made as CoreMap;
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

  #modelOf(drag: number): number {
    return this.#maps.get(this.#drags.get(drag)?.of ?? 0)?.of ?? 0;
  }

  #callHandle(id: number, method: string, args: unknown[]): unknown {
    const handle =
      this.#models.get(id) ?? this.#maps.get(id)?.map ?? this.#drags.get(id)?.drag ?? undefined;
    if (!handle || !methodsOf(handle).includes(method))
      throw new HgpError({ code: 'usage', message: `no such call: ${method}` });
    const calls = handle as unknown as Record<string, (...args: unknown[]) => unknown>;
    const given =
      method === 'transferCones' ? [args[0], this.#models.get(args[1] as number)] : args;
    const result = calls[method](...given);
    if (!(handle instanceof CoreDrag) || method !== 'dragTo') return result;
    this.#dragged = handle;
    return { frame: result, path: handle.path };
  }
  #dragged?: CoreDrag;

  /** What can be done while nobody waits; what goes wrong here is found by the next call of the drag. */
  useRest(): void {
    try {
      this.#dragged?.prepare();
    } catch (error) {
      if (!(error instanceof HgpError)) throw error;
    } finally {
      this.#dragged = undefined;
    }
  }

  #release(id: number): void {
    for (const [other, { drag, of }] of [...this.#drags]) {
      if (other !== id && of !== id && this.#maps.get(of)?.of !== id) continue;
      drag.free();
      this.#drags.delete(other);
    }
    for (const [other, { map, of }] of [...this.#maps]) {
      if (other !== id && of !== id) continue;
      map.free();
      this.#maps.delete(other);
    }
    this.#models.get(id)?.free();
    this.#models.delete(id);
  }
}

function methodsOf(handle: CoreModel | CoreMap | CoreDrag): string[] {
  if (handle instanceof CoreModel) return methodsOfModel;
  return handle instanceof CoreMap ? methodsOfMap : methodsOfDrag;
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
    const { id } = call;
    try {
      if (call.method === 'init') {
        server = new Server(await createCore({ wasmModule: call.args[0] as WebAssembly.Module }));
        return;
      }
      if (!server) throw new Error('the worker was not initialized');
      server.onProgress = progressOf(call, (progress) => post({ id, progress }, []));
      const result = await server.perform(call);
      if (id !== 0) post({ id, result, has: server.has }, [...buffersOf(result)]);
    } catch (error) {
      // What is not an HgpError is a fault of the solver, whose state is then unknown.
      if (!(error instanceof HgpError)) post({ id: 0, error: faultOf(error) }, []);
      else post({ id, error: failureOf(error), has: server?.has ?? [] }, []);
    }
  };
  let last = Promise.resolve();
  let waiting = 0; // calls that have not ended
  let resting: ReturnType<typeof setTimeout> | undefined;
  return (message) => {
    waiting += 1;
    clearTimeout(resting);
    last = last
      .then(() => handle(message as Call))
      .then(() => {
        waiting -= 1;
        if (waiting === 0) resting = setTimeout(() => server?.useRest(), rest);
      });
  };
}

const faultOf = (error: unknown): HgpFailure => ({ code: 'internal', message: messageOf(error) });
