// What plain runs cost, counted and not timed: the instructions of whole processes on five small meshes, by valgrind,
// against bench/INSTRUCTIONS.md. A change that makes a run more expensive has to remake the table, where it is seen.
//
//     node tests/cli/instructions.test.mjs --write    remakes the table

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import test from 'node:test';
import { blocks, eight, ring } from '../support/blocks.mjs';
import { bumpyDisk } from '../support/disk.mjs';
import { cubeMesh, toObj } from '../support/meshes.mjs';

const root = path.resolve(import.meta.dirname, '../..');
const program = process.env.HGP_BIN ?? path.join(root, 'build/native-release/bin/hgp');
const table = path.join(root, 'bench/INSTRUCTIONS.md');
const mostRise = 0.03;

const meshes = {
  'rounded cube': () => toObj(cubeMesh(10)),
  'finer cube': () => toObj(cubeMesh(16)),
  'ring of blocks': () => toObj(blocks(ring, { n: 4 })),
  'two handles': () => toObj(blocks(eight, { n: 3 })),
  disk: () => bumpyDisk(24),
};

const hasValgrind = spawnSync('valgrind', ['--version']).status === 0;

/** Millions of instructions of `hgp param`, with the kernels that every processor has. */
function count(name) {
  const folder = mkdtempSync(path.join(tmpdir(), 'hgp-instructions-'));
  try {
    const [file, out] = ['in.obj', 'out.obj'].map((one) => path.join(folder, one));
    writeFileSync(file, meshes[name]());
    const counter = ['--tool=callgrind', `--callgrind-out-file=${path.join(folder, 'counts')}`];
    const run = [program, 'param', '--reproducible', '--threads', '1', file, '-o', out];
    const { status, stderr } = spawnSync('valgrind', [...counter, ...run], { encoding: 'utf8' });
    assert.equal(status, 0, stderr);
    return Number(stderr.match(/Collected : (\d+)/)[1]) / 1e6;
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}

const rowsOf = (text) =>
  new Map([...text.matchAll(/^\| ([^|]+?) \| +([\d.]+) \|$/gm)].map(([, name, n]) => [name, +n]));

function write() {
  const rows = Object.keys(meshes).map((name) => `| ${name} | ${count(name).toFixed(1)} |`);
  const text = `# Instructions of plain runs

Millions of instructions of \`hgp param --reproducible --threads 1\`, the whole process, counted by valgrind (callgrind) on meshes of
the tests (build \`native-release\`). Unlike times they are the same on a busy machine. \`tests/cli/instructions.test.mjs\`
fails when one rises by more than ${100 * mostRise} %, and says so where valgrind (80 MB, not installed by scripts/setup) is missing; \`node tests/cli/instructions.test.mjs --write\` makes this table.

| mesh | millions |
|---|--:|
${rows.join('\n')}
`;
  writeFileSync(table, text);
}

if (process.argv.includes('--write')) write();
else
  test('plain runs take at most 3 % more instructions than the table says', (t) => {
    if (!hasValgrind) return t.skip('valgrind is not installed: instructions are not counted');
    const known = rowsOf(readFileSync(table, 'utf8'));
    assert.deepEqual([...known.keys()], Object.keys(meshes));
    const risen = [];
    for (const [name, before] of known) {
      const now = count(name);
      t.diagnostic(`${name}: ${now.toFixed(1)} million, ${before} in the table`);
      if (now > (1 + mostRise) * before)
        risen.push(`${name}: ${now.toFixed(1)} instead of ${before}`);
    }
    const advice = 'make the run cheaper, or the table anew in the same commit (--write)';
    assert.deepEqual(risen, [], advice);
  });
