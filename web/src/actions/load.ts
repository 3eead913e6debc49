// Loads a set of files as a surface: reads, welds and repairs it, and takes the cones that come
// with it.

import type { Model as SolverModel, ModelInfo, Placements, Surface as SurfaceArrays } from 'hgp';
import { ignoredBytes } from '../formats/gzip';
import { loadOptionsOf, plainSettings, type MeshWork } from '../model/document';
import {
  emptyPrescription,
  fromCones,
  isSilent,
  toCones,
  type Prescription,
} from '../model/prescription';
import { identity, type Matrix } from '../model/matrix';
import { canRepair } from '../model/repairs';
import type { ScenePart } from '../model/scene';
import type { LoadSettings, Model, Step } from '../model/types';
import { restorable, saveCones } from '../services/cone_storage';
import { describeError, whyUnusable } from '../text/error_messages';
import { remarksOn } from '../text/remarks';
import { estimateFor, mostTriangles, tooMany } from '../text/estimate';
import { bytesOfAll, megabytes, plural } from '../text/format';
import { gzipNote, noteForPage } from '../text/notes';
import { describeTransfer } from '../text/transfer';
import { solverOf, type App } from './app';
import { setPrescription } from './edit_cones';
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
  const look = async (index: number): Promise<ModelInfo> => {
    const seen = await read(index);
    const arrays = await seen.surface(call);
    void seen.dispose();
    parts.push(await partOf(app, index, arrays, placements[index]));
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
  placements: Placements | undefined,
): Promise<ScenePart> {
  const matrices = matricesOf(placements);
  const [to] = matrices;
  const arrays = { positions, triangles, repaired };
  const { picture, shape } = await geometry.call('part', [arrays, to], [positions, triangles]);
  doc.thumbnails = new Map(doc.thumbnails).set(mesh, picture);
  return { mesh, ...shape, matrices };
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
    parts = [await partOf(app, 0, await solver.surface(call), placements[0])];
  }
  const { info } = solver;
  if (info.triangles > mostTriangles) throw new Error(tooMany(main, info.triangles));
  const [arrays, facts] = await Promise.all([solver.surface(call), solver.facts(call)]);
  call.signal.throwIfAborted();
  const [matrix] = matricesOf(placements[info.surface]);
  const surface = await geometry.surface(arrays, facts, matrix);
  call.signal.throwIfAborted();
  const ignored = ignoredBytes(files.get(main));
  const remarks = remarksOn(info, placements[info.surface]);
  if (ignored > 0) remarks.unshift(noteForPage(gzipNote(ignored)));
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

const emptyFor = (q: number, info: ModelInfo): Prescription =>
  emptyPrescription(q, info.boundaryLoops ?? 0, 2 * (info.genus ?? 0));

/** Opens a model that is new to the page, or another mesh of the same file for the first time. */
export async function loadMesh(app: App, source: Source, surface?: number): Promise<void> {
  const { doc } = app;
  const isDone = await loading(app, source, async (call) => {
    const model = await readMesh(app, source, plainSettings, surface, call);
    doc.solutions = [];
    doc.begin(emptyFor(doc.prescription.q, model.info), plainSettings);
    if (model.info.usable) await findCones(app, model, call);
  });
  if (isDone && doc.usableModel) warnOfSize(app, doc.usableModel);
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

interface Transferred {
  prescription: Prescription;
  kept: number;
  /** What was kept and what was not. */
  text: string;
}

/** A prescription on another reading of its surface. */
async function transferred(
  { solver, info }: Model,
  prescription: Prescription,
  from: SolverModel,
  call: JobCall,
): Promise<Transferred> {
  if (!info.usable) {
    // Another repair may make the mesh usable; the cones are kept until then.
    const waiting = { ...prescription, turnings: [], handles: [] };
    return { prescription: waiting, kept: prescription.cones.length, text: '' };
  }
  const { cones, lost } = await solver.transferCones(toCones(prescription), from, call);
  const empty = emptyFor(prescription.q, info);
  const kept = cones.cones.length;
  return {
    prescription: fromCones(cones, empty.turnings.length, empty.handles.length),
    kept,
    text: describeTransfer(kept, lost),
  };
}

/** Reads the same mesh with other repairs or another weld, as one undo step. */
export async function reloadWith(app: App, settings: LoadSettings, kind: string): Promise<boolean> {
  const { doc } = app;
  const old = doc.model;
  if (!old || isLocked(app)) return false;
  const { prescription, hasUserCones } = doc;
  return loading(app, old, async (call) => {
    const model = await readMesh(app, old, settings, old.info.surface, call);
    const moved = await transferred(model, prescription, old.solver, call);
    doc.history = doc.history.push({ prescription: moved.prescription, settings }, kind);
    doc.hasUserCones = hasUserCones && !isSilent(moved.prescription);
    if (!model.info.usable) return;
    void saveCones(model.info.file.sha256, moved.prescription);
    doc.say(`Done: ${kind}.${moved.text} Undo reverts it.`, 'good');
  });
}

/** Reads the surface again after undo or redo has led to a step with other repairs. */
export function reloadForStep(app: App, model: Model): Promise<boolean> {
  return loading(app, model, async (call) => {
    await readMesh(app, model, app.doc.settings, model.info.surface, call);
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

/** Transfers the cones from the previous version of the file, as one undo step. */
async function transferFromPrevious(app: App, model: Model, call: JobCall): Promise<boolean> {
  const { doc } = app;
  const { previous } = doc;
  doc.previous = undefined;
  // Without the reading of before there is nothing to move cones from: its file may have changed since.
  if (!previous || previous.model.main !== model.main || previous.model.solver.isDisposed) {
    return false;
  }
  const { info } = previous.model;
  if (info.file.sha256 === model.info.file.sha256) return false;
  if (model.info.surfaces.length > 1 && info.surface !== model.info.surface) return false;
  const moved = await transferred(model, previous.prescription, previous.model.solver, call);
  if (moved.kept === 0) return false;
  return setWhileLoading(app, moved.prescription, 'carry cones over', () =>
    doc.say(`Another version of ${model.main}.${moved.text} Undo removes them.`),
  );
}

/** Sets the prescription during loading; a loading job does not prevent edits. */
function setWhileLoading(app: App, to: Prescription, kind: string, say: () => void): boolean {
  setPrescription(app, to, kind);
  say();
  return true;
}

/** Takes cones from the file or its previous version, or offers those of an earlier session. */
async function findCones(app: App, model: Model, call: JobCall): Promise<void> {
  const { doc } = app;
  const { turnings, handles } = doc.prescription;
  const embedded = await model.solver.embeddedCones().catch(() => null);
  if (embedded && embedded.cones.length > 0) {
    doc.begin(fromCones(embedded, turnings.length, handles.length));
    doc.hasUserCones = true;
    doc.message = {
      kind: 'note',
      text: `${plural(embedded.cones.length, 'cone')} came with the file.`,
    };
    return;
  }
  if (await transferFromPrevious(app, model, call)) return;
  await offerSaved(app, model);
}

async function offerSaved(app: App, model: Model): Promise<void> {
  const { doc } = app;
  const saved = await restorable(model.info.file.sha256);
  const count = saved?.prescription.cones.length ?? 0;
  if (!saved || count === 0) return;
  const cones = plural(count, 'cone');
  const when = new Date(saved.time).toLocaleDateString(undefined, { dateStyle: 'medium' });
  const restore = (): void => {
    setPrescription(app, saved.prescription, 'restore cones');
    doc.say(`${cones} restored.`);
  };
  doc.message = {
    kind: 'note',
    text: `You placed ${cones} on this file (${when}).`,
    actions: [{ label: `Restore ${cones}`, run: restore }],
  };
}
