// Texts on a quad mesh and on how it differs from the displayed cells.

import type { Quads } from 'hgp';
import { count, plural } from './format';

type Counts = Pick<
  Quads,
  'quads' | 'clipped' | 'cuts' | 'replaced' | 'halvings' | 'foldedInSpace' | 'foldedQuads'
>;

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
  if (foldedQuads > 0) parts.push(`${count(foldedQuads)} of them folded at a cone of k = 1`);
  return `${parts.join(', ')}.`;
}
