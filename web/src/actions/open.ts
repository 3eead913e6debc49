// Opens files: finds the main file, asks for missing files and for the mesh, and reports problems.

import { examples, type Example } from 'virtual:examples';
import { coneFileOf, findMissing, meshesOf, unpack } from '../formats/file_set';
import { bytesOf } from '../formats/glb';
import { emptyPrescription } from '../model/prescription';
import type { Files } from '../model/types';
import { saveCones } from '../services/cone_storage';
import { ensureWorker } from '../services/solver';
import { bytesOfAll, megabytes } from '../text/format';
import { solverOf, started, type App } from './app';
import { importCones } from './edit_cones';
import { freeUnused } from './free_unused';
import { loadMesh, reopen } from './load';
import { refreshRecent, remember } from './recent';

const maxBytes = 512 * 2 ** 20;

const kinds = 'The page reads GLB, glTF, OBJ, PLY, STL and OFF.';

/** Opens new files: a model, a cone file for the open model, or files that were missing. */
export async function open(app: App, dropped: Files): Promise<void> {
  const { doc } = app;
  // Of a text, or of a folder without files.
  if (dropped.size === 0) return doc.say(`There is no file in what was dropped. ${kinds}`, 'error');
  const own = ++doc.openRequestId;
  if (doc.state.kind === 'starting') {
    doc.say(`The solver is still starting; ${[...dropped.keys()][0]} is opened then.`);
    await started(app);
    if (own !== doc.openRequestId || !app.client) return;
  }
  const coneFile = doc.model ? coneFileOf(dropped) : undefined;
  if (coneFile) {
    const text = new TextDecoder().decode(await bytesOf(dropped.get(coneFile)!));
    if (own !== doc.openRequestId) return;
    return importCones(app, coneFile, text);
  }
  const files = await unpack(dropped);
  if (own !== doc.openRequestId) return;
  const meshes = meshesOf(files);
  if (doc.state.kind === 'needs-files' && meshes.length === 0) return supply(app, files);
  doc.clearModel();
  if (meshes.length === 0) {
    doc.previous = undefined;
    freeUnused(app);
    const name = [...files.keys(), ...dropped.keys()][0];
    return doc.say(`“${name}” holds no mesh. ${kinds}`, 'error');
  }
  if (meshes.length > 1) doc.state = { kind: 'pick-model', files, candidates: meshes };
  else await openMain(app, files, meshes[0]);
}

export async function openMain(app: App, files: Files, main: string): Promise<void> {
  const { doc } = app;
  const own = ++doc.openRequestId;
  doc.state = { kind: 'empty' };
  if (doc.previous && doc.previous.model.main !== main) doc.previous = undefined;
  freeUnused(app);
  const size = bytesOfAll(files);
  if (size > maxBytes) {
    return doc.say(
      `These files have ${megabytes(size)}; this page takes up to ${megabytes(maxBytes)}. ` +
        'The command line has no such limit: hgp param.',
      'error',
    );
  }
  const { missing, refused } = await findMissing(files, main);
  if (own !== doc.openRequestId) return;
  if (refused.length > 0) {
    const outside = `This file refers to “${refused[0]}”, which is outside the dropped folder.`;
    doc.say(`${outside} Not loaded.`, 'error');
  }
  if (missing.length > 0) doc.state = { kind: 'needs-files', files, main, missing };
  else {
    await loadMesh(app, { main, files });
    const isExample = examples.some(({ file }) => file === main);
    if (own === doc.openRequestId && !isExample) void remember(app, files);
  }
}

/** Adds files that were missing, from a second drop or a Browse button. */
export async function supply(app: App, more: Files): Promise<void> {
  const { state } = app.doc;
  if (state.kind !== 'needs-files') return;
  await openMain(app, new Map([...state.files, ...more]), state.main);
}

/** Continues without the missing images; buffers cannot be left out. */
export async function loadWithoutImages(app: App): Promise<void> {
  const { state } = app.doc;
  if (state.kind !== 'needs-files') return;
  app.doc.state = { kind: 'empty' };
  await loadMesh(app, state);
}

/** Cancels the question about missing files and returns to the start page. */
export function giveUp({ doc }: App): void {
  if (doc.state.kind === 'needs-files' || doc.state.kind === 'pick-model') {
    doc.state = { kind: 'empty' };
  }
}

/** Closes the model. Cones are stored for the next time, and one click restores everything. */
export function close(app: App): void {
  const { doc } = app;
  const { model, prescription, settings, hasUserCones } = doc;
  if (!model) return;
  doc.openRequestId += 1;
  if (prescription.cones.length > 0) void saveCones(model.info, prescription);
  doc.clearModel();
  doc.previous = undefined;
  void refreshRecent(app);
  const client = solverOf(app);
  client.terminate(); // because WebAssembly memory never shrinks
  ensureWorker(client);
  const openAgain = (): Promise<void> => {
    doc.hasUserCones = hasUserCones;
    return reopen(app, model, model.info.surface, { prescription, settings });
  };
  const kept = prescription.cones.length > 0 ? ' Its cones are kept in this browser.' : '';
  const again = { label: 'Open it again', run: openAgain };
  doc.say(`Closed ${model.main}.${kept}`, 'note', [again]);
}

async function fetchExample(file: string): Promise<Uint8Array> {
  const failure = (why: string): Error =>
    new Error(
      `The example could not be read (${why}). It needs the network once; your own files never do.`,
    );
  let response: Response;
  try {
    response = await fetch(`./examples/${file}`);
  } catch (error) {
    throw failure((error as Error).message);
  }
  if (!response.ok) throw failure(String(response.status));
  return new Uint8Array(await response.arrayBuffer());
}

/** Opens an example with its cones. */
export async function openExample(app: App, example: Example): Promise<void> {
  const { doc } = app;
  const own = ++doc.openRequestId;
  const bytes = await fetchExample(example.file);
  if (own !== doc.openRequestId) return;
  doc.clearModel();
  freeUnused(app);
  doc.begin(emptyPrescription(example.q, 0, 0));
  await openMain(app, new Map([[example.file, bytes]]), example.file);
  const { model } = doc;
  if (!model || !example.cones || model.main !== example.file) return;
  doc.hasUserCones = true;
  doc.message = undefined;
  doc.begin({ ...doc.prescription, q: example.q, cones: example.cones });
}

export const exampleById = (id: string | undefined): Example | undefined =>
  examples.find((one) => one.id === id);
