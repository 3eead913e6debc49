// What the page does not do: edits while the solver runs, actions that lack what they need, steps that lead nowhere, answers that
// come too late. The document is then as it was, and who asked is told where that is not plain to see.

import assert from 'node:assert/strict';
import test from 'node:test';
import { blocks, eight } from '../../support/blocks.mjs';
import { cubeMesh, toGlb, toObj } from '../../support/meshes.mjs';
import { $, drawn, openFiles, openPage, runNow, skip, until } from './whole_page.mjs';

const load = (name) => import(`../../../web/src/actions/${name}.ts`);
const edit = await load('edit_cones');
const { cancel, runJob } = await load('job');
const solving = await load('solve');
const featuring = await load('features');
const { actionIds, actions, perform, whyNotOf } = await load('registry');
const { returnTo } = await load('compare_runs');
const { setConeStep } = await load('cone_slider');
const { evenOut } = await load('even_out');
const { switchMesh } = await load('load');
const { mirrorCone } = await load('mirror_cone');
const { usePreset } = await load('presets');
const { leaveRepairsOut, repair, repairAll, repairAndRun, placeOnAny } = await load('repair');
const { runAll } = await load('run_all');
const { redo, undo } = await load('undo');

async function pageWith(t, files) {
  const app = await openPage(t);
  await openFiles(app, files);
  app.ui.setAutomatic(false);
  return app;
}

/** What an action may change of a document. */
const stateOf = ({ doc }) => ({
  ...{ history: doc.history, solve: doc.solve, features: doc.features, selected: doc.selected },
  ...{ state: doc.state, solutions: doc.solutions, meshes: doc.meshes, isUnsaved: doc.isUnsaved },
  ...{ quads: doc.quads, coneStep: doc.coneStep, field: doc.field },
});
function unchanged(app, before, what) {
  for (const [key, value] of Object.entries(stateOf(app))) assert.equal(value, before[key], `${what}: ${key}`); // prettier-ignore
}

/** A job that lasts until it is cancelled. */
function lasting(app, kind) {
  const ended = new Promise((resolve) => {
    const work = ({ signal }) => new Promise((_, reject) => signal.addEventListener('abort', () => reject(signal.reason))); // prettier-ignore
    void runJob(app, { kind, title: 'Lasting', onFailure: assert.fail }, work).then(resolve);
  });
  return ended;
}

test(
  'while the solver runs nothing is edited, and who tries is offered to cancel it',
  { skip },
  async (t) => {
    const app = await pageWith(t, { 'eight.glb': toGlb([blocks(eight, { open: ['0 0 +z'] }), cubeMesh(2)]) }); // prettier-ignore
    const { doc, ui } = app;
    assert.equal(doc.model.info.surface, 0);
    await runNow(app);
    const [first] = doc.solutions;
    edit.deleteCone(app, 0);
    doc.history = doc.history.undo();
    doc.selected = 0;
    const cone = doc.prescription.cones[0];
    const { surface } = doc.model;
    const taken = new Set(doc.prescription.cones.map(({ vertex }) => vertex));
    const free = [...surface.angle.keys()].find((v) => !taken.has(v) && !surface.isBoundary[v]);
    const edge = [surface.triangles[0], surface.triangles[1]];
    const other = { ...first, improve: 0.5, prescription: { ...first.prescription, cones: [] } };
    const tries = {
      place: () => edit.placeOrSelect(app, free),
      placeOnAny: () => placeOnAny(app, free),
      k: () => edit.setK(app, 0, cone.k + 1),
      move: () => edit.moveCone(app, 0, free, 'drag'),
      delete: () => edit.deleteCone(app, 0),
      clear: () => edit.clearCones(app),
      turning: () => edit.setTurning(app, 0, 3),
      handle: () => edit.setHandle(app, 0, 1),
      order: () => edit.setOrder(app, 8),
      import: () => edit.importCones(app, 'a.cones.json', '{}'),
      mirror: () => mirrorCone(app),
      even: () => evenOut(app),
      creases: () => featuring.followCreases(app, true),
      rims: () => featuring.followRims(app, true),
      symmetric: () => featuring.mirrorMap(app, true),
      chain: () => featuring.chooseChain(app, edge, false),
      suggest: () => solving.suggestCones(app),
      realign: () => solving.realign(app, { cells: 50 }),
      preset: () => usePreset(app, 'quads'),
      few: () => usePreset(app, 'few'),
      step: () => setConeStep(app, 4),
      run: () => returnTo(app, other),
      mesh: () => switchMesh(app, 1),
      repairs: () => repair(app, ['orient']),
      all: () => repairAll(app),
      none: () => leaveRepairsOut(app),
      undo: () => undo(app),
      redo: () => redo(app),
    };
    const { target } = ui;
    for (const [name, act] of Object.entries(tries)) {
      const before = stateOf(app);
      const ended = lasting(app, 'run');
      await act();
      assert.equal(doc.message?.actions?.length, 1, name);
      unchanged(app, before, name);
      assert.equal(doc.job?.title, 'Lasting', `${name}: it goes on`);
      doc.message.actions[0].run();
      assert.equal(await ended, 'cancelled', name);
      assert.equal(doc.isBusy, false);
    }
    assert.equal(ui.target, target);
    // What needs the solver is refused with a reason.
    for (const act of [() => solving.run(app)]) {
      const ended = lasting(app, 'run');
      assert.equal(await act(), 'refused');
      assert.equal(doc.message.kind, 'error');
      await perform(app, 'cancel');
      assert.equal(await ended, 'cancelled');
    }
    // Loading does not lock the cones, but undo waits for it.
    doc.history = doc.history.redo();
    const ended = lasting(app, 'load');
    const { history } = doc;
    await undo(app);
    assert.equal(doc.history, history);
    edit.setK(app, 0, 2);
    assert.notEqual(doc.history, history);
    await perform(app, 'cancel');
    assert.equal(await ended, 'cancelled');
    assert.equal(doc.message.actions, undefined);
  },
);

test(
  'an action without what it needs says so and does nothing; with it, it has no reason not to',
  { skip },
  async (t) => {
    const app = await openPage(t);
    const { doc, ui } = app;
    const needs = {
      model: ['close', 'copy-link', 'copy-command', 'import-cones', 'suggest', 'balance', 'run', 'run-all'], // prettier-ignore
      cones: ['export-cones', 'clear-cones', 'next-cone', 'previous-cone'],
      selected: ['larger-k', 'smaller-k', 'mirror-cone', 'delete-cone'],
      map: ['download', 'save-report', 'validate', 'download-quads', 'seams'],
      steps: ['undo', 'redo'],
      job: ['cancel'],
      repairs: ['repair-and-run'],
      runs: ['compare'],
    };
    const lacking = (...kinds) => new Set(kinds.flatMap((kind) => needs[kind]));
    const all = Object.keys(needs);
    const refuses = async (what, missing) => {
      for (const id of Object.values(needs).flat()) {
        const isMissing = missing.has(id);
        assert.equal(whyNotOf(app, id) !== '', isMissing, `${what}: ${id}`);
        if (!isMissing) continue;
        const before = stateOf(app);
        doc.message = undefined;
        await perform(app, id);
        assert.equal(doc.message.text, whyNotOf(app, id), `${what}: ${id}`);
        unchanged(app, before, `${what}: ${id}`);
        assert.deepEqual([ui.dialog, doc.isBusy], ['', false]);
      }
    };
    const but = (missing, ...ids) => new Set([...missing].filter((id) => !ids.includes(id)));
    await refuses('no model', lacking(...all));
    await openFiles(app, { 'cube.obj': toObj(cubeMesh(3)) });
    ui.setAutomatic(false);
    const none = new Set([...lacking('cones', 'selected', 'map', 'steps', 'job', 'repairs', 'runs'), 'run-all']); // prettier-ignore
    await refuses('no cones', none);
    edit.placeOrSelect(app, 0);
    const placed = but(none, ...needs.cones, ...needs.selected, 'undo');
    doc.selected = -1;
    await refuses('one cone, none selected', new Set([...placed, ...needs.selected, 'run']));
    doc.selected = 0;
    await refuses('the first cone selected', new Set([...placed, 'run']));
    doc.history = doc.history.undo();
    doc.selected = -1;
    await refuses('a step back', but(none, 'redo'));
    await runNow(app);
    await refuses('a map', new Set(['redo', 'cancel', 'repair-and-run', 'compare', 'run-all', 'balance', ...needs.selected])); // prettier-ignore
    for (const id of actionIds) assert.ok(actions[id].label, id);
    for (const kind of ['needs-files', 'pick-model', 'dialog']) {
      const { isDialogOpen } = await load('registry');
      assert.equal(isDialogOpen(app), false);
      const { state } = doc;
      if (kind === 'dialog') ui.dialog = 'help';
      else doc.state = { kind, files: new Map(), main: 'a', missing: [], candidates: [] };
      assert.equal(isDialogOpen(app), true, kind);
      [doc.state, ui.dialog] = [state, ''];
    }
  },
);

test(
  'cones are where cones can be: at no boundary, at no vertex twice, and at none that a repair took away',
  { skip },
  async (t) => {
    const app = await pageWith(t, { 'tray.obj': toObj(blocks(['##'], { n: 2, open: ['0 0 +z'] })) }); // prettier-ignore
    const { doc } = app;
    const { surface } = doc.model;
    const rim = [...surface.isBoundary.keys()].find((v) => surface.isBoundary[v]);
    const [a, b, c] = [...surface.isBoundary.keys()].filter((v) => !surface.isBoundary[v]);
    const places = () => doc.prescription.cones.map(({ vertex }) => vertex);
    edit.placeOrSelect(app, rim);
    assert.deepEqual([places(), doc.message.kind], [[], 'error']);
    assert.equal(edit.coneToPlace(app, rim), undefined);
    edit.placeOrSelect(app, a);
    edit.placeOrSelect(app, b);
    assert.deepEqual([places(), doc.selected], [[a, b], 1]);
    const { history } = doc;
    edit.placeOrSelect(app, a);
    assert.deepEqual([doc.history === history, doc.selected], [true, 0]);
    for (const to of [a, b, rim, surface.vertexCount]) edit.moveCone(app, 0, to, 'drag');
    edit.moveCone(app, 2, c, 'drag');
    edit.deleteCone(app, 2);
    edit.setK(app, 0, doc.prescription.cones[0].k);
    edit.setK(app, 2, 5);
    edit.setTurning(app, 0, 0.5);
    edit.setOrder(app, 4);
    assert.equal(doc.history, history, 'nothing of it is a step');
    const gone = surface.representative.slice().fill(-1, c, c + 1);
    doc.state = { kind: 'open', model: { ...doc.model, surface: { ...surface, representative: gone } } }; // prettier-ignore
    doc.message = undefined;
    edit.placeOrSelect(app, c);
    assert.deepEqual([doc.history === history, doc.message?.kind], [true, 'error']);
    edit.moveCone(app, 0, c, 'drag');
    assert.equal(edit.coneToPlace(app, c), undefined);
    assert.equal(doc.history, history);
    edit.setTurning(app, 0, null);
    edit.setTurning(app, 0, -2);
    assert.deepEqual(doc.prescription.turnings, [-2]);
    // Selecting goes round, in both directions, from none as well.
    const selects = (from, step) => {
      doc.selected = from;
      edit.selectNext(app, step);
      return doc.selected;
    };
    assert.deepEqual([selects(-1, 1), selects(0, 1), selects(1, 1)], [0, 1, 0]);
    assert.deepEqual([selects(-1, -1), selects(0, -1), selects(1, -1)], [1, 1, 0]);
    doc.selected = 1;
    edit.deleteCone(app, 0);
    assert.deepEqual([places(), doc.selected], [[b], -1]);
    edit.clearCones(app);
    edit.selectNext(app, 1);
    assert.deepEqual([places(), doc.selected], [[], -1]);
  },
);

test(
  'what is asked for and then overtaken by an edit or another file has no effect',
  { skip },
  async (t) => {
    const app = await pageWith(t, { 'cube.obj': toObj(cubeMesh(4)) });
    const { doc } = app;
    edit.placeOrSelect(app, 0);
    const place = () => edit.setPrescription(app, { ...doc.prescription, cones: [{ vertex: 5, k: 3 }] }, 'place'); // prettier-ignore
    const overtaken = async (what, act, overtake) => {
      const asked = act();
      overtake();
      const after = stateOf(app);
      await asked;
      await drawn();
      unchanged(app, after, what);
    };
    doc.selected = 0;
    await overtaken('mirrored', () => mirrorCone(app), place);
    await overtaken('balanced', () => edit.balance(app), () => edit.clearCones(app)); // prettier-ignore
    await overtaken('creases', () => featuring.followCreases(app, true), () => (doc.state = { kind: 'open', model: { ...doc.model } })); // prettier-ignore
    // A failure is told, and leaves everything as it is.
    const { model } = doc;
    const failing = async (what, act) => {
      doc.state = { kind: 'open', model: { ...model, solver: lost } };
      doc.message = undefined;
      const before = stateOf(app);
      await act();
      unchanged(app, before, what);
      assert.equal(doc.message?.kind, 'error', what);
    };
    const lost = await app.client.load({ main: 'cube.obj', files: model.files });
    await lost.dispose();
    place();
    await failing('balanced', () => edit.balance(app));
    await failing('creases', () => featuring.followCreases(app, true));
    await failing('imported', () => edit.importCones(app, 'a.cones.json', '{}'));
    await failing('suggested', () => solving.suggestCones(app));
    doc.state = { kind: 'open', model };
    // A balance that is there already needs none.
    const eight = [...Array(8).keys()].map((vertex) => ({ vertex, k: 3 }));
    edit.setPrescription(app, { ...doc.prescription, cones: eight }, 'place');
    const { history } = doc;
    await edit.balance(app);
    assert.deepEqual([doc.history === history, doc.message.kind], [true, 'note']);
  },
);

test(
  'a mirror: what lies in the plane is its own image; a surface without one has none; creases that are none are told',
  { skip },
  async (t) => {
    const lopsided = () => {
      const { vertices, triangles } = cubeMesh(3);
      return { vertices: vertices.map(([x, y, z]) => [1.3 * x + 0.3 * y * z, y + 0.4 * x * z + 0.2 * z, 0.7 * z + 0.1 * x * x]), triangles }; // prettier-ignore
    };
    const app = await pageWith(t, { 'bent.obj': toObj(lopsided()) });
    const { doc } = app;
    edit.placeOrSelect(app, 0);
    let { history } = doc;
    await mirrorCone(app);
    assert.deepEqual([doc.history === history, doc.message.kind], [true, 'error']);
    const ball = (n) => {
      const { vertices, triangles } = cubeMesh(n);
      return { vertices: vertices.map((p) => p.map((x) => x / Math.hypot(...p))), triangles };
    };
    await openFiles(app, { 'ball.obj': toObj(ball(8)) });
    await featuring.followCreases(app, true);
    assert.deepEqual(
      [doc.features, doc.message.kind],
      [undefined, 'note'],
      'a ball has no creases',
    );
    featuring.mirrorMap(app, true);
    assert.equal(doc.features.isSymmetric, true);
    const { features } = doc;
    await featuring.followCreases(app, true);
    assert.deepEqual(doc.features, features, 'what was chosen stays');
    featuring.mirrorMap(app, false);
    assert.equal(doc.features, undefined);

    await openFiles(app, { 'cube.obj': toObj(cubeMesh(4)) });
    const { opposite } = await app.geometry.call('opposite', [doc.model.surface.id, 0]).then(({ vertex }) => ({ opposite: vertex })); // prettier-ignore
    assert.notEqual(opposite, 0);
    const places = () => doc.prescription.cones.map(({ vertex }) => vertex);
    const inPlane = async () => {
      for (const v of doc.model.surface.angle.keys()) {
        const { vertex } = await app.geometry.call('opposite', [doc.model.surface.id, v]);
        if (vertex === v) return v;
      }
      return -1;
    };
    const own = await inPlane();
    edit.placeOrSelect(app, own);
    ({ history } = doc);
    await mirrorCone(app);
    assert.deepEqual([doc.history === history, doc.message.kind, places()], [true, 'note', [own]]);
    edit.placeOrSelect(app, 0);
    await mirrorCone(app);
    assert.deepEqual([places(), doc.selected, doc.message.kind], [[own, 0, opposite], 2, 'good']);
    doc.selected = 1;
    await mirrorCone(app);
    assert.deepEqual([places(), doc.selected], [[own, 0, opposite], 2], 'it is there already');
  },
);

test('a rim is one line, chosen by any of its edges and taken out again', { skip }, async (t) => {
  const app = await pageWith(t, { 'tray.obj': toObj(blocks(['##'], { n: 2, open: ['0 0 +z'] })) }); // prettier-ignore
  const { doc } = app;
  const { edgeMap } = await load('keep_features');
  const map = edgeMap(app);
  for (const edge of map.rims()) {
    featuring.chooseChain(app, edge, false);
    assert.deepEqual([doc.features.hasRims, doc.features.edges], [true, []]);
    featuring.chooseChain(app, edge, true);
    assert.equal(doc.features, undefined);
  }
  const { triangles } = doc.model.surface;
  const inside = [triangles[0], triangles[1]];
  if (map.isRim(inside)) return;
  featuring.chooseChain(app, inside, false);
  assert.ok(doc.features.edges.length > 0);
  assert.equal(doc.features.rims.length, map.rims().length);
  featuring.chooseChain(app, inside, true);
  assert.equal(doc.features, undefined);
  assert.ok($('#follow-rims'));
  await until(() => !doc.isBusy);
});

test('two million triangles are opened; of one more it is said what they need and which command maps them', { skip }, async (t) => {
  const app = await openPage(t);
  const { doc, client } = app;
  let triangles = 2_000_000;
  const counted = (model) => new Proxy(model, { get: (of, key) => (key === 'info' ? { ...of.info, triangles } : typeof of[key] === 'function' ? of[key].bind(of) : of[key]) }); // prettier-ignore
  const load = async (...all) => counted(await client.load(...all));
  app.client = new Proxy(client, { get: (of, key) => (key === 'load' ? load : typeof of[key] === 'function' ? of[key].bind(of) : of[key]) }); // prettier-ignore
  t.after(() => (app.client = client));
  await openFiles(app, { 'large.obj': toObj(cubeMesh(1)) });
  assert.equal(doc.usableModel?.main, 'large.obj', doc.message?.text);
  triangles += 1;
  await openFiles(app, { 'larger one.obj': toObj(cubeMesh(1)) });
  assert.equal(doc.message.kind, 'error');
  for (const part of ['2.0 million', '4 GB', "hgp param 'larger one.obj'"]) assert.ok(doc.message.text.includes(part), doc.message.text); // prettier-ignore
  assert.notEqual(doc.model?.main, 'larger one.obj');
}); // prettier-ignore

/** A cube with a triangle more on one of its edges, which three triangles then have. */
function finned(n) {
  const { vertices, triangles } = cubeMesh(n);
  const [a, b] = triangles[0];
  const tip = vertices[a].map((x, i) => x + vertices[b][i]);
  return { vertices: [...vertices, tip], triangles: [...triangles, [a, b, vertices.length]] };
}

test(
  'a cone can be placed on a mesh that repairs make usable, after them; on any other it is told why not',
  { skip },
  async (t) => {
    const app = await pageWith(t, { 'fin.obj': toObj(finned(2)) });
    const { doc } = app;
    const [read, before] = [doc.model, stateOf(app)];
    assert.equal(read.info.usable, false);
    await placeOnAny(app, 5);
    await until(() => !doc.isBusy);
    assert.equal(doc.model.info.usable, true);
    assert.deepEqual(doc.prescription.cones.map(({ vertex }) => doc.model.surface.representative[vertex]), [doc.model.surface.representative[5]]); // prettier-ignore
    assert.equal(doc.message.kind, 'note');
    await undo(app);
    await undo(app);
    assert.deepEqual([doc.model.info.usable, doc.prescription.cones.length, doc.history.canUndo], [false, 0, before.history.canUndo]); // prettier-ignore

    // One that no repair can make usable, or whose repairs were made already.
    const hopeless = {
      defects: [{ ...read.info.defects[0], kind: 'no-such-repair', fatal: true }],
    };
    for (const more of [
      { info: { ...read.info, ...hopeless } },
      { loaded: { fix: {}, hasAllRepairs: true } },
    ]) {
      // prettier-ignore
      doc.state = { kind: 'open', model: { ...doc.model, ...more } };
      const then = stateOf(app);
      doc.message = undefined;
      await placeOnAny(app, 5);
      assert.equal(doc.message.kind, 'error');
      unchanged(app, then, 'a cone on it');
    }
    assert.equal(await repairAndRun(app), 'refused', 'all repairs were made');
    assert.deepEqual([doc.solutions, doc.isBusy], [[], false]);
    assert.equal(await repair(app, []), false);
  },
);

test(
  'all meshes of a file are run, repaired where they need it, and the open one is open again; who cancels ends all',
  { skip },
  async (t) => {
    const app = await pageWith(t, { 'all.glb': toGlb([cubeMesh(2), finned(3), cubeMesh(3)]) });
    const { doc } = app;
    const meshes = () => new Map([...doc.meshes.values(), doc.work].map((work) => [work.model.info.surface, work])); // prettier-ignore
    const mapped = () => [...meshes()].filter(([, { solutions }]) => solutions.length > 0).map(([mesh]) => mesh).sort(); // prettier-ignore
    await switchMesh(app, 2);
    // Cancelled while the second one runs.
    const all = runAll(app);
    await until(() => doc.job?.kind === 'run' && doc.model.info.surface === 1);
    cancel(app);
    await all;
    await until(() => !doc.isBusy);
    assert.deepEqual([mapped(), doc.model.info.surface], [[0], 1]);
    const { solutions } = meshes().get(0);
    await switchMesh(app, 2);
    await runAll(app);
    assert.deepEqual([mapped(), doc.model.info.surface, doc.message.kind], [[0, 1, 2], 2, 'good']);
    assert.ok(doc.message.text.startsWith('3 '));
    assert.equal(meshes().get(0).solutions[0], solutions[0], 'what has a map is not run again');
    // One whose map is not certified is named.
    const work = meshes().get(1);
    const [last] = work.solutions;
    const refused = { ...last, isSameAsFile: false };
    doc.meshes = new Map(doc.meshes).set(1, { ...work, solutions: [refused] });
    await runAll(app);
    assert.deepEqual([doc.message.kind, doc.model.info.surface], ['error', 2]);
    assert.ok(doc.message.text.startsWith('2 ') && doc.message.text.includes(work.model.info.surfaces[1].name || 'Mesh 1')); // prettier-ignore
    // Another file that is opened meanwhile ends it.
    const replaced = runAll(app);
    await openFiles(app, { 'other.obj': toObj(cubeMesh(1)) });
    await replaced;
    assert.deepEqual([doc.model.main, doc.solutions], ['other.obj', []]);
  },
);
