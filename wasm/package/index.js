// The client: every call runs in a worker, can be cancelled and reports progress. The same file
// serves browsers and Node.

import { compile, HgpError } from './core.js';

export { HgpError };

const isNode = typeof process === 'object' && Boolean(process.versions?.node);

const abortError = (reason) =>
  reason instanceof Error && reason.name === 'AbortError'
    ? reason
    : new DOMException('The operation was cancelled.', 'AbortError');

/** Starts a worker and gives it one face: post, onMessage, onLost, idle, busy, terminate. */
async function startWorker(createWorker) {
  if (!isNode || createWorker) {
    const worker = createWorker
      ? createWorker()
      : new Worker(new URL('./worker.js', import.meta.url), { type: 'module' });
    return {
      post: (message) => worker.postMessage(message),
      onMessage: (take) => worker.addEventListener('message', ({ data }) => take(data)),
      onLost: (take) => {
        worker.addEventListener('error', (event) => take(event.message ?? 'script error'));
        worker.addEventListener('messageerror', () => take('unreadable message'));
      },
      idle() {},
      busy() {},
      terminate: () => worker.terminate(),
    };
  }
  const { Worker: NodeWorker } = await import(/* @vite-ignore */ 'node:worker_threads');
  const script = new URL('./worker.js', import.meta.url);
  // The script's own flags (--input-type, --test …) are not the worker's.
  const worker = new NodeWorker(script, { execArgv: [] });
  return {
    post: (message) => worker.postMessage(message),
    onMessage: (take) => worker.on('message', take),
    onLost: (take) => {
      worker.on('error', (error) => take(error.message));
      worker.on('exit', (code) => take(`exit code ${code}`));
    },
    // A waiting worker must not keep a finished script alive.
    idle: () => worker.unref(),
    busy: () => worker.ref(),
    terminate: () => void worker.terminate(),
  };
}

const bytesOf = async (source) =>
  source instanceof Uint8Array ? source : new Uint8Array(await source.arrayBuffer());

/** File, Blob, bytes or FileSet → { main, files: Map<name, Uint8Array> }. */
async function toFileSet(source, name) {
  if (source?.files instanceof Map) {
    const files = new Map();
    for (const [key, value] of source.files) files.set(key, await bytesOf(value));
    return { main: source.main, files };
  }
  const main = name ?? source.name ?? '';
  return { main, files: new Map([[main, await bytesOf(source)]]) };
}

export async function createClient(options = {}) {
  return Client.start(await compile(options), options);
}

class Client {
  #wasmModule;
  #options;
  #worker; // a promise while it starts
  #queue = [];
  #current;
  #nextId = 1;
  #source; // what the last successful load or parametrizeMesh took; a fresh worker needs it again

  constructor(wasmModule, options) {
    this.#wasmModule = wasmModule;
    this.#options = options;
  }

  static async start(wasmModule, options) {
    const client = new Client(wasmModule, options);
    await client.#call('ready', []);
    // Behind the answer. Later workers profit too, for they run the same compiled module.
    if (options.warmUp ?? true) client.#running.post({ id: 0, method: 'warmUp', args: [] });
    return client;
  }

  /** Starts the worker where there is none, with the model, so that the next call need not wait. */
  async ready(call) {
    await this.#call('ready', [], call);
  }

  async load(source, options = {}, call = {}) {
    const args = [await toFileSet(source, options.name), options];
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

  readCones(file, call) {
    return this.#call('readCones', [file], call);
  }

  embeddedCones(call) {
    return this.#call('embeddedCones', [], call);
  }

  suggestCones(options, call) {
    return this.#call('suggestCones', [options], call);
  }

  check(cones, call) {
    return this.#call('check', [cones], call);
  }

  parametrize(options = {}, call) {
    return this.#call('parametrize', [options], call);
  }

  async parametrizeMesh({ positions, triangles, ...options }, call) {
    const args = [{ positions, triangles }];
    await this.#call('loadMesh', args, call);
    this.#source = ['loadMesh', args];
    return this.#call('parametrize', [options], call);
  }

  verify(options = {}, call) {
    return this.#call('verify', [options], call);
  }

  write(options = {}, call) {
    return this.#call('write', [options], call);
  }

  /** Ends the worker, forgets the model and rejects whatever is pending. */
  terminate() {
    this.#stopWorker();
    this.#source = undefined;
    const pending = [this.#current, ...this.#queue];
    this.#current = undefined;
    this.#queue = [];
    for (const job of pending) job?.reject(abortError());
  }

  async [Symbol.asyncDispose ?? Symbol.for('Symbol.asyncDispose')]() {
    this.terminate();
  }

  #call(method, args, { signal, onProgress } = {}) {
    return new Promise((resolve, reject) => {
      if (signal?.aborted) return reject(abortError(signal.reason));
      const job = { id: this.#nextId++, method, args, onProgress };
      const onAbort = () => this.#abort(job, signal.reason);
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

  /** One call at a time: a waiting call is cancelled without hurting the running one. */
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
    if (isFresh && this.#source && !job.method.startsWith('load')) {
      const [method, args] = this.#source;
      worker.post({ id: 0, method, args });
    }
    const { id, method, args, onProgress } = job;
    worker.post({ id, method, args, wantsProgress: onProgress !== undefined });
  }

  async #start() {
    const worker = await startWorker(this.#options.createWorker);
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
      job.onProgress?.(progress);
    } else if (error) {
      this.#finish(job, job.reject, new HgpError(error));
    } else {
      this.#finish(job, job.resolve, result);
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
      // WebAssembly reads no messages while it works: cancelling means ending the worker.
      this.#stopWorker();
      this.#finish(job, job.reject, abortError(reason));
    } else {
      this.#queue = this.#queue.filter((other) => other !== job);
      job.reject(abortError(reason));
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
