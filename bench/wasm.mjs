// node bench/wasm.mjs [--runs N] [FACES …] [FILE …]: compares whole runs of the package with those of the native
// program in processor time and prints the table of bench/WASM.md. Needs build/package and build/native-release.

import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { parseArgs } from 'node:util';
import { blocks, ring } from '../tests/support/blocks.mjs';
import { bumpyDisk } from '../tests/support/disk.mjs';
import { cubeMesh, toObj } from '../tests/support/meshes.mjs';
import { runNative, runPackage } from '../tests/support/whole_runs.mjs';

const root = path.dirname(import.meta.dirname);
const native = process.env.HGP_BIN ?? path.join(root, 'build/native-release/bin/hgp');
const built = path.join(root, 'build/package');
for (const file of [native, built]) {
  if (!existsSync(file)) {
    console.error(`${path.relative(root, file)} is not built`);
    process.exit(1);
  }
}
const { values, positionals } = parseArgs({
  options: { runs: { type: 'string', default: '3' } },
  allowPositionals: true,
});
const runs = Number(values.runs);
const wanted = positionals.length > 0 ? positionals : ['10000', '100000'];
const folder = path.join(root, 'build/bench-wasm');
mkdirSync(folder, { recursive: true });

const kinds = {
  sphere: (faces) => toObj(cubeMesh(Math.round(Math.sqrt(faces / 12)))),
  disk: (faces) => bumpyDisk(Math.round(Math.sqrt(faces / 6))),
  'genus 1': (faces) => toObj(blocks(ring, { n: Math.round(Math.sqrt(faces / 64)) })),
};

/** Names and files of the meshes of one argument: generated ones of so many triangles, or a file. */
function meshesOf(word) {
  if (!/^\d+$/.test(word)) return [[path.basename(word), path.resolve(word)]];
  return Object.entries(kinds).map(([kind, make]) => {
    const file = path.join(folder, `${kind} ${word}.obj`);
    writeFileSync(file, make(Number(word)));
    return [kind, file];
  });
}

const head = ['mesh', 'faces', 'native s', 'WASM first s', 'WASM s', 'ratio', 'same result', 'MB'];
console.log(`| ${head.join(' | ')} |\n|---|--:|--:|--:|--:|--:|---|--:|`);
const ratios = [];
for (const [name, file] of wanted.flatMap(meshesOf)) {
  const out = path.join(folder, 'out.obj');
  const natives = Array.from({ length: runs }, () =>
    runNative(native, file, out, ['--threads', '1']),
  );
  const packaged = runPackage(built, file, runs);
  const report = JSON.parse(readFileSync(natives[0].report, 'utf8'));
  const [n, w] = [Math.min(...natives.map((run) => run.seconds)), Math.min(...packaged.seconds)];
  const faces = readFileSync(file, 'latin1').match(/^f /gm)?.length ?? '';
  const isSame =
    report.certified === packaged.certified &&
    JSON.stringify(report.cones.cones) === JSON.stringify(packaged.cones);
  ratios.push(w / n);
  const cells = [name, faces, n.toFixed(2), packaged.seconds[0].toFixed(2), w.toFixed(2)];
  cells.push((w / n).toFixed(2), isSame ? 'yes' : 'NO', Math.round(packaged.peak / 1e6));
  console.log(`| ${cells.join(' | ')} |`);
}
const mean = Math.exp(ratios.reduce((sum, ratio) => sum + Math.log(ratio), 0) / ratios.length);
console.log(
  `\nratios: geometric mean ${mean.toFixed(2)}, largest ${Math.max(...ratios).toFixed(2)}`,
);
