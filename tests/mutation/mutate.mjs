// Plants faults of one line, one at a time, and sees whether the tests notice.
//
//   scripts/mutate [--short] [--again] [--preset native-debug] [WORD…]   only faults whose file has a WORD
//   scripts/mutate --seed N [--count M] [WORD…]   M faults drawn at random instead of those of the list
//
// A drawn fault that does not compile is not counted. What no test notices wants to be looked at: either a test is
// missing, or the fault changes nothing that a user can see.
//
// So that no fault counts as caught by accident, the tests that caught one run once more in a program
// that is linked in the same way with a source that is not changed, and must pass there; with --short, in
// one program for all, as they share the way of linking. A fault that was caught, and of which nothing has
// changed since, is not planted again (but with --again).

import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { inParallel } from '../support/commands.mjs';
import { contentOf, KeptResults, listingOf } from '../support/results.mjs';
import { drawFaults, modulesOf, programsFor } from './draw.mjs';
import { faults } from './faults.mjs';
import { planter } from './plant.mjs';

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
const { values: options, positionals: words } = parseArgs({
  options: {
    short: { type: 'boolean', default: false },
    again: { type: 'boolean', default: false },
    preset: { type: 'string', default: 'native-debug' },
    seed: { type: 'string' },
    count: { type: 'string', default: '40' },
  },
  allowPositionals: true,
});
const isDrawn = options.seed !== undefined;
const wantedShare = isDrawn ? 0.9 : 0.95;
const wantedCount = 40;
const lanes = 2;
if (!existsSync(path.join(root, 'build', options.preset, 'compile_commands.json'))) {
  console.error(`mutate: build/${options.preset} is not there; build it first`);
  process.exit(2);
}
const plant = planter(root, options.preset);
const kept = new KeptResults(path.join(root, 'build/results'), { isRead: !options.again });
const data = process.env.HGP_SHARED_MESHES ?? path.join(root, '../shared/meshes');

const moduleOf = (file) => file.split('/')[2];
/** Faults from the seed, more than are wanted, as some do not compile. */
function drawn() {
  const modules = modulesOf(root);
  return drawFaults(root, Number(options.seed), 2 * Number(options.count), words).map(
    (fault, n) => ({ ...fault, id: `${n}`, programs: programsFor(fault.file, modules) }),
  );
}
const listed = () =>
  faults
    .map((fault, n) => ({
      ...fault,
      id: `${n}`,
      programs: fault.programs ?? [moduleOf(fault.file)],
    }))
    .filter(({ short }) => short || !options.short)
    .filter(({ file }) => words.length === 0 || words.some((word) => file.includes(word)));
const chosen = isDrawn ? drawn() : listed();

const wrong = [];
const textOf = (file) =>
  existsSync(path.join(root, file)) ? readFileSync(path.join(root, file), 'utf8') : '';
for (const fault of isDrawn ? [] : chosen) {
  const text = textOf(fault.file);
  const count = text.split(fault.find).length - 1;
  fault.name = `${fault.file}: ${fault.find.split('\n')[0]}`;
  fault.text = text.replace(fault.find, () => fault.put);
  if (count !== 1) wrong.push(`${fault.name}\n  stands there ${count} times; the fault wants to be looked at again`); // prettier-ignore
}

const programs = [...new Set(chosen.flatMap((fault) => fault.programs))];
// A program of yesterday fails without any fault, and every fault would count as caught.
if (isDrawn) {
  const targets = programs.map((program) => (program.startsWith('node:') ? 'hgp' : `tests_${program}`)); // prettier-ignore
  const call = ['--build', '--preset', options.preset, '--target', ...targets];
  execFileSync('cmake', call, { cwd: root, stdio: ['ignore', 'ignore', 'inherit'] });
}
const missing = programs.filter((program) => !plant.has(program));
if (missing.length > 0) wrong.push(`not built: cmake --build --preset ${options.preset} --target ${missing.map((p) => `tests_${p}`).join(' ')}`); // prettier-ignore

async function keyOf({ file, find, put, programs, seenBy }) {
  const how = ['mutate.mjs', 'plant.mjs'].map((name) => contentOf(path.join(root, 'tests/mutation', name))); // prettier-ignore
  const inputs = await plant.inputsOf({ file, programs });
  return kept.key(file, find, put, seenBy ?? '', `${options.short}`, ...how, ...inputs, listingOf(data)); // prettier-ignore
}

/** A program that does not contain the fault's module, and so does not link, says nothing about a drawn fault. */
async function outcomeOf(...args) {
  try {
    return await plant.outcome(...args);
  } catch (error) {
    if (isDrawn && /does not link/.test(error.message)) return { kind: 'passed' };
    throw error;
  }
}

/** What the tests say about a fault: first the one that is known to see it, then all. */
async function observe({ id, file, text, programs, seenBy: likely }) {
  let seen;
  for (const program of programs) {
    if (likely && program === programs[0]) {
      seen = { program, ...(await plant.outcome(file, text, program, id, likely)) };
      if (seen.kind === 'failed' || seen.kind === 'endless') break;
    }
    seen = { program, ...(await outcomeOf(file, text, program, id)) };
    if (seen.kind !== 'passed') break;
  }
  return seen;
}

const caught = [];
const missed = [];
let unchanged = 0;
const tested = () => caught.length + missed.length + unchanged;
async function runTests(fault) {
  if (isDrawn && tested() >= Number(options.count)) return;
  try {
    fault.key = await keyOf(fault);
    if (kept.find(fault.key)) {
      unchanged += 1;
      console.log(`unchanged since it was caught: ${fault.name}`);
      return;
    }
    fault.seen = await observe(fault);
    const { kind, by = '' } = fault.seen;
    if (kind === 'passed') missed.push(fault.name);
    else caught.push(fault);
    console.log(`${kind === 'passed' ? 'MISSED' : 'caught'} ${fault.name}  ${by}`);
  } catch (error) {
    if (!isDrawn || !/does not compile/.test(error.message))
      wrong.push(`${fault.name}\n  ${error.message}`);
  }
  plant.forget(fault.id);
}

const caughtBy = (program) => caught.filter(({ seen }) => seen.program === program);

/** The tests of a program that caught something pass where nothing is changed. */
async function control(program) {
  const own = caughtBy(program);
  const isNamed = own.every(({ seen }) => seen.test);
  const filter = isNamed ? [...new Set(own.map(({ seen }) => seen.test))].join(':') : '*';
  try {
    const { file } = own[0];
    const { kind, by } = await plant.outcome(file, textOf(file), program, `control-${program}`, filter); // prettier-ignore
    if (kind !== 'passed')
      wrong.push(`tests_${program} fails without a fault: ${by ?? `there is no ${filter}`}`);
  } catch (error) {
    wrong.push(`tests_${program}, without a fault: ${error.message}`);
  }
  plant.forget(`control-${program}`);
}

async function keepCaught() {
  for (const fault of caught) {
    kept.keep(fault.key, await keyOf(fault), fault.name, { passed: 1, failed: 0, skipped: 0 });
  }
}

if (wrong.length === 0) await inParallel(chosen, lanes, runTests);
const noticing = programs.filter((program) => caughtBy(program).length > 0);
await inParallel(options.short ? noticing.slice(0, 1) : noticing, lanes, control);
if (wrong.length === 0) await keepCaught();
if (!isDrawn && words.length === 0 && faults.length < wantedCount) wrong.push(`only ${faults.length} faults; ${wantedCount} are wanted`); // prettier-ignore

for (const text of wrong) console.log(`WRONG  ${text}`);
for (const name of missed) console.log(`no test noticed ${name}`);
const count = caught.length + unchanged;
const all = count + missed.length;
console.log(`${count} of ${all} faults caught, ${missed.length} missed`);
process.exitCode = wrong.length > 0 || count < wantedShare * all ? 1 : 0;
