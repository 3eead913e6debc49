// Progress as the core reports it.

import type { Progress } from './results.js';

/** Called by the core; false ends the call. */
export type ProgressCall = (
  stage: string,
  fraction: number,
  iteration: number,
  residual: number,
  round: number,
  maxRounds: number,
) => boolean;

/** The callback in the form in which the core calls it. */
export function progressCall(
  onProgress: ((progress: Progress) => unknown) | undefined,
): ProgressCall | undefined {
  return (
    onProgress &&
    ((stage, fraction, iteration, residual, round, maxRounds) =>
      onProgress({ stage, fraction, iteration, residual, round, maxRounds }) !== false)
  );
}
