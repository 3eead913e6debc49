// Numbers formatted for users.

import type { Files } from '../model/types';

export const bytesOfAll = (files: Files): number =>
  [...files.values()].reduce(
    (sum, file) => sum + (file instanceof Uint8Array ? file.length : file.size),
    0,
  );

export const megabytes = (bytes: number): string =>
  `${(bytes / 2 ** 20).toFixed(bytes < 2 ** 20 ? 2 : 0)} MB`;

export const memoryText = (bytes: number): string =>
  bytes < 2 ** 30
    ? `${Math.max(10, Math.round(bytes / 2 ** 20 / 10) * 10)} MB`
    : `${(bytes / 2 ** 30).toFixed(1)} GB`;

const grouped = new Intl.NumberFormat('en');

/** "12 345", with a thin space. */
export const count = (n: number | undefined): string => grouped.format(n ?? 0).replaceAll(',', ' ');

/** "a, b and c". */
export const listed = (parts: readonly string[]): string =>
  [parts.slice(0, -1).join(', '), ...parts.slice(-1)].filter(Boolean).join(' and ');

export const plural = (n: number, one: string, many = `${one}s`): string =>
  `${count(n)} ${n === 1 ? one : many}`;

/** Whether it is below ten when it is written with one decimal. */
const isBelowTen = (x: number): boolean => Number(x.toFixed(1)) < 10;

/** "4.8 %", "41 %" */
export const percentText = (x: number): string => `${x.toFixed(isBelowTen(x) ? 1 : 0)} %`;

/** "× 1.6", "× 24" */
export const timesText = (x: number): string =>
  `× ${isBelowTen(x) ? x.toFixed(1) : count(Math.round(x))}`;

export const signed = (x: number): string => (x < 0 ? `−${(-x).toFixed(2)}` : x.toFixed(2));

/** "−12", "0": an angle in whole degrees. */
export const wholeDegrees = (x: number): string =>
  x.toFixed(0).replace(/^-0$/, '0').replace('-', '−');
