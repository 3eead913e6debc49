// Files of several meshes: each map is written into the result of the previous one.

import type { Core, CoreMap } from './core.js';
import { checkOptions } from './check_options.js';
import { HgpError, usage, type HgpFailure } from './error.js';
import type { CombineOptions, Cones, CoreFiles, FileOptions } from './options.js';
import type { FileResult, MeshNote, MeshOutcome, OutputFile, Written } from './results.js';

/** A file into which maps are written one after another. */
class Composition {
  /** The main file and its side files, in this order. */
  written: OutputFile[] = [];
  readonly notes: MeshNote[] = [];
  #source: CoreFiles;

  constructor(source: CoreFiles) {
    this.#source = source;
  }

  get source(): CoreFiles {
    return this.#source;
  }

  /** Side files written with earlier meshes are kept; the main file is the last one written. */
  add(mesh: number, made: Written): void {
    this.notes.push(...made.notes.map((note) => ({ ...note, mesh })));
    const others = this.written.slice(1);
    const isNew = ({ name }: OutputFile): boolean => made.files.every((file) => file.name !== name);
    this.written = [...made.files, ...others.filter(isNew)];
    const files = new Map(this.#source.files);
    for (const { name, bytes } of this.written) files.set(name, bytes);
    this.#source = { main: made.name, files };
  }
}

/** The cones stored in a mesh, unless another order is requested. */
const storedCones = (cones: Cones | null, q: number | undefined): Cones | undefined =>
  cones && (q === undefined || q === cones.q) ? cones : undefined;

/**
 * Does what `hgp param` does with a file of several meshes. A mesh without a certified map is not changed, unless
 * `keepGoing` or `write.allowUncertified` is set; without them, files are returned only if all meshes are certified.
 * @internal
 */
export function parametrizeFile(core: Core, source: CoreFiles, options: FileOptions): FileResult {
  const { weld, fix, strict, writeRepairs, limits, target, write = {}, ...rest } = options;
  const { name: _ofSource, ...solve } = rest;
  const load = { weld, fix, strict, writeRepairs, limits, target };
  const storesAll = solve.keepGoing === true || write.allowUncertified === true;
  const first = core.load(source, load);
  const count = first.info.surfaces.length;
  first.free();
  const { onProgress } = core;
  const whole = new Composition(source);
  const meshes: MeshOutcome[] = [];
  const takeOne = (mesh: number): void => {
    const model = core.load(whole.source, { ...load, surface: mesh });
    try {
      const isConvex = solve.boundary === 'convex';
      const cones = isConvex ? undefined : storedCones(model.embeddedCones(), solve.q);
      const map = model.parametrize({ ...solve, cones });
      const { certified } = map.certificate;
      try {
        if (certified || storesAll)
          whole.add(mesh, map.write({ ...write, allowUncertified: storesAll }));
        meshes.push({ mesh, certified, report: map.report });
      } finally {
        map.free();
      }
    } finally {
      model.free();
    }
  };
  try {
    for (let mesh = 0; mesh < count; mesh++) {
      core.onProgress =
        onProgress && ((progress) => onProgress({ ...progress, mesh, meshes: count }));
      try {
        takeOne(mesh);
      } catch (error) {
        if (!(error instanceof HgpError) || error.code === 'cancelled') throw error;
        meshes.push({ mesh, certified: false, error: failureOf(error) });
      }
    }
  } finally {
    core.onProgress = onProgress;
  }
  const certified = meshes.every((one) => one.certified);
  const { written, notes } = whole;
  if (written.length === 0 || !(certified || storesAll))
    return { certified, meshes, notes: [], files: [] };
  const [{ name, bytes }] = written;
  return { certified, meshes, notes, files: written, name, bytes };
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
  source: CoreFiles,
  maps: readonly CoreMap[],
  options: readonly CombineOptions[],
): Written {
  if (maps.length === 0) throw usage('combine: there are no maps');
  const [{ model: first }] = maps;
  const whole = new Composition(source);
  let certified = true;
  let xref: Int32Array = new Int32Array();
  const seen = new Set<number>();
  for (const [i, map] of maps.entries()) {
    const { info, options: loadedWith } = map.model;
    if (info.file.sha256 !== first.info.file.sha256)
      throw usage('combine: the maps are of meshes of different files');
    if (seen.has(info.surface)) throw usage(`combine: two maps are of mesh ${info.surface}`);
    seen.add(info.surface);
    const model = core.load(whole.source, { ...loadedWith, surface: info.surface });
    try {
      const made = map.writeFrom(model, options[i]);
      certified &&= made.certified;
      ({ xref } = made);
      whole.add(info.surface, made);
    } finally {
      model.free();
    }
  }
  const { written: files, notes } = whole;
  const [{ name, bytes }] = files;
  return {
    name,
    bytes,
    files,
    notes,
    xref: maps.length === 1 ? xref : new Int32Array(),
    certified,
  };
}
