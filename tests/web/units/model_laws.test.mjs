// Laws of the page's values: what makes two of them the same, what each change of a document resets, what derived numbers are.

import assert from 'node:assert/strict';
import test from 'node:test';
import { effect } from '@preact/signals-core';
import { returnTo } from '../../../web/src/actions/compare_runs.ts';
import { compareRuns } from '../../../web/src/model/compare.ts';
import { Document } from '../../../web/src/model/document.ts';
import { loadOptionsOf } from '../../../web/src/model/plain.ts';
import { sameFeatures } from '../../../web/src/model/features.ts';
import { computeBudget, suggestedK, waysToSpend } from '../../../web/src/model/gauss_bonnet.ts';
import { areSeamsShown, hasSteps, sameGrid, sameTiles, tilesPerUnit, turnedSeams } from '../../../web/src/model/grid.ts'; // prettier-ignore
import { beforeFirst, heatMapOf, liveMapOf } from '../../../web/src/model/live.ts';
import {
  emptyPrescription,
  isSilent,
  samePrescription,
} from '../../../web/src/model/prescription.ts';
import { readQuads } from '../../../web/src/model/quad_shape.ts';
import { canRepair } from '../../../web/src/model/repairs.ts';
import { cornerNear } from '../../../web/src/model/snapping.ts';
import { curvatureAround, defectDegrees, neighbourhood, scaleAt } from '../../../web/src/model/surface.ts'; // prettier-ignore
import { sameWanted } from '../../../web/src/model/wanted.ts';
import { locatedSurface } from '../../../web/src/services/geometry/placed_surface.ts';
import { randomFrom } from '../../mutation/draw.mjs';
import { cubeMesh } from '../../support/meshes.mjs';
import { plainFacts } from './plain_facts.mjs';

const near = (a, b, what, within = 1e-9) =>
  assert.ok(Math.abs(a - b) <= within * Math.max(1, Math.abs(b)), `${what}: ${a} and ${b}`);
const surfaceOf = (mesh) => ({
  id: 1,
  ...locatedSurface(
    {
      positions: Float64Array.from(mesh.vertices.flat()),
      triangles: Uint32Array.from(mesh.triangles.flat()),
    },
    plainFacts(mesh),
  ),
});
const surface = surfaceOf(cubeMesh(6));
const square = surfaceOf({
  vertices: [0, 1, 2, 3, 4].flatMap((j) => [0, 1, 2, 3, 4].map((i) => [i, j, 0])),
  triangles: [0, 1, 2, 3].flatMap((j) =>
    [0, 1, 2, 3].flatMap((i) => {
      const a = 5 * j + i;
      return [[a, a + 1, a + 6], [a, a + 6, a + 5]]; // prettier-ignore
    }),
  ),
});

/** Two values are the same exactly if no change of one member was made. */
function samenessLaw(same, value, changes) {
  const copy = structuredClone(value);
  assert.equal(same(value, copy), true, 'equal content');
  assert.equal(same(value, value), true);
  for (const [what, change] of Object.entries(changes)) {
    const other = { ...structuredClone(value), ...change };
    assert.equal(same(value, other), false, what);
    assert.equal(same(other, value), false, what);
    assert.equal(same(other, structuredClone(other)), true, what);
  }
}

test('prescriptions are the same if every integer is', () => {
  const cones = [{ vertex: 3, k: 5 }, { vertex: 4, k: 3, triangle: 2 }]; // prettier-ignore
  samenessLaw(
    samePrescription,
    { q: 4, cones, turnings: [1, null], handles: [null, 0] },
    {
      q: { q: 6 },
      'number of cones': { cones: cones.slice(1) },
      vertex: { cones: [{ vertex: 2, k: 5 }, cones[1]] },
      k: { cones: [{ vertex: 3, k: 4 }, cones[1]] },
      triangle: { cones: [cones[0], { vertex: 4, k: 3 }] },
      order: { cones: cones.toReversed() },
      turning: { turnings: [1, 0] },
      'more turnings': { turnings: [1, null, null] },
      handle: { handles: [0, 0] },
    },
  );
  assert.equal(isSilent(emptyPrescription(4, 2, 2)), true);
  assert.equal(isSilent({ ...emptyPrescription(4, 0, 0), cones }), false);
  for (const key of ['turnings', 'handles'])
    assert.equal(isSilent({ ...emptyPrescription(4, 2, 2), [key]: [null, 0] }), false, `${key} 0`);
});

test('features are the same if they have the same edges, whichever way round and in whichever order', () => {
  const value = { hasCreases: true, hasRims: false, edges: [[1, 2], [3, 4]], rims: [] }; // prettier-ignore
  samenessLaw(sameFeatures, value, {
    rims: { hasRims: true },
    mirrored: { isSymmetric: true },
    fewer: { edges: [[1, 2]] },
    others: { edges: [[1, 2], [3, 5]] }, // prettier-ignore
  });
  assert.equal(sameFeatures(value, { ...value, edges: [[4, 3], [1, 2]] }), true); // prettier-ignore
  assert.equal(sameFeatures(undefined, { hasCreases: false, hasRims: false, edges: [], rims: [] }), true); // prettier-ignore
  assert.equal(sameFeatures(undefined, value), false);
});

test('grids are the same if they are off, or cannot be, or ask for the same', () => {
  const grid = { isOn: true, cells: 50, mode: 'tile' };
  samenessLaw((a, b) => sameGrid(a, b, 4), grid, { off: { isOn: false }, cells: { cells: 60 }, mode: { mode: 'quad' } }); // prettier-ignore
  assert.equal(sameGrid({ isOn: false, mode: 'quad' }, { isOn: false, cells: 5, mode: 'tile' }, 4), true); // prettier-ignore
  assert.equal(sameGrid(grid, { isOn: false, mode: 'quad' }, 3), true);
});

test('what is wanted is the same only as the same objects', () => {
  const wanted = { model: {}, prescription: {}, solve: {}, features: {}, field: {} };
  assert.equal(sameWanted(wanted, { ...wanted }), true);
  assert.equal(sameWanted(undefined, undefined), true);
  assert.equal(sameWanted(wanted, undefined), false);
  for (const key of Object.keys(wanted))
    assert.equal(sameWanted(wanted, { ...wanted, [key]: {} }), false, key);
});

const closed = [{ component: 0, eulerCharacteristic: 2, boundaryLoops: [] }];
const infoOf = (more) => ({ usable: true, genus: 0, components: closed, defects: [], file: { sha256: 'x' }, surface: 0, surfaces: [{}], ...more }); // prettier-ignore
function opened(doc = new Document(), more = {}) {
  const model = { main: 'a.obj', files: new Map(), solver: {}, info: infoOf(), surface, loaded: doc.settings, remarks: [], matrix: [], ...more }; // prettier-ignore
  doc.state = { kind: 'open', model };
  doc.begin(emptyPrescription(4, 0, 0));
  return { doc, model };
}
/** A finished run of the document as it is, certified or not. */
function solutionOf(doc, { isGood = true, ...more } = {}) {
  const { improve, frames, grid } = doc.solve;
  const component = { orientation: {}, distortion: {} };
  const certificate = { certified: isGood, usable: true, flipped: isGood ? 0 : 1, triangles: 9, wrongAngles: 0, wrongTurnings: 0, brokenSeams: 0, seamEdges: 0, integerSeams: 0, overlap: { share: 0, layers: 1 }, stored: { verified: 9, triangles: 9, negative: 0, zero: 0, reversed: 0, duplicates: 0, zeroArea: 0, splitVertices: 0 }, components: [component], q: 4, precision: 'float32', maxConeDistance: 0, maxSeamResidual: 0, seamTolerance: 1 }; // prettier-ignore
  return { prescription: doc.prescription, settings: doc.settings, improve, frames, grid, field: doc.askedField, features: doc.askedFeatures, isSameAsFile: true, difference: '', written: { bytes: new Uint8Array(9) }, smallestArea: { area: 1, mean: 1, smallestPositive: 1, triangle: 0, negative: 0, zero: 0 }, distortion: { flipped: new Uint32Array(0) }, seams: [], chains: new Uint32Array(0), result: { certificate, report: { components: [{}], seconds: 1 } }, ...more }; // prettier-ignore
}

test('a run is the current one as long as everything that decides a map is as it was', () => {
  const { doc } = opened();
  doc.solutions = [solutionOf(doc)];
  const [first] = doc.solutions;
  assert.equal(doc.current, first);
  const field = { name: 'a.rosy', text: '' };
  const changes = {
    cones: () => doc.begin({ ...doc.prescription, cones: [{ vertex: 1, k: 3 }] }),
    q: () => doc.begin(emptyPrescription(6, 0, 0)),
    improve: () => (doc.solve = { ...doc.solve, improve: 0 }),
    grid: () => (doc.solve = { ...doc.solve, grid: { isOn: false, mode: 'tile' } }),
    frames: () => {
      doc.takeField(field);
      doc.solve = { ...doc.solve, frames: 'file' };
    },
    features: () =>
      (doc.features = { hasCreases: false, hasRims: false, edges: [[1, 2]], rims: [] }),
  };
  for (const [what, change] of Object.entries(changes)) {
    const [{ solve, features, prescription }, before] = [doc, doc.field];
    change();
    assert.equal(doc.current, undefined, what);
    assert.equal(doc.displayed, first, `${what}: it is still shown`);
    assert.equal(doc.stateName, 'stale', what);
    const again = solutionOf(doc);
    doc.solutions = [first, again];
    assert.equal(doc.current, again, what);
    assert.equal(doc.beforeDisplayed, first);
    doc.takeField(before);
    Object.assign(doc, { solve, features });
    doc.begin(prescription);
    assert.equal(doc.current, first, `${what}, taken back`);
    assert.equal(doc.beforeDisplayed, undefined, 'what is shown is not the newest');
    doc.solutions = [first];
  }
  // What does not decide it.
  doc.features = { hasCreases: false, hasRims: false, edges: [], rims: [], keepsCones: true };
  assert.equal(doc.current, first);
  doc.look = { ...doc.look, tiles: 99 };
  doc.solve = { ...doc.solve, rounds: 3, timeLimit: 9 };
  assert.equal(doc.current, first);
  // Another reading of the surface has maps of its own.
  const { model } = opened(doc, { loaded: { fix: { split: true } } });
  assert.equal(doc.displayed, undefined);
  assert.deepEqual(doc.runs, []);
  doc.begin(doc.prescription, model.loaded);
  doc.solutions = [first, solutionOf(doc)];
  assert.equal(doc.displayed, doc.solutions[1]);
});

test('whichever run one returns to is the current one then, with its cones and settings, and undo leads back to the cones', (t) => {
  const random = randomFrom(21);
  const pick = (all) => all[Math.floor(random() * all.length)];
  const { doc } = opened();
  const app = { doc, ui: {} };
  const fields = [
    { name: 'a.rosy', text: '' },
    { name: 'b.rosy', text: '' },
  ];
  const features = [undefined, { hasCreases: false, hasRims: false, edges: [[1, 2]], rims: [] }, { hasCreases: true, hasRims: false, edges: [[3, 4]], rims: [] }, { hasCreases: true, hasRims: false, edges: [[5, 4]], rims: [], keepsCones: true }]; // prettier-ignore
  const edit = {
    cones: () => doc.begin({ ...doc.prescription, cones: [{ vertex: Math.floor(9 * random()), k: 3 }] }), // prettier-ignore
    improve: () => (doc.solve = { ...doc.solve, improve: pick([undefined, 0, 1, -1]) }),
    grid: () => (doc.solve = { ...doc.solve, grid: { isOn: pick([true, false]), mode: pick(['tile', 'quad']) } }), // prettier-ignore
    features: () => (doc.features = pick(features)),
    frames: () => {
      doc.takeField(pick([undefined, ...fields]));
      doc.solve = { ...doc.solve, frames: doc.field ? pick(['auto', 'file']) : 'auto' };
    },
  };
  // Choices in quick succession are one step.
  let clock = 0;
  t.mock.method(performance, 'now', () => (clock += 1000));
  for (let round = 0; round < 100; round++) {
    edit[pick(Object.keys(edit))]();
    edit[pick(Object.keys(edit))]();
    if (!doc.current) doc.solutions = [...doc.solutions.slice(-2), solutionOf(doc)];
    const run = pick(doc.runs);
    const { prescription, solve } = doc;
    returnTo(app, run);
    assert.equal(doc.current, run);
    assert.equal(doc.prescription, run.prescription);
    assert.equal(doc.features, run.features, 'and who chose its cones');
    const { improve, frames, grid, ...rest } = doc.solve;
    assert.deepEqual([improve, frames, grid], [run.improve, run.frames, run.grid]);
    const { improve: _a, frames: _b, grid: _c, ...before } = solve;
    assert.deepEqual(rest, before, 'what decides no map stays');
    if (run.prescription === prescription) continue;
    assert.equal(doc.history.undo().value.prescription, prescription);
  }
});

test('features and fields are asked for only where lines and frames can follow them', () => {
  const { doc } = opened();
  doc.features = { hasCreases: false, hasRims: true, edges: [], rims: [] };
  assert.equal(doc.askedFeatures, doc.features);
  doc.begin(emptyPrescription(6, 0, 0));
  assert.equal(doc.askedFeatures, undefined);
  doc.begin(emptyPrescription(4, 0, 0));
  doc.takeField({ name: 'a', text: '' });
  assert.equal(doc.askedField, undefined);
  doc.solve = { ...doc.solve, frames: 'file' };
  assert.equal(doc.askedField, doc.field);
  assert.equal(doc.askedFeatures, undefined, 'frames are those of the file');
  doc.takeField();
  assert.deepEqual([doc.field, doc.solve.frames], [undefined, 'auto']);
});

test('the state is one word, in this order of precedence', () => {
  const doc = new Document();
  assert.equal(doc.stateName, 'starting');
  opened(doc);
  assert.equal(doc.stateName, 'ready', 'Run chooses cones');
  doc.hasUserCones = true;
  assert.equal(doc.needsCones, true, 'none were placed, and none are not balanced');
  doc.begin({ ...doc.prescription, cones: [{ vertex: 0, k: 3 }] });
  assert.equal(doc.needsCones, false);
  assert.equal(doc.stateName, 'unbalanced');
  doc.features = { hasCreases: false, hasRims: false, edges: [[1, 2]], rims: [] };
  assert.equal(doc.stateName, 'ready', 'Run chooses others');
  doc.features = undefined;
  doc.begin({ ...doc.prescription, cones: Array.from({ length: 8 }, (_, vertex) => ({ vertex, k: 3 })) }); // prettier-ignore
  assert.equal(doc.stateName, 'ready');
  doc.solutions = [solutionOf(doc)];
  assert.equal(doc.stateName, 'certified');
  doc.solutions = [solutionOf(doc, { isGood: false })];
  assert.equal(doc.stateName, 'not-certified');
  doc.live = heatMapOf(doc.displayed, new Float32Array(2));
  assert.equal(doc.stateName, 'dragging');
  doc.automatic = { controller: new AbortController(), stage: 'solve' };
  assert.equal(doc.stateName, 'renewing');
  doc.job = { kind: 'run' };
  assert.deepEqual([doc.stateName, doc.isBusy], ['running', true]);
  doc.job = { kind: 'load' };
  assert.equal(doc.stateName, 'loading');
  doc.job = undefined;
  assert.equal(doc.isBusy, false);
  opened(doc, { info: infoOf({ usable: false }) });
  assert.deepEqual([doc.stateName, doc.usableModel, doc.budget, doc.wanted], ['invalid', undefined, undefined, undefined]); // prettier-ignore
});

test('a closed file leaves nothing behind but the version whose cones may be carried over', () => {
  const fresh = new Document();
  const { doc, model } = opened();
  const cones = [{ vertex: 0, k: 3 }];
  doc.begin({ ...doc.prescription, cones }, { weld: 1, fix: {} });
  const [job, automatic] = [new AbortController(), new AbortController()];
  Object.assign(doc, { job: { kind: 'load', controller: job }, automatic: { controller: automatic, stage: '' }, notAgain: {}, firstRun: 7, live: {}, solutions: [{}], meshes: new Map([[1, {}]]), thumbnails: new Map([[1, {}]]), parts: [{}], summaries: [{}], features: {}, hasUserCones: true, coneStep: 4, selected: 0, validation: {}, message: {}, quads: {}, isUnsaved: true }); // prettier-ignore
  doc.takeField({ name: 'a', text: '' });
  doc.clearModel();
  assert.deepEqual([job.signal.aborted, automatic.signal.aborted], [true, true]);
  const kept = new Set(['state', 'history', 'log', 'solve', 'look', 'pendingOutput', 'objection']);
  for (const key of Object.keys(fresh).filter(
    (name) => !kept.has(name) && !['previous', 'openRequestId'].includes(name),
  ))
    // prettier-ignore
    assert.deepEqual(doc[key], fresh[key], key);
  assert.deepEqual(doc.state, { kind: 'empty' });
  assert.deepEqual([doc.prescription, doc.settings], [emptyPrescription(4, 0, 0), { fix: {} }]);
  assert.deepEqual(doc.previous, { model, prescription: { ...emptyPrescription(4, 0, 0), cones } });
  doc.clearModel();
  assert.equal(doc.previous?.model, model, 'a file that could not be read does not end it');
  opened(doc);
  doc.clearModel();
  assert.equal(doc.previous, undefined, 'there were no cones');
});

test('a new page starts with these values', () => {
  const doc = new Document();
  assert.deepEqual(doc.solve, { rounds: 12, frames: 'auto', grid: { isOn: true, mode: 'tile' } });
  assert.deepEqual([doc.hasUserCones, doc.isUnsaved, doc.selected, doc.coneStep], [false, false, -1, 2]); // prettier-ignore
  assert.deepEqual([doc.look.hasWire, doc.look.seams, doc.look.steps], [false, 'auto', 1]);
  assert.deepEqual(loadOptionsOf({ weld: 2, fix: { split: true } }), { weld: 2, fix: { split: true } }); // prettier-ignore
  assert.deepEqual(loadOptionsOf({ weld: 2, fix: {}, hasAllRepairs: true }), { weld: 2 });
});

test('the log keeps the last two hundred messages, and the newest is shown', () => {
  const doc = new Document();
  for (let i = 0; i < 250; i++) doc.say(`message ${i}`);
  assert.equal(doc.log.length, 200);
  assert.match(doc.log.at(-1).text, /message 249/);
  assert.match(doc.log[0].text, /message 50/);
  assert.deepEqual([doc.message.text, doc.message.kind], ['message 249', 'note']);
});

test('an objection counts only for the cones and the surface that it is about', () => {
  const { doc } = opened();
  const cones = Array.from({ length: 8 }, (_, vertex) => ({ vertex, k: 3 }));
  doc.begin({ ...doc.prescription, cones });
  assert.equal(doc.budget.isReady, true);
  doc.objection = { prescription: doc.prescription, surface, text: 'no', warnings: ['w'] };
  assert.deepEqual([doc.budget.isReady, doc.budget.text, doc.budget.warnings], [false, 'no', ['w']]); // prettier-ignore
  doc.objection = { ...doc.objection, text: '' };
  assert.deepEqual([doc.budget.isReady, doc.budget.warnings], [true, ['w']]);
  doc.objection = { ...doc.objection, text: 'no', surface: square };
  assert.deepEqual([doc.budget.isReady, doc.budget.warnings], [true, []]);
  doc.objection = { ...doc.objection, surface, prescription: structuredClone(doc.prescription) };
  assert.equal(doc.budget.isReady, true);
});

test('budgets: what is left is what would balance, per component; open boundaries take the rest', () => {
  const loop = { loop: 0 };
  const two = [{ component: 0, eulerCharacteristic: 2, boundaryLoops: [] }, { component: 1, eulerCharacteristic: 1, boundaryLoops: [loop] }]; // prettier-ignore
  const both = { ...surface, component: surface.component.map((_, v) => (v < 50 ? 0 : 1)) };
  const of = (cones, turnings = [null], q = 4) =>
    computeBudget({ q, cones, turnings, handles: [] }, both, { components: two });
  const random = randomFrom(2);
  for (let i = 0; i < 50; i++) {
    const q = [2, 4, 6][Math.floor(3 * random())];
    const cones = Array.from({ length: 5 }, () => ({ vertex: Math.floor(100 * random()), k: 1 + Math.floor(7 * random()) })); // prettier-ignore
    const l = random() < 0.5 ? null : Math.floor(9 * random()) - 4;
    const { components } = of(cones, [l], q);
    const spent = (from, to) => cones.filter(({ vertex }) => vertex >= from && vertex < to).reduce((sum, { k }) => sum + q - k, 0); // prettier-ignore
    assert.deepEqual(components.map(({ have }) => have), [spent(0, 50), spent(50, 999) + (l ?? 0)]); // prettier-ignore
    assert.deepEqual(
      components.map(({ need }) => need),
      [2 * q, q],
    );
    components.forEach(({ have, need, left, openLoops, isBalanced }, c) => {
      assert.equal(left, need - have);
      assert.equal(openLoops, c === 1 && l === null ? 1 : 0);
      assert.equal(isBalanced, left === 0 || openLoops > 0);
    });
  }
  // A cone with a triangle belongs to the component of that triangle.
  both.triangleComponent = new Int32Array(surface.triangles.length / 3).fill(1);
  assert.deepEqual(of([{ vertex: 0, k: 3, triangle: 5 }]).components.map(({ have }) => have), [0, 1]); // prettier-ignore
  assert.deepEqual(
    of([{ vertex: 0, k: 3 }]).components.map(({ have }) => have),
    [1, 0],
  );
  assert.match(of([{ vertex: 0, k: 3 }]).text, /^7 left in component 1/);
  assert.match(of(Array.from({ length: 11 }, (_, vertex) => ({ vertex: 4 * vertex, k: 3 }))).text, /^3 too much/); // prettier-ignore
  assert.equal(waysToSpend(8, 4), '8 cones with k = 3 or 4 cones with k = 2');
  assert.equal(waysToSpend(-1, 4), 'one cone with k = 5');
});

test('a cone placed by a click never takes more than is left, nor what no vertex can have', () => {
  for (const q of [2, 4, 6])
    for (let left = -9; left <= 9; left++)
      for (const v of [0, 3, 20, 40, 90]) {
        const k = suggestedK(surface, v, q, left);
        assert.ok(Number.isInteger(k) && k >= 1, `${k}`);
        assert.notEqual(k, q, 'it has an effect');
        assert.ok(
          (Math.PI * k * 2) / q < Math.PI * surface.valence[v],
          'below 180° at each corner',
        );
        if (left > 0) assert.ok(k < q && q - k <= left, `${left} left: k = ${k}`);
        if (left < 0) assert.ok(k > q && k - q <= -left, `${left} too much: k = ${k}`);
      }
});

test('curvature adds up to that of the sphere; a flat square has none; on a rim it is measured to a half turn', () => {
  const all = Array.from({ length: surface.vertexCount }, (_, v) => defectDegrees(surface, v));
  near(
    all.reduce((sum, x) => sum + x, 0),
    720,
    'Gauss–Bonnet',
    1e-6,
  );
  near(defectDegrees(square, 12), 0, 'inside');
  near(defectDegrees(square, 2), 0, 'on a side');
  near(defectDegrees(square, 0), 90, 'at a corner');
  near(curvatureAround(square, 0), 0, 'the boundary does not count');
  const [first, ...others] = neighbourhood(surface, 7);
  assert.equal(first, 7);
  const ring = surface.neighbours.subarray(surface.neighbourStart[7], surface.neighbourStart[8]);
  for (const v of ring) assert.ok(others.includes(v), 'the first ring is always in it');
  assert.equal(new Set(others).size, others.length);
  near(curvatureAround(surface, 7), [7, ...others].reduce((sum, v) => sum + (defectDegrees(surface, v) * Math.PI) / 180, 0), 'around'); // prettier-ignore
});

test('the scale of a triangle is the root of its areas, wherever it lies', () => {
  for (const scale of [0.5, 1, 7]) {
    const uv = Float64Array.from([...square.triangles].flatMap((v) => [3 - scale * square.positions[3 * v + 1], 2 + scale * square.positions[3 * v]])); // prettier-ignore
    for (const t of [0, 5, 31]) near(scaleAt(square, uv, t), scale, `triangle ${t}`);
  }
});

test('a click goes to a corner in reach, never past it, and stays where nothing is sharp', () => {
  const around = (v, reach) => (w) =>
    Math.hypot(...[0, 1, 2].map((i) => surface.positions[3 * v + i] - surface.positions[3 * w + i])) < reach; // prettier-ignore
  for (let v = 0; v < surface.vertexCount; v++) {
    const found = cornerNear(surface, v, around(v, 0.5));
    assert.ok(found === v || (found < 8 && around(v, 0.5)(found)), `${v} goes to ${found}`);
    assert.equal(
      cornerNear(surface, v, () => false),
      v,
      'nothing is near',
    );
  }
  for (let c = 0; c < 8; c++)
    assert.equal(
      cornerNear(surface, c, () => true),
      c,
      'a corner stays',
    );
  assert.equal(
    cornerNear(square, 12, () => true),
    12,
    'corners of a rim are none',
  );
});

test('a click goes to the sharpest corner that is reached over what is near, is clearly sharper, and has none beside it that is sharper still', () => {
  const random = randomFrom(12);
  const moved = { corner: 0, none: 0 };
  for (let round = 0; round < 600; round++) {
    // Any curvature, as rough surfaces have it.
    const rough = { ...surface, angle: surface.angle.map(() => (random() < 0.7 ? 2 * Math.PI : 1 + 8 * random())), isBoundary: surface.isBoundary.map(() => (random() < 0.1 ? 1 : 0)) }; // prettier-ignore
    const ring = (v) => [...rough.neighbours.subarray(rough.neighbourStart[v], rough.neighbourStart[v + 1])]; // prettier-ignore
    const defect = (v) => (rough.isBoundary[v] ? 0 : 2 * Math.PI - rough.angle[v]);
    const sharpness = (v) => Math.abs(ring(v).reduce((sum, w) => sum + defect(w), 2 * defect(v))) / 2; // prettier-ignore
    const isNear = surface.angle.map(() => (random() < 0.4 ? 1 : 0));
    const from = Math.floor(surface.vertexCount * random());
    const reached = new Set([from]);
    for (const v of reached) for (const w of ring(v)) if (isNear[w]) reached.add(w);
    const corners = [...reached].filter((v) => {
      const own = sharpness(v);
      const isClear = own > Math.PI / 7 && own > 1.3 * sharpness(from);
      return v !== from && !rough.isBoundary[v] && isClear && ring(v).every((w) => sharpness(w) <= own + 1e-12); // prettier-ignore
    });
    const found = cornerNear(rough, from, (v) => isNear[v] === 1);
    const best = Math.max(...corners.map(sharpness));
    if (corners.length === 0) assert.equal(found, from);
    else assert.ok(corners.includes(found) && sharpness(found) > best - 1e-9, `${found} from ${from}`); // prettier-ignore
    moved[corners.length > 0 ? 'corner' : 'none'] += 1;
  }
  assert.ok(moved.corner > 50 && moved.none > 50, JSON.stringify(moved));
});

test('of a fine surface only hundreds of vertices around a place are looked at, so that a pointer does not wait', () => {
  const fine = surfaceOf(cubeMesh(16));
  const most = 7; // neighbours that the last one may add
  const wide = { ...fine, diagonal: 1000 * fine.diagonal };
  for (const v of [0, 100, 1500]) {
    assert.ok(Math.abs(neighbourhood(wide, v).length - 600 - most / 2) <= most / 2 + 1);
    const seen = new Set();
    cornerNear(fine, v, (w) => seen.add(w));
    assert.ok(Math.abs(seen.size - 400 - most / 2) <= most / 2 + 1, `${seen.size}`);
    // Where fewer are in reach, all of these are.
    const far = (w) => Math.hypot(...[0, 1, 2].map((i) => fine.positions[3 * v + i] - fine.positions[3 * w + i])); // prettier-ignore
    const all = [...Array(fine.vertexCount).keys()].filter((w) => far(w) <= 0.03 * fine.diagonal * 6);
    const found = neighbourhood({ ...fine, diagonal: 6 * fine.diagonal }, v);
    assert.deepEqual(found.toSorted((x, y) => x - y), all); // prettier-ignore
  }
}); // prettier-ignore

test('repairs are offered where every fatal defect has one that was not made', () => {
  const of = (kinds, loaded = { fix: {} }, usable = false) =>
    canRepair({ info: { usable, defects: kinds.map((kind) => ({ kind, fatal: kind !== 'isolated-vertex' })) }, loaded }); // prettier-ignore
  assert.equal(of(['zero-area', 'non-manifold-edge']), true);
  assert.equal(of(['zero-area', 'isolated-vertex']), true);
  assert.equal(of(['zero-area', 'not-finite']), false);
  assert.equal(of(['isolated-vertex']), false, 'nothing is fatal');
  assert.equal(of(['zero-area'], { fix: {}, hasAllRepairs: true }), false);
  assert.equal(of(['zero-area'], { fix: {} }, true), false);
});

test('while a cone is dragged: corners of the last map, and scales relative to their mean', () => {
  const base = { cornerUv: new Float32Array(6) };
  const logScale = Float32Array.from([1, 2, NaN, 6]);
  const heat = heatMapOf(base, logScale);
  const expected = [-2, -1, NaN, 3].map((x) => (2 * x) / Math.LN2);
  expected.forEach((x, i) => (Number.isNaN(x) ? assert.ok(Number.isNaN(heat.heat[i])) : near(heat.heat[i], x, 'heat', 1e-6))); // prettier-ignore
  assert.deepEqual([heat.state, heat.cornerUv, heat.base], ['heat', base.cornerUv, base]);
  // Until the first of them nothing is known but the map that was there.
  const none = { base, state: 'heat', cornerUv: base.cornerUv, heat: new Float32Array(0), notPositive: new Uint32Array(0), reasons: [] }; // prettier-ignore
  assert.deepEqual(beforeFirst(base), none);
  assert.deepEqual(heatMapOf(base, logScale), { ...none, heat: heat.heat });
  const unknown = heatMapOf(base, Float32Array.of(NaN, NaN)).heat;
  assert.ok(unknown.length === 2 && unknown.every(Number.isNaN), 'nothing is known anywhere');
  const frame = { state: 'certified', uv: Float32Array.from([1, 2, 3, 4, 5, 6]), cornerToUv: Uint32Array.from([2, 0, 1]), notPositive: new Uint32Array(0), reasons: [], logScale }; // prettier-ignore
  const map = liveMapOf(base, frame, undefined);
  assert.deepEqual([...map.cornerUv], [5, 6, 1, 2, 3, 4]);
  assert.equal(map.heat.length, 0);
  const after = liveMapOf(base, { ...frame, state: 'heat' }, map);
  assert.equal(after.cornerUv, map.cornerUv, 'the picture before stays');
  assert.equal(after.heat.length, 4);
  assert.equal(liveMapOf(base, { ...frame, state: 'heat' }, undefined).cornerUv, base.cornerUv);
});

test('runs side by side: the best of a row is the lowest, if they differ as written', () => {
  const { doc } = opened();
  const run = (stretch, cones, seconds, share) =>
    solutionOf(doc, {
      prescription: { ...doc.prescription, cones: Array.from({ length: cones }, (_, vertex) => ({ vertex, k: 3 })) }, // prettier-ignore
      sizes: { typicalStretch: stretch, spread: 2 },
      chains: Uint32Array.from([0, 1, 1]),
      result: { ...solutionOf(doc).result, certificate: { ...solutionOf(doc).result.certificate, overlap: { share, layers: 1 } }, report: { components: [{}], seconds } }, // prettier-ignore
    });
  const rows = new Map(compareRuns([run(1.1, 8, 1, 0.0001), run(1.05, 9, 1.001, 0)]).map((row) => [row.name, row.cells])); // prettier-ignore
  const textsOf = (name) => rows.get(name).map(({ text }) => text);
  const bestOf = (name) => rows.get(name).map(({ isBest }) => isBest);
  assert.deepEqual([textsOf('Cones'), bestOf('Cones')], [['8', '9'], [true, false]]); // prettier-ignore
  assert.deepEqual([textsOf('Typical stretch'), bestOf('Typical stretch')], [['10.0 %', '5.0 %'], [false, true]]); // prettier-ignore
  assert.deepEqual([textsOf('Size varies'), bestOf('Size varies')], [['× 2.00', '× 2.00'], [false, false]]); // prettier-ignore
  assert.deepEqual(bestOf('Time'), [false, false], 'equal as written');
  assert.deepEqual(textsOf('Overlaps'), ['under 0.1 %', '0.0 %']);
  // Whatever the share: 0 only if there are none, and otherwise as in one decimal.
  for (const share of [0, 1e-9, 0.0004, 0.00049, 0.00051, 0.0006, 0.0014, 0.25, 1]) {
    const text = compareRuns([run(1, 8, 1, share)]).find(({ name }) => name === 'Overlaps').cells[0].text; // prettier-ignore
    const tenths = Math.round(1000 * share);
    assert.equal(text, share > 0 && tenths === 0 ? 'under 0.1 %' : `${(tenths / 10).toFixed(1)} %`);
  }
  assert.deepEqual([textsOf('Seams'), textsOf('Verdict')], [['2', '2'], ['certified', 'certified']]); // prettier-ignore
  assert.deepEqual([textsOf('Less distortion'), textsOf('Lines follow')], [['off', 'off'], ['nothing', 'nothing']]); // prettier-ignore
});

const mapOf = (isIt, uvArea = 4) => ({ result: { certificate: { integerSeams: isIt ? 2 : 1, seamEdges: 2 }, report: { components: [{ grid: { aligned: isIt } }] } }, distortion: { uvArea, surfaceArea: 1 } }); // prettier-ignore

test('tiles: as many along the diagonal as asked for, whole ones per cell on an aligned map, and as large as before', () => {
  const look = { pattern: 'checker', tiles: 24, steps: 3, seams: 'auto' };
  // uv is twice as long as the surface: a diagonal of 5 is 10 in uv.
  near(10 * tilesPerUnit(look, { diagonal: 5 }, mapOf(false)), 24, 'tiles');
  assert.equal(tilesPerUnit(look, { diagonal: 5 }, mapOf(true)), 6);
  assert.deepEqual([hasSteps(look, mapOf(true)), hasSteps(look, mapOf(false)), hasSteps(look, undefined), hasSteps({ ...look, pattern: 'plain' }, mapOf(true))], [true, false, false, false]); // prettier-ignore
  const after = sameTiles(look, { diagonal: 5 }, mapOf(true), mapOf(false));
  near(tilesPerUnit(after, { diagonal: 5 }, mapOf(false)), 6, 'the same size', 0.02);
  for (const [a, b] of [
    [false, false],
    [true, true],
    [false, true],
  ])
    // prettier-ignore
    assert.equal(sameTiles(look, { diagonal: 5 }, mapOf(a), mapOf(b)), look);
  assert.deepEqual([areSeamsShown(look, mapOf(true)), areSeamsShown(look, mapOf(false))], [false, true]); // prettier-ignore
  for (const isIt of [true, false])
    assert.deepEqual(['on', 'off'].map((seams) => areSeamsShown({ seams }, mapOf(isIt))), [true, false]); // prettier-ignore
});

test('turned seams are those whose rotation the pattern does not have', () => {
  const solution = { seams: [{ r: 0 }, { r: 1 }, { r: 2 }, { r: 1 }], chains: [0, 1, 2, 1], prescription: { q: 4 } }; // prettier-ignore
  assert.deepEqual(turnedSeams('checker', solution), { all: 3, turned: 0, edges: [] });
  assert.deepEqual(turnedSeams('brick', solution), { all: 3, turned: 1, edges: [1, 3] });
  assert.deepEqual(turnedSeams('wood', solution), { all: 3, turned: 2, edges: [1, 2, 3] });
});

test('quads are read from an OBJ whatever else is in it', () => {
  const text = '# v 9 9 9\no a\nv 0 0 0 1\n  v 1 0 0\nv 1 1 0\r\nv 0 1 0\nvn 0 0 1\nf 1 2 3\nf 1//1 2//1 3//1 4//1\n'; // prettier-ignore
  const { positions, quads } = readQuads(new TextEncoder().encode(text));
  assert.deepEqual([...positions], [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]);
  assert.deepEqual([...quads], [0, 1, 2, 3]);
});

test('every member of a document tells its readers of a change', () => {
  const doc = new Document();
  for (const key of Object.keys(doc).filter(
    (name) => !['previous', 'openRequestId'].includes(name),
  )) {
    let seen = 0;
    const end = effect(() => {
      void doc[key];
      seen += 1;
    });
    doc[key] = { of: key };
    assert.equal(seen, 2, key);
    end();
  }
});

test('meshes are surveyed where that is quick: the largest that can be used is opened', async () => {
  const { surveyMeshes } = await import('../../../web/src/actions/inspect_meshes.ts');
  const surfaces = (...sizes) => sizes.map((triangles, index) => ({ index, triangles }));
  const read =
    (bad = []) =>
    async (index) => {
      // prettier-ignore
      if (bad.includes(index)) throw new Error('no');
      return {
        usable: index !== 1,
        components: [{}],
        defects: [{ fatal: true, kind: 'zero-area' }],
      };
    };
  const of = async (sizes, ...more) => surveyMeshes({ surfaces: surfaces(...sizes), surface: 0 }, [{ count: 3 }], read(...more)); // prettier-ignore
  const { best, summaries } = await of([10, 99, 50]);
  assert.equal(best, 2);
  assert.deepEqual(summaries.map(({ isUsable, instances, why }) => [isUsable, instances, why]), [[true, 3, 'zero area'], [false, undefined, 'zero area'], [true, undefined, 'zero area']]); // prettier-ignore
  const failed = await of([10, 99, 50], [2]);
  assert.deepEqual([failed.best, failed.summaries[2].isUsable, failed.summaries[2].why], [0, false, 'no']); // prettier-ignore
  assert.equal((await of([50, 50, 50])).best, 0, 'the first of equal ones');
  // Four hundred thousand triangles and 64 meshes are read, one more of either is not.
  assert.deepEqual((await of([1, 200_000, 199_999])).summaries.length, 3);
  assert.deepEqual(await of([1, 200_000, 200_000]), { summaries: [], best: 0 });
  assert.equal((await of(Array(64).fill(1))).summaries.length, 64);
  assert.equal((await of(Array(65).fill(1))).summaries.length, 0);
});
