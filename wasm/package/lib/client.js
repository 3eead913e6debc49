// The client: every call runs in a worker, can be cancelled and reports progress. Differences between
// browsers and Node are in the platform layer passed to it.

import { compileWith } from './compile.js';
import { HgpError, unavailable, usage } from './error.js';
import { checkConeFile, checkCones, checkOptions } from './options.js';
import { toFileSet, toMeshArrays } from './sources.js';

/** The error of a cancelled call if the signal has no reason of its own. */
const cancelled = () => new DOMException('The operation was cancelled.', 'AbortError');

export async function startClient(platform, options = {}) {
  return Client.start(platform, await compileWith(platform, options), options);
}

class Client {
  #platform;
  #wasmModule;
  #options;
  #worker; // a promise while it starts
  #queue = [];
  #current;
  #nextId = 1;
  #source; // the source of the last successful load or parametrizeMesh, which a new worker loads again

  constructor(platform, wasmModule, options) {
    this.#platform = platform;
    this.#wasmModule = wasmModule;
    this.#options = options;
  }

  static async start(platform, wasmModule, options) {
    const client = new Client(platform, wasmModule, options);
    await client.#call('ready', []).catch((error) => {
      client.terminate();
      throw error.code === 'worker-lost' ? unavailable(error.message, error) : error;
    });
    // After the answer. Later workers also benefit, because they use the same compiled module.
    if (options.warmUp ?? true) client.#running.post({ id: 0, method: 'warmUp', args: [] });
    return client;
  }

  /** Starts the worker, with the model, if it is not running, so that the next call need not wait for it. */
  async ready(call) {
    await this.#call('ready', [], call);
  }

  async load(source, options = {}, call = {}) {
    checkOptions('load', options);
    const args = [await toFileSet(source, options.name, this.#platform.packed), options];
    const info = await this.#call('load', args, call);
    this.#source = ['load', args];
    return info;
  }

  inspect(call) {
    return this.#call('inspect', [], call);
  }

  surface(call) {
    return this.#call('surface', [], call);
  }

  async readCones(file, call) {
    checkConeFile('readCones', file);
    return this.#call('readCones', [file], call);
  }

  embeddedCones(call) {
    return this.#call('embeddedCones', [], call);
  }

  async suggestCones(options = {}, call) {
    checkOptions('suggestCones', options);
    return this.#call('suggestCones', [options], call);
  }

  async check(cones, call) {
    checkCones('check', cones);
    return this.#call('check', [cones], call);
  }

  async parametrize(options = {}, call) {
    checkOptions('parametrize', options);
    return this.#call('parametrize', [options], call);
  }

  async parametrizeMesh(mesh, call) {
    if (mesh === null || typeof mesh !== 'object') {
      throw usage('parametrizeMesh takes { positions, triangles, … }');
    }
    const { positions, triangles, weld, fix, strict, limits, ...options } = mesh;
    checkOptions('parametrize', options);
    checkOptions('load', { weld: weld === false ? undefined : weld, fix, strict, limits });
    const args = [toMeshArrays({ positions, triangles }), { weld, fix, strict, limits }];
    await this.#call('loadMesh', args, call);
    this.#source = ['loadMesh', args];
    return this.#call('parametrize', [options], call);
  }

  async parametrizeFile(source, options = {}, call = {}) {
    checkOptions('parametrizeFile', options);
    const { weld, fix, strict, writeRepairs, limits, target, name } = options;
    const files = await toFileSet(source, name, this.#platform.packed);
    const result = await this.#call('parametrizeFile', [files, options], call);
    this.#source = ['load', [files, { weld, fix, strict, writeRepairs, limits, target }]];
    return result;
  }

  async verify(options = {}, call) {
    checkOptions('verify', options);
    return this.#call('verify', [options], call);
  }

  async write(options = {}, call) {
    checkOptions('write', options);
    return this.#call('write', [options], call);
  }

  measure(call) {
    return this.#call('measure', [], call);
  }

  async keep(name, call) {
    await this.#call('keep', [name], call);
  }

  recall(name, call) {
    return this.#call('recall', [name], call);
  }

  facts(call) {
    return this.#call('facts', [], call);
  }

  loops(call) {
    return this.#call('loops', [], call);
  }

  async quads(options = {}, call) {
    checkOptions('quads', options);
    return this.#call('quads', [options], call);
  }

  /** Terminates the worker, drops the model and rejects all pending calls. */
  terminate() {
    this.#stopWorker();
    this.#source = undefined;
    const pending = [this.#current, ...this.#queue];
    this.#current = undefined;
    this.#queue = [];
    for (const job of pending) job?.reject(cancelled());
  }

  async [Symbol.asyncDispose ?? Symbol.for('Symbol.asyncDispose')]() {
    this.terminate();
  }

  /** @param {import('../index.js').CallOptions} [call] */
  #call(method, args, call = {}) {
    const { signal, onProgress } = call;
    return new Promise((resolve, reject) => {
      if (signal?.aborted) return reject(signal.reason);
      const job = { id: this.#nextId++, method, args, onProgress };
      const onAbort = () => this.#abort(job, signal?.reason);
      const settled = (settle) => (value) => {
        signal?.removeEventListener('abort', onAbort);
        settle(value);
      };
      job.resolve = settled(resolve);
      job.reject = settled(reject);
      signal?.addEventListener('abort', onAbort, { once: true });
      this.#queue.push(job);
      this.#next();
    });
  }

  /** Starts the next call: one at a time, so that a waiting call can be cancelled without affecting the running one. */
  #next() {
    if (this.#current || this.#queue.length === 0) return;
    const job = (this.#current = this.#queue.shift());
    this.#send(job).catch((error) => {
      if (this.#current === job) this.#stopWorker();
      this.#finish(job, job.reject, error);
    });
  }

  async #send(job) {
    const isFresh = this.#worker === undefined;
    this.#worker ??= this.#start();
    const worker = await this.#worker;
    if (this.#current !== job) return; // cancelled while the worker started
    worker.busy();
    if (isFresh && this.#source && !/^(load|parametrizeFile)/.test(job.method)) {
      const [method, args] = this.#source;
      worker.post({ id: 0, method, args });
    }
    const { id, method, args, onProgress } = job;
    worker.post({ id, method, args, wantsProgress: onProgress !== undefined });
  }

  async #start() {
    const worker = await this.#platform.startWorker(this.#options);
    const isCurrent = () => this.#running === worker;
    this.#running = worker;
    worker.onMessage((message) => isCurrent() && this.#receive(message));
    worker.onLost((reason) => isCurrent() && this.#lost(reason));
    worker.post({ id: 0, method: 'init', args: [this.#wasmModule] });
    return worker;
  }
  #running;

  #receive({ id, result, error, progress }) {
    const job = this.#current;
    if (id === 0) {
      if (error) this.#lost(error.message);
      return;
    }
    if (job?.id !== id) return;
    if (progress) {
      this.#report(job, progress);
    } else if (error) {
      this.#finish(job, job.reject, new HgpError(error));
    } else {
      this.#finish(job, job.resolve, result);
    }
  }

  /** Reports progress; if the callback throws, its call is rejected with that error. */
  #report(job, progress) {
    try {
      job.onProgress?.(progress);
    } catch (error) {
      this.#abort(job, error);
    }
  }

  #finish(job, settle, value) {
    if (this.#current === job) this.#current = undefined;
    this.#running?.idle();
    settle(value);
    this.#next();
  }

  #abort(job, reason) {
    if (this.#current === job) {
      // WebAssembly receives no messages while it runs, so cancelling means terminating the worker.
      this.#stopWorker();
      this.#finish(job, job.reject, reason);
    } else {
      this.#queue = this.#queue.filter((other) => other !== job);
      job.reject(reason);
    }
  }

  #lost(reason) {
    const job = this.#current;
    this.#stopWorker();
    const message = `The solver stopped unexpectedly (${reason}). The next call starts a new one.`;
    if (job) this.#finish(job, job.reject, new HgpError({ code: 'worker-lost', message }));
  }

  #stopWorker() {
    const starting = this.#worker;
    this.#running = undefined;
    this.#worker = undefined;
    starting?.then(
      (worker) => worker.terminate(),
      () => {},
    );
  }
}
