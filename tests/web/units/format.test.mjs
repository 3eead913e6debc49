// Amounts of memory as words: whole tens of megabytes up to a gigabyte, then gigabytes.

import assert from 'node:assert/strict';
import test from 'node:test';
import { megabytes, memoryText } from '../../../web/src/text/format.ts';

test('memory is told in tens of megabytes below a gigabyte, and in gigabytes from there on', () => {
  const mega = 2 ** 20;
  assert.deepEqual(
    [0, 1, 123, 126, 1000, 1024, 1536, 10240].map((n) => memoryText(n * mega)),
    ['10 MB', '10 MB', '120 MB', '130 MB', '1000 MB', '1.0 GB', '1.5 GB', '10.0 GB'],
  );
  assert.deepEqual(
    [0.25, 0.999, 1, 12.4].map((n) => megabytes(n * mega)),
    ['0.25 MB', '1.00 MB', '1 MB', '12 MB'],
  );
});
