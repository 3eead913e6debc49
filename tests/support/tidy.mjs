// Runs clang-tidy on our sources, of the benchmarks only with --full: otherwise they are parsed, as no build of
// scripts/test compiles them. A unit whose text and headers have not changed since it last passed is not checked again.
// Modules are checked as the sanitizer build compiles them, as one unit each, and from scratch several units at a time:
// most of the time is spent on the headers of Eigen and the standard library, once per file.

import { exec, execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { promisify } from 'node:util';
import { treeFiles } from './results.mjs';

const root = process.cwd();
const cache = path.join(root, 'build/tidy');
mkdirSync(cache, { recursive: true });

/** Our own files on which an object depends, by object name, from ninja's record. */
function dependencies(build) {
  const text = execFileSync('ninja', ['-C', build, '-t', 'deps'], {
    encoding: 'utf8',
    maxBuffer: 1 << 30,
  });
  const found = new Map();
  for (const block of text.split('\n\n')) {
    const [head, ...lines] = block.split('\n');
    const files = lines
      .map((line) => path.resolve(build, line.trim()))
      .filter((file) => file.startsWith(root + path.sep) && !file.startsWith(build + path.sep));
    found.set(path.resolve(build, head.split(':')[0].replace(/^ninja.*/, '')), files);
  }
  return found;
}

let headers;
/** The files on which an object may depend that are not made by the build. */
function ownHeaders() {
  headers ??= treeFiles().filter((name) => /^(core|bench|examples)\/.*\.(h|cpp)$/.test(name));
  return headers;
}

// These checks follow every path through every function, or every expression, including those of other libraries, and
// take half of the time, so they run only with --full; the last one takes it in programs, which include CLI11 (15 of
// 23 seconds).
const dear = ['bugprone-use-after-move', 'performance-move-const-arg', 'bugprone-sizeof-container'];
const dearInPrograms = 'performance-unnecessary-value-param';
const isFull = process.env.HGP_FULL === '1';

/** The command that checks a file or the unit of a module. */
function checkOf(file, { command }, build) {
  // Parsing with warnings, by the compiler of the build.
  if (!isFull && /(^|\/)bench\//.test(file)) return command.replace(/ -o \S+/, ' -fsyntax-only');
  const without = leftOut(file).map((name) => `-${name}`);
  return `clang-tidy --quiet --checks=${without.join(',')} -p '${build}' '${path.resolve(file)}'`;
}

/** The checks that are left out for a file, or for the unit of a module. */
function leftOut(file) {
  // Only a unit includes sources.
  const outside = file.startsWith('build/') ? ['bugprone-suspicious-include'] : [];
  if (isFull) return outside;
  return [...outside, ...dear, ...(/(^|\/)core\/hgp\//.test(file) ? [] : [dearInPrograms])];
}

const settings = readFileSync('.clang-tidy');
const seen = new Set();
const units = [];

/** Collects the units of a build whose path, as source or as object, starts with one of the folders. */
function collect(preset, pattern) {
  const build = path.join(root, 'build', preset);
  const deps = dependencies(build);
  for (const entry of JSON.parse(readFileSync(path.join(build, 'compile_commands.json'), 'utf8'))) {
    const from = entry.file.startsWith(build + path.sep) ? build : root;
    const file = path.relative(root, entry.file);
    if (!pattern.test(path.relative(from, entry.file)) || seen.has(file)) continue;
    seen.add(file);
    const object = path.resolve(entry.directory, entry.command.match(/ -o (\S+)/)[1]);
    const command = checkOf(file, entry, build);
    const hash = createHash('sha256').update(settings).update(entry.command).update(command);
    for (const name of [entry.file, ...(deps.get(object) ?? ownHeaders())]) {
      if (existsSync(name)) hash.update(readFileSync(name));
    }
    const stamp = path.join(cache, hash.digest('hex'));
    const size = existsSync(entry.file)
      ? readFileSync(entry.file, 'utf8').split('\n#include').length
      : 0;
    const { directory: cwd, command: compile } = entry;
    if (!existsSync(stamp)) units.push({ file, stamp, size, command, cwd, compile });
  }
}
collect('native-debug', /^(core|examples\/cli)\//);
collect('native-release', /^(bench|examples)\/(?!cli\/)/);
// pybind11 takes as long as everything else.
if (isFull) collect('native-release', /^python\//);

// Modules that have no private name in common, the highest last. Where every module of a group has something to
// check, this is checked as one file.
const groups = [
  ['base', 'text', 'mesh', 'field', 'cut', 'linalg', 'socp', 'quads', 'parametrize', 'api'],
  ['prescription', 'io', 'verify', 'grid'],
  ['improve', 'optimize', 'system'],
];

/** The units of a module; kernels are for instructions that others do not have. */
const unitsOf = (module) =>
  units.filter(({ file }) => file.includes(`core/hgp/${module}/`) && !file.includes('/kernels/'));

/** One job for a group of modules; undefined if one of them has nothing to check. */
function together(modules) {
  const parts = modules.map(unitsOf);
  if (parts.some((part) => part.length === 0)) return undefined;
  const members = parts.flat();
  const file = path.join(cache, `${modules.at(-1)}.cxx`);
  writeFileSync(file, members.map((unit) => `#include "${path.resolve(unit.file)}"\n`).join(''));
  const { compile, cwd } = members.at(-1);
  const flags = compile.replace(/^\S+/, '').replace(/ -o \S+ -c \S+/, '');
  const without = leftOut(members[0].file).map((name) => `-${name}`);
  const command = `clang-tidy --quiet --checks=${without.join(',')} '${file}' -- ${flags}`;
  const size = members.reduce((sum, unit) => sum + unit.size, 0);
  return { members, size, command, cwd };
}

const grouped = groups.map(together).filter(Boolean);
const inGroups = new Set(grouped.flatMap(({ members }) => members));
const jobs = [...grouped, ...units.filter((unit) => !inGroups.has(unit))];
// The largest first, so that no large one remains at the end.
jobs.sort((a, b) => a.size - b.size);

let failures = 0;
async function worker() {
  for (let job = jobs.pop(); job !== undefined; job = jobs.pop()) {
    const { members = [job], command, cwd } = job;
    try {
      await promisify(exec)(command, { cwd, maxBuffer: 1 << 28 });
      for (const { stamp, file } of members) writeFileSync(stamp, file);
    } catch (error) {
      // What a group reports may be that its modules have a name in common.
      if (job.members) {
        console.log(`checked one by one: ${members.map(({ file }) => file).join(' ')}`);
        jobs.push(...members);
        continue;
      }
      failures += 1;
      console.log(`${error.stdout}${error.stderr}`.replaceAll(root + path.sep, ''));
    }
  }
}
console.log(`clang-tidy: ${seen.size} units, ${units.length} changed`);
await Promise.all([worker(), worker()]);
process.exitCode = failures > 0 ? 1 : 0;
