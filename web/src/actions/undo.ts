// Undo and redo of changes to cones and repairs.

import type { App } from './app';
import { isLocked } from './job';
import { reloadForStep } from './load';
import { isSilent } from '../model/prescription';

async function step(app: App, forward: boolean): Promise<void> {
  const { doc } = app;
  if (doc.job?.kind === 'load' || isLocked(app)) return;
  const before = doc.history;
  const after = forward ? before.redo() : before.undo();
  if (after === before) return;
  doc.history = after;
  doc.message = undefined;
  doc.selected = -1;
  // Before the first cone was placed, a run chooses them.
  const isSet = !isSilent(after.value.prescription);
  doc.hasUserCones = isSet || (after.canUndo && doc.hasUserCones);
  const { model } = doc;
  if (!model || doc.settings === model.loaded) return;
  // A repair or a weld is undone only if reading the file again is not cancelled.
  const isDone = await reloadForStep(app, model);
  if (!isDone && doc.history === after) doc.history = before;
}

export const undo = (app: App): Promise<void> => step(app, false);
export const redo = (app: App): Promise<void> => step(app, true);
