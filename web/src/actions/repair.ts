// Repairs that defects ask for, one by one or all at once.

import type { Model } from '../model/types';
import type { App } from './app';
import { reloadWith } from './load';
import { run } from './solve';

export type Repair = 'split' | 'orient' | 'degenerate';

export const repairFor: Record<string, Repair> = {
  'non-manifold-edge': 'split',
  'non-manifold-vertex': 'split',
  'inconsistent-edge': 'orient',
  'zero-area': 'degenerate',
  'repeated-vertex': 'degenerate',
  'duplicate-face': 'degenerate',
};

export const repairNames: Record<Repair, string> = {
  split: 'split non-manifold places',
  orient: 'turn triangles round',
  degenerate: 'remove degenerate triangles',
};

/** What would settle the defects that stand in the way; nothing where no repair settles one of them. */
export function repairsFor({ info, loaded }: Model): Repair[] {
  if (info.usable) return [];
  const fatal = info.defects.filter((defect) => defect.fatal);
  const repairs = fatal.map(({ kind }) => repairFor[kind]);
  if (fatal.length === 0 || repairs.some((one) => !one || loaded.fix[one])) return [];
  return [...new Set(repairs)];
}

export async function repair(app: App, repairs: Repair[]): Promise<boolean> {
  const { model } = app.doc;
  if (!model || repairs.length === 0) return false;
  const more = Object.fromEntries(repairs.map((one) => [one, true]));
  const settings = { ...model.loaded, fix: { ...model.loaded.fix, ...more } };
  return reloadWith(app, settings, repairs.map((one) => repairNames[one]).join(', '));
}

/** What no single repair settles, such as a surface with one side: it is cut where it must be. */
async function repairAll(app: App): Promise<boolean> {
  const { loaded } = app.doc.model!;
  if (loaded.hasAllRepairs) return false;
  return reloadWith(app, { ...loaded, hasAllRepairs: true }, 'repair all');
}

const mostPasses = 4; // a repair may bring another kind of defect to light

/** Everything that is in the way is repaired; then Run. */
export async function repairAndRun(app: App): Promise<void> {
  const { doc } = app;
  for (let pass = 0; pass < mostPasses && doc.model && !doc.usableModel; pass++) {
    const repairs = repairsFor(doc.model);
    const isDone = repairs.length > 0 ? await repair(app, repairs) : await repairAll(app);
    if (!isDone) return;
  }
  if (doc.usableModel) await run(app);
}
