// What repairs did to a mesh, for a person: out of the solver's notes on it.

import type { ModelInfo } from 'hgp';
import type { LoadSettings } from '../model/types';
import { withoutCliAdvice } from './error_messages';

const reason = /^repaired: /;
const done = /^(?:orient|split): |^\d+ triangles? left out /;

export const isRepaired = ({ fix, hasAllRepairs }: LoadSettings): boolean =>
  hasAllRepairs === true || Object.values(fix).includes(true);

export interface Repairs {
  /** What was wrong, in a sentence; empty where a person chose the repairs one by one. */
  defects: string;
  /** What was done about it. */
  made: string[];
}

/** Nothing where nothing was repaired. */
export function repairsMade({ notes }: ModelInfo, settings: LoadSettings): Repairs | undefined {
  if (!isRepaired(settings)) return undefined;
  const defects = notes.find((note) => reason.test(note))?.replace(reason, '') ?? '';
  const made = notes
    .filter((note) => done.test(note))
    .map((note) => note.replace(/^(?:orient|split): /, ''));
  if (!defects && made.length === 0) return undefined;
  return { defects: defects && `${withoutCliAdvice(defects)}.`, made };
}
