// Runs test files in this process one after another, skipping those that another lane has started, so that slow
// start-up work is done once for all of them.
//
//   node --test-reporter=tap tests/support/lane.mjs CLAIMS FILE...

import { mkdirSync } from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { test } from 'node:test';

/** Functions that test files register to be called after the last file. */
globalThis.atEnd = [];

const [claims, ...files] = process.argv.slice(2);

/** Claims a file; false if another lane has claimed it. */
function take(file) {
  try {
    mkdirSync(path.join(claims, path.basename(file)));
    return true;
  } catch {
    return false;
  }
}

for (const file of files) {
  if (!take(file)) continue;
  await import(pathToFileURL(path.resolve(file)));
  // Tests run in the order of their declarations, so this one is the last of the file.
  await test(`all of ${path.basename(file)}`, () => {});
}
for (const act of globalThis.atEnd) await act();
