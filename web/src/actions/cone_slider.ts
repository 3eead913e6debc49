// Automatic cones by purpose, from few cones to low distortion, in five steps. The solver's choice for each
// step is kept, so that going back to it is immediate.

import type { Cones } from 'hgp';
import type { Surface } from '../model/types';
import type { App } from './app';
import { ways } from './cone_steps';
import { isLocked } from './job';
import { chooseCones, placeCones } from './solve';

const known = new WeakMap<Surface, Map<string, Cones>>();
const keyOf = (q: number, step: number): string => `${q} ${step}`;

/** The number of cones of a step, if it is known already. */
export function knownCount({ doc }: App, step: number): number | undefined {
  const { model, prescription } = doc;
  return model && known.get(model.surface)?.get(keyOf(prescription.q, step))?.cones.length;
}

async function conesFor(app: App, step: number): Promise<Cones | undefined> {
  const surface = app.doc.usableModel?.surface;
  if (!surface) return undefined;
  const { q } = app.doc.prescription;
  const all = known.get(surface) ?? new Map<string, Cones>();
  known.set(surface, all);
  const found = all.get(keyOf(q, step));
  if (found) return found;
  const cones = await chooseCones(app, { conesFor: ways[step] });
  if (cones) all.set(keyOf(q, step), cones);
  return cones;
}

let isFollowing = false;

/** Places the cones of a step; if several are requested while cones are being chosen, the last one counts. */
export async function setConeStep(app: App, step: number): Promise<void> {
  const { doc } = app;
  if (isFollowing) return void (doc.coneStep = step);
  if (isLocked(app)) return;
  doc.coneStep = step;
  isFollowing = true;
  try {
    for (let done = -1; done !== doc.coneStep;) {
      done = doc.coneStep;
      const { surface } = doc.usableModel ?? {};
      const cones = await conesFor(app, done);
      if (!cones || doc.usableModel?.surface !== surface) return;
      if (done === doc.coneStep) placeCones(app, cones);
    }
  } finally {
    isFollowing = false;
  }
}
