// From a set of files to a surface that can be worked on: read, welded, repaired, with the cones that
// came with it.

import type { ModelInfo } from 'hgp';
import type { App, LoadSettings, Step } from './app';
import { restorable, save } from './autosave';
import { carry, inWords } from './carry';
import { isLocked, replaceAsked } from './edit';
import { estimateOf, mostTriangles, tooMany } from './estimate';
import { bytesOfAll, explain, inButtons, megabytes } from './explain';
import { embeddedCones } from './files';
import { emptyPrescription, fromCones, type Prescription } from './prescription';
import { follow, isAbort } from './run';
import { surveyMeshes } from './survey';
import { makeSurface } from './surface';
import { remarksOn, usesOf } from './uses';

interface LoadCall {
  signal: AbortSignal;
  onProgress: ReturnType<typeof follow>;
}

/** Does one load with progress and every way it can end; whether it came to its end. */
async function loading(app: App, work: (call: LoadCall) => Promise<void>): Promise<boolean> {
  app.running?.abort();
  const own = (app.running = new AbortController());
  const hadModel = app.phase === 'invalid' || app.phase === 'editing';
  const before = app.phase;
  app.phase = 'loading';
  const title = `Reading ${app.main}`;
  const detail = megabytes(bytesOfAll(app.files));
  app.progress = { title, stage: 'read', detail, fraction: 0, begin: performance.now() };
  app.changed();
  try {
    await work({ signal: own.signal, onProgress: follow(app, own) });
    return own === app.running;
  } catch (error) {
    if (own !== app.running) return false;
    app.phase = hadModel ? before : 'empty';
    if (!hadModel) app.info = app.surface = undefined;
    if (isAbort(error)) app.say('Cancelled.');
    else app.say(explain(error, app.main), 'error');
    return false;
  } finally {
    if (own === app.running) {
      app.progress = undefined;
      app.running = undefined;
      app.changed();
    }
  }
}

/** Reads one mesh of the files with the given settings, and shows it. */
async function take(
  app: App,
  settings: LoadSettings,
  surface: number | undefined,
  call: LoadCall,
): Promise<ModelInfo> {
  const source = { main: app.main, files: app.files };
  const { weld, fix } = settings;
  const read = (index?: number): Promise<ModelInfo> =>
    app.client!.load(source, { name: app.main, surface: index, weld, fix }, call);
  let info = await read(surface);
  const uses = await usesOf(app.files, app.main);
  if (surface === undefined && info.surfaces.length > 1) {
    const { survey, best } = await surveyMeshes(info, uses, (index) => read(index));
    app.survey = survey;
    info = await read(best);
  }
  if (info.triangles > mostTriangles) throw new Error(tooMany(app.main, info.triangles));
  const arrays = await app.client!.surface(call);
  call.signal.throwIfAborted();
  const made = await makeSurface(arrays);
  call.signal.throwIfAborted();
  app.info = info;
  app.remarks = remarksOn(info, uses?.[info.surface]);
  app.surface = made;
  app.loaded = settings;
  app.inWorker = undefined;
  app.natural.clear();
  app.selected = -1;
  app.phase = info.usable ? 'editing' : 'invalid';
  app.message = info.usable ? undefined : { kind: 'error', text: inButtons(info.error?.message) };
  return info;
}

const emptyFor = (app: App, info: ModelInfo): Prescription =>
  emptyPrescription(app.asked.q, info.boundaryLoops ?? 0, 2 * (info.genus ?? 0));

/** A model that is new to the page, or another mesh of the same file. */
export async function load(app: App, surface?: number): Promise<void> {
  const isDone = await loading(app, async (call) => {
    const settings: LoadSettings = { fix: {} };
    const info = await take(app, settings, surface, call);
    app.results = [];
    app.begin(emptyFor(app, info), settings);
    if (info.surfaces.length > 1 && surface === undefined) app.phase = 'pick-mesh';
    if (info.usable) await findCones(app);
  });
  if (isDone && app.info?.usable) warnOfSize(app);
}

/** The same mesh with other repairs or another weld: one step of undo. */
export async function change(app: App, settings: LoadSettings, kind: string): Promise<void> {
  if (isLocked(app)) return app.changed(); // and the field shows what it was
  const { asked } = app;
  const old = { surface: app.surface!, info: app.info! };
  await loading(app, async (call) => {
    const info = await take(app, settings, app.info!.surface, call);
    const carried = carry(asked, old, { surface: app.surface!, info }, true);
    app.history.push({ asked: carried.asked, settings }, kind);
    app.isExplicit &&= isSaid(carried.asked);
    if (!info.usable) return;
    void save(info.file.sha256, carried.asked);
    app.say(`Done: ${kind}.${inWords(carried)} Undo takes it back.`, 'good');
  });
}

const isSaid = ({ cones, turnings, handles }: Prescription): boolean =>
  cones.length > 0 || [...turnings, ...handles].some((n) => n !== null);

/** Undo and redo went to a step with other repairs: the surface follows. */
export function reload(app: App): Promise<boolean> {
  return loading(app, async (call) => {
    await take(app, app.settings, app.info!.surface, call);
  });
}

/** What was closed, as it was. */
export async function reopen(app: App, surface: number, { asked, settings }: Step): Promise<void> {
  await loading(app, async (call) => {
    await take(app, settings, surface, call);
    app.begin(asked, settings);
    app.say(`${app.main} is open again, with its cones.`);
  });
}

function warnOfSize(app: App): void {
  const { needed, isTight } = estimateOf(app);
  if (isTight && !app.message) {
    app.say(`This mesh needs about ${needed}: see the Solve panel before running it here.`);
  }
}
/** Another version of the file that was open: the cones go along, as one step of undo. */
function carryOver(app: App): boolean {
  const { previous, surface, info } = app;
  app.previous = undefined;
  if (!previous || previous.main !== app.main || !surface || !info) return false;
  if (previous.info.file.sha256 === info.file.sha256) return false;
  if (info.surfaces.length > 1 && previous.info.surface !== info.surface) return false;
  const carried = carry(previous.asked, previous, { surface, info }, false);
  if (carried.kept === 0) return false;
  replaceAsked(app, carried.asked, 'carry cones over');
  app.say(`Another version of ${app.main}.${inWords(carried)} Undo takes them off.`);
  return true;
}

/** Cones stored in the file, those of its last version, or offered from an earlier session. */
async function findCones(app: App): Promise<void> {
  const info = app.info!;
  const text = await embeddedCones(app.files, app.main, info.surface).catch(() => undefined);
  if (text !== undefined) {
    const name = text.startsWith('{') ? 'cones.json' : app.main;
    const cones = await app
      .client!.readCones({ name, text, q: app.asked.q })
      .catch(() => undefined);
    if (cones && cones.cones.length > 0) {
      app.isExplicit = true;
      const found = fromCones(cones, app.asked.turnings.length, app.asked.handles.length);
      app.begin(found);
      app.message = { kind: 'note', text: `${found.cones.length} cones came with the file.` };
      return;
    }
  }
  if (carryOver(app)) return;
  const saved = await restorable(info.file.sha256);
  if (!saved || saved.asked.cones.length === 0) return;
  const count = saved.asked.cones.length;
  const when = new Date(saved.time).toLocaleDateString(undefined, { dateStyle: 'medium' });
  app.message = {
    kind: 'note',
    text: `You placed ${count} cones on this file (${when}).`,
    actions: [
      {
        label: `Restore ${count} cones`,
        do: () => {
          replaceAsked(app, saved.asked, 'restore cones');
          app.say(`${count} cones restored.`);
        },
      },
    ],
  };
}
