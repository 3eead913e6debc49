// What is saved, and how it leaves the page.

import {
  coneFile,
  makeDownload,
  type Download,
  type ExportSource,
  type Format,
} from '../formats/exports';
import { gridTilesPerUnit } from '../model/grid';
import type { App } from './app';
import { filesWithAllMaps, mappedMeshes } from './download_all';

/** Nothing where there is no map of what is prescribed. */
export function exportSource(app: App): ExportSource | undefined {
  const { model, current: solution, prescription, look } = app.doc;
  if (!model || !solution) return undefined;
  return { model, solution, prescription, tiles: gridTilesPerUnit(look, model.surface, solution) };
}

export function saveFile({ name, bytes, type }: Download): void {
  const url = URL.createObjectURL(new Blob([bytes as BlobPart], { type }));
  const link = document.createElement('a');
  link.href = url;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

export async function download(app: App, format: Format): Promise<void> {
  const source = exportSource(app);
  if (!source) return;
  if (format === 'same' && mappedMeshes(app).length > 1) {
    const files = await filesWithAllMaps(app);
    if (!files) return;
    const solution = { ...source.solution, files };
    saveFile(await makeDownload({ ...source, solution }, format));
  } else saveFile(await makeDownload(source, format));
  if (format !== 'report' && format !== 'cones') app.doc.isUnsaved = false;
}

export function exportCones({ doc }: App): void {
  if (doc.model) saveFile(coneFile({ model: doc.model, prescription: doc.prescription }));
}
