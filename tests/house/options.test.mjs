// One table of options: what is made from it is up to date, and the command line has no other words.

import assert from 'node:assert/strict';
import test from 'node:test';
import { declareOptions, readTables } from '../../wasm/options.mjs';
import { textOf } from './source_tree.mjs';

const rows = Object.values(readTables()).flat();

test('every row of the table is read, with its bounds', () => {
  const { load, solve, verify, write } = readTables();
  assert.deepEqual(
    [load.length, solve.length, verify.length, write.length],
    [...textOf('core/hgp/api/option_table.cpp').matchAll(/k\w+Rows\{([^]*?)\n\};/g)].map(
      ([, body]) => body.match(/OptionRow/g).length,
    ),
  );
  const { kind, low, high } = solve.find((row) => row.name === 'improve');
  assert.deepEqual([kind, low, high], ['wordOrNumber', -1, 1]);
});

test('the options of the package are made from the table', async () => {
  const made = textOf('wasm/package/src/lib/option_table.ts');
  assert.equal(made, await declareOptions(), 'npm run types');
});

test('options of the command line are in the table, or concern files, messages and prescriptions', () => {
  const source = textOf('examples/cli/option_table.cpp');
  const flags = new Set(
    [...source.matchAll(/"(?:-\w,)?(--[a-z-]+)[",]/g)].map((match) => match[1]),
  );
  const ofProgram =
    '--help --format --root --json --quiet --no-progress --color --loops --xref --faces --also --force --embed ' +
    '--compress --convert --balance --transfer --from --cones --cone --turning --handle --field --ignore-embedded --rims --creases --features --marked ' +
    '--reproducible --time-limit --threads';
  const known = new Set([...rows.map((row) => row.flag), ...ofProgram.split(' ')]);
  assert.deepEqual(
    [...flags].filter((flag) => !known.has(flag)),
    [],
  );
  assert.deepEqual(
    [...rows.map((row) => row.flag)].filter((flag) => flag && !flags.has(flag)),
    [],
  );
});

test('the command line takes its words from the table', () => {
  const source = textOf('examples/cli/option_table.cpp');
  for (const { flag, words = [] } of rows.filter((row) => row.kind === 'word' && row.flag))
    assert.ok(
      !source.includes(words.map((word) => `"${word}"`).join(', ')),
      `${flag} lists its words itself`,
    );
});
