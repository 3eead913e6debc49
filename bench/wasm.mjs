// node bench/wasm.mjs [--runs N] [FACES …]: compares WebAssembly with the native program without run-time
// dispatch and prints the table of bench/WASM.md. Needs build/package and
//   cmake --preset native-baseline && cmake --build --preset native-baseline

import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { parseArgs } from 'node:util';
import { blocks, ring } from '../tests/support/blocks.mjs';
import { bumpyDisk } from '../tests/support/disk.mjs';
import { cubeMesh, toObj } from '../tests/support/meshes.mjs';

const root = path.dirname(import.meta.dirname);
const native = path.join(root, 'build/native-baseline/bin/hgp');
const packaged = path.join(root, 'build/package/node/index.js');
for (const file of [native, packaged]) {
  if (!existsSync(file)) {
    console.error(`${path.relative(root, file)} is not built`);
    process.exit(1);
  }
}
const { values, positionals } = parseArgs({
  options: { runs: { type: 'string', default: '3' } },
  allowPositionals: true,
});
const sizes = positionals.length > 0 ? positionals.map(Number) : [10_000, 100_000];
const folder = path.join(root, 'build/bench-wasm');
mkdirSync(folder, { recursive: true });

const kinds = {
  sphere: (faces) => toObj(cubeMesh(Math.round(Math.sqrt(faces / 12)))),
  disk: (faces) => bumpyDisk(Math.round(Math.sqrt(faces / 6))),
  'genus 1': (faces) => toObj(blocks(ring, { n: Math.round(Math.sqrt(faces / 64)) })),
};

/** The report of `hgp param`, which contains the seconds of the solve, as that of the package does. */
function runNative(file) {
  const report = path.join(folder, 'report.json');
  const out = path.join(folder, 'out.obj');
  const args = ['param', file, '-o', out, '--json', report, '--quiet', '--force'];
  execFileSync(native, [...args, '--q', '4', '--allow-uncertified']);
  return JSON.parse(readFileSync(report, 'utf8'));
}

const { createClient } = await import(packaged);
const client = await createClient();
await new Promise((done) => setTimeout(done, 1000)); // it warms up in the meantime

const stages = ['prepare', 'cones', 'connection', 'field', 'cut', 'assemble', 'solve'];
const head = ['mesh', 'faces', 'native s', 'WASM first s', 'WASM s', 'ratio', 'same result'];
console.log(`| ${[...head, ...stages, 'MB'].join(' | ')} |`);
console.log(`|---|--:|--:|--:|--:|--:|---|${'--:|'.repeat(stages.length + 1)}`);
let worst = 0;
for (const faces of sizes) {
  for (const [kind, make] of Object.entries(kinds)) {
    const text = make(faces);
    const file = path.join(folder, 'mesh.obj');
    writeFileSync(file, text);
    const { triangles } = await client.load(new TextEncoder().encode(text), { name: 'mesh.obj' });
    const seconds = { native: [], wasm: [] };
    let times = [];
    let isSame = true;
    // Alternating, so that other load on the machine affects both.
    for (let i = 0; i < Number(values.runs); i++) {
      const a = runNative(file);
      const b = (await client.parametrize({ q: 4 })).report;
      seconds.native.push(a.seconds);
      seconds.wasm.push(b.seconds);
      if (b.seconds === Math.min(...seconds.wasm)) times = b.components[0].times;
      isSame &&= a.certified === b.certified;
      isSame &&= JSON.stringify(a.cones.cones) === JSON.stringify(b.cones.cones);
    }
    const [n, w] = [Math.min(...seconds.native), Math.min(...seconds.wasm)];
    worst = Math.max(worst, w / n);
    const cells = [kind, triangles, n.toFixed(2), seconds.wasm[0].toFixed(2), w.toFixed(2)];
    const spent = (stage) => times.find((t) => t.stage === stage)?.seconds.toFixed(2) ?? '';
    // The peak of the whole process, which never decreases from one row to the next.
    const peak = Math.round((process.resourceUsage().maxRSS * 1024) / 1e6);
    cells.push((w / n).toFixed(2), isSame ? 'yes' : 'NO', ...stages.map(spent), peak);
    console.log(`| ${cells.join(' | ')} |`);
  }
}
client.terminate();
console.log(`\nworst ratio ${worst.toFixed(2)} (wanted: at most 2.0)`);
