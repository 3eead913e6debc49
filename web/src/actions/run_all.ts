// Runs all meshes of a file, one after the other; meshes that cannot be used are skipped and reported.

import { isCertified } from '../model/verdict';
import { plural } from '../text/format';
import type { App } from './app';
import { switchMesh } from './load';
import { repairAndRun } from './repair';

export async function runAll(app: App): Promise<void> {
  const { doc } = app;
  const { model } = doc;
  if (!model) return;
  const request = doc.openRequestId;
  const first = model.info.surface;
  const done: number[] = [];
  const left: string[] = [];
  for (const { index, name } of model.info.surfaces) {
    await switchMesh(app, index);
    if (doc.openRequestId !== request || doc.model?.info.surface !== index) return;
    const outcome = doc.current ? 'done' : await repairAndRun(app);
    if (outcome === 'cancelled' || outcome === 'replaced') return;
    if (doc.current && isCertified(doc.current)) done.push(index);
    else left.push(name || `Mesh ${index}`);
  }
  await switchMesh(app, first);
  const rest = left.length > 0 ? ` Not certified: ${left.join(', ')}.` : '';
  doc.say(
    `${plural(done.length, 'mesh', 'meshes')} certified.${rest}`,
    left.length ? 'error' : 'good',
  );
}
