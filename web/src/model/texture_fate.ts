// What became of the textures that a glTF had, by the notes of the writer.

import type { Output, Solution } from './types';

/** `kept`: on the old coordinates; `moved`: to the new ones; `unseen`: likewise, since they could not be seen before. */
export type TextureFate = 'kept' | 'moved' | 'unseen';

type Told = Pick<Solution, 'notes' | 'preserved'>;

/** Undefined if the file has no textures. */
export function textureFate({ notes, preserved }: Told): TextureFate | undefined {
  if (!/\btextures?\b/.test(preserved)) return undefined;
  const has = (code: string): boolean => notes.some((note) => note.code === code);
  if (has('write-set-used') || has('write-set-replaced')) return 'moved';
  return has('write-set-unseen') ? 'unseen' : 'kept';
}

/** The choice of the uv set: `keep`, `use`, or the number of the set that is replaced. */
export function chosenSet({ uvSet, usesNewSet }: Output, solution: Told): string {
  if (uvSet !== undefined) return String(uvSet);
  const isMoved = usesNewSet ?? textureFate(solution) === 'unseen';
  return isMoved ? 'use' : 'keep';
}
