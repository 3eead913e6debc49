// The quads that are shown before they are saved.

import assert from 'node:assert/strict';
import test from 'node:test';
import { bendOf, readQuads, valencesOf } from '../../../web/src/model/quad_shape.ts';
import { askedFor, quadFaults } from '../../../web/src/text/quads.ts';

const box = `v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1
vn 0 0 1
f 4//1 3//1 2//1 1//1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n`;
const read = (text) => readQuads(new TextEncoder().encode(text));

test('the valences of a closed box are eight times three', () => {
  const { counts, irregular } = valencesOf(read(box));
  assert.deepEqual([...counts], [[3, 8]]);
  assert.deepEqual(irregular.map(({ vertex }) => vertex).sort(), [0, 1, 2, 3, 4, 5, 6, 7]);
});

test('vertices on a boundary are not counted', () => {
  const open = read(box.replace('f 5 6 7 8\n', ''));
  assert.deepEqual([...valencesOf(open).counts], [[3, 4]]);
});

test('a quad of which one corner is turned over is folded; a bent one is not', () => {
  const at = (x, y, z = 0) => read(`v 0 0 0\nv 1 0 0\nv ${x} ${y} ${z}\nv 0 1 0\nf 1 2 3 4`);
  assert.equal(bendOf(at(1, 1), 0).isFolded, false);
  assert.equal(bendOf(at(1, 1, 0.7), 0).isFolded, false);
  assert.equal(bendOf(at(0.2, 0.2), 0).isFolded, true);
});

test('why another number of quads came out is said only where it is another', () => {
  const none = { clipped: 0, cuts: 0, replaced: 0, halvings: 0, foldedInSpace: 0, foldedQuads: 0 };
  assert.equal(askedFor({ ...none, quads: 800 }, undefined, 8), '');
  assert.equal(askedFor({ ...none, quads: 870 }, 800, 8), '');
  assert.match(askedFor({ ...none, quads: 2032 }, 800, 52), /^800 .*too coarse for 52 cones/);
  assert.match(askedFor({ ...none, quads: 3200, halvings: 1 }, 800, 8), /each cell is divided/);
  assert.match(askedFor({ ...none, quads: 500, clipped: 300 }, 800, 8), /boundary cuts/);
  assert.deepEqual(quadFaults(none), []);
  assert.equal(quadFaults({ ...none, clipped: 1, cuts: 2, replaced: 1, foldedQuads: 1 }).length, 4);
});
