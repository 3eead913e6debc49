// Keys, focus and dialogs of the page, in a document without a browser.

import assert from 'node:assert/strict';
import test from 'node:test';
import { cubeMesh, toObj } from '../../support/meshes.mjs';
import { $, $$, choose, click, drawn, openFiles, openPage, runNow, skip, textOf } from './whole_page.mjs'; // prettier-ignore

const press = async (target, key, more = {}) => {
  const event = new KeyboardEvent('keydown', { key, bubbles: true, cancelable: true, ...more });
  (typeof target === 'string' ? $(target) : target).dispatchEvent(event);
  await drawn();
  return event.defaultPrevented;
};

/** What is in the middle of the view. */
const pointed = { vertex: 9 };

/** A page with a keyboard, and views that note what they are told. */
async function pageWithKeys(t) {
  const { Keyboard } = await import('../../../web/src/input/keyboard.ts');
  const app = await openPage(t);
  await openFiles(app, { 'cube.obj': toObj(cubeMesh(6)) });
  const told = [];
  const tell = (name) => (...args) => void told.push([name, ...args]); // prettier-ignore
  const { surface } = app.doc.model;
  const orbit = { move: tell('move'), pan: tell('pan'), toText: () => '', reset: tell('reset'), fit: tell('fit'), toggleParallel: tell('parallel') }; // prettier-ignore
  const model = { orbit, setCursor: tell('cursor'), highlight: tell('highlight'), lookAt: tell('look'), draw() {}, canvas: $('#view'), pick: () => ({ vertex: pointed.vertex }), setHandles: tell('handles'), toScreen: (v) => ({ x: surface.positions[3 * v], y: -surface.positions[3 * v + 1] }) }; // prettier-ignore
  app.views = { model, uv: { highlight() {}, zoom: tell('zoom'), pan: tell('uv-pan'), fit() {} } };
  const keyboard = new Keyboard(app);
  return { app, told, keyboard, surface };
}

test(
  'single keys edit the selected cone while a view has the focus, and do nothing elsewhere',
  { skip },
  async (t) => {
    // prettier-ignore
    const { app } = await pageWithKeys(t);
    const { doc, ui } = app;
    ui.setAutomatic(false);
    await runNow(app);
    const count = doc.prescription.cones.length;
    await press('#view', 'n');
    assert.equal(doc.selected, 0);
    await press('#view', 'n');
    assert.equal(doc.selected, 1);
    assert.match(textOf($('#status')), /^Cone 2, k = /);
    for (const [key, index] of [
      ['p', 0],
      ['p', count - 1],
      ['n', 0],
    ]) {
      // prettier-ignore
      await press('#view', key);
      assert.equal(doc.selected, index, key);
    }
    const k = () => doc.prescription.cones[0].k;
    for (const [key, to] of [
      ['3', 3],
      ['+', 4],
      ['=', 5],
      ['-', 4],
      ['1', 1],
    ]) {
      // prettier-ignore
      await press('#view', key);
      assert.equal(k(), to, key);
    }
    await press('#view', '-');
    assert.equal(k(), 1, 'not below 1');
    await press('#panel-cones', '3');
    assert.equal(k(), 1, 'the focus is elsewhere');
    ui.setKeys(false);
    await press('#view', '3');
    assert.equal(k(), 1, 'single keys are switched off');
    ui.setKeys(true);
    await press('#view', 'Delete');
    assert.deepEqual([doc.prescription.cones.length, doc.selected], [count - 1, -1]);
    assert.equal(await press(document.body, 'z', { ctrlKey: true }), true);
    assert.equal(doc.prescription.cones.length, count);
    await press(document.body, 'z', { ctrlKey: true, shiftKey: true });
    assert.equal(doc.prescription.cones.length, count - 1);
    await press(document.body, 'y', { ctrlKey: true });
    assert.match(textOf($('#status')), /Nothing to redo/);
    assert.equal(await press(document.body, 'j', { ctrlKey: true }), false, 'the browser’s own');
    doc.selected = 2;
    await press('#view', 'Escape');
    assert.equal(doc.selected, -1);
  },
);

test(
  'arrows turn, pan and zoom; with the Place tool they walk over vertices, and Enter places',
  { skip },
  async (t) => {
    // prettier-ignore
    const { app, told, surface } = await pageWithKeys(t);
    const { doc, ui } = app;
    const last = () => told.at(-1);
    await press('#view', 'ArrowLeft');
    assert.deepEqual(last().slice(0, 1), ['move']);
    assert.ok(last()[1] < 0 && last()[2] === 0);
    await press('#view', 'ArrowUp');
    assert.ok(last()[1] === 0 && last()[2] < 0, 'from above');
    await press('#view', 'ArrowRight', { shiftKey: true });
    assert.ok(last()[0] === 'pan' && last()[1] < 0);
    await press('#view', 'PageUp');
    assert.ok(last()[0] === 'move' && last()[3] < 1, 'nearer');
    await press('#view', 'PageDown');
    assert.ok(last()[3] > 1);
    await press('#map', 'ArrowRight');
    assert.ok(last()[0] === 'uv-pan' && last()[1] > 0);
    await press('#map', 'PageUp');
    assert.equal(last()[0], 'zoom');
    // Opposite keys undo one another, and steps are as long up and down as left and right.
    for (const [view, kind, more] of [
      ['#view', 'move', {}],
      ['#view', 'pan', { shiftKey: true }],
      ['#map', 'uv-pan', {}],
    ]) {
      // prettier-ignore
      const step = async (key) => {
        await press(view, key, more);
        assert.equal(last()[0], kind);
        return last().slice(1, 3);
      };
      const [left, right, up, down] = [await step('ArrowLeft'), await step('ArrowRight'), await step('ArrowUp'), await step('ArrowDown')]; // prettier-ignore
      assert.ok(left[0] !== 0 && left[0] + right[0] === 0 && left[1] === 0 && right[1] === 0, kind);
      assert.ok(up[0] === 0 && down[0] === 0 && up[1] + down[1] === 0, kind);
      assert.ok(Math.abs(up[1]) === Math.abs(left[0]) && Math.abs(up[1]) < 0.3, kind);
    }
    for (const view of ['#view', '#map']) {
      await press(view, 'PageUp');
      const nearer = last().at(-1);
      await press(view, 'PageDown');
      assert.ok(nearer < 1 && nearer > 0.5 && Math.abs(nearer * last().at(-1) - 1) < 1e-9, view);
    }
    await press('#view', 'c');
    assert.equal(ui.tool, 'place');
    assert.deepEqual(last(), ['cursor', 9]);
    for (const [key, axis, sign] of [
      ['ArrowRight', 0, 1],
      ['ArrowUp', 1, 1],
      ['ArrowLeft', 0, -1],
      ['ArrowDown', 1, -1],
    ]) {
      // prettier-ignore
      const from = last()[1];
      await press('#view', key);
      const to = last()[1];
      if (to === from) continue; // there is no neighbour on that side
      const around = [...surface.neighbours.subarray(surface.neighbourStart[from], surface.neighbourStart[from + 1])]; // prettier-ignore
      assert.ok(around.includes(to), key);
      assert.ok(sign * (surface.positions[3 * to + axis] - surface.positions[3 * from + axis]) > 0, key); // prettier-ignore
      assert.match(textOf($('#status')), new RegExp(`^vertex ${to}, valence ${surface.valence[to]}, `)); // prettier-ignore
    }
    const at = last()[1];
    await press('#view', 'Enter');
    assert.deepEqual(
      doc.prescription.cones.map(({ vertex }) => vertex),
      [at],
    );
    await press('#view', 'c');
    assert.deepEqual([ui.tool, last()], ['orbit', ['cursor', -1]]);

    pointed.vertex = 0; // the first of all
    await press('#view', 'c');
    await press('#view', 'Enter');
    pointed.vertex = 9;
    assert.deepEqual(
      doc.prescription.cones.map(({ vertex }) => vertex),
      [at, 0],
    );
  },
);

test('a run is cancelled by Escape pressed twice', { skip }, async (t) => {
  const { app } = await pageWithKeys(t);
  const { doc } = app;
  const controller = new AbortController();
  doc.job = { kind: 'run', title: 'Running', stage: 'solve', entered: [], detail: '', fraction: 0, begin: performance.now(), controller }; // prettier-ignore
  await press('#view', 'Escape');
  assert.equal(controller.signal.aborted, false);
  assert.match(textOf($('#aside')), /Escape once more/);
  await press('#view', 'Escape');
  assert.equal(controller.signal.aborted, true);
  doc.job = undefined;
});

test(
  'the cone table is one Tab stop: arrows move between its controls, Home and End to the ends of a row',
  { skip },
  async (t) => {
    // prettier-ignore
    const { app } = await pageWithKeys(t);
    await runNow(app);
    const controls = (row) => $$('button, input', row);
    const rows = () => $$('#cones tr').filter((row) => controls(row).length > 0);
    const stops = () => controls($('#cones')).filter((one) => one.tabIndex === 0);
    assert.equal(stops().length, 1);
    assert.equal(stops()[0], controls($('#cones tbody'))[0], 'the first of the cones');
    const row = controls(rows()[2]);
    const focus = (element) => {
      element.focus();
      element.dispatchEvent(new FocusEvent('focusin', { bubbles: true }));
    };
    focus(row[1]);
    assert.deepEqual(stops(), [row[1]], 'where the focus was');
    const after = async (key, from) => {
      focus(from);
      const isTaken = await press(from, key);
      assert.equal(isTaken, document.activeElement !== from, key);
      return document.activeElement;
    };
    assert.equal(await after('Home', row[2]), row[0]);
    assert.equal(await after('End', row[0]), row.at(-1));
    assert.equal(await after('ArrowRight', row[0]), row[1]);
    assert.equal(await after('ArrowLeft', row[1]), row[0]);
    assert.equal(await after('ArrowDown', row[1]), controls(rows()[3])[1]);
    assert.equal(await after('ArrowUp', row[1]), controls(rows()[1])[1]);
    const [head, first] = rows().map(controls);
    assert.ok(head.length < first.length);
    assert.equal(
      await after('ArrowUp', first.at(-1)),
      head.at(-1),
      'the last one of a shorter row',
    );
    const field = row.find((one) => one.matches('input'));
    assert.equal(await after('ArrowUp', field), field, 'a number changes by it');
    assert.equal(await after('x', row[0]), row[0]);
    assert.equal(await after('ArrowLeft', row[0]), row[0], 'there is none');
  },
);

test(
  'keys that move the focus, the view or the splitter leave those with Ctrl, ⌘ or Alt to the browser',
  { skip },
  async (t) => {
    // prettier-ignore
    const { app, told } = await pageWithKeys(t);
    const { doc, ui } = app;
    const { listenToSplitter } = await import('../../../web/src/input/splitter.ts');
    const splitter = $('#splitter');
    listenToSplitter(splitter, ui);
    ui.setAutomatic(false);
    await runNow(app);
    doc.selected = 1;
    await drawn();
    const keys = ['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown', 'Home', 'End', 'PageUp', 'PageDown', '3', 'n', 'm', 'c', 'Delete']; // prettier-ignore
    const table = $$('#cones tbody tr')[1].querySelectorAll('button')[1];
    const tool = $('#tool-place');
    for (const target of [table, tool, $('#view'), $('#map'), splitter]) {
      for (const modifier of ['ctrlKey', 'metaKey', 'altKey']) {
        for (const key of keys) {
          target.focus();
          const [{ prescription, selected }, { length }, { split }] = [doc, told, ui];
          const isTaken = await press(target, key, { [modifier]: true });
          const what = `${target.id} ${modifier} ${key}`;
          assert.equal(isTaken, false, what);
          assert.equal(document.activeElement, target, what);
          assert.deepEqual([doc.prescription === prescription, doc.selected, told.length, ui.split], [true, selected, length, split], what); // prettier-ignore
        }
      }
    }
  },
);

test(
  'actions are found by their words; what cannot be done says why; Enter does the first',
  { skip },
  async (t) => {
    // prettier-ignore
    const { app } = await pageWithKeys(t);
    const { actionIds, actions, keyOf, actionForKey, labelOf, whyNotOf } = await import('../../../web/src/actions/registry.ts'); // prettier-ignore
    await press(document.body, 'k', { ctrlKey: true });
    const items = () => $$('[data-action]');
    assert.equal(items().length, actionIds.length - 1, 'all but the list itself');
    for (const item of items()) {
      const id = item.dataset.action;
      assert.equal(item.disabled, whyNotOf(app, id) !== '', id);
      assert.ok(textOf(item).startsWith(labelOf(app, id)), id);
    }
    const query = $('#palette-query');
    query.value = 'CONE clear';
    query.dispatchEvent(new Event('input', { bubbles: true }));
    await drawn();
    assert.deepEqual(
      items().map(({ dataset }) => dataset.action),
      ['clear-cones'],
    );
    query.value = 'theme';
    query.dispatchEvent(new Event('input', { bubbles: true }));
    await drawn();
    const before = app.ui.theme;
    await press('#palette-query', 'Enter');
    assert.notEqual(app.ui.theme, before);
    assert.equal(app.ui.dialog, '');
    // Every key belongs to one action.
    const keys = actionIds.flatMap((id) => actions[id].keys ?? []);
    assert.equal(new Set(keys).size, keys.length);
    for (const id of actionIds) for (const key of actions[id].keys ?? []) assert.equal(actionForKey(key), id); // prettier-ignore
    assert.equal(keyOf({ key: 'n' }), 'N');
    assert.equal(keyOf({ key: 'z', ctrlKey: true, shiftKey: true }), 'Ctrl+Shift+Z');
    assert.equal(keyOf({ key: 's', metaKey: true }), 'Ctrl+S');
    await press(document.body, 'k', { ctrlKey: true });
    assert.equal(await press('#view', 'n'), false, 'nothing behind a dialog');
    app.ui.dialog = 'help';
    await drawn();
    const lines = $$('#help-dialog .keys > div').map((one) => textOf(one));
    for (const id of actionIds.filter((one) => actions[one].keys)) assert.ok(lines.some((line) => line.endsWith(labelOf(app, id))), id); // prettier-ignore
    await choose('#help-dialog input', false);
    assert.equal(app.ui.hasKeys, false);
    app.doc.say('a message');
    app.ui.dialog = 'log';
    await drawn();
    assert.match(textOf($('.log li')), /a message$/);
  },
);

test('a map that came from dragging says so, others do not', { skip }, async (t) => {
  const { app } = await pageWithKeys(t);
  const { doc } = app;
  await runNow(app);
  assert.equal($('#dragged'), null);
  doc.solutions = [{ ...doc.current, isDragged: true }];
  await drawn();
  assert.match(textOf($('#dragged')), /dragging a cone/);
  doc.look = { ...doc.look, overlay: 'flips' };
  await drawn();
  assert.match(textOf($('.legend')), /Folded triangles ?none/);
  for (const overlay of ['angle', 'area', 'seams']) {
    doc.look = { ...doc.look, overlay };
    await drawn();
    const [low, middle, high] = $$('.legend .ends > span').map((one) => textOf(one));
    const number = (text) => Number(text.match(/[\d.]+/)[0]);
    if (overlay === 'angle') assert.ok(number(low) === 1 && 2 * number(middle) - 1 - number(high) < 0.02); // prettier-ignore
    if (overlay === 'seams') assert.ok(number(low) === 0 && Math.abs(2 * number(middle) - number(high)) < 0.06 * number(high)); // prettier-ignore
    if (overlay === 'area') assert.deepEqual([low[0], middle, high[0], number(low)], ['÷', '1', '×', number(high)]); // prettier-ignore
  }
  await click('[data-sort="k"]');
});

test(
  'the pages’ own settings: themes in turn, the tabs, the sheet, the width of the views',
  { skip },
  async (t) => {
    // prettier-ignore
    const { app } = await pageWithKeys(t);
    const { ui } = app;
    const seen = [];
    for (let i = 0; i < 3; i++) {
      ui.nextTheme();
      seen.push([ui.theme, document.documentElement.dataset.theme, localStorage.getItem('hgp-theme'), ui.isDark]); // prettier-ignore
    }
    assert.deepEqual(seen, [['light', 'light', 'light', false], ['dark', 'dark', 'dark', true], ['auto', 'auto', 'auto', ui.isSystemDark]]); // prettier-ignore
    ui.setSplit(5);
    assert.equal(ui.split, 20);
    ui.setSplit(99);
    assert.equal(ui.split, 80);
    ui.setSplit(50.4);
    await drawn();
    assert.equal($('#splitter').getAttribute('aria-valuenow'), '50');
    await click('#tab-map');
    assert.deepEqual([ui.tab, $('#pane-map').dataset.shown, $('#pane-surface').dataset.shown], ['map', 'true', 'false']); // prettier-ignore
    const order = [];
    for (let i = 0; i < 3; i++) {
      order.push([ui.sheet, $('#sheet').getAttribute('aria-expanded')]);
      await click('#sheet');
    }
    assert.deepEqual(order, [['half', 'true'], ['full', 'true'], ['peek', 'false']]); // prettier-ignore
    ui.setTarget('three');
    ui.setAutomatic(true);
    const { UiState } = await import('../../../web/src/model/ui_state.ts');
    const next = new UiState();
    assert.deepEqual([next.target, next.automatic, next.theme, next.hasKeys], ['three', true, 'auto', true]); // prettier-ignore
  },
);

test(
  'the sheet follows the finger and snaps to the nearest height; a tap is no drag',
  { skip },
  async (t) => {
    // prettier-ignore
    const { app } = await pageWithKeys(t);
    const { ui } = app;
    const [aside, handle] = [$('aside'), $('#sheet')];
    handle.setPointerCapture = () => undefined;
    let height = 400;
    Object.defineProperty(aside, 'offsetHeight', { configurable: true, get: () => height });
    Object.defineProperty(aside.parentElement, 'clientHeight', { configurable: true, value: 800 });
    const touch = async (type, y) => {
      handle.dispatchEvent(new PointerEvent(type, { bubbles: true, clientY: y, pointerId: 1 }));
      await drawn();
    };
    const dragged = () => aside.style.getPropertyValue('--sheet-drag');
    for (const [to, sheet] of [
      [-350, 'full'],
      [-90, 'half'],
      [380, 'peek'],
      [150, 'half'],
    ]) {
      // prettier-ignore
      height = 400;
      await touch('pointerdown', 500);
      await touch('pointermove', 500 + Math.sign(to) * 6);
      assert.equal(dragged(), '', 'hardly moved');
      await touch('pointermove', 500 + Math.sign(to) * 7);
      assert.equal(dragged(), `${400 - Math.sign(to) * 7}px`, 'from seven pixels on');
      await touch('pointermove', 500 + to);
      height = Math.min(Math.max(400 - to, 46), 800);
      assert.equal(dragged(), `${height}px`, 'up is taller');
      await touch('pointerup', 500 + to);
      assert.deepEqual([ui.sheet, dragged()], [sheet, '']);
      handle.dispatchEvent(new MouseEvent('click', { bubbles: true, detail: 1 }));
      assert.equal(ui.sheet, sheet, 'the end of a drag is no tap');
    }
    await touch('pointerdown', 500);
    await touch('pointermove', 506);
    await touch('pointerup', 500);
    handle.dispatchEvent(new MouseEvent('click', { bubbles: true, detail: 1 }));
    assert.equal(ui.sheet, 'full', 'the next one');
  },
);

test(
  'the divider: keys move it by steps, a click to the next place, dragging to the pointer',
  { skip },
  async (t) => {
    // prettier-ignore
    const { app } = await pageWithKeys(t);
    const { ui } = app;
    const { listenToSplitter } = await import('../../../web/src/input/splitter.ts');
    const splitter = $('#splitter');
    splitter.setPointerCapture = () => undefined;
    listenToSplitter(splitter, ui);
    const before = ui.split;
    await press(splitter, 'ArrowLeft');
    assert.equal(ui.split, before - 4);
    await press(splitter, 'ArrowRight');
    assert.equal(ui.split, before);
    const places = [];
    for (let i = 0; i < 3; i++) {
      splitter.dispatchEvent(new MouseEvent('click'));
      places.push(ui.split);
    }
    assert.deepEqual(
      places.toSorted((a, b) => a - b),
      [30, 58, 80],
    );
    $('#pane-surface').getBoundingClientRect = () => ({ left: 100, right: 500 });
    $('#pane-map').getBoundingClientRect = () => ({ left: 500, right: 900 });
    const drag = (x, buttons) => splitter.dispatchEvent(new PointerEvent('pointermove', { clientX: x, buttons })); // prettier-ignore
    splitter.dispatchEvent(new PointerEvent('pointerdown', { pointerId: 1 }));
    drag(700, 0);
    assert.equal(ui.split, places.at(-1), 'no button is pressed');
    drag(500, 1);
    assert.equal(ui.split, 50);
    splitter.dispatchEvent(new MouseEvent('click'));
    assert.equal(ui.split, 50, 'the end of a drag');
  },
);
