// Laws of actions that ask for something first: a file, cones of the solver, another reading of the mesh. Whatever is answered, and
// however often it is asked, the last choice counts, and who gives up has what was there before.

import assert from 'node:assert/strict';
import test from 'node:test';
import { setConeStep, knownCount } from '../../../web/src/actions/cone_slider.ts';
import { balancedStep, coneSteps, fewStep, ways } from '../../../web/src/actions/cone_steps.ts';
import { whyNoQuads } from '../../../web/src/actions/quads.ts';
import { choosePattern } from '../../../web/src/actions/view.ts';
import { Document } from '../../../web/src/model/document.ts';
import { emptyPrescription } from '../../../web/src/model/prescription.ts';
import { replace } from '../../support/replaced.mjs';
import { cubeSurface } from './cube_view.mjs';
import { certificate, solutionOf, square } from './square_solution.mjs';

const turn = () => new Promise((resolve) => setImmediate(resolve));
const closed = [{ component: 0, eulerCharacteristic: 2, boundaryLoops: [] }];

/** A cube whose solver answers when it is told to. */
function opened() {
  const doc = new Document();
  const asked = [];
  const suggestCones = (options, { signal }) =>
    new Promise((resolve, reject) => {
      const cones = Array.from({ length: 2 + ways.indexOf(options.conesFor) }, (_, vertex) => ({ vertex, k: 3 })); // prettier-ignore
      asked.push({ options, answer: () => resolve({ q: options.q, cones }) });
      signal.addEventListener('abort', () => reject(signal.reason));
    });
  const info = { usable: true, genus: 0, components: closed, file: { sha256: 'x' }, surface: 0, surfaces: [{}], defects: [] }; // prettier-ignore
  const open = () => {
    doc.state = { kind: 'open', model: { main: 'cube.obj', files: new Map(), info, surface: cubeSurface(), loaded: doc.settings, solver: { suggestCones } } }; // prettier-ignore
    doc.begin(emptyPrescription(4, 0, 0));
  };
  open();
  return { app: { doc, client: { ready: async () => undefined } }, doc, asked, open };
}

test('the slider takes the cones of the step that was chosen last, and asks once for each step of a symmetry', async () => {
  assert.deepEqual([ways[fewStep], ways[balancedStep], coneSteps], ['few', 'balanced', ways.length]); // prettier-ignore
  const { app, doc, asked, open } = opened();
  const count = () => doc.prescription.cones.length;
  const steps = async (...all) => {
    const before = asked.length;
    const ends = all.map((step) => setConeStep(app, step));
    for (let given = before; ; given++) {
      await turn();
      if (given === asked.length) break;
      asked[given].answer();
    }
    await Promise.all(ends);
    assert.equal(doc.isBusy, false);
    assert.deepEqual([doc.coneStep, count()], [all.at(-1), 2 + all.at(-1)], `${all}`);
    return asked.slice(before).map(({ options }) => [options.q, ways.indexOf(options.conesFor)]);
  };
  for (const step of ways.keys()) assert.equal(knownCount(app, step), undefined);
  assert.deepEqual(await steps(1), [[4, 1]]);
  assert.deepEqual(await steps(3, 0, 4), [[4, 3], [4, 4]]); // prettier-ignore
  const { history } = doc;
  assert.deepEqual(await steps(1), [], 'it is known');
  assert.notEqual(doc.history, history, 'and is an edit');
  assert.deepEqual(await steps(2, 2, 2), [[4, 2]]); // prettier-ignore
  assert.deepEqual([...ways.keys()].map((step) => knownCount(app, step)), [undefined, 3, 4, 5, 6]); // prettier-ignore
  doc.begin(emptyPrescription(6, 0, 0));
  assert.deepEqual(await steps(1), [[6, 1]]);
  open();
  assert.deepEqual(await steps(1), [[4, 1]], 'another surface');
  // Whoever cancels has the cones that were there, and may ask again.
  const kept = doc.prescription;
  const end = setConeStep(app, 3);
  await turn();
  doc.job.controller.abort(new DOMException('enough', 'AbortError'));
  await end;
  assert.equal(doc.prescription, kept);
  assert.deepEqual(await steps(3), [[4, 3]]);
  // Without a model there is nothing to ask.
  doc.state = { kind: 'empty' };
  await setConeStep(app, 0);
  assert.equal(asked.at(-1).options.conesFor, ways[3]);
});

test('cones of a surface that is not there any more are placed on no other one', async () => {
  const { app, doc, asked, open } = opened();
  const end = setConeStep(app, 1);
  await turn();
  open();
  const kept = doc.prescription;
  asked[0].answer();
  await end;
  assert.equal(doc.prescription, kept);
});

test('a pattern of an image is asked for; without one, or with one that cannot be read, the pattern stays, and the list shows it again', async (t) => {
  const made = [];
  let chosen;
  replace(t, 'document', {
    createElement: (name) => {
      const input = Object.assign(new EventTarget(), {
        files: chosen ? [chosen] : [],
        click: () => queueMicrotask(() => input.dispatchEvent(new Event(chosen ? 'change' : 'cancel'))), // prettier-ignore
      });
      made.push([name, input]);
      return input;
    },
  });
  const image = { width: 4, height: 2 };
  const readers = [];
  replace(t, 'createImageBitmap', async (file, options) => {
    readers.push([file, options]);
    if (file.name.endsWith('png')) return image;
    throw new Error('no image');
  });
  const doc = new Document();
  const choose = async (pattern, file) => {
    chosen = file && new File(['x'], file);
    const { look } = doc;
    doc.message = undefined;
    await choosePattern({ doc }, pattern);
    assert.notEqual(doc.look, look, 'who shows the look is told');
    return [doc.look.pattern, doc.look.image, doc.message?.kind];
  };
  assert.deepEqual(await choose('grid'), ['grid', undefined, undefined]);
  assert.equal(made.length, 0);
  assert.deepEqual(await choose('image'), ['grid', undefined, undefined]);
  assert.deepEqual(await choose('image', 'a.txt'), ['grid', undefined, 'error']);
  assert.deepEqual(await choose('image', 'a.png'), ['image', image, undefined]);
  for (const [name, { type, accept }] of made) assert.deepEqual([name, type, accept.includes('image/png')], ['input', 'file', true]); // prettier-ignore
  assert.deepEqual(readers.map(([{ name }, { imageOrientation }]) => [name, imageOrientation]), [['a.txt', 'flipY'], ['a.png', 'flipY']]); // prettier-ignore
});

test('quads need a certified map of order four in the scale as solved, and each of these that is missing is named', () => {
  const good = { ...solutionOf(square()), output: { scale: 'solved' } };
  const uncertified = { ...good, result: { ...good.result, certificate: { ...certificate, certified: false, flipped: 1 } } }; // prettier-ignore
  const why = (current, q = 4) => whyNoQuads({ doc: { current, prescription: { q } } });
  assert.equal(why(good), '');
  const reasons = [why(undefined), why(good, 3), why(good, 8), why(uncertified), why({ ...good, output: { scale: 'unit' } })]; // prettier-ignore
  assert.equal(new Set(reasons).size, 5);
  for (const reason of reasons) assert.ok(reason.length > 5);
});
