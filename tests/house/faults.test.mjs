// The list of planted faults follows the code: each stands in its file, once, so that it can be planted.

import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { faults } from '../mutation/faults.mjs';

const root = path.resolve(import.meta.dirname, '../..');

test('what listed faults replace stands in their files exactly once', () => {
  const strays = faults.filter(({ file, find }) => {
    const name = path.join(root, file);
    return !existsSync(name) || readFileSync(name, 'utf8').split(find).length !== 2;
  });
  assert.deepEqual(
    strays.map(({ file, find }) => `${file}: ${find}`),
    [],
  );
});
