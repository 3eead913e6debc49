// Edits as values: what one undo step is, what a repair or another version of a file does to cones, where a click
// places which cone, and which job another file ends.

import assert from 'node:assert/strict';
import test from 'node:test';
import {
  balanced,
  clearCones,
  deleteCone,
  keepCones,
  moveCone,
  placeOrSelect,
  selectNext,
  setHandle,
  setK,
  setPrescription,
  setTurning,
} from '../../../web/src/actions/edit_cones.ts';
import { cancel, runJob } from '../../../web/src/actions/job.ts';
import { whyNotRun } from '../../../web/src/actions/solve.ts';
import { redo, undo } from '../../../web/src/actions/undo.ts';
import { Document } from '../../../web/src/model/document.ts';
import { leftAt } from '../../../web/src/model/gauss_bonnet.ts';
import { History } from '../../../web/src/model/history.ts';
import { emptyPrescription } from '../../../web/src/model/prescription.ts';
import { locatedSurface } from '../../../web/src/services/geometry/placed_surface.ts';
import { randomFrom } from '../../mutation/draw.mjs';
import { cubeMesh } from '../../support/meshes.mjs';
import { plainFacts } from './plain_facts.mjs';

function surfaceOf(mesh, changes = {}) {
  const arrays = {
    positions: Float64Array.from(mesh.vertices.flat()),
    triangles: Uint32Array.from(mesh.triangles.flat()),
  };
  const facts = { ...plainFacts(mesh), ...changes };
  return { id: 1, ...locatedSurface(arrays, facts) };
}

const closed = [{ component: 0, eulerCharacteristic: 2, boundaryLoops: [] }];
const infoOf = (more = {}) => ({ usable: true, genus: 0, components: closed, ...more });

/** An open cube without a solver behind it. */
function opened() {
  const doc = new Document();
  const surface = surfaceOf(cubeMesh(3));
  const file = { sha256: 'x', name: 'cube.obj' };
  const info = infoOf({ file, surfaces: [{}] });
  doc.state = { kind: 'open', model: { main: 'cube.obj', files: new Map(), info, surface, loaded: { fix: {} } } }; // prettier-ignore
  doc.begin(emptyPrescription(4, 0, 0));
  return { doc, surface };
}
const positionsOf = ({ doc }) => doc.prescription.cones.map(({ vertex }) => vertex);

test('all moves of a drag are one undo step, however slow; another drag is another step', () => {
  const begin = History.of('a');
  const steps = ['b', 'c', 'd'].reduce(
    (history, value, i) => history.push(value, 'move cone: 17', 9000 * i),
    begin,
  );
  assert.equal(steps.value, 'd');
  assert.equal(steps.undo().value, 'a');
  const second = steps.push('e', 'move cone: 18', 27001);
  assert.deepEqual([second.undo().value, second.undo().undo().value], ['d', 'a']);
  // Other edits are one step only in quick succession.
  const typed = begin.push('b', 'change k: 3', 0).push('c', 'change k: 3', 400);
  assert.equal(typed.undo().value, 'a');
  assert.equal(begin.push('b', 'change k: 3', 0).push('c', 'change k: 3', 600).undo().value, 'b');
});

test('dragging a cone over many vertices is undone at once', () => {
  const app = opened();
  const { doc } = app;
  placeOrSelect(app, 0);
  assert.deepEqual(positionsOf(app), [0]);
  const path = [...Array(6).keys()].map((i) => i + 5);
  for (const vertex of path) moveCone(app, 0, vertex, 'a drag');
  assert.deepEqual(positionsOf(app), [path.at(-1)]);
  doc.history = doc.history.undo();
  assert.deepEqual(positionsOf(app), [0]);
  doc.history = doc.history.redo();
  moveCone(app, 0, 20, 'another drag');
  doc.history = doc.history.undo();
  assert.deepEqual(positionsOf(app), [path.at(-1)]);
});

test('a cone that is moved leaves the copy of the vertex at which it was', () => {
  const app = opened();
  const { doc } = app;
  placeOrSelect(app, 0);
  const [{ k }] = doc.prescription.cones;
  const split = { ...doc.prescription, cones: [{ vertex: 0, k, triangle: 3 }] };
  assert.ok(setPrescription(app, split, 'add cone: 0'));
  moveCone(app, 0, 5, 'a drag');
  assert.deepEqual(doc.prescription.cones, [{ vertex: 5, k }]);
});

test('whatever is done to cones one after another, they and the selection are as one expects', () => {
  const random = randomFrom(14);
  const below = (n) => Math.floor(n * random());
  const { doc, surface } = opened();
  const app = { doc };
  surface.isBoundary = surface.isBoundary.map((_, v) => (v % 7 === 3 ? 1 : 0));
  // Some vertices were joined with another one, or left out, when the file was read.
  surface.representative = surface.representative.map((v) => (v % 5 === 4 ? v - 4 : v % 11 === 2 ? -1 : v)); // prettier-ignore
  const done = new Map();
  for (let round = 0; round < 150; round++) {
    doc.begin({ ...emptyPrescription(4, 2, 2), cones: [] });
    doc.selected = -1;
    let [cones, selected] = [[], -1];
    const [turnings, handles] = [
      [null, null],
      [null, null],
    ];
    for (let step = 0; step < 14; step++) {
      const at = below(cones.length + 2) - 1; // beyond the ends, too
      const picked = random() < 0.3 && cones.length > 0 ? cones[below(cones.length)].vertex : below(surface.vertexCount); // prettier-ignore
      const vertex = surface.representative[picked];
      const isFree = vertex >= 0 && !surface.isBoundary[vertex];
      const there = cones.findIndex((cone) => cone.vertex === vertex);
      const k = [0, -1, 1, 2, 5, 2.5][below(6)];
      const value = [null, 0, 1, -3, 6, 0.5][below(6)];
      const acts = {
        place() {
          placeOrSelect(app, picked);
          if (there >= 0) selected = there;
          else if (isFree) {
            cones = [...cones, { vertex, k: doc.prescription.cones.at(-1).k }];
            selected = cones.length - 1;
          }
        },
        next() {
          selectNext(app, 1);
          if (cones.length > 0) selected = selected === cones.length - 1 ? 0 : selected + 1;
        },
        previous() {
          selectNext(app, -1);
          if (cones.length > 0) selected = selected <= 0 ? cones.length - 1 : selected - 1;
        },
        number() {
          setK(app, at, k);
          if (k >= 1 && Number.isInteger(k)) cones = cones.map((one, i) => (i === at ? { ...one, k } : one)); // prettier-ignore
        },
        move() {
          moveCone(app, at, picked, `${step}`);
          if (isFree && there < 0) cones = cones.map((one, i) => (i === at ? { ...one, vertex } : one)); // prettier-ignore
        },
        delete() {
          deleteCone(app, at);
          if (at in cones) selected = -1;
          cones = cones.filter((_, i) => i !== at);
        },
        clear() {
          if (step % 5 > 0) return; // seldom
          clearCones(app);
          [cones, selected] = [[], -1];
        },
        fewer() {
          cones = cones.slice(0, below(cones.length + 1));
          setPrescription(app, { ...doc.prescription, cones: doc.prescription.cones.slice(0, cones.length) }, 'restore cones'); // prettier-ignore
          if (selected >= cones.length) selected = -1;
        },
        turning() {
          setTurning(app, at, value);
          if (at in turnings && value !== 0.5) turnings[at] = value;
        },
        handle() {
          setHandle(app, at, value);
          if (at in handles) handles[at] = value === null || value === 0.5 ? null : (value + 4) % 4;
        },
      };
      const what = Object.keys(acts)[below(10)];
      const before = JSON.stringify([cones, selected]);
      acts[what]();
      const is = doc.prescription;
      assert.deepEqual(is.cones.map(({ vertex: v, k: own }) => [v, own]), cones.map(({ vertex: v, k: own }) => [v, own]), what); // prettier-ignore
      assert.deepEqual(
        [doc.selected, is.turnings, is.handles],
        [selected, turnings, handles],
        what,
      );
      if (JSON.stringify([cones, selected]) !== before) done.set(`${what} of ${Math.min(cones.length, 3)}`, true); // prettier-ignore
    }
  }
  for (const what of ['place of 1', 'next of 1', 'next of 3', 'previous of 1', 'number of 1', 'move of 1', 'delete of 0', 'clear of 0']) assert.ok(done.has(what), what); // prettier-ignore
});

test('undo leads back to cones that Run chooses, and to none that were asked for', async () => {
  const app = opened();
  const { doc } = app;
  doc.state.model.loaded = doc.settings;
  placeOrSelect(app, 0);
  await undo(app);
  assert.deepEqual([doc.hasUserCones, doc.needsCones], [false, true]);
  await redo(app);
  assert.equal(doc.hasUserCones, true);
  clearCones(app);
  assert.equal(doc.hasUserCones, true, 'without cones, as asked');
  await undo(app);
  await redo(app);
  assert.deepEqual([positionsOf(app), doc.hasUserCones], [[], true]);
});

test('cones at copies of one vertex stay apart when others are added for a balance', async () => {
  const cone = (vertex, triangle, k = 3) => ({ vertex, k, ...(triangle < 0 ? {} : { triangle }) });
  const given = [cone(7, -1), cone(5, 20), cone(5, 41), cone(9, 8)];
  // The solver sorts them, and names another triangle of the copy of vertex 9.
  const solver = { balanceCones: async (asked) => ({ q: asked.q, cones: [cone(5, 12), cone(5, 20), cone(5, 41), cone(7, -1), cone(9, 3), cone(9, 77, 5)] }) }; // prettier-ignore
  const all = await balanced({ solver }, { ...emptyPrescription(4, 0, 0), cones: given });
  assert.deepEqual(all, [...given, cone(5, 12), cone(9, 77, 5)]);
});

test('a click spends what is left, unless an open boundary takes it', () => {
  const surface = surfaceOf(cubeMesh(2));
  const component = { component: 0, have: 0, need: 8, left: 8, isBalanced: false };
  const budget = (openLoops) => ({ components: [{ ...component, openLoops }], cones: [] });
  assert.equal(leftAt(budget(0), surface, 3), 8);
  assert.equal(leftAt(budget(1), surface, 3), 0);
  assert.equal(leftAt(undefined, surface, 3), 0);
});

/** The page's context, as far as jobs need it. */
const contextOf = (doc) => ({ doc, client: { ready: () => Promise.resolve() } });
const options = (onFailure = assert.fail) => ({ kind: 'run', title: 'Running', onFailure });
const untilAborted = ({ signal }) =>
  new Promise((_, reject) => signal.addEventListener('abort', () => reject(signal.reason)));

test('how a job ends is a value: done, failed, cancelled, or replaced by another file', async () => {
  const { doc } = opened();
  const app = contextOf(doc);
  assert.equal(await runJob(app, options(), async () => undefined), 'done');
  const ends = runJob(app, options(), async () => void (doc.job = undefined));
  assert.equal(await ends, 'done', 'although it ended its job itself, to say how it went');
  const failures = [];
  const failing = runJob(
    app,
    options((error) => failures.push(error)),
    async () => {
      throw new Error('no');
    },
  );
  assert.equal(await failing, 'failed');
  assert.equal(failures.length, 1);

  const cancelled = runJob(app, options(), untilAborted);
  cancel(app);
  assert.equal(doc.isBusy, false, 'at once');
  assert.equal(await cancelled, 'cancelled');

  const replaced = runJob(app, options(), untilAborted);
  const next = runJob(app, options(), async () => undefined);
  assert.deepEqual(await Promise.all([replaced, next]), ['replaced', 'done']);

  // Another file: its name on the status line or not, the run of the one before is ended.
  const { signal } = await new Promise((resolve) => {
    void runJob(app, options(), (call) => {
      resolve(call);
      return untilAborted(call);
    }).then((outcome) => assert.equal(outcome, 'replaced'));
  });
  doc.clearModel();
  assert.equal(signal.aborted, true);
  assert.equal(doc.isBusy, false);
});

test('cones that are edited along features are kept by Run; those that it chose, or that are cleared, are not', () => {
  const app = opened();
  const { doc } = app;
  const keeps = () => doc.features?.keepsCones ?? false;
  const cones = [{ vertex: 3, k: 3 }];
  const place = (kind, placed = cones) =>
    assert.ok(setPrescription(app, { ...doc.prescription, cones: placed }, kind));
  place('add cone: 3');
  assert.equal(doc.features, undefined);
  const features = { hasCreases: true, hasRims: false, edges: [[0, 1]], rims: [] };
  doc.features = features;
  for (const kind of [
    'add cone: 3',
    'move cone: 1',
    'change k: 3',
    'balance',
    'import cones',
    'restore cones',
  ]) {
    // prettier-ignore
    doc.features = features;
    place(kind);
    assert.equal(keeps(), true, kind);
    assert.deepEqual({ ...doc.features, keepsCones: undefined }, { ...features, keepsCones: undefined }); // prettier-ignore
  }
  const kept = doc.features;
  place('change k: 3');
  assert.equal(doc.features, kept, 'the same edges as before');
  place('suggest cones');
  assert.equal(keeps(), false);
  place('move cone: 1');
  clearCones(app);
  assert.equal(keeps(), false);
  place('move cone: 1');
  keepCones(app, false);
  assert.equal(keeps(), false);
  doc.features = undefined;
  keepCones(app, true);
  assert.equal(doc.features, undefined);
  // What is not balanced prevents no run that chooses other cones.
  doc.features = features;
  doc.begin({ ...doc.prescription, cones });
  assert.equal(whyNotRun({ doc, client: {} }), '');
  keepCones(app, true);
  assert.equal(whyNotRun({ doc, client: {} }), doc.budget.text);
  // With another q, lines follow no edges, and the choice waits.
  doc.features = features;
  doc.begin(emptyPrescription(6, 0, 0));
  place('add cone: 3');
  assert.equal(doc.features, features);
});
