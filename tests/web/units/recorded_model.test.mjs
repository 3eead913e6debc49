// Recorded: one model from the first screen to closing it, with everything that the page can do with it.

import test from 'node:test';
import { cubeMesh, toObj } from '../../support/meshes.mjs';
import { $, begin, buttonOf, choose, click, drag, drop, finish, placeOf, point, press, rest, setScreen, skip, solver, step, tap, waits } from './recorded_session.mjs'; // prettier-ignore

/** A box without equal sides, so that no rounding decides between equal cones. */
const box = (n) => {
  const { vertices, triangles } = cubeMesh(n);
  const at = ([x, y, z]) => [1.3 * x + 0.03 * y, y + 0.02 * z * z, 0.8 * z + 0.05 * x * y];
  return { vertices: vertices.map(at), triangles };
};

test('one model, from the first screen to closing it', { skip }, async () => {
  const app = await begin('model');
  const { doc, ui } = app;
  await step('the first screen');
  await step('theme', () => click('#theme'));
  await step('theme again', () => click('#theme'));
  await step('help', () => click('#help'));
  await step('no single keys', () => choose('#help-dialog input', false));
  await step('the log', () => click('#help-log'));
  await step('closed', () => click(buttonOf(/Close/, '#log-dialog')));
  await step('all actions', () => press(document.body, 'k', { ctrlKey: true }));
  await step('some of them', () => choose('#palette-query', 'THE mod'));
  await step('the first of them', () => press('#palette-query', 'Enter'));
  await step('nothing to run', () => click('#run'));
  await step('single keys', () => ui.setKeys(true));

  await step('a box', () => drop({ 'box.obj': toObj(box(4)) }));
  await step('not automatic', () => choose('#automatic', false));
  await step('moving over it', () => point('view', 'pointermove', 300, 200));
  await step('the tool to place', () => press('#view', 'c'));
  await step('over a corner', () => point('view', 'pointermove', ...placeOf(0)));
  await step('a cone there', () => tap('view', ...placeOf(0)));
  const middle = () => placeOf(70);
  await step('a cone elsewhere', () => tap('view', ...middle(), { altKey: true }));
  await step('beside the model', () => tap('view', 5, 5));
  await step('the cursor', () => (press('#view', 'c'), press('#view', 'c')));
  await step('to the right', () => press('#view', 'ArrowRight'));
  await step('and up', () => (press('#view', 'ArrowUp'), press('#view', 'ArrowUp')));
  await step('a cone at the cursor', () => press('#view', 'Enter'));
  await step('larger', () => press('#view', '+'));
  await step('five', () => press('#view', '5'));
  await step('the next cone', () => press('#view', 'n'));
  await step('and the one before', () => press('#view', 'p'));
  await step('deleted', () => press('#view', 'Delete'));
  await step('undone', () => press('#view', 'z', { ctrlKey: true }));
  await step('redone', () => press('#view', 'Z', { ctrlKey: true, shiftKey: true }));
  await step('orbiting', () => press('#view', 'c'));
  await step('deselected', () => press('#view', 'Escape'));
  await step('balanced', () => click('#balance'));
  await step('a run that is not ready', () => (choose('#cones [data-cone="0"] input', '9'), click('#run'))); // prettier-ignore
  await step('cleared', () => click('#clear-cones'));
  await step('order six', () => choose('#q', '6'));
  await step('order nine', () => choose('#q-custom', '9'));
  await step('no order', () => choose('#q-custom', '0'));
  await step('order four', () => choose('#q', '4'));

  await step('suggested', () => click('#suggest'));
  await step('as few as possible', () => choose('#cone-step', '0'));
  await step('many', () => choose('#cone-step', '4'));
  await step('fewer again', () => choose('#cone-step', '1'));
  solver.isHeld = waits.isOff = true;
  await step('running', () => press(document.body, 'Enter', { ctrlKey: true }));
  await step('half a second', () => undefined, 500);
  for (const [stage, fraction, round] of [['cones', 0.2, 0], ['field', 0.5, 0], ['solve', 0.1, 1], ['solve', 0.6, 2], ['verify', 0.9, 3]]) await step(`at ${stage}, ${fraction}`, () => solver.answer({ progress: { stage, fraction, iteration: 3, residual: 0.1, round, maxRounds: 12 } }), 700); // prettier-ignore
  waits.isOff = false;
  await step('done', () => solver.release());
  await step('over the map', () => point('map', 'pointermove', 300, 200));
  await step('over the model', () => point('view', 'pointermove', 310, 190));
  const seamEnds = () => doc.current.seams[3].a.map((end) => doc.current.result.uvToVertex[end]);
  const seamMiddle = () => [0, 1].map((i) => (placeOf(seamEnds()[0])[i] + placeOf(seamEnds()[1])[i]) / 2); // prettier-ignore
  await step('over a seam', () => point('view', 'pointermove', ...seamMiddle()));
  await step('away', () => point('view', 'pointerleave', 0, 0));
  for (let i = 0; i < 9; i++) await step(`pattern ${i}`, () => press('#view', 'g'));
  for (let i = 0; i < 5; i++) await step(`overlay ${i}`, () => press('#view', 'h'));
  for (let i = 0; i < 4; i++) await step(`light ${i}`, () => press('#view', 't'));
  await step('crosses', () => choose('#pattern', 'cross'));
  await step('more of them', () => choose('#scale', '60'));
  await step('checkers', () => choose('#pattern', 'checker'));
  await step('another scale', () => choose('#scale', '3'));
  await step('wires', () => press('#view', 'l'));
  await step('no wires', () => press('#view', 'l'));
  await step('seams', () => press('#view', 's'));
  await step('no seams', () => press('#view', 's'));
  await step('before and after', () => choose('#wipe', '40'));
  await step('after only', () => choose('#wipe', '0'));
  await step('parallel', () => press('#view', 'o'));
  await step('in perspective', () => press('#view', 'o'));
  await step('turned by keys', () => (press('#view', 'ArrowLeft'), press('#view', 'ArrowUp')));
  await step('panned by keys', () => press('#view', 'ArrowRight', { shiftKey: true }));
  await step('nearer', () => press('#view', 'PageUp'));
  await step('farther', () => press('#view', 'PageDown'));
  await step('turned by hand', () => drag('view', [20, 20], [80, 50]));
  await step('released', () => point('view', 'pointerup', 80, 50));
  await step('reset', () => press('#view', 'r'));
  await step('a place in the middle', () => point('view', 'dblclick', 330, 180));
  await step('framed', () => click('#frame'));
  await step('the other view', () => press('#view', 'u'));
  await step('the map moved', () => press('#map', 'ArrowRight'));
  await step('the map nearer', () => press('#map', 'PageUp'));
  await step('a place of the map in the middle', () => point('map', 'dblclick', 300, 150));
  await step('the map dragged', () => drag('map', [10, 10], [60, 30]));
  await step('and released', () => (point('map', 'pointerup', 60, 30), press('#map', 'u')));
  await step('all framed', () => press('#view', 'f'));
  await step('a picture', () => click('#picture'));

  await step('a row selected', () => click('#cones [data-cone="1"] th button'));
  await step('looked at', () => click('#cones [data-cone="1"] [aria-label$="frame"]'));
  await step('sorted by k', () => click('[data-sort="k"]'));
  await step('and the other way', () => click('[data-sort="k"]'));
  await step('by number', () => click('[data-sort="number"]'));
  await step('a smaller k', () => click('#cones [data-cone="1"] [aria-label$="smaller k"]'));
  await step('mirrored', () => click('#mirror-cone'));
  await step('back to before', async () => {
    while (!doc.current && doc.history.canUndo) await (click('#undo'), rest());
  });
  const cone = () => doc.prescription.cones[0].vertex;
  const beside = () => {
    const { neighbourStart, neighbours } = doc.model.surface;
    return neighbours[neighbourStart[cone()]];
  };
  await step('a cone taken along', async () => {
    app.views.model.lookAt(cone());
    await rest();
    await drag('view', placeOf(cone()), placeOf(beside()));
    point('view', 'pointerup', ...placeOf(cone()));
  });
  await step('run anew', () => click(buttonOf(/Run anew/, '#dragged, hgp-status-bar')));
  await step('a cone put back', async () => {
    await drag('view', placeOf(cone()), placeOf(beside()));
    press(document.body, 'Escape');
  });

  await step('aligned off', () => choose('#align', false));
  await step('aligned on', () => choose('#align', true));
  await step('few cells', () => choose('#cells', '20'));
  await step('cells as it likes', () => click('#cells-automatic'));
  await step('for quads', () => choose('#grid-mode', 'quad'));
  await step('less distortion', () => choose('#quality', true));
  await step('mostly for areas', () => choose('#improve', '0.5'));
  await step('limits', () => (choose('#rounds', '7'), choose('#time-limit', '20')));
  await step('run with that', () => click('#run'));
  await step('compared', () => perform('compare'));
  await step('the first shown', () => click('#runs [data-run]:not([disabled])'));
  await step('no features', () => choose('#follow-creases', true));
  await step('features away', () => choose('#follow-creases', false));
  await step('quads', () => click('#preview-quads'));
  await step('the quads as OBJ', () => click('#save-quads-obj'));
  await step('the quads as GLB', () => click('#save-quads-glb'));
  await step('quads away', () => click('#hide-quads'));

  await step('download', () => click('#download'));
  for (const target of ['three', 'engine', 'quads', 'blender']) await step(`for ${target}`, () => choose('#target', target)); // prettier-ignore
  await step('as large as an edge', () => choose('#uv-scale', 'unit'));
  await step('with a grid', () => choose('#grid-material', true));
  await step('without cones', () => choose('#embed-cones', false));
  await step('validated', () => click('#validate'));
  for (const format of ['glb', 'zip', 'flat', 'cones', 'report', 'svg']) {
    await step(`as ${format}`, () => click(`#downloads [data-format="${format}"]`));
    if (!$('#downloads')) await (click('#download'), rest());
  }
  await step('saved', () => click('#downloads .primary.big'));
  await step('the command', () => click('#copy-command'));
  await step('the link', () => perform('copy-link'));
  await step('the cones', () => click('#export-cones'));
  for (const preset of ['few', 'quads', 'tiling']) await step(`for ${preset}`, () => click(`[data-preset="${preset}"]`)); // prettier-ignore
  await step('automatic', () => choose('#automatic', true));
  await step('follows an edit', () => click('#cones [data-cone="0"] [aria-label$="delete"]'));
  await step('and another', () => click('#balance'));
  await step('not automatic any more', () => choose('#automatic', false));

  solver.isHeld = waits.isOff = true;
  await step('limited', () => (choose('#quality', true), click('#run')));
  await step('too late', () => undefined, 21_000);
  solver.held = [];
  solver.isHeld = false;
  waits.isOff = false;
  await step('no limit', () => choose('#time-limit', ''));
  solver.isHeld = waits.isOff = true;
  await step('running again', () => click('#run'));
  await step('asked once', () => press('#view', 'Escape'));
  await step('asked twice', () => press('#view', 'Escape'));
  solver.held = [];
  await step('running once more', () => click('#run'));
  await step('cancelled', () => click('#cancel'));
  solver.held = [];
  for (const code of ['unsolvable', 'limit', 'malformed']) {
    await step(code, async () => {
      click('#run');
      await rest();
      solver.answer({ error: { code, message: 'so it is' } });
      solver.held = [];
    });
  }
  await step('running into the end', () => click('#run'));
  await step('the worker ends', () => solver.lose('out of luck'));
  solver.held = [];
  solver.isHeld = waits.isOff = false;
  await step('run after all', () => click('#run'));
  await step('dark', () => setScreen({ dark: true }));
  await step('light', () => setScreen({ dark: false }));
  await step('another version', () => drop({ 'box.obj': toObj(box(5)) }));
  await step('closed', () => click('#close'));
  await step('open again', () => click(buttonOf(/Open it again/)));
  await step('closed again', () => click('#close'));
  await step('one of the last files', () => click('[data-recent]'));
  await step('closed for good', () => click('#close'));
  await step('forgotten', () => click('#forget-recent'));
  await step('the log at the end', () => click('#log'));
  finish();

  async function perform(id) {
    press(document.body, 'k', { ctrlKey: true });
    await rest();
    click(`[data-action="${id}"]`);
  }
});
