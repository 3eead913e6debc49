// Saves the cells of a map aligned in quad mode as a quad mesh. If the map is aligned for textures only,
// it is first run again with its cones on grid points.

import { isAligned } from '../model/grid';
import type { Solution } from '../model/types';
import { isCertified } from '../model/verdict';
import { safeName } from '../formats/file_set';
import { describeError } from '../text/error_messages';
import { quadsSaved } from '../text/quads';
import type { UvMap } from 'hgp';
import type { App } from './app';
import { saveFile } from './download';
import { runJob } from './job';
import { denserButton, mapInSolver, realign } from './solve';

export type QuadFile = 'obj' | 'glb';

/** Why there can be no quads; empty if Run may produce some. */
export function whyNoQuads({ doc }: App): string {
  if (!doc.current) return 'Run first.';
  if (doc.prescription.q !== 4) return `Quads need q = 4, not ${doc.prescription.q}.`;
  return doc.current.output.scale === 'solved' ? '' : 'Quads need the scale as solved.';
}

const isForQuads = (solution: Solution | undefined): solution is Solution =>
  solution !== undefined &&
  solution.grid.mode === 'quad' &&
  isAligned(solution) &&
  isCertified(solution);

/** The map with its cones on grid points; if there is none, the user is told why. */
async function quadMap(app: App): Promise<UvMap | undefined> {
  const { doc } = app;
  if (!isForQuads(doc.current)) await realign(app, { isOn: true, mode: 'quad' });
  if (isForQuads(doc.current)) return mapInSolver(app);
  if (!doc.current) return undefined; // cancelled, or failed and reported
  const reason = isCertified(doc.current)
    ? 'the grid is too coarse for these cones'
    : 'the map is not certified';
  doc.say(`No quad mesh: ${reason}.`, 'error', denserButton(app, doc.current));
  return undefined;
}

export const quadName = ({ doc }: App, file: QuadFile): string => {
  const stem = safeName(doc.model?.main ?? '').replace(/\.[^.]*$/, '') || 'model';
  return `${stem}.quads.${file}`;
};

export async function downloadQuads(app: App, file: QuadFile): Promise<void> {
  const { doc } = app;
  const why = whyNoQuads(app);
  if (why) return doc.say(why, 'error');
  const map = await quadMap(app);
  if (!map) return;
  const name = quadName(app, file);
  const onFailure = (error: unknown): void => doc.say(describeError(error, name), 'error');
  await runJob(app, { kind: 'run', title: 'Making quads', onFailure }, async (call) => {
    const made = await map.quads({ name }, call);
    doc.job = undefined;
    const type = file === 'glb' ? 'model/gltf-binary' : 'text/plain';
    await saveFile({ name, bytes: made.bytes, type });
    doc.say(quadsSaved(made, name), 'good');
  });
}
