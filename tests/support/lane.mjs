// Runs test files in this process, one after another: those that no other lane has begun. What takes
// long to start is then started once for all of them.
//
//   node --test-reporter=tap tests/support/lane.mjs CLAIMS FILE...

import { mkdirSync } from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { test } from 'node:test';

/** What files want done when all of them are through. */
globalThis.atEnd = [];

const [claims, ...files] = process.argv.slice(2);

/** Whether no other lane has taken it. */
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
  // Tests run in the order they are declared: this one is the last of the file.
  await test(`all of ${path.basename(file)}`, () => {});
}
for (const act of globalThis.atEnd) await act();
