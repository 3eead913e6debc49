// What happened to cones that moved to another reading of a surface.

import type { Note } from 'hgp';
import { noteForPage } from './notes';

const maxSaid = 4;

/** " 7 cones kept; the cone at vertex 3 is left out: its vertex is on the boundary now." */
export function describeTransfer(kept: number, lost: readonly Note[]): string {
  if (kept + lost.length === 0) return '';
  const cones = `${kept} ${kept === 1 ? 'cone' : 'cones'} kept`;
  if (lost.length === 0) return ` ${cones}.`;
  const more = lost.length > maxSaid ? `; and ${lost.length - maxSaid} more` : '';
  const said = lost.slice(0, maxSaid).map((note) => noteForPage(note));
  return ` ${[cones, ...said].join('; ')}${more}.`;
}
