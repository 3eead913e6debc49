// Cones where the pattern is much larger or smaller than elsewhere: the way out that the result offers.

import type { Cone } from '../model/prescription';
import { plural } from '../text/format';
import { largestK } from '../model/gauss_bonnet';
import type { App } from './app';
import { setPrescription } from './edit_cones';
import { isLocked } from './job';
import { run } from './solve';

/** Places cones at the extremes of the scale, balances them, and runs: one undo step. */
export async function evenOut(app: App): Promise<void> {
  const { doc, geometry } = app;
  const { current, prescription } = doc;
  const surface = doc.usableModel?.surface;
  if (!current || !surface || isLocked(app)) return;
  const { q, cones } = prescription;
  const { larger, smaller } = current.sizes;
  const taken = new Set(cones.map(({ vertex }) => vertex));
  const conesAt = (vertices: number[], k: number): Cone[] =>
    vertices
      .filter((v) => !taken.has(v) && k >= 1 && k <= largestK(q, surface.valence[v]))
      .map((vertex) => ({ vertex, k }));
  // A tip is shrunk by the map: a cone of positive curvature there makes it larger; and the other way round.
  const added = [...conesAt(larger.vertices, q - 1), ...conesAt(smaller.vertices, q + 1)];
  const left = new Map<number, number>();
  for (const { vertex, k } of added) {
    const component = surface.component[vertex];
    left.set(component, (left.get(component) ?? 0) - (q - k));
  }
  const all = [...cones, ...added];
  const rest = await geometry.call('balance', [surface.id, q, all, [...left]]);
  if (doc.prescription !== prescription || added.length === 0) return;
  if (!setPrescription(app, { ...prescription, cones: [...all, ...rest] }, 'even out sizes'))
    return;
  const count = plural(added.length + rest.length, 'cone');
  if ((await run(app)) === 'done')
    doc.say(
      `${count} added where the pattern was largest and smallest. Undo removes them.`,
      'good',
    );
}
