// Answers of solver and geometry that come when their model is not the open one any more: they change nothing of the one that is.

import assert from 'node:assert/strict';
import test from 'node:test';
import { blocks } from '../../support/blocks.mjs';
import { cubeMesh, toObj } from '../../support/meshes.mjs';
import { $, drawn, openFiles, openPage, skip, until } from './whole_page.mjs';

const load = (name) => import(`../../../web/src/actions/${name}.ts`);
const { perform, whyNotOf } = await load('registry');
const { importCones, setPrescription } = await load('edit_cones');
const { setConeStep } = await load('cone_slider');
const { followCreases } = await load('features');

/** What of a document an action may change. */
const stateOf = ({ doc, ui }) => ({
  ...{ state: doc.state, history: doc.history, solutions: doc.solutions, meshes: doc.meshes },
  ...{ parts: doc.parts, summaries: doc.summaries, thumbnails: doc.thumbnails },
  ...{ features: doc.features, selected: doc.selected, quads: doc.quads, field: doc.field },
  ...{ validation: doc.validation, message: doc.message, isUnsaved: doc.isUnsaved },
  ...{ hasUserCones: doc.hasUserCones, objection: doc.objection, coneStep: doc.coneStep },
  ...{ dialog: ui.dialog, isBusy: doc.isBusy },
});

/** Lets answers of solver and geometry wait until they are given; an aborted call rejects at once, as ever. */
function holdAnswers(app) {
  const own = new WeakMap();
  const answers = { pass: Infinity, waiting: [] };
  const later = (made, signal) => {
    made.catch(() => undefined); // it is said when the answer is given
    return new Promise((give, reject) => {
      answers.waiting.push(give);
      signal?.addEventListener('abort', () => reject(signal.reason));
    }).then(() => made);
  };
  const hold = (of) => {
    const stand = new Proxy(of, {
      get: (_, key) => {
        const member = of[key];
        if (typeof member !== 'function') return member;
        return (...all) => {
          const made = member.apply(of, all.map((one) => own.get(one) ?? one)); // prettier-ignore
          if (!(made instanceof Promise)) return made;
          const answer = made.then((one) => (['load', 'parametrize'].includes(key) ? hold(one) : one)); // prettier-ignore
          return answers.pass-- > 0 ? answer : later(answer, all.at(-1)?.signal);
        };
      },
    });
    own.set(stand, of);
    return stand;
  };
  [app.client, app.geometry] = [hold(app.client), hold(app.geometry)];
  return answers;
}

const act = (id) => (app) => (assert.equal(whyNotOf(app, id), '', id), perform(app, id));
const corners = [...Array(8).keys()].map((vertex) => ({ vertex, k: 3 }));
const one = [{ vertex: 0, k: 3 }];
/** All that asks solver or geometry for something about the open model, and what is there before. */
const asking = {
  run: [act('run'), { cones: corners }],
  suggest: [act('suggest')],
  handles: [act('handles'), { mesh: blocks(['###', '# #', '###'], { n: 1 }) }],
  creases: [(app) => followCreases(app, true)],
  'fewer cones': [(app) => setConeStep(app, 1)],
  'import of a file': [(app) => importCones(app, 'a.cones.json', JSON.stringify({ q: 4, cones: one }))],
  balance: [act('balance'), { cones: one }],
  mirror: [act('mirror-cone'), { cones: one }],
}; // prettier-ignore

test('what was asked and is answered when another file is open changes nothing, at whatever step it waits', { skip }, async (t) => {
  const app = await openPage(t);
  const { doc, ui } = app;
  ui.setAutomatic(false);
  let told = 0;
  const orbit = { toText: () => '', fromText() {}, fit() {} };
  const views = { model: { orbit, draw() {}, lookAt() {}, canvas: $('#view'), setHandles: () => (told += 1), highlight() {} }, uv: { fit() {}, highlight() {} } }; // prettier-ignore
  app.views = views;
  const answers = holdAnswers(app);
  for (const [name, [ask, { mesh = cubeMesh(1), cones } = {}]] of Object.entries(asking)) {
    for (let steps = 0; ; steps++) {
      await openFiles(app, { 'first.obj': toObj(mesh) });
      if (cones) setPrescription(app, { ...doc.prescription, cones }, 'place');
      [doc.selected, ui.handlesShown] = [0, false];
      answers.pass = steps;
      let isOver = false;
      const end = () => (isOver = true);
      const ended = Promise.resolve(ask(app)).then(end, end);
      await until(() => answers.waiting.length > 0 || isOver);
      answers.pass = Infinity;
      if (isOver) {
        assert.ok(steps > 0, name);
        break;
      }
      await openFiles(app, { 'other.obj': toObj(cubeMesh(1)) });
      await drawn();
      const [before, tellings] = [stateOf(app), told];
      assert.equal(doc.model.main, 'other.obj');
      answers.waiting.splice(0).forEach((give) => give());
      await ended;
      await until(() => !doc.isBusy);
      for (const [key, value] of Object.entries(stateOf(app))) assert.equal(value, before[key], `${name}, ${steps} answers: ${key}`); // prettier-ignore
      assert.equal(told, tellings, name);
    }
  }
}); // prettier-ignore
