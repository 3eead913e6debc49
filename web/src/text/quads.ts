// Texts on a quad mesh and on how it differs from the displayed cells.

import type { Quads } from 'hgp';
import { count, plural } from './format';

type Counts = Pick<Quads, 'quads' | 'clipped' | 'halvings' | 'foldedQuads'>;

export function quadsSaved(
  { quads, clipped, halvings, foldedQuads }: Counts,
  name: string,
): string {
  const parts = [`${plural(quads, 'quad')} saved as ${name}`];
  if (clipped > 0) parts.push(`without ${plural(clipped, 'cell')} that a boundary cuts`);
  if (halvings > 0)
    parts.push(`${4 ** halvings} per cell, because a handle or two cones are within two cells`);
  if (foldedQuads > 0) parts.push(`${count(foldedQuads)} of them folded at a cone of k = 1`);
  return `${parts.join(', ')}.`;
}
