import assert from 'node:assert/strict';
import test from 'node:test';
import { niceLength } from '../../../web/src/model/nice_length.ts';

test('a round length is 1, 2 or 5 times a power of ten, at most what is allowed and more than 40 % of it', () => {
  for (let most = 1e-6; most < 1e6; most *= 1.07) {
    const length = niceLength(most);
    assert.match(length.toExponential(), /^[125]e/);
    assert.ok(length <= most * (1 + 1e-9) && length > 0.399 * most, `${length} for ${most}`);
  }
  assert.deepEqual([1, 2, 5, 10, 0.1, 0.049].map(niceLength), [1, 2, 5, 10, 0.1, 0.02]);
});
