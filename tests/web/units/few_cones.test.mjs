// Few cones are kept only where their map is certified and good on every component, or no worse than with more.

import assert from 'node:assert/strict';
import test from 'node:test';
import { HgpError } from '../../../build/package/index.js';
import { solveAutomatic } from '../../../web/src/actions/automatic.ts';
import { balancedStep, fewStep } from '../../../web/src/actions/cone_steps.ts';
import { Document } from '../../../web/src/model/document.ts';
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

/** What a run makes of these maps, or failures, with few and with more cones. */
async function chosen({ few, more, triangles = 1000, isAligned = true }) {
  const asked = [];
  const open = new Set();
  const parametrize = async ({ conesFor }) => {
    const name = conesFor ?? 'more';
    asked.push(name);
    const made = name === 'few' ? few : more;
    if (made instanceof Error) throw made;
    open.add(name);
    const grid = name === 'few' && !isAligned ? { aligned: false, cells: 9, spacing: 1, workingCells: 0 } : undefined; // prettier-ignore
    const report = { options: {}, components: [grid ? { grid } : {}] };
    return { name, certificate: { ...made, integerSeams: 0, seamEdges: 0 }, report, cones: { cones: [1] }, dispose: async () => open.delete(name) }; // prettier-ignore
  };
  const result =
    await solveAutomatic({ doc: new Document() }, { info: { triangles }, solver: { parametrize } }, {}, {}) // prettier-ignore
      .catch((error) => ({ error, map: {} }));
  const isFew = result.step === fewStep;
  assert.ok(result.error || isFew || result.step === balancedStep);
  if (!result.error) assert.equal(result.map.name, isFew ? 'few' : 'more');
  return [result.error?.code ?? result.map.name, asked.join(' '), [...open].join(' ')];
}

test('of the maps of a run that chooses cones one is kept, the other one is let go of', async () => {
  const [good, stretched, fair, worse] = [[0.05, 2], [0.3, 1], [0.1, 3], [0.1, 9]].map((one) => certificate(true, one)); // prettier-ignore
  const failure = (code) => new HgpError({ code, message: 'scripted', notes: [] });
  const law = async (given, ...expected) => assert.deepEqual(await chosen(given), expected);
  await law({ few: good, more: good }, 'few', 'few', 'few');
  await law({ few: stretched, more: good }, 'more', 'few more', 'more');
  await law({ few: fair, more: good }, 'more', 'few more', 'more');
  await law({ few: fair, more: worse }, 'few', 'few more', 'few');
  await law({ few: worse, more: fair }, 'more', 'few more', 'more');
  await law({ few: fair, more: certificate(false, [0, 1]) }, 'few', 'few more', 'few');
  await law({ few: good, more: fair, isAligned: false }, 'more', 'few more', 'more');
  await law({ few: good, more: fair, triangles: 10 ** 6 }, 'more', 'more', 'more');
  // A map with few cones is better than none; what else goes wrong ends the run, and keeps nothing.
  await law({ few: fair, more: failure('no-map') }, 'few', 'few more', 'few');
  await law({ few: failure('no-map'), more: fair }, 'more', 'few more', 'more');
  await law({ few: failure('no-map'), more: failure('no-map') }, 'no-map', 'few more', '');
  await law({ few: fair, more: failure('internal') }, 'internal', 'few more', '');
  await law({ few: failure('internal'), more: fair }, 'internal', 'few', '');
});
