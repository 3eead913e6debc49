// Converts dropped or chosen files to one set with relative names; finds the candidates for the main file and the
// files that are missing. Nothing is fetched.

import type { Files, Missing } from '../model/types';
import { gltfOf, objectsIn, relativeName } from './glb';
import { gunzip } from './gzip';
import { unzip } from './zip';

const meshEnding = /\.(glb|gltf|obj|off|ply|stl)$/i;
const coneEnding = /\.(sing|sings|curvatures|th_hat|rawfield|rosy|ffield)$|cones?\.json$/i;

/** Whether a cone file has directions; files in other formats have at most matchings. */
export const hasDirections = (name: string): boolean => /\.(rawfield|rosy|ffield)$/i.test(name);

async function readFolder(entry: FileSystemDirectoryEntry, into: Files): Promise<void> {
  const reader = entry.createReader();
  for (;;) {
    // A call returns at most a hundred entries; it is repeated until there are none.
    const batch = await new Promise<FileSystemEntry[]>((resolve, reject) =>
      reader.readEntries(resolve, reject),
    );
    if (batch.length === 0) return;
    for (const child of batch) await readEntry(child, into);
  }
}

async function readEntry(entry: FileSystemEntry, into: Files): Promise<void> {
  if (entry.isDirectory) return readFolder(entry as FileSystemDirectoryEntry, into);
  const file = await new Promise<File>((resolve, reject) =>
    (entry as FileSystemFileEntry).file(resolve, reject),
  );
  into.set(entry.fullPath.replace(/^\//, ''), file);
}

/** Must be called during the event, because the browser empties the list afterwards. */
export function filesOfDrop(transfer: DataTransfer): Promise<Files> {
  const files: Files = new Map();
  const entries = [...transfer.items].map((item) => item.webkitGetAsEntry?.() ?? null);
  const plain = [...transfer.files];
  return (async () => {
    if (entries.some((entry) => entry?.isDirectory)) {
      for (const entry of entries) if (entry) await readEntry(entry, files);
    } else {
      for (const file of plain) files.set(file.name, file);
    }
    return files;
  })();
}

export function filesOfInput(list: Iterable<File>): Files {
  return new Map([...list].map((file) => [file.webkitRelativePath || file.name, file]));
}

/** Unpacks ZIP and gzip files, and removes a folder that contains everything from the names. */
export async function unpack(files: Files): Promise<Files> {
  const all: Files = new Map();
  for (const [name, file] of files) {
    if (/\.zip$/i.test(name) && file instanceof Blob) {
      for (const [inner, bytes] of await unzip(file)) all.set(inner, bytes);
    } else if (/\.gz$/i.test(name) && file instanceof Blob) {
      all.set(name.slice(0, -3), await gunzip(file));
    } else all.set(name, file);
  }
  const names = [...all.keys()].filter((name) => !/(^|\/)(\.|__MACOSX)/.test(name));
  const folder = names[0]?.includes('/') ? `${names[0].split('/')[0]}/` : '';
  const isCommon = folder !== '' && names.every((name) => name.startsWith(folder));
  return new Map(
    names.map((name) => [isCommon ? name.slice(folder.length) : name, all.get(name)!]),
  );
}

export const meshesOf = (files: Files): string[] =>
  [...files.keys()].filter((name) => meshEnding.test(name));

/** The cone file, if it is the only file: it is then imported into the open model. */
export const coneFileOf = (files: Files): string | undefined =>
  files.size === 1 ? [...files.keys()].find((name) => coneEnding.test(name)) : undefined;

const baseName = (name: string): string => name.slice(name.lastIndexOf('/') + 1);

/** The relative URIs of buffers and images, and whether geometry needs them. */
export async function urisIn(
  files: Files,
  main: string,
): Promise<[uri: string, isNeeded: boolean][]> {
  const { buffers, images } = await gltfOf(files, main);
  const named = (list: unknown, isNeeded: boolean): [string, boolean][] =>
    objectsIn(list).flatMap(({ uri }) =>
      typeof uri !== 'string' || uri.startsWith('data:') ? [] : [[uri, isNeeded]],
    );
  return [...named(buffers, true), ...named(images, false)];
}

/** Finds the files to which the main file refers; files dropped without their folders are matched by name. */
export async function findMissing(
  files: Files,
  main: string,
): Promise<{ missing: Missing[]; refused: string[] }> {
  const missing = new Map<string, Missing>();
  const refused: string[] = [];
  const folder = main.includes('/') ? main.slice(0, main.lastIndexOf('/') + 1) : '';
  for (const [uri, isNeeded] of await urisIn(files, main)) {
    const name = relativeName(uri);
    if (name === undefined) refused.push(uri);
    else if (!resolve(files, folder, name)) missing.set(name, { name, isNeeded });
  }
  return { missing: [...missing.values()], refused };
}

/** Adds `name` to the set if it has this file, possibly in another folder. */
function resolve(files: Files, folder: string, name: string): boolean {
  if (files.has(name)) return true;
  const found =
    files.get(folder + name) ??
    [...files].find(([other]) => baseName(other) === baseName(name))?.[1];
  if (found) files.set(name, found);
  return found !== undefined;
}

/** The name of a file without folder and ending, safe for a download. */
export const nameStem = (name: string): string => safeName(name).replace(/\.[^.]*$/, '') || 'model';

/** A version of the name that is safe for a download. */
export function safeName(name: string): string {
  const safe = baseName(name)
    .replace(/[^\w.-]+/g, '_')
    .replace(/^\.+/, '');
  return safe.slice(-80) || 'model';
}
