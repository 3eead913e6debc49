// node bench/rates/rates.mjs FOLDER… [--hgp PROGRAM] [--limit SECONDS] [--json FILE]
//
// Runs `hgp param` without options, in 2 GB of address space, on every glTF and polygon file below the folders, and
// reports how many are certified, which are slow, and which are refused and why. Written files are checked by
// independent code (tests/support/check_file.mjs): the sign of every stored triangle, and the two sides of every edge.

import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { parseArgs } from 'node:util';
import { checkFile } from '../../tests/support/check_file.mjs';

const root = path.resolve(import.meta.dirname, '../..');
const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: {
    hgp: { type: 'string', default: path.join(root, 'build/native-release/bin/hgp') },
    limit: { type: 'string', default: '120' },
    json: { type: 'string' },
  },
});
const kinds = { gltf: /\.(gltf|glb)$/i, polygon: /\.(obj|off|ply|stl)(\.gz)?$/i };
const slowSeconds = 60;
const kilobytes = 2 << 20; // of address space
const manyTriangles = 300_000;

function filesBelow(place) {
  if (!statSync(place).isDirectory()) return [place];
  return readdirSync(place, { withFileTypes: true })
    .sort((a, b) => (a.name < b.name ? -1 : 1))
    .flatMap((entry) => filesBelow(path.join(place, entry.name)));
}

const meaning = {
  0: 'certified',
  3: 'cannot be read',
  4: 'geometry',
  5: 'prescription',
  6: 'not certified',
  7: 'cannot be written',
  8: 'limit',
};

/** Number of triangles in a report of one or all meshes. */
function trianglesOf(report) {
  if (!report) return 0;
  const list = report.meshes ? report.meshes.map((m) => m.document) : [report];
  return list.reduce((n, one) => n + (one.certificate?.stored?.triangles ?? 0), 0);
}

/** Triangles that a report states to be outside its certificate, whose orientation is not checked. */
function outsideOf(report) {
  const list = report.meshes ? report.meshes.map((m) => m.document) : [report];
  return list.reduce((n, { certificate }) => {
    const { duplicates = 0, zeroArea = 0, reversed = 0 } = certificate?.stored ?? {};
    return n + duplicates + zeroArea + reversed;
  }, 0);
}

const scratch = mkdtempSync(path.join(os.tmpdir(), 'hgp-rates-'));

async function runOne(file, kind) {
  const ending = kind === 'gltf' ? path.extname(file).toLowerCase() : '.obj';
  const out = path.join(scratch, `out${ending}`);
  const report = path.join(scratch, 'report.json');
  for (const name of readdirSync(scratch)) rmSync(path.join(scratch, name), { recursive: true });
  const begin = performance.now();
  const run = spawnSync(
    'bash',
    [
      ...['-c', `ulimit -v ${kilobytes}; exec "$@"`, 'run'],
      ...[values.hgp, 'param', file, '-o', out, '--json', report, '--no-progress', '--quiet'],
    ],
    { encoding: 'utf8', timeout: 1000 * Number(values.limit) },
  );
  const seconds = (performance.now() - begin) / 1000;
  let document;
  try {
    document = JSON.parse(readFileSync(report, 'utf8'));
  } catch {
    document = undefined;
  }
  const one = { file, kind, seconds, code: run.status, triangles: trianglesOf(document) };
  // A run that is stopped reports a timeout.
  const isTooLong = run.error?.code === 'ETIMEDOUT';
  one.outcome = isTooLong ? `over ${values.limit} s` : (meaning[run.status] ?? `${run.status}`);
  const lines = (run.stderr ?? '').split('\n').filter((line) => line.startsWith('hgp: '));
  if (run.status !== 0 && !isTooLong) one.reason = reasonOf(document) ?? lines[0]?.slice(5) ?? '';
  if (run.status === 0) {
    try {
      one.checked = await checkFile(out, kind, { outside: outsideOf(document) });
    } catch (error) {
      one.checked = { good: false, why: `cannot be checked: ${error.message}` };
    }
  }
  return one;
}

/** The first reason of a mesh without a map. */
function reasonOf(report) {
  if (!report) return undefined;
  if (report.format === 'hgp-error') return report.message;
  const list = report.meshes
    ? report.meshes.filter((m) => !m.certified).map((m) => m.document)
    : [report];
  for (const one of list) {
    if (one.format === 'hgp-error') return one.message;
    for (const component of one.certificate?.components ?? [])
      for (const { message } of component.reasons ?? []) return message;
  }
  return undefined;
}

const all = [];
for (const place of positionals) {
  for (const file of filesBelow(place)) {
    const kind = Object.keys(kinds).find((name) => kinds[name].test(file));
    if (!kind) continue;
    const one = await runOne(file, kind);
    all.push(one);
    const checked = one.checked
      ? one.checked.good
        ? ''
        : `  CHECKED WRONG: ${one.checked.why}`
      : '';
    console.log(
      `${one.outcome.padEnd(16)} ${one.seconds.toFixed(1).padStart(6)} s ${String(one.triangles).padStart(8)}  ` +
        `${path.relative(process.cwd(), file)}${one.reason ? `\n    ${one.reason}` : ''}${checked}`,
    );
  }
}
rmSync(scratch, { recursive: true });

console.log('');
for (const kind of Object.keys(kinds)) {
  const list = all.filter((one) => one.kind === kind);
  if (list.length === 0) continue;
  const count = new Map();
  for (const { outcome } of list) count.set(outcome, (count.get(outcome) ?? 0) + 1);
  const readable = list.filter(({ outcome }) => outcome !== 'cannot be read');
  const certified = list.filter(({ code }) => code === 0);
  const wrong = certified.filter(({ checked }) => !checked.good);
  const share = (100 * certified.length) / Math.max(1, readable.length);
  console.log(
    `${kind}: ${certified.length} of ${readable.length} readable files certified (${share.toFixed(1)} %), ` +
      `${wrong.length} of them checked wrong; ${[...count].map(([k, n]) => `${n} ${k}`).join(', ')}`,
  );
}
const slow = all.filter((one) => one.seconds > slowSeconds && one.triangles < manyTriangles);
for (const one of slow) console.log(`slow: ${one.file} ${one.seconds.toFixed(0)} s`);
if (values.json) writeFileSync(values.json, JSON.stringify(all, null, 1));
process.exitCode = all.some(({ checked }) => checked && !checked.good) ? 1 : 0;
