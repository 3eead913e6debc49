// A grid that is asked for and what came of it: densities, whether lines meet, and which patterns a seam
// turns.

import assert from 'node:assert/strict';
import test from 'node:test';
import { randomFrom } from '../../mutation/draw.mjs';
import {
  areSeamsShown,
  canAlign,
  gridOutcome,
  gridTilesPerUnit,
  hasSteps,
  isAligned,
  isTurnedBy,
  sameGrid,
  tilesPerUnit,
  turnedSeams,
} from '../../../web/src/model/grid.ts';
import { quadsSaved } from '../../../web/src/text/quads.ts';

const look = (part) => ({ pattern: 'checker', steps: 1, tiles: 24, seams: 'auto', ...part });
const grid = (part) => ({
  ...{ aligned: true, cells: 100, spacing: 0.1, cellsPerCone: 12.5, reason: '', workingCells: 0 },
  ...part,
});
const solutionOf = (grids, certificate = {}) => ({
  result: {
    report: { components: grids.map((one) => ({ grid: one })) },
    certificate: { seamEdges: 7, integerSeams: 7, ...certificate },
    cones: { cones: new Array(8).fill({}) },
  },
  distortion: { uvArea: 400, surfaceArea: 4 },
});

test('a quad mesh that differs from the cells on the screen reports how', () => {
  const plain = {
    quads: 1200,
    clipped: 0,
    cuts: 0,
    replaced: 0,
    halvings: 0,
    foldedInSpace: 0,
    foldedQuads: 0,
  };
  assert.equal(quadsSaved(plain, 'a.obj'), '1 200 quads saved as a.obj.');
  assert.equal(
    quadsSaved({ ...plain, clipped: 1, halvings: 1, foldedQuads: 2 }, 'a.obj'),
    '1 200 quads saved as a.obj, without 1 cell that a boundary cuts, 4 per cell, because a handle or two cones are within two cells, 2 of them folded together at a cone with k = 1.',
  );
  assert.match(quadsSaved({ ...plain, halvings: 2 }, 'a.obj'), /, 16 per cell/);
});

test('square cells fit only rotations by half and quarter turns', () => {
  assert.deepEqual([1, 2, 3, 4, 6, 8].filter(canAlign), [2, 4]);
  const on = { isOn: true, mode: 'tile' };
  assert.equal(sameGrid(on, { ...on, cells: 9 }, 4), false);
  assert.equal(sameGrid(on, { ...on, mode: 'quad' }, 2), false);
  assert.equal(sameGrid(on, { isOn: false, mode: 'quad' }, 6), true); // no grid either way
  assert.equal(sameGrid({ ...on, isOn: false }, { isOn: false, mode: 'quad' }, 4), true);
});

test('lines meet where the report says so and the certificate counts every seam', () => {
  assert.equal(isAligned(solutionOf([grid(), grid()])), true);
  assert.equal(isAligned(solutionOf([grid()], { integerSeams: 6 })), false);
  assert.equal(isAligned(solutionOf([grid()], { integerSeams: null })), false);
  assert.equal(isAligned(solutionOf([grid(), grid({ aligned: false })])), false);
  assert.equal(isAligned(solutionOf([null])), false); // no grid was asked
  assert.equal(gridOutcome(solutionOf([null])), undefined);
});

test('the component that needs most cells determines the recommended number', () => {
  const failed = {
    aligned: false,
    cells: 50,
    reason: 'cones 1 and 2 are too close',
    workingCells: 200,
  };
  const outcome = gridOutcome(solutionOf([grid(), grid(failed)]));
  assert.equal(outcome.isAligned, false);
  assert.equal(outcome.workingCells, 600); // of 150, four times as many
  assert.match(outcome.reason, /too close/);
  const hopeless = gridOutcome(solutionOf([grid(failed), grid({ ...failed, workingCells: 0 })]));
  assert.equal(hopeless.workingCells, 0);
});

test('a number of cells is recommended where every component that has no aligned map has one that works, be it a single cell', () => {
  const random = randomFrom(17);
  const oneOf = (...all) => all[Math.floor(all.length * random())];
  const seen = new Set();
  for (let round = 0; round < 200; round++) {
    const parts = Array.from({ length: oneOf(1, 2, 3) }, () => ({ aligned: random() < 0.4, cells: oneOf(1, 40, 100), workingCells: oneOf(0, 1, 1, 30, 250) })); // prettier-ignore
    const failed = parts.filter(({ aligned }) => !aligned);
    const isKnown = failed.length > 0 && failed.every(({ workingCells }) => workingCells !== 0);
    const total = parts.reduce((sum, { cells }) => sum + cells, 0);
    const most = Math.max(1, ...failed.map((one) => one.workingCells / one.cells));
    const { workingCells, cells } = gridOutcome(solutionOf(parts.map((one) => grid(one))));
    assert.deepEqual([workingCells, cells], [isKnown ? Math.ceil(total * most) : 0, total]);
    seen.add(isKnown);
  }
  assert.equal(seen.size, 2);
});

test('cells are counted for each cone where there are cones', () => {
  const solution = solutionOf([grid(), grid()]);
  assert.equal(gridOutcome(solution).cellsPerCone, 25);
  solution.result.cones.cones = [];
  assert.equal(gridOutcome(solution).cellsPerCone, Infinity);
});

test('on an aligned map a pattern comes in whole periods, elsewhere at any scale', () => {
  const surface = { diagonal: 2 };
  const aligned = solutionOf([grid()]);
  assert.equal(tilesPerUnit(look({ steps: 3 }), surface, aligned), 6); // dark and light
  assert.equal(tilesPerUnit(look({ pattern: 'grid', steps: 3 }), surface, aligned), 3);
  assert.equal(gridTilesPerUnit(look({ steps: 3 }), surface, aligned), 6);
  const plain = solutionOf([grid({ aligned: false })]);
  assert.equal(tilesPerUnit(look({ steps: 3 }), surface, plain), 24 / 20);
  assert.equal(hasSteps(look({}), aligned), true);
  assert.equal(hasSteps(look({ pattern: 'cross' }), aligned), false);
  assert.equal(hasSteps(look({}), plain), false);
  assert.deepEqual(['auto', 'on', 'off'].map((seams) => areSeamsShown({ seams }, aligned)), [false, true, false]); // prettier-ignore
  assert.deepEqual(['auto', 'on', 'off'].map((seams) => areSeamsShown({ seams }, plain)), [true, true, false]); // prettier-ignore
});

test('a quarter turn changes bricks and images, a half turn only images', () => {
  const turnedBy = (r) =>
    ['checker', 'grid', 'plaid', 'circles', 'brick', 'hex', 'wood', 'image', 'cross'].filter(
      (pattern) => isTurnedBy(pattern, r, 4),
    );
  assert.deepEqual(turnedBy(0), []);
  assert.deepEqual(turnedBy(1), ['brick', 'hex', 'wood', 'image']);
  assert.deepEqual(turnedBy(2), ['wood', 'image']);
  assert.equal(isTurnedBy('brick', 1, 2), false);
  const seams = [0, 0, 1, 1, 2].map((r) => ({ r }));
  const some = { seams, chains: Uint32Array.of(0, 0, 1, 1, 2), prescription: { q: 4 } };
  assert.deepEqual(turnedSeams('image', some), { all: 3, turned: 2, edges: [2, 3, 4] });
  assert.deepEqual(turnedSeams('brick', some).edges, [2, 3]);
  assert.equal(turnedSeams('checker', some).turned, 0);
});
