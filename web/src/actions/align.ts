// Alignment to a grid: how many cells are requested, and what happens if alignment fails.

import type { SolveOptions, UvMap } from 'hgp';
import { automaticCells, canAlign, gridOutcome } from '../model/grid';
import type { GridSettings, MapNumbers, Model, Solution } from '../model/types';
import type { App } from './app';
import type { JobCall } from './job';

const patience = 15; // seconds: after a longer first run no other density is tried automatically

/** An aligned map has its own scale: if the user chose another scale, the map is not aligned. */
const isAsked = (grid: GridSettings, q: number, scale: SolveOptions['scale'] = 'solved'): boolean =>
  grid.isOn && canAlign(q) && scale === 'solved';

/** Whether to run again: the first run found a density that works, the user set none, and runs are fast. */
const isWorthAnother = ({ isOn, cells }: GridSettings, { report }: MapNumbers): boolean =>
  isOn && cells === undefined && report.seconds < patience;

export interface Aligned {
  map: UvMap;
  /** The number requested from the solver. */
  cells?: number;
}

/** The map, aligned if requested and possible; by default as the document says. */
export async function solveAligned(
  app: App,
  { surface, solver }: Model,
  options: SolveOptions,
  call: JobCall,
  grid = app.doc.solve.grid,
): Promise<Aligned> {
  const q = options.cones?.q ?? options.q ?? 4;
  if (!isAsked(grid, q, options.scale)) return { map: await solver.parametrize(options, call) };
  const run = async (cells: number, more: SolveOptions = {}): Promise<Aligned> => {
    const asked = { ...options, ...more, grid: { cells, mode: grid.mode } };
    return { map: await solver.parametrize(asked, call), cells };
  };
  const count = options.cones?.cones.length ?? 0;
  const first = await run(grid.cells ?? automaticCells(surface, count));
  const outcome = gridOutcome({ result: first.map });
  if (!outcome || outcome.isAligned || outcome.workingCells === 0) return first;
  if (!isWorthAnother(grid, first.map)) return first;
  await first.map.dispose();
  return run(outcome.workingCells, { cones: first.map.cones });
}

/** A sentence for the status bar on how lines meet after the last run. */
export function describeLines(solution: Solution): string {
  const outcome = gridOutcome(solution);
  if (!outcome) return '';
  if (outcome.isAligned) return solution.seams.length > 0 ? ', and lines meet at every seam' : '';
  return ', but lines do not meet at every seam: the grid is too coarse for these cones';
}
