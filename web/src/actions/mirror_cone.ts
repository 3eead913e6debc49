// The cone opposite to the selected one, where the surface is its own mirror image.

import type { App } from './app';
import { select, setPrescription } from './edit_cones';
import { isLocked } from './job';
import { oppositeIn } from './opposite';

export async function mirrorCone(app: App): Promise<void> {
  const { doc, geometry } = app;
  const { prescription, selected } = doc;
  const surface = doc.usableModel?.surface;
  const cone = prescription.cones[selected];
  if (!surface || !cone || isLocked(app)) return;
  const known = oppositeIn(app)(cone.vertex);
  const { vertex, hasPlane } =
    known < 0
      ? await geometry.call('opposite', [surface.id, cone.vertex])
      : { vertex: known, hasPlane: true };
  if (doc.prescription !== prescription) return; // edited in the meantime
  if (!hasPlane) return doc.say('This surface is not its own mirror image in any plane.', 'error');
  if (vertex === cone.vertex)
    return doc.say('This cone lies in the plane of symmetry: it is its own mirror image.');
  if (vertex < 0 || surface.isBoundary[vertex])
    return doc.say('There is no vertex opposite to this cone.', 'error');
  const there = prescription.cones.findIndex((one) => one.vertex === vertex);
  if (there >= 0) {
    select(app, there);
    return doc.say('The cone opposite to it is there already.');
  }
  const cones = [...prescription.cones, { vertex, k: cone.k }];
  if (!setPrescription(app, { ...prescription, cones }, `mirror cone: ${vertex}`)) return;
  select(app, cones.length - 1);
  doc.say(`A cone with k = ${cone.k} was placed opposite.`, 'good');
}
