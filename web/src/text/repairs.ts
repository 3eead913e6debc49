// Texts on the repairs made to a mesh, from the solver's notes.

import type { ModelInfo } from 'hgp';
import type { LoadSettings } from '../model/types';
import { withoutCliAdvice } from './error_messages';

const reason = /^repaired: /;
const done = /^(?:orient|split): |^\d+ triangles? left out /;

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
  const defects = notes.find((note) => reason.test(note))?.replace(reason, '') ?? '';
  const made = notes
    .filter((note) => done.test(note))
    .map((note) => note.replace(/^(?:orient|split): /, ''))
    .map((note) => (/one-sided/.test(note) ? `${note}: a texture ends at this cut` : note));
  if (!defects && made.length === 0) return undefined;
  return { defects: defects && `${withoutCliAdvice(defects)}.`, made };
}
