// Laws of the address of the page: what is written into it comes back, and of what is not of its kind nothing is taken, not even
// where the rest of it is.

import assert from 'node:assert/strict';
import test from 'node:test';
import { modelTag, readHash, writeHash } from '../../../web/src/formats/hash_state.ts';
import { Document } from '../../../web/src/model/document.ts';
import { overlays, patterns } from '../../../web/src/model/types.ts';
import { randomFrom } from '../../mutation/draw.mjs';

const { look, solve } = new Document();
const encoded = (value) => btoa(typeof value === 'string' ? value : JSON.stringify(value)).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', ''); // prettier-ignore

test('whatever a link holds comes back, each part by itself and with all others', () => {
  const random = randomFrom(12);
  const below = (n) => Math.floor(n * random());
  const one = (list) => list[below(list.length)];
  const listOf = (make) => Array.from({ length: below(5) }, make);
  const maybe = (make) => (random() < 0.5 ? make() : undefined);
  for (let i = 0; i < 300; i++) {
    const cone = () => ({ vertex: below(3) * below(10 ** 6), k: 1 + below(70), ...(random() < 0.3 ? { triangle: below(3) * 7 } : {}) }); // prettier-ignore
    const index = () => (random() < 0.4 ? null : below(9) - 4);
    const grid = { isOn: random() < 0.7, mode: one(['tile', 'quad']), cells: maybe(() => 1 + below(10 ** 6)) }; // prettier-ignore
    if (!grid.isOn) grid.mode = 'tile';
    const source = {
      example: maybe(() => one(['a', 'the-sphere-2', 'x'.repeat(40)])),
      look: { ...look, pattern: one(patterns.filter((name) => !['image', 'material'].includes(name))), overlay: one(overlays), tiles: 1 + below(1000) }, // prettier-ignore
      solve: { ...solve, grid, improve: maybe(() => one([-1, 0, 0.25, 1])), rounds: 1 + below(1000), timeLimit: maybe(() => 1 + below(10 ** 6)) }, // prettier-ignore
      prescription: { q: 1 + below(64), cones: listOf(cone), turnings: listOf(index), handles: listOf(index) }, // prettier-ignore
      features: maybe(() => ({ hasCreases: random() < 0.5, hasRims: random() < 0.5, edges: listOf(() => [below(99), below(99)]), rims: [], isSymmetric: random() < 0.5, keepsCones: random() < 0.5 })), // prettier-ignore
      camera: maybe(() => '1,2,3,-4,5.5,0'),
      model: modelTag({ file: { sha256: `c0ffee${10 + below(90)}11` }, surface: below(3) }),
    };
    const { hash, omitted } = writeHash(source);
    const read = readHash(hash);
    assert.deepEqual(omitted, []);
    const { prescription, features } = source;
    const said = (list) => list.flatMap((n, at) => (n === null ? [] : [[at, n]]));
    const orNone = (list) => (list.length > 0 ? list : undefined);
    for (const key of ['example', 'camera']) assert.equal(read[key], source[key], key);
    for (const key of ['pattern', 'overlay', 'tiles']) if (key !== 'overlay' || source.look.overlay !== 'none') assert.equal(read[key], source.look[key], key); // prettier-ignore
    for (const key of ['improve', 'timeLimit']) assert.equal(read[key], source.solve[key], key);
    assert.equal(read.rounds ?? solve.rounds, source.solve.rounds);
    assert.deepEqual({ cells: undefined, ...(read.grid ?? solve.grid) }, grid);
    assert.equal(read.q, prescription.q);
    assert.deepEqual(read.cones, orNone(prescription.cones));
    assert.deepEqual([read.turnings, read.handles], [orNone(said(prescription.turnings)), orNone(said(prescription.handles))]); // prettier-ignore
    const { hasCreases = false, hasRims = false, edges = [], isSymmetric = false, keepsCones = false } = features ?? {}; // prettier-ignore
    const hasLines = edges.length > 0 || hasRims || isSymmetric;
    const lines = { hasCreases: hasCreases && edges.length > 0, hasRims, edges, ...(isSymmetric ? { isSymmetric } : {}), ...(keepsCones && prescription.cones.length > 0 ? { keepsCones } : {}) }; // prettier-ignore
    assert.deepEqual(read.features, hasLines ? lines : undefined);
    const isOfModel = hasLines || [read.cones, read.turnings, read.handles].some(Boolean);
    assert.equal(read.model, isOfModel ? source.model : undefined);
  }
});

test('a list with one item that is none of its kind is not taken, wherever the item is', () => {
  const good = { cones: [[0, 1], [5, 3, 0], [7, 4, 2]], turnings: [[0, -3], [2, 5]], handles: [[0, 0], [1, 3]], edges: [[0, 1], [4, 2]] }; // prettier-ignore
  const wrong = {
    cones: [[-1, 3], [3, 0], [3, -1], [3, 1, -1], [3, 1, 2, 4]],
    turnings: [[1, 2, 3]],
    handles: [[1, 2, 3]],
    edges: [[-1, 2], [2, -1], [1, 2, 3]],
  }; // prettier-ignore
  const none = [[1], [], 5, null, 'x', {}, [1, 2.5], [1, '2'], [1, null], [1, 2 ** 53]];
  const read = (key, list) => readHash(`#${key}=${encoded(list)}`);
  const taken = (key, list) => (key === 'edges' ? read(key, list).features?.edges : read(key, list)[key]); // prettier-ignore
  for (const [key, list] of Object.entries(good)) {
    assert.equal(taken(key, list).length, list.length, key);
    for (const bad of [...wrong[key], ...none])
      for (let at = 0; at <= list.length; at++)
        assert.equal(taken(key, list.toSpliced(at, 0, bad)), undefined, `${key}: ${JSON.stringify(bad)} at ${at}`); // prettier-ignore
    for (const text of ['{}', '5', 'null', '[[1,2]', '']) assert.equal(taken(key, text), undefined, `${key}: ${text}`); // prettier-ignore
    for (const text of ['%', '!!', '[[1,2]]', '']) assert.equal(readHash(`#${key}=${encodeURIComponent(text)}`)[key], undefined); // prettier-ignore
  }
});

test('each number of a link has its least and its largest value, each word its length, each list its room', () => {
  const ranges = { q: [1, 64], rounds: [1, 1000], limit: [1, 10 ** 6], tiles: [1, 1000], improve: [-1, 1] }; // prettier-ignore
  const names = { limit: 'timeLimit' };
  for (const [key, [low, high]] of Object.entries(ranges)) {
    const taken = (n) => readHash(`#${key}=${n}`)[names[key] ?? key];
    for (const n of [low, high]) assert.equal(taken(n), n, key);
    const step = key === 'improve' ? 1e-9 : 1;
    for (const n of [low - step, high + step, 'x', NaN]) assert.equal(taken(n), undefined, `${key}=${n}`); // prettier-ignore
    assert.equal(readHash('#')[names[key] ?? key], undefined);
  }
  for (const [cells, is] of [
    [0, undefined],
    [1, 1],
    [10 ** 6, 10 ** 6],
    [10 ** 6 + 1, undefined],
  ])
    // prettier-ignore
    assert.equal(readHash(`#grid=tile&cells=${cells}`).grid.cells, is);
  const words = {
    example: [['a', 'x'.repeat(40)], ['', 'x'.repeat(41), 'A', 'a/b']],
    model: [['0123abcd.0', '0123abcd.123456789'], ['0123abc.0', '0123abcde.0', '0123abcd.', '0123abcd.1234567890', '0123abcD.0']],
  }; // prettier-ignore
  for (const [key, [good, bad]] of Object.entries(words)) {
    for (const word of good) assert.equal(readHash(`#${key}=${word}`)[key], word);
    for (const word of bad) assert.equal(readHash(`#${key}=${word}`)[key], undefined, word);
  }
  // A list of this many signs and no more, for reading as for writing.
  const room = 8192;
  const written = (cones) => writeHash({ look, solve, prescription: { q: 4, cones, turnings: [], handles: [] } }); // prettier-ignore
  const cones = Array.from({ length: 900 }, (_, i) => ({ vertex: 10 + (i % 80), k: 3 }));
  const lengthOf = (all) => encoded(all.map(({ vertex, k }) => [vertex, k])).length;
  while (lengthOf(cones) > room - 16) cones.pop();
  for (let i = 0; lengthOf(cones) < room; i++) cones[i].vertex *= 10;
  assert.equal(lengthOf(cones), room);
  assert.equal(readHash(written(cones).hash).cones?.length, cones.length);
  const longer = cones.map((one, i) => (i < 700 ? one : { ...one, vertex: 10 * one.vertex }));
  assert.ok(lengthOf(longer) > room);
  assert.deepEqual(written(longer).omitted, [`${cones.length} cones`]);
  const text = encoded(longer.map(({ vertex, k }) => [vertex, k]));
  assert.equal(readHash(`#cones=${text}`).cones, undefined);
});
