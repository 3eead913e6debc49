// Alignment to a grid: the request, the outcome, and the patterns that then continue across seams.

import type { Note, Report, Result } from 'hgp';
import type { GridSettings, Look, Pattern, Solution, Surface } from './types';

/** Only rotations by half and quarter turns map a grid of squares to itself. */
export const canAlign = (q: number): boolean => q === 2 || q === 4;

export const cellRange = { min: 10, max: 1_000_000 };
export const sameGrid = (a: GridSettings, b: GridSettings, q: number): boolean =>
  !canAlign(q) || (a.isOn === b.isOn && (!a.isOn || (a.cells === b.cells && a.mode === b.mode)));

type GridReport = NonNullable<Report['components'][number]['grid']>;

const gridReports = ({ report }: Pick<Result, 'report'>): GridReport[] =>
  report.components.flatMap(({ grid }) => grid ?? []);

/** The report states that alignment succeeded, and the certificate that the grid continues across every seam. */
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
  /** Cells of all components together. */
  cells: number;
  /** Infinite where there are no cones. */
  cellsPerCone: number;
  /** Edge length of a cell in units of the surface. */
  spacing: number;
  /** Why there is no aligned map. */
  reason?: Note;
  /** A number of cells that works, 0 if none was found. */
  workingCells: number;
}

/** Undefined if no grid was requested. */
export function gridOutcome({ result }: Pick<Solution, 'result'>): GridOutcome | undefined {
  const reports = gridReports(result);
  if (reports.length === 0) return undefined;
  const cells = reports.reduce((sum, one) => sum + one.cells, 0);
  const failed = reports.filter(({ aligned }) => !aligned);
  const isFound = failed.every(({ workingCells }) => workingCells > 0);
  // All components have the same spacing, so the most demanding one decides.
  const denser = Math.max(1, ...failed.map((one) => one.workingCells / one.cells));
  return {
    isAligned: isAligned({ result }),
    cells: Math.round(cells),
    cellsPerCone: cells / result.cones.cones.length,
    spacing: reports[0].spacing,
    reason: failed.find(({ reason }) => reason)?.reason ?? undefined,
    workingCells: failed.length > 0 && isFound ? Math.ceil(cells * denser) : 0,
  };
}

/** The number of tiles after which a pattern repeats; patterns that are not listed have no lines. */
const periods: Partial<Record<Pattern, number>> = {
  checker: 2,
  brick: 2,
  wood: 2,
  hex: 2,
  grid: 1,
  plaid: 1,
  circles: 1,
  image: 1,
};

/** The order of the rotations that leave a pattern unchanged on the aligned grid. */
const symmetries: Partial<Record<Pattern, number>> = {
  checker: 4,
  grid: 4,
  plaid: 4,
  circles: 4,
  brick: 2,
  hex: 2,
  wood: 1,
  image: 1,
};

export const areSeamsShown = ({ seams }: Look, solution: Solution): boolean =>
  seams === 'auto' ? !isAligned(solution) : seams === 'on';

/** On an aligned map the number of tiles per cell is an integer. */
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

/** The look with which a map that is not aligned shows tiles of the size that they had on another map. */
export function sameTiles(
  look: Look,
  surface: Pick<Surface, 'diagonal'>,
  before: Pick<Solution, 'result' | 'distortion'>,
  after: Pick<Solution, 'result' | 'distortion'>,
): Look {
  if (!isAligned(before) || isAligned(after) || !(look.pattern in periods)) return look;
  const scale = tilesPerUnit(look, surface, before) / tilesPerUnit(look, surface, after);
  return { ...look, tiles: Math.round(look.tiles * scale) };
}

/** The same for the grid written as material of a file, whose picture consists of two tiles. */
export const gridTilesPerUnit = (
  look: Look,
  surface: Pick<Surface, 'diagonal'>,
  solution: Pick<Solution, 'result' | 'distortion'>,
): number =>
  isAligned(solution)
    ? 2 * look.steps
    : tilesPerUnit({ ...look, pattern: 'checker' }, surface, solution);

/** Whether a pattern looks different on the two sides of a seam with rotation r. */
export const isTurnedBy = (pattern: Pattern, r: number, q: number): boolean =>
  (r * (symmetries[pattern] ?? q)) % q !== 0;

export interface TurnedSeams {
  /** Number of chains of seam edges, each of which has one colour. */
  all: number;
  turned: number;
  /** Indices of the seam edges across which the pattern is rotated. */
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
