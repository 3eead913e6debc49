// Plants faults of one line, one at a time, and sees whether the tests notice.
//
//   scripts/mutate [--short] [--preset native-debug] [WORD…]   only faults whose file has a WORD
//
// A fault costs one file: the changed source is compiled alone and linked before the libraries, whose
// own definitions of the same functions then give way (--allow-multiple-definition). So that this never
// counts a fault as caught by accident, each program is first linked in the same way with a source that
// is not changed, and must pass.

import { execFile } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { faults } from './faults.mjs';

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
const { values: options, positionals: words } = parseArgs({
  options: {
    short: { type: 'boolean', default: false },
    preset: { type: 'string', default: 'native-debug' },
  },
  allowPositionals: true,
});
const build = path.join(root, 'build', options.preset);
const wantedShare = 0.95;
const wantedCount = 40;
// Of the processor, as a busy machine says nothing about a test.
const testSeconds = 150;
if (!existsSync(path.join(build, 'compile_commands.json'))) {
  console.error(`mutate: build/${options.preset} is not there; build it first`);
  process.exit(2);
}

/** Runs a shell command; resolves to its exit code (null when it was stopped) and its output. */
function run(command, { cwd = build, seconds = 600 } = {}) {
  const env = { ...process.env, ASAN_OPTIONS: 'detect_odr_violation=0', HGP_MUTATION: '1' };
  const limits = { maxBuffer: 1 << 28 };
  return new Promise((resolve) =>
    execFile(
      'sh',
      ['-c', `ulimit -t ${seconds}; exec ${command}`],
      { cwd, env, ...limits },
      (error, stdout, stderr) =>
        resolve({ code: error ? error.code : 0, signal: error?.signal, output: stdout + stderr }),
    ),
  );
}

const compilations = JSON.parse(readFileSync(path.join(build, 'compile_commands.json'), 'utf8'));

/** How the build compiles `file`, alone or as part of its module's unit, with `from` in its place. */
function compileCommand(file, from, object) {
  const own = ({ file: name }) => path.relative(root, name) === file;
  const isUnit = ({ file: name }) =>
    name.endsWith('.cxx') && readFileSync(name, 'utf8').includes(`"${path.join(root, file)}"`);
  const entry = compilations.find(own) ?? compilations.find(isUnit);
  if (!entry) throw new Error(`${file} is not compiled by ${options.preset}`);
  const command = entry.command
    .replace(/ -o \S+/, ` -o ${object}`)
    .replace(/ -c \S+/, ` -w -c ${from}`)
    .replace(/ -O3\b/, ' -O1')
    .replace(/^\S*ccache /, '');
  return { command, cwd: entry.directory };
}

/** How the build links a test program, with one more object before its libraries. */
async function linkCommand(program, object, out) {
  const listed = await run(`ninja -t commands bin/tests_${program}`);
  const link = listed.output.trim().split('\n').at(-1);
  const body = link.match(/^: && (.*) && :$/)?.[1];
  if (listed.code !== 0 || !body) throw new Error(`no way to link tests_${program}: ${link}`);
  return body.replace(
    ` -o bin/tests_${program}`,
    ` ${object} -Wl,--allow-multiple-definition -o ${out}`,
  );
}

const scratch = path.join(root, 'build/mutation', options.preset);
rmSync(scratch, { recursive: true, force: true });
mkdirSync(scratch, { recursive: true });

/** @returns {Promise<'passed' | 'failed' | 'endless'>} what the program's tests say with this text */
async function outcome(file, text, program, id) {
  const folder = path.join(scratch, id);
  mkdirSync(folder, { recursive: true });
  const [source, object, out] = ['fault.cpp', 'fault.o', `tests_${program}`].map((name) =>
    path.join(folder, name),
  );
  if (!existsSync(object)) {
    writeFileSync(source, text);
    const { command, cwd } = compileCommand(file, source, object);
    const compiled = await run(command, { cwd });
    if (compiled.code !== 0)
      throw new Error(`does not compile:\n${compiled.output.slice(0, 1500)}`);
  }
  const linked = await run(await linkCommand(program, object, out));
  if (linked.code !== 0) throw new Error(`does not link:\n${linked.output.slice(0, 1500)}`);
  const ran = await run(`${out} --gtest_brief=1 --gtest_fail_fast`, {
    cwd: root,
    seconds: testSeconds,
  });
  rmSync(out);
  if (ran.code === 0) return { kind: 'passed' };
  if (ran.signal === 'SIGXCPU' || ran.signal === 'SIGKILL')
    return { kind: 'endless', by: `${program} does not end` };
  const [, by] = ran.output.match(/\[ {2}FAILED {2}\] (\S+)/) ?? [];
  return { kind: 'failed', by: by ?? `${program} stops: ${ran.output.trim().slice(-200)}` };
}

/** Calls `act` on all items, two at a time. */
async function inPairs(items, act) {
  const left = [...items];
  const work = async () => {
    for (let item = left.shift(); item; item = left.shift()) await act(item);
  };
  await Promise.all([work(), work()]);
}

const moduleOf = (file) => file.split('/')[2];
const chosen = faults
  .map((fault, n) => ({ ...fault, id: `${n}`, programs: fault.programs ?? [moduleOf(fault.file)] }))
  .filter(({ short }) => short || !options.short)
  .filter(({ file }) => words.length === 0 || words.some((word) => file.includes(word)));

const wrong = [];
for (const fault of chosen) {
  const text = existsSync(path.join(root, fault.file)) ? readFileSync(path.join(root, fault.file), 'utf8') : ''; // prettier-ignore
  const count = text.split(fault.find).length - 1;
  const name = `${fault.file}: ${fault.find.split('\n')[0]}`;
  fault.name = name;
  fault.text = text.replace(fault.find, () => fault.put);
  if (count !== 1) wrong.push(`${name}\n  stands there ${count} times; the fault wants to be looked at again`); // prettier-ignore
}

const programs = [...new Set(chosen.flatMap((fault) => fault.programs))];
const missing = programs.filter((program) => !existsSync(path.join(build, `bin/tests_${program}`)));
if (missing.length > 0) wrong.push(`not built in ${options.preset}: ${missing.map((p) => `tests_${p}`).join(' ')}`); // prettier-ignore

let caught = 0;
const missed = [];
if (wrong.length === 0) {
  await inPairs(programs, async (program) => {
    const { file } = chosen.find((fault) => fault.programs.includes(program));
    try {
      const text = readFileSync(path.join(root, file), 'utf8');
      const { kind, by } = await outcome(file, text, program, `control-${program}`);
      if (kind !== 'passed') wrong.push(`tests_${program} fails without a fault: ${by}`);
    } catch (error) {
      wrong.push(`tests_${program}, without a fault: ${error.message}`);
    }
  });
}
if (wrong.length === 0) {
  await inPairs(chosen, async (fault) => {
    try {
      let seen;
      for (const program of fault.programs) {
        seen = await outcome(fault.file, fault.text, program, fault.id);
        if (seen.kind !== 'passed') break;
      }
      if (seen.kind === 'passed') missed.push(fault.name);
      else caught += 1;
      console.log(
        `${seen.kind === 'passed' ? 'MISSED' : 'caught'} ${fault.name}  ${seen.by ?? ''}`,
      );
    } catch (error) {
      wrong.push(`${fault.name}\n  ${error.message}`);
    }
    rmSync(path.join(scratch, fault.id), { recursive: true, force: true });
  });
}
if (words.length === 0 && faults.length < wantedCount) wrong.push(`only ${faults.length} faults; ${wantedCount} are wanted`); // prettier-ignore

for (const text of wrong) console.log(`WRONG  ${text}`);
for (const name of missed) console.log(`no test noticed ${name}`);
console.log(`${caught} of ${chosen.length} faults caught, ${missed.length} missed`);
process.exitCode = wrong.length > 0 || caught < wantedShare * chosen.length ? 1 : 0;
