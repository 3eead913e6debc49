// Our interior-point method against SCS, an outside solver of another kind (splitting, first order):
// the same random programs must have the same minimisers.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { fileURLToPath } from 'node:url';

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../../..');
const program =
  process.env.HGP_SOCP_PROGRAMS ?? path.join(root, 'build/native-release/bin/socp_programs');
const isInstalled = existsSync(path.join(root, 'node_modules/scs-solver'));

/** Compressed columns of a dense matrix given by rows, as SCS wants them. */
function columns(rows, width, wanted = () => true) {
  const x = [];
  const i = [];
  const p = [0];
  for (let column = 0; column < width; column++) {
    rows.forEach((row, index) => {
      if (row[column] === 0 || !wanted(index, column)) return;
      x.push(row[column]);
      i.push(index);
    });
    p.push(x.length);
  }
  return { x, i, p };
}

/** minimise ½ xᵀHx + cᵀx with F x − h in a product of cones Q³. */
function solveWithScs(SCS, { H, c, F, h }) {
  const A = columns(
    F.map((row) => row.map((value) => -value)),
    c.length,
  );
  const P = columns(H, c.length, (row, column) => row <= column);
  const data = { m: h.length, n: c.length, b: h.map((value) => -value), c };
  Object.assign(data, { A_x: A.x, A_i: A.i, A_p: A.p, P_x: P.x, P_i: P.i, P_p: P.p });
  const cone = { z: 0, l: 0, q: Array(h.length / 3).fill(3), qsize: h.length / 3 };
  const settings = new SCS.ScsSettings();
  SCS.setDefaultSettings(settings);
  Object.assign(settings, { epsAbs: 1e-8, epsRel: 1e-8, maxIters: 20_000, verbose: 0 });
  return SCS.solve(data, cone, settings);
}

test('minimisers agree with those of SCS', { skip: !isInstalled && 'no scs-solver' }, async () => {
  const { default: createSCS } = await import('scs-solver');
  const SCS = await createSCS();
  const [command, args] = program.endsWith('.js')
    ? [process.execPath, ['--no-experimental-fetch', program]]
    : [program, []];
  const lines = execFileSync(command, args, { encoding: 'utf8', maxBuffer: 1 << 28 });
  const problems = lines
    .split('\n')
    .filter(Boolean)
    .map((line) => JSON.parse(line));
  let compared = 0;
  let refused = 0;
  for (const problem of problems) {
    const theirs = solveWithScs(SCS, problem);
    const isInfeasible = /infeasible/i.test(String(theirs.status));
    assert.equal(problem.status === 'infeasible', isInfeasible, `program ${problem.seed}`);
    if (isInfeasible) {
      refused += 1;
      continue;
    }
    assert.match(problem.status, /^(optimal|almost)$/, `program ${problem.seed}`);
    const size = Math.hypot(...problem.x);
    const distance = Math.hypot(...problem.x.map((value, i) => value - theirs.x[i]));
    assert.ok(distance <= 1e-5 * (1 + size), `program ${problem.seed}: ${distance} of ${size}`);
    compared += 1;
  }
  assert.ok(compared >= 20, `${compared} compared`);
  assert.ok(refused >= 3, `${refused} refused`);
});
