// What all handles of a client have in common.

import { checkOptions, type CallName } from './check_options.js';
import type { Queue } from './queue.js';

/** Releases handles that a program has lost. */
export const lost = new FinalizationRegistry<{ queue: Queue; id: number }>(
  ({ queue, id }) => void queue.release(id),
);

/** A checked copy of options, which the caller may change before the call runs. */
export function taken(call: CallName, options: object): object {
  checkOptions(call, options);
  return structuredClone(options);
}
