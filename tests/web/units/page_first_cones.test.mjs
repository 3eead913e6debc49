// The cones that a model has when it is opened: those of the version before, with and without repairs, those that were placed in
// an earlier session, those of a link; and what is told of each.

import assert from 'node:assert/strict';
import test from 'node:test';
import { cubeMesh, toObj, toOff } from '../../support/meshes.mjs';
import { database } from './database_stand_in.mjs';
import { click, drawn, openFiles, openPage, skip, until } from './whole_page.mjs';

globalThis.indexedDB = database((act) => setImmediate(act));
const { followLink } = await import('../../../web/src/actions/follow_link.ts');
const { moveFromPrevious, offerSaved } = await import('../../../web/src/actions/first_cones.ts');
const { runJob } = await import('../../../web/src/actions/job.ts');
const { repair, repairAll } = await import('../../../web/src/actions/repair.ts');
const { setPrescription } = await import('../../../web/src/actions/edit_cones.ts');
const { restorable, saveCones } = await import('../../../web/src/services/cone_storage.ts');

const plain = cubeMesh(4);
const corners = [0, 1, 2].map((vertex) => ({ vertex, k: 3 }));
/** With one triangle turned round, which a repair turns back. */
const broken = { ...plain, triangles: plain.triangles.with(40, plain.triangles[40].toReversed()) };
/** Another file of the same surface. */
const another = ({ vertices, triangles }) => ({ vertices, triangles: triangles.toReversed() });
const call = { signal: new AbortController().signal, onProgress() {} };

const place = (app, cones = corners) => setPrescription(app, { ...app.doc.prescription, cones }, 'place cones'); // prettier-ignore
const conesIn = ({ doc }) => doc.prescription.cones.map(({ vertex, k }) => ({ vertex, k }));
async function pageWith(t, files) {
  const app = await openPage(t);
  await openFiles(app, files);
  return app;
}

test(
  'a repair is said to be done; cones of a version before are moved by the repair that makes this one usable',
  { skip },
  async (t) => {
    const repairs = { one: (app) => repair(app, ['orient']), all: repairAll };
    for (const [name, act] of Object.entries(repairs)) {
      const alone = await pageWith(t, { 'cube.off': toOff(broken) });
      assert.equal(await act(alone), true);
      const { doc } = alone;
      assert.match(doc.message.text, /^Done: /, name);
      assert.deepEqual([doc.message.kind, doc.stateName, doc.hasUserCones], ['good', 'ready', false]); // prettier-ignore

      const app = await pageWith(t, { 'cube.off': toOff(another(plain)) });
      place(app);
      await openFiles(app, { 'cube.off': toOff(broken) });
      assert.deepEqual([app.doc.stateName, conesIn(app)], ['invalid', []]);
      assert.equal(await act(app), true);
      assert.deepEqual(conesIn(app), corners, name);
      assert.match(app.doc.message.text, /^Another version of cube\.off/);
      assert.deepEqual([app.doc.hasUserCones, app.doc.previous], [true, undefined]);
      app.doc.history = app.doc.history.undo();
      assert.deepEqual([conesIn(app), app.doc.usableModel !== undefined], [[], true]);
    }
  },
);

test(
  'where no cone has a place in the new version, or they could not be moved, this is what is said',
  { skip },
  async (t) => {
    const far = { ...broken, vertices: broken.vertices.map(([x, y, z]) => [x + 90, y, z]) };
    const app = await pageWith(t, { 'cube.off': toOff(plain) });
    const { doc } = app;
    place(app);
    await openFiles(app, { 'cube.off': toOff(far) });
    await repairAll(app);
    assert.deepEqual([conesIn(app), doc.message.kind], [[], 'good']);
    assert.match(doc.message.text, /^Done: /);

    const other = await pageWith(t, { 'cube.off': toOff(plain) });
    place(other);
    const { model, prescription } = other.doc;
    await openFiles(other, { 'cube.off': toOff(broken) });
    const { previous } = other.doc;
    assert.equal(previous.model, model);
    other.doc.previous = { model: { ...model, solver: { isDisposed: false } }, prescription }; // nothing that the solver knows
    await repairAll(other);
    assert.equal(other.doc.message.kind, 'error', 'no “Done” takes its place');
    assert.deepEqual(conesIn(other), []);
  },
);

test(
  'cones are moved from another content of the same file and mesh, and from nothing else',
  { skip },
  async (t) => {
    const app = await pageWith(t, { 'cube.obj': toObj(plain) });
    const { doc } = app;
    place(app);
    const before = { model: doc.model, prescription: doc.prescription };
    await openFiles(app, { 'cube.obj': toObj(another(plain)) });
    assert.deepEqual(conesIn(app), corners);
    const [{ model: now }, { model: old }] = [doc, before];
    const surfaces = [now.info.surfaces[0], now.info.surfaces[0]];
    const withInfo = (model, more) => ({ ...model, info: { ...model.info, ...more } });
    /** What becomes of the cones of one model when another is opened. */
    const move = async (to, from, cones = corners) => {
      doc.begin({ ...doc.prescription, cones: [] });
      doc.message = undefined;
      doc.previous = from && { model: from, prescription: { ...before.prescription, cones } };
      const isMoved = await moveFromPrevious(app, to, call);
      assert.equal(doc.previous, undefined, 'it is let go in any case');
      assert.equal(isMoved, doc.message !== undefined, 'it says so where it says something');
      return isMoved ? conesIn(app) : [];
    };
    assert.deepEqual(await move(now, old), corners);
    assert.deepEqual(await move(withInfo(now, { surfaces }), old), corners, 'the same mesh of two');
    assert.deepEqual(await move(now, withInfo(old, { surface: 1 })), corners, 'the only mesh');
    assert.deepEqual(await move(withInfo(now, { surfaces }), withInfo(old, { surface: 1 })), []);
    assert.deepEqual(await move(now, undefined), []);
    assert.deepEqual(await move(now, { ...old, main: 'other.obj' }), []);
    assert.deepEqual(await move(now, withInfo(old, { file: now.info.file })), [], 'as it was');
    assert.deepEqual(await move(now, old, []), [], 'none');
    assert.deepEqual(await move(now, old, corners.slice(0, 1)), corners.slice(0, 1));
    // A move that was stopped is no failure, whoever stopped it and whatever the solver says then.
    for (const isStopped of [false, true])
      for (const error of [new DOMException('', 'AbortError'), new Error('not so')]) {
        const controller = new AbortController();
        if (isStopped) controller.abort();
        const solver = { transferCones: () => Promise.reject(error) };
        doc.message = undefined;
        doc.previous = { model: old, prescription: before.prescription };
        const moving = moveFromPrevious(app, { ...now, solver }, { ...call, signal: controller.signal }); // prettier-ignore
        if (isStopped || error.name === 'AbortError') {
          await assert.rejects(moving, (thrown) => thrown === error);
          assert.equal(doc.message, undefined);
        } else {
          assert.equal(await moving, true);
          assert.deepEqual([doc.message.kind, doc.message.text.includes('not so')], ['error', true]); // prettier-ignore
        }
      }
    await old.solver.dispose();
    assert.deepEqual(await move(now, old), [], 'the solver has it no longer');
  },
);

test(
  'cones of an earlier session are offered beside what was said, unless something is prescribed or under way',
  { skip },
  async (t) => {
    const app = await pageWith(t, { 'cube.obj': toObj(cubeMesh(3)) });
    const { doc } = app;
    const { model } = doc;
    await offerSaved(app, model);
    assert.equal(doc.message, undefined, 'nothing is stored');
    await saveCones(model.info, { ...doc.prescription, cones: [] });
    await offerSaved(app, model);
    assert.equal(doc.message, undefined, 'no cones are stored');
    for (const cones of [corners.slice(0, 1), corners]) {
      await saveCones(model.info, { ...doc.prescription, cones });
      doc.message = undefined;
      await offerSaved(app, model);
      assert.deepEqual([doc.message.kind, doc.message.actions.length], ['note', 1]);
      const has = () => {};
      doc.message = { kind: 'error', text: 'said before.', actions: [{ label: 'a', run: has }] };
      await offerSaved(app, model);
      const { kind, text, actions } = doc.message;
      assert.deepEqual([kind, actions.length, actions[0].run], ['error', 2, has]);
      assert.match(text, /^said before\. \S/);
      actions[1].run();
      assert.deepEqual(conesIn(app), cones);
      doc.message = undefined;
      await offerSaved(app, model);
      assert.equal(doc.message, undefined, 'there are cones');
      doc.history = doc.history.undo();
      assert.deepEqual(conesIn(app), []);
    }
    const unlessIs = async (what, set, back) => {
      set();
      doc.message = undefined;
      await offerSaved(app, model);
      assert.equal(doc.message, undefined, what);
      back();
    };
    await runJob(app, { kind: 'run', title: 'Running' }, () => offerSaved(app, model));
    assert.equal(doc.message, undefined, 'a job');
    const { state } = doc;
    await unlessIs('another model', () => (doc.state = { ...state, model: { ...model } }), () => (doc.state = state)); // prettier-ignore
    const { prescription } = doc;
    await unlessIs('a turning', () => doc.begin({ ...prescription, turnings: [0] }), () => doc.begin(prescription)); // prettier-ignore
    await offerSaved(app, model);
    assert.notEqual(doc.message, undefined);
    // Opened once more, by the same name or another, it is offered; whoever has asked for none is asked nothing.
    doc.message = undefined;
    await openFiles(app, { 'same.obj': toObj(cubeMesh(3)) });
    await until(() => doc.message?.actions?.length === 1);
  },
);

test(
  'what is stored of a mesh is its own, is the last that was placed, and is read only as it was written',
  { skip },
  async (t) => {
    const app = await pageWith(t, { 'cube.obj': toObj(cubeMesh(2)) });
    const { doc } = app;
    const { info } = doc.model;
    place(app, corners.slice(0, 2));
    place(app, corners);
    await until(() => globalThis.indexedDB.all.get('hgp') !== undefined);
    const cones = async (mesh) => (await restorable(mesh))?.prescription.cones;
    await drawn();
    assert.deepEqual(await cones(info), corners);
    assert.deepEqual(await cones({ ...info, surface: 1 }), undefined);
    const good = { ...doc.prescription, turnings: [null, -2], handles: [null, 3] };
    const some = { ...info, surface: 2 };
    const bad = {
      q: [0, -4, 1.5, '4'],
      cones: [undefined, {}, [{ vertex: -1, k: 3 }], [{ vertex: 0.5, k: 3 }], [{ vertex: 0, k: 0.5 }], [null], [corners[0], { vertex: 1 }]], // prettier-ignore
      turnings: [undefined, [1.5], [null, 'a']],
      handles: [undefined, [undefined], [0, 1.5]],
    };
    await saveCones(some, good);
    assert.deepEqual((await restorable(some)).prescription, good);
    for (const [key, values] of Object.entries(bad)) {
      for (const value of values) {
        await saveCones(some, { ...good, [key]: value });
        assert.equal(await restorable(some), undefined, `${key}: ${JSON.stringify(value)}`);
      }
    }
    await saveCones(some, { ...good, q: 1 });
    assert.equal((await restorable(some)).prescription.q, 1);
  },
);

test(
  'closing a model stores the cones that are shown, and where there are none leaves what is stored',
  { skip },
  async (t) => {
    const app = await openPage(t);
    const files = { 'cube.obj': toObj(cubeMesh(4)) };
    const { doc } = app;
    const closedWith = async (prepare) => {
      await openFiles(app, files);
      const { info } = doc.model;
      await prepare(info);
      await click('#close');
      return (await restorable(info))?.prescription.cones;
    };
    const undone = (steps) => () => {
      const { prescription } = doc;
      for (let n = 1; n <= corners.length; n++) setPrescription(app, { ...prescription, cones: corners.slice(0, n) }, `add cone: ${n}`); // prettier-ignore
      for (let i = 0; i < steps; i++) doc.history = doc.history.undo();
    };
    assert.deepEqual(await closedWith(undone(0)), corners);
    assert.deepEqual(await closedWith(undone(2)), corners.slice(0, 1));
    assert.deepEqual(await closedWith(undone(1)), corners.slice(0, 2));
    assert.deepEqual(await closedWith(undone(3)), corners, 'those that were placed last');
    assert.deepEqual(await closedWith(() => {}), corners, 'nobody has asked for them');
    const stored = corners.slice(0, 2);
    assert.deepEqual(await closedWith((info) => saveCones(info, { ...doc.prescription, cones: stored })), stored); // prettier-ignore
    assert.deepEqual(await closedWith(() => place(app, [])), [], 'they were taken away');
  },
);

test(
  'a link brings its cones, turnings and edges to its own model, and takes nothing from anybody',
  { skip },
  async (t) => {
    const app = await pageWith(t, { 'cube.obj': toObj(cubeMesh(3)) });
    const { doc } = app;
    const { info, surface } = doc.model;
    const { modelTag } = await import('../../../web/src/formats/hash_state.ts');
    const follow = async (state) => {
      doc.begin({ q: 4, cones: [], turnings: [], handles: [] });
      doc.message = undefined;
      doc.features = undefined;
      followLink(app, state);
      await drawn();
      return [conesIn(app), doc.message === undefined];
    };
    const last = [{ vertex: surface.vertexCount - 1, k: 3 }];
    const past = [{ vertex: surface.vertexCount, k: 3 }];
    assert.deepEqual(await follow({ cones: corners }), [corners, true]);
    assert.deepEqual(await follow({ cones: corners, model: modelTag(info) }), [corners, true]);
    assert.deepEqual(await follow({ cones: corners, model: '0' }), [[], false]);
    assert.deepEqual(await follow({ cones: last }), [last, true]);
    assert.deepEqual(await follow({ cones: past }), [[], false], 'no vertex of the model');
    assert.deepEqual(await follow({ q: 6, model: '0' }), [[], true], 'there is nothing of a model');
    assert.equal(doc.prescription.q, 6);
    const [v, w] = [surface.triangles[0], surface.triangles[1]];
    const features = { edges: [[v, w]], hasRims: false, hasCreases: false };
    assert.deepEqual(await follow({ features, model: '0' }), [[], false]);
    assert.deepEqual(await follow({ features }), [[], true]);
    assert.equal(doc.features?.edges.length, 1);
    assert.equal(doc.history.canUndo, false, 'edges are no cones');
    for (const key of ['turnings', 'handles']) {
      assert.deepEqual(await follow({ [key]: [[0, 1]], model: '0' }), [[], false], key);
      doc.begin({ q: 4, cones: [], turnings: [null, 5], handles: [null, 2] });
      followLink(app, { [key]: [[0, 1]] });
      await drawn();
      const expected = { turnings: [null, 5], handles: [null, 2], [key]: [1, key === 'turnings' ? 5 : 2] }; // prettier-ignore
      assert.deepEqual([doc.prescription.turnings, doc.prescription.handles], [expected.turnings, expected.handles]); // prettier-ignore
    }
    // Whoever has placed cones keeps them.
    const own = [{ vertex: 9, k: 3 }];
    doc.begin({ q: 4, cones: own, turnings: [], handles: [] });
    followLink(app, { cones: corners });
    await drawn();
    assert.deepEqual(conesIn(app), own);
    // Opened later, the model gets them then, once.
    await click('#close');
    followLink(app, { cones: corners });
    await drawn();
    assert.deepEqual(conesIn(app), []);
    await openFiles(app, { 'cube.obj': toObj(cubeMesh(3)) });
    await until(() => conesIn(app).length === 3);
    setPrescription(app, { ...doc.prescription, cones: [] }, 'clear cones');
    await drawn();
    assert.deepEqual(conesIn(app), []);
  },
);
