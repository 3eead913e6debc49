// Texts on a quad mesh and on how it differs from the displayed cells.

import type { Quads } from 'hgp';
import { count, plural } from './format';

type Counts = Pick<
  Quads,
  'quads' | 'clipped' | 'cuts' | 'replaced' | 'halvings' | 'foldedInSpace' | 'foldedQuads'
>;

/** How the number of quads compares with the one that was asked for, and why it differs. */
export function askedFor(
  { quads, halvings, clipped }: Counts,
  asked: number | undefined,
  cones: number,
): string {
  if (asked === undefined || Math.abs(quads - asked) <= 0.1 * asked) return '';
  if (halvings > 0)
    return `${count(asked)} were asked for: each cell is divided, because two cones or a handle are within two cells.`;
  if (quads > asked)
    return `${count(asked)} were asked for: that is too coarse for ${plural(cones, 'cone')}, each of which needs a grid point of its own.`;
  return clipped > 0
    ? `${count(asked)} were asked for: those that the boundary cuts are left out.`
    : `${count(asked)} were asked for; this is the nearest grid that fits.`;
}

/** What was done to make it a clean mesh. */
export function quadFaults({ clipped, cuts, replaced, foldedQuads }: Counts): string[] {
  const near = 'because a handle or two cones are close';
  return [
    clipped > 0
      ? `${plural(clipped, 'cell')} that a boundary cuts ${clipped === 1 ? 'is' : 'are'} left out.`
      : '',
    cuts > 0 ? `${plural(cuts, 'strip')} cut lengthwise, ${near}.` : '',
    replaced > 0 ? `${plural(replaced, 'edge')} replaced, ${near}.` : '',
    foldedQuads > 0 ? `${plural(foldedQuads, 'quad')} folded together at a cone with k = 1.` : '',
  ].filter((text) => text !== '');
}

export function quadsSaved(
  { quads, clipped, cuts, replaced, halvings, foldedInSpace, foldedQuads }: Counts,
  name: string,
): string {
  const parts = [`${plural(quads, 'quad')} saved as ${name}`];
  if (clipped > 0) parts.push(`without ${plural(clipped, 'cell')} that a boundary cuts`);
  if (cuts > 0)
    parts.push(`${plural(cuts, 'strip')} cut lengthwise, because a handle or two cones are close`);
  if (replaced > 0)
    parts.push(`${plural(replaced, 'edge')} replaced, because a handle or two cones are close`);
  if (foldedInSpace > 0)
    parts.push(`${count(foldedInSpace)} of them folded in space (more cells lower that)`);
  if (halvings > 0)
    parts.push(`${4 ** halvings} per cell, because a handle or two cones are within two cells`);
  if (foldedQuads > 0)
    parts.push(`${count(foldedQuads)} of them folded together at a cone with k = 1`);
  return `${parts.join(', ')}.`;
}
