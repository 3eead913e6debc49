// The equivalent command line.

import type { Prescription } from '../model/prescription';
import type { Model, SolveSettings } from '../model/types';

/** A word quoted for a POSIX shell, such that no file name is read as an option. */
export function quoted(word: string): string {
  const name = word.startsWith('-') ? `./${word}` : word;
  return /^[\w./:,=-]+$/.test(name) ? name : `'${name.replaceAll("'", "'\\''")}'`;
}

const mostInline = 40; // cones; more are passed in a file

function coneWords({ q, cones, turnings, handles }: Prescription, stem: string): string[] {
  const words = ['--q', String(q)];
  if (cones.length > mostInline) return [...words, '--cones', quoted(`${stem}.cones.json`)];
  for (const { vertex, k } of cones) words.push('--cone', `${vertex}:${k}`);
  turnings.forEach((l, loop) => l !== null && words.push('--turning', `${loop}:${l}`));
  handles.forEach((r, generator) => r !== null && words.push('--handle', `${generator}:${r}`));
  return words;
}

function meshWords({ info, loaded }: Model): string[] {
  const words: string[] = [];
  if (info.surfaces.length > 1) words.push('--mesh', String(info.surface));
  if (loaded.weld !== undefined) words.push('--weld', String(loaded.weld));
  const fixes = Object.entries(loaded.fix).flatMap(([name, isOn]) => (isOn ? [name] : []));
  // Without the option the command line makes all repairs that are needed.
  if (!loaded.hasAllRepairs && fixes.length > 0) words.push('--fix', fixes.join(','));
  return words;
}

function solveWords(
  solve: SolveSettings,
  field: { name: string } | undefined,
  cells: number | undefined,
): string[] {
  const words: string[] = [];
  if (field && solve.frames === 'file')
    words.push('--field', quoted(field.name), '--frames', 'file');
  if (solve.rounds !== 12) words.push('--rounds', String(solve.rounds));
  if (solve.improve !== undefined) {
    const word = { [-1]: 'conformal', 0: 'isometric', 1: 'area' }[solve.improve];
    words.push(`--improve=${word ?? solve.improve}`);
  }
  if (cells !== undefined) {
    words.push('--cells', String(cells));
    if (solve.grid.mode === 'quad') words.push('--grid-mode', 'quad');
  }
  if (solve.timeLimit !== undefined) words.push('--time-limit', String(solve.timeLimit));
  return words;
}

/** The command for exactly this run. `cells`: of a grid, if one is requested. */
export function cliCommand(
  model: Model,
  prescription: Prescription,
  solve: SolveSettings,
  field: { name: string } | undefined,
  cells?: number,
): string {
  const { main } = model;
  const stem = main.replace(/^.*\//, '').replace(/\.[^.]*$/, '');
  const ending = /\.(glb|gltf)$/i.exec(main)?.[0] ?? '.obj';
  return [
    ...['hgp', 'param', quoted(main)],
    ...coneWords(prescription, stem),
    ...meshWords(model),
    ...solveWords(solve, field, cells),
    ...['--embed-cones', '-o', quoted(`${stem}.mapped${ending}`)],
  ].join(' ');
}
