// Shared libraries: built, installed, found by a program, and the command line beside them runs. A build of its
// own, so only with --full.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';

const root = path.resolve(import.meta.dirname, '../..');
const build = path.join(root, 'build/native-shared');
const prefix = path.join(build, 'prefix');
const run = (command, ...args) => execFileSync(command, args, { encoding: 'utf8', stdio: 'pipe' });
const block = (language) =>
  readFileSync(path.join(root, 'README.md'), 'utf8').match(
    new RegExp(`In C\\+\\+[^]*?\`\`\`${language}\\n([^]*?)\`\`\``),
  )[1];

if (process.env.HGP_FULL) {
  test('shared libraries are built, installed and found', () => {
    const options = ['BUILD_SHARED_LIBS=ON', 'HGP_TESTS=OFF', 'HGP_BENCH=OFF', 'HGP_EXAMPLES=OFF'];
    const settings = options.map((option) => `-D${option}`);
    const release = ['-DCMAKE_BUILD_TYPE=Release', '-DCMAKE_UNITY_BUILD=ON'];
    run('cmake', '-G', 'Ninja', '-S', root, '-B', build, ...release, ...settings);
    run('cmake', '--build', build);
    rmSync(prefix, { recursive: true, force: true });
    run('cmake', '--install', build, '--prefix', prefix);
    const names = readdirSync(prefix, { recursive: true, encoding: 'utf8' });
    assert.ok(names.some((name) => /libhgp_parametrize\.so$/.test(name)));
    assert.ok(!names.some((name) => /libhgp_.*\.a$/.test(name)));
    assert.match(run(path.join(prefix, 'bin/hgp'), '--version'), /\d+\.\d+/);

    const source = path.join(build, 'program');
    mkdirSync(source, { recursive: true });
    writeFileSync(path.join(source, 'CMakeLists.txt'), block('cmake'));
    writeFileSync(path.join(source, 'main.cpp'), block('cpp'));
    const out = path.join(source, 'build');
    run('cmake', '-G', 'Ninja', '-S', source, '-B', out, `-DCMAKE_PREFIX_PATH=${prefix}`);
    run('cmake', '--build', out);
    assert.match(run(path.join(out, 'your_program')), /^certified: yes$/m);
  });
} else {
  console.log('SKIPPING shared libraries: built with --full only');
}
