// Cones where the pattern is much larger or smaller than elsewhere: the way out that the result offers.

import type { Cone } from '../model/prescription';
import { plural } from '../text/format';
import { largestK } from '../model/gauss_bonnet';
import type { App } from './app';
import { balanced, setPrescription } from './edit_cones';
import { isLocked } from './job';
import { run } from './solve';

/** Places cones at the extremes of the scale, balances them, and runs: one undo step. */
export async function evenOut(app: App): Promise<void> {
  const { doc } = app;
  const { current, prescription, usableModel: model } = doc;
  if (!current || !model || isLocked(app)) return;
  const { surface } = model;
  const { q, cones } = prescription;
  const { larger, smaller } = current.sizes;
  const taken = new Set(cones.map(({ vertex }) => vertex));
  const conesAt = (vertices: number[], k: number): Cone[] =>
    vertices
      .filter((v) => !taken.has(v) && k >= 1 && k <= largestK(q, surface.valence[v]))
      .map((vertex) => ({ vertex, k }));
  // A tip is shrunk by the map: a cone of positive curvature there makes it larger; and the other way round.
  const added = [...conesAt(larger.vertices, q - 1), ...conesAt(smaller.vertices, q + 1)];
  const wanted = { ...prescription, cones: [...cones, ...added] };
  if (added.length === 0) return;
  const all = await balanced(model, wanted).catch(() => wanted.cones);
  if (doc.prescription !== prescription) return; // edited in the meantime
  if (!setPrescription(app, { ...prescription, cones: all }, 'even out sizes')) return;
  const balancing = all.length - cones.length - added.length;
  const more = balancing > 0 ? `, and ${balancing} to balance them` : '';
  const text = `${plural(added.length, 'cone')} added where the pattern was largest and smallest`;
  if ((await run(app)) === 'done') doc.say(`${text}${more}. Undo removes them.`, 'good');
}
