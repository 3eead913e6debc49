// The cells of a map as a quad mesh: seen first, then saved. A map that is aligned for textures only is solved once
// more for it, with its cones on grid points; the map that is shown stays.

import type { UvMap } from 'hgp';
import { safeName } from '../formats/file_set';
import { readQuads } from '../model/quad_shape';
import { gridOutcome, isAligned } from '../model/grid';
import { optionsAgain } from '../model/request';
import type { QuadPreview, Solution } from '../model/types';
import { isCertified } from '../model/verdict';
import { describeError } from '../text/error_messages';
import { count } from '../text/format';
import { quadsSaved } from '../text/quads';
import { solveAligned } from './align';
import type { App } from './app';
import { saveFile } from './download';
import { runJob, type JobCall } from './job';
import { mapInSolver, realign } from './solve';

export type QuadFile = 'obj' | 'glb';

/** Why there can be no quads; empty if there may be some. */
export function whyNoQuads({ doc }: App): string {
  if (!doc.current) return 'Run first.';
  if (doc.prescription.q !== 4) return `Quads need q = 4, not ${doc.prescription.q}.`;
  if (!isCertified(doc.current)) return 'The map is not certified.';
  return doc.current.output.scale === 'solved' ? '' : 'Quads need the scale as solved.';
}

const isForQuads = ({ grid, result }: Solution): boolean =>
  grid.mode === 'quad' && isAligned({ result });

/** The map with its cones on grid points; undefined if there is none, and the user was told why. */
async function quadMap(app: App, current: Solution, call: JobCall): Promise<UvMap | undefined> {
  const { doc } = app;
  const model = doc.usableModel;
  if (isForQuads(current) && !current.map.isDisposed) return current.map;
  if (!model) return undefined;
  const options = optionsAgain(current, 'solved');
  const settings = { ...doc.solve.grid, isOn: true, mode: 'quad' as const };
  const { map } = await solveAligned(app, model, options, call, settings);
  const outcome = gridOutcome({ result: map });
  if (outcome?.isAligned && map.certificate.certified) return map;
  const working = outcome?.workingCells ?? 0;
  const denser = { label: `Use ${count(working)} cells`, run: () => withCells(app, working) };
  void map.dispose();
  doc.job = undefined;
  doc.say(
    'No quad mesh: so few cells are too coarse for these cones.',
    'error',
    working > 0 ? [denser] : [],
  );
  return undefined;
}

async function withCells(app: App, cells: number): Promise<void> {
  await realign(app, { isOn: true, cells });
  await previewQuads(app);
}

const quadsShown = 'The quads are shown on the model; your map is still there.';

/** Makes the quads of the map that is shown, and shows them; what was made is kept. */
export async function previewQuads(app: App): Promise<QuadPreview | undefined> {
  const { doc } = app;
  const why = whyNoQuads(app);
  if (why) return void doc.say(why, 'error');
  if (doc.current?.map.isDisposed) await mapInSolver(app);
  const { current } = doc;
  if (!current) return undefined;
  if (doc.quads?.of === current) return (doc.quads = { ...doc.quads, isShown: true });
  const onFailure = (error: unknown): void =>
    doc.say(describeError(error, doc.model?.main ?? ''), 'error');
  await runJob(app, { kind: 'run', title: 'Making quads', onFailure }, async (call) => {
    const map = await quadMap(app, current, call);
    if (!map) return;
    const made = await map.quads({ name: quadName(app, 'obj') }, call);
    const glb = await map.quads({ name: quadName(app, 'glb') }, call);
    const asked = doc.solve.grid.cells ?? current.cells;
    if (map !== current.map) void map.dispose();
    doc.job = undefined;
    const shape = readQuads(made.bytes);
    doc.quads = { of: current, made, glb: glb.bytes, shape, asked, isShown: true };
    doc.say(quadsShown, 'good');
  });
  return doc.quads?.of === current ? doc.quads : undefined;
}

export function hideQuads({ doc }: App): void {
  if (doc.quads) doc.quads = { ...doc.quads, isShown: false };
  if (doc.message?.text === quadsShown) doc.message = undefined;
}

export const quadName = ({ doc }: App, file: QuadFile): string => {
  const stem = safeName(doc.model?.main ?? '').replace(/\.[^.]*$/, '') || 'model';
  return `${stem}.quads.${file}`;
};

export async function downloadQuads(app: App, file: QuadFile): Promise<void> {
  const { doc } = app;
  const preview = await previewQuads(app);
  if (!preview) return;
  const name = quadName(app, file);
  const isGlb = file === 'glb';
  const bytes = isGlb ? preview.glb : preview.made.bytes;
  await saveFile({ name, bytes, type: isGlb ? 'model/gltf-binary' : 'text/plain' });
  doc.say(quadsSaved(preview.made, name), 'good');
}
