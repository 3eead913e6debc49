// Repairs for the defects of a mesh, one by one or all at once.

import { canRepair, type Repair } from '../model/repairs';
import { whyUnusable } from '../text/error_messages';
import type { App } from './app';
import { placeOrSelect } from './edit_cones';
import { reloadWith } from './load';
import { run, type RunOutcome } from './solve';

const repairNames: Record<Repair, string> = {
  split: 'split non-manifold places',
  orient: 'turn triangles round',
  degenerate: 'remove degenerate triangles',
};

export async function repair(app: App, repairs: Repair[]): Promise<boolean> {
  const { model } = app.doc;
  if (!model || repairs.length === 0) return false;
  const more = Object.fromEntries(repairs.map((one) => [one, true]));
  const settings = { ...model.loaded, fix: { ...model.loaded.fix, ...more } };
  return reloadWith(app, settings, repairs.map((one) => repairNames[one]).join(', '));
}

/**
 * Makes all repairs that the solver considers necessary, as one undo step. This is more than the single repairs
 * together: a one-sided surface is also cut.
 */
export async function repairAll(app: App): Promise<boolean> {
  const { model } = app.doc;
  if (!model || model.loaded.hasAllRepairs) return false;
  return reloadWith(app, { ...model.loaded, fix: {}, hasAllRepairs: true }, 'repair all');
}

/** Uses the mesh as it is in the file, even if it cannot be solved. */
export async function leaveRepairsOut(app: App): Promise<boolean> {
  const { model } = app.doc;
  if (!model) return false;
  return reloadWith(app, { weld: model.loaded.weld, fix: {} }, 'leave repairs out');
}

/** Places a cone, or selects the one there, after the repairs without which there can be none. */
export async function placeOnAny(app: App, vertex: number): Promise<void> {
  const { doc } = app;
  const { model } = doc;
  if (!model || doc.usableModel) return placeOrSelect(app, vertex);
  if (!canRepair(model)) {
    return doc.say(`${whyUnusable(model.info)} No cone can be placed on it.`, 'error');
  }
  if (!(await repairAll(app)) || !doc.usableModel) return;
  placeOrSelect(app, vertex);
  doc.say('Repaired first, so that cones can be placed. Undo reverts it.');
}

/** Makes all necessary repairs, then runs. */
export async function repairAndRun(app: App): Promise<RunOutcome> {
  const { doc } = app;
  if (doc.model && !doc.usableModel && !(await repairAll(app))) return 'refused';
  return doc.usableModel ? run(app) : 'refused';
}
