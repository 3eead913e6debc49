// Small parts of the package by themselves: how a call is asked to stop, how progress is passed on, how a mesh is split along
// the seams of its map, and in which form options go to the core.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { resolveObjectURL } from 'node:buffer';
import path from 'node:path';
import test from 'node:test';
import { randomFrom } from '../mutation/draw.mjs';
import { replace } from '../support/replaced.mjs';
import { cubeMesh, toGlb } from '../support/meshes.mjs';
import { asFiles, built, bytesOf, createCore, HgpError } from './support.mjs';

const part = (name) => import(path.join(built, `lib/${name}`));
const { Stopper, stopTest } = await part('leash.js');
const { progressCall } = await part('progress_call.js');
const { splitAlongSeams } = await part('split.js');
const { phrase } = await part('phrases.js');
const { toGlb: minimalGlb } = await part('glb.js');
const { filesOf, forCore, listFile } = await part('to_core.js');

/** Requests that read Blobs of this process, and how many there were. */
function withRequests(t, isAllowed = () => true) {
  const reads = [];
  replace(t, 'XMLHttpRequest', class {
    open(method, url, isAsync) {
      assert.deepEqual([method, isAsync], ['GET', false]);
      this.url = url;
    }
    send() {
      reads.push(this.url);
      if (!isAllowed() || !resolveObjectURL(this.url)) throw new Error('cannot be read');
    }
  }); // prettier-ignore
  return reads;
}

test('a call on a leash of shared memory stops when it is asked to, and no other does', () => {
  const [one, other] = [new Stopper(), new Stopper()];
  assert.ok('shared' in one.leash);
  const [isStopped, isOtherStopped] = [one, other].map(({ leash }) => stopTest(leash));
  assert.deepEqual([isStopped(), isOtherStopped()], [false, false]);
  one.stop();
  one.stop();
  assert.deepEqual([isStopped(), isStopped(), isOtherStopped()], [true, true, false]);
});

test('without shared memory a call looks every few hundredths of a second, not more often, and not after it was stopped', async (t) => {
  replace(t, 'crossOriginIsolated', false);
  let clock = 0;
  t.mock.method(performance, 'now', () => clock);
  const reads = withRequests(t);
  const { Stopper: Own, stopTest: test } = await part('leash.js?isolated');
  const stopper = new Own();
  assert.ok('url' in stopper.leash && !('shared' in stopper.leash));
  const isStopped = test(stopper.leash);
  reads.length = 0;
  for (; clock < 1000; clock += 1) assert.equal(isStopped(), false);
  assert.ok(reads.length >= 20 && reads.length <= 101, `${reads.length} looks in a second`);
  assert.ok(reads.every((url) => url === stopper.leash.url));
  stopper.stop();
  let waited = 0;
  for (; !isStopped(); waited++) clock += 1;
  assert.ok(waited <= 50, `${waited} milliseconds`);
  const { length } = reads;
  for (; clock < 3000; clock += 7) assert.equal(isStopped(), true);
  assert.equal(reads.length, length);
  // It is the leash of one call.
  const next = new Own();
  assert.equal(test(next.leash)(), false);
});

test('where a Blob cannot be read, or nothing can, a call goes on to its end', async (t) => {
  replace(t, 'crossOriginIsolated', false);
  const freed = [];
  t.mock.method(URL, 'revokeObjectURL', (url) => freed.push(url));
  for (const [name, isThere] of [
    ['forbidden', true],
    ['none', false],
  ]) {
    // prettier-ignore
    const reads = isThere ? withRequests(t, () => false) : (replace(t, 'XMLHttpRequest', undefined), []); // prettier-ignore
    const { Stopper: Own, stopTest: test } = await part(`leash.js?${name}`);
    const stopper = new Own();
    const isStopped = test(stopper.leash);
    stopper.stop();
    assert.deepEqual([isStopped(), isStopped()], [false, false]);
    assert.equal(test(new Own().leash)(), false);
    assert.equal(reads.length, isThere ? 1 : 0, 'asked once');
    assert.deepEqual(new Set(freed.splice(0)), new Set([...reads, stopper.leash.url]));
  }
});

test('shared memory is used on isolated pages and where that word is unknown, and nowhere else', async (t) => {
  for (const [isIsolated, hasMemory, isShared] of [
    [true, true, true],
    [undefined, true, true],
    [false, true, false],
    [true, false, false],
  ]) {
    // prettier-ignore
    replace(t, 'crossOriginIsolated', isIsolated);
    const own = globalThis.SharedArrayBuffer;
    if (!hasMemory) replace(t, 'SharedArrayBuffer', undefined);
    assert.equal('shared' in new Stopper().leash, isShared, `${isIsolated} ${hasMemory}`);
    globalThis.SharedArrayBuffer = own;
  }
});

const hasPrintf = spawnSync('printf', ['1'], { encoding: 'utf8' }).stdout === '1';
test(
  'numbers in sentences are those of printf, also in the middle of two, at powers of ten and for zero',
  { skip: hasPrintf ? false : 'no printf' },
  () => {
    const random = randomFrom(7);
    const values = [0, 1, 2.5, 3.5, 6.25, 6.75, 0.125, 0.375, 9.5, 95, 99.5, 0.5, 1.5, 1e5, 999999.5, 1e-4, 9.9999e-5, 0.00012345, 123456789, 1e20, 2 ** -40]; // prettier-ignore
    for (let i = 0; i < 60; i++) {
      values.push((10 ** (24 * random() - 12)).valueOf(), Math.round(1000 * random()) / 8);
      values.push(Number((10 ** (8 * random() - 4)).toPrecision(1 + Math.floor(4 * random()))));
    }
    for (const x of [...values]) values.push(-x);
    for (const format of [
      '.0f',
      '.1f',
      '.3f',
      '.2e',
      '.0e',
      'g',
      '.1g',
      '.2g',
      '.3g',
      '.4g',
      '.10g',
    ]) {
      const texts = values.map((n) => phrase({ code: 'x', numbers: { n }, words: {}, where: [] }, { x: `{n:${format}}` })); // prettier-ignore
      // All digits of a number, which printf would read as a longer one.
      const exact = values.map((n) => n.toPrecision(100));
      const env = { ...process.env, LC_ALL: 'C' };
      const { stdout } = spawnSync('printf', [`%${format}\\n`, ...exact], { encoding: 'utf8', env }); // prettier-ignore
      const expected = stdout.trimEnd().split('\n');
      values.forEach((n, i) => assert.equal(texts[i], expected[i], `${n} as ${format}`)); // prettier-ignore
    }
  },
);

test('progress is passed on by name, and only the answer false ends a call', () => {
  assert.equal(progressCall(undefined), undefined);
  const told = [];
  for (const answer of [undefined, null, 0, '', true, false]) {
    const call = progressCall((progress) => (told.push(progress), answer));
    assert.equal(call('frames', 0.25, 3, 1e-5, 2, 12), answer !== false, `${answer}`);
  }
  for (const one of told) assert.deepEqual(one, { stage: 'frames', fraction: 0.25, iteration: 3, residual: 1e-5, round: 2, maxRounds: 12 }); // prettier-ignore
});

test('a mesh is split so that each of its corners keeps its vertex and its place in the map, with no copy too many', () => {
  const random = randomFrom(4);
  for (let round = 0; round < 100; round++) {
    const vertexCount = 3 + Math.floor(12 * random());
    const corners = 3 * Math.floor(12 * random());
    const triangles = Uint32Array.from({ length: corners }, () => Math.floor(vertexCount * random())); // prettier-ignore
    // Up to four places in the map for each vertex.
    const cornerToUv = triangles.map((v) => 4 * v + Math.floor((1 + (v % 4)) * random()));
    const { index, vertexOf, uvOf } = splitAlongSeams(triangles, cornerToUv, vertexCount);
    assert.equal(index.length, corners);
    index.forEach((v, c) =>
      assert.deepEqual([vertexOf[v], uvOf[v]], [triangles[c], cornerToUv[c]]),
    );
    const used = new Set(triangles);
    const unused = vertexCount - used.size;
    assert.equal(vertexOf.length, new Set(cornerToUv).size + unused, 'one for each place');
    assert.equal(uvOf.length, vertexOf.length);
    for (let v = 0; v < vertexCount; v++) {
      assert.equal(vertexOf[v], v, 'the first copy is the vertex itself');
      assert.equal(uvOf[v] === -1, !used.has(v));
    }
  }
});

test('a grid goes to the core as it was asked: a number of cells, a spacing, or neither; a mode of its own; all else as it is', () => {
  const other = { rounds: 3, improve: 'balance' };
  const cases = [
    [undefined, undefined],
    ['auto', { mode: 'tile' }],
    [{ cells: 'auto' }, { mode: 'tile' }],
    [{ cells: 'auto', mode: 'quad' }, { mode: 'quad' }],
    [{ cells: 'auto', spacing: 2, mode: 'quad' }, { mode: 'quad' }],
    [{ cells: 50 }, { cells: 50 }],
    [{ cells: 0 }, { cells: 0 }],
    [
      { cells: 50, mode: 'quad' },
      { cells: 50, mode: 'quad' },
    ],
    [{ spacing: 0.5 }, { spacing: 0.5 }],
    [
      { spacing: 0, mode: 'tile' },
      { spacing: 0, mode: 'tile' },
    ],
    [{ mode: 'quad' }, { mode: 'quad' }],
    [{}, {}],
  ];
  for (const [grid, core] of cases) {
    const given = { ...other, ...(grid === undefined ? {} : { grid }) };
    const before = structuredClone(given);
    assert.deepEqual(forCore(given), core === undefined ? other : { ...other, grid: core }, JSON.stringify(grid)); // prettier-ignore
    assert.deepEqual(given, before, 'what was given is not changed');
  }
});

test('features and fields are files to the core: those that are files stay, lists become one', () => {
  const list = { edges: [[1, 2]], rims: [0] };
  assert.deepEqual(listFile({ name: 'a.json', text: '{}' }), { name: 'a.json', text: '{}' });
  assert.deepEqual(listFile({ text: '' }), { name: '', text: '' });
  const { name, text } = listFile(list);
  assert.match(name, /\.json$/);
  assert.deepEqual(JSON.parse(text), { q: 4, features: list });
  assert.deepEqual(filesOf(), {});
  assert.deepEqual(filesOf({ name: 'f.rosy', text: 'x' }), { field: { name: 'f.rosy', text: 'x', q: 0 } }); // prettier-ignore
  assert.deepEqual(filesOf({ text: 'x', q: 6 }), { field: { name: '', text: 'x', q: 6 } });
  assert.deepEqual(filesOf(undefined, list), { features: listFile(list) });
  assert.deepEqual(Object.keys(filesOf({ text: '' }, { text: '' })), ['field', 'features']);
});

/** What a core has made in the memory of WebAssembly and not freed, by kind; nothing may be freed twice. */
function ownedBy({ module }) {
  const owned = new Map();
  const take = (kind, one) => {
    if (typeof one?.delete !== 'function') return one;
    owned.set(one, kind);
    const free = one.delete;
    one.delete = () => {
      assert.ok(owned.delete(one), `${kind} is freed once`);
      free.call(one);
    };
    return one;
  };
  const { Session } = module;
  for (const kind of ['Session', 'Drag', 'FileMaps']) {
    const construct = (of, all) => take(kind, Reflect.construct(of, all));
    module[kind] = new Proxy(module[kind], { construct });
  }
  const stored = Session.prototype.storedResult;
  Session.prototype.storedResult = function made() {
    return take('map', stored.call(this));
  };
  return () => [...owned.values()].sort();
}

test('all that a call makes in the memory of WebAssembly is freed with its handles, and whatever is refused leaves nothing', async () => {
  const core = await createCore();
  const owned = ownedBy(core);
  const bytes = new Uint8Array(toGlb([cubeMesh(3), cubeMesh(2)]));
  const files = asFiles('a.glb', bytes);
  const disk = { positions: [0, 0, 0, 1, 0, 0, 0, 1, 0], triangles: [0, 1, 2] };
  const refused = {
    'no file': () => core.load(asFiles('a.glb', bytes.slice(0, 40))),
    'no mesh of that number': () => core.load(files, { surface: 9 }),
    'no such vertex': () => core.loadMesh({ ...disk, triangles: [0, 1, 7] }),
    'an option': () => core.loadMesh(disk, { weld: 'x' }),
    'no cones': () => core.parametrizeMesh({ ...disk, cones: { q: 4, cones: [{ vertex: 0, k: 4 }, { vertex: 99, k: 4 }] } }), // prettier-ignore
    'a mesh that is not strict': () => core.parametrizeMesh({ positions: disk.positions, triangles: [0, 1, 2, 0, 1, 2], strict: true }), // prettier-ignore
    'no file of meshes': () => core.parametrizeFile(asFiles('a.obj', bytesOf('v 0 0 0\nf 1 2 3\n'))), // prettier-ignore
  };
  for (const [what, call] of Object.entries(refused)) {
    assert.throws(call, HgpError, what);
    assert.deepEqual(owned(), [], what);
  }
  core.parametrizeMesh(disk);
  core.parametrizeRendered(disk, {}, {});
  core.warmUp();
  core.parametrizeFile(files);
  assert.deepEqual(owned(), [], 'nothing was given');

  const model = core.load(files);
  const cones = model.suggestCones();
  assert.throws(() => model.parametrize({ cones: { ...cones, cones: [{ vertex: 0, k: 1 }] } }), HgpError); // prettier-ignore
  assert.deepEqual(owned(), ['Session']);
  const map = model.parametrize({ cones });
  assert.deepEqual(owned(), ['Session', 'map']);
  const [{ vertex }] = cones.cones;
  const plain = [...Array(20).keys()].find((v) => !cones.cones.some((cone) => cone.vertex === v));
  assert.throws(() => map.beginDrag(plain), HgpError);
  assert.deepEqual(owned(), ['Session', 'map']);
  const drag = map.beginDrag(vertex);
  assert.deepEqual(owned(), ['Drag', 'Session', 'map']);
  const dropped = drag.endDrag();
  assert.deepEqual(owned(), ['Session', 'map', 'map']);
  drag.free();
  const again = model.dragged({ cones }, [[vertex, [vertex]], [vertex, [vertex]]]); // prettier-ignore
  assert.deepEqual(owned(), ['Session', 'map', 'map', 'map']);
  const second = core.load(files, { surface: 1 - model.info.surface });
  const other = second.parametrize();
  const held = owned();
  core.combine([map, other]);
  assert.deepEqual(owned(), held);
  other.free();
  assert.throws(() => core.combine([map, other]), HgpError);
  for (const handle of [second, again, dropped, map, map, model, model]) handle.free();
  assert.deepEqual(owned(), []);
});

test('positions and triangles become a GLB that a reader finds whole: its chunks, its views, its bounds', () => {
  const random = randomFrom(5);
  for (let round = 0; round < 60; round++) {
    const count = 3 + Math.floor(9 * random());
    const positions = Array.from({ length: 3 * count }, () => 200 * random() - (round % 3) * 100);
    // The extremes are anywhere, at the first and the last place, too.
    const most = round % 2 === 0 ? 1000 : -1000;
    positions[[0, 1, 2, 3 * count - 1, 3 * count - 2, 3 * count - 3][round % 6]] = most;
    const triangles = Array.from({ length: 3 * (1 + (round % 4)) }, () => Math.floor(count * random())); // prettier-ignore
    const glb = minimalGlb(positions, triangles);
    const view = new DataView(glb.buffer, glb.byteOffset, glb.byteLength);
    const word = (at) => view.getUint32(at, true);
    const textBytes = word(12);
    assert.deepEqual(
      [word(0), word(4), word(8), word(16)],
      [0x46546c67, 2, glb.length, 0x4e4f534a],
    );
    assert.deepEqual([textBytes % 4, word(20 + textBytes), word(24 + textBytes)], [0, glb.length - 28 - textBytes, 0x004e4942]); // prettier-ignore
    const json = JSON.parse(new TextDecoder().decode(glb.subarray(20, 20 + textBytes)));
    assert.equal(json.buffers[0].byteLength, glb.length - 28 - textBytes);
    const [{ attributes, indices }] = json.meshes[0].primitives;
    const valuesOf = (accessor, Type, size) => {
      const { bufferView, count: n } = json.accessors[accessor];
      const { byteOffset = 0, byteLength } = json.bufferViews[bufferView];
      assert.equal(byteLength, 4 * size * n);
      const from = 28 + textBytes + byteOffset;
      return [...new Type(glb.slice(from, from + byteLength).buffer)];
    };
    const single = [...Float32Array.from(positions)];
    assert.deepEqual(valuesOf(attributes.POSITION, Float32Array, 3), single);
    assert.deepEqual(valuesOf(indices, Uint32Array, 1), triangles);
    const { min, max } = json.accessors[attributes.POSITION];
    const along = (i) => single.filter((_, at) => at % 3 === i);
    for (const i of [0, 1, 2]) assert.deepEqual([min[i], max[i]], [Math.min(...along(i)), Math.max(...along(i))]); // prettier-ignore
  }
});
