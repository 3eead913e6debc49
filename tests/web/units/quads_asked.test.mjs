// What is offered where no quads can be made: a number of cells that works, if there is one.

import assert from 'node:assert/strict';
import test from 'node:test';
import { previewQuads } from '../../../web/src/actions/quads.ts';
import { Document } from '../../../web/src/model/document.ts';
import { emptyPrescription } from '../../../web/src/model/prescription.ts';
import { cubeSurface } from './cube_view.mjs';
import { solutionOf, square } from './square_solution.mjs';

/** A page with a certified map whose grid, asked for anew, is as `grids` say, by component; undefined: none. */
function opened(grids) {
  const doc = new Document();
  const disposed = [];
  const asked = [];
  const parametrize = async (options) => {
    asked.push(options.grid);
    if (asked.length > 1) throw new Error('scripted');
    const report = { options: {}, components: grids.map((grid) => ({ grid })) };
    const { certificate } = solutionOf(square()).result;
    return { report, certificate: { ...certificate, integerSeams: 0, seamEdges: 1 }, cones: { cones: [1] }, dispose: async () => disposed.push('map') }; // prettier-ignore
  };
  const info = { usable: true, genus: 0, components: [], file: { sha256: 'x', name: 'a.obj' }, surface: 0, surfaces: [{}] }; // prettier-ignore
  doc.state = { kind: 'open', model: { main: 'a.obj', files: new Map(), info, surface: cubeSurface(), solver: { parametrize }, loaded: doc.settings } }; // prettier-ignore
  doc.begin(emptyPrescription(4, 0, 0));
  doc.solve = { ...doc.solve, grid: { isOn: false, mode: 'tile' } };
  const about = { ...doc.solve, settings: doc.settings, output: { scale: 'solved' }, prescription: doc.prescription }; // prettier-ignore
  const solution = solutionOf(square());
  solution.result.report = { options: { rounds: 12 }, components: [{}] };
  doc.solutions = [{ ...solution, ...about, map: { isDisposed: false } }];
  const app = { doc, ui: {}, client: { ready: async () => undefined }, geometry: {} };
  return { app, doc, asked, disposed };
}
const grid = (workingCells) => ({ aligned: false, cells: 20, spacing: 1, workingCells });

test('where the grid is too coarse, a number of cells that works is offered, and none where none is known', async () => {
  const { warn } = console;
  console.warn = () => undefined;
  try {
    for (const [grids, cells] of [
      [[grid(50)], 50],
      [[grid(0)], 0],
      [[grid(50), grid(0)], 0],
      [[undefined], 0],
    ]) {
      // prettier-ignore
      const { app, doc, asked, disposed } = opened(grids);
      assert.equal(await previewQuads(app), undefined);
      assert.equal(asked[0].mode, 'quad');
      assert.deepEqual([disposed, doc.isBusy, doc.message.kind], [['map'], false, 'error']);
      const actions = doc.message.actions;
      assert.equal(actions.length, cells > 0 ? 1 : 0);
      if (cells === 0) continue;
      assert.match(actions[0].label, new RegExp(`\\b${cells}\\b`));
      await actions[0].run();
      assert.equal(doc.solve.grid.isOn, true);
      assert.equal(doc.solve.grid.cells, cells);
      assert.equal(asked[1]?.cells, cells, 'and run with it');
    }
  } finally {
    console.warn = warn;
  }
});
