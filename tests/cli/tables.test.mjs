// Committed tables are those of this program: three cheap rows of each are made again.
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { rowsOf } from '../../bench/quads/quads.mjs';
import { hgp, inFolder, shared } from '../support/program.mjs';

const { at, good } = inFolder('tables');
const root = path.join(import.meta.dirname, '../..');
const table = (name) => readFileSync(path.join(root, 'bench', name), 'utf8').split('\n');
const cellsOf = (row) => row.split('|').slice(1, -1).map((cell) => cell.trim()); // prettier-ignore

/** Numbers may differ in the last digit, as processors may. */
function assertSame(made, committed, what) {
  assert.equal(made.length, committed.length, what);
  made.forEach((cell, i) => {
    const [a, b] = [cell, committed[i]].map((x) => x.split(' / '));
    assert.equal(a.length, b.length, what);
    a.forEach((x, k) => {
      if (Number.isNaN(Number(x))) return assert.equal(x, b[k], what);
      const unit = 10 ** -(x.split('.')[1] ?? '').length;
      const bound = 1.5 * unit + 0.02 * Math.abs(Number(x));
      assert.ok(Math.abs(x - b[k]) <= bound, `${what}, column ${i}: now ${x}, committed ${b[k]}`);
    });
  });
}

const absent = existsSync(shared) ? false : `${shared} is absent`;

test('three models of bench/QUADS.md have the quads of its rows', { skip: absent }, () => {
  for (const model of [
    'BFF/hemisphere.obj',
    'odedstein-meshes/spot_low_resolution.obj',
    'gp-js/double-torus.obj',
  ])
    // prettier-ignore
    for (const row of rowsOf(hgp, shared, model)) {
      const made = cellsOf(row);
      const found = table('QUADS.md')
        .map(cellsOf)
        .find((c) => c[0] === made[0] && c[1] === made[1]);
      assert.ok(found, `no row of ${made[0]}, ${made[1]}`);
      assertSame(made.slice(2, 9), found.slice(2, 9), `${made[0]}, ${made[1]}`);
    }
});

test('three meshes of bench/CORPUS.md have the maps of its rows', { skip: absent }, () => {
  const all = table('CORPUS.md');
  const rows = all.slice(all.indexOf('## q = 4'), all.indexOf('## q = 2')).map(cellsOf);
  for (const name of [
    'OptCuts/torus_with_holes.obj',
    'BFF/hemisphere.obj',
    'gp-js/double-torus.obj',
  ]) {
    good('param', path.join(shared, name), '-o', at('out.obj'), '-f', '-q', '--json', at('r.json'));
    const report = JSON.parse(readFileSync(at('r.json'), 'utf8'));
    const [c] = report.certificate.components;
    const [part] = report.components;
    const d = c.distortion;
    const made = [c.vertices, c.triangles, c.genus, c.boundaryLoops, part.cones, part.rounds.length]
      .map(String)
      .concat(
        report.certified ? 'certified' : 'not certified',
        [d.meanMu, d.p95Mu, d.maxMu].map((x) => x.toFixed(4)),
        d.rmsLogArea.toFixed(2),
      );
    const found = rows.find((r) => r[0] === name);
    assert.ok(found, `no row of ${name}`);
    assertSame(made, found.slice(1, 12), name);
  }
});
