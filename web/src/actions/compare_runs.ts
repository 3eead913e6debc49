// Runs beside one another, and the way back to one of them.

import type { Solution } from '../model/types';
import type { App } from './app';
import { setPrescription } from './edit_cones';
import { isLocked } from './job';

export const whyNotCompare = ({ doc }: App): string =>
  doc.runs.length > 1 ? '' : 'Run twice first, with different cones or settings.';

export function showRuns({ ui }: App): void {
  ui.dialog = 'compare';
}

/** Makes a run the current one: its cones and its settings. */
export function returnTo(
  app: App,
  { prescription, improve, frames, field, grid, features }: Solution,
): void {
  const { doc } = app;
  if (isLocked(app)) return;
  doc.solve = { ...doc.solve, improve, frames, grid };
  if (field) doc.field = field;
  if (doc.prescription !== prescription) setPrescription(app, prescription, 'choose run');
  doc.features = features; // and who chooses the cones along them
}
