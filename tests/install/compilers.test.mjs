// The compilers that cmake/HgpCompilers.cmake and docs/five-minutes/cpp.md say are tested.

import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import test, { before } from 'node:test';
import { root } from '../support/page.mjs';

const folder = path.join(root, 'build/compilers');
const prefix = path.join(folder, 'prefix');
const compilers = ['g++-11', 'g++-12', 'clang++-14'];
const run = (command, ...args) => execFileSync(command, args, { encoding: 'utf8', stdio: 'pipe' });

before(() => {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  run('cmake', '--install', path.join(root, 'build/native-release'), '--prefix', prefix);
});

/** Whether it is there; scripts/setup installs them. */
const isThere = (compiler) => !spawnSync(compiler, ['--version']).error;

// What is not ISO C++ or has an alternative: every file that asks which compiler it is, those in one list together.
const guarded = [
  ['linalg/kernels/dense_kernels.cpp'],
  ['linalg/kernels/dense_kernels_baseline.cpp'],
  ['linalg/kernels/dense_kernels_plain.cpp'],
  ['base/check.cpp', 'verify/orientation.cpp', 'grid/snap.cpp', 'quads/grid_lines.cpp'],
];
const warnings = [
  '-Wall',
  '-Wextra',
  '-Wshadow',
  '-Wconversion',
  '-Wno-sign-conversion',
  '-Werror',
];

for (const compiler of compilers) {
  test(`${compiler}: the program of the README, with the installed library`, (t) => {
    if (!isThere(compiler)) return t.skip(`${compiler} is not installed`);
    const readme = readFileSync(path.join(root, 'README.md'), 'utf8');
    const main = path.join(folder, `${compiler}.cpp`);
    writeFileSync(main, readme.match(/In C\+\+[^]*?```cpp\n([^]*?)```/)[1]);
    const build = path.join(folder, compiler);
    mkdirSync(path.join(folder, `${compiler}-source`));
    writeFileSync(
      path.join(folder, `${compiler}-source`, 'CMakeLists.txt'),
      `cmake_minimum_required(VERSION 3.22)
project(one LANGUAGES CXX)
find_package(hgp REQUIRED)
add_executable(one ${main})
target_link_libraries(one PRIVATE hgp::hgp)
`,
    );
    const source = path.join(folder, `${compiler}-source`);
    const settings = [`-DCMAKE_PREFIX_PATH=${prefix}`, `-DCMAKE_CXX_COMPILER=${compiler}`];
    run('cmake', '-G', 'Ninja', '-S', source, '-B', build, ...settings);
    run('cmake', '--build', build);
    assert.match(run(path.join(build, 'one')), /^certified: yes$/m);
  });

  test(`${compiler}: files that depend on the compiler, with its extensions and in ISO C++`, (t) => {
    if (!isThere(compiler)) return t.skip(`${compiler} is not installed`);
    const unit = path.join(folder, `${compiler}-unit.cpp`);
    for (const files of guarded) {
      writeFileSync(unit, files.map((file) => `#include "hgp/${file}"\n`).join(''));
      for (const more of [[], ['-DHGP_PORTABLE', '-Wpedantic']]) {
        const flags = ['-std=c++20', '-O1', '-fsyntax-only', '-ffp-contract=off', ...warnings];
        const where = [`-I${root}/core`, '-isystem', '/usr/include/eigen3'];
        run(compiler, ...flags, ...more, ...where, unit);
      }
    }
  });
}

test('no other file of the library depends on the compiler or the operating system', () => {
  const listed = run(
    'git',
    '-C',
    root,
    'ls-files',
    '-co',
    '--exclude-standard',
    'core',
    'examples/cli',
  )
    .trim()
    .split('\n');
  const beyond =
    /__int128|vector_size|__builtin_|__attribute__|_Pragma|#pragma (?!once)|<(unistd|fcntl|signal|sys\/\w+|immintrin|malloc|io)\.h>/;
  const found = listed
    .filter((file) => /\.(h|cpp)$/.test(file))
    .filter((file) => beyond.test(readFileSync(path.join(root, file), 'utf8')));
  assert.deepEqual(found.sort(), [
    'core/hgp/base/check.h',
    'core/hgp/base/wide_integer.h',
    'core/hgp/linalg/kernels/dense_kernels.cpp',
    'core/hgp/linalg/kernels/dense_kernels_avx2.cpp',
    'core/hgp/linalg/kernels/dense_kernels_avx512.cpp',
    'core/hgp/linalg/kernels/dense_kernels_baseline.cpp',
    'core/hgp/linalg/kernels/dense_product_impl.h',
    'examples/cli/process_memory.cpp',
    'examples/cli/terminal.cpp',
  ]);
});
