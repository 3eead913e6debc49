// Alignment to a grid: what is requested of the solver, and what is said about the outcome.

import type { SolveOptions, UvMap } from 'hgp';
import { canAlign, gridOutcome } from '../model/grid';
import type { GridSettings, MapNumbers, Model, Solution } from '../model/types';
import type { App } from './app';
import type { JobCall } from './job';

/** An aligned map has its own scale: if the user chose another scale, the map is not aligned. */
function gridOf(grid: GridSettings, q: number, scale: SolveOptions['scale'] = 'solved') {
  const isAsked = grid.isOn && canAlign(q) && scale === 'solved';
  return isAsked ? { grid: { cells: grid.cells ?? ('auto' as const), mode: grid.mode } } : {};
}

export interface Aligned {
  map: UvMap;
  /** The number with which the solver made it. */
  cells?: number;
}

/** The map, aligned if requested and possible; by default as the document says. */
export async function solveAligned(
  { doc }: App,
  { solver }: Pick<Model, 'solver'>,
  options: SolveOptions,
  call: JobCall,
  grid = doc.solve.grid,
): Promise<Aligned> {
  const q = options.cones?.q ?? options.q ?? 4;
  const map = await solver.parametrize({ ...options, ...gridOf(grid, q, options.scale) }, call);
  return { map, cells: cellsOf(map) };
}

/** The number of cells with which the solver made a map; undefined without a grid. */
function cellsOf({ report }: Pick<MapNumbers, 'report'>): number | undefined {
  const { grid } = report.options;
  return grid && grid.cells > 0 ? grid.cells : undefined;
}

/** A sentence for the status bar on how lines meet after the last run. */
export function describeLines(solution: Solution): string {
  const outcome = gridOutcome(solution);
  if (!outcome) return '';
  if (outcome.isAligned) return solution.seams.length > 0 ? ', and lines meet at every seam' : '';
  return ', but lines do not meet at every seam: the grid is too coarse for these cones';
}
