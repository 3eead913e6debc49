// Laws of what updates the views: they end as if the document had always been as it is, nothing is shown twice, no change
// is lost, whatever fails or comes too late.

import assert from 'node:assert/strict';
import test from 'node:test';
import { BufferGeometry } from 'three';
import { storeOf } from '../../../web/src/model/store.ts';
import { ViewUpdates } from '../../../web/src/views/view_updates.ts';
import { randomFrom } from '../../mutation/draw.mjs';
import { cubeMesh, toGltf } from '../../support/meshes.mjs';
import { replace } from '../../support/replaced.mjs';

const turn = () => new Promise((resolve) => setTimeout(resolve, 2));
const surfaceOf = (id, triangles = 2) => ({ id, diagonal: 2, triangles: new Uint32Array(3 * triangles) }); // prettier-ignore
const modelOf = (id, more) => ({ main: 'a.obj', files: new Map(), matrix: [id], surface: surfaceOf(id, more), info: { surface: id, triangles: 2, usable: true, file: { format: 'obj' } } }); // prettier-ignore
function solutionOf(id, { flipped = [], isGood = true, q = 4 } = {}) {
  const certificate = { certified: isGood, usable: true, flipped: 0, triangles: 2, wrongAngles: 0, wrongTurnings: 0, brokenSeams: 0, seamEdges: 0, integerSeams: 0, overlap: { share: 0, layers: 1 }, stored: { verified: 2, triangles: 2, negative: 0, zero: 0, reversed: 0, duplicates: 0, zeroArea: 0, splitVertices: 0 }, components: [{ orientation: {}, distortion: {} }], q, precision: 'float32', maxConeDistance: 0, maxSeamResidual: 0, seamTolerance: 1 }; // prettier-ignore
  return { id, prescription: { q, cones: [] }, cornerUv: new Float32Array(6).fill(id), isSameAsFile: true, difference: '', written: { bytes: new Uint8Array(9) }, smallestArea: { area: 1, mean: 1, smallestPositive: 1, triangle: 0, negative: 0, zero: 0 }, distortion: { flipped: new Uint32Array(flipped), scale: { mean: 1 }, meanScale: 1 }, seams: [], chains: new Uint32Array(0), result: { certificate, report: { components: [{}], seconds: 1 } } }; // prettier-ignore
}
const look = { pattern: 'checker', overlay: 'none', tiles: 24, steps: 1, seams: 'auto', hasWire: false, light: 'studio' }; // prettier-ignore
const empty = { model: undefined, displayed: undefined, current: undefined, look, live: undefined, prescription: { q: 4, cones: [] }, selected: -1, budget: undefined, meshes: new Map(), parts: [], quads: undefined, features: undefined }; // prettier-ignore

/** The views, each call of which is noted; `act` may do something at a call. */
function sight(name, calls, act) {
  const note = (method) => (...all) => {
    calls.push([`${name}.${method}`, ...all]);
    return act?.(`${name}.${method}`, ...all);
  }; // prettier-ignore
  return new Proxy(
    { canvas: { dataset: {} }, marks: { setFeatures: note('setFeatures') } },
    { get: (own, key) => own[key] ?? note(key) },
  );
}

/** Updates of a document with these members; what its geometry is asked is answered at once, or when `held` ends. */
function updated(t, { doc: members = {}, ui: settings = {}, act, held } = {}) {
  const body = { dataset: {} };
  replace(t, 'document', { body });
  const [calls, said, asked] = [[], [], []];
  const doc = new (storeOf())({ ...empty, ...members });
  Object.defineProperty(doc, 'say', { value: (...all) => said.push(all) });
  const ui = new (storeOf())({ isDark: false, tool: 'orbit', wipe: 0, ...settings });
  const call = async (method, args) => {
    asked.push([method, ...args]);
    const lines = { onSurface: [method, ...args, 1], inMap: [method, ...args, 2] };
    await held?.();
    return method === 'crosses' ? lines : [method, ...args];
  };
  const [model, uv] = ['model', 'uv'].map((name) => sight(name, calls, act));
  new ViewUpdates({ doc, ui, geometry: { call }, model, uv, onSurface: () => calls.push(['onSurface']) }); // prettier-ignore
  const settled = async () => {
    for (let i = 0; i < 1000 && (i < 2 || 'pending' in body.dataset); i++) await turn();
    assert.ok(!('pending' in body.dataset), 'comes to rest');
  };
  const named = (name) => calls.filter(([one]) => one === name).map(([, ...all]) => all);
  return { doc, ui, calls, said, asked, body, settled, named, canvases: [model.canvas, uv.canvas] };
}

/**
 * What each method was told last; without materials of a file it does not matter of which mesh there are none, and
 * whether a model came of the same file is of the past.
 */
const lastOf = (calls) => new Map(calls.filter(([name]) => !/draw|onSurface|setOriginal/.test(name)).map(([name, ...all]) => [name, name === 'model.setModel' ? all.slice(0, 2) : all])); // prettier-ignore

test('after any changes, in whatever order, the views are told what a new page would tell them', async (t) => {
  const random = randomFrom(12);
  const pick = (all) => all[Math.floor(random() * all.length)];
  const models = [undefined, modelOf(1), modelOf(2), modelOf(3, 40_000)];
  const solutions = [undefined, solutionOf(1), solutionOf(2, { q: 6 }), solutionOf(3, { flipped: [1], isGood: false })]; // prettier-ignore
  const shape = {};
  const choices = {
    model: models,
    displayed: solutions,
    current: solutions,
    live: [undefined, { state: 'heat' }, { state: 'map' }],
    prescription: [
      { q: 4, cones: [] },
      { q: 6, cones: [{ vertex: 1, k: 3 }] },
    ],
    selected: [-1, 0],
    budget: [undefined, { cones: [{ isGood: false }, { isGood: true }] }],
    meshes: [new Map(), new Map([[7, { model: modelOf(7), solutions: [solutions[1], solutions[2]] }], [8, { model: modelOf(8), solutions: [] }]])], // prettier-ignore
    parts: [[], [{ mesh: 7 }]],
    quads: [undefined, { of: solutions[1], isShown: true, shape }, { of: solutions[1], isShown: false, shape }, { of: solutions[2], isShown: true, shape }], // prettier-ignore
    features: [undefined, { edges: [[1, 2]], rims: [[3, 4]] }, { edges: [[5, 6]] }],
    look: ['checker', 'cross', 'material', 'image'].flatMap((pattern) => ['none', 'area', 'flips'].flatMap((overlay) => [8, 24].map((tiles) => ({ ...look, pattern, overlay, tiles })))), // prettier-ignore
  };
  const settings = { isDark: [false, true], tool: ['orbit', 'place'], wipe: [0, 40] };
  const one = updated(t);
  for (let round = 0; round < 60; round++) {
    for (let changes = 1 + Math.floor(4 * random()); changes > 0; changes--) {
      const of = random() < 0.2 ? [one.ui, settings] : [one.doc, choices];
      const name = pick(Object.keys(of[1]));
      of[0][name] = pick(of[1][name]);
    }
    // With or without a pause between the changes.
    if (random() < 0.3) continue;
    await one.settled();
    const fresh = updated(t, { doc: { ...one.doc }, ui: { ...one.ui } });
    await fresh.settled();
    const last = lastOf(one.calls);
    for (const [name, told] of lastOf(fresh.calls)) assert.deepEqual(last.get(name), told, `${round}: ${name}`); // prettier-ignore
    assert.deepEqual(one.canvases, fresh.canvases);
    assert.deepEqual([one.said, fresh.said], [[], []]);
  }
});

test('what has not changed is not shown again; a view has its model before it has anything else', async (t) => {
  const members = { model: modelOf(1), displayed: solutionOf(1), look: { ...look, pattern: 'cross', overlay: 'area' } }; // prettier-ignore
  const one = updated(t, { doc: members });
  await one.settled();
  for (const view of ['model', 'uv']) {
    const own = one.calls.map(([name]) => name).filter((name) => name.startsWith(`${view}.`));
    assert.equal(own[0], `${view}.setModel`);
    assert.ok(own.includes(`${view}.setCrosses`) && own.includes(`${view}.setOverlay`));
    for (const name of ['setModel', 'setLook', 'setCones', 'setCrosses', 'setOverlay'])
      assert.equal(own.filter((each) => each === `${view}.${name}`).length, name === 'setLook' ? 2 : 1, name); // prettier-ignore
  }
  const { length } = one.calls;
  const { model, displayed } = one.doc;
  for (const change of [
    () => (one.doc.selected = -1),
    () => ([one.doc.model, one.doc.model] = [undefined, model]),
    () => ([one.doc.displayed, one.doc.displayed] = [undefined, displayed]),
    () => (one.ui.tool = 'place'),
  ]) {
    change();
    await one.settled();
    assert.deepEqual(one.calls.slice(length), []);
  }
});

test('a surface is new once, and of the same file as long as its files are the same', async (t) => {
  const files = new Map();
  const one = updated(t);
  const show = async (model) => {
    one.calls.length = 0;
    one.doc.model = model;
    await one.settled();
    const [[, , about]] = one.named('model.setModel');
    return [about.isSameFile, one.named('onSurface').length];
  };
  const first = { ...modelOf(1), files };
  assert.deepEqual(await show(first), [false, 1]);
  assert.deepEqual(await show({ ...modelOf(2), files }), [true, 1]);
  assert.deepEqual(await show({ ...first, surface: surfaceOf(3) }), [true, 1]);
  assert.deepEqual(await show({ ...first, files: new Map() }), [false, 1]);
  assert.deepEqual(await show(undefined), [false, 1]);
  one.calls.length = 0;
  one.doc.displayed = solutionOf(4);
  await one.settled();
  assert.equal(one.named('onSurface').length, 0, 'another map, not another surface');
});

test('trees for picking come from the worker for large surfaces: once for each, and for each of their maps', async (t) => {
  for (const [triangles, isLarge] of [
    [30_000, false],
    [30_001, true],
  ]) {
    // prettier-ignore
    const one = updated(t);
    const trees = () => one.asked.splice(0).filter(([name]) => /Bvh/.test(name));
    one.doc.model = { ...modelOf(1), surface: { ...surfaceOf(1), triangles: { length: triangles } } }; // prettier-ignore
    await one.settled();
    assert.deepEqual(trees(), isLarge ? [['surfaceBvh', 1]] : []);
    one.doc.displayed = solutionOf(5);
    await one.settled();
    assert.deepEqual(trees(), isLarge ? [['mapBvh', 5]] : []);
    const { model, displayed } = one.doc;
    assert.deepEqual(one.named('model.setBvh'), isLarge ? [[model.surface, ['surfaceBvh', 1]]] : []); // prettier-ignore
    assert.deepEqual(one.named('uv.setBvh'), isLarge ? [[displayed, ['mapBvh', 5]]] : []);
  }
});

test('a view that fails is told of once, and all others are updated', async (t) => {
  t.mock.method(console, 'warn', () => undefined);
  for (const bad of [
    'model.setModel',
    'uv.setLook',
    'model.setCones',
    'model.setScene',
    'model.setWipe',
    'model.setOverlay',
    'uv.setCrosses',
  ]) {
    // prettier-ignore
    const members = { model: modelOf(1), displayed: solutionOf(1), look: { ...look, pattern: 'cross', overlay: 'area' } }; // prettier-ignore
    const good = updated(t, { doc: members });
    await good.settled();
    const act = (name) => {
      if (name === bad) throw new Error(`no ${bad}`);
    };
    const one = updated(t, { doc: members, act });
    await one.settled();
    assert.ok(one.said.length > 0 && one.said.every(([text, kind]) => text.includes(`no ${bad}`) && kind === 'error'), bad); // prettier-ignore
    const [[view]] = [bad.split('.')];
    const others = (calls) => calls.filter(([name]) => !name.startsWith(`${view}.`) && !/setModel|Overlay|Crosses|setLook|setCones/.test(name)).map(([name]) => name); // prettier-ignore
    assert.deepEqual(others(one.calls), others(good.calls), bad);
    one.doc.features = { edges: [], rims: [] };
    one.said.length = 0;
    await one.settled();
    assert.deepEqual(one.said, [], 'later changes of something else do not fail');
  }
});

test('what was asked of the worker for a map or a look that is gone is not shown; the page waits for it', async (t) => {
  const waiting = [];
  const held = () => new Promise((resolve) => waiting.push(resolve));
  const first = { ...look, pattern: 'cross', overlay: 'area', tiles: 8 };
  const changes = {
    'another map': { displayed: solutionOf(2) },
    'another overlay': { look: { ...first, overlay: 'stretch' } },
    'more tiles': { look: { ...first, tiles: 20 } },
    'no crosses': { look: { ...first, pattern: 'checker' } },
    'no map': { displayed: undefined },
  };
  for (const [what, change] of Object.entries(changes)) {
    const one = updated(t, { doc: { model: modelOf(1), displayed: solutionOf(1), look: first }, held }); // prettier-ignore
    for (let i = 0; i < 4; i++) await turn();
    assert.ok('pending' in one.body.dataset && waiting.length === 2, what);
    Object.assign(one.doc, change);
    for (let i = 0; i < 4; i++) await turn();
    // The later answers come before the earlier ones.
    for (const answer of waiting.splice(0).reverse()) {
      answer();
      await turn();
    }
    await one.settled();
    const now = updated(t, { doc: { ...one.doc } });
    await now.settled();
    for (const name of ['model.setOverlay', 'uv.setOverlay', 'model.setCrosses', 'uv.setCrosses']) {
      const [is, wanted] = [one, now].map((page) => page.named(name).at(-1));
      if (wanted) assert.deepEqual(is, wanted, `${what}: ${name}`);
      if (change.displayed !== undefined) assert.ok(!one.named(name).some(([of]) => of?.[1] === 1), `${what}: ${name}`); // prettier-ignore
    }
  }
});

test('colours of an overlay are asked for where there are some, flipped triangles, or those of before are to go', async (t) => {
  const one = updated(t, { doc: { model: modelOf(1) } });
  const asks = async (members) => {
    Object.assign(one.doc, members);
    await one.settled();
    return one.asked.splice(0).map(([name, ...all]) => `${name} ${all}`);
  };
  const [plain, area] = ['none', 'area'].map((overlay) => ({ ...look, overlay }));
  const [first, second, folded] = [solutionOf(1), solutionOf(2), solutionOf(3, { flipped: [0] })];
  assert.deepEqual(await asks({ displayed: first, look: plain }), []);
  assert.deepEqual(await asks({ look: area }), ['overlay 1,area']);
  assert.deepEqual(await asks({ look: plain }), ['overlay 1,none'], 'those of before go');
  assert.deepEqual(await asks({ displayed: second }), []);
  assert.deepEqual(await asks({ displayed: folded }), ['overlay 3,none'], 'what is flipped is red');
  assert.deepEqual(await asks({ displayed: undefined }), []);
});

test('updates that take long are made in several tasks, none left out and none twice; a change starts anew', async (t) => {
  let clock = 0;
  t.mock.method(performance, 'now', () => clock);
  const members = { model: modelOf(1), displayed: solutionOf(1), look: { ...look, pattern: 'cross' } }; // prettier-ignore
  const all = updated(t, { doc: members });
  await all.settled();
  const names = (calls) => calls.filter(([name]) => !/Crosses/.test(name)).map(([name]) => name);
  const one = updated(t, { doc: members, act: () => void (clock += 100) });
  let [tasks, seen] = [0, 0];
  for (let i = 0; i < 200 && 'pending' in one.body.dataset; i++) {
    await new Promise((resolve) => setTimeout(resolve));
    if (one.calls.length > seen) tasks += 1;
    seen = one.calls.length;
  }
  assert.ok(tasks > 6, `${tasks} tasks`);
  assert.deepEqual(names(one.calls), names(all.calls));
  // In the midst of it the look changes.
  const other = updated(t, { doc: members, act: () => void (clock += 100) });
  await new Promise((resolve) => setTimeout(resolve));
  other.doc.look = { ...other.doc.look, tiles: 99 };
  await other.settled();
  assert.deepEqual(names(other.calls).sort(), names(all.calls).sort());
  assert.deepEqual(
    other.named('model.setLook').map(([{ tiles }]) => tiles),
    [99, 99],
  );
  // What takes no time is one task.
  const quick = updated(t, { doc: members });
  await new Promise((resolve) => setTimeout(resolve));
  assert.deepEqual(names(quick.calls), names(all.calls));
});

test('no task of updates takes longer than a frame when each of its steps is short', async (t) => {
  let clock = 0;
  t.mock.method(performance, 'now', () => clock);
  const members = { model: modelOf(1), displayed: solutionOf(1), look: { ...look, pattern: 'cross' } }; // prettier-ignore
  const one = updated(t, { doc: members, act: () => void (clock += 1) });
  let longest = 0;
  for (let i = 0; i < 200 && 'pending' in one.body.dataset; i++) {
    const begin = clock;
    await new Promise((resolve) => setTimeout(resolve));
    longest = Math.max(longest, clock - begin);
  }
  assert.ok(clock > 1000 / 60, 'all of them take longer');
  assert.ok(longest <= 1000 / 60, `${longest} milliseconds`);
});

test('beside the open mesh every other one has its last map, in a pattern that it can have', async (t) => {
  const [a, b, c] = [solutionOf(1), solutionOf(2, { isGood: false, q: 6 }), solutionOf(3)];
  const meshes = new Map([[7, { model: modelOf(7), solutions: [a, b] }], [8, { model: modelOf(8), solutions: [] }]]); // prettier-ignore
  for (const pattern of ['checker', 'image', 'material', 'hex']) {
    const one = updated(t, { doc: { model: modelOf(3), displayed: c, meshes, look: { ...look, pattern } } }); // prettier-ignore
    await one.settled();
    const [{ maps, open, isOwnShown }] = one.named('model.setScene').at(-1);
    assert.deepEqual([open, isOwnShown], [3, pattern === 'material']);
    if (pattern === 'material') {
      assert.equal(maps.size, 0);
      continue;
    }
    assert.deepEqual([...maps.keys()].sort(), [3, 7]);
    for (const [mesh, of] of [
      [3, c],
      [7, b],
    ]) {
      // prettier-ignore
      const map = maps.get(mesh);
      assert.equal(map.cornerUv, of.cornerUv);
      assert.deepEqual([map.pattern, map.q, map.isCertified], [pattern === 'image' ? 'checker' : pattern, of.prescription.q, of !== b]); // prettier-ignore
    }
  }
  const none = updated(t);
  await none.settled();
  assert.equal(none.named('model.setScene').at(-1)[0].open, -1);
});

/** A glTF in one text, and a model of it. */
function gltfText() {
  const { json, bin } = toGltf([cubeMesh(1)]);
  json.buffers[0].uri = `data:application/octet-stream;base64,${Buffer.from(bin).toString('base64')}`; // prettier-ignore
  return JSON.stringify(json);
}
const gltfInfo = { surface: 1, triangles: 2, usable: true, file: { format: 'gltf' } };
const file = (text) => ({ ...modelOf(1), info: gltfInfo, main: 'a.gltf', files: new Map([['a.gltf', new Blob([text])]]) }); // prettier-ignore
function letRead(t) {
  replace(t, 'self', globalThis);
  replace(t, 'ProgressEvent', globalThis.ProgressEvent ?? class extends Event {});
}

test('materials of a file are freed when others take their place or there are none, not before; those that come late, at once', async (t) => {
  letRead(t);
  const good = gltfText();
  const open = () => ({ model: { ...file(good), info: { ...gltfInfo, surface: 0 } }, parts: [{ mesh: 0, matrices: [[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]] }] }); // prettier-ignore
  const freed = [];
  t.mock.method(BufferGeometry.prototype, 'dispose', function dispose() {
    freed.push(this);
  });
  const own = ({ group }) => {
    const found = [];
    group.traverse(({ geometry }) => geometry && found.push(geometry));
    assert.ok(found.length > 0);
    return found;
  };
  const one = updated(t, { doc: open() });
  const shown = () => [...new Set(one.named('model.setOriginal').map(([scene]) => scene))].filter(Boolean); // prettier-ignore
  const displayed = { ...solutionOf(1), files: [{ name: 'a.gltf', bytes: new TextEncoder().encode(good) }] }; // prettier-ignore
  const steps = [
    () => Object.assign(one.doc, open()),
    () => Object.assign(one.doc, { displayed, look: { ...look, pattern: 'material' } }),
    () => Object.assign(one.doc, open(), { displayed: undefined, look }),
  ];
  await one.settled();
  for (const [i, step] of steps.entries()) {
    assert.equal(shown().length, i + 1);
    const last = own(shown().at(-1));
    assert.ok(
      last.every((geometry) => !freed.includes(geometry)),
      'it is shown',
    );
    step();
    await one.settled();
    assert.ok(
      last.every((geometry) => freed.includes(geometry)),
      'another one is',
    );
  }
  const last = own(shown().at(-1));
  one.doc.model = undefined;
  await one.settled();
  assert.ok(
    last.every((geometry) => freed.includes(geometry)),
    'none is',
  );
  assert.equal(shown().length, steps.length + 1);
  assert.equal(new Set(freed).size, freed.length, 'each once');
  assert.equal(freed.length, shown().flatMap(own).length);
  // One that is replaced while it is read is never shown.
  let goOn;
  const isReplaced = new Promise((resolve) => (goOn = resolve));
  const slow = open();
  const blob = slow.model.files.get('a.gltf');
  let asked = 0;
  blob.arrayBuffer = async () => {
    asked += 1;
    await isReplaced;
    return Blob.prototype.arrayBuffer.call(blob);
  };
  Object.assign(one.doc, slow);
  while (asked === 0) await turn();
  Object.assign(one.doc, open());
  for (let i = 0; i < 5; i++) await turn();
  goOn();
  await one.settled();
  assert.equal(shown().length, steps.length + 2);
  const late = freed.slice(shown().slice(0, -1).flatMap(own).length);
  assert.ok(late.length > 0 && !late.some((geometry) => shown().flatMap(own).includes(geometry)));
});

test('materials that cannot be read are told of where they were asked for; elsewhere the shape is shown without them', async (t) => {
  letRead(t);
  const info = gltfInfo;
  const good = gltfText();
  for (const [pattern, isTold] of [
    ['checker', false],
    ['material', true],
  ]) {
    // prettier-ignore
    const one = updated(t, { doc: { model: file('not a glTF'), look: { ...look, pattern } } });
    await one.settled();
    assert.equal(one.said.length, isTold ? 1 : 0, pattern);
    if (isTold) assert.equal(one.said[0][1], 'error');
    assert.ok(one.named('model.setOriginal').every(([scene]) => scene === undefined));
  }
  // Before there is a map they are shown of a model that is not large, afterwards where they are asked for.
  const isShown = async (members, triangles = 2) => {
    const model = { ...file(good), info: { ...info, surface: 0, triangles } };
    const one = updated(t, { doc: { model, parts: [{ mesh: 0, matrices: [] }], ...members } });
    await one.settled();
    const [scene, mesh, shown] = one.named('model.setOriginal').at(-1);
    assert.deepEqual([one.said, mesh], [[], 0]);
    return [scene !== undefined, shown];
  };
  const material = { ...look, pattern: 'material' };
  const displayed = { ...solutionOf(1), files: [{ name: 'a.gltf', bytes: new TextEncoder().encode(good) }] }; // prettier-ignore
  assert.deepEqual(await isShown({}), [true, true]);
  assert.deepEqual(await isShown({ displayed }), [true, false]);
  assert.deepEqual(await isShown({ displayed, look: material }), [true, true]);
  assert.deepEqual(await isShown({}, 300_000), [true, true]);
  assert.deepEqual(await isShown({}, 300_001), [false, false]);
  assert.deepEqual(await isShown({ look: material }, 300_001), [true, true]);
});
