// The installed library is usable by find_package(hgp), from a project that knows nothing of ours.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { rmSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { fileURLToPath } from 'node:url';

const here = path.dirname(fileURLToPath(import.meta.url));
const root = path.resolve(here, '../..');
const prefix = path.join(root, 'build/install/prefix');
const build = path.join(root, 'build/install/example');
const run = (command, ...args) => execFileSync(command, args, { encoding: 'utf8', stdio: 'pipe' });

test('cmake --install, find_package, build, run', () => {
  rmSync(path.join(root, 'build/install'), { recursive: true, force: true });
  run('cmake', '--install', path.join(root, 'build/native-release'), '--prefix', prefix);
  const source = path.join(here, 'example');
  run('cmake', '-G', 'Ninja', '-S', source, '-B', build, `-DCMAKE_PREFIX_PATH=${prefix}`);
  run('cmake', '--build', build);
  const printed = run(path.join(build, 'example'));
  assert.match(printed, /^certified: yes$/m);
});
