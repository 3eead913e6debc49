// How runs end: what is said of a failure and which way out is offered, what of a map that passes and of one that does not, and what
// becomes of maps that nobody shows any more.

import assert from 'node:assert/strict';
import test from 'node:test';
import { HgpError } from 'hgp';
import { beside } from '../../support/blocks.mjs';
import { cubeCrosses, cubeMesh, toObj } from '../../support/meshes.mjs';
import { $$, click, copied, drawn, openFiles, openPage, runNow, skip, textOf, until } from './whole_page.mjs'; // prettier-ignore

const { denserButton, keepSolution, mapInSolver, realign, rewrite, run, sayRunFailure, sayVerdict, setSolve } = await import('../../../web/src/actions/solve.ts'); // prettier-ignore
const { setPrescription } = await import('../../../web/src/actions/edit_cones.ts');

async function pageWith(t, files = { 'cube.obj': toObj(cubeMesh(4)) }) {
  const app = await openPage(t);
  await openFiles(app, files);
  app.ui.setAutomatic(false);
  return app;
}
const errorOf = (code, details = {}) => new HgpError({ code, message: 'so it is', ...details });

test('each failure of a run has its ways out: again, the command, the place, automatic frames, other cones', { skip }, async (t) => {
  const app = await pageWith(t);
  const { doc } = app;
  await runNow(app);
  const cones = doc.prescription;
  const waysOf = (error) => {
    doc.message = undefined;
    sayRunFailure(app, error);
    assert.equal(doc.message.kind, 'error');
    return doc.message.actions ?? [];
  };
  const [again, ...none] = waysOf(errorOf('worker-lost'));
  assert.deepEqual(none, []);
  const { length } = doc.solutions;
  await again.run();
  assert.deepEqual([doc.solutions.length, doc.prescription], [length + 1, cones]);

  const copies = copied.length;
  const limits = waysOf(errorOf('limit'));
  assert.equal(limits.length, 1);
  await limits[0].run();
  assert.equal(copied.length, copies + 1);

  const plain = waysOf(errorOf('no-certificate'));
  const plainText = doc.message.text;
  assert.equal(plain.length, 1);
  const noMap = waysOf(errorOf('no-map'));
  assert.ok(doc.message.text.length > plainText.length, 'what may help');
  assert.equal(noMap.length, 1);
  assert.equal(waysOf(new Error('so it is')).length, 1);
  const shown = [];
  app.views = { model: { highlight: (all) => shown.push(all.length), lookAt() {} }, uv: { highlight() {} } }; // prettier-ignore
  const placed = waysOf(errorOf('no-map', { where: [{ kind: 'triangle', id: 3 }] }));
  assert.equal(placed.length, 2);
 placed[0].run();
 assert.deepEqual(shown, [1]);
 assert.equal(waysOf(errorOf('no-map', { where: [] })).length, 1);
app.views = undefined;
  doc.field = { name: 'a.rosy', text: cubeCrosses(cubeMesh(4)) };
  doc.solve = { ...doc.solve, frames: 'file' };
  const framed = waysOf(errorOf('no-certificate'));
  assert.equal(framed.length, 2);
  await framed[0].run();
  assert.equal(doc.solve.frames, 'auto');
  assert.notEqual(doc.current, undefined);
  setPrescription(app, { ...doc.prescription, cones: [] }, 'clear');
  await waysOf(errorOf('no-certificate'))[0].run();
  assert.ok(doc.prescription.cones.length > 0, 'suggested');
}); // prettier-ignore

test('a verdict says what is certified, what was suggested, what passes, and what may do better', { skip }, async (t) => {
  const app = await pageWith(t, { 'two.obj': toObj(beside(cubeMesh(2), cubeMesh(3))) });
  const { doc } = app;
  await runNow(app);
  const good = doc.current;
  const said = (solution, isOpen = false) => {
    sayVerdict(app, solution, isOpen);
    return doc.message;
  };
  const plain = said(good);
  assert.deepEqual([plain.kind, plain.actions], ['good', []]);
  assert.ok(said(good, true).text.length > plain.text.length, 'how many were suggested');
  const without = { ...good, prescription: { ...good.prescription, cones: [] } };
  assert.equal(said(without, true).text, said(without).text, 'none were');
  const { result } = good;
  const { certificate, report } = result;
  const [first, second] = certificate.components;
  const failing = (parts, more = {}) => ({ ...good, ...more, result: { ...result, certificate: { ...certificate, certified: false, components: parts } } }); // prettier-ignore
  const bad = { ...second, reasons: [{ message: 'so it is' }] };
  const one = said(failing([first, bad]));
  assert.equal(one.kind, 'error');
  assert.ok(one.text.includes('1 of 2'));
  assert.ok(!/\d of \d/.test(said(failing([{ ...first, reasons: bad.reasons }, bad])).text));
  assert.ok(said(failing([{ ...first, reasons: [] }, { ...second, reasons: undefined }])).text.includes('2 of 2')); // prettier-ignore
  assert.ok(said(failing([first, bad], { frames: 'file' })).text.length > one.text.length);
  const coarse = (workingCells) => ({ ...good, result: { ...result, report: { ...report, components: report.components.map((part) => ({ ...part, grid: { ...part.grid, aligned: false, workingCells } })) } } }); // prettier-ignore
  assert.deepEqual(denserButton(app, coarse(0)), []);
  assert.equal(said(coarse(0)).actions.length, 0);
  assert.notEqual(said(coarse(0)).text, plain.text, 'lines do not meet');
  assert.equal(said(coarse(1)).actions.length, 1);
  const none = { ...good, seams: [] };
  assert.notEqual(said(none).text, plain.text);
  assert.deepEqual(denserButton(app, { ...good, result: { ...result, report: { ...report, components: [{}, {}] } } }), []); // prettier-ignore
  const { cells } = { cells: 800 };
  const [button] = denserButton(app, coarse(cells));
  await button.run();
  await until(() => !doc.isBusy);
  assert.ok(doc.solve.grid.cells >= cells, 'at least as many as work');
}); // prettier-ignore

test('three maps are kept, settings apply to the next run or at once, and a map that cannot be written is told', { skip }, async (t) => {
  const app = await pageWith(t);
  const { doc } = app;
  assert.equal(await mapInSolver(app), undefined);
  await rewrite(app, { scale: 'fit' });
  assert.deepEqual([doc.pendingOutput, doc.isBusy], [undefined, false], 'there is no map');
  await realign(app, { cells: 500 });
  assert.deepEqual([doc.solve.grid.cells, doc.solutions.length], [500, 0], 'for the next run');
  await realign(app, { cells: undefined });
  await runNow(app);
  const first = doc.current;
  doc.isUnsaved = false;
  const four = [1, 2, 3, 4].map((id) => ({ ...first, id }));
  for (const one of four) keepSolution(app, one);
  assert.deepEqual(doc.solutions, four.slice(1));
  assert.equal(doc.isUnsaved, true);
  doc.solutions = [first];
  setSolve(app, { rounds: 3 });
  assert.deepEqual([doc.solve.rounds, doc.current], [3, first], 'rounds do not change which map is shown');

  // Settings that are chosen while the file is written take effect afterwards.
  const going = rewrite(app, { scale: 'unit' });
  await rewrite(app, { embedCones: false });
  assert.deepEqual([doc.pendingOutput.scale, doc.pendingOutput.embedCones], ['unit', false]);
  await going;
  assert.deepEqual([doc.current.output.scale, doc.current.output.embedCones, doc.pendingOutput], ['unit', false, undefined]); // prettier-ignore
  const { map } = doc.current;
  assert.equal(await mapInSolver(app), map);
  await rewrite(app, { embedCones: true });
  assert.equal(doc.current.map, map, 'it is written again, not made again');
  await map.dispose();
  const again = await mapInSolver(app);
  assert.deepEqual([again.isDisposed, doc.current.map === again, doc.current.output.scale], [false, true, 'unit']); // prettier-ignore
  // It fails: what was chosen is forgotten, what is there stays.
  const before = doc.current;
  const { solver } = doc.model;
  await again.dispose();
  await solver.dispose();
  await rewrite(app, { scale: 'fit' });
  assert.deepEqual([doc.current, doc.pendingOutput, doc.message.kind], [before, undefined, 'error']); // prettier-ignore
  assert.equal(await mapInSolver(app), undefined);
  assert.equal(await run(app), 'failed');
  assert.deepEqual([doc.isBusy, doc.current], [false, before]);
  await drawn();
  const buttons = $$('hgp-status-bar button').map((one) => textOf(one));
  assert.ok(buttons.length > 1);
  await click('#clear-cones');
  assert.equal(doc.prescription.cones.length, 0);
}); // prettier-ignore

test('a map that is made by itself names its stage, takes a minute at most, and what comes too late is let go of', { skip }, async (t) => {
  const { watchEdits } = await import('../../../web/src/actions/follow_edits.ts');
  const { moveCone } = await import('../../../web/src/actions/edit_cones.ts');
  const { stageName } = await import('../../../web/src/text/stages.ts');
  const app = await pageWith(t);
  const { doc, ui } = app;
  await runNow(app);
  const asked = [];
  const { solver } = doc.model;
  const parametrize = (options, call) => new Promise((give, fail) => asked.push({ call, give, fail })); // prettier-ignore
  const held = new Proxy(solver, { get: (of, key) => (key === 'parametrize' ? parametrize : typeof of[key] === 'function' ? of[key].bind(of) : of[key]) }); // prettier-ignore
  doc.state = { kind: 'open', model: { ...doc.model, solver: held } };
  const timers = [];
  const own = globalThis.setTimeout;
  t.mock.method(globalThis, 'setTimeout', (act, delay, ...all) => {
    if (delay >= 1000) timers.push({ act, delay });
    return own(act, delay, ...all);
  });
  t.after(watchEdits(app));
  ui.setAutomatic(true);
  const edit = async () => {
    const taken = new Set(doc.prescription.cones.map(({ vertex }) => vertex));
    const free = [...doc.model.surface.angle.keys()].find((v) => v > 7 && !taken.has(v));
    const { length } = asked;
    moveCone(app, 0, free, `edit ${length}`);
    await until(() => asked.length > length, 'a map is asked for', 15);
    return asked.at(-1);
  };
  const status = () => textOf(document.querySelector('#status'));
  const first = await edit();
  assert.equal(first.call.keepWorker, true);
  for (const stage of ['solve', 'verify']) {
    first.call.onProgress({ stage, fraction: 0.5 });
    assert.equal(doc.automatic.stage, stage);
    const { automatic } = doc;
    first.call.onProgress({ stage, fraction: 0.6 });
    assert.equal(doc.automatic, automatic, 'nothing is drawn anew');
    await drawn();
    assert.ok(status().endsWith(stageName(stage).toLowerCase()), status());
  }
  const [{ delay, act }] = timers.splice(0);
  assert.equal(delay, 60_000);
  act();
  await drawn();
  assert.deepEqual([doc.automatic, doc.live, first.call.signal.aborted], [undefined, undefined, true]); // prettier-ignore
  assert.deepEqual([doc.message.kind, doc.message.actions.length], ['note', 1]);
  assert.match(status(), /60 seconds/);
  first.call.onProgress({ stage: 'solve', fraction: 0.9 });
  act();
  assert.equal(doc.automatic, undefined, 'it was given up');
  const { solutions } = doc;
  const late = await solver.parametrize({});
  first.give(late);
  await until(() => late.isDisposed, 'the late map is let go of');
  assert.equal(doc.solutions, solutions);
  assert.equal(asked.length, 1, 'it is not begun again');

  // The next edit is another one, with the limit of Run if that is shorter.
  doc.solve = { ...doc.solve, timeLimit: 5 };
  const second = await edit();
  assert.equal(timers.splice(0)[0].delay, 5000);
  second.fail(errorOf('no-certificate'));
  await until(() => doc.automatic === undefined, 'the end');
  assert.deepEqual([doc.message.kind, doc.solutions, asked.length], ['error', solutions, 2]);
  // A newer edit takes the place of the one before.
  const third = await edit();
  const fourth = await edit();
  assert.deepEqual([third.call.signal.aborted, fourth.call.signal.aborted], [true, false]);
  third.call.onProgress({ stage: 'write', fraction: 0.5 });
  assert.notEqual(doc.automatic.stage, 'write');
  third.fail(errorOf('no-certificate'));
  await drawn();
  assert.notEqual(doc.automatic, undefined, 'the failure of the one before says nothing of this one');
  fourth.give(await solver.parametrize({}));
  await until(() => doc.automatic === undefined, 'the map');
  assert.notEqual(doc.solutions, solutions);
}); // prettier-ignore
