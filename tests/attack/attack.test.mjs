// Verdicts against exact arithmetic: maps of strangers and maps of our own, of both number types, with
// areas that span up to 2^120, tampered with; every answer of `hgp verify` and every map that
// `hgp param` calls certified is decided once more by check.mjs.
//
// HGP_FULL=1 runs the long form. HGP_ATTACK=FIRST..LAST runs the cases of these numbers only and keeps
// their files.

import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import test, { after } from 'node:test';

import { readGlb, readObj, writeGlb, writeObj } from './files.mjs';
import { checkMap } from './check.mjs';
import { familyNames, makeMap } from './maps.mjs';
import { Random } from './random.mjs';
import { areaOf, surfaceOf } from './surface.mjs';
import { tamperNames, tampers } from './tamper.mjs';

const hgp =
  process.env.HGP_BIN ?? path.join(import.meta.dirname, '../../build/native-release/bin/hgp');
const isFull = process.env.HGP_FULL === '1';
const folder = mkdtempSync(path.join(os.tmpdir(), 'hgp-attack-'));
after(() => {
  if (!process.env.HGP_ATTACK) rmSync(folder, { recursive: true });
  else console.log(`files are in ${folder}`);
});

function run(...args) {
  return new Promise((resolve, reject) => {
    const options = { maxBuffer: 1 << 28, timeout: 120_000 };
    execFile(hgp, args, options, (error, stdout, stderr) => {
      const code = error ? error.code : 0;
      if (Number.isInteger(code)) resolve({ code, stdout, stderr });
      else reject(new Error(`hgp ${args.join(' ')}: ${error.signal ?? code}`));
    });
  });
}

/** Calls `act(n)` for first … last, two at a time. */
async function forCases(count, act) {
  const [first, last] = process.env.HGP_ATTACK?.split('..').map(Number) ?? [0, count - 1];
  let next = first;
  const work = async () => {
    while (next <= last) await act(next++);
  };
  await Promise.all([work(), work()]);
}

const conesFile = (q, cones) =>
  JSON.stringify({
    ...{ format: 'hgp-cones', version: 1, q },
    cones,
  });

/** The same map as a file has it; cones by the file's own vertices. */
function throughFile(map, at) {
  const isGlb = map.precision === 'float32';
  const name = at(isGlb ? 'map.glb' : 'map.obj');
  writeFileSync(name, isGlb ? writeGlb(map) : writeObj(map));
  const read = isGlb ? readGlb(readFileSync(name)) : readObj(readFileSync(name, 'utf8'));
  const vertexIn = (v) => {
    if (!isGlb) return v;
    const p = map.positions[v].map(Math.fround);
    return read.positions.findIndex((r) => r.every((x, n) => x === p[n]));
  };
  const cones = map.cones && [...map.cones].map(([v, k]) => ({ vertex: vertexIn(v), k }));
  return { name, stored: { ...read, q: map.q, cones } };
}

/** What the exact check says of the triangles in a file. */
function decide(stored) {
  const { surface, facts } = surfaceOf(stored);
  const areas = surface.triangles.map((t) => areaOf(t.map((v) => surface.positions[v])));
  return { ...facts, ...checkMap(surface, stored.precision, areas) };
}

const isFinite = (map) => map.uv.every((p) => p.every(Number.isFinite));

/** A stranger's map, changed in up to three ways. */
function strangersMap(n) {
  const random = new Random(1000003 * n + 17);
  const map = makeMap(random.pick(familyNames), n);
  const changes = [];
  for (let left = random.integer(0, 3); left > 0; left--) changes.push(random.pick(tamperNames));
  if (random.chance(0.3)) changes.push('float32');
  for (const name of changes) tampers[name](map, random);
  if (random.chance(0.2)) map.cones = null;
  if (changes.length === 0) changes.push('nothing');
  return { map, changes };
}

/** Places where an answer of `hgp verify` differs from what was decided exactly. */
function disagreements(decided, answer, q) {
  const wrong = [];
  const compare = (what, ours, theirs) => {
    if (ours !== theirs) wrong.push(`${what}: ${theirs}, exactly ${ours}`);
  };
  compare('certified', decided.isCertified, answer.code === 0);
  if (!answer.stdout.startsWith('{')) return wrong;
  const report = JSON.parse(answer.stdout);
  if (report.format !== 'hgp-certificate') return wrong;
  compare('report says', answer.code === 0, report.certified);
  compare('duplicates', decided.duplicates, report.stored.duplicates);
  compare('differing', decided.differing, report.stored.differing);
  compare('zeroArea', decided.folded, report.stored.zeroArea);
  const { reversed } = report.stored;
  if (reversed < decided.reversedAtLeast || reversed > decided.reversedAtMost)
    compare('reversed', decided.reversed, reversed);
  if (!report.components.every((c) => c.measured)) return wrong;
  const sum = (pick) => report.components.reduce((total, c) => total + pick(c), 0);
  compare(
    'not positive',
    decided.notPositive.length,
    sum((c) => c.orientation.notPositive.length),
  );
  compare(
    'seams',
    decided.seams,
    sum((c) => c.seams.edges),
  );
  compare(
    'broken',
    decided.broken,
    sum((c) => c.seams.broken),
  );
  if ([1, 2, 4].includes(q))
    compare(
      'exact seams',
      decided.exact,
      sum((c) => c.seams.exact),
    );
  if (decided.notPositive.length === 0 && decided.broken === 0) {
    compare('wrong angles', decided.wrongCones, report.wrongAngles);
    compare('wrong turnings', decided.wrongLoops, report.wrongTurnings);
  }
  return wrong;
}

test('hgp verify agrees with exact arithmetic on maps of other origin', async (t) => {
  const counts = { certified: 0, refused: 0, close: 0, left: 0 };
  const certifiedAfter = new Map();
  const wrong = [];
  await forCases(isFull ? 10_000 : 400, async (n) => {
    const at = (name) => path.join(folder, `${n}-${name}`);
    const { map, changes } = strangersMap(n);
    const { name, stored } = throughFile(map, at);
    // Equal positions are one vertex in glTF, infinite numbers no map: both are for other tests.
    const isSound =
      isFinite(map) && isFinite(stored) && stored.positions.length === map.positions.length;
    const decided = isSound ? decide(stored) : null;
    if (!decided || decided.isAmbiguous || decided.areConesAmbiguous || !decided.isManifold) {
      counts.left += 1;
      return;
    }
    const asked = ['--q', `${map.q}`];
    if (stored.cones) {
      writeFileSync(at('cones.json'), conesFile(map.q, stored.cones));
      asked.push('--cones', at('cones.json'));
    }
    const answer = await run('verify', name, ...asked, '--json', '-', '--quiet');
    const found = disagreements(decided, answer, map.q);
    if (decided.isClose) counts.close += 1;
    else if (decided.isCertified) counts.certified += 1;
    else counts.refused += 1;
    for (const change of changes)
      if (decided.isCertified) certifiedAfter.set(change, (certifiedAfter.get(change) ?? 0) + 1);
    if (found.length > 0 && !decided.isClose)
      wrong.push(`case ${n} (${changes}): ${found.join('; ')}; ${answer.stderr.slice(0, 200)}`);
  });
  t.diagnostic(JSON.stringify(counts));
  t.diagnostic(JSON.stringify(Object.fromEntries(certifiedAfter)));
  assert.deepEqual(wrong, []);
  if (process.env.HGP_ATTACK) return;
  // The cases must be able to tell.
  const total = counts.certified + counts.refused;
  assert.ok(counts.certified > 0.2 * total && counts.refused > 0.2 * total, JSON.stringify(counts));
  assert.ok(counts.left + counts.close < 0.2 * total, JSON.stringify(counts));
});

/** Sound surfaces and damaged ones, without a map. */
function surfaceToSolve(n) {
  const random = new Random(2000003 * n + 5);
  const map = makeMap(random.pick(['doubled', 'doubled', 'torus', 'cone']), 100_000 + n);
  const damages = ['duplicate', 'fold', 'flatTriangle', 'reverse', 'pinch'];
  const changes = [];
  for (let left = random.integer(0, 2); left > 0; left--) changes.push(random.pick(damages));
  for (const name of changes) tampers[name](map, random);
  if (random.chance(0.4)) map.precision = 'float32';
  return { map, changes, random };
}

/** Whatever happens to a map before it is stored. */
function optionsToSolve(random, q) {
  const options = random.chance(0.3) ? ['--write-repairs'] : [];
  if (random.chance(0.2))
    options.push('--improve', random.pick(['isometric', 'conformal', 'area']));
  if ((q === 2 || q === 4) && random.chance(0.3)) return [...options, '--cells', '200'];
  return [...options, '--scale', random.pick(['solved', 'fit', 'unit'])];
}

test('files that hgp param certifies pass the exact check, and hgp verify agrees', async (t) => {
  const counts = { certified: 0, refused: 0, left: 0 };
  const wrong = [];
  await forCases(isFull ? 1500 : 60, async (n) => {
    const at = (name) => path.join(folder, `${n}-${name}`);
    const { map, changes, random } = surfaceToSolve(n);
    const q = random.pick([1, 2, 3, 4, 6, 8]);
    const isGlb = map.precision === 'float32';
    // Without uv of its own, so that those of the result are the only ones.
    const bare = { ...map, uv: [[0, 0]], corners: map.triangles.map(() => [0, 0, 0]) };
    const { name } = throughFile(isGlb ? map : bare, at);
    const out = at(isGlb ? 'out.glb' : 'out.obj');
    const options = ['--q', `${q}`, ...optionsToSolve(random, q)];
    const answer = await run('param', name, '-o', out, ...options, '--json', at('report.json'));
    if (answer.code !== 0) {
      counts.refused += 1;
      if (![4, 5, 6, 7].includes(answer.code)) wrong.push(`case ${n}: exit code ${answer.code}`);
      return;
    }
    const report = JSON.parse(readFileSync(at('report.json'), 'utf8'));
    const { cones } = report.cones;
    const bytes = readFileSync(out);
    const stored = { ...(isGlb ? readGlb(bytes) : readObj(bytes.toString())), q, cones };
    const decided = decide(stored);
    if (decided.isAmbiguous) {
      counts.left += 1;
      return;
    }
    counts.certified += 1;
    const found = [];
    if (decided.areConesAmbiguous) found.push('the report does not say which cones are meant');
    if (!decided.isCertified) found.push(`exactly: ${JSON.stringify(decided)}`);
    if (decided.differing > 0) found.push(`${decided.differing} copies have other uv`);
    if ([1, 2, 4].includes(q) && decided.exact !== decided.seams)
      found.push(`${decided.exact} of ${decided.seams} seam edges are exact`);
    writeFileSync(at('cones.json'), conesFile(q, cones));
    const check = await run('verify', out, '--cones', at('cones.json'), '--json', '-', '--quiet');
    found.push(...disagreements(decided, check, q).map((text) => `verify: ${text}`));
    const { reversed, splitVertices } = report.certificate.stored;
    if (report.repairsWritten && (reversed > 0 || (splitVertices > 0 && !isGlb)))
      found.push(`repairs are written, but ${reversed} are reversed, ${splitVertices} split`);
    if (found.length > 0)
      wrong.push(`case ${n} (${changes}, ${options.join(' ')}): ${found.join('; ')}`);
  });
  t.diagnostic(JSON.stringify(counts));
  assert.deepEqual(wrong, []);
  if (process.env.HGP_ATTACK) return;
  assert.ok(counts.certified > 0.8 * (counts.certified + counts.refused), JSON.stringify(counts));
});
