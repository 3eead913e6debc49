// Repairs that defects ask for, one by one or all at once.

import type { Repair } from '../model/repairs';
import type { App } from './app';
import { reloadWith } from './load';
import { run } from './solve';

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
 * What the solver finds that the mesh needs, in one step of undo. More than the single repairs together: a
 * surface with one side is cut where it must be.
 */
export async function repairAll(app: App): Promise<boolean> {
  const { model } = app.doc;
  if (!model || model.loaded.hasAllRepairs) return false;
  return reloadWith(app, { ...model.loaded, fix: {}, hasAllRepairs: true }, 'repair all');
}

/** The mesh as it is in the file, which may not be one that can be solved. */
export async function leaveRepairsOut(app: App): Promise<boolean> {
  const { model } = app.doc;
  if (!model) return false;
  return reloadWith(app, { weld: model.loaded.weld, fix: {} }, 'leave repairs out');
}

/** Everything that is in the way is repaired; then Run. */
export async function repairAndRun(app: App): Promise<void> {
  const { doc } = app;
  if (doc.model && !doc.usableModel && !(await repairAll(app))) return;
  if (doc.usableModel) await run(app);
}
