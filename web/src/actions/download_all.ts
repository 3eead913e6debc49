// One file with the maps of all its meshes: each map is written into the result of the previous one and then compared
// with the map that was shown. A map that the solver no longer has is computed again.

import { loadOptionsOf, type MeshWork } from '../model/document';
import { toCones } from '../model/prescription';
import type { Files, OutputFile, Solution } from '../model/types';
import { isCertified } from '../model/verdict';
import { describeError } from '../text/error_messages';
import { solverOf, type App } from './app';
import { runJob, type JobCall } from './job';
import { reloadInSolver } from './load';
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

async function addMap(
  app: App,
  { work, solution }: Part,
  files: Files,
  call: JobCall,
): Promise<OutputFile[]> {
  const client = solverOf(app);
  const { main, info, loaded } = work.model;
  await client.load(
    { main, files },
    { name: main, surface: info.surface, ...loadOptionsOf(loaded) },
    call,
  );
  if (!(await client.recall(solution.keptAs, call))) {
    const { prescription, output, improve, cells, grid } = solution;
    const aligned = cells === undefined ? {} : { grid: { cells, mode: grid.mode } };
    const options = { maxRounds: app.doc.solve.rounds, improve, scale: output.scale, ...aligned };
    await client.parametrize({ cones: toCones(prescription), ...options }, call);
    await client.keep(solution.keptAs, call);
  }
  const written = await client.write(writeOptions(solution.output), call);
  return written.files;
}

async function compose(app: App, parts: Part[], call: JobCall): Promise<OutputFile[]> {
  const { model } = parts[0].work;
  let files: Files = new Map(model.files);
  const made = new Map<string, OutputFile>();
  for (const part of parts) {
    const written = await addMap(app, part, files, call);
    files = new Map(files);
    for (const file of written) {
      const isMain = file === written[0];
      files.set(isMain ? model.main : file.name, file.bytes);
      made.set(isMain ? '' : file.name, file);
    }
  }
  return [...made.values()];
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
  if (!doc.job) await reloadInSolver(app);
  if (!files) return undefined;
  const failed = parts.filter(({ solution }) => !isCertified(solution)).length;
  const text = `${parts.length} meshes in one file`;
  doc.say(failed > 0 ? `${text}; ${failed} of them not certified.` : `${text}, all certified.`, failed > 0 ? 'error' : 'good'); // prettier-ignore
  return files;
}
