// Cones of a symmetric map on the page: they are placed, moved, changed and deleted in pairs, and the map has them.

import assert from 'node:assert/strict';
import test from 'node:test';
import { toObj } from '../../support/meshes.mjs';
import { arch } from '../shapes.mjs';
import { $, choose, openFiles, openPage, runNow, skip, textOf, until } from './whole_page.mjs';

const load = (name) => import(`../../../web/src/actions/${name}.ts`);
const { deleteCone, moveCone, placeOrSelect, setK } = await load('edit_cones');
const { mirrorCone } = await load('mirror_cone');
const { oppositeIn, watchOpposite } = await load('opposite');
const { undo } = await load('undo');

const n = 6;
const mesh = arch(n);
const vertexAt = (i, j) => j * (2 * n + 1) + i + n;
const image = (v) => vertexAt(-((v % (2 * n + 1)) - n), Math.floor(v / (2 * n + 1)));

test('cones of a symmetric map come, go and change in pairs', { skip }, async (t) => {
  const app = await openPage(t);
  await openFiles(app, { 'arch.obj': toObj(mesh) });
  t.after(watchOpposite(app));
  const { doc, geometry, ui } = app;
  ui.setAutomatic(false);
  const cones = () => doc.prescription.cones.map(({ vertex, k }) => [vertex, k]);
  // Alone, where the map is not to be symmetric.
  const [first, second] = [vertexAt(3, 2), vertexAt(2, 4)];
  placeOrSelect(app, first);
  assert.equal(cones().length, 1);
  deleteCone(app, 0);
  const called = t.mock.method(geometry, 'call');
  await choose('#symmetric', true);
  assert.match(textOf($('#panel-solve')), /Cones are placed and moved in pairs\./);
  await until(() => oppositeIn(app)(first) >= 0);
  mesh.vertices.forEach((_, v) => assert.equal(oppositeIn(app)(v), image(v)));
  await choose('#symmetric', false);
  assert.equal(oppositeIn(app)(first), -1);
  await choose('#symmetric', true);
  const calls = called.mock.calls.filter(({ arguments: [method] }) => method === 'images');
  assert.equal(calls.length, 1, 'once for a surface');

  placeOrSelect(app, first);
  const [[, k]] = cones();
  assert.deepEqual(cones(), [[first, k], [image(first), k]]); // prettier-ignore
  assert.equal(doc.selected, 0, 'the one that was clicked');
  setK(app, 1, 5);
  assert.deepEqual(cones(), [[first, 5], [image(first), 5]]); // prettier-ignore
  moveCone(app, 1, image(second), 'a drag');
  assert.deepEqual(cones(), [[second, 5], [image(second), 5]]); // prettier-ignore
  for (const j of [1, 3]) moveCone(app, 0, vertexAt(0, j), 'a drag');
  assert.deepEqual(cones(), [[second, 5], [image(second), 5]], 'they do not meet'); // prettier-ignore
  await runNow(app);
  assert.equal(doc.stateName, 'certified');
  assert.deepEqual(cones(), [[second, 5], [image(second), 5]]); // prettier-ignore
  assert.equal(doc.current.features.keepsCones, true);
  // In the plane a cone is its own image, and stays in it.
  const middle = vertexAt(0, 3);
  placeOrSelect(app, middle);
  assert.deepEqual(cones()[2][0], middle);
  assert.equal(cones().length, 3);
  moveCone(app, 2, vertexAt(1, 3), 'another');
  assert.equal(cones()[2][0], middle);
  moveCone(app, 2, vertexAt(0, 2), 'another');
  assert.equal(cones()[2][0], vertexAt(0, 2));
  deleteCone(app, 0);
  assert.deepEqual(cones(), [[vertexAt(0, 2), cones()[0][1]]]);
  await undo(app);
  assert.equal(cones().length, 3);
  // The button finds the partner in the same plane.
  doc.selected = 1;
  await mirrorCone(app);
  assert.deepEqual([doc.selected, doc.message.text], [0, 'The cone opposite to it is there already.']); // prettier-ignore
  assert.ok(!called.mock.calls.some(({ arguments: [method] }) => method === 'opposite'));
});

test('each of a pair takes half of what is left, as far as that is whole', { skip }, async (t) => {
  const app = await openPage(t);
  await openFiles(app, { 'arch.obj': toObj(mesh) });
  t.after(watchOpposite(app));
  const { doc } = app;
  await choose('#symmetric', true);
  await until(() => oppositeIn(app)(vertexAt(1, 2)) >= 0);
  const first = vertexAt(3, 3);
  const placedWith = (l) => {
    doc.begin({ ...doc.prescription, cones: [], turnings: [l] });
    const { left } = doc.budget.components[0];
    placeOrSelect(app, first);
    return [left, doc.prescription.cones.map(({ k }) => k)];
  };
  assert.deepEqual(placedWith(2), [2, [3, 3]]);
  assert.deepEqual(placedWith(6), [-2, [5, 5]]);
  assert.deepEqual(placedWith(8)[1].map((k) => k >= 5), [true, true]); // prettier-ignore
});
