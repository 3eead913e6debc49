// A cone that is dragged over a real map: which map it takes with it, what is stored where it is dropped, and what one step of undo
// takes back.

import assert from 'node:assert/strict';
import test from 'node:test';
import { blocks, eight } from '../../support/blocks.mjs';
import { cubeMesh, toObj } from '../../support/meshes.mjs';
import { drawn, openFiles, openPage, runNow, skip, until } from './whole_page.mjs';

const { beginLive, cancelLive, dragLive, dropLive, pointAtCone } = await import('../../../web/src/actions/drag_live.ts'); // prettier-ignore
const { moveCone, setPrescription } = await import('../../../web/src/actions/edit_cones.ts');
const { undo } = await import('../../../web/src/actions/undo.ts');

async function pageWith(t, files = { 'cube.obj': toObj(cubeMesh(6)) }) {
  const app = await openPage(t);
  await openFiles(app, files);
  app.ui.setAutomatic(false);
  return app;
}
const placesOf = ({ doc }) => doc.prescription.cones.map(({ vertex }) => vertex);
/** A vertex beside a cone that has none and is not on a boundary. */
function besideCone({ doc }, cone, but = -1) {
  const { neighbourStart, neighbours, isBoundary } = doc.model.surface;
  const { vertex } = doc.prescription.cones[cone];
  const around = [...neighbours.subarray(neighbourStart[vertex], neighbourStart[vertex + 1])];
  return around.find((v) => v !== but && !isBoundary[v] && !placesOf({ doc }).includes(v));
}
let drags = 0;
async function drag(app, cone, to, { drops = true } = {}) {
  const step = `drag ${++drags}`;
  const over = beginLive(app, cone);
  moveCone(app, cone, to, step);
  dragLive(app);
  await drawn(); // the map is asked for, if there is one
  await until(() => app.doc.live === undefined || app.doc.live.state === 'certified' || app.doc.live.state === 'fails', 'a frame', 20); // prettier-ignore
  const { live } = app.doc;
  if (drops) dropLive(app, `move cone: ${step}`);
  else cancelLive(app);
  await over;
  await drawn();
  return live;
}

test('a cone takes the map along; where it is dropped the map is stored, in one step of undo', { skip }, async (t) => {
  const app = await pageWith(t);
  const { doc, ui } = app;
  await runNow(app);
  const first = doc.current;
  const before = placesOf(app);
  for (const cone of [0, before.length - 1]) {
    const to = besideCone(app, cone);
    const over = beginLive(app, cone);
    assert.equal(ui.holdsCone, true);
    moveCone(app, cone, to, 'going');
    dragLive(app);
    await until(() => doc.live?.state === 'certified', 'a map', 20);
    assert.equal(doc.live.base.prescription.cones[cone].vertex === to, false);
    assert.equal(doc.live.cornerUv.length, doc.displayed.cornerUv.length);
    dropLive(app, 'move cone: going');
    await over;
    assert.deepEqual([ui.holdsCone, doc.live, doc.current?.isDragged], [false, undefined, true]);
    assert.equal(doc.current.result.certificate.certified, true);
    assert.deepEqual([doc.message.kind, doc.message.actions.length], ['good', 1]);
    assert.equal(placesOf(app)[cone], to);
    assert.equal(doc.current.prescription.cones[cone].vertex, to);
    await undo(app);
    assert.deepEqual([placesOf(app), doc.current], [before, first]);
  }
  // Taken back, nothing is left of it; at its own place neither.
  const held = await drag(app, 1, besideCone(app, 1), { drops: false });
  assert.notEqual(held, undefined);
  assert.deepEqual([doc.live, ui.holdsCone, doc.solutions.includes(first)], [undefined, false, true]); // prettier-ignore
  await undo(app);
  const { solutions } = doc;
  const over = beginLive(app, 1);
  dropLive(app, 'move cone: nowhere');
  await over;
  assert.deepEqual([doc.solutions, ui.holdsCone, doc.live], [solutions, false, undefined]);
  cancelLive(app);
  dropLive(app, 'nothing is held');
  dragLive(app);
  assert.equal(doc.live, undefined);
}); // prettier-ignore

test('a drag is prepared while the pointer rests on its cone, and given up where it goes on', { skip }, async (t) => {
  const app = await pageWith(t);
  const { doc } = app;
  await runNow(app);
  const maps = Object.getPrototypeOf(doc.current.map);
  const { beginDrag } = maps;
  t.after(() => (maps.beginDrag = beginDrag));
  const asked = [];
  maps.beginDrag = function (...args) {
    asked.push(beginDrag.apply(this, args));
    return asked.at(-1);
  };
  const isAsked = (count) => until(() => asked.length === count, `${count} drags`, 20);
  const pause = () => new Promise((done) => setTimeout(done, 300));

  pointAtCone(app, 0);
  pointAtCone(app, 0);
  await isAsked(1);
  await pause();
  const live = await drag(app, 0, besideCone(app, 0));
  assert.equal(live.state, 'certified');
  assert.equal(doc.current.isDragged, true);
  assert.deepEqual([asked.length, (await asked[0]).isDisposed], [1, true]);

  // The same cone once more, now that its map is another one.
  pointAtCone(app, 0);
  await isAsked(2);
  pointAtCone(app, -1);
  const left = await asked[1];
  await until(() => left.isDisposed, 'the end of what was prepared', 20);
  pointAtCone(app, 0); // only passes
  pointAtCone(app, 1);
  await isAsked(3);
  await drag(app, 0, besideCone(app, 0), { drops: false });
  assert.equal(asked.length, 4, 'prepared for another cone');
  assert.deepEqual((await Promise.all(asked)).map((one) => one.isDisposed), [true, true, true, true]); // prettier-ignore

  // No map of these cones is shown: a run may be on its way.
  moveCone(app, 1, besideCone(app, 1), 'away');
  assert.equal(doc.current, undefined);
  pointAtCone(app, -1);
  pointAtCone(app, 0);
  await pause();
  assert.equal(asked.length, 4);
}); // prettier-ignore

test('only a certified map of these cones, settings and surface that the solver has is taken along', { skip }, async (t) => {
  const app = await pageWith(t);
  const { doc } = app;
  await runNow(app);
  const good = doc.current;
  const { certificate } = good.result;
  const to = besideCone(app, 0);
  const hasMap = async (solutions, more = {}) => {
    const { solve, prescription } = doc;
    Object.assign(doc, { solutions, ...more });
    const live = await drag(app, 0, to, { drops: false });
    doc.solve = solve;
    doc.job = undefined;
    doc.begin(prescription);
    return live !== undefined;
  };
  assert.equal(await hasMap([good]), true);
  const others = {
    'of another surface': { surfaceId: good.surfaceId + 1 },
    'with less distortion': { improve: 0 },
    'along features': { features: { hasCreases: false, hasRims: true, edges: [], rims: [] } },
    'of another model': { map: new Proxy(good.map, { get: (of, key) => (key === 'model' ? {} : of[key]) }) }, // prettier-ignore
    'not certified': { result: { ...good.result, certificate: { ...certificate, certified: false } } }, // prettier-ignore
    'not as in the file': { isSameAsFile: false },
    'of other cones': { prescription: { ...good.prescription, cones: good.prescription.cones.slice(1) } }, // prettier-ignore
    'of another angle': { prescription: { ...good.prescription, cones: good.prescription.cones.with(0, { ...good.prescription.cones[0], k: 5 }) } }, // prettier-ignore
  };
  for (const [what, part] of Object.entries(others)) {
    assert.equal(await hasMap([{ ...good, ...part }]), false, what);
    assert.equal(await hasMap([good, { ...good, ...part }]), true, `${what}, beside a good one`);
  }
  assert.equal(await hasMap([good], { solve: { ...doc.solve, frames: 'file' } }), false);
  assert.equal(await hasMap([]), false);
  // Where this cone alone is elsewhere in the map, the map follows from there.
  const { cones } = good.prescription;
  moveCone(app, 0, to, 'without its map');
  doc.solutions = [good];
  const back = besideCone(app, 0, cones[0].vertex);
  const live = await drag(app, 0, back, { drops: false });
  assert.equal(live?.base, good);
  assert.equal(await hasMap([good]), true);
  const { map } = good;
  await map.dispose();
  doc.begin(good.prescription);
  assert.equal(await hasMap([good]), false, 'the solver has it no longer');
}); // prettier-ignore

test('rotations around handles that are prescribed follow the path, in the same step of undo', { skip }, async (t) => {
  const app = await pageWith(t, { 'eight.obj': toObj(blocks(eight, { n: 2 })) });
  const { doc } = app;
  await runNow(app);
  const { handles } = doc.current.result.cones;
  const rotations = doc.prescription.handles.map((_, i) => handles.find(({ generator }) => generator === i)?.r ?? null); // prettier-ignore
  assert.ok(rotations.length >= 4 && rotations.every(Number.isInteger));
  setPrescription(app, { ...doc.prescription, handles: rotations.with(1, null) }, 'handles');
  await runNow(app);
  assert.equal(doc.stateName, 'certified');
  const before = doc.prescription;
  const live = await drag(app, 0, besideCone(app, 0));
  assert.equal(live?.state, 'certified');
  const { prescription, current } = doc;
  assert.equal(current?.isDragged, true);
  const found = current.result.cones.handles ?? [];
  assert.equal(prescription.handles[1], null, 'what is automatic stays so');
  for (const i of [0, 2, 3]) assert.equal(prescription.handles[i], found.find(({ generator }) => generator === i)?.r ?? before.handles[i]); // prettier-ignore
  await undo(app);
  assert.deepEqual(doc.prescription, before);
}); // prettier-ignore
