// "Five minutes with Python", from an empty home, exactly as printed, except that what has been compiled is not
// compiled again without --full.

import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { emptyHome, runPage } from '../support/page.mjs';

test('docs/five-minutes/python.md', async () => {
  const { home, remove } = emptyHome();
  const isFull = process.env.HGP_FULL === '1';
  const build = process.env.HGP_BUILD ?? 'build/native-release';
  try {
    // Debian's Python, even if another one comes first on the PATH.
    const more = { PATH: `/usr/bin:/bin:${process.env.PATH}` };
    if (!isFull) more.HGP_BUILD_DIR = build;
    const { folder } = await runPage('five-minutes/python.md', home, more);
    assert.ok(existsSync(path.join(folder, 'mapped.obj')));
  } finally {
    remove();
  }
});
