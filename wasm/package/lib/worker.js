// The worker: one Core, one call at a time. Messages in: { id, method, args, wantsProgress };
// messages out: { id, result }, { id, error } or { id, progress }.

import { HgpError } from './error.js';
import { unpacked } from './sources.js';

const progressInterval = 100; // milliseconds: at most ten reports a second

const methods = new Set([
  'load',
  'loadMesh',
  'inspect',
  'surface',
  'readCones',
  'embeddedCones',
  'suggestCones',
  'check',
  'parametrize',
  'parametrizeFile',
  'verify',
  'write',
  'measure',
  'facts',
  'keep',
  'recall',
  'loops',
  'quads',
]);

/** The buffers of all typed arrays in a result, which are transferred instead of copied. */
function buffersOf(value, found = new Set()) {
  if (ArrayBuffer.isView(value)) found.add(value.buffer);
  else if (value && typeof value === 'object') {
    for (const part of Object.values(value)) if (typeof part === 'object') buffersOf(part, found);
  }
  return found;
}

function throttled(report) {
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

async function handle(state, post, { id, method, args, wantsProgress }) {
  try {
    if (method === 'init') {
      state.core = await state.createCore({ wasmModule: args[0] });
      return;
    }
    const ready = state.core;
    if (method === 'ready') return post({ id, result: true }, []);
    if (method === 'warmUp') return ready.warmUp();
    if (!methods.has(method)) {
      throw new HgpError({ code: 'usage', message: `no such call: ${method}` });
    }
    ready.onProgress = wantsProgress
      ? throttled((progress) => post({ id, progress }, []))
      : undefined;
    // A file may have to be decompressed or need decoders.
    const [first, ...rest] = args;
    const isFile = method === 'load' || method === 'parametrizeFile';
    const input = isFile ? await ready.prepare(await unpacked(first), ...rest) : first;
    const result = ready[method](input, ...rest);
    if (id !== 0) post({ id, result }, [...buffersOf(result)]);
  } catch (error) {
    const { code = 'internal', message = String(error), details } = error;
    const isLost = !(error instanceof HgpError);
    post({ id: isLost ? 0 : id, error: { code, message, ...details } }, []);
  }
}

/** Handles messages one after another: the module may still be compiling when the second one arrives. */
export function serve(createCore, post) {
  const state = { createCore, core: undefined };
  let last = Promise.resolve();
  return (message) => {
    last = last.then(() => handle(state, post, message));
  };
}
