import assert from 'node:assert/strict';
import test from 'node:test';
import { noteForPage, weldIn } from '../../../web/src/text/notes.ts';

const equal =
  '2 vertices have the position of another one; --weld exact would join 14 components into 12';
const crack =
  'a crack: 64 boundary vertices lie within 2e-06 of another one; --weld 2.1e-06 closes it';

test('notes name buttons of the page instead of options of the command line', () => {
  assert.equal(
    noteForPage(equal),
    '2 vertices have the position of another one; joining these makes 12 of 14 components',
  );
  assert.match(noteForPage(crack), /; joining vertices closer than 2\.1e-06 closes it$/);
  const joined = 'vertices were joined, and 9 components became 1 (--weld none keeps them apart)';
  assert.doesNotMatch(noteForPage(joined), /--/);
  const thin = 'as free of folds, with more distortion. --improve isometric (improve) lowers it.';
  assert.match(noteForPage(thin), /“Less distortion” under Solve lowers it\.$/);
  assert.doesNotMatch(noteForPage('more room for a grid: try --cones-for few'), /--/);
  assert.equal(noteForPage('T-junctions: 4 (within 0)'), 'T-junctions: 4 (within 0)');
});

test('a note offers the length at which vertices are joined', () => {
  assert.equal(weldIn([equal]), 0);
  assert.equal(weldIn([equal, crack]), 2.1e-6);
  assert.equal(weldIn(['T-junctions: 4']), undefined);
});
