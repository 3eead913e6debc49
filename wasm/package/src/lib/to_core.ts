// What is passed to the core, and taken from it, in its own form.

import { valueOf } from './error.js';
import type { ConeFile, FeatureFile, Features, SolveOptions } from './options.js';

/** Features in the session's form: a file. */
export function listFile(features: Features | FeatureFile): FeatureFile {
  if ('text' in features) {
    const { name = '', text = '' } = features as Partial<FeatureFile>;
    return { name, text };
  }
  return { name: 'features.json', text: JSON.stringify({ q: 4, features }) };
}

/** Files in the session's form: all members of each are set, q is 0 if a field has its own. */
export function filesOf(field?: ConeFile, features?: Features | FeatureFile): object {
  const { name = '', text, q = 0 } = (field ?? {}) as Partial<ConeFile>;
  return {
    ...(field && { field: { name, text, q } }),
    ...(features && { features: listFile(features) }),
  };
}

export const jsonOf = (reply: { json: string } | { error: string }): unknown =>
  JSON.parse(valueOf(reply as { json: string }).json);

/** The options as the core's table has them: 'auto' is a mode without a number of cells. */
export function forCore({ grid, ...options }: Pick<SolveOptions, 'grid'>): object {
  if (grid === undefined) return options;
  const { cells, spacing, mode = 'tile' } = grid === 'auto' ? {} : grid;
  const isAutomatic = grid === 'auto' || cells === 'auto';
  const asked = typeof cells === 'number' ? { cells } : {};
  if (isAutomatic) return { ...options, grid: { mode } };
  return {
    ...options,
    grid: { ...asked, ...(spacing === undefined ? {} : { spacing }), ...(grid.mode && { mode }) },
  };
}
