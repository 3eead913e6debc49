// Suggest and Run: the two calls that take time. Cancel ends the worker at once.

import {
  HgpError,
  type Progress as Report,
  type Result,
  type WriteOptions,
  type Written,
} from 'hgp';
import type { App } from './app';
import { isLocked, replaceAsked } from './edit';
import { copyCommand } from './estimate';
import { explain } from './explain';
import { withGrid } from './grid';
import { tilesPerUnit } from './measure';
import { fromCones, toCones } from './prescription';
import { wake } from './solver';
import { finish, type Output, plainOutput, type Solved } from './solved';

// Where each stage begins and ends within the whole.
const spans: Record<string, [number, number]> = {
  read: [0, 0.02],
  weld: [0.02, 0.04],
  topology: [0.04, 0.06],
  cones: [0.06, 0.14],
  field: [0.06, 0.22],
  cut: [0.22, 0.26],
  assemble: [0.26, 0.3],
  solve: [0.3, 0.9],
  verify: [0.9, 0.95],
  write: [0.95, 1],
};

const stageNames: Record<string, string> = {
  read: 'Reading',
  cones: 'Choosing cones',
  field: 'Smooth field',
  cut: 'Cutting',
  assemble: 'Assembling',
  solve: 'Solving',
  verify: 'Checking',
  write: 'Writing',
};

export const stageName = (stage: string): string => stageNames[stage] ?? stage;

export const isAbort = (error: unknown): boolean => (error as Error).name === 'AbortError';

const beginning = (stage: string): Report => ({
  stage,
  fraction: 0,
  iteration: -1,
  residual: -1,
  round: 0,
  maxRounds: 0,
});

/** Progress that only goes forward. */
export function follow(app: App, own: AbortController): (report: Report) => void {
  return ({ stage, fraction, iteration, residual, round, maxRounds }) => {
    if (own !== app.running || !app.progress) return;
    const [from, to] = spans[stage] ?? [app.progress.fraction, app.progress.fraction];
    const whole = from + (to - from) * Math.min(Math.max(fraction, 0), 1);
    const detail = [
      round > 0 ? `round ${round} of ${maxRounds}` : '',
      iteration > 0 ? `step ${iteration}` : '',
      residual > 0 ? `gap ${residual.toPrecision(1)}` : '',
    ];
    app.progress = {
      ...app.progress,
      stage,
      detail: detail.filter(Boolean).join(' · '),
      fraction: Math.max(app.progress.fraction, whole),
    };
    app.changed();
  };
}

/** Does one long thing with progress, Cancel and every way it can end. */
async function busy(
  app: App,
  title: string,
  work: (call: { signal: AbortSignal; onProgress(p: Report): void }) => Promise<void>,
): Promise<void> {
  app.running?.abort();
  const own = (app.running = new AbortController());
  app.phase = 'running';
  app.message = undefined;
  app.progress = { title, stage: 'field', detail: '', fraction: 0, begin: performance.now() };
  app.changed();
  const { timeLimit } = app.solve;
  const timer = timeLimit && setTimeout(() => stopLate(app, own, timeLimit), 1000 * timeLimit);
  // Free at once, whatever the worker still does.
  own.signal.addEventListener('abort', () => {
    if (own !== app.running) return;
    app.phase = 'editing';
    app.progress = undefined;
    app.changed();
  });
  try {
    await work({ signal: own.signal, onProgress: follow(app, own) });
  } catch (error) {
    if (own.signal.aborted || isLost(error)) app.inWorker = undefined; // gone with its worker
    if (own !== app.running || isLate(own)) return;
    if (isAbort(error)) app.say('Cancelled. Your cones are untouched.');
    else sayFailure(app, error);
  } finally {
    clearTimeout(timer || undefined);
    if (own === app.running) {
      app.running = undefined;
      app.progress = undefined;
      app.phase = app.info ? 'editing' : 'empty';
      app.changed();
    }
  }
}

const isLate = ({ signal }: AbortController): boolean =>
  signal.aborted && (signal.reason as Error).name === 'TimeoutError';

function stopLate(app: App, own: AbortController, seconds: number): void {
  if (own !== app.running) return;
  own.abort(new DOMException('too late', 'TimeoutError'));
  wake(app);
  app.say(
    `No certified map within ${seconds} s, the limit you set. Your cones are untouched. ` +
      'Try: more time in the Solve panel, fewer triangles, or the command line.',
    'error',
  );
}

const isLost = (error: unknown): boolean =>
  error instanceof HgpError && error.code === 'worker-lost';

function sayFailure(app: App, error: unknown): void {
  const text = explain(error, app.main);
  if (isLost(error)) {
    wake(app);
    app.say(`${text} Your cones and history are intact.`, 'error', [
      { label: 'Run again', do: () => void run(app) },
    ]);
    return;
  }
  if (error instanceof HgpError && error.code === 'limit') {
    app.say(text, 'error', [{ label: 'Copy the command', do: () => void copyCommand(app) }]);
    return;
  }
  const advice = 'Try: move a cone to a vertex with more triangles, or another q.';
  const isNoMap = error instanceof HgpError && error.code === 'no-map';
  const where = error instanceof HgpError ? (error.details.where ?? []) : [];
  const show = where.length > 0 ? [{ label: 'Show', do: () => app.showPlaces?.(where) }] : [];
  const auto = (): void => {
    app.solve = { ...app.solve, frames: 'auto' };
    void run(app);
  };
  const other = usesField(app) ? [{ label: 'Run with automatic frames', do: auto }] : [];
  app.say(isNoMap ? `${text} ${advice}` : text, 'error', [
    ...show,
    ...other,
    { label: 'Suggest cones', do: () => void suggest(app) },
  ]);
}

/** Puts suggested cones in place; an edit like any other. */
export async function suggest(app: App, count?: number): Promise<void> {
  if (isLocked(app)) return;
  const { q, turnings, handles } = app.asked;
  await busy(app, 'Suggesting cones', async (call) => {
    const cones = await app.client!.suggestCones({ q, count }, call);
    app.phase = 'editing';
    const asked = fromCones(cones, turnings.length, handles.length);
    if (count === undefined) app.natural.set(q, asked);
    replaceAsked(app, asked, 'suggest cones');
    app.say(`${cones.cones.length} cones suggested for q = ${q}.`, 'good');
  });
}

const usesField = (app: App): boolean => app.solve.frames === 'file' && app.field !== undefined;

export function canRun(app: App): boolean {
  if (app.phase !== 'editing' || !app.info?.usable || !app.client) return false;
  return app.needsCones || Boolean(app.budget?.isReady);
}

type Call = Parameters<Parameters<typeof busy>[2]>[0];

/**
 * Solves what is asked and writes the file; what is shown is read back from that file. The surface's
 * own cones are chosen by the solver, as on the command line: it has a shorter road to them.
 */
async function solve(app: App, output: Output, call: Call): Promise<Solved> {
  const { rounds, quality, frames } = app.solve;
  const { turnings, handles, q } = app.asked;
  const isNatural = !usesField(app) && (app.needsCones || app.isNatural);
  const options = { maxRounds: rounds, quality, scale: output.scale };
  const framed = usesField(app) ? { frames, field: app.field } : {};
  const what = isNatural ? { q } : { cones: toCones(app.asked), ...framed };
  const result = await app.client!.parametrize({ ...what, ...options }, call);
  const asked = isNatural ? fromCones(result.cones, turnings.length, handles.length) : app.asked;
  if (isNatural) app.natural.set(q, asked);
  call.onProgress(beginning('write'));
  const written = await write(app, result, output, call);
  app.inWorker = result;
  const order = { asked, settings: app.loaded, quality, frames, output };
  return finish(app, order, result, written);
}

async function write(app: App, result: Result, output: Output, call: Call): Promise<Written> {
  const written = await app.client!.write(writeOptions(output), call);
  if (!output.hasGrid) return written;
  const asked = { mesh: app.info!.surface, uvSet: output.uvSet, tiles: tilesPerUnit(app, result) };
  const files = withGrid(written.files, asked);
  return { ...written, ...files[0], files };
}

const writeOptions = ({ uvSet, embedCones }: Output): WriteOptions => ({
  ...{ allowUncertified: true, embedCones },
  ...(uvSet === undefined ? {} : { uvSet }),
});

/** The same map in another place or size of the file: solved again only where it must be. */
async function writeAs(app: App, old: Solved, output: Output): Promise<void> {
  await busy(app, 'Writing', async (call) => {
    const isThere = app.inWorker === old.result && old.output.scale === output.scale;
    const solved = isThere
      ? await finish(
          app,
          { ...old, output },
          old.result,
          await write(app, old.result, output, call),
        )
      : await solve(app, output, call);
    app.results = app.results.map((one) => (one === old ? solved : one));
    app.isUnsaved = true;
  });
}

/** What is chosen while the file is written is taken up afterwards. */
export async function rewrite(app: App, part: Partial<Output>): Promise<void> {
  if (!app.current) return;
  app.wanted = { ...(app.wanted ?? app.current.output), ...part };
  if (app.phase === 'running') return;
  for (let old: Solved | undefined = app.current; old && app.wanted; old = app.current) {
    const output: Output = app.wanted;
    await writeAs(app, old, output);
    // Done, or cancelled, or failed; unless something else was chosen meanwhile.
    if (app.wanted === output || app.current === old) app.wanted = undefined;
  }
  app.wanted = undefined;
  app.changed();
}

export async function run(app: App): Promise<void> {
  if (!canRun(app)) return;
  const isOpen = app.needsCones && !usesField(app);
  await busy(app, isOpen ? 'Choosing cones and running' : 'Running', async (call) => {
    const solved = await solve(app, app.shown?.output ?? plainOutput, call);
    call.signal.throwIfAborted();
    app.phase = 'editing';
    if (isOpen) replaceAsked(app, solved.asked, 'suggest cones');
    app.results = [...app.results.slice(-2), solved];
    app.isUnsaved = true;
    const count = solved.asked.cones.length;
    const chosen = isOpen && count > 0 ? ` ${count} cones were suggested for you.` : '';
    if (solved.isCertified) app.say(`Certified: no triangle is folded.${chosen}`, 'good');
    else {
      const other = solved.frames === 'file' ? ' Automatic frames may do better.' : '';
      const see = 'The map can be viewed; see the certificate.';
      app.say(`Not certified. ${see}${other}${chosen}`, 'error');
    }
  });
}

export function cancel(app: App): void {
  app.running?.abort();
  wake(app);
  app.say('Cancelled. Your cones are untouched.');
}
