// From files to a surface on screen: which model, what is missing, which mesh, what is wrong with it.

import type { App } from './app';
import { coneFileOf, findMissing, meshesOf, unpack, bytesOf, type Files } from './files';
import { emptyPrescription } from './prescription';
import { importCones } from './edit';
import { save } from './autosave';
import { load, reopen } from './load';
import { bytesOfAll, megabytes } from './explain';
import { wake } from './solver';

const mostBytes = 512 * 2 ** 20;

/** New files: a model, a cone file for the model that is open, or what was missing. */
export async function open(app: App, dropped: Files): Promise<void> {
  if (dropped.size === 0) return;
  const own = ++app.openings;
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
  if (own !== app.openings) return;
  const meshes = meshesOf(files);
  if (app.phase === 'needs-files' && meshes.length === 0) return supply(app, files);
  app.forgetModel();
  app.files = files;
  if (meshes.length === 0) {
    app.phase = 'empty';
    const name = [...files.keys(), ...dropped.keys()][0];
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
  const own = ++app.openings;
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
  if (own !== app.openings) return;
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

/** Back to the beginning. What was made stays within reach: the cones by themselves, all by one click. */
export function close(app: App): void {
  const { files, main, asked, settings, info, isExplicit } = app;
  if (!info) return;
  app.openings += 1;
  if (asked.cones.length > 0) void save(info.file.sha256, asked);
  app.forgetModel();
  app.previous = undefined;
  app.client?.terminate(); // its memory never shrinks
  wake(app);
  app.files = new Map();
  app.main = '';
  app.phase = 'empty';
  const openAgain = (): void => {
    app.files = files;
    app.main = main;
    app.isExplicit = isExplicit;
    void reopen(app, info.surface, { asked, settings });
  };
  const kept = asked.cones.length > 0 ? ' Its cones are kept in this browser.' : '';
  app.say(`Closed ${main}.${kept}`, 'note', [{ label: 'Open it again', do: openAgain }]);
}

/** One click: the example with its cones. */
export async function openExample(
  app: App,
  example: { file: string; q: number; cones: { vertex: number; k: number }[] | null },
): Promise<void> {
  const own = ++app.openings;
  const response = await fetch(`./examples/${example.file}`);
  if (!response.ok) return app.say(`The example could not be read (${response.status}).`, 'error');
  const bytes = new Uint8Array(await response.arrayBuffer());
  if (own !== app.openings) return;
  app.forgetModel();
  app.begin(emptyPrescription(example.q, 0, 0));
  app.files = new Map([[example.file, bytes]]);
  await openMain(app, example.file);
  if (!app.surface || !example.cones || app.main !== example.file) return;
  app.isExplicit = true;
  app.message = undefined;
  app.begin({ ...app.asked, q: example.q, cones: example.cones });
  app.changed();
}
