// Alignment to a grid: how many cells are requested, and what happens where alignment fails.

import type { Result, SolveOptions } from 'hgp';
import { automaticCells, canAlign, gridOutcome } from '../model/grid';
import type { GridSettings, Model, Solution } from '../model/types';
import { solverOf, type App } from './app';
import type { JobCall } from './job';

const patience = 15; // seconds of a first run, up to which another density is tried unasked

/** An aligned map has a scale of its own: another one that is asked for wins. */
const isAsked = ({ doc }: App, q: number, scale: SolveOptions['scale']): boolean =>
  doc.solve.grid.isOn && canAlign(q) && scale === 'solved';

/** One more run where the first has found a density that works, nobody has set one, and it is quick. */
const isWorthAnother = ({ isOn, cells }: GridSettings, { report }: Result): boolean =>
  isOn && cells === undefined && report.seconds < patience;

export interface Aligned {
  result: Result;
  /** That were asked of the solver. */
  cells?: number;
}

/** The map, aligned where that is wanted and possible. */
export async function solveAligned(
  app: App,
  { surface }: Model,
  options: SolveOptions,
  call: JobCall,
): Promise<Aligned> {
  const client = solverOf(app);
  const { grid } = app.doc.solve;
  const q = options.cones?.q ?? options.q ?? 4;
  if (!isAsked(app, q, options.scale)) return { result: await client.parametrize(options, call) };
  const run = async (cells: number, more: SolveOptions = {}): Promise<Aligned> => {
    const asked = { ...options, ...more, grid: { cells, mode: grid.mode } };
    return { result: await client.parametrize(asked, call), cells };
  };
  const count = options.cones?.cones.length ?? 0;
  const first = await run(grid.cells ?? automaticCells(surface, count));
  const outcome = gridOutcome(first);
  if (!outcome || outcome.isAligned || outcome.workingCells === 0) return first;
  if (!isWorthAnother(grid, first.result)) return first;
  return run(outcome.workingCells, { cones: first.result.cones });
}

/** Of the last run, for the status bar. */
export function describeLines(solution: Solution): string {
  const outcome = gridOutcome(solution);
  if (!outcome) return '';
  if (outcome.isAligned) return solution.seams.length > 0 ? ', and lines meet at every seam' : '';
  return ', but lines do not meet at every seam: the grid is too coarse for these cones';
}
