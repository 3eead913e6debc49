// Draws faults at random in the TypeScript of page and package, plants one at a time, and sees whether the tests notice
// that need no browser: those of tests/web/units, and those of tests/wasm that take seconds.
//
//   scripts/mutate --page --seed N [--count M] [WORD…]   only files with a WORD in their name
//
// What does not compile is not counted. What no test notices wants a law, or a reason why it changes nothing.

import path from 'node:path';
import { parseArgs } from 'node:util';
import { inParallel } from '../support/commands.mjs';
import { drawPageFaults } from './draw_page.mjs';
import { failing, testsFor, typeChecker } from './plant_page.mjs';

const root = path.resolve(import.meta.dirname, '../..');
const { values: options, positionals: words } = parseArgs({
  options: {
    page: { type: 'boolean' },
    seed: { type: 'string', default: '1' },
    count: { type: 'string', default: '40' },
  },
  allowPositionals: true,
});
const wantedShare = 0.9;
const lanes = 2;
const count = Number(options.count);

const compiles = typeChecker(root);
const chosen = [];
for (const fault of drawPageFaults(root, Number(options.seed), 3 * count, words)) {
  if (chosen.length === count) break;
  if (compiles(fault)) chosen.push({ ...fault, id: chosen.length });
}

/** Tests that fail without a fault say nothing. */
const controls = new Map();
function passesPlain(group) {
  const key = group.join(' ');
  if (!controls.has(key)) controls.set(key, failing(root, group));
  return controls.get(key);
}

const missed = [];
const wrong = new Set();
await inParallel(chosen, lanes, async (fault) => {
  let by = '';
  for (const group of testsFor(root, fault.file)) {
    by = await failing(root, group, fault);
    if (by === '') continue;
    const plain = await passesPlain(group);
    if (plain === '') break;
    wrong.add(`without a fault: ${plain}`);
    by = '';
  }
  if (by === '') missed.push(fault.name);
  console.log(`${by === '' ? 'MISSED' : 'caught'} ${fault.name}  ${by === '' ? '' : `[${by}]`}`);
});

for (const text of wrong) console.log(`WRONG  ${text}`);
for (const name of missed) console.log(`no test noticed ${name}`);
const caught = chosen.length - missed.length;
console.log(`${caught} of ${chosen.length} faults caught, ${missed.length} missed`);
process.exitCode = wrong.size > 0 || caught < wantedShare * chosen.length ? 1 : 0;
