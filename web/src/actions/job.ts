// Runs one long task at a time, with progress, cancellation and errors.

import type { Progress } from 'hgp';
import type { Job } from '../model/types';
import { ensureWorker } from '../services/solver';
import { isAbort } from '../text/error_messages';
import { stageName, wholeFraction } from '../text/stages';
import { TimeLeft } from '../text/time_left';
import { solverOf, type App } from './app';

export interface JobCall {
  signal: AbortSignal;
  onProgress(progress: Progress): void;
  /** The solver stops at its next step and is not ended. */
  keepWorker?: boolean;
}

/** How a job ended; `replaced`: another one, or another file, took its place. */
export type JobOutcome = 'done' | 'failed' | 'cancelled' | 'replaced';

export interface JobOptions {
  kind: Job['kind'];
  title: string;
  detail?: string;
  /** In seconds. */
  timeLimit?: number;
  /** Called for every failure except cancellation. */
  onFailure: (error: unknown) => void;
  onTimeout?: () => void;
}

/** Reports progress that never decreases. */
function reportProgress({ doc }: App, controller: AbortController): JobCall['onProgress'] {
  const clock = new TimeLeft();
  return ({ stage, fraction, round }) => {
    const { job } = doc;
    if (job?.controller !== controller) return;
    const isNew = !job.entered.includes(stage);
    const whole = wholeFraction(stage, fraction, job.fraction);
    const [begin, now] = [job.begin / 1000, performance.now() / 1000];
    doc.job = {
      ...job,
      stage,
      entered: isNew ? [...job.entered, stage] : job.entered,
      detail: round > 1 ? `round ${round}` : '',
      fraction: whole,
      secondsLeft: clock.update(stage, fraction, whole, begin, now),
    };
  };
}

export const stageStart = (stage: string): Progress => ({
  stage,
  fraction: 0,
  iteration: -1,
  residual: -1,
  round: 0,
  maxRounds: 0,
});

/** The reason with which cancel() aborts. */
const byUser = new DOMException('Cancelled.', 'AbortError');

const outcomeOf = ({ signal }: AbortController): JobOutcome =>
  signal.reason === byUser ? 'cancelled' : 'replaced';

const isTimeout = ({ signal }: AbortController): boolean =>
  signal.aborted && (signal.reason as Error).name === 'TimeoutError';

/** A job that another one has replaced ends silently. */
export async function runJob(
  app: App,
  { kind, title, detail = '', timeLimit, onFailure, onTimeout }: JobOptions,
  work: (call: JobCall) => Promise<void>,
): Promise<JobOutcome> {
  const { doc } = app;
  doc.job?.controller.abort();
  const controller = new AbortController();
  const isOwn = (): boolean => doc.job?.controller === controller;
  const begin = performance.now();
  doc.job = { kind, title, stage: 'read', entered: [], detail, fraction: 0, begin, controller };
  doc.message = undefined;
  const stopLate = (): void => controller.abort(new DOMException('too late', 'TimeoutError'));
  const timer = timeLimit ? setTimeout(stopLate, 1000 * timeLimit) : undefined;
  // The page is free immediately, even if the worker is still busy.
  controller.signal.addEventListener('abort', () => isOwn() && (doc.job = undefined));
  try {
    await work({ signal: controller.signal, onProgress: reportProgress(app, controller) });
    // Work may end its job itself, to say how it went.
    return controller.signal.aborted ? outcomeOf(controller) : 'done';
  } catch (error) {
    if (isTimeout(controller)) {
      onTimeout?.();
      return 'failed';
    }
    if (controller.signal.aborted) return outcomeOf(controller);
    if (!isOwn()) return 'replaced';
    if (isAbort(error)) return 'cancelled';
    onFailure(error);
    return 'failed';
  } finally {
    clearTimeout(timer);
    if (isOwn()) doc.job = undefined;
  }
}

/** Whether a job prevents editing now; if so, tells the user and offers to cancel it. */
export function isLocked(app: App): boolean {
  const { doc } = app;
  if (doc.job?.kind !== 'run') return false;
  doc.say('The cones are locked while the solver runs.', 'note', [
    { label: 'Cancel and edit', run: () => cancel(app) },
  ]);
  return true;
}

export function cancel(app: App): void {
  const { doc } = app;
  const { job } = doc;
  if (!job) return;
  job.controller.abort(byUser);
  ensureWorker(solverOf(app));
  doc.say(
    job.kind === 'load'
      ? 'Cancelled.'
      : `Cancelled while ${stageName(job.stage).toLowerCase()}. Your cones are untouched.`,
  );
}
