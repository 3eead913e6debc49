// Texts on the repairs made to a mesh, from the solver's notes.

import type { ModelInfo } from 'hgp';
import type { LoadSettings } from '../model/types';
import { noteForPage } from './notes';

/** Notes on what was done, as the page says it. */
const done: Readonly<Record<string, string>> = {
  'repair-turned': '{faces|face} turned over',
  'repair-one-sided-left': '{components|one-sided component} cannot be oriented without a cut',
  'repair-one-sided-cut':
    '{components|one-sided component} cut along {edges|edge}: a texture ends at this cut',
  'repair-split':
    '{vertices|vertex|vertices} duplicated[edges: ({edges|edge} had more than two faces)]',
};
const leftOut = new Set(['repair-no-surface', 'repair-copies']);

export const isRepaired = ({ fix, hasAllRepairs }: LoadSettings): boolean =>
  hasAllRepairs === true || Object.values(fix).includes(true);

export interface Repairs {
  /** The defects, in a sentence; empty if the user chose the repairs one by one. */
  defects: string;
  /** The repairs that were made. */
  made: string[];
}

/** Undefined if nothing was repaired. */
export function repairsMade({ notes }: ModelInfo, settings: LoadSettings): Repairs | undefined {
  if (!isRepaired(settings)) return undefined;
  const defects = notes
    .filter(({ code }) => code.startsWith('defect-'))
    .map((note) => noteForPage({ ...note, numbers: { ...note.numbers, repaired: 0 } }));
  const made = notes
    .filter(({ code }) => code in done || leftOut.has(code))
    .map((note) => noteForPage(note, done));
  if (defects.length === 0 && made.length === 0) return undefined;
  return { defects: defects.length > 0 ? `${defects.join('; ')}.` : '', made };
}
