// From files to a surface on screen: which model, what is missing, which mesh, what is wrong with it.

import { HgpError } from 'hgp';
import type { App } from './app';
import { restorable } from './autosave';
import {
  coneFileOf,
  embeddedCones,
  findMissing,
  meshesOf,
  unpack,
  bytesOf,
  type Files,
} from './files';
import { History } from './history';
import { emptyPrescription, fromCones } from './prescription';
import { makeSurface } from './surface';
import { importCones, replaceAsked } from './edit';
import { follow, isAbort } from './run';

const bytesOfAll = (files: Files): number =>
  [...files.values()].reduce(
    (sum, file) => sum + (file instanceof Uint8Array ? file.length : file.size),
    0,
  );

const megabytes = (bytes: number): string =>
  `${(bytes / 2 ** 20).toFixed(bytes < 2 ** 20 ? 2 : 0)} MB`;
const mostBytes = 512 * 2 ** 20;
const mostTriangles = 2_000_000;

/** From the solver's own measurements: about 4 KB of memory and a tenth of a millisecond each. */
function tooMany(name: string, triangles: number): string {
  const gigabytes = ((triangles * 4096) / 2 ** 30).toFixed(0);
  const millions = (triangles / 1e6).toFixed(1);
  return (
    `${millions} million triangles would need about ${gigabytes} GB; a page may use 4. ` +
    `The command line has no such limit: hgp param "${name}" -o mapped`
  );
}

/** New files: a model, a cone file for the model that is open, or what was missing. */
export async function open(app: App, dropped: Files): Promise<void> {
  if (dropped.size === 0) return;
  const coneFile = app.surface ? coneFileOf(dropped) : undefined;
  if (coneFile) {
    const text = new TextDecoder().decode(await bytesOf(dropped.get(coneFile)!));
    return importCones(app, coneFile, text);
  }
  let files: Files;
  try {
    files = await unpack(dropped);
  } catch (error) {
    return app.say((error as Error).message, 'error');
  }
  const meshes = meshesOf(files);
  if (app.phase === 'needs-files' && meshes.length === 0) return supply(app, files);
  app.forgetModel();
  app.files = files;
  if (meshes.length === 0) {
    app.phase = 'empty';
    const name = [...files.keys()][0] ?? '';
    return app.say(
      `“${name}” holds no mesh. Drop a GLB, glTF, OBJ, PLY, STL or OFF file.`,
      'error',
    );
  }
  if (meshes.length > 1) {
    app.candidates = meshes;
    app.phase = 'pick-mesh';
    return app.changed();
  }
  await openMain(app, meshes[0]);
}

export async function openMain(app: App, main: string): Promise<void> {
  app.candidates = [];
  app.main = main;
  const size = bytesOfAll(app.files);
  if (size > mostBytes) {
    app.phase = 'empty';
    return app.say(
      `These files have ${megabytes(size)}; this page takes up to ${megabytes(mostBytes)}. ` +
        'The command line has no such limit: hgp param.',
      'error',
    );
  }
  const { missing, refused } = await findMissing(app.files, main);
  if (refused.length > 0) {
    app.say(
      `This file asks for “${refused[0]}”, which is outside the dropped folder. Not loaded.`,
      'error',
    );
  }
  app.missing = missing;
  if (missing.length > 0) {
    app.phase = 'needs-files';
    return app.changed();
  }
  await load(app);
}

/** Files that were missing, from a second drop or a Browse button. */
export async function supply(app: App, files: Files): Promise<void> {
  for (const [name, file] of files) app.files.set(name, file);
  await openMain(app, app.main);
}

/** Goes on without images; geometry cannot be left out. */
export async function loadWithoutImages(app: App): Promise<void> {
  app.missing = [];
  await load(app);
}

export async function load(app: App, surface?: number): Promise<void> {
  app.running?.abort();
  const own = (app.running = new AbortController());
  app.phase = 'loading';
  const title = `Reading ${app.main}`;
  const detail = megabytes(bytesOfAll(app.files));
  app.progress = { title, stage: 'read', detail, fraction: 0, begin: performance.now() };
  app.changed();
  try {
    const source = { main: app.main, files: app.files };
    const call = { signal: own.signal, onProgress: follow(app, own) };
    const { weld, fix } = app.settings;
    const info = await app.client!.load(source, { name: app.main, surface, weld, fix }, call);
    if (info.triangles > mostTriangles) throw new Error(tooMany(app.main, info.triangles));
    const arrays = await app.client!.surface(call);
    if (own !== app.running) return;
    app.info = info;
    app.surface = makeSurface(arrays);
    const generators = 2 * (info.genus ?? 0);
    const start = emptyPrescription(app.asked.q, info.boundaryLoops ?? 0, generators);
    app.history = new History(start);
    app.results = [];
    app.selected = -1;
    app.phase = !info.usable
      ? 'invalid'
      : info.surfaces.length > 1 && surface === undefined
        ? 'pick-mesh'
        : 'editing';
    app.message = info.usable ? undefined : { kind: 'error', text: inWords(info.error?.message) };
    if (info.usable) await findCones(app);
  } catch (error) {
    if (own !== app.running) return;
    app.phase = 'empty';
    if (isAbort(error)) app.say('Cancelled.');
    else app.say(explain(error, app.main), 'error');
  } finally {
    if (own === app.running) {
      app.progress = undefined;
      app.running = undefined;
      app.changed();
    }
  }
}

/** The page has buttons where the command line has options. */
const inWords = (message = 'This mesh cannot be used as it is.'): string =>
  message.replace(/Repair with --fix.*$/, 'Repairs are offered beside each defect.');

/** Cones stored in the file, or offered from an earlier session. */
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
      app.history = new History(found);
      app.message = { kind: 'note', text: `${found.cones.length} cones came with the file.` };
      return;
    }
  }
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

/** One click: the example with its cones. */
export async function openExample(
  app: App,
  example: { file: string; q: number; cones: { vertex: number; k: number }[] | null },
): Promise<void> {
  const response = await fetch(`./examples/${example.file}`);
  if (!response.ok) return app.say(`The example could not be read (${response.status}).`, 'error');
  const bytes = new Uint8Array(await response.arrayBuffer());
  app.forgetModel();
  app.history = new History(emptyPrescription(example.q, 0, 0));
  app.files = new Map([[example.file, bytes]]);
  await openMain(app, example.file);
  if (!app.surface || !example.cones) return;
  app.isExplicit = true;
  app.message = undefined;
  app.history = new History({ ...app.asked, q: example.q, cones: example.cones });
  app.changed();
}

export function explain(error: unknown, name: string): string {
  const { message } = error as Error;
  if (!(error instanceof HgpError)) return message;
  if (error.code === 'limit') {
    return `${message} Your cones are saved. The command line may use more memory: hgp param "${name}"`;
  }
  if (error.code === 'malformed') return `“${name}” cannot be read: ${message}`;
  return message;
}
