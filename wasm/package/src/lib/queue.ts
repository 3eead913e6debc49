// The calls of a client: one after another, in the order in which they were made, in one worker. A call takes its place
// when it is made, even if its arguments are still being read. Cancelling the running call ends the worker; the next
// call starts another, which makes the handles that it needs again.

import { checkOptions } from './check_options.js';
import { HgpError, usage } from './error.js';
import type { CallOptions, ClientOptions } from './client.js';
import { Stopper } from './leash.js';
import type { Platform, WorkerLink } from './platform.js';
import type { Answer, Call, Recipe } from './protocol.js';

/** What is asked of the worker, apart from the arguments. */
type Request = Pick<Call, 'method' | 'on' | 'makes'> & {
  /** Further handles that it needs. */
  needs?: number[];
  /**
   * Makes it a preview, and is its result if another preview of the same handle is made while it waits: at most one of
   * them waits. Aborting a preview never ends the worker, whose answer is then ignored.
   */
  superseded?: object;
  /** Called with the result before the next call is sent; returns the recipe of the handle that was made, if it is not this call. */
  learn?: (result: unknown) => Omit<Recipe, 'id'> | undefined;
};

interface Job extends Request {
  readonly id: number;
  readonly args: Promise<unknown[]>;
  readonly onProgress: CallOptions['onProgress'];
  /** Of a call that is not cancelled by ending the worker. */
  readonly stopper: Stopper | undefined;
  isAborted: boolean;
  /** The arguments, once it is sent. */
  sent: unknown[] | undefined;
  resolve(value: unknown): void;
  reject(reason: unknown): void;
}

/** The error of a cancelled call if the signal has no reason of its own. */
const cancelled = (): DOMException =>
  new DOMException('The operation was cancelled.', 'AbortError');

export class Queue {
  readonly #platform: Platform;
  readonly #wasmModule: WebAssembly.Module;
  readonly #options: ClientOptions;
  #waiting: Job[] = [];
  #current: Job | undefined;
  #starting: Promise<WorkerLink> | undefined;
  #running: WorkerLink | undefined;
  #hasAnswered = false;
  #nextId = 1;
  /** Of every handle that is not released. */
  readonly #recipes = new Map<number, Recipe>();
  /** Handles that may be used in new calls. */
  readonly #live = new Set<number>();
  /** Handles that the running worker has. */
  #there = new Set<number>();

  constructor(platform: Platform, wasmModule: WebAssembly.Module, options: ClientOptions) {
    this.#platform = platform;
    this.#wasmModule = wasmModule;
    this.#options = options;
  }

  newId(): number {
    return this.#nextId++;
  }

  /**
   * Queues a call. `prepare` is executed now; what it throws, or its promise rejects with, is the outcome of the call.
   */
  add<T>(
    request: Request,
    prepare: () => unknown[] | Promise<unknown[]>,
    call: CallOptions = {},
  ): Promise<T> {
    return new Promise((resolve, reject) => {
      checkOptions('call', call);
      const { signal, onProgress, keepWorker } = call;
      for (const handle of [request.on, ...(request.needs ?? [])]) this.#requireLive(handle);
      const args = Promise.resolve(prepare());
      args.catch(() => undefined); // the call reports it when its turn comes
      if (signal?.aborted) throw signal.reason;
      const onAbort = (): void => this.#abort(job, signal?.reason);
      const settled =
        <V>(settle: (value: V) => void) =>
        (value: V): void => {
          signal?.removeEventListener('abort', onAbort);
          settle(value);
        };
      const job: Job = {
        ...request,
        id: this.newId(),
        args,
        onProgress,
        stopper: keepWorker ? new Stopper() : undefined,
        isAborted: false,
        sent: undefined,
        resolve: settled(resolve as (value: unknown) => void),
        reject: settled(reject),
      };
      signal?.addEventListener('abort', onAbort, { once: true });
      if (job.superseded) this.#supersede(job.on);
      this.#waiting.push(job);
      this.#next();
    });
  }

  /** Whether a handle may still be used. */
  isLive(id: number): boolean {
    const { on } = this.#recipes.get(id) ?? {};
    return this.#live.has(id) && (on === undefined || this.isLive(on));
  }

  /** How a worker makes a handle; undefined if it was released. */
  recipeOf(id: number): Recipe | undefined {
    return this.#recipes.get(id);
  }

  /** Whether the model of a map was loaded from files. */
  isOfFile(map: number): boolean {
    return this.#recipes.get(this.#recipes.get(map)?.on ?? 0)?.method === 'load';
  }

  /** Releases a handle, after the calls made before. */
  release(id: number): Promise<void> {
    if (!this.#live.delete(id)) return Promise.resolve();
    return this.add({ method: 'release' }, () => [id]);
  }

  /** Sends something that has no answer, if a worker is running. */
  tell(method: string): void {
    this.#running?.post({ id: 0, method, args: [], restore: [], wantsProgress: false }, []);
  }

  /** Ends the worker, releases all handles and rejects all calls. */
  stop(): void {
    this.#stopWorker();
    this.#recipes.clear();
    this.#live.clear();
    const pending = this.#current ? [this.#current, ...this.#waiting] : this.#waiting;
    this.#current = undefined;
    this.#waiting = [];
    for (const job of pending) {
      job.stopper?.stop();
      if (job.method === 'release') job.resolve(undefined);
      else job.reject(cancelled());
    }
  }

  /** Takes the waiting preview of a handle out of the queue. */
  #supersede(handle: number | undefined): void {
    const isOld = (job: Job): boolean => job.superseded !== undefined && job.on === handle;
    const old = this.#waiting.filter(isOld);
    this.#waiting = this.#waiting.filter((job) => !isOld(job));
    for (const job of old) job.resolve(job.superseded);
  }

  #requireLive(id: number | undefined): void {
    if (id !== undefined && !this.isLive(id))
      throw usage('this model or map was disposed of, or its client was terminated');
  }

  #next(): void {
    const job = this.#current ? undefined : this.#waiting.shift();
    if (!job) return;
    this.#current = job;
    this.#send(job).catch((error: unknown) => {
      if (this.#current !== job) return;
      if (job.sent) this.#stopWorker();
      this.#finish(job, () => job.reject(error));
    });
  }

  async #send(job: Job): Promise<void> {
    const args = await job.args;
    if (this.#current !== job) return; // cancelled while they were read
    if (job.method === 'release' && !this.#forget(args[0] as number)) {
      this.#finish(job, () => job.resolve(undefined));
      return;
    }
    this.#starting ??= Promise.resolve(this.#start());
    let worker: WorkerLink;
    try {
      worker = await this.#starting;
    } catch (error) {
      this.#stopWorker();
      throw error;
    }
    if (this.#current !== job) return; // cancelled while the worker started
    worker.busy();
    const { id, method, on, makes, onProgress, stopper } = job;
    const wantsProgress = onProgress !== undefined;
    const restore = this.#missing(job);
    const leash = stopper && { leash: stopper.leash };
    worker.post({ id, method, on, makes, args, restore, wantsProgress, ...leash }, []);
    job.sent = args;
  }

  /** Forgets a handle and those that belong to it; false if the worker has none of them. */
  #forget(id: number): boolean {
    let isThere = false;
    const isOf = (other: number): boolean => this.#chainTo(other).includes(id);
    for (const other of [...this.#recipes.keys(), id].filter(isOf)) {
      this.#recipes.delete(other);
      this.#live.delete(other);
      isThere = this.#there.delete(other) || isThere;
    }
    return isThere;
  }

  /** The recipes of what a call needs and the worker does not have. `ready` prepares all models. */
  #missing({ method, on, needs = [] }: Job): Recipe[] {
    const isModel = ({ on: of }: Recipe): boolean => of === undefined;
    const models = [...this.#recipes.values()].filter(isModel).map(({ id }) => id);
    const wanted = method === 'ready' ? models : on === undefined ? needs : [on, ...needs];
    const chain = wanted.flatMap((id) => this.#chainTo(id));
    return [...new Set(chain)].flatMap((id) => {
      const recipe = this.#there.has(id) ? undefined : this.#recipes.get(id);
      return recipe ? [recipe] : [];
    });
  }

  /** A handle after those to which it belongs: a model, a map of it, a drag of that. */
  #chainTo(id: number): number[] {
    const of = this.#recipes.get(id)?.on;
    return of === undefined ? [id] : [...this.#chainTo(of), id];
  }

  async #start(): Promise<WorkerLink> {
    const worker = await this.#platform.startWorker(this.#options);
    const isCurrent = (): boolean => this.#running === worker;
    this.#running = worker;
    worker.onMessage((message) => {
      if (isCurrent()) this.#receive(message as Answer);
    });
    worker.onLost((reason) => {
      if (isCurrent()) this.#lost(reason);
    });
    const args = [this.#wasmModule];
    worker.post({ id: 0, method: 'init', args, restore: [], wantsProgress: false }, []);
    return worker;
  }

  #receive({ id, result, error, progress, has }: Answer): void {
    const job = this.#current;
    if (id === 0) {
      if (error) this.#lost(error.message);
      return;
    }
    if (job?.id !== id) return;
    this.#hasAnswered = true;
    if (progress) {
      if (!job.isAborted) this.#report(job, progress);
      return;
    }
    if (has) this.#there = new Set(has);
    if (error) this.#finish(job, () => job.reject(new HgpError(error)));
    else this.#finish(job, () => this.#succeed(job, result));
  }

  #succeed(job: Job, result: unknown): void {
    const { makes, method, on, sent = [], learn } = job;
    const recipe = learn?.(result) ?? { method, on, args: sent };
    if (makes !== undefined) {
      this.#recipes.set(makes, { id: makes, ...recipe });
      this.#live.add(makes);
      if (job.isAborted) void this.release(makes); // nobody has it
    }
    job.resolve(result);
  }

  /** Reports progress; if the callback throws, its call is rejected with that error. */
  #report(job: Job, progress: NonNullable<Answer['progress']>): void {
    try {
      job.onProgress?.(progress);
    } catch (error) {
      this.#abort(job, error);
    }
  }

  #finish(job: Job, settle: () => void): void {
    if (this.#current === job) this.#current = undefined;
    this.#running?.idle();
    job.stopper?.stop();
    settle();
    this.#next();
  }

  #abort(job: Job, reason: unknown): void {
    if (this.#current === job && (job.superseded ?? job.stopper) && job.sent) {
      job.isAborted = true;
      job.stopper?.stop();
      job.reject(reason);
    } else if (this.#current === job) {
      // WebAssembly receives no messages while it runs, so cancelling means terminating the worker.
      if (job.sent) this.#stopWorker();
      this.#finish(job, () => job.reject(reason));
    } else {
      this.#waiting = this.#waiting.filter((other) => other !== job);
      job.stopper?.stop();
      job.reject(reason);
    }
  }

  #lost(reason: string): void {
    const job = this.#current;
    this.#stopWorker();
    // Before its first answer, a client returns nothing whose next call could start another worker.
    const message = this.#hasAnswered
      ? `The solver stopped unexpectedly (${reason}). The next call starts a new one.`
      : reason;
    if (job) this.#finish(job, () => job.reject(new HgpError({ code: 'worker-lost', message })));
  }

  #stopWorker(): void {
    const starting = this.#starting;
    this.#running = undefined;
    this.#starting = undefined;
    this.#there = new Set();
    starting?.then(
      (worker) => worker.terminate(),
      () => undefined,
    );
  }
}
