// Amounts of memory as words: whole tens of megabytes up to a gigabyte, then gigabytes. What a run will need. And the stages of
// a run as numbers.

import assert from 'node:assert/strict';
import test from 'node:test';
import { estimate, tooMany } from '../../../web/src/text/estimate.ts';
import { megabytes, memoryText, percentText, timesText } from '../../../web/src/text/format.ts';
import { runSteps, stageName, stepIndex, wholeFraction } from '../../../web/src/text/stages.ts';

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

test('numbers have one decimal as long as that makes two digits, and none from ten on', () => {
  for (const hundredths of [0, 4, 6, 50, 949, 951, 994, 996, 1004, 1049, 1051, 9960, 99_949]) {
    const x = hundredths / 100;
    const tenths = Math.round(hundredths / 10);
    const digits = tenths < 100 ? (tenths / 10).toFixed(1) : String(Math.round(x));
    assert.deepEqual([percentText(x), timesText(x)], [`${digits} %`, `× ${digits}`]);
  }
});

test('a run is estimated by its triangles and bytes: seconds up to a minute and a half, and whether memory is tight', () => {
  const each = 1.2e-4; // seconds for a triangle
  const counts = [0, 1, 8333, 8334, 9000, 500_000, 749_000, 749_999, 750_000, 750_001, 2_000_000];
  for (const triangles of counts) {
    const seconds = each * triangles;
    const takes = triangles < 1 / each ? 'under a second' : triangles < 90 / each ? `${Math.ceil(seconds)} s` : `${Math.ceil(seconds / 60)} min`; // prettier-ignore
    for (const bytes of [0, 1000, 1e8, 1e9, 1.5e9]) {
      const memory = 24 * 2 ** 20 + 3 * bytes + 4608 * triangles;
      const is = estimate(triangles, bytes);
      assert.deepEqual(is, { needed: memoryText(memory), takes, isTight: memory > 0.8 * 2 ** 32 }, `${triangles} ${bytes}`); // prettier-ignore
    }
    assert.deepEqual(estimate(triangles), estimate(triangles, 0));
    assert.ok(tooMany('a b.obj', triangles).includes(estimate(triangles).needed));
  }
});

test('the stages of a run follow one another: each begins where one before it ends, the last one ends at the whole', () => {
  const stages = ['read', 'weld', 'topology', 'field', 'cut', 'assemble', 'solve', 'improve', 'align', 'verify', 'write']; // prettier-ignore
  let [end, step] = [0, 0];
  for (const stage of stages) {
    assert.ok(Math.abs(wholeFraction(stage, 0, 0) - end) < 1e-9, `${stage} begins`);
    const parts = [0, 0.25, 0.5, 1].map((part) => wholeFraction(stage, part, 0));
    for (let i = 1; i < parts.length; i++) assert.ok(parts[i] > parts[i - 1], `${stage} goes on`);
    assert.ok(Math.abs(parts[2] - (parts[0] + parts[3]) / 2) < 1e-9, 'evenly');
    assert.deepEqual(
      [wholeFraction(stage, -1, 0), wholeFraction(stage, 9, 0)],
      [parts[0], parts[3]],
    );
    assert.equal(wholeFraction(stage, 0, 1), 1, 'never back');
    end = parts[3];
    assert.ok(stepIndex(stage) >= step && stepIndex(stage) <= step + 1, `the step of ${stage}`);
    step = stepIndex(stage);
    assert.notEqual(stageName(stage), stage);
  }
  assert.deepEqual([end, step], [1, runSteps.length - 1]);
  // Those that only some runs have are parts of others.
  for (const [stage, first, last] of [
    ['prepare', 'weld', 'topology'],
    ['cones', 'field', 'field'],
    ['connection', 'field', 'field'],
  ]) {
    // prettier-ignore
    const [from, to] = [0, 1].map((part) => wholeFraction(stage, part, 0));
    assert.ok(wholeFraction(first, 0, 0) <= from && from < to && to <= wholeFraction(last, 1, 0));
    assert.equal(stepIndex(stage), stepIndex(last));
  }
  assert.deepEqual([wholeFraction('other', 0.5, 0.3), stageName('other')], [0.3, 'other']);
});
