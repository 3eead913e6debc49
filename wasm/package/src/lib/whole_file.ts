// Files of several meshes.

import type { Core } from './core.js';
import type { CoreMap } from './core_map.js';
import { checkOptions } from './check_options.js';
import type { Note, Report } from './documents.js';
import { HgpError, usage, valueOf, type HgpFailure } from './error.js';
import type { CombineOptions, CoreFiles, FileOptions } from './options.js';
import type { FileResult, MeshNote, MeshOutcome, Written } from './results.js';
import type { WrittenFile } from '../module.js';

const parsed = (notes: string): Note[] => JSON.parse(notes) as Note[];

/** The notes of each map with its mesh, then those on the file. */
const notesOf = ({ mapNotes, notes }: WrittenFile): MeshNote[] => [
  ...mapNotes.flatMap(({ mesh, notes: own }) => parsed(own).map((note) => ({ ...note, mesh }))),
  ...parsed(notes),
];

/**
 * Does what `hgp param` does with a file. A mesh without a certified map, or whose map is not aligned to the grid that was
 * asked for, is not changed, unless `keepGoing` or `write.allowUncertified` is set; without them, files are returned only
 * if all meshes are good.
 * @internal
 */
export function parametrizeFile(core: Core, source: CoreFiles, options: FileOptions): FileResult {
  const { weld, fix, strict, writeRepairs, limits, target, name: _ofSource, ...solve } = options;
  const model = core.load(source, { weld, fix, strict, writeRepairs, limits, target });
  try {
    const made = model.parametrizeFile(solve);
    const meshes = made.meshes.map(({ mesh, certified, aligned, report, error }): MeshOutcome => ({
      mesh,
      certified,
      aligned,
      ...(report === undefined ? {} : { report: JSON.parse(report) as Report }),
      ...(error === undefined ? {} : { error: JSON.parse(error) as HgpFailure }),
    }));
    const certified = meshes.every((one) => one.certified);
    const { file } = made;
    if (!file) return { certified, meshes, notes: [], files: [] };
    const [{ name, bytes }] = file.files;
    return { certified, meshes, notes: notesOf(file), files: file.files, name, bytes };
  } finally {
    model.free();
  }
}

/** @internal */
export const failureOf = ({ code, rule, details }: HgpError): HgpFailure => ({
  code,
  message: rule,
  ...details,
});

/**
 * A checked copy of the options for each of the maps.
 * @internal
 */
export function takeCombineOptions(
  count: number,
  options: CombineOptions | readonly CombineOptions[],
): CombineOptions[] {
  const isList = (value: typeof options): value is readonly CombineOptions[] =>
    Array.isArray(value);
  const each = isList(options) ? options : new Array<CombineOptions>(count).fill(options);
  if (each.length !== count)
    throw usage(`combine: there are ${count} maps, and options for ${each.length}`);
  for (const one of each) checkOptions('combine', one);
  return structuredClone([...each]);
}

/**
 * Writes maps of several meshes of one file into that file.
 * @internal
 */
export function combine(
  core: Core,
  maps: readonly CoreMap[],
  options: readonly CombineOptions[],
): Written {
  if (maps.length === 0) throw usage('combine: there are no maps');
  const [{ model: first }] = maps;
  if (maps.length === 1) {
    const made = maps[0].write(options[0]);
    const notes = made.notes.map((note) => ({ ...note, mesh: first.info.surface }));
    return { ...made, notes };
  }
  const meshes = maps.map(({ model }) => model.info.surface);
  if (maps.some(({ model }) => model.info.file.sha256 !== first.info.file.sha256))
    throw usage('combine: the maps are of meshes of different files');
  const twice = meshes.find((mesh, i) => meshes.indexOf(mesh) !== i);
  if (twice !== undefined) throw usage(`combine: two maps are of mesh ${twice}`);
  const name = options.findLast((one) => one.name !== undefined)?.name ?? first.defaultName;
  const whole = new core.module.FileMaps();
  try {
    maps.forEach((map, i) =>
      valueOf(whole.add(map.current(), JSON.stringify({ ...options[i], name }))),
    );
    const made = valueOf(whole.write(meshes));
    const { files, certified } = made;
    return { ...files[0], files, notes: notesOf(made), xref: new Int32Array(), certified };
  } finally {
    whole.delete();
  }
}
