// One file with the maps of all its meshes: each map is written into the result of the previous one and then compared
// with the map that was shown. A map that the solver no longer has is computed again.

import type { UvMap } from 'hgp';
import type { MeshWork } from '../model/document';
import { toCones } from '../model/prescription';
import type { OutputFile, Solution } from '../model/types';
import { isCertified } from '../model/verdict';
import { describeError } from '../text/error_messages';
import { solverOf, type App } from './app';
import { runJob, type JobCall } from './job';
import { loadInSolver } from './load';
import { writeOptions } from './solve';

interface Part {
  work: MeshWork;
  solution: Solution;
}

/** The meshes that have a map, in the order of the file. */
export function mappedMeshes({ doc }: App): Part[] {
  const { work: open, current } = doc;
  const waiting = [...doc.meshes.values()].flatMap((work): Part[] => {
    const solution = work.solutions.at(-1);
    return solution ? [{ work, solution }] : [];
  });
  const all = open && current ? [...waiting, { work: open, solution: current }] : waiting;
  return all.sort((a, b) => a.work.model.info.surface - b.work.model.info.surface);
}

/** The map in the solver, computed again if that was disposed of. */
async function mapOf(app: App, { work, solution }: Part, call: JobCall): Promise<UvMap> {
  if (!solution.map.isDisposed) return solution.map;
  const { model } = work;
  const solver = model.solver.isDisposed ? await loadInSolver(app, model, call) : model.solver;
  const { prescription, output, improve, cells, grid } = solution;
  const aligned = cells === undefined ? {} : { grid: { cells, mode: grid.mode } };
  const options = { maxRounds: app.doc.solve.rounds, improve, scale: output.scale, ...aligned };
  return solver.parametrize({ cones: toCones(prescription), ...options }, call);
}

async function compose(app: App, parts: Part[], call: JobCall): Promise<OutputFile[]> {
  const maps: UvMap[] = [];
  for (const part of parts) maps.push(await mapOf(app, part, call));
  const options = parts.map(({ solution }) => writeOptions(solution.output));
  return (await solverOf(app).combine(maps, options, call)).files;
}

/** Undefined if one of the maps could not be reproduced. */
export async function filesWithAllMaps(app: App): Promise<OutputFile[] | undefined> {
  const { doc } = app;
  const parts = mappedMeshes(app);
  const open = doc.model;
  if (!open) return undefined;
  let files: OutputFile[] | undefined;
  const onFailure = (error: unknown): void => doc.say(describeError(error, open.main), 'error');
  const title = `Writing ${parts.length} meshes`;
  await runJob(app, { kind: 'run', title, onFailure }, async (call) => {
    const made = await compose(app, parts, call);
    for (const { work, solution } of parts) {
      const mesh = work.model.info.surface;
      const { uvSet } = solution.output;
      const { difference } = await app.geometry.compare(solution.result, made, { mesh, uvSet });
      if (difference)
        throw new Error(`Mesh ${mesh} is not in the file as it was seen: ${difference}.`);
    }
    files = made;
  });
  if (!files) return undefined;
  const failed = parts.filter(({ solution }) => !isCertified(solution)).length;
  const text = `${parts.length} meshes in one file`;
  doc.say(failed > 0 ? `${text}; ${failed} of them not certified.` : `${text}, all certified.`, failed > 0 ? 'error' : 'good'); // prettier-ignore
  return files;
}
