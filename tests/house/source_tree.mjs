// What the house tests look at: the text of our sources, module by module.

import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');

/** Paths below `folder` that git knows or would take, with one of the endings. */
export function filesOf(folder, ...endings) {
  const listed = execFileSync(
    'git',
    ['ls-files', '-co', '--exclude-standard', '--deduplicate', folder],
    { cwd: root, encoding: 'utf8', maxBuffer: 1 << 28 },
  );
  return listed
    .split('\n')
    .filter((file) => endings.some((ending) => file.endsWith(ending)))
    .filter((file) => existsSync(path.join(root, file)));
}

export const textOf = (file) => readFileSync(path.join(root, file), 'utf8');
export const exists = (file) => existsSync(path.join(root, file));

/** "core/hgp/cut/x.h" and "core/hgp/cut/folder/x.h" → "cut"; "core/hgp/x.h" → "hgp", the whole; else null. */
export function moduleOf(file) {
  const match = file.match(/^core\/hgp\/(?:([^/]+)\/)?/);
  return match ? (match[1] ?? 'hgp') : null;
}
