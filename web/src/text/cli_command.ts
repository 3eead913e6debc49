// The equivalent command line.

import { isGltfModel } from '../formats/glb';
import type { FeatureChoice } from '../model/features';
import type { Prescription } from '../model/prescription';
import type { GridSettings, Model, Output } from '../model/types';

/** A word quoted for a POSIX shell, such that no file name is read as an option. */
export function quoted(word: string): string {
  const name = word.startsWith('-') ? `./${word}` : word;
  return /^[\w./:,=-]+$/.test(name) ? name : `'${name.replaceAll("'", "'\\''")}'`;
}

const maxInline = 40; // cones; more are passed in a file

function coneWords({ q, cones, turnings, handles }: Prescription, stem: string): string[] {
  const words = ['--q', String(q)];
  if (cones.length > maxInline) return [...words, '--cones', quoted(`${stem}.cones.json`)];
  for (const { vertex, k } of cones) words.push('--cone', `${vertex}:${k}`);
  turnings.forEach((l, loop) => l !== null && words.push('--turning', `${loop}:${l}`));
  handles.forEach((r, generator) => r !== null && words.push('--handle', `${generator}:${r}`));
  return words;
}

function meshWords({ info, loaded }: CommandModel): string[] {
  const words: string[] = [];
  if (info.surfaces.length > 1) words.push('--mesh', String(info.surface));
  if (loaded.weld !== undefined)
    words.push('--weld', loaded.weld === 0 ? 'exact' : String(loaded.weld));
  const fixes = Object.entries(loaded.fix).flatMap(([name, isOn]) => (isOn ? [name] : []));
  // Without these options the command line makes all repairs that are needed.
  if (loaded.hasAllRepairs) return words;
  return [...words, ...(fixes.length > 0 ? ['--fix', fixes.join(',')] : ['--strict'])];
}

/** The model, as far as the command depends on it. */
export type CommandModel = Pick<Model, 'main' | 'loaded'> & {
  info: Pick<Model['info'], 'surface' | 'surfaces' | 'components' | 'file'>;
};

/** What was, or will be, requested of the solver besides the prescription. */
export interface CommandOptions {
  /** Maximum number of programs. */
  rounds: number;
  improve?: number;
  scale: Output['scale'];
  /** Of a grid, if one is requested. */
  cells?: number | 'auto';
  gridMode: GridSettings['mode'];
  /** Whose directions are the frames. */
  field?: { name: string };
  /** Edges that lines follow; cones are then automatic, unless those that are placed are kept. */
  features?: FeatureChoice;
  /** In seconds. */
  timeLimit?: number;
}

/** What was, or will be, requested of the writer. */
export type CommandOutput = Omit<Output, 'scale' | 'hasGrid'> & {
  /** Tiles per unit of uv of a grid as the material. */
  gridTiles?: number;
  /** Whether the map is not certified, and is written all the same. */
  isUncertified: boolean;
};

function solveWords(options: CommandOptions): string[] {
  const { rounds, improve, scale, cells, gridMode, field, timeLimit } = options;
  const words = ['--rounds', String(rounds)]; // the command line has another default
  if (field) words.push('--field', quoted(field.name), '--frames', 'file');
  if (improve !== undefined) {
    const word = { [-1]: 'conformal', 0: 'isometric', 1: 'area' }[improve];
    words.push(`--improve=${word ?? improve}`);
  }
  if (scale !== 'solved') words.push('--scale', scale);
  if (cells !== undefined) words.push('--cells', String(cells), '--grid-mode', gridMode);
  if (timeLimit !== undefined) words.push('--time-limit', String(timeLimit));
  return words;
}

function featureWords({ hasRims, edges, isSymmetric }: FeatureChoice, stem: string): string[] {
  const list = edges.length > 0 ? ['--features', quoted(`${stem}.features.json`)] : [];
  return [...(hasRims ? ['--rims'] : []), ...list, ...(isSymmetric ? ['--symmetric=auto'] : [])];
}

function outputWords(output: CommandOutput): string[] {
  const { uvSet, usesNewSet, embedCones, gridTiles, isUncertified } = output;
  return [
    ...(uvSet === undefined ? [] : ['--uv-set', String(uvSet)]),
    ...(usesNewSet === undefined ? [] : [usesNewSet ? '--use' : '--use=false']),
    ...(embedCones ? ['--embed-cones'] : []),
    ...(gridTiles === undefined ? [] : [`--grid-material=${gridTiles}`]),
    ...(isUncertified ? ['--allow-uncertified'] : []),
  ];
}

/** The command that does exactly this run, and writes the same bytes. */
export function cliCommand(
  model: CommandModel,
  prescription: Prescription,
  options: CommandOptions,
  output: CommandOutput,
): string {
  const { main, info } = model;
  const stem = main.replace(/^.*\//, '').replace(/\.[^.]*$/, '');
  const { features } = options;
  const hasCones = !features || features.keepsCones;
  const ending = isGltfModel(model) ? `.${info.file.format}` : '.obj';
  return [
    ...['hgp', 'param', quoted(main)],
    ...(features ? featureWords(features, stem) : []),
    ...(hasCones ? coneWords(prescription, stem) : []),
    ...meshWords(model),
    ...solveWords(options),
    ...((info.components?.length ?? 1) > 1 ? ['--keep-going'] : []),
    ...outputWords(output),
    ...['--reproducible', '-o', quoted(`${stem}.mapped${ending}`)],
  ].join(' ');
}
