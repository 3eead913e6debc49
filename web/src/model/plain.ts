// The settings of a new page.

import type { GridSettings, LoadSettings, Look, Output } from './types';

/** The load settings as options of the solver. */
export const loadOptionsOf = ({ weld, fix, hasAllRepairs }: LoadSettings) =>
  hasAllRepairs ? { weld } : { weld, fix };
export const plainSettings: LoadSettings = { fix: {} };
export const plainGrid: GridSettings = { isOn: true, mode: 'tile' };
export const plainOutput: Output = {
  scale: 'solved',
  embedCones: true,
  hasGrid: false,
};
export const plainLook: Look = {
  pattern: 'checker',
  overlay: 'none',
  tiles: 24,
  steps: 1,
  seams: 'auto',
  hasWire: false,
  light: 'studio',
};
