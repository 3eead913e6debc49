// Sentences, commands and clocks that need no browser; and the store that the page is drawn from.

import assert from 'node:assert/strict';
import test from 'node:test';
import { effect } from '@preact/signals-core';
import { deleteCone, setPrescription } from '../../../web/src/actions/edit_cones.ts';
import { notifyAtEnd } from '../../../web/src/actions/notify_at_end.ts';
import { isAutomatic } from '../../../web/src/actions/follow_edits.ts';
import { frame, lookAtCone } from '../../../web/src/actions/view.ts';
import { viewActions } from '../../../web/src/actions/view_actions.ts';
import { suggestCones } from '../../../web/src/actions/solve.ts';
import { isSettled } from '../../../web/src/actions/write_solution.ts';
import { Document } from '../../../web/src/model/document.ts';
import { suggestedK } from '../../../web/src/model/gauss_bonnet.ts';
import { locatedSurface } from '../../../web/src/services/geometry/placed_surface.ts';
import { plainFacts } from './plain_facts.mjs';
import { certificate, solutionOf, square } from './square_solution.mjs';
import { quoted } from '../../../web/src/text/cli_command.ts';
import { TimeLeft } from '../../../web/src/text/time_left.ts';
import { cubeMesh } from '../../support/meshes.mjs';

test('file names are quoted in the command line that the page copies', () => {
  assert.equal(quoted('a b.obj'), "'a b.obj'");
  assert.equal(quoted('a$(touch x)`id`.obj'), "'a$(touch x)`id`.obj'");
  assert.equal(quoted("it's.obj"), "'it'\\''s.obj'");
  assert.equal(quoted('-o.obj'), './-o.obj');
  assert.equal(quoted('--help x'), "'./--help x'");
});

test('remaining seconds are shown only after a stage ended as estimated, and never increase', () => {
  const clock = new TimeLeft();
  const at = (stage, fraction, whole, now) => clock.update(stage, fraction, whole, 0, now);
  assert.equal(at('field', 0.1, 0.05, 1), undefined);
  assert.equal(at('field', 0.5, 0.1, 5), undefined);
  assert.equal(at('field', 1, 0.2, 10), undefined);
  assert.equal(at('solve', 0, 0.2, 10), 40); // as promised: believed from here on
  const said = at('solve', 0.3, 0.5, 22);
  assert.ok(said <= 28, `${said}`);
  // It takes longer: nothing is promised any more, instead of more and more.
  assert.equal(at('solve', 0.3, 0.5, 60), undefined);
  const wrong = new TimeLeft();
  wrong.update('field', 0.5, 0.1, 0, 2);
  wrong.update('field', 1, 0.2, 0, 30);
  assert.equal(wrong.update('solve', 0, 0.2, 0, 30), undefined);
});

test('a stage is believed if it took at least a second and a half and was foreseen within three tenths', () => {
  for (const took of [1, 1.4, 1.5, 2, 10, 40]) {
    for (const error of [-0.5, -0.31, -0.3, -0.2, 0, 0.25, 0.3, 0.31, 0.6]) {
      const clock = new TimeLeft();
      const predicted = took + error * took;
      clock.update('field', 0, 0.01, 0, 0);
      clock.update('field', 0.5, 0.1, 0, predicted / 2);
      clock.update('field', 0.75, 0.1, 0, 0.9 * took); // said once, at the middle
      const isBelieved = took >= 1.5 && Math.abs(predicted - took) <= 0.3 * took;
      const left = clock.update('solve', 0, 0.25, 0, took);
      assert.equal(left, isBelieved ? 3 * took : undefined, `${took} seconds instead of ${predicted}`); // prettier-ignore
      assert.equal(clock.update('solve', 0, 0, 0, took), undefined, 'of nothing follows nothing');
      if (!isBelieved) continue;
      // Up to a second more than was said is borne, and no more is said to be left; beyond that nothing is said.
      const now = took + 0.5;
      const say = (end) => clock.update('solve', 0.2, now / end, 0, now);
      let end = 4 * took;
      for (const later of [0.5, 0.9, -1, 0.9, -0.2]) {
        const is = say(end + later);
        end = Math.min(end, end + later);
        assert.ok(Math.abs(is - (end - now)) < 1e-9, `${later}: ${is}`);
      }
      for (const later of [1.1, 0, -1]) assert.equal(say(end + later), undefined);
    }
  }
});

test('readers of a value are notified of changes; derived values follow', () => {
  const doc = new Document();
  const seen = [];
  effect(() => void seen.push(doc.stateName));
  doc.state = { kind: 'empty' };
  const controller = new AbortController();
  doc.job = { kind: 'load', title: '', stage: 'read', entered: [], detail: '', fraction: 0, begin: 0, controller }; // prettier-ignore
  doc.look = { ...doc.look, tiles: 9 }; // about something else
  doc.job = undefined;
  assert.deepEqual(seen, ['starting', 'empty', 'loading', 'empty']);
});

test('cones are not suggested while the solver runs, which is said', async () => {
  const said = [];
  let asked = 0;
  const doc = {
    job: { kind: 'run' },
    model: { solver: { suggestCones: () => (asked += 1) } },
    prescription: { q: 4, turnings: [], handles: [] },
    solve: { timeLimit: 9 },
    say: (text) => said.push(text),
  };
  await suggestCones({ doc });
  assert.equal(asked, 0);
  assert.equal(said.length, 1);
  assert.match(said[0], /locked while the solver runs/);
  assert.equal(doc.job.kind, 'run', 'it goes on');
});

function cubeSurface(n) {
  const { vertices, triangles } = cubeMesh(n);
  const positions = Float64Array.from(vertices.flat());
  const arrays = { positions, triangles: Uint32Array.from(triangles.flat()) };
  return locatedSurface(arrays, plainFacts({ vertices, triangles }));
}

test('a click on a flat side places a cone of the sign that is missing', () => {
  const surface = cubeSurface(8);
  surface.angle = surface.angle.slice();
  const flat =
    8 + surface.angle.subarray(8).findIndex((angle) => Math.abs(angle - 2 * Math.PI) < 1e-9);
  surface.angle[flat] += 0.02; // a saddle, by a degree
  assert.equal(suggestedK(surface, flat, 4, 8), 3);
  assert.equal(suggestedK(surface, flat, 4, -1), 5);
  assert.equal(suggestedK(surface, 0, 4, 8), 3); // a corner of the cube
  assert.equal(suggestedK(surface, 0, 6, 12), 5); // 270° are k = 4.5 for q = 6
});

test('each cone that is deleted is one step of undo, however quickly', () => {
  const doc = new Document();
  const app = { doc };
  const cones = [3, 5, 7].map((vertex) => ({ vertex, k: 3 }));
  setPrescription(app, { ...doc.prescription, cones }, 'import cones');
  deleteCone(app, 0);
  deleteCone(app, 0);
  const left = () => doc.prescription.cones.map(({ vertex }) => vertex);
  assert.deepEqual(left(), [7]);
  doc.history = doc.history.undo();
  assert.deepEqual(left(), [5, 7]);
  doc.history = doc.history.undo();
  assert.deepEqual(left(), [3, 5, 7]);
});

test('framing looks at the selected cone, whichever it is, and without one shows the whole model in both views', () => {
  const doc = new Document();
  const app = { doc, ui: { tab: 'map' } };
  const seen = [];
  const note = (name) => (vertex) => void seen.push(vertex === undefined ? name : `${name} ${vertex}`); // prettier-ignore
  app.views = { model: { lookAt: note('look at'), draw() {}, orbit: { fit: note('fit') } }, uv: { fit: note('fit the map') } }; // prettier-ignore
  const cones = [3, 5, 7].map((vertex) => ({ vertex, k: 3 }));
  setPrescription(app, { ...doc.prescription, cones }, 'import cones');
  cones.forEach(({ vertex }, i) => {
    for (const act of [frame, () => lookAtCone(app, i)]) {
      [doc.selected, app.ui.tab] = [i, 'map'];
      act(app);
      assert.deepEqual(seen.splice(0), [`look at ${vertex}`]);
      assert.deepEqual([doc.selected, app.ui.tab], [i, 'surface']);
    }
  });
  lookAtCone(app, 3);
  assert.deepEqual([seen, doc.selected], [[], 2], 'no such cone');
  doc.selected = -1;
  frame(app);
  assert.deepEqual(seen, ['fit', 'fit the map']);
});

test('choosing a tool says how it is used, choosing it again leads back to turning the model and says nothing', () => {
  for (const tool of ['place', 'edges']) {
    const doc = new Document();
    const app = { doc, ui: { tool: 'orbit' } };
    for (const before of ['orbit', 'place', 'edges'].filter((one) => one !== tool)) {
      [app.ui.tool, doc.message] = [before, undefined];
      viewActions[tool].run(app);
      assert.deepEqual([app.ui.tool, viewActions[tool].isOn(app)], [tool, true]);
      assert.ok(doc.message.text.length > 20);
      doc.message = undefined;
      viewActions[tool].run(app);
      assert.deepEqual([app.ui.tool, viewActions.orbit.isOn(app), doc.message], ['orbit', true, undefined]); // prettier-ignore
    }
  }
});

test('maps follow edits as the user chose; until then where the first run took less than two seconds', () => {
  for (const [firstRun, expected] of [
    [undefined, false],
    [0, true],
    [1999, true],
    [2000, false],
    [9000, false],
  ]) {
    // prettier-ignore
    for (const automatic of [undefined, true, false])
      assert.equal(isAutomatic({ doc: { firstRun }, ui: { automatic } }), automatic ?? expected, `${firstRun} ${automatic}`); // prettier-ignore
  }
});

test('a file that is to be kept is no longer asked for where any file of the download is that one', () => {
  const note = (code, name) => ({ code, words: { name }, numbers: {}, where: [] });
  const files = ['a.glb', 'b.bin', 'c.png'].map((name) => ({ name }));
  for (const { name } of files) {
    assert.equal(isSettled(note('write-keep-beside', name), files), true);
    assert.equal(isSettled(note('write-set-used', name), files), false);
  }
  assert.equal(isSettled(note('write-keep-beside', 'd.png'), files), false);
});

test('the end of a run is told in another tab: in the title until the page is looked at, by a notification from ten seconds on', async (t) => {

  const [told, listeners] = [[], {}];
  let clock = 5000;
  t.mock.method(performance, 'now', () => clock);
  class Notification {
    static permission = 'granted';
    constructor(title, { body }) {
      told.push([title, body]);
    }
  }
  const own = { document: { title: 'hgp', hidden: true }, Notification, addEventListener: (type, act) => (listeners[type] = act) }; // prettier-ignore
  for (const [name, value] of Object.entries(own)) {
    const before = Object.getOwnPropertyDescriptor(globalThis, name);
    Object.defineProperty(globalThis, name, { value, configurable: true, writable: true });
    t.after(() => (before ? Object.defineProperty(globalThis, name, before) : delete globalThis[name]));
  }
  const doc = new Document();
  t.after(notifyAtEnd({ doc }));
  const { document } = globalThis;
  /** Titles and notifications after a job of some seconds. */
  const after = async (seconds, kind = 'run', outcome = () => doc.say('the outcome')) => {
    listeners.focus();
    assert.equal(document.title, 'hgp');
    doc.message = undefined;
    const job = { kind, title: '', stage: 'read', entered: [], detail: '', fraction: 0, begin: clock, controller: new AbortController() }; // prettier-ignore
    doc.job = job;
    doc.job = { ...job, fraction: 0.5 };
    clock += 1000 * seconds;
    assert.equal(document.title, 'hgp', 'it is not over');
    doc.job = undefined;
    outcome();
    await new Promise((resolve) => setTimeout(resolve));
    return [document.title, told.splice(0)];
  };
  const title = '● the outcome · hgp';
  assert.deepEqual(await after(9.9), [title, []]);
  assert.deepEqual(await after(10), [title, [['hgp', 'the outcome']]]);
  assert.deepEqual(await after(60, 'run', () => undefined), ['● Done · hgp', [['hgp', 'Done']]]);
  assert.deepEqual(await after(60, 'load'), ['hgp', []], 'no run');
  doc.job = undefined;
  Notification.permission = 'default';
  assert.deepEqual(await after(60), [title, []]);
  delete globalThis.Notification;
  assert.deepEqual(await after(60), [title, []]);
  document.hidden = false;
  assert.deepEqual(await after(60), ['hgp', []], 'it is seen');
  document.hidden = true;
  const passing = solutionOf(square());
  const failing = { ...passing, result: { ...passing.result, certificate: { ...certificate, certified: false, flipped: 1 } } }; // prettier-ignore
  for (const [current, text] of [[failing, 'the outcome'], [passing, 'Certified']]) { // prettier-ignore
    Object.defineProperty(doc, 'current', { value: current, configurable: true });
    assert.equal((await after(1))[0], `● ${text} · hgp`);
  }
}); // prettier-ignore
