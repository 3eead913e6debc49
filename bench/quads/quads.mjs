// The quads of `hgp quads`, as the rows of bench/QUADS.md:
//
//   node bench/quads/quads.mjs MESHES [NAME…]             thirteen models
//   node bench/quads/quads.mjs --creases MODELS [NAME…]   eight with creases, without and with lines along these
//
// HGP_BIN: the program; --head: the head of the table
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { gunzipSync } from 'node:zlib';
import { creasesOf, shareOnEdges } from './creases.mjs';
import { measureQuads, readQuads, readSurface } from './shape.mjs';

export const models = [
  'BFF/hemisphere.obj',
  'BFF/cowhead.obj',
  'odedstein-meshes/spot_low_resolution.obj',
  'OptCuts/horse_f10000.obj',
  'Directional/eight.off',
  'Directional/697224__sf.obj',
  'gp-js/double-torus.obj',
  'OptCuts/feline_half.obj',
  'wildmeshing-data/100071_sf.obj',
  'gp-js/soccerball.obj.gz',
  'ConformalIdealDelaunay/elephant.obj.gz',
  'odedstein-meshes/nefertiti-lowres.obj.gz',
  'odedstein-meshes/skull.obj.gz',
];
const withCreases = [
  ...['deckel_rem.obj', 'hinge_rem.obj.gz', 'joint_rem.obj', 'motor_tail_rem.obj.gz'],
  ...['sculpt_rem.obj', 'wrench_rem.obj', 'fandisk.off.gz', 'casting.off.gz'],
];
const variants = [
  ['as solved', []],
  ['isometric', ['--improve', 'isometric']],
];
const alongCreases = [
  ['without features', []],
  ['`--creases`', ['--creases']],
  ['`--creases`, isometric', ['--creases', '--improve', 'isometric']],
];
const kCells = 4000;

function surfaceOf(file) {
  const bytes = readFileSync(file);
  return readSurface((file.endsWith('.gz') ? gunzipSync(bytes) : bytes).toString());
}

/** Runs the program; processor seconds as the shell's `times` tells them. */
function run(program, words) {
  const done = spawnSync('sh', ['-c', '"$0" "$@" && times', program, ...words], {
    encoding: 'utf8',
  });
  if (done.status !== 0) throw new Error(`${words.join(' ')}: ${done.stderr}`);
  return [
    ...done.stdout
      .trim()
      .split('\n')
      .at(-1)
      .matchAll(/(\d+)m([\d.]+)s/g),
  ]
    .map(([, minutes, seconds]) => 60 * Number(minutes) + Number(seconds))
    .reduce((a, b) => a + b);
}

/**
 * The row of one model and one variant, without line ends. With `hasCreases` a column says how much of the creases' length
 * lies on edges of quads, and what the program says of the run if it does not end well.
 */
export function rowOf(program, folder, model, [variant, words], hasCreases = false) {
  const scratch = mkdtempSync(path.join(os.tmpdir(), 'hgp-bench-quads-'));
  try {
    const out = path.join(scratch, 'quads.obj');
    const file = path.join(folder, model);
    const name = ['', path.basename(model).replace(/\..*/, ''), variant];
    let seconds;
    try {
      seconds = run(program, ['quads', file, '--cells', String(kCells), '-q', '-o', out, ...words]);
    } catch (error) {
      if (!hasCreases) throw error;
      return [...name, error.message.split('\n').at(-1), ...Array(8).fill(''), ''].join(' | ').trim(); // prettier-ignore
    }
    const mesh = readQuads(readFileSync(out, 'utf8'));
    const surface = surfaceOf(file);
    const m = measureQuads(mesh, surface);
    return [
      ...[...name, m.quads, m.rims, `${m.folded} / ${m.dented}`, m.irregular],
      ...[`${m.angle.toFixed(1)} / ${m.angle95.toFixed(0)}`],
      ...[`${m.edge.toFixed(3)} / ${m.area.toFixed(3)}`],
      ...(hasCreases ? [shareOnEdges(creasesOf(surface), mesh).toFixed(2)] : []),
      ...[`${m.distance.toFixed(3)} / ${m.farthest.toFixed(2)}`, seconds.toFixed(2), ''],
    ]
      .join(' | ')
      .trim();
  } finally {
    rmSync(scratch, { recursive: true });
  }
}

export const rowsOf = (program, folder, model) =>
  variants.map((variant) => rowOf(program, folder, model, variant));

export const creaseRowsOf = (program, folder, model) =>
  alongCreases.map((variant) => rowOf(program, folder, model, variant, true));

const headOf = (hasCreases) => {
  const columns = [
    ...['model', 'map', 'quads', 'rim edges', 'folded / dented', 'irregular'],
    ...['angle off 90°, mean / 95 %', 'CV of edge / area'],
    ...(hasCreases ? ['creases on edges'] : []),
    ...['distance to the surface, mean / max, % of its diagonal', 's'],
  ];
  const marks = ['---', '---', ...columns.slice(2).map(() => '--:')];
  return `| ${columns.join(' | ')} |\n|${marks.join('|')}|`;
};

if (process.argv[1] === import.meta.filename) {
  const words = process.argv.slice(2);
  const hasCreases = words.includes('--creases');
  const [folder, ...names] = words.filter((word) => !word.startsWith('--'));
  const program = process.env.HGP_BIN ?? 'build/native-release/bin/hgp';
  const isWanted = (m) => names.length === 0 || names.some((n) => m.includes(n));
  const [list, rows] = hasCreases ? [withCreases, creaseRowsOf] : [models, rowsOf];
  if (words.includes('--head')) console.log(headOf(hasCreases));
  else
    for (const model of list.filter(isWanted)) console.log(rows(program, folder, model).join('\n'));
}
