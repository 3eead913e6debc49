// What a run will take, before it is started: memory, time, and the command line that does the same.

import type { App } from './app';

export const mostTriangles = 2_000_000;
const limit = 4 * 2 ** 30; // bytes: what a page may use of WebAssembly's memory
const tight = 0.8;
// Measured with the solver in a browser: the module itself, and per triangle.
const bytesAtRest = 24 * 2 ** 20;
const bytesEach = 4.5 * 1024;
const secondsEach = 1.2e-4;

export interface Estimate {
  bytes: number;
  seconds: number;
  needed: string;
  takes: string;
  /** Over 80 % of what a browser gives. */
  isTight: boolean;
}

export const memoryText = (bytes: number): string =>
  bytes < 2 ** 30
    ? `${Math.max(10, Math.round(bytes / 2 ** 20 / 10) * 10)} MB`
    : `${(bytes / 2 ** 30).toFixed(1)} GB`;

function timeText(seconds: number): string {
  if (seconds < 1) return 'under a second';
  if (seconds < 90) return `${Math.ceil(seconds)} s`;
  return `${Math.ceil(seconds / 60)} min`;
}

export function estimate(triangles: number, fileBytes = 0): Estimate {
  const bytes = bytesAtRest + 3 * fileBytes + bytesEach * triangles;
  const seconds = secondsEach * triangles;
  return {
    ...{ bytes, seconds, needed: memoryText(bytes), takes: timeText(seconds) },
    isTight: bytes > tight * limit,
  };
}

export const estimateOf = ({ info }: App): Estimate =>
  estimate(info?.triangles ?? 0, info?.file.bytes ?? 0);

export function tooMany(name: string, triangles: number): string {
  const millions = (triangles / 1e6).toFixed(1);
  return (
    `${millions} million triangles would need about ${estimate(triangles).needed}; a page may use ` +
    `4 GB. The command line has no such limit: hgp param ${quoted(name)} -o mapped`
  );
}

/** For a POSIX shell. */
export const quoted = (word: string): string =>
  /^[\w./:,=-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`;

const mostInline = 40; // cones; beyond, they go into a file

/** Exactly this run, on the command line. */
export function commandOf(app: App): string {
  const { main, info, asked, loaded, solve, field } = app;
  const stem = main.replace(/^.*\//, '').replace(/\.[^.]*$/, '');
  const ending = /\.(glb|gltf)$/i.exec(main)?.[0] ?? '.obj';
  const words = ['hgp', 'param', quoted(main)];
  const { q, cones, turnings, handles } = asked;
  words.push('--q', String(q));
  if (cones.length > mostInline) words.push('--cones', quoted(`${stem}.cones.json`));
  else {
    for (const { vertex, k } of cones) words.push('--cone', `${vertex}:${k}`);
    turnings.forEach((l, loop) => l !== null && words.push('--turning', `${loop}:${l}`));
    handles.forEach((r, generator) => r !== null && words.push('--handle', `${generator}:${r}`));
  }
  if ((info?.surfaces.length ?? 1) > 1) words.push('--mesh', String(info!.surface));
  if (loaded.weld !== undefined) words.push('--weld', String(loaded.weld));
  const fixes = Object.entries(loaded.fix).flatMap(([name, isOn]) => (isOn ? [name] : []));
  if (fixes.length > 0) words.push('--fix', fixes.join(','));
  if (field && solve.frames === 'file')
    words.push('--field', quoted(field.name), '--frames', 'file');
  if (solve.rounds !== 12) words.push('--rounds', String(solve.rounds));
  if (solve.quality) words.push('--quality');
  if (solve.timeLimit !== undefined) words.push('--time-limit', String(solve.timeLimit));
  words.push('--embed-cones', '-o', quoted(`${stem}.mapped${ending}`));
  return words.join(' ');
}

export async function copyCommand(app: App): Promise<void> {
  const command = commandOf(app);
  const isFile = command.includes('--cones ');
  const also = isFile ? ' It reads the cones from the file that Export saves.' : '';
  try {
    await navigator.clipboard.writeText(command);
    app.say(`Copied: the command that does this run.${also}`, 'good');
  } catch {
    app.say(`The browser does not let this page copy. The command: ${command}`);
  }
}
