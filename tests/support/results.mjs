// Stores results of tests that depend only on their inputs, keyed by the content of all inputs: if nothing
// has changed since a test passed, it need not run again. Failed and skipped tests are
// not stored; tests that are random or measure time or memory do not use this.

import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, readdirSync, statSync, writeFileSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';

const sha256 = (content) => createHash('sha256').update(content).digest('hex');

const known = new Map();
/** A hash of the content of a file, or of a folder with everything in it but what Python compiles there. */
export function contentOf(name) {
  const stat = statSync(name);
  if (stat.isDirectory()) {
    const entries = readdirSync(name)
      .filter((entry) => entry !== '__pycache__')
      .sort();
    return sha256(
      entries.map((entry) => `${entry} ${contentOf(path.join(name, entry))}\n`).join(''),
    );
  }
  const version = [name, stat.size, stat.mtimeMs, stat.ctimeMs, stat.ino].join(' ');
  if (!known.has(version)) known.set(version, sha256(readFileSync(name)));
  return known.get(version);
}

/** Names, sizes and times of all files of a folder, which suffice for data that are not edited by hand. */
export function listingOf(folder) {
  if (!existsSync(folder)) return `${folder} is not there`;
  const entries = readdirSync(folder, { recursive: true }).sort();
  const line = (name) => {
    const { size, mtimeMs, mode } = statSync(path.join(folder, name));
    return `${name} ${size} ${mtimeMs} ${mode}\n`;
  };
  return sha256(entries.map(line).join(''));
}

/** The files that git tracks, and untracked files that it does not ignore. */
export function treeFiles() {
  const listed = execFileSync('git', ['ls-files', '-co', '--exclude-standard', '-z'], {
    encoding: 'utf8',
    maxBuffer: 1 << 28,
  });
  return listed.split('\0').filter((name) => name !== '' && existsSync(name));
}

/** A hash of the names and contents of those files of the checkout for which `isChosen` is true. */
export function treeContent(isChosen) {
  const files = treeFiles().filter(isChosen).sort();
  return sha256(files.map((name) => `${name} ${contentOf(name)}\n`).join(''));
}

const packages = '/var/lib/dpkg/status';

/**
 * The environment on which every result depends: the versions of all system packages (compilers, browser, shells)
 * and npm packages, the processor, and our environment variables. Null if there is no list of packages.
 */
function surroundings() {
  if (!existsSync(packages)) return null;
  const modules = 'node_modules/.installed-from';
  const variables = Object.entries(process.env).filter(([name]) => /^(HGP_|LC_|LANG)/.test(name));
  return JSON.stringify([
    contentOf(packages),
    existsSync(modules) ? contentOf(modules) : '',
    process.version,
    os.cpus()[0]?.model,
    process.getuid?.(),
    process.cwd(),
    variables.sort(),
  ]);
}

export class KeptResults {
  #folder;
  #surroundings = surroundings();
  #isRead;

  /** @param {{ isRead?: boolean }} options  without `isRead` everything runs again */
  constructor(folder, { isRead = true } = {}) {
    this.#folder = folder;
    this.#isRead = isRead;
    mkdirSync(folder, { recursive: true });
  }

  /** A key for all inputs; null if results cannot be stored. @param {...string} inputs */
  key(...inputs) {
    return this.#surroundings && sha256(JSON.stringify([this.#surroundings, inputs]));
  }

  /** The stored counts, all marked as unchanged; undefined if there are none. */
  find(key) {
    const file = key && path.join(this.#folder, key);
    if (!this.#isRead || !file || !existsSync(file)) return undefined;
    const { passed } = JSON.parse(readFileSync(file, 'utf8'));
    return { passed, failed: 0, skipped: 0, unchanged: passed, notes: [] };
  }

  /** Stores a result if all tests passed. The key is computed `again`: if inputs changed meanwhile, nothing is stored. */
  keep(key, again, name, { passed, failed, skipped }) {
    if (!key || key !== again || failed > 0 || skipped > 0 || passed === 0) return;
    writeFileSync(path.join(this.#folder, key), `${JSON.stringify({ name, passed })}\n`);
  }
}
