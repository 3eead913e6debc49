// Results of tests whose outcome is a function of their inputs, kept by the content of all of these:
// where nothing has changed since a test passed, it need not run again. What fails or was skipped is
// never kept; what measures time or memory, or draws at random, is never asked for here.

import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, readdirSync, statSync, writeFileSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';

const sha256 = (content) => createHash('sha256').update(content).digest('hex');

const known = new Map();
/** The content of a file, or of a folder with all that is in it, as one word. */
export function contentOf(name) {
  const stat = statSync(name);
  if (stat.isDirectory()) {
    const entries = readdirSync(name).sort();
    return sha256(
      entries.map((entry) => `${entry} ${contentOf(path.join(name, entry))}\n`).join(''),
    );
  }
  const version = [name, stat.size, stat.mtimeMs, stat.ctimeMs, stat.ino].join(' ');
  if (!known.has(version)) known.set(version, sha256(readFileSync(name)));
  return known.get(version);
}

/** Names, sizes and times of all files of a folder: enough for data that nobody edits by hand. */
export function listingOf(folder) {
  if (!existsSync(folder)) return `${folder} is not there`;
  const entries = readdirSync(folder, { recursive: true }).sort();
  const line = (name) => {
    const { size, mtimeMs, mode } = statSync(path.join(folder, name));
    return `${name} ${size} ${mtimeMs} ${mode}\n`;
  };
  return sha256(entries.map(line).join(''));
}

/** The files git knows or could know. */
export function treeFiles() {
  const listed = execFileSync('git', ['ls-files', '-co', '--exclude-standard', '-z'], {
    encoding: 'utf8',
    maxBuffer: 1 << 28,
  });
  return listed.split('\0').filter((name) => name !== '' && existsSync(name));
}

/** Those of the checkout's files that are `chosen`, by name and content. */
export function treeContent(isChosen) {
  const files = treeFiles().filter(isChosen).sort();
  return sha256(files.map((name) => `${name} ${contentOf(name)}\n`).join(''));
}

const packages = '/var/lib/dpkg/status';

/**
 * What every outcome depends on: the versions of all packages of the system (compilers, browser, shells)
 * and of Node's, processor, variables of ours. Null where no list of packages says so.
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

  /** @param {...string} inputs  all of them; null where nothing can be kept */
  key(...inputs) {
    return this.#surroundings && sha256(JSON.stringify([this.#surroundings, inputs]));
  }

  /** The counts that were kept, all of them marked as unchanged; undefined where there are none. */
  find(key) {
    const file = key && path.join(this.#folder, key);
    if (!this.#isRead || !file || !existsSync(file)) return undefined;
    const { passed } = JSON.parse(readFileSync(file, 'utf8'));
    return { passed, failed: 0, skipped: 0, unchanged: passed, notes: [] };
  }

  /** Keeps what has passed whole. The key is made again: what changed under way is not kept. */
  keep(key, again, name, { passed, failed, skipped }) {
    if (!key || key !== again || failed > 0 || skipped > 0 || passed === 0) return;
    writeFileSync(path.join(this.#folder, key), `${JSON.stringify({ name, passed })}\n`);
  }
}
