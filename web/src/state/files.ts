// From what was dropped or chosen to one set of files with relative names, its candidates for the
// main file, and what is still missing. Nothing is ever fetched.

import { unzip } from './zip';

export type Files = Map<string, Blob | Uint8Array>;

export interface Missing {
  name: string;
  /** Geometry cannot be read without it; images can be left out. */
  isNeeded: boolean;
}

const meshEnding = /\.(glb|gltf|obj|off|ply|stl)$/i;
const imageEnding = /\.(png|jpe?g|webp|ktx2)$/i;
const coneEnding = /\.(sing|sings|curvatures|th_hat|rawfield|rosy|ffield)$|cones?\.json$/i;

/** Other files of cones have matchings at most. */
export const hasDirections = (name: string): boolean => /\.(rawfield|rosy|ffield)$/i.test(name);

async function readFolder(entry: FileSystemDirectoryEntry, into: Files): Promise<void> {
  const reader = entry.createReader();
  for (;;) {
    // A call returns a hundred entries at most: ask until there are none.
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

/** Must be called inside the event: the browser empties the list afterwards. */
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

/** ZIPs unpacked, the folder that everything is in taken away. */
export async function unpack(files: Files): Promise<Files> {
  const all: Files = new Map();
  for (const [name, file] of files) {
    if (/\.zip$/i.test(name) && file instanceof Blob) {
      for (const [inner, bytes] of await unzip(file)) all.set(inner, bytes);
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

/** An existing model and a cone file: an import, not a new model. */
export const coneFileOf = (files: Files): string | undefined =>
  files.size === 1 ? [...files.keys()].find((name) => coneEnding.test(name)) : undefined;

export async function bytesOf(file: Blob | Uint8Array): Promise<Uint8Array> {
  return file instanceof Uint8Array ? file : new Uint8Array(await file.arrayBuffer());
}

function jsonOfGlb(bytes: Uint8Array): string {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const length = view.getUint32(12, true);
  return new TextDecoder().decode(bytes.subarray(20, 20 + length));
}

interface GltfLike {
  buffers?: { uri?: string }[];
  images?: { uri?: string }[];
  meshes?: { extras?: { hgp?: unknown } }[];
}

/** The JSON of a .glb or .gltf, or nothing when it is no such file (the solver says why). */
export async function readGltfJson(name: string, file: Blob | Uint8Array): Promise<GltfLike> {
  try {
    if (/\.glb$/i.test(name)) {
      const head = file instanceof Blob ? await bytesOf(file.slice(0, 64 * 2 ** 20)) : file;
      return JSON.parse(jsonOfGlb(head)) as GltfLike;
    }
    return JSON.parse(new TextDecoder().decode(await bytesOf(file))) as GltfLike;
  } catch {
    return {};
  }
}

export const isGltf = (name: string): boolean => /\.(glb|gltf)$/i.test(name);

/** Relative, inside the folder, decoded once; undefined for everything else. */
export function relativeName(uri: string): string | undefined {
  let name: string;
  try {
    name = decodeURIComponent(uri);
  } catch {
    return undefined;
  }
  if (/^[a-z][a-z0-9+.-]*:|^[/\\]|\\|\0/i.test(name)) return undefined;
  const parts = name.split('/').filter((part) => part !== '.');
  return parts.includes('..') ? undefined : parts.join('/');
}

const baseName = (name: string): string => name.slice(name.lastIndexOf('/') + 1);

/** Finds what the main file names; files dropped without their folders are matched by name. */
export async function findMissing(
  files: Files,
  main: string,
): Promise<{ missing: Missing[]; refused: string[] }> {
  if (!isGltf(main)) return { missing: [], refused: [] };
  const json = await readGltfJson(main, files.get(main)!);
  const missing = new Map<string, Missing>();
  const refused: string[] = [];
  const folder = main.includes('/') ? main.slice(0, main.lastIndexOf('/') + 1) : '';
  for (const [list, isNeeded] of [
    [json.buffers, true],
    [json.images, false],
  ] as const) {
    for (const { uri } of Array.isArray(list) ? list : []) {
      if (typeof uri !== 'string' || uri.startsWith('data:')) continue;
      const name = relativeName(uri);
      if (name === undefined) refused.push(uri);
      else if (!resolve(files, folder, name)) missing.set(name, { name, isNeeded });
    }
  }
  return { missing: [...missing.values()], refused };
}

/** Makes the set answer to `name` when it holds that file, perhaps in another folder. */
function resolve(files: Files, folder: string, name: string): boolean {
  if (files.has(name)) return true;
  const found =
    files.get(folder + name) ??
    [...files].find(([other]) => baseName(other) === baseName(name))?.[1];
  if (found) files.set(name, found);
  return found !== undefined;
}

/** What the main one of some files names and does not bring: buffers and images that were there before. */
export async function sideFiles(
  files: Files,
  written: { name: string; bytes: Uint8Array }[],
): Promise<{ name: string; bytes: Uint8Array }[]> {
  const [main] = written;
  if (!/\.gltf$/i.test(main.name)) return [];
  const { buffers = [], images = [] } = await readGltfJson(main.name, main.bytes);
  const found = new Map<string, Uint8Array>();
  for (const { uri } of [...buffers, ...images]) {
    const name = uri === undefined || uri.startsWith('data:') ? undefined : relativeName(uri);
    if (name === undefined || written.some((file) => file.name === name)) continue;
    const file = files.get(name);
    if (file) found.set(name, await bytesOf(file));
  }
  return [...found].map(([name, bytes]) => ({ name, bytes }));
}

/** Cones stored in the file by an earlier run. */
export async function embeddedCones(
  files: Files,
  main: string,
  surface: number,
): Promise<string | undefined> {
  if (isGltf(main)) {
    const json = await readGltfJson(main, files.get(main)!);
    const cones = json.meshes?.[surface]?.extras?.hgp;
    return cones ? JSON.stringify(cones) : undefined;
  }
  if (!/\.obj$/i.test(main)) return undefined;
  const text = new TextDecoder().decode(await bytesOf(files.get(main)!));
  return /^# ?hgp-cones|^c \d+ [\d.]/m.test(text) ? text : undefined;
}

export const imagesOf = (files: Files): string[] =>
  [...files.keys()].filter((name) => imageEnding.test(name));

/** Safe as the name of a download. */
export function safeName(name: string): string {
  const safe = baseName(name)
    .replace(/[^\w.-]+/g, '_')
    .replace(/^\.+/, '');
  return safe.slice(-80) || 'model';
}
