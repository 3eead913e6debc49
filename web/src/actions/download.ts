// Writes the files of Download and saves them.

import {
  coneFile,
  nameOf,
  packed,
  reportFile,
  writeOptionsFor,
  type Download,
  type ExportSource,
  type Format,
  type SolverFormat,
} from '../formats/exports';
import { gridTilesPerUnit } from '../model/grid';
import type { OutputFile } from '../model/types';
import { isCertified } from '../model/verdict';
import { describeError } from '../text/error_messages';
import type { App } from './app';
import { filesWithAllMaps, mappedMeshes } from './download_all';
import { runJob, stageStart } from './job';
import { mapInSolver } from './solve';

/** Undefined if there is no map of the current prescription. */
export function exportSource(app: App): ExportSource | undefined {
  const { model, current: solution, prescription, look } = app.doc;
  if (!model || !solution) return undefined;
  return { model, solution, prescription, tiles: gridTilesPerUnit(look, model.surface, solution) };
}

const partBytes = 4 * 2 ** 20; // bytes copied per task

/** A blob made of blobs: making one from a hundred megabytes would copy them in one long task. */
async function blobOf(bytes: Uint8Array, type: string): Promise<Blob> {
  const parts: Blob[] = [];
  for (let at = 0; at < bytes.length; at += partBytes) {
    if (at > 0) await new Promise((resolve) => setTimeout(resolve));
    parts.push(new Blob([bytes.subarray(at, at + partBytes) as BlobPart]));
  }
  return new Blob(parts, { type });
}

export async function saveFile({ name, bytes, type }: Download): Promise<void> {
  saveBlob(await blobOf(bytes, type), name);
}

export function saveBlob(blob: Blob, name: string): void {
  const url = URL.createObjectURL(blob);
  const link = document.createElement('a');
  link.href = url;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

const zipper =
  ({ geometry }: App) =>
  async (files: OutputFile[]): Promise<Uint8Array> =>
    (await geometry.call('zip', [files])).zip;

/**
 * The map in another format, from the solver; undefined if that was cancelled, or failed, which is reported. A map
 * that the solver no longer has is computed again.
 */
export async function exportFiles(
  app: App,
  format: SolverFormat,
): Promise<OutputFile[] | undefined> {
  const map = await mapInSolver(app);
  if (!map) return undefined;
  const source = exportSource(app);
  if (!source) return undefined;
  const allowUncertified = !isCertified(source.solution);
  const options = { ...writeOptionsFor(source, format), allowUncertified };
  let files: OutputFile[] | undefined;
  const onFailure = (error: unknown): void =>
    app.doc.say(describeError(error, nameOf(source, format)), 'error');
  await runJob(app, { kind: 'run', title: 'Writing', onFailure }, async (call) => {
    call.onProgress(stageStart('write'));
    ({ files } = await map.write(options, call));
  });
  return files;
}

async function downloadOf(app: App, format: Format): Promise<Download | undefined> {
  const source = exportSource(app);
  if (!source) return undefined;
  if (format === 'cones') return coneFile(source);
  if (format === 'report') return reportFile(source);
  if (format !== 'same') {
    const files = await exportFiles(app, format);
    return files && packed(nameOf(source, format), files, zipper(app));
  }
  const { solution } = source;
  const files = mappedMeshes(app).length > 1 ? await filesWithAllMaps(app) : solution.files;
  if (!files) return undefined;
  return packed(
    nameOf({ ...source, solution: { ...solution, files } }, format),
    files,
    zipper(app),
  );
}

export async function download(app: App, format: Format): Promise<void> {
  const made = await downloadOf(app, format);
  if (!made) return;
  await saveFile(made);
  if (format !== 'report' && format !== 'cones') app.doc.isUnsaved = false;
}

export async function exportCones({ doc }: App): Promise<void> {
  if (doc.model) await saveFile(coneFile({ model: doc.model, prescription: doc.prescription }));
}
