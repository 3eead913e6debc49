// A map aligned to a grid: what is asked, what came of it, and which patterns then run on across seams.

import type { Report, Result } from 'hgp';
import type { GridSettings, Look, Pattern, Solution, Surface } from './types';

/** A grid of squares comes back to itself under half and quarter turns only. */
export const canAlign = (q: number): boolean => q === 2 || q === 4;

export const cellRange = { min: 10, max: 1_000_000 };
const cellsAcross = 14; // along the diagonal, for a picture in which single tiles are seen
const fewestCells = 800; // cones that the solver chooses keep a cell apart: fewer cells would move many
const cellsPerCone = 40; // of cones that are given: fewer fail more often, and distort more

export function automaticCells(
  { area, diagonal }: Pick<Surface, 'area' | 'diagonal'>,
  cones: number,
): number {
  const bySize = area * (cellsAcross / diagonal) ** 2;
  const cells = Math.max(bySize, fewestCells, cellsPerCone * cones);
  return Math.round(Math.min(Math.max(cells, cellRange.min), cellRange.max));
}

export const sameGrid = (a: GridSettings, b: GridSettings, q: number): boolean =>
  !canAlign(q) || (a.isOn === b.isOn && (!a.isOn || (a.cells === b.cells && a.mode === b.mode)));

type GridReport = NonNullable<Report['components'][number]['grid']>;

const gridReports = ({ report }: Pick<Result, 'report'>): GridReport[] =>
  report.components.flatMap(({ grid }) => grid ?? []);

/** The report says that a grid was reached, and the certificate that it runs on across every seam. */
export function isAligned({ result }: Pick<Solution, 'result'>): boolean {
  const { integerSeams, seamEdges } = result.certificate;
  const reports = gridReports(result);
  return (
    reports.length === result.report.components.length &&
    reports.every(({ aligned }) => aligned) &&
    integerSeams === seamEdges
  );
}

export interface GridOutcome {
  isAligned: boolean;
  /** Reached, of all components. */
  cells: number;
  cellsPerCone: number;
  /** Edge of a cell in units of the surface. */
  spacing: number;
  /** Why there is none. */
  reason: string;
  /** How many cells would work, 0 where that was not found. */
  workingCells: number;
}

/** Nothing where no grid was asked. */
export function gridOutcome({ result }: Pick<Solution, 'result'>): GridOutcome | undefined {
  const reports = gridReports(result);
  if (reports.length === 0) return undefined;
  const cells = reports.reduce((sum, one) => sum + one.cells, 0);
  const cones = Math.max(1, result.cones.cones.length);
  const failed = reports.filter(({ aligned }) => !aligned);
  const isFound = failed.every(({ workingCells }) => workingCells > 0);
  // All components have the same spacing: the one that needs most decides.
  const denser = Math.max(1, ...failed.map((one) => one.workingCells / one.cells));
  return {
    isAligned: isAligned({ result }),
    cells: Math.round(cells),
    cellsPerCone: cells / cones,
    spacing: reports[0].spacing,
    reason: failed.find(({ reason }) => reason)?.reason ?? '',
    workingCells: failed.length > 0 && isFound ? Math.ceil(cells * denser) : 0,
  };
}

/** After how many of its tiles a pattern repeats; those that are not listed have no lines. */
const periods: Partial<Record<Pattern, number>> = {
  ...{ checker: 2, brick: 2, wood: 2, hex: 2 },
  ...{ grid: 1, plaid: 1, circles: 1, image: 1 },
};

/** The order of the turns that leave a pattern as it is, where it lies on the aligned grid. */
const symmetries: Partial<Record<Pattern, number>> = {
  ...{ checker: 4, grid: 4, plaid: 4, circles: 4 },
  ...{ brick: 2, hex: 2, wood: 1, image: 1 },
};

export const areSeamsShown = ({ seams }: Look, solution: Solution): boolean =>
  seams === 'auto' ? !isAligned(solution) : seams === 'on';

/** On an aligned map tiles come in whole steps. */
export const hasSteps = (look: Look, solution: Solution | undefined): boolean =>
  solution !== undefined && look.pattern in periods && isAligned(solution);

/** Tiles of the pattern per unit of uv. */
export function tilesPerUnit(
  look: Look,
  { diagonal }: Pick<Surface, 'diagonal'>,
  solution: Pick<Solution, 'result' | 'distortion'>,
): number {
  const period = periods[look.pattern];
  if (period !== undefined && isAligned(solution)) return period * look.steps;
  const { uvArea, surfaceArea } = solution.distortion;
  return look.tiles / (Math.sqrt(uvArea / surfaceArea) * diagonal);
}

/** The same for the grid that a file gets as its material: two tiles of it are one picture. */
export const gridTilesPerUnit = (
  look: Look,
  surface: Pick<Surface, 'diagonal'>,
  solution: Pick<Solution, 'result' | 'distortion'>,
): number =>
  isAligned(solution)
    ? 2 * look.steps
    : tilesPerUnit({ ...look, pattern: 'checker' }, surface, solution);

/** Whether a pattern looks another way on the other side of a seam that turns by r of q. */
export const isTurnedBy = (pattern: Pattern, r: number, q: number): boolean =>
  (r * (symmetries[pattern] ?? q)) % q !== 0;

export interface TurnedSeams {
  /** Runs of seam edges, as they are coloured. */
  all: number;
  turned: number;
  /** Indices of the seam edges that turn the pattern. */
  edges: number[];
}

export function turnedSeams(
  pattern: Pattern,
  { seams, chains, prescription: { q } }: Pick<Solution, 'seams' | 'chains' | 'prescription'>,
): TurnedSeams {
  const turned = new Set<number>();
  const edges: number[] = [];
  seams.forEach(({ r }, i) => {
    if (!isTurnedBy(pattern, r, q)) return;
    turned.add(chains[i]);
    edges.push(i);
  });
  return { all: new Set(chains).size, turned: turned.size, edges };
}
