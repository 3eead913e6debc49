// Which repair a defect needs, and whether repairs can make a mesh usable.

import type { Model } from './types';

export type Repair = 'split' | 'orient' | 'degenerate';

export const repairFor: Record<string, Repair> = {
  'non-manifold-edge': 'split',
  'non-manifold-vertex': 'split',
  'inconsistent-edge': 'orient',
  'zero-area': 'degenerate',
  'repeated-vertex': 'degenerate',
  'duplicate-face': 'degenerate',
};

/** Whether repairs that have not been made yet may make the mesh usable. */
export function canRepair({ info, loaded }: Model): boolean {
  if (info.usable || loaded.hasAllRepairs) return false;
  const fatal = info.defects.filter((defect) => defect.fatal);
  return fatal.length > 0 && fatal.every(({ kind }) => repairFor[kind] !== undefined);
}
