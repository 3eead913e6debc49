// Loads a set of files as a surface: reads, welds and repairs it, and takes the cones that come
// with it.

import type { Model as SolverModel, ModelInfo, Placements, Surface as SurfaceArrays } from 'hgp';
import { ignoredBytes } from '../formats/gzip';
import type { MeshWork } from '../model/document';
import { loadOptionsOf, plainSettings } from '../model/plain';
import { isSilent } from '../model/prescription';
import { identity, type Matrix } from '../model/matrix';
import { canRepair } from '../model/repairs';
import type { ScenePart } from '../model/scene';
import type { LoadSettings, Model, Step } from '../model/types';
import { saveCones } from '../services/cone_storage';
import { describeError, whyUnusable } from '../text/error_messages';
import { remarksOn } from '../text/remarks';
import { estimateFor, maxTriangles, tooMany } from '../text/estimate';
import { bytesOfAll, megabytes } from '../text/format';
import { solverOf, type App } from './app';
import { keepFeatures } from './keep_features';
import { emptyFor, findCones, moveFromPrevious, offerSaved, transferred } from './first_cones';
import { surveyMeshes } from './inspect_meshes';
import { isLocked, runJob, type JobCall } from './job';

type Source = Pick<Model, 'main' | 'files'>;

/** Loads the mesh of a model into the solver again. */
export function loadInSolver(app: App, model: Model, call: JobCall): Promise<SolverModel> {
  const { main, files, info, loaded } = model;
  const options = { name: main, surface: info.surface, ...loadOptionsOf(loaded) };
  return solverOf(app).load({ main, files }, options, call);
}

/** Runs one load as a job; if it fails, the open model stays. */
async function loading(
  app: App,
  source: Source,
  work: (call: JobCall) => Promise<void>,
): Promise<boolean> {
  const { doc } = app;
  const options = {
    kind: 'load' as const,
    title: `Reading ${source.main}`,
    detail: megabytes(bytesOfAll(source.files)),
    onFailure: (error: unknown) => {
      if (doc.state.kind !== 'open') doc.state = { kind: 'empty' };
      doc.say(describeError(error, source.main), 'error');
    },
  };
  return (await runJob(app, options, work)) === 'done';
}

/** The meshes of the files, and those of them that are drawn beside the open one. */
interface Seen {
  best: number;
  parts: ScenePart[];
}

/** Reads every mesh, for the strip and the scene. */
async function lookAround(
  app: App,
  info: ModelInfo,
  placements: readonly Placements[],
  read: (surface: number) => Promise<SolverModel>,
  call: JobCall,
): Promise<Seen> {
  const parts: ScenePart[] = [];
  const isScene = placements.some(({ count }) => count > 0);
  const look = async (index: number): Promise<ModelInfo> => {
    const seen = await read(index);
    const arrays = await seen.surface(call);
    void seen.dispose();
    const isPlaced = !isScene || placements[index].count > 0;
    parts.push(await partOf(app, index, arrays, { placements: placements[index], isPlaced }));
    return seen.info;
  };
  const { summaries, best } = await surveyMeshes(info, placements, look);
  call.signal.throwIfAborted();
  app.doc.summaries = summaries;
  return { best, parts };
}

/** The places of a mesh in the scene; the first is where it is edited. */
function matricesOf(placements: Placements | undefined): readonly Matrix[] {
  const { matrices = new Float64Array() } = placements ?? {};
  const each = Array.from({ length: matrices.length / 16 }, (_, n) => [
    ...matrices.subarray(16 * n, 16 * n + 16),
  ]);
  return each.length > 0 ? each : [identity];
}

/** A mesh as it is drawn beside others. */
async function partOf(
  { doc, geometry }: App,
  mesh: number,
  { positions, triangles, repaired }: SurfaceArrays,
  { placements, isPlaced }: { placements: Placements | undefined; isPlaced: boolean },
): Promise<ScenePart> {
  const matrices = matricesOf(placements);
  const [to] = matrices;
  const arrays = { positions, triangles, repaired };
  const { picture, shape } = await geometry.call('part', [arrays, to], [positions, triangles]);
  doc.thumbnails = new Map(doc.thumbnails).set(mesh, picture);
  return { mesh, isPlaced, ...shape, matrices };
}

/** Reads one mesh of the files with the given settings, and opens it. */
async function readMesh(
  app: App,
  { main, files }: Source,
  settings: LoadSettings,
  surfaceIndex: number | undefined,
  call: JobCall,
): Promise<Model> {
  const { doc, geometry } = app;
  const client = solverOf(app);
  const read = (surface?: number): Promise<SolverModel> =>
    client.load({ main, files }, { name: main, surface, ...loadOptionsOf(settings) }, call);
  let solver = await read(surfaceIndex);
  const placements = await solver.placements(call);
  let parts: ScenePart[] | undefined;
  if (surfaceIndex === undefined && solver.info.surfaces.length > 1) {
    const seen = await lookAround(app, solver.info, placements, read, call);
    ({ parts } = seen);
    void solver.dispose();
    solver = await read(seen.best);
  } else if (surfaceIndex === undefined && matricesOf(placements[0]).length > 1) {
    const of = { placements: placements[0], isPlaced: true };
    parts = [await partOf(app, 0, await solver.surface(call), of)];
  }
  const { info } = solver;
  if (info.triangles > maxTriangles) throw new Error(tooMany(main, info.triangles));
  const [arrays, facts] = await Promise.all([solver.surface(call), solver.facts(call)]);
  call.signal.throwIfAborted();
  const [matrix] = matricesOf(placements[info.surface]);
  const surface = await geometry.surface(arrays, facts, matrix);
  call.signal.throwIfAborted();
  const remarks = remarksOn(info, placements[info.surface], ignoredBytes(files.get(main)));
  const model = { main, files, solver, info, surface, loaded: settings, remarks, matrix };
  if (surfaceIndex === undefined) doc.parts = parts ?? [];
  doc.state = { kind: 'open', model };
  doc.features = undefined; // edges are named by vertices of the surface before
  doc.selected = -1;
  const problem = whyUnusable(info);
  if (info.usable) doc.message = undefined;
  else if (canRepair(model))
    doc.message = { kind: 'note', text: `${problem} “Repair and run” fixes this.` }; // prettier-ignore
  else doc.message = { kind: 'error', text: problem };
  return model;
}

/** Opens a model that is new to the page, or another mesh of the same file for the first time. */
export async function loadMesh(app: App, source: Source, surface?: number): Promise<void> {
  const { doc } = app;
  const isDone = await loading(app, source, async (call) => {
    const model = await readMesh(app, source, plainSettings, surface, call);
    doc.solutions = [];
    doc.begin(emptyFor(doc.prescription.q, model.info), plainSettings);
    if (model.info.usable) await findCones(app, model, call);
    // Unless a repair makes this version usable, the one before is of no more use.
    else if (!canRepair(model)) doc.previous = undefined;
  });
  const opened = doc.usableModel;
  if (!isDone || !opened) return;
  warnOfSize(app, opened);
  void offerSaved(app, opened);
}

/** Opens another mesh of the open file; the work on this one is kept. */
export async function switchMesh(app: App, index: number): Promise<void> {
  const { doc } = app;
  const { work, model } = doc;
  if (!work || !model || isLocked(app) || index === model.info.surface) return;
  const meshes = new Map(doc.meshes).set(model.info.surface, work);
  const waiting = meshes.get(index);
  meshes.delete(index);
  const { isUnsaved } = doc;
  if (waiting) await restoreMesh(app, waiting);
  else {
    doc.clearMesh();
    await loadMesh(app, model, index);
  }
  // If the mesh could not be read, the previous one is still open.
  if (doc.model?.info.surface === index) doc.meshes = meshes;
  else restoreWork(app, work);
  doc.isUnsaved = isUnsaved;
}

function restoreWork({ doc }: App, work: MeshWork): void {
  const { history, solutions, hasUserCones, firstRun, features } = work;
  doc.history = history;
  doc.solutions = solutions;
  doc.hasUserCones = hasUserCones;
  doc.firstRun = firstRun;
  doc.features = features;
}

/** Opens a mesh that was open before: the solver reads it again if it has not kept it, the rest is restored. */
async function restoreMesh(app: App, work: MeshWork): Promise<void> {
  const { doc } = app;
  const { model } = work;
  await loading(app, model, async (call) => {
    const isThere = !model.solver.isDisposed;
    const solver = isThere ? model.solver : await loadInSolver(app, model, call);
    doc.clearMesh();
    doc.state = { kind: 'open', model: isThere ? model : { ...model, solver } };
    restoreWork(app, work);
  });
}

/** Reads the same mesh with other repairs or another weld, as one undo step. */
export async function reloadWith(app: App, settings: LoadSettings, kind: string): Promise<boolean> {
  const { doc } = app;
  const old = doc.model;
  if (!old || isLocked(app)) return false;
  const { prescription, hasUserCones, features } = doc;
  return loading(app, old, async (call) => {
    const model = await readMesh(app, old, settings, old.info.surface, call);
    const lines = keepFeatures(app, features);
    const moved = await transferred(model, prescription, old.solver, call);
    doc.history = doc.history.push({ prescription: moved.prescription, settings }, kind);
    doc.hasUserCones = hasUserCones && !isSilent(moved.prescription);
    if (!model.info.usable) return;
    if (!old.info.usable && (await moveFromPrevious(app, model, call))) return;
    void saveCones(model.info, moved.prescription);
    doc.say(`Done: ${kind}.${moved.text}${lines} Undo reverts it.`, 'good');
  });
}

/** Reads the surface again after undo or redo has led to a step with other repairs. */
export function reloadForStep(app: App, model: Model): Promise<boolean> {
  const { features } = app.doc;
  return loading(app, model, async (call) => {
    await readMesh(app, model, app.doc.settings, model.info.surface, call);
    const lines = keepFeatures(app, features);
    if (lines) app.doc.say(lines.trim());
  });
}

/** Opens a closed model again in the state in which it was left. */
export async function reopen(
  app: App,
  source: Source,
  surface: number,
  { prescription, settings }: Step,
): Promise<void> {
  const { doc } = app;
  await loading(app, source, async (call) => {
    await readMesh(app, source, settings, surface, call);
    doc.begin(prescription, settings);
    doc.say(`${source.main} is open again, with its cones.`);
  });
}

function warnOfSize({ doc }: App, { info }: Model): void {
  const { needed, isTight } = estimateFor(info);
  if (!isTight || doc.message) return;
  doc.say(`This mesh needs about ${needed}: see the Solve panel before running it here.`);
}
