// C libraries round their functions differently: those of core/ come from base/portable_math.h (decision 046).

import assert from 'node:assert/strict';
import test from 'node:test';
import { filesOf, textOf } from './source_tree.mjs';

const functions =
  /\bstd::(a?(sin|cos|tan)h?|atan2|exp2?|expm1|log(2|10|1p)?|pow|cbrt|hypot|polar|arg|tgamma|erf)\(/;

test('core uses no elementary function of the C library', () => {
  const found = filesOf('core/hgp', '.h', '.cpp', '.inc').flatMap((file) =>
    textOf(file)
      .split('\n')
      .map((line, n) => (functions.test(line) ? `${file}:${n + 1}: ${line.trim()}` : null))
      .filter(Boolean),
  );
  assert.deepEqual(found, []);
});
