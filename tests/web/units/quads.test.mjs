// The quads that are shown before they are saved.

import assert from 'node:assert/strict';
import test from 'node:test';
import { randomFrom } from '../../mutation/draw.mjs';
import { bendOf, readQuads, valencesOf } from '../../../web/src/model/quad_shape.ts';
import { askedFor, quadFaults, quadsSaved } from '../../../web/src/text/quads.ts';

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

test('a tenth more or less is as asked for; anything beyond is told with its reason', () => {
  const none = { clipped: 0, cuts: 0, replaced: 0, halvings: 0, foldedInSpace: 0, foldedQuads: 0 };
  for (let asked = 10; asked < 3000; asked += 10) {
    const tenth = asked / 10;
    for (const quads of [asked - tenth, asked, asked + tenth]) assert.equal(askedFor({ ...none, quads }, asked, 8), ''); // prettier-ignore
    const beyond = (of) => [asked - tenth - 1, asked + tenth + 1].map((quads) => askedFor({ ...none, ...of, quads }, asked, 8)); // prettier-ignore
    const [[fewer, more], cut, divided] = [beyond({}), beyond({ clipped: 1 }), beyond({ halvings: 1 })]; // prettier-ignore
    assert.equal(new Set(['', fewer, more, cut[0], divided[0]]).size, 5);
    assert.equal(cut[1], more, 'what is left out makes no more');
    assert.equal(divided[1], divided[0]);
  }
});

test('of quads everything is told that is not zero, with its number, and nothing else', () => {
  const random = randomFrom(3);
  const keys = ['clipped', 'cuts', 'replaced', 'halvings', 'foldedInSpace', 'foldedQuads'];
  const numbersIn = (text) => (text.match(/\d+/g) ?? []).map(Number);
  for (let round = 0; round < 200; round++) {
    const some = Object.fromEntries(keys.map((key, i) => [key, random() < 0.5 ? 0 : random() < 0.3 ? 1 : 2 + i])); // prettier-ignore
    const { halvings, ...others } = some;
    const told = (names) => names.filter((key) => others[key] > 0).map((key) => others[key]);
    const faults = quadFaults(some);
    const text = faults.map((one) => one.replace('k = 1', 'k')).join('');
    assert.deepEqual(numbersIn(text), told(['clipped', 'cuts', 'replaced', 'foldedQuads']));
    assert.equal(faults.length, numbersIn(text).length);
    for (const one of faults) {
      const [, n, noun] = one.match(/^(\d+) (\w+)/);
      assert.equal(noun.endsWith('s'), n !== '1', one);
    }
    const saved = quadsSaved({ ...some, quads: 812 }, 'x.obj').replace('k = 1', 'k');
    const per = halvings > 0 ? [4 ** halvings] : [];
    const expected = [812, ...told(['clipped', 'cuts', 'replaced', 'foldedInSpace']), ...per, ...told(['foldedQuads'])]; // prettier-ignore
    assert.deepEqual(numbersIn(saved), expected);
  }
});
