// What repairs did to a mesh, for a person: out of the solver's notes on it.

import type { ModelInfo } from 'hgp';
import type { LoadSettings } from '../model/types';
import { withoutCliAdvice } from './error_messages';

const reason = /^repaired: /;
const done = /^(?:orient|split): |^\d+ triangles are /;

export const isRepaired = ({ fix, hasAllRepairs }: LoadSettings): boolean =>
  hasAllRepairs === true || Object.values(fix).includes(true);

const singular: Record<string, string> = {
  edges: 'edge',
  faces: 'face',
  vertices: 'vertex',
  components: 'component',
  triangles: 'triangle',
};
/** "1 edges" → "1 edge": the solver counts, a person reads. */
const inWords = (note: string): string =>
  note
    .replace(/\b1 ((?:one-sided )?)(\w+)/g, (all, more: string, word: string) =>
      singular[word] ? `1 ${more}${singular[word]}` : all,
    )
    .replace(
      '1 triangle are copies of others: left out, with the uv of those',
      '1 triangle is a copy of another: left out, with its uv',
    ) // prettier-ignore
    .replace('1 triangle are', '1 triangle is');

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
    .map((note) => note.replace(/ \(0 edges[^)]*\)/, '').replace(/^(?:orient|split): /, ''))
    .map(inWords);
  if (!defects && made.length === 0) return undefined;
  return { defects: defects && `${withoutCliAdvice(defects)}.`, made };
}
