// When the map of a dragged cone takes steps to places out of its reach, which map it starts from, and what a drop
// promises. The solver's drag is a script here; tests/web/drag.test.mjs drags in a browser.

import assert from 'node:assert/strict';
import test from 'node:test';
import { beginLive, cancelLive, dragLive, dropLive } from '../../../web/src/actions/drag_live.ts';
import { moveCone } from '../../../web/src/actions/edit_cones.ts';
import { Document } from '../../../web/src/model/document.ts';
import { emptyPrescription } from '../../../web/src/model/prescription.ts';
import { locatedSurface } from '../../../web/src/services/geometry/placed_surface.ts';
import { cubeMesh } from '../../support/meshes.mjs';
import { plainFacts } from './plain_facts.mjs';
import { solutionOf, square } from './square_solution.mjs';

const mesh = cubeMesh(3);

/** Runs a test in a time that passes only when it says so: what is decided depends on milliseconds. */
async function inItsTime(act) {
  const { setTimeout } = globalThis;
  let now = 0;
  let timers = [];
  const settle = async () => {
    for (let i = 0; i < 5; i++) await new Promise((resolve) => setImmediate(resolve));
  };
  const pass = async (ms) => {
    const end = now + ms;
    for (;;) {
      await settle();
      const [next] = timers.filter(({ at }) => at <= end).sort((a, b) => a.at - b.at);
      if (!next) break;
      timers = timers.filter((one) => one !== next);
      now = next.at;
      next.act();
    }
    now = end;
  };
  globalThis.setTimeout = (act, ms = 0) => timers.push({ at: now + ms, act });
  performance.now = () => now;
  try {
    await act(pass);
  } finally {
    globalThis.setTimeout = setTimeout;
    delete performance.now;
  }
}

const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));
const cones = [0, 5, 9].map((vertex) => ({ vertex, k: 3 }));

/** A drag that is prepared in `took` ms, and certifies a vertex after as many steps as `stepsTo` says. */
function scripted(stepsTo, { took = 1 } = {}) {
  const calls = [];
  const spent = { inSteps: 0 };
  const asked = new Map();
  const answer = async (vertex) => {
    calls.push(vertex);
    const count = (asked.get(vertex) ?? 0) + 1;
    asked.set(vertex, count);
    const isFar = count <= (stepsTo[vertex] ?? 0);
    const begin = performance.now();
    if (count > 1) await pause(took);
    spent.inSteps += performance.now() - begin;
    return {
      state: isFar ? 'heat' : 'fails',
      isApproaching: isFar,
      ...{ vertex, uv: new Float64Array(2), cornerToUv: new Uint32Array(3) },
      ...{ logScale: new Float32Array(4), notPositive: new Uint32Array(0), reasons: ['scripted'] },
    };
  };
  let last = Promise.resolve(); // one call after the other, as the worker
  const drag = {
    dragTo: (vertex) => (last = last.then(() => answer(vertex))),
    dispose: async () => undefined,
  };
  const begun = [];
  const beginDrag = async (vertex) => {
    begun.push(vertex);
    await pause(took);
    return drag;
  };
  return { beginDrag, begun, calls, spent };
}

/** An open cube with three cones and a certified map of `mapped`. */
function opened(script, { mapped = {}, now = {} } = {}) {
  const doc = new Document();
  const arrays = {
    positions: Float64Array.from(mesh.vertices.flat()),
    triangles: Uint32Array.from(mesh.triangles.flat()),
  };
  const surface = { id: 1, ...locatedSurface(arrays, plainFacts(mesh)) };
  const components = [{ component: 0, eulerCharacteristic: 2, boundaryLoops: [] }];
  const info = { usable: true, genus: 0, components, file: { sha256: 'x', name: 'cube.obj' }, surfaces: [{}] }; // prettier-ignore
  const solver = { name: 'solver' };
  doc.state = { kind: 'open', model: { main: 'cube.obj', files: new Map(), info, surface, solver, loaded: { fix: {} } } }; // prettier-ignore
  const prescription = { ...emptyPrescription(4, 0, 0), cones, ...now };
  doc.begin(prescription);
  const map = { model: solver, isDisposed: false, beginDrag: script.beginDrag };
  doc.solutions = [
    {
      ...solutionOf(square()), // only its verdict is read
      ...{ surfaceId: 1, improve: doc.solve.improve, map },
      ...{ prescription: { ...prescription, ...mapped } },
    },
  ];
  return { doc, ui: { holdsCone: false } };
}

/** Moves the held cone, as the pointer does. */
function moveTo(app, vertex) {
  moveCone(app, 0, vertex, 'a drag');
  dragLive(app);
}

test('a place out of reach is asked for again when the hand rests, and not while it moves', () =>
  inItsTime(async (pass) => {
    const script = scripted({ 20: 1, 21: 1, 22: 2 }, { took: 60 });
    const app = opened(script);
    const over = beginLive(app, 0);
    await pass(70);
    for (const vertex of [20, 21, 22]) {
      moveTo(app, vertex);
      await pass(20);
      assert.equal(app.doc.live.state, 'heat');
    }
    assert.deepEqual(script.calls, [20, 21, 22], 'the hand moves');
    await pass(40);
    assert.deepEqual(script.calls, [20, 21, 22], 'it has not rested for long');
    await pass(200);
    assert.deepEqual(
      script.calls,
      [20, 21, 22, 22, 22],
      'one step after the other until it is there',
    );
    assert.equal(app.doc.live.state, 'fails');
    cancelLive(app);
    await over;
    assert.deepEqual(
      [app.doc.live, app.doc.promised, app.ui.holdsCone],
      [undefined, undefined, false],
    );
  }));

test('while the hand moves on and on, steps take a quarter of the time', () =>
  inItsTime(async (pass) => {
    const far = Object.fromEntries(Array.from({ length: 30 }, (_, i) => [20 + i, 2]));
    const script = scripted(far, { took: 10 });
    const app = opened(script);
    const over = beginLive(app, 0);
    await pass(60); // longer than three times what preparing took: the next step is due
    const begin = performance.now();
    for (let vertex = 20; vertex < 50; vertex++) {
      moveTo(app, vertex);
      await pass(15);
    }
    const share = script.spent.inSteps / (performance.now() - begin);
    assert.ok(share > 0.15 && share < 0.3, `${share} of the time`);
    cancelLive(app);
    await over;
  }));

test('a cone that is dropped out of reach is promised a map, without further steps', () =>
  inItsTime(async (pass) => {
    const script = scripted({ 20: 5 }, { took: 30 });
    const app = opened(script);
    const over = beginLive(app, 0);
    await pass(40);
    moveTo(app, 20);
    dropLive(app, 'a drag');
    await over;
    assert.deepEqual(script.calls, [20]);
    assert.deepEqual(app.doc.promised, app.doc.wanted);
    assert.equal(app.doc.promised.prescription.cones[0].vertex, 20);
  }));

test('a drag that is given up asks for nothing more, wherever its steps were', () =>
  inItsTime(async (pass) => {
    for (const wait of [10, 100, 150, 220]) {
      const script = scripted({ 20: 9 }, { took: 60 });
      const app = opened(script, { now: { handles: [1, null] } });
      const over = beginLive(app, 0);
      await pass(70);
      moveTo(app, 20);
      await pass(wait);
      cancelLive(app);
      await over;
      const asked = script.calls.length;
      assert.ok(asked > 0);
      await pass(5000);
      assert.equal(script.calls.length, asked, `after ${wait} ms`);
      assert.equal(app.doc.live, undefined);
    }
  }));

test('where handles are prescribed the steps go on, since rotations follow the path; what fails is not promised', () =>
  inItsTime(async (pass) => {
    const script = scripted({ 20: 3 });
    const app = opened(script, { now: { handles: [1, null] } });
    const over = beginLive(app, 0);
    await pass(20);
    moveTo(app, 20);
    dropLive(app, 'a drag');
    await pass(50);
    await over;
    assert.deepEqual(script.calls, [20, 20, 20, 20]);
    assert.equal(app.doc.promised, undefined);
  }));

test('the map is that of the cones, or one with this cone alone elsewhere, also at another copy of its vertex', () =>
  inItsTime(async (pass) => {
    const at = (place) => ({ cones: [{ ...place, k: 3 }, ...cones.slice(1)] });
    const beginsAt = async (mapped, now) => {
      const script = scripted({});
      const app = opened(script, { mapped, now });
      const over = beginLive(app, 0);
      await pass(5);
      cancelLive(app);
      await over;
      return script.begun;
    };
    assert.deepEqual(await beginsAt({}), [0]);
    assert.deepEqual(await beginsAt(at({ vertex: 30 })), [30], 'dragged on from where its map is');
    assert.deepEqual(await beginsAt(at({ vertex: 0, triangle: 7 })), [0]);
    assert.deepEqual(await beginsAt({}, at({ vertex: 0, triangle: 7 })), [0]);
    assert.deepEqual(await beginsAt({ cones: cones.slice(0, 2) }), [], 'another number of cones');
    assert.deepEqual(await beginsAt({ cones: [{ vertex: 30, k: 5 }, ...cones.slice(1)] }), []);
    assert.deepEqual(await beginsAt({ cones: [cones[0], { vertex: 30, k: 3 }, cones[2]] }), []);
  }));

test('a cone is held until the last drag is over, however many were begun while those before were being stored', () =>
  inItsTime(async (pass) => {
    const app = opened(scripted({}, { took: 50 }));
    const isOver = [];
    for (let i = 0; i < 3; i++) {
      const over = beginLive(app, 0);
      isOver[i] = false;
      void over.then(() => (isOver[i] = true));
      assert.equal(app.ui.holdsCone, true);
      moveTo(app, 20 + i);
      if (i < 2) dropLive(app, `move cone: ${i}`);
    }
    const seen = new Set();
    for (let at = 0; at < 60; at++) {
      await pass(10);
      const left = isOver.filter((is) => !is).length;
      assert.equal(app.ui.holdsCone, left > 0, `${left} of ${isOver.length} are not over`);
      seen.add(left);
      if (at === 50) cancelLive(app);
    }
    assert.ok(seen.has(1) && seen.has(0), `${[...seen]}`);
  }));
