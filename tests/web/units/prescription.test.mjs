// The values of the page: what is asked, its budget, its history, and its place in the address.

import assert from 'node:assert/strict';
import test from 'node:test';
import { modelTag, readHash, writeHash } from '../../../web/src/formats/hash_state.ts';
import { computeBudget, largestK, waysToSpend } from '../../../web/src/model/gauss_bonnet.ts';
import { History } from '../../../web/src/model/history.ts';
import { plainRounds } from '../../../web/src/model/request.ts';
import { randomFrom } from '../../mutation/draw.mjs';
import {
  angleText,
  emptyPrescription,
  fromCones,
  indexText,
  toCones,
  withOrder,
} from '../../../web/src/model/prescription.ts';

const asked = {
  ...emptyPrescription(4, 2, 2),
  cones: [
    { vertex: 7, k: 3 },
    { vertex: 9, k: 6 },
  ],
  turnings: [null, -4],
  handles: [2, null],
};

test('export to hgp-cones and back keeps the prescription; loops and handles past the end are left out', () => {
  const cones = toCones(asked, [...Array(30).keys()]);
  assert.deepEqual(cones.cones[0], { vertex: 7, k: 3, position: [21, 22, 23] });
  assert.deepEqual(cones.boundaries, [{ loop: 1, l: -4 }]);
  assert.deepEqual(fromCones(cones, 2, 2), asked);
  assert.deepEqual(fromCones(cones, 1, 0), { ...asked, turnings: [null], handles: [] });
});

test('another q keeps every angle or is refused', () => {
  const eighths = withOrder(asked, 8);
  assert.deepEqual(
    eighths.cones.map(({ k }) => k),
    [6, 12],
  );
  assert.deepEqual(
    [eighths.turnings, eighths.handles],
    [
      [null, -8],
      [4, null],
    ],
  );
  assert.deepEqual(withOrder(eighths, 4), asked);
  assert.equal(withOrder(asked, 2), undefined);
});

test('the texts of indices and angles', () => {
  assert.deepEqual(
    [4, 3, 6, 2, 8, 12].map((k) => indexText(k, 4)),
    ['0', '+1/4', '−1/2', '+1/2', '−1', '−2'],
  );
  assert.deepEqual([angleText(3, 4), angleText(1, 7)], ['270°', '51.4°']);
});

test('the largest k leaves every corner below 180°', () => {
  for (let q = 1; q <= 12; q++) {
    for (let valence = 3; valence <= 9; valence++) {
      const corner = (k) => (360 * k) / q / valence;
      assert.ok(corner(largestK(q, valence)) < 180 && corner(largestK(q, valence) + 1) >= 180);
    }
  }
});

test('every suggestion for the budget balances it exactly', () => {
  for (let q = 1; q <= 8; q++) {
    for (const left of [-9, -4, -1, 1, 2, 5, 8]) {
      for (const way of waysToSpend(left, q).split(' or ').filter(Boolean)) {
        const [, count, k] = way.match(/^(one cone|\d+ cones) with k = (\d+)$/);
        const n = count === 'one cone' ? 1 : Number.parseInt(count);
        assert.equal(n * (q - Number(k)), left, `q = ${q}: ${way}`);
      }
    }
  }
});

test('undo takes back one step; edits of one kind soon after one another are one', () => {
  let history = History.of(0)
    .push(1, 'k: cone 1', 1000)
    .push(2, 'k: cone 1', 1499)
    .push(3, 'k: cone 1', 2100)
    .push(4, 'k: cone 2', 2101);
  const seen = [];
  while (history.canUndo) {
    history = history.undo();
    seen.push(history.value);
  }
  assert.deepEqual(seen, [3, 2, 0]);
  history = history.redo().push(9, 'add: cone', 9000);
  assert.deepEqual([history.value, history.canRedo, history.undoKind], [9, false, 'add']);
});

test('a URL gives numbers and known words or nothing', () => {
  const pairs = (list) => btoa(JSON.stringify(list)).replaceAll('=', '');
  assert.deepEqual(readHash(`#q=6&cones=${pairs([[5, 3]])}`).cones, [{ vertex: 5, k: 3 }]);
  const split = readHash(`#cones=${pairs([[5, 3, 0], [5, 2, 9]])}`).cones; // prettier-ignore
  assert.deepEqual(split, [{ vertex: 5, k: 3, triangle: 0 }, { vertex: 5, k: 2, triangle: 9 }]); // prettier-ignore
  assert.deepEqual(readHash(`#turnings=${pairs([[0, -4]])}`).turnings, [[0, -4]]);
  const bad = ['', '!', pairs({}), pairs([[1]]), pairs([[1, 2, 3, 4]]), pairs([[1, 2, -3]]), pairs([[-1, 3]]), pairs([[1, 0]])]; // prettier-ignore
  for (const text of [...bad, pairs([[1.5, 3]]), pairs([['1', 3]]), 'A'.repeat(8193)]) {
    assert.equal(readHash(`#cones=${text}`).cones, undefined, text.slice(0, 20));
  }
  for (const word of [
    'q=0',
    'q=65',
    'q=1.5',
    'pattern=image',
    'overlay=x',
    'tiles=0',
    'tiles=1e9',
  ]) {
    const { q, pattern, overlay, tiles } = readHash(`#${word}`);
    assert.deepEqual([q, pattern, overlay, tiles], Array(4).fill(undefined), word);
  }
});

/** A surface of one component in which vertex v has the neighbours v − 1 and v + 1. */
function chain(count) {
  const all = (value) => new Array(count).fill(value);
  return {
    vertexCount: count,
    valence: all(6),
    isBoundary: all(0),
    triangleComponent: new Int32Array(0),
    component: all(0),
    neighbourStart: Array.from({ length: count + 1 }, (_, v) => 2 * v),
    neighbours: Array.from({ length: 2 * count }, (_, i) => (i >> 1) + (i & 1 ? 1 : -1)),
  };
}
const closed = { components: [{ component: 0, eulerCharacteristic: 2, boundaryLoops: [] }] };

test('each faulty cone is reported: the second of two, neighbours, k that is too large', () => {
  const cones = [
    { vertex: 5, k: 3 },
    { vertex: 6, k: 3 },
    { vertex: 5, k: 3 },
    { vertex: 90, k: 12 },
    { vertex: 400, k: 3 },
  ];
  const { cones: states, isReady } = computeBudget(
    { q: 4, cones, turnings: [], handles: [] },
    chain(100),
    closed,
  );
  assert.deepEqual(
    states.map(({ text }) => text.split('.')[0].slice(0, 32)),
    ['shares a triangle with cone 2', 'shares a triangle with cone 1', 'there is a cone here already', '6 triangles; k = 12 would need a', 'no such vertex'], // prettier-ignore
  );
  assert.equal(isReady, false);
});

test('each cone is visited a few times, however many there are', () => {
  let looks = 0;
  const count = 2000;
  const list = Array.from({ length: count }, (_, i) => ({ vertex: 3 * i, k: 3 }));
  const cones = new Proxy(list, {
    get(target, key, receiver) {
      if (typeof key === 'string' && /^\d+$/.test(key)) looks += 1;
      return Reflect.get(target, key, receiver);
    },
  });
  const surface = chain(3 * count + 3);
  computeBudget({ q: 4, cones, turnings: [], handles: [] }, surface, closed);
  assert.ok(looks >= count && looks < 12 * count, `${looks} for ${count} cones`);
});

test('cones in the address name the mesh of the file to which they belong', () => {
  const sha256 = 'c0ffee00'.repeat(8);
  const model = modelTag({ file: { sha256 }, surface: 2 });
  const look = { pattern: 'checker', overlay: 'none', tiles: 24 };
  const plain = { q: 4, cones: [], turnings: [null], handles: [] };
  const withCones = { ...plain, cones: [{ vertex: 5, k: 3 }] };
  const read = (prescription) =>
    readHash(
      writeHash({ look, solve: { grid: { isOn: true, mode: 'tile' } }, prescription, model }).hash,
    );
  assert.equal(read(withCones).model, 'c0ffee00.2');
  assert.equal(read({ ...plain, turnings: [-4] }).model, 'c0ffee00.2');
  const split = { ...plain, cones: [{ vertex: 5, k: 3, triangle: 0 }, { vertex: 5, k: 2 }] }; // prettier-ignore
  assert.deepEqual(read(split).cones, split.cones);
  assert.equal(read(plain).model, undefined); // nothing belongs to a model
  assert.equal(readHash('#model=<b>').model, undefined);
});

test('the address gives back whatever was written into it, down to vertex 0 and from one limit to the other', () => {
  const random = randomFrom(21);
  const below = (n) => Math.floor(n * random());
  const perhaps = (make) => (random() < 0.5 ? undefined : make());
  const oneOf = (...all) => all[below(all.length)];
  const list = (make) => Array.from({ length: below(4) }, make);
  for (let round = 0; round < 400; round++) {
    const cones = list(() => ({ vertex: below(3), k: 1 + below(3), ...perhaps(() => ({ triangle: below(3) })) })); // prettier-ignore
    const numbers = () => list(() => oneOf(null, 0, 1, -4));
    const prescription = {
      q: oneOf(1, 2, 4, 6, 64),
      cones,
      turnings: numbers(),
      handles: numbers(),
    };
    const look = { pattern: oneOf('checker', 'plain', 'cross', 'image', 'material'), overlay: oneOf('none', 'area', 'flips'), tiles: oneOf(1, 2, 24, 1000) }; // prettier-ignore
    const grid = { isOn: random() < 0.6, mode: oneOf('tile', 'quad'), cells: oneOf(undefined, 1, 500, 1_000_000) }; // prettier-ignore
    const solve = { grid, improve: oneOf(undefined, -1, -0.75, 0, 0.5, 1), rounds: oneOf(1, plainRounds, 100, 1000), timeLimit: oneOf(undefined, 1, 30, 1_000_000) }; // prettier-ignore
    const features = perhaps(() => ({ hasCreases: random() < 0.5, hasRims: random() < 0.5, edges: list(() => [below(2), below(3)]), rims: [], ...perhaps(() => ({ isSymmetric: true })) })); // prettier-ignore
    const [example, camera, model] = [perhaps(() => 'the-cube-2'), perhaps(() => '1,2,3,4,5,6'), perhaps(() => 'c0ffee00.0')]; // prettier-ignore
    const { hash, omitted } = writeHash({ example, look, prescription, solve, features, camera, model }); // prettier-ignore
    assert.deepEqual(omitted, []);

    const { edges = [], hasCreases, hasRims, isSymmetric } = features ?? {};
    const pairs = (all) => all.flatMap((n, i) => (n === null ? [] : [[i, n]]));
    const some = (all) => (all.length > 0 ? all : undefined);
    const isPlain = grid.isOn && grid.mode === 'tile' && grid.cells === undefined;
    const follows = edges.length > 0 || hasRims || isSymmetric;
    const [turnings, handles] = [some(pairs(prescription.turnings)), some(pairs(prescription.handles))]; // prettier-ignore
    const expected = {
      ...{
        example,
        camera,
        q: prescription.q,
        tiles: look.tiles,
        cones: some(cones),
        turnings,
        handles,
      },
      pattern: ['image', 'material'].includes(look.pattern) ? undefined : look.pattern,
      overlay: look.overlay === 'none' ? undefined : look.overlay,
      grid: isPlain ? undefined : { ...grid, mode: grid.isOn ? grid.mode : 'tile' },
      improve: solve.improve,
      rounds: solve.rounds === plainRounds ? undefined : solve.rounds,
      timeLimit: solve.timeLimit,
      features: follows ? { hasCreases: hasCreases && edges.length > 0, hasRims, edges, ...(isSymmetric ? { isSymmetric } : {}) } : undefined, // prettier-ignore
      model: follows || cones.length > 0 || turnings || handles ? model : undefined,
    };
    assert.deepEqual(readHash(hash), expected, hash);
  }
});

test('numbers in an address are taken within their ranges, ends included, and otherwise ignored', () => {
  const ranges = { q: [1, 64], rounds: [1, 1000], limit: [1, 1_000_000], cells: [1, 1_000_000], tiles: [1, 1000], improve: [-1, 1] }; // prettier-ignore
  for (const [key, [low, high]] of Object.entries(ranges)) {
    const isWhole = !['tiles', 'improve'].includes(key);
    const around = [low, high].flatMap((end) => [-1, -0.5, 0, 0.5, 1].map((by) => end + by));
    for (const n of [...around, -high - 1]) {
      const read = readHash(`#grid=tile&${key}=${n}`);
      const is = { ...read, limit: read.timeLimit, cells: read.grid?.cells }[key];
      const isGood = n >= low && n <= high && (!isWhole || Number.isInteger(n));
      assert.equal(is, isGood ? n : undefined, `${key}=${n}`);
    }
  }
});

test('a list of up to 8192 letters is in the address, and a longer one is named instead', () => {
  const look = { pattern: 'checker', overlay: 'none', tiles: 24 };
  const seen = new Set();
  for (let longer = 0; longer < 12; longer++) {
    const cones = Array.from({ length: 877 }, (_, i) => ({ vertex: i < longer ? 100 : 10, k: 3 }));
    const length = Math.ceil((4 * (7 * 877 + 1 + longer)) / 3);
    const prescription = { q: 4, cones, turnings: [], handles: [] };
    const { hash, omitted } = writeHash({ look, prescription, solve: { grid: { isOn: true, mode: 'tile' } } }); // prettier-ignore
    assert.deepEqual(readHash(hash).cones, length <= 8192 ? cones : undefined, `${length} letters`);
    assert.equal(omitted.length, length <= 8192 ? 0 : 1);
    seen.add(length);
  }
  assert.ok(seen.has(8192), 'the longest of all');
});
