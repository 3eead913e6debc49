// Failures and sizes in words a person can act on: the rule, the number, what next.

import { HgpError } from 'hgp';
import type { Files } from './files';

export const bytesOfAll = (files: Files): number =>
  [...files.values()].reduce(
    (sum, file) => sum + (file instanceof Uint8Array ? file.length : file.size),
    0,
  );

export const megabytes = (bytes: number): string =>
  `${(bytes / 2 ** 20).toFixed(bytes < 2 ** 20 ? 2 : 0)} MB`;

export function explain(error: unknown, name: string): string {
  const { message } = error as Error;
  if (!(error instanceof HgpError)) return message;
  if (error.code === 'limit') {
    return `${message} Your cones are saved. The command line may use more memory: hgp param "${name}"`;
  }
  if (error.code === 'malformed') return `“${name}” cannot be read: ${message}`;
  return message;
}

/** The page has buttons where the command line has options. */
export const inButtons = (message = 'This mesh cannot be used as it is.'): string =>
  message.replace(/Repair with --fix.*$/, 'Repairs are offered beside each defect.');
