// Runs side by side: which numbers, and which of them is the best of its row.

import { countRuns, followedLines } from './features';
import { isAligned } from './grid';
import type { Solution } from './types';
import { isCertified } from './verdict';

export interface CompareCell {
  text: string;
  /** Whether it is better than another one of its row, and none is better. */
  isBest: boolean;
}

export interface CompareRow {
  name: string;
  cells: CompareCell[];
}

type Run = Solution;

/** A row of numbers, of which the lowest is the best. */
interface Quantity {
  name: string;
  of: (run: Run) => number;
  text: (x: number) => string;
}

const percent = (x: number): string => `${x.toFixed(1)} %`;

/** "0.3 %"; "0.0 %" only if there is nothing. */
export const shareText = (x: number): string =>
  x > 0 && percent(x) === percent(0) ? 'under 0.1 %' : percent(x);

const quantities: Quantity[] = [
  { name: 'Cones', of: ({ prescription }) => prescription.cones.length, text: String },
  { name: 'Typical stretch', of: ({ sizes }) => 100 * (sizes.typicalStretch - 1), text: percent },
  { name: 'Size varies', of: ({ sizes }) => sizes.spread, text: (x) => `× ${x.toFixed(2)}` },
  {
    name: 'Overlaps',
    of: ({ result: { certificate } }) => certificate.overlap.share * 100,
    text: shareText,
  },
  { name: 'Seams', of: ({ chains }) => new Set(chains).size, text: String },
  { name: 'Time', of: ({ result }) => result.report.seconds, text: (x) => `${x.toFixed(2)} s` },
];

function row({ name, of, text }: Quantity, runs: readonly Run[]): CompareRow {
  const texts = runs.map((run) => text(of(run)));
  const values = runs.map(of);
  const best = texts[values.indexOf(Math.min(...values))];
  const isTelling = new Set(texts).size > 1;
  return { name, cells: texts.map((one) => ({ text: one, isBest: isTelling && one === best })) };
}

const plainRow = (name: string, texts: string[]): CompareRow => ({
  name,
  cells: texts.map((text) => ({ text, isBest: false })),
});

/** What lines follow, in a cell of the table. */
const followed = ({ features }: Run): string =>
  features ? followedLines(features, countRuns(features.rims)) : 'nothing';

export const compareRuns = (runs: readonly Run[]): CompareRow[] => [
  plainRow(
    'Verdict',
    runs.map((run) => (isCertified(run) ? 'certified' : 'not certified')),
  ),
  ...quantities.map((one) => row(one, runs)),
  plainRow(
    'Lines meet',
    runs.map((run) => (isAligned(run) ? 'at every seam' : 'not everywhere')),
  ),
  plainRow('Lines follow', runs.map(followed)),
  plainRow(
    'Less distortion',
    runs.map(({ improve }) => (improve === undefined ? 'off' : 'on')),
  ),
];
