// Messages between a client and its worker. One operation is one message, and has one answer; progress comes before it.

import type { HgpFailure } from './error.js';
import type { Leash } from './leash.js';
import type { Progress } from './results.js';

/** What makes a handle. A worker that does not have the handle makes it again: results are deterministic. */
export interface Recipe {
  id: number;
  method: string;
  /** The handle to which the call belongs. */
  on?: number;
  args: unknown[];
}

export interface Call {
  id: number;
  method: string;
  on?: number;
  /** The id of the handle that it makes. */
  makes?: number;
  args: unknown[];
  /** Makes handles that the call needs and this worker does not have, in this order. */
  restore: Recipe[];
  wantsProgress: boolean;
  /** By which it is asked to stop. */
  leash?: Leash;
}

export interface Answer {
  /** The call; 0: the worker cannot go on. */
  id: number;
  progress?: Progress;
  result?: unknown;
  error?: HgpFailure;
  /** The handles that the worker has after the call. */
  has?: number[];
}
