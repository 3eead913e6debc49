// Formatting, lint and types; files that passed a tool and have not changed are not checked again.

import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { checks, must } from './commands.mjs';
import { treeFiles } from './results.mjs';

const folder = 'build/lint';
const bin = (name) => `node_modules/.bin/${name}`;

/** Runs clang-format on the files that have changed since they passed with the same version and style. */
async function clangFormat(log) {
  const version = await must(log, 'clang-format', '--version');
  const style = readFileSync('.clang-format');
  const files = treeFiles().filter((name) => /\.(cpp|h)$/.test(name));
  const record = path.join(folder, 'clang-format.json');
  const seen = new Set(existsSync(record) ? JSON.parse(readFileSync(record, 'utf8')) : []);
  const hashes = new Map(
    files.map((name) => {
      const hash = createHash('sha256').update(version).update(style).update(readFileSync(name));
      return [name, hash.digest('hex')];
    }),
  );
  const changed = files.filter((name) => !seen.has(hashes.get(name)));
  log.write(`clang-format: ${files.length} files, ${changed.length} changed\n`);
  const counts =
    changed.length > 0
      ? await checks(log, [['clang-format', '--dry-run', '-Werror', ...changed]])
      : { passed: 1, failed: 0, skipped: 0, notes: [] };
  if (counts.failed === 0) writeFileSync(record, JSON.stringify([...hashes.values()]));
  return counts;
}

/** @param {{ isAgain: boolean }} options  `isAgain`: checks all files again */
export async function lint(log, { isAgain }) {
  if (isAgain) rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  const cached = (name) => [
    ...['--cache', '--cache-strategy', 'content'],
    ...['--cache-location', path.join(folder, name)],
  ];
  const types = (project) => [
    ...[bin('tsc'), '--noEmit', '-p', project, '--incremental'],
    ...['--tsBuildInfoFile', path.join(folder, `${project}.tsbuildinfo`)],
  ];
  const format = await clangFormat(log);
  const others = await checks(log, [
    [bin('prettier'), '--check', '.', ...cached('prettier')],
    [bin('eslint'), '.', ...cached('eslint')],
    types('web'),
    types('wasm'),
  ]);
  return {
    ...others,
    passed: format.passed + others.passed,
    failed: format.failed + others.failed,
    notes: [...format.notes, ...others.notes],
  };
}
