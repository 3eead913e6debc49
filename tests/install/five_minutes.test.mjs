// "Five minutes with" C++ and the command line, from an empty home, exactly as printed.

import assert from 'node:assert/strict';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { execFileSync } from 'node:child_process';
import os from 'node:os';
import path from 'node:path';
import test from 'node:test';
import { emptyHome, root, runPage } from '../support/page.mjs';

// Where make is not installed, CMake would have to be told each time.
const more = { CMAKE_GENERATOR: 'Ninja' };

for (const page of ['command-line', 'cpp']) {
  test(`docs/five-minutes/${page}.md`, async () => {
    const { home, remove } = emptyHome();
    try {
      const { folder } = await runPage(`five-minutes/${page}.md`, home, more);
      assert.ok(existsSync(folder));
    } finally {
      remove();
    }
  });
}

test('the sample mesh is reproduced by `generate`', () => {
  const folder = mkdtempSync(path.join(os.tmpdir(), 'hgp-sample-'));
  try {
    const program = path.join(root, 'build/native-release/bin/generate');
    execFileSync(program, [folder, 'small-pretzel'], { stdio: 'pipe' });
    const words = (file) => readFileSync(file, 'utf8').split(/\s+/);
    const made = words(path.join(folder, 'small-pretzel.obj'));
    const kept = words(path.join(root, 'examples/meshes/pretzel.obj'));
    assert.equal(made.length, kept.length);
    // The last digits are those of the C library's functions.
    kept.forEach((word, i) => {
      if (word !== made[i]) assert.ok(Math.abs(word - made[i]) < 1e-9, `${i}: ${word} ${made[i]}`);
    });
  } finally {
    rmSync(folder, { recursive: true });
  }
});
