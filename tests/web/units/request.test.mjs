// What a run is asked with has one form, for Run, for making a map once more, and for its quads.

import assert from 'node:assert/strict';
import test from 'node:test';
import { Document } from '../../../web/src/model/document.ts';
import { emptyPrescription, toCones } from '../../../web/src/model/prescription.ts';
import { cliCommand } from '../../../web/src/text/cli_command.ts';
import { optionsAgain, runOptions } from '../../../web/src/model/request.ts';

const prescription = { ...emptyPrescription(4, 0, 0), cones: [{ vertex: 7, k: 3 }] };
const features = { hasCreases: false, hasRims: true, edges: [[0, 1]], rims: [] };
const field = { name: 'cube.rosy', text: '4' };
const settings = { rounds: 9, improve: 0, scale: 'unit', keepGoing: true };
const common = { maxRounds: 9, improve: 0, scale: 'unit', keepGoing: true };

test('cones, features or a choice of the solver: a run is asked with one of them', () => {
  const { cones, ...rest } = runOptions({ prescription, ...settings });
  assert.deepEqual(rest, common);
  assert.deepEqual(cones.cones, [{ vertex: 7, k: 3, position: undefined }]);
  assert.deepEqual(runOptions({ prescription, isAutomatic: true, ...settings }), { q: 4, ...common }); // prettier-ignore
  const lines = [{ vertices: [0, 1] }];
  assert.deepEqual(runOptions({ prescription, features, isAutomatic: true, ...settings }), {
    ...{ q: 4, features: { rims: true, lines } },
    ...common,
  });
  const symmetric = { ...features, isSymmetric: true };
  assert.deepEqual(runOptions({ prescription, features: symmetric, ...settings }), {
    ...{ q: 4, symmetric: 'auto', features: { rims: true, lines } },
    ...common,
  });
  const alone = { ...symmetric, hasRims: false, edges: [] };
  assert.deepEqual(runOptions({ prescription, features: alone, ...settings }), {
    ...{ q: 4, symmetric: 'auto' },
    ...common,
  });
  const kept = runOptions({ prescription, features: { ...symmetric, keepsCones: true }, isAutomatic: true, ...settings }); // prettier-ignore
  assert.deepEqual(kept, {
    ...{ cones: toCones(prescription), symmetric: 'auto', features: { rims: true, lines } },
    ...common,
  });
  const framed = runOptions({ prescription, field, ...settings });
  assert.deepEqual([framed.field, framed.frames], [field, 'file']);
  assert.equal(framed.cones.cones.length, 1);
});

test('a map is made once more with its own rounds and field, whatever the settings are now', () => {
  const report = { options: { rounds: 31 }, components: [{}, {}] };
  const solution = { prescription, improve: -1, result: { report } };
  const again = (more) => optionsAgain({ ...solution, ...more }, 'fit');
  const { maxRounds, improve, scale, keepGoing } = again({});
  assert.deepEqual([maxRounds, improve, scale, keepGoing], [31, -1, 'fit', true]);
  assert.equal(again({ features }).cones, undefined);
  assert.equal(again({ features: { ...features, keepsCones: true } }).cones.cones.length, 1);
  assert.equal(again({ field }).frames, 'file');
});

test('features are asked for where lines can follow them: with q = 4, and not beside the frames of a file', () => {
  const doc = new Document();
  doc.features = features;
  assert.equal(doc.askedFeatures, features);
  doc.solve = { ...doc.solve, frames: 'file' }; // without a file
  assert.equal(doc.askedFeatures, features);
  doc.takeField(field);
  assert.deepEqual([doc.askedFeatures, doc.askedField], [undefined, field]);
  doc.takeField();
  doc.begin(emptyPrescription(6, 0, 0));
  assert.equal(doc.askedFeatures, undefined);
});

test('along features a run chooses the cones, unless there are some and they are kept', () => {
  const doc = new Document();
  const placed = (cones) => doc.begin({ ...emptyPrescription(4, 0, 0), cones });
  const choosing = () => [[], prescription.cones].map((cones) => (placed(cones), doc.choosesCones));
  assert.deepEqual(choosing(), [true, false]);
  doc.features = features;
  assert.deepEqual(choosing(), [true, true]);
  doc.features = { ...features, keepsCones: true };
  assert.deepEqual(choosing(), [true, false], 'where there is none, none is kept');
  doc.takeField(field);
  doc.solve = { ...doc.solve, frames: 'file' };
  assert.deepEqual(choosing(), [false, false], 'frames of a file have cones of their own');
});

test('the command of a run along features has the cones only if they are kept', () => {
  const model = { main: 'a.obj', loaded: { fix: {} }, info: { surface: 0, surfaces: [{}], file: { format: 'obj' } } }; // prettier-ignore
  const output = { embedCones: false, isUncertified: false };
  const command = (more, cones = prescription) =>
    cliCommand(model, cones, { rounds: 9, scale: 'solved', gridMode: 'tile', features: { ...features, ...more } }, output); // prettier-ignore
  assert.match(command(), /^hgp param a\.obj --rims --features a\.features\.json --strict/);
  assert.match(command({ keepsCones: true }), /^hgp param a\.obj --rims --features a\.features\.json --q 4 --cone 7:3 --strict/); // prettier-ignore
  const cones = Array.from({ length: 41 }, (_, vertex) => ({ vertex, k: 3 }));
  assert.match(command({ keepsCones: true }, { ...prescription, cones }), /a\.features\.json --q 4 --cones a\.cones\.json /); // prettier-ignore
});
