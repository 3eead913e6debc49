// The quads of `hgp quads` on thirteen models, as the rows of bench/QUADS.md:
//
//   node bench/quads/quads.mjs MESHES [NAME…]      HGP_BIN: the program; --head: the head of the table
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { gunzipSync } from 'node:zlib';
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
const variants = [
  ['as solved', []],
  ['isometric', ['--improve', 'isometric']],
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

/** The row of one model and one variant, without line ends. */
export function rowOf(program, folder, model, [variant, words]) {
  const scratch = mkdtempSync(path.join(os.tmpdir(), 'hgp-bench-quads-'));
  try {
    const out = path.join(scratch, 'quads.obj');
    const file = path.join(folder, model);
    const seconds = run(program, ['quads', file, '--cells', String(kCells), '-q', '-o', out, ...words]); // prettier-ignore
    const m = measureQuads(readQuads(readFileSync(out, 'utf8')), surfaceOf(file));
    return [
      ...['', path.basename(model).replace(/\..*/, ''), variant, m.quads, m.rims],
      ...[
        `${m.folded} / ${m.dented}`,
        m.irregular,
        `${m.angle.toFixed(1)} / ${m.angle95.toFixed(0)}`,
      ],
      ...[`${m.edge.toFixed(3)} / ${m.area.toFixed(3)}`],
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

const head = [
  '| model | map | quads | rim edges | folded / dented | irregular | angle off 90°, mean / 95 % | CV of edge / area | distance to the surface, mean / max, % of its diagonal | s |',
  '|---|---|--:|--:|--:|--:|--:|--:|--:|--:|',
];

if (process.argv[2] === '--head') console.log(head.join('\n'));
else if (process.argv[1] === import.meta.filename) {
  const [folder, ...names] = process.argv.slice(2);
  const program = process.env.HGP_BIN ?? 'build/native-release/bin/hgp';
  const wanted = models.filter((m) => names.length === 0 || names.some((n) => m.includes(n)));
  for (const model of wanted) console.log(rowsOf(program, folder, model).join('\n'));
}
