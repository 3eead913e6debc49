// The map that is wanted, as maps that follow edits know it.

import type { FeatureChoice } from './features';
import type { Prescription } from './prescription';
import type { DirectionField, Model, SolveSettings } from './types';

/** What a map depends on; values are compared by identity. */
export interface Wanted {
  readonly model: Model;
  readonly prescription: Prescription;
  readonly solve: SolveSettings;
  readonly features: FeatureChoice | undefined;
  readonly field: DirectionField | undefined;
}

export const sameWanted = (a: Wanted | undefined, b: Wanted | undefined): boolean =>
  a?.model === b?.model &&
  a?.prescription === b?.prescription &&
  a?.solve === b?.solve &&
  a?.features === b?.features &&
  a?.field === b?.field;
