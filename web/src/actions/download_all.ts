// One file with the maps of all its meshes, written with the output settings of the mesh that is open: each map is
// written into the result of the previous one, compared with the map that was shown, and verified as stored in the file.
// A map that the solver no longer has, or has in another scale, is computed again.

import type { CombineOptions, UvMap } from 'hgp';
import type { MeshWork } from '../model/document';
import { plainOutput } from '../model/plain';
import { gridTilesPerUnit } from '../model/grid';
import { optionsAgain } from '../model/request';
import type { Model, Output, OutputFile, Solution } from '../model/types';
import { describeError } from '../text/error_messages';
import { solveAligned } from './align';
import { solverOf, type App } from './app';
import { runJob, type JobCall } from './job';
import { loadInSolver } from './load';
import { writeOptions } from './write_solution';

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

/** The map in the solver, computed again if it was disposed of or has another scale. */
async function mapOf(
  app: App,
  { work, solution }: Part,
  { scale }: Output,
  call: JobCall,
): Promise<UvMap> {
  if (!solution.map.isDisposed && solution.output.scale === scale) return solution.map;
  const { model } = work;
  const solver = model.solver.isDisposed ? await loadInSolver(app, model, call) : model.solver;
  const { cells, grid } = solution;
  const asked = { ...grid, cells: cells ?? grid.cells };
  const { map } = await solveAligned(app, { solver }, optionsAgain(solution, scale), call, asked);
  return map;
}

/**
 * The set to write for one mesh, where `output` was chosen for all: a mesh without the set that is to be replaced gets
 * a new one.
 */
function outputFor({ info }: Model, output: Output): Output {
  const { uvSet } = output;
  const sets = info.surfaces[info.surface]?.uvSets ?? [];
  if (uvSet === undefined || sets.includes(uvSet)) return output;
  return { ...output, uvSet: undefined, usesNewSet: true };
}

function optionsFor(app: App, { work, solution }: Part, output: Output): CombineOptions {
  const options = writeOptions(outputFor(work.model, output));
  if (!output.hasGrid) return options;
  const gridMaterial = gridTilesPerUnit(app.doc.look, work.model.surface, solution);
  return { ...options, gridMaterial };
}

/** Whether `hgp verify` of the file would certify a mesh: with the set and the repairs that it chooses. */
async function isVerified(
  app: App,
  { main, files, info }: Model,
  made: OutputFile[],
  call: JobCall,
): Promise<boolean> {
  const all = new Map(files);
  made.forEach(({ name, bytes }, i) => all.set(i === 0 ? main : name, bytes));
  const options = { name: main, surface: info.surface };
  await using model = await solverOf(app).load({ main, files: all }, options, call);
  return (await model.verify({}, call)).certified;
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
  const output = doc.current?.output ?? plainOutput;
  const verified: boolean[] = [];
  await runJob(app, { kind: 'run', title, onFailure }, async (call) => {
    const maps: UvMap[] = [];
    for (const part of parts) maps.push(await mapOf(app, part, output, call));
    const options = parts.map((part) => optionsFor(app, part, output));
    const made = (await solverOf(app).combine(maps, options, call)).files;
    for (const [i, { work, solution }] of parts.entries()) {
      const { model } = work;
      const mesh = model.info.surface;
      const { uvSet } = outputFor(model, output);
      // The arrays of a map that is shown are in its solution.
      const map = maps[i] === solution.map ? solution.result : maps[i];
      const { difference } = await app.geometry.compare(map, made, { mesh, uvSet });
      if (difference)
        throw new Error(`Mesh ${mesh} is not in the file as it was seen: ${difference}.`);
      verified.push(await isVerified(app, model, made, call));
    }
    files = made;
  });
  if (!files) return undefined;
  const good = verified.filter(Boolean).length;
  const text = `${parts.length} meshes in one file`;
  if (good === parts.length) doc.say(`${text}, all certified.`, 'good');
  else doc.say(`${text}; ${parts.length - good} of them not certified.`, 'error');
  return files;
}
