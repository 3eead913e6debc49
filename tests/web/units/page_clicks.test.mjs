// What is under the pointer and the keys beside the views: fields for files, the divider, the palette, Escape, buttons in dialogs and
// notes. Each does what it says, once.

import assert from 'node:assert/strict';
import test from 'node:test';
import { beside, blocks, eight } from '../../support/blocks.mjs';
import { cubeMesh, toGltf, toObj, toOff } from '../../support/meshes.mjs';
import { $, $$, choose, click, drawn, openFiles, openPage, runNow, saved, skip, textOf, until } from './whole_page.mjs'; // prettier-ignore

const { Keyboard } = await import('../../../web/src/input/keyboard.ts');
const { ignoreSecondClicks } = await import('../../../web/src/input/double_click.ts');
const { listenToDrops } = await import('../../../web/src/input/drop.ts');
const { listenToSplitter } = await import('../../../web/src/input/splitter.ts');
const { setPrescription } = await import('../../../web/src/actions/edit_cones.ts');
const { runJob } = await import('../../../web/src/actions/job.ts');

async function pageWith(t, files) {
  const app = await openPage(t);
  await openFiles(app, files);
  app.ui.setAutomatic(false);
  return app;
}
const fileOf = (name, content) => new File([content], name);
async function give(selector, ...files) {
  const field = typeof selector === 'string' ? $(selector) : selector;
  Object.defineProperty(field, 'files', { value: files, configurable: true });
  field.dispatchEvent(new Event('change', { bubbles: true }));
  await drawn();
}
async function press(target, key, more = {}) {
  const event = new KeyboardEvent('keydown', { key, bubbles: true, cancelable: true, ...more });
  (typeof target === 'string' ? $(target) : target).dispatchEvent(event);
  await drawn();
  return event.defaultPrevented;
}

test('files come by either field, by dropping, and one by one where they are missing', { skip }, async (t) => {
  const app = await openPage(t);
  const { doc } = app;
  for (const [id, name] of [['file', 'a.obj'], ['folder', 'b.obj']]) { // prettier-ignore
    assert.equal($(`#${id}`).hasAttribute('webkitdirectory'), id === 'folder');
    await give(`#${id}`, fileOf(name, toObj(cubeMesh(1))));
    await until(() => doc.usableModel?.main === name && !doc.isBusy);
  }
  for (const id of ['open', 'open-folder']) {
    const { actions } = await import('../../../web/src/actions/registry.ts');
    const clicked = [];
    for (const field of ['file', 'folder']) $(`#${field}`).click = () => clicked.push(field);
    actions[id].run(app);
    assert.deepEqual(clicked, [id === 'open' ? 'file' : 'folder']);
  }
  listenToDrops(app);
  const isOver = () => document.body.classList.contains('over');
  const fire = (type, more = {}) => {
    const event = Object.assign(new Event(type, { bubbles: true, cancelable: true }), more);
    document.dispatchEvent(event);
    return event.defaultPrevented;
  };
  fire('dragenter');
  fire('dragenter'); // an element within
  fire('dragleave');
  assert.deepEqual([isOver(), fire('dragover')], [true, true]);
  fire('dragleave');
  assert.equal(isOver(), false);
  fire('dragenter');
  const { model } = doc;
  assert.equal(fire('drop', { dataTransfer: null }), true);
  assert.deepEqual([isOver(), doc.model], [false, model]);
  const file = fileOf('c.obj', toObj(cubeMesh(1)));
  const items = [{ webkitGetAsEntry: () => null }];
  assert.equal(fire('drop', { dataTransfer: { files: [file], items } }), true);
  await until(() => doc.usableModel?.main === 'c.obj' && !doc.isBusy);
  const isSaid = () => $('#status').classList.contains('error');
  assert.equal(isSaid(), false);
  fire('drop', { dataTransfer: { files: [], items } });
  await until(isSaid);
  assert.equal(doc.usableModel?.main, 'c.obj', 'stays open where there was no file in what was dropped');

  const { json, bin } = toGltf([cubeMesh(2)]);
  json.images = [{ uri: 'skin.png' }];
  await openFiles(app, { 'm.gltf': JSON.stringify(json) });
  const fields = () => $$('#needs-files input');
  assert.equal(fields().length, 2);
  await give(fields()[0]);
  assert.equal(fields().length, 2, 'none was chosen');
  await give(fields()[0], fileOf('other name.bin', bin));
  assert.equal(fields().length, 1, 'by whatever name it has');
  await click('#without-images');
  await until(() => doc.usableModel?.main === 'm.gltf' && !doc.isBusy);
  await openFiles(app, { 'a.obj': toObj(cubeMesh(1)), 'b.obj': toObj(cubeMesh(1)) });
  await click($$('#pick-model button').at(-1));
  assert.deepEqual([doc.stateName, $('dialog')], ['empty', null]);
}); // prettier-ignore

test('the second click of a double click is not one on what has come in place of the first button', () => {
  const place = document.createElement('div');
  document.body.append(place);
  ignoreSecondClicks(place);
  const clicked = [];
  const show = (...ids) =>
    place.replaceChildren(
      ...ids.map((id) => {
        const button = Object.assign(document.createElement('button'), { id });
        button.addEventListener('click', () => clicked.push(id));
        return button;
      }),
      document.createElement('p'),
    );
  const clickOn = (id, detail) =>
    place
      .querySelector(id)
      .dispatchEvent(new MouseEvent('click', { detail, bubbles: true, cancelable: true }));
  show('start', 'stop');
  place.querySelector('p').addEventListener('click', () => clicked.push('p'));
  const both = (first, second) => [clickOn(first, 1), clickOn(second, 2)];
  assert.deepEqual(both('#start', '#stop'), [true, false], 'the browser does nothing either');
  assert.deepEqual(clicked.splice(0), ['start']);
  both('#stop', '#start');
  both('#start', 'p');
  assert.deepEqual(clicked.splice(0), ['stop', 'start']);
  both('#start', '#start');
  both('p', 'p');
  assert.deepEqual(clicked.splice(0), ['start', 'start', 'p', 'p'], 'two clicks on the same');
  for (const detail of [0, 1]) for (const id of ['#start', '#stop']) clickOn(id, detail);
  assert.deepEqual(clicked, ['start', 'stop', 'start', 'stop'], 'by keyboard, and one by one');
  place.remove();
});

test('the divider follows the pointer between the views, arrows, and clicks from place to place', { skip }, async (t) => {
  const app = await pageWith(t, { 'cube.obj': toObj(cubeMesh(1)) });
  const { ui } = app;
  const splitter = $('#splitter');
  listenToSplitter(splitter, ui);
  splitter.setPointerCapture = () => {};
  $('#pane-surface').getBoundingClientRect = () => ({ left: 100, right: 500 });
  $('#pane-map').getBoundingClientRect = () => ({ left: 500, right: 1100 });
  const fire = (type, more) => splitter.dispatchEvent(Object.assign(new Event(type), more));
  const seen = (from) => {
    ui.setSplit(from);
    fire('pointerdown', { pointerId: 1 });
    fire('click');
    return ui.split;
  };
  assert.deepEqual([20, 30, 40, 58, 60, 80].map(seen), [30, 58, 58, 80, 80, 30]);
  const movedTo = (clientX, buttons = 1) => {
    fire('pointermove', { clientX, buttons });
    return ui.split;
  };
  fire('pointerdown', { pointerId: 1 });
  assert.equal(movedTo(700, 0), 30, 'no button is held');
  assert.deepEqual([600, 350, 0, 1090].map((x) => movedTo(x)), [50, 25, 20, 80]); // prettier-ignore
  fire('click');
  assert.equal(ui.split, 80, 'the end of a drag is no click');
  ui.setSplit(50);
  const key = (name) => {
    const event = Object.assign(new Event('keydown', { cancelable: true }), { key: name });
    splitter.dispatchEvent(event);
    return [ui.split, event.defaultPrevented];
  };
  assert.deepEqual(key('ArrowLeft'), [46, true]);
  assert.deepEqual(key('ArrowRight'), [50, true]);
  assert.deepEqual(key('ArrowUp'), [50, false]);
  assert.equal(document.documentElement.style.getPropertyValue('--part'), '0.5');
}); // prettier-ignore

test('Escape goes one step: a drag, the selection, a question before a run ends, a load, outlines', { skip }, async (t) => {
  const app = await pageWith(t, { 'cube.obj': toObj(cubeMesh(2)) });
  const { doc, ui } = app;
  new Keyboard(app);
  const outlined = [];
  app.views = { model: { highlight: (all) => outlined.push(all.length) }, uv: { highlight: (all) => outlined.push(all.length) } }; // prettier-ignore
  t.after(() => (app.views = undefined));
  setPrescription(app, { ...doc.prescription, cones: [{ vertex: 0, k: 3 }] }, 'place');
  const lasts = (kind) => runJob(app, { kind, title: 'Lasting', onFailure: assert.fail }, ({ signal }) => new Promise((_, reject) => signal.addEventListener('abort', () => reject(signal.reason)))); // prettier-ignore
  const ended = lasts('run');
  doc.selected = 0;
  let drags = 1;
  ui.stopDrag = () => drags-- > 0;
  const escape = () => press(document.body, 'Escape');
  assert.equal(await escape(), true);
  assert.equal(doc.selected, 0, 'the drag alone');
  assert.equal(await escape(), false);
  assert.deepEqual([doc.selected, doc.isBusy, doc.message], [-1, true, undefined]);
  await escape();
  assert.deepEqual([doc.isBusy, doc.message.actions.length], [true, 1]);
  doc.say('something else');
  await escape();
  assert.equal(doc.isBusy, true, 'what was asked is no longer there: it is asked again');
  await escape();
  assert.deepEqual([doc.isBusy, await ended], [false, 'cancelled']);
  const second = lasts('run');
  await escape();
  doc.message.actions[0].run();
  assert.equal(await second, 'cancelled');
  const load = lasts('load');
  await escape();
  assert.equal(await load, 'cancelled', 'at once');
  assert.deepEqual(outlined, []);
  await escape();
  assert.deepEqual(outlined, [0, 0]);
  doc.selected = 0;
  ui.dialog = 'help';
  await drawn();
  await escape();
  assert.equal(doc.selected, 0, 'the browser closes the dialog');
  ui.dialog = '';
  await drawn();
  // Keys do nothing behind a dialog, and the browser does not act on them either.
  ui.dialog = 'help';
  const { history } = doc;
  assert.equal(await press(document.body, 'z', { ctrlKey: true }), true);
  await press('#view', '5');
  assert.equal(doc.history, history);
  ui.dialog = '';
  await drawn();
  assert.equal(await press('#view', '5', { altKey: true }), false);
  assert.equal(doc.history, history);
  assert.equal(await press('#view', 'ü'), false);
  // A number that is being typed is taken first.
  const field = $('#cones input');
  const blurred = [];
  field.blur = () => blurred.push(1);
  await press(field, 'z', { ctrlKey: true });
  assert.equal(blurred.length, 1);
}); // prettier-ignore

test('with the Place tool keys walk from the place in the middle, and a boundary is named', { skip }, async (t) => {
  const app = await pageWith(t, { 'tray.obj': toObj(blocks(['##'], { n: 2, open: ['0 0 +z'] })) }); // prettier-ignore
  const { doc, ui } = app;
  const keyboard = new Keyboard(app);
  const { surface } = doc.model;
  const cursors = [];
    let pointed;
  const at = (v) => ({ x: surface.positions[3 * v] + 0.3 * surface.positions[3 * v + 2], y: -surface.positions[3 * v + 1] - 0.2 * surface.positions[3 * v + 2] }); // prettier-ignore
  app.views = { model: { canvas: $('#view'), pick: () => pointed, setCursor: (v) => cursors.push(v), toScreen: at, orbit: { move() {}, pan() {} }, highlight() {} }, uv: { highlight() {} } }; // prettier-ignore
  t.after(() => (app.views = undefined));
  ui.tool = 'place';
  await press('#view', 'Enter');
  assert.equal(doc.prescription.cones.length, 0, 'there is no place yet');
  await press('#view', 'ArrowRight');
  assert.deepEqual(cursors, [surface.triangles[0]], 'nothing is in the middle: any vertex');
  const ends = { ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
  
  for (const key of ['ArrowRight', 'ArrowRight', 'ArrowUp', 'ArrowUp', 'ArrowLeft', 'ArrowLeft', 'ArrowLeft', 'ArrowDown', 'ArrowDown', 'ArrowRight']) { // prettier-ignore
    const from = cursors.at(-1);
    await press('#view', key);
    const to = cursors.at(-1);
    const [dx, dy] = ends[key];
    const around = [...surface.neighbours.subarray(surface.neighbourStart[from], surface.neighbourStart[from + 1])]; // prettier-ignore
    const cosine = (v) => { const [x, y] = [at(v).x - at(from).x, at(v).y - at(from).y]; return (dx * x + dy * y) / (Math.hypot(x, y) || 1); }; // prettier-ignore
    const best = Math.max(...around.map(cosine));
    if (to !== from) assert.ok(Math.abs(cosine(to) - best) < 1e-9, key);
    const isNamed = /boundary/.test(doc.message?.text ?? '');
    assert.equal(isNamed, Boolean(surface.isBoundary[to]), `${to}`);
  }
  for (const vertex of [[...surface.isBoundary.keys()].find((v) => surface.isBoundary[v]), 0]) {
      keyboard.reset();
      assert.equal(cursors.at(-1), -1);
      pointed = { vertex };
      await press('#view', 'ArrowUp');
      assert.equal(cursors.at(-1), vertex, 'what is in the middle');
      assert.equal(/boundary/.test(doc.message.text), Boolean(surface.isBoundary[vertex]));
    }
  // From every vertex each arrow leads to the neighbour that is most nearly in its direction, if any is roughly there.
  const strike = (key) => $('#view').dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true })); // prettier-ignore
  let stays = 0;
  for (let from = 0; from < surface.vertexCount; from++) {
    for (const [key, [x, y]] of Object.entries(ends)) {
      keyboard.reset();
      pointed = { vertex: from };
      strike('ArrowUp');
      assert.equal(cursors.at(-1), from);
      strike(key);
      const to = cursors.at(-1);
      const around = surface.neighbours.subarray(surface.neighbourStart[from], surface.neighbourStart[from + 1]); // prettier-ignore
      const cosine = (v) => (x * (at(v).x - at(from).x) + y * (at(v).y - at(from).y)) / (Math.hypot(at(v).x - at(from).x, at(v).y - at(from).y) || 1); // prettier-ignore
      const best = Math.max(...[...around].map(cosine));
      if (best <= 0.2) stays += 1;
      assert.ok(best > 0.2 ? around.includes(to) && cosine(to) === best : to === from, `${key} from ${from} to ${to}`); // prettier-ignore
    }
  }
  assert.ok(stays > 0 && stays < surface.vertexCount, `${stays} stay`);
  keyboard.reset();
  assert.equal(cursors.at(-1), -1);
  assert.equal(textOf($('#status')).length > 0, true);
}); // prettier-ignore

test('the palette finds actions by words in any order, and Enter takes the first that is possible', { skip }, async (t) => {
  const app = await pageWith(t, { 'cube.obj': toObj(cubeMesh(2)) });
  const { doc, ui } = app;
  const open = async (words) => {
    ui.dialog = 'palette';
    await drawn();
    const field = $('#palette-query');
    field.value = words;
    field.dispatchEvent(new Event('input', { bubbles: true }));
    await drawn();
    return $$('[data-action]').map(({ dataset }) => dataset.action);
  };
  const all = await open('');
  assert.ok(all.length > 30 && !all.includes('palette'));
  assert.deepEqual(await open('cones SUGGEST'), ['suggest']);
  assert.deepEqual(await open('no such thing'), []);
  assert.equal(await press('#palette-query', 'Enter'), false);
  assert.equal(ui.dialog, 'palette', 'there is none to take');
  const cones = await open('cone');
  const possible = $$('[data-action]').filter((one) => !one.disabled);
  assert.ok(cones.length > possible.length && possible.length > 0);
  assert.deepEqual($$('.first').map(({ dataset }) => dataset.action), [possible[0].dataset.action]); // prettier-ignore
  await open('log');
  await press('#palette-query', 'a');
  assert.equal(ui.dialog, 'palette');
  assert.equal(await press('#palette-query', 'Enter'), true);
  assert.equal(ui.dialog, 'log');
  await open('help');
  assert.deepEqual(await open(''), all, 'words are forgotten once it is closed');
  await click('[data-action="suggest"]');
  await until(() => doc.prescription.cones.length > 0 && !doc.isBusy);
  assert.equal(ui.dialog, '');
}); // prettier-ignore

test('buttons in notes and dialogs: quads, repairs, sizes, rows that were left out', { skip }, async (t) => {
  const app = await pageWith(t, { 'eight.obj': toObj(blocks(eight, { open: ['0 0 +z'] })) });
  const { doc, ui } = app;
  const handles = [...Array(10)].map(() => null);
  setPrescription(app, { ...doc.prescription, handles }, 'handles');
  await drawn();
  assert.equal($$('[data-handle]').length, 8);
  await click($$('#panel-turnings button').at(-1));
  assert.equal($$('[data-handle]').length, 10);
  // Steps begin at what the surface has, or the solver found.
  doc.history = doc.history.undo();
  await drawn();
  const small = $('[data-loop="0"] small').textContent;
  const natural = Number(small.match(/shape\s+(−?\d+)/)[1].replace('−', '-'));
  await click('[data-loop="0"] [aria-label$="smaller"]');
  assert.deepEqual(doc.prescription.turnings, [natural]);
  await click('[data-loop="0"] [aria-label$="smaller"]');
  assert.deepEqual(doc.prescription.turnings, [natural - 1]);
  await click('[data-loop="0"] [aria-label$="larger"]');
  assert.deepEqual(doc.prescription.turnings, [natural]);
  await choose('[data-loop="0"] input', ' ');
  assert.deepEqual(doc.prescription.turnings, [null]);
  await click('[data-handle="1"] [aria-label$="smaller"]');
  assert.equal(doc.prescription.handles[1], 0);

  await openFiles(app, { 'two.obj': toObj(beside(cubeMesh(3), cubeMesh(3))) });
  await runNow(app);
  const shown = [];
  app.views = { model: { highlight: (...all) => shown.push(all), lookAt: (v) => shown.push(v), draw() {} }, uv: { highlight() {} } }; // prettier-ignore
  t.after(() => (app.views = undefined));
  const place = (share, triangles, vertices) => ({ share, triangles: Uint32Array.from(triangles), vertices }); // prettier-ignore
  doc.solutions = [{ ...doc.current, overlaps: { triangles: Uint32Array.of(3, 4), pairs: 1, isMore: false }, sizes: { ...doc.current.sizes, range: 30, larger: place(0, [], []), smaller: place(0.1, [5], [17]) }, result: { ...doc.current.result, certificate: { ...doc.current.result.certificate, overlap: { share: 0.1, layers: 2 } } } }]; // prettier-ignore
  await drawn();
  await click('#overlaps button');
  assert.deepEqual([shown[0][0].length, textOf($('#status')).length > 0], [2, true]);
  shown.length = 0;
  await click('#sizes-differ button');
  assert.deepEqual([shown[0][0].length, shown[1]], [1, 17]);
  const { current } = doc;
  for (const range of [9.99, 10]) {
    doc.solutions = [{ ...current, sizes: { ...current.sizes, range } }];
    await drawn();
    assert.equal($('#sizes-differ') !== null, range >= 10, 'from ten times on');
  }
  ui.dialog = 'download';
  await drawn();
  for (const file of ['obj', 'glb']) {
    ui.dialog = 'download';
    await drawn();
    const { length } = saved;
    await click(`[data-format="quads-${file}"]`);
    assert.equal(ui.dialog, '', 'the progress is seen behind it');
    await until(() => saved.length > length && saved.at(-1).name);
    assert.equal(saved.at(-1).name, `two.quads.${file}`);
  }
  ui.setTarget('quads');
  ui.dialog = 'download';
  await drawn();
  const { length } = saved;
  await click('#downloads .primary.big');
  await until(() => saved.length > length && saved.at(-1).name);
  assert.deepEqual([saved.at(-1).name, ui.dialog], ['two.quads.obj', '']);
  for (const dialog of ['help', 'log', 'compare']) {
    ui.dialog = dialog;
    await drawn();
    await click($$('dialog button.primary').at(-1));
    assert.equal(ui.dialog, '', dialog);
  }

  const mesh = cubeMesh(3);
  const [a, b, c] = mesh.triangles[10];
  const broken = { vertices: mesh.vertices, triangles: [...mesh.triangles.with(10, [a, c, b]), [3, 3, 5]] }; // prettier-ignore
  await openFiles(app, { 'broken.off': toOff(broken) });
  await click('[data-fix="orient"]');
  await until(() => !doc.isBusy);
  assert.deepEqual(doc.settings.fix, { orient: true });
  await click('[data-fix="degenerate"]');
  await until(() => !doc.isBusy && doc.usableModel !== undefined);
}); // prettier-ignore

test('of very many boundaries two hundred are listed', { skip }, async (t) => {
  const app = await pageWith(t, { 'eight.obj': toObj(blocks(eight, { open: ['0 0 +z'] })) });
  const { doc } = app;
  const [component] = doc.model.info.components;
  const [loop] = component.boundaryLoops;
  const boundaryLoops = Array.from({ length: 250 }, (_, i) => ({ ...loop, loop: i }));
  const info = { ...doc.model.info, components: [{ ...component, boundaryLoops }] };
  doc.state = { ...doc.state, model: { ...doc.model, info } };
  await drawn();
  const numbers = $$('[data-loop]').map(({ dataset }) => Number(dataset.loop));
  assert.deepEqual(numbers, [...Array(200).keys()]);
  assert.match(textOf($('#panel-turnings .note')), /^… and 50 more boundaries/);
});

test('a file that is chosen twice in a row is opened twice', { skip }, async (t) => {
  const app = await openPage(t);
  const { doc } = app;
  for (const id of ['file', 'folder']) {
    const input = $(`#${id}`);
    const file = new File([toObj(cubeMesh(3))], 'cube.obj');
    Object.defineProperty(input, 'files', { value: [file], configurable: true });
    Object.defineProperty(input, 'value', { value: 'cube.obj', writable: true });
    const before = doc.model;
    input.dispatchEvent(new Event('change'));
    // A browser says nothing of a choice that is the one before.
    assert.equal(input.value, '');
    await until(() => !doc.isBusy && doc.model && doc.model !== before);
    assert.equal(doc.model.main, 'cube.obj');
  }
});
