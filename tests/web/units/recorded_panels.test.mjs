// Recorded: what the panels say at both sides of every bound: numbers that are just small enough, one of a thing and several,
// states that a person meets rarely. Each is one change of a page that else stays as it is, and goes back to it.

import assert from 'node:assert/strict';
import test from 'node:test';
import { beside, blocks, eight } from '../../support/blocks.mjs';
import { cubeMesh, toGlb, toObj } from '../../support/meshes.mjs';
import { changes, Recording, shortened, valueText } from '../../support/recording.mjs';
import { elementLines } from './page_text.mjs';
import { drawn, openFiles, openPage, runNow, skip } from './whole_page.mjs';

/** A value with one of its parts, named by a path, replaced; what it is made of stays as it is. */
function put(value, [key, ...rest], part) {
  const changed = rest.length > 0 ? put(value?.[key], rest, part) : part;
  return Array.isArray(value) ? value.with(Number(key), changed) : { ...value, [key]: changed };
}
const withParts = (value, parts) =>
  Object.entries(parts).reduce((all, [name, part]) => put(all, name.split('.'), part), value);

/** A line without the order of attributes, which depends on what came first, and without the value of a list, which the stand-in
 *  document does not follow. */
const sorted = (line) => line.replace(/ =\S*/, '').split(' ').sort().join(' ');

const note = (code, numbers = {}, where = []) => ({ code, numbers, words: {}, where });

/** The page with a model, and what is recorded of it. */
async function pageOf(t, name, files) {
  const app = await openPage(t);
  const { doc, ui } = app;
  await openFiles(app, files);
  ui.setAutomatic(false);
  const recording = new Recording(`panels_${name}`, import.meta.dirname);
  const known = new Set();
  const linesNow = async () => {
    await drawn();
    return [...elementLines(document.body)];
  };
  let base = [];
  /** The page as it is from now on. */
  const rest = async (what) => {
    const before = base;
    base = await linesNow();
    recording.add(`# ${what}`, ...shortened(changes(before, base), known));
  };
  /** What another value of one member changes, which then has its own again. */
  const look = async (of, member, value, what = member) => {
    const own = of[member];
    of[member] = value;
    const after = await linesNow();
    recording.add(`# ${what}`, ...shortened(changes(base, after), known));
    of[member] = own;
    const again = await linesNow();
    assert.deepEqual(again.map(sorted), base.map(sorted), `${what}: the page is as before`);
    base = again;
  };
  const text = (value) => valueText(value, 3).slice(0, 200);
  const each = async (of, member, ...values) => {
    for (const value of values) await look(of, member, value, `${member} ${text(value)}`);
  };
  /** The map that is shown with other parts. */
  const maps = async (...all) => {
    for (const parts of all) await look(doc, 'solutions', [...doc.solutions.slice(0, -1), withParts(doc.solutions.at(-1), parts)], text(parts)); // prettier-ignore
  };
  const models = async (...all) => {
    for (const parts of all) await look(doc, 'state', { kind: 'open', model: withParts(doc.model, parts) }, text(parts)); // prettier-ignore
  };
  const cones = async (...all) => {
    for (const parts of all) await look(doc, 'history', doc.history.push({ ...doc.history.value, prescription: withParts(doc.prescription, parts) }, 'place', 1e9), text(parts)); // prettier-ignore
  };
  return { app, doc, ui, rest, look, each, maps, models, cones, end: () => recording.end() };
}

test('a page with a model and its map', { skip }, async (t) => {
  const { app, doc, ui, rest, look, each, maps, models, cones, end } = await pageOf(t, 'map', { 'cube.obj': toObj(cubeMesh(4)) }); // prettier-ignore
  await rest('a model');
  const { q } = doc.prescription;
  for (const other of [1, 2, 3, 5, 6, 7, 8, 10]) await cones({ q: other, cones: [{ vertex: 0, k: other - 1 || 1 }] }); // prettier-ignore
  const corner = (vertex, k = 3) => ({ vertex, k });
  await cones({ cones: [corner(0)] }, { cones: [corner(0, 1)] }, { cones: [corner(0), corner(0)] }, { cones: [corner(0, 5), corner(1, 4)] }, { cones: [0, 1, 2, 3, 4, 5, 6, 7].map((v) => corner(v)) }, { cones: [0, 1, 2, 3, 4, 5, 6, 7, 8].map((v) => corner(v)) }); // prettier-ignore
  await each(doc, 'hasUserCones', true);
  await each(doc, 'coneStep', 0, 1, 3, 4);
  await each(doc, 'features', { hasCreases: true, hasRims: false, edges: [[0, 8]], rims: [] }, { hasCreases: false, hasRims: false, edges: [], rims: [], isSymmetric: true }, { hasCreases: false, hasRims: true, edges: [[0, 8], [8, 9]], rims: [] }); // prettier-ignore
  const defect = (kind, count, fatal, where = []) => ({ kind, count, fatal, where });
  const kinds = ['non-manifold-edge', 'non-manifold-vertex', 'inconsistent-edge', 'zero-area', 'duplicate-face', 'repeated-vertex', 'isolated-vertex', 'not-finite', 'extent', 'index-out-of-range', 'some-other']; // prettier-ignore
  for (const count of [1, 2]) await models({ 'info.usable': false, 'info.defects': kinds.map((kind) => defect(kind, count, true)) }); // prettier-ignore
  await models({ 'info.defects': [defect('zero-area', 1, false)] });
  for (const fix of [{}, { degenerate: true }, { orient: true }]) await models({ 'info.usable': false, 'info.defects': [defect('zero-area', 1, true), defect('extent', 1, false)], 'loaded.fix': fix }); // prettier-ignore
  await models({ 'info.usable': false, 'info.defects': [defect('extent', 1, true)] }, { 'loaded.weld': 0 }, { 'loaded.weld': 0.5 }, { 'info.notes': [note('weld-would-join')] }, { 'info.notes': [note('crack', { weld: 0.25 })] }, { 'info.notes': [note('crack', { weld: 0.25 })], 'loaded.weld': 0 }, { remarks: ['so', 'it is'] }); // prettier-ignore
  await models({ 'info.surfaces.0.storedVertices': 99 }, { 'info.surfaces.0.notes': [note('some')] }, { 'info.genus': undefined }, { 'info.genus': 2, 'info.boundaryLoops': 3, 'info.eulerCharacteristic': -5 }, { 'info.mirrors': [{}] }, { 'info.triangles': 700_000 }, { 'info.triangles': 800_000 }, { 'info.diagonal': 0.00123456 }); // prettier-ignore
  await each(doc, 'field', { name: 'a.rosy', text: '' });
  await each(doc, 'solve', ...[-1, -0.25, 0, 0.25, 1].map((improve) => ({ ...doc.solve, improve })), { ...doc.solve, rounds: 7, timeLimit: 30 }, { ...doc.solve, frames: 'file' }); // prettier-ignore
  await each(doc, 'solve', ...[{ cells: 10 }, { cells: 100_000 }, { isOn: false }, { mode: 'quad' }].map((grid) => ({ ...doc.solve, grid: { ...doc.solve.grid, ...grid } }))); // prettier-ignore
  await each(ui, 'automatic', true);

  await runNow(app);
  doc.message = undefined;
  await rest('its map');
  const result = 'result.certificate';
  await maps({ 'sizes.range': 9.99 }, { 'sizes.range': 10 }, { 'sizes.range': 1234.4 });
  const place = (share, triangles, vertices) => ({ share, triangles: Uint32Array.from(triangles), vertices }); // prettier-ignore
  for (const [larger, smaller] of [[place(0.2, [1], [5]), place(0.1, [2], [6])], [place(0, [], []), place(0.1, [2], [6])], [place(0.2, [1], []), place(0, [], [])], [place(0.2, [1], []), place(0.2, [1], [3])]]) await maps({ 'sizes.range': 20, 'sizes.larger': larger, 'sizes.smaller': smaller }); // prettier-ignore
  for (const layers of [1, 2]) for (const share of [0.00049, 0.0005, 0.1234]) await maps({ [`${result}.overlap`]: { layers, share } }); // prettier-ignore
  await maps({ 'sizes.typicalStretch': 1 }, { 'sizes.typicalStretch': 2.5 }, { 'sizes.spread': 1 }, { 'sizes.spread': 99.94 }); // prettier-ignore
  const why = [{ message: 'So.', where: [] }, { message: 'There.', where: [{ kind: 'triangle', id: 1 }] }]; // prettier-ignore
  await maps({ [`${result}.certified`]: false, [`${result}.reasons`]: why }, { isDragged: true }, { notes: [note('write-some')], preserved: '1 texture' }, { 'result.memory': 2 ** 31 }, { preserved: '2 skins' }); // prettier-ignore
  await maps({ isSameAsFile: false, difference: 'another' });
  const grid = doc.current.result.report.components[0].grid;
  for (const parts of [{ aligned: false, workingCells: 0 }, { aligned: false, workingCells: 1 }, { aligned: false, workingCells: 300, reason: note('grid-some') }]) await maps({ 'result.report.components.0.grid': { ...grid, ...parts } }); // prettier-ignore
  await maps({ 'result.report.components.0.grid': undefined }, { 'result.cones.cones': [] }, { [`${result}.integerSeams`]: 0 }, { seams: [] }); // prettier-ignore
  await maps({ 'grid.isOn': false });
  const part = doc.current.result.certificate.components[0];
  await maps({ [`${result}.components`]: [part, withParts(part, { 'distortion.p95Mu': 0.9, 'distortion.minLogArea': -3, 'distortion.maxLogArea': 4 })] }); // prettier-ignore
  await maps({ 'distortion.flipped': Uint32Array.of(3) });
  for (const overlay of ['angle', 'area', 'seams', 'flips']) await each(doc, 'look', { ...doc.look, overlay }); // prettier-ignore
  for (const pattern of ['grid', 'brick', 'wood', 'cross', 'hex', 'image', 'plain', 'material']) await each(doc, 'look', { ...doc.look, pattern }); // prettier-ignore
  await each(doc, 'look', { ...doc.look, steps: 2 }, { ...doc.look, tiles: 100, pattern: 'wood' }, { ...doc.look, seams: 'on' }, { ...doc.look, hasWire: true }, { ...doc.look, light: 'flat' }); // prettier-ignore
  await each(ui, 'mapScale', 10, 109, 110, 111, 1100);
  await each(ui, 'wipe', 1, 50);
  await each(ui, 'hover', 'vertex 3');
  await each(ui, 'tab', 'map');
  await each(ui, 'tool', 'place', 'edges');
  await each(ui, 'isNarrow', true);
  await each(ui, 'isPhone', true);
  for (const sheet of ['peek', 'full']) await each(ui, 'sheet', sheet);
  await each(ui, 'split', 20);
  await each(ui, 'isRecording', true);
  await each(doc, 'selected', 0, doc.prescription.cones.length - 1);
  await each(doc, 'isUnsaved', false);
  for (const sort of [{ by: 'vertex', isDown: false }, { by: 'vertex', isDown: true }, { by: 'k', isDown: false }, { by: 'number', isDown: true }]) await each(ui, 'sort', sort); // prettier-ignore
  await each(ui, 'maxRows', doc.prescription.cones.length - 1, doc.prescription.cones.length);
  for (const state of ['heat', 'certified', 'storing', 'fails']) await look(doc, 'live', { base: doc.current, state, cornerUv: doc.current.cornerUv, heat: new Float32Array(), notPositive: new Uint32Array(state === 'fails' ? 2 : 0), reasons: ['why'] }, `live ${state}`); // prettier-ignore
  await each(doc, 'automatic', { controller: {}, stage: 'solve' });

  const job = { kind: 'run', title: 'Running', stage: 'read', entered: [], detail: '', fraction: 0, begin: 0, controller: {} }; // prettier-ignore
  const jobs = [{}, { kind: 'load', detail: '3 MB' }, { stage: 'prepare', fraction: 0.5 }, { stage: 'solve', secondsLeft: 0 }, { stage: 'verify', secondsLeft: 2.1 }, { stage: 'write', detail: 'round 2' }]; // prettier-ignore
  const permission = { value: 'default' };
  const { Notification: own } = globalThis;
  t.after(() => (globalThis.Notification = own));
  globalThis.Notification = { get permission() { return permission.value; }, requestPermission: async () => (permission.value = 'granted') }; // prettier-ignore
  for (const now of [-500, 400, 600, 10_000, 10_001]) {
    ui.now = now;
    await drawn();
    await each(doc, 'job', ...(now === 400 ? jobs : [{}]).map((one) => ({ ...job, ...one })));
  }
  doc.job = job;
  await rest('a run of a long time');
  document.querySelector('#notify').click();
  await rest('who has answered is not asked again');
  doc.job = undefined;
  await rest('and its end');
  for (const kind of ['note', 'good', 'error']) await each(doc, 'message', { kind, text: 'So.', actions: [{ label: 'one', run() {} }, { label: 'two', run() {} }] }); // prettier-ignore

  // Dialogs, with what is chosen in them.
  ui.dialog = 'download';
  await rest('the download');
  for (const target of ['three', 'engine', 'quads', 'blender']) {
    ui.target = target;
    await rest(`for ${target}`);
    await maps({ 'grid.mode': 'quad' }, { 'result.report.components.0.grid': undefined }, { 'grid.isOn': false }); // prettier-ignore
  }
  await maps(...['unit', 'fit'].map((scale) => ({ 'output.scale': scale })), { 'output.embedCones': false }, { 'output.hasGrid': true }, { [`${result}.certified`]: false }, { notes: [note('write-some'), note('write-other')] }, { preserved: '1 texture' }); // prettier-ignore
  await each(doc, 'pendingOutput', { ...doc.current.output, scale: 'unit', embedCones: false });
  for (const seen of [{ isGood: true, text: 'good', issues: [] }, { isGood: false, text: 'bad', issues: ['one'] }]) await look(doc, 'validation', { of: doc.current, ...seen }, seen.text); // prettier-ignore
  await look(doc, 'validation', { of: {}, isGood: false, text: 'of another', issues: ['one'] });
  await each(doc, 'job', job);
  ui.dialog = 'compare';
  doc.solutions = [withParts(doc.current, { improve: 0.5, 'sizes.spread': 1.1, id: 98 }), withParts(doc.current, { 'sizes.typicalStretch': 1.01, 'sizes.spread': 3, id: 99, grid: { ...doc.current.grid, cells: 40 } }), doc.current]; // prettier-ignore
  await rest('three runs');
  await each(doc, 'job', job);
  for (const dialog of ['help', 'palette', 'log', '']) {
    ui.dialog = dialog;
    if (dialog !== 'log') await rest(`dialog ${dialog}`);
  }
  await maps({ 'sizes.typicalStretch': 1.5 }, { 'sizes.spread': 2.9 }, { 'sizes.spread': 3 });
  assert.equal(doc.prescription.q, q);
  await cones({ cones: [] });
  end();
});

test('a page with boundaries, handles and components', { skip }, async (t) => {
  const { doc, rest, each, cones, end } = await pageOf(t, 'parts', { 'eight.obj': toObj(blocks(eight, { open: ['0 0 +z'] })) }); // prettier-ignore
  await rest('handles and a rim');
  const [handles, { turnings }] = [[null, null, null, null], doc.prescription];
  await cones({ turnings: [0] }, { turnings: [-3] }, { handles: [1, ...handles.slice(1)] }, { handles: [0, null, 3, 2] }, { turnings: [2], cones: [{ vertex: 0, k: 3 }] }); // prettier-ignore
  for (const count of [0, 8, 9, 12]) await cones({ handles: Array(count).fill(null) }, { handles: Array(count).fill(null).map((r, i) => (i === count - 1 ? 2 : r)) }); // prettier-ignore
  await cones({ turnings: [], handles: [] }, { turnings, handles: [] }, { cones: [{ vertex: 0, k: 3 }] }); // prettier-ignore
  for (const n of [20, 21]) await cones({ cones: Array.from({ length: n }, (_, i) => ({ vertex: 2 * i, k: 3 + (i % 3) })) }); // prettier-ignore
  await each(doc, 'hasUserCones', true);
  end();
  const many = Array.from({ length: 10 }, () => cubeMesh(1)).reduce((all, one) => beside(all, one));
  const parts = await pageOf(t, 'components', { 'ten.obj': toObj(many) });
  await parts.rest('ten components');
  const corners = (count) => ({ cones: Array.from({ length: count }, (_, vertex) => ({ vertex, k: 3 })) }); // prettier-ignore
  await parts.cones(corners(1), corners(8), corners(15), corners(16), corners(24), corners(80));
  parts.end();
});

test('a page with several meshes, and with none', { skip }, async (t) => {
  const { app, doc, ui, rest, look, each, models, maps, end } = await pageOf(t, 'meshes', { 'two.glb': toGlb([cubeMesh(2), cubeMesh(3)]) }); // prettier-ignore
  await rest('two meshes');
  const summary = { index: 0, isUsable: false, components: 1, why: 'broken' };
  await each(doc, 'summaries', [summary], [{ ...summary, isUsable: true }], []);
  await each(doc, 'thumbnails', new Map());
  ui.now = 0;
  await models({ 'info.usable': false }, { 'info.surfaces.0.name': '' }, { 'info.surfaces.0.name': 'a name' }); // prettier-ignore
  await each(doc, 'job', { kind: 'run', title: 'Running', stage: 'read', entered: [], detail: '', fraction: 0, begin: 0, controller: {} }); // prettier-ignore
  await runNow(app);
  doc.message = undefined;
  await rest('the map of one');
  const { work } = doc;
  const other = withParts(doc.current, { 'result.certificate.certified': false });
  for (const solutions of [[], [doc.current], [other], [other, doc.current]]) await look(doc, 'meshes', new Map([[0, { ...work, model: withParts(work.model, { 'info.surface': 0 }), solutions }]]), `waiting with ${solutions.length}`); // prettier-ignore
  await look(doc, 'meshes', new Map([[0, { ...work, solutions: [other] }]]), 'not certified');
  await maps({ 'result.certificate.certified': false });
  ui.dialog = 'download';
  await rest('the download of one');
  for (const uvSets of [[0], [0, 1], [1], [2, 0]]) {
    await models({ 'info.surfaces.1.uvSets': uvSets });
    await models({ 'info.surfaces.1.uvSets': uvSets, 'info.file.format': 'obj' });
  }
  await maps({ notes: [note('write-set-used')], preserved: '1 texture' }, { notes: [note('write-set-unseen')], preserved: '1 texture' }, { 'output.uvSet': 0 }, { 'output.uvSet': 2 }, { 'output.usesNewSet': true }); // prettier-ignore
  for (const count of [1, 3]) await models({ 'info.surfaces': Array(count + 1).fill(doc.model.info.surfaces[0]) }); // prettier-ignore
  await look(doc, 'meshes', new Map([[0, { ...work, model: withParts(work.model, { 'info.surface': 0 }), solutions: [other] }]]), 'both'); // prettier-ignore
  ui.dialog = '';
  await rest('no dialog');
  doc.clearModel();
  await rest('no model');
  const missing = (...needed) => ({ kind: 'needs-files', files: new Map(), main: 'a.gltf', missing: needed.map((isNeeded, i) => ({ name: `${i}.bin`, isNeeded })) }); // prettier-ignore
  await each(doc, 'state', { kind: 'starting' }, { kind: 'failed' }, missing(true), missing(false), missing(false, true), { kind: 'pick-model', files: new Map(), candidates: ['a.obj', 'b.obj'] }); // prettier-ignore
  await look(ui, 'recent', [{ id: 'a', main: 'a.obj', time: 0, files: [] }, { id: 'b', main: 'b.obj', time: 0, files: [] }].slice(0, 2)); // prettier-ignore
  for (const theme of ['light', 'dark']) await each(ui, 'theme', theme);
  end();
});
