// Few cones are kept only where their map is certified and good on every component, or no worse than with more.

import assert from 'node:assert/strict';
import test from 'node:test';
import {
  isAsGoodWithFew,
  isFewTried,
  isGoodWithFew,
  isPossibleWithFew,
} from '../../../web/src/model/few_cones.ts';

/** μ whose σ₁/σ₂ − 1 is `stretch`. */
const muOf = (stretch) => stretch / (2 + stretch);
const certificate = (certified, ...parts) => ({
  certified,
  components: parts.map(([stretch, sizeSpread]) => ({
    distortion: { medianMu: muOf(stretch), sizeSpread },
  })),
});

test('few cones may stretch every component by 15 %', () => {
  assert.equal(isPossibleWithFew(certificate(true, [0.149, 9])), true);
  assert.equal(isPossibleWithFew(certificate(true, [0.151, 1])), false);
  assert.equal(isPossibleWithFew(certificate(true, [0.1, 2], [0.2, 1])), false);
});

test('a map that is not certified, or not measured, is not kept', () => {
  assert.equal(isPossibleWithFew(certificate(false, [0, 1])), false);
  assert.equal(isPossibleWithFew({ certified: true, components: [{}] }), false);
  assert.equal(isGoodWithFew({ certified: true, components: [{}] }), false);
});

test('sizes may vary 2.5 times on every component, or as much as with more cones', () => {
  assert.equal(isGoodWithFew(certificate(true, [0, 2.49])), true);
  assert.equal(isGoodWithFew(certificate(true, [0, 2], [0, 2.51])), false);
  const few = certificate(true, [0.1, 3]);
  assert.equal(isAsGoodWithFew(few, certificate(true, [0, 3.1])), true);
  assert.equal(isAsGoodWithFew(few, certificate(true, [0, 2.8])), true);
  assert.equal(isAsGoodWithFew(few, certificate(true, [0, 2])), false);
  assert.equal(isAsGoodWithFew(few, certificate(false, [0, 1])), true);
});

test('on large surfaces there is one run', () => {
  assert.deepEqual([1000, 90_000, 1_000_000].map(isFewTried), [true, true, false]);
});
