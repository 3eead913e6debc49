// Estimates of the time and memory of a run before it starts.

import type { ModelInfo } from 'hgp';
import { quoted } from './cli_command';
import { memoryText } from './format';

export const maxTriangles = 2_000_000;
const limit = 4 * 2 ** 30; // bytes: the maximum of WebAssembly's memory
const tight = 0.8;
// Measured with the solver in a browser: for the module itself, and per triangle.
const bytesAtRest = 24 * 2 ** 20;
const bytesEach = 4.5 * 1024;
const secondsEach = 1.2e-4;

export interface Estimate {
  needed: string;
  takes: string;
  /** Whether it is above 80 % of the limit. */
  isTight: boolean;
}

function timeText(seconds: number): string {
  if (seconds < 1) return 'under a second';
  if (seconds < 90) return `${Math.ceil(seconds)} s`;
  return `${Math.ceil(seconds / 60)} min`;
}

export function estimate(triangles: number, fileBytes = 0): Estimate {
  const bytes = bytesAtRest + 3 * fileBytes + bytesEach * triangles;
  return {
    needed: memoryText(bytes),
    takes: timeText(secondsEach * triangles),
    isTight: bytes > tight * limit,
  };
}

export const estimateFor = ({ triangles, file }: ModelInfo): Estimate =>
  estimate(triangles, file.bytes);

export function tooMany(name: string, triangles: number): string {
  const millions = (triangles / 1e6).toFixed(1);
  return (
    `${millions} million triangles would need about ${estimate(triangles).needed}; a page may use ` +
    `4 GB. The command line has no such limit: hgp param ${quoted(name)} -o mapped`
  );
}
