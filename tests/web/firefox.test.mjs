// The page in Firefox, from a drop to the file: where Firefox is installed, and otherwise the skip is said.
// Without a graphics card it has no WebGL; then the page must do everything but draw.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import test from 'node:test';

const firefox = ['/usr/bin/firefox-esr', '/usr/bin/firefox'].find(existsSync);
const program = path.resolve(import.meta.dirname, '../../build/native-release/bin/hgp');

test('Firefox: drop, Run, read, download', (t) => {
  if (!firefox) {
    // Not a skip, which would count as missing data: Firefox is optional.
    t.diagnostic('SKIPPING: Firefox is not installed (apt-get install firefox-esr)');
    return;
  }
  const folder = mkdtempSync(path.join(tmpdir(), 'hgp-firefox-'));
  try {
    const pilot = path.join(import.meta.dirname, 'firefox_pilot.mjs');
    const { status, stdout, stderr } = spawnSync(
      process.execPath,
      ['--no-warnings', '--experimental-websocket', pilot, firefox, folder],
      { encoding: 'utf8', timeout: 120_000 },
    );
    assert.equal(status, 0, stderr);
    const seen = JSON.parse(stdout);
    t.diagnostic(`Firefox ${seen.browserVersion}, ${seen.hasPictures ? 'with' : 'without'} WebGL`);
    assert.match(seen.status, /^Certified: no triangle is folded/);
    assert.match(seen.banner, /Certified/);
    assert.equal(seen.name, 'cube.obj');
    const isWebGl = (text) => /WebGL/.test(text);
    assert.deepEqual(seen.problems.filter((text) => seen.hasPictures || !isWebGl(text)), []); // prettier-ignore
    if (!existsSync(program)) return;
    const file = path.join(folder, 'cube.obj');
    writeFileSync(file, seen.text);
    assert.equal(spawnSync(program, ['verify', '-q', file]).status, 0);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
});
