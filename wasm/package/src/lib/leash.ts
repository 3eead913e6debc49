// Asks a worker to stop its call at the next report of progress, where it cannot read messages: WebAssembly runs to its
// end first. With shared memory that is a number; elsewhere it is a Blob that can be read until it is revoked.

/** What the worker looks at. */
export type Leash = { shared: Int32Array } | { url: string };

const interval = 20; // milliseconds between two looks

// Browsers have shared memory only on isolated pages; others do not define that word.
const isShareable = (): boolean =>
  typeof SharedArrayBuffer === 'function' &&
  (globalThis as { crossOriginIsolated?: boolean }).crossOriginIsolated !== false;

/** The other end of a leash. */
export class Stopper {
  readonly leash: Leash;

  constructor() {
    this.leash = isShareable()
      ? { shared: new Int32Array(new SharedArrayBuffer(4)) }
      : { url: URL.createObjectURL(new Blob(['go on'])) };
  }

  /** Asks the call to stop; also frees the leash of a call that has ended. */
  stop(): void {
    if ('shared' in this.leash) Atomics.store(this.leash.shared, 0, 1);
    else URL.revokeObjectURL(this.leash.url);
  }
}

function isReadable(url: string): boolean {
  try {
    const request = new XMLHttpRequest();
    request.open('GET', url, false);
    request.send();
    return true;
  } catch {
    return false;
  }
}

/** Whether a Blob can be read at all; a Content-Security-Policy may not allow it (connect-src blob:). */
function canRead(): boolean {
  if (typeof XMLHttpRequest !== 'function') return false;
  const url = URL.createObjectURL(new Blob(['']));
  const can = isReadable(url);
  URL.revokeObjectURL(url);
  return can;
}
let reads: boolean | undefined;

/** In the worker: whether a call on this leash shall stop. Where that cannot be known, it goes on to its end. */
export function stopTest(leash: Leash): () => boolean {
  if ('shared' in leash) return () => Atomics.load(leash.shared, 0) !== 0;
  reads ??= canRead();
  if (!reads) return () => false;
  let last = -Infinity;
  let isStopped = false;
  return () => {
    const now = performance.now();
    if (isStopped || now - last < interval) return isStopped;
    last = now;
    isStopped = !isReadable(leash.url);
    return isStopped;
  };
}
