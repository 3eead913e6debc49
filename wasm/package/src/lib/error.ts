// The error class of this package.

import type { Note } from './documents.js';
import { withAdvice } from './phrases.js';
import type { HgpErrorCode, Where } from './results.js';

/** An error with the same code on the page, in this package and on the command line. */
export class HgpError extends Error {
  readonly code: HgpErrorCode;
  /** The step in which it happened. */
  readonly stage: string | undefined;
  /** Places on the mesh or in the file. */
  readonly where: Where[] | undefined;
  /** The message without the sentences of `advice`, for programs that phrase these themselves. */
  readonly rule: string;
  /** What to do, as codes: sentences of the message already name options of this package. */
  readonly advice: Note[] | undefined;

  constructor(
    { code, message, stage, where, advice }: HgpFailure,
    options?: {
      /** What caused it. */
      cause?: unknown;
    },
  ) {
    super(withAdvice(message, advice), options);
    this.name = 'HgpError';
    this.code = code;
    this.stage = stage;
    this.where = where;
    this.rule = message;
    this.advice = advice;
  }

  /** `stage`, `where` and `advice`. */
  get details(): { stage?: string; where?: Where[]; advice?: Note[] } {
    return {
      ...(this.stage === undefined ? {} : { stage: this.stage }),
      ...(this.where === undefined ? {} : { where: this.where }),
      ...(this.advice === undefined ? {} : { advice: this.advice }),
    };
  }
}

/** What an HgpError says, as plain data. */
export interface HgpFailure {
  code: HgpErrorCode;
  message: string;
  stage?: string;
  where?: Where[];
  /** What to do, where that is not in the message. */
  advice?: Note[];
}

/**
 * The error of a call with invalid arguments.
 * @internal
 */
export const usage = (message: string): HgpError => new HgpError({ code: 'usage', message });

/**
 * The error if WebAssembly, or a file of this package, could not be loaded.
 * @internal
 */
export const unavailable = (message: string, cause?: unknown): HgpError =>
  new HgpError({ code: 'wasm-unavailable', message }, cause === undefined ? undefined : { cause });

/** @internal */
export const messageOf = (error: unknown): string =>
  error instanceof Error ? error.message : String(error);

/**
 * A reply of the solver; throws the failure that it has instead.
 * @internal
 */
export function valueOf<T extends object>(reply: T | { error: string }): T {
  if ('error' in reply) throw new HgpError(JSON.parse(reply.error) as HgpFailure);
  return reply;
}
