// Requests cones and maps from the solver and stores its results.

import { HgpError, type Cones, type SuggestOptions, type UvMap } from 'hgp';
import { describeFollowed } from '../model/features';
import { gridOutcome, sameTiles } from '../model/grid';
import { plainOutput } from '../model/plain';
import { alongFeatures, fromCones } from '../model/prescription';
import { requestOf, runOptions } from '../model/request';
import type {
  GridSettings,
  MessageAction,
  Model,
  Output,
  Solution,
  SolveSettings,
} from '../model/types';
import { componentsOf, isCertified } from '../model/verdict';
import { ensureWorker } from '../services/solver';
import { describeError } from '../text/error_messages';
import { count, plural } from '../text/format';
import { repairsMade } from '../text/repairs';
import { describeLines, solveAligned } from './align';
import { solveAutomatic } from './automatic';
import { solverOf, type App } from './app';
import { balancedStep } from './cone_steps';
import { copyCommand } from './copy_command';
import { keepCones, setPrescription, takeCones } from './edit_cones';
import { isLocked, runJob, type JobCall, type JobOutcome } from './job';
import { showPlaces } from './view';
import { numbersOf, writeSolution } from './write_solution';

const isLost = (error: unknown): boolean =>
  error instanceof HgpError && error.code === 'worker-lost';

export function sayRunFailure(app: App, error: unknown): void {
  const { doc } = app;
  const text = describeError(error, doc.model?.main ?? '');
  if (isLost(error)) {
    ensureWorker(solverOf(app));
    const again = { label: 'Run again', run: () => run(app) };
    return doc.say(`${text} Your cones and history are intact.`, 'error', [again]);
  }
  if (error instanceof HgpError && error.code === 'limit') {
    const copy = { label: 'Copy the command', run: () => copyCommand(app) };
    return doc.say(text, 'error', [copy]);
  }
  const { askedFeatures: features } = doc;
  const advice = features
    ? 'Try: without some of the edges that lines follow.'
    : 'Try: move a cone to a vertex with more triangles, or another q.';
  const isNoMap = error instanceof HgpError && error.code === 'no-map';
  const where = error instanceof HgpError ? (error.details.where ?? []) : [];
  const runAutomatic = (): unknown => {
    doc.solve = { ...doc.solve, frames: 'auto' };
    return run(app);
  };
  const suggest = { label: 'Suggest cones', run: () => suggestCones(app) };
  doc.say(isNoMap ? `${text} ${advice}` : text, 'error', [
    ...(where.length > 0 ? [{ label: 'Show', run: () => showPlaces(app, where) }] : []),
    ...(doc.askedField ? [{ label: 'Run with automatic frames', run: runAutomatic }] : []),
    ...(features ? chooseAlong(app) : [suggest]),
  ]);
}

/** Where cones of the user have no map along features: a button that runs with those that fit. */
export function chooseAlong(app: App): MessageAction[] {
  const { doc } = app;
  if (!doc.askedFeatures || doc.choosesCones) return [];
  const choose = (): unknown => {
    keepCones(app, false);
    return run(app);
  };
  return [{ label: 'Let Run choose the cones', run: choose }];
}

function sayTimeout({ doc, client }: App): void {
  if (client) ensureWorker(client);
  doc.say(
    `No certified map within ${doc.solve.timeLimit} s, the limit you set. Your cones are untouched. ` +
      'Try: more time in the Solve panel, fewer triangles, or the command line.',
    'error',
  );
}

function running(app: App, title: string, work: (call: JobCall) => Promise<void>) {
  const { timeLimit } = app.doc.solve;
  const onFailure = (error: unknown): void => sayRunFailure(app, error);
  const onTimeout = (): void => sayTimeout(app);
  return runJob(app, { kind: 'run', title, timeLimit, onFailure, onTimeout }, work);
}

/** Asks the solver for cones; undefined if that was cancelled or failed. */
export async function chooseCones(
  app: App,
  options: Omit<SuggestOptions, 'q'> = {},
): Promise<Cones | undefined> {
  const { model, prescription } = app.doc;
  const { q } = prescription;
  if (!model) return undefined;
  let cones: Cones | undefined;
  await running(app, 'Suggesting cones', async (call) => {
    cones = await model.solver.suggestCones({ q, ...options }, call);
  });
  return cones;
}

/** Replaces the cones, as an ordinary edit. */
export function placeCones(app: App, cones: Cones): void {
  const { doc } = app;
  const { q, turnings, handles } = doc.prescription;
  setPrescription(app, fromCones(cones, turnings.length, handles.length), 'suggest cones');
  doc.say(`${plural(cones.cones.length, 'cone')} suggested for q = ${q}.`, 'good');
}

export async function suggestCones(app: App): Promise<void> {
  if (isLocked(app)) return;
  const cones = await chooseCones(app);
  if (!cones) return;
  placeCones(app, cones);
  app.doc.coneStep = balancedStep;
}

/** Why Run is not possible; empty if it is. */
export function whyNotRun({ doc, client }: App): string {
  if (!client || !doc.model) return 'Open a model first.';
  if (doc.isBusy) return 'Something is running already.';
  if (!doc.usableModel) return 'This mesh cannot be parametrized as it is.';
  if (doc.needsCones || doc.choosesCones || doc.budget?.isReady) return '';
  return doc.budget?.text ?? 'The cones are not balanced.';
}

/**
 * Solves the prescription and writes the file; the map that is shown is read back from this file. Prescribed and
 * automatic cones are treated in the same way.
 */
export async function solve(
  app: App,
  model: Model,
  output: Output,
  call: JobCall,
): Promise<Solution> {
  const { doc } = app;
  const { rounds, improve, frames, grid } = doc.solve;
  const { turnings, handles } = doc.prescription;
  // A component without a map is cut to a disk and fails its checks; this does not affect the others.
  const keepGoing = (model.info.components?.length ?? 1) > 1;
  const { askedFeatures, askedField: field, coneStep, choosesCones } = doc;
  const features = askedFeatures && { ...askedFeatures, keepsCones: !choosesCones };
  const isAutomatic = choosesCones && !features;
  const prescribed = { prescription: doc.prescription, isAutomatic, features, field };
  const options = runOptions({ ...prescribed, rounds, improve, scale: output.scale, keepGoing });
  const { map, cells, step } = isAutomatic
    ? await solveAutomatic(app, model, options, call)
    : { ...(await solveAligned(app, model, options, call)), step: coneStep };
  doc.coneStep = step;
  const chosen = features ? alongFeatures(map.cones) : map.cones;
  const prescription = choosesCones
    ? fromCones(chosen, turnings.length, handles.length)
    : doc.prescription;
  const asked = { prescription, settings: model.loaded, improve, frames, field, features };
  const request = { ...asked, grid, cells, output };
  try {
    return await writeSolution(app, model, request, { map, result: numbersOf(map) }, call);
  } catch (error) {
    if (call.keepWorker) void map.dispose();
    throw error;
  }
}

/** Makes a solution the newest. @param before  what was shown before */
export function keepSolution({ doc }: App, solution: Solution, before?: Solution): void {
  const surface = doc.model?.surface;
  if (before && surface) doc.look = sameTiles(doc.look, surface, before, solution);
  doc.solutions = [...doc.solutions.slice(-2), solution];
  doc.isUnsaved = true;
}

/** An edit that was undone leaves open who chose the cones along features: as they were chosen, they are chosen again. */
function solveAgain(
  app: App,
  model: Model,
  old: Solution,
  output: Output,
  call: JobCall,
): Promise<Solution> {
  app.doc.features = old.features ?? app.doc.features;
  return solve(app, model, output, call);
}

/** Writes the current map with other output settings; solves again, as it was solved, only if necessary. */
async function writeAs(app: App, old: Solution, output: Output): Promise<void> {
  const { doc } = app;
  const { model } = doc;
  if (!model) return;
  await running(app, 'Writing', async (call) => {
    const isThere = old.output.scale === output.scale && !old.map.isDisposed;
    const solution = isThere
      ? await writeSolution(app, model, { ...requestOf(old), output }, old, call)
      : await solveAgain(app, model, old, output, call);
    doc.solutions = doc.solutions.map((one) => (one === old ? solution : one));
    doc.isUnsaved = true;
  });
}

/** The map that is shown, in the solver; computed again if necessary, undefined if that fails. */
export async function mapInSolver(app: App): Promise<UvMap | undefined> {
  const { doc } = app;
  const { current } = doc;
  if (current?.map.isDisposed) await writeAs(app, current, current.output);
  const { map } = doc.current ?? {};
  return map?.isDisposed ? undefined : map;
}

/** Changes output settings; changes made while the file is being written take effect afterwards. */
export async function rewrite(app: App, part: Partial<Output>): Promise<void> {
  const { doc } = app;
  if (!doc.current) return;
  doc.pendingOutput = { ...(doc.pendingOutput ?? doc.current.output), ...part };
  if (doc.isBusy) return;
  for (let old: Solution | undefined = doc.current; old && doc.pendingOutput; old = doc.current) {
    const output: Output = doc.pendingOutput;
    await writeAs(app, old, output);
    // Finished, cancelled or failed, unless other settings were chosen in the meantime.
    if (doc.pendingOutput === output || doc.current === old) doc.pendingOutput = undefined;
  }
  doc.pendingOutput = undefined;
}

/** If the grid was too coarse: a button that runs with a density that works. */
export function denserButton(app: App, solution: Solution): MessageAction[] {
  const cells = gridOutcome(solution)?.workingCells ?? 0;
  if (cells === 0) return [];
  return [{ label: `Align with ${count(cells)} cells`, run: () => realign(app, { cells }) }];
}

export function sayVerdict(app: App, solution: Solution, isOpen: boolean): void {
  const { doc } = app;
  const cones = solution.prescription.cones.length;
  const chosen = isOpen && cones > 0 ? ` (${plural(cones, 'cone')} suggested)` : '';
  if (isCertified(solution)) {
    const isRepaired = doc.model && repairsMade(doc.model.info, doc.model.loaded) !== undefined;
    const repaired = isRepaired ? ' It was repaired first: what was done is under Result.' : '';
    const followed = describeFollowed(solution.features, doc.model?.info.boundaryLoops);
    const text = `Certified: no triangle is folded${followed}${describeLines(solution)}${chosen}.${repaired}`;
    return doc.say(text, 'good', denserButton(app, solution));
  }
  const other = solution.frames === 'file' ? ' Automatic frames may do better.' : '';
  const parts = componentsOf(solution.result.certificate);
  const good = parts.filter(({ reasons }) => !reasons?.length).length;
  const passing = good > 0 ? ` ${good} of ${parts.length} components pass.` : '';
  const see = 'The map can be viewed; see the certificate.';
  doc.say(`Not certified${chosen}.${passing} ${see}${other}`, 'error', chooseAlong(app));
}

/** How a run ended; `refused`: it did not begin, and the user was told why. */
export type RunOutcome = JobOutcome | 'refused';

export async function run(app: App): Promise<RunOutcome> {
  const { doc } = app;
  const reason = whyNotRun(app);
  if (reason) {
    doc.say(reason, 'error');
    return 'refused';
  }
  const model = doc.usableModel!;
  doc.notAgain = doc.wanted;
  const isOpen = doc.choosesCones;
  const begin = performance.now();
  return running(app, 'Running', async (call) => {
    const solution = await solve(app, model, doc.displayed?.output ?? plainOutput, call);
    doc.job = undefined;
    takeCones(app, solution.prescription);
    doc.firstRun ??= performance.now() - begin;
    doc.notAgain = undefined;
    keepSolution(app, solution);
    sayVerdict(app, solution, isOpen);
  });
}

/** Changes settings that apply to the next Run. */
export function setSolve({ doc }: App, part: Partial<SolveSettings>): void {
  doc.solve = { ...doc.solve, ...part };
}

/** Changes the grid settings. An existing map is computed again; otherwise they apply to the next Run. */
export async function realign(app: App, part: Partial<GridSettings>): Promise<void> {
  const { doc } = app;
  const hadMap = doc.current !== undefined;
  if (isLocked(app)) return;
  doc.solve = { ...doc.solve, grid: { ...doc.solve.grid, ...part } };
  if (hadMap && !doc.current) await run(app);
}
