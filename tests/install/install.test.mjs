// The installed library in a project that knows nothing of ours: by find_package, by pkg-config, by
// add_subdirectory, with the README's own words; and every installed header alone.

import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import test, { before } from 'node:test';
import { fileURLToPath } from 'node:url';

const here = path.dirname(fileURLToPath(import.meta.url));
const root = path.resolve(here, '../..');
const folder = path.join(root, 'build/install');
const prefix = path.join(folder, 'prefix');
const run = (command, ...args) => execFileSync(command, args, { encoding: 'utf8', stdio: 'pipe' });

const readme = readFileSync(path.join(root, 'README.md'), 'utf8');
const block = (language) =>
  readme.match(new RegExp(`In C\\+\\+[^]*?\`\`\`${language}\\n([^]*?)\`\`\``))[1];

/** A project of these files below build/install. */
function project(name, files) {
  const source = path.join(folder, name);
  mkdirSync(source, { recursive: true });
  for (const [file, text] of Object.entries(files)) writeFileSync(path.join(source, file), text);
  return source;
}

const installed = (pattern) =>
  readdirSync(prefix, { recursive: true, encoding: 'utf8' }).filter((name) => pattern.test(name));

before(() => {
  rmSync(folder, { recursive: true, force: true });
  run('cmake', '--install', path.join(root, 'build/native-release'), '--prefix', prefix);
});

test('the C++ example of the README builds and runs as printed', () => {
  const source = project('readme', { 'CMakeLists.txt': block('cmake'), 'main.cpp': block('cpp') });
  const build = path.join(source, 'build');
  run('cmake', '-G', 'Ninja', '-S', source, '-B', build, `-DCMAKE_PREFIX_PATH=${prefix}`);
  run('cmake', '--build', build);
  assert.match(run(path.join(build, 'your_program')), /^certified: yes$/m);
});

test('the modules can be linked one by one', () => {
  const build = path.join(folder, 'example');
  const source = path.join(here, 'example');
  run('cmake', '-G', 'Ninja', '-S', source, '-B', build, `-DCMAKE_PREFIX_PATH=${prefix}`);
  run('cmake', '--build', build);
  assert.match(run(path.join(build, 'example')), /^certified: yes$/m);
});

test('pkg-config gives the flags that a program needs', () => {
  const [pc] = installed(/hgp\.pc$/);
  const env = { ...process.env, PKG_CONFIG_PATH: path.dirname(path.join(prefix, pc)) };
  const flags = execFileSync('pkg-config', ['--cflags', '--libs', 'hgp'], {
    env,
    encoding: 'utf8',
  });
  const source = project('pkg-config', { 'main.cpp': block('cpp') });
  const program = path.join(source, 'program');
  run('g++', '-O0', path.join(source, 'main.cpp'), '-o', program, ...flags.trim().split(/\s+/));
  assert.match(run(program), /^certified: yes$/m);
});

test('every installed header compiles alone, and none is private', () => {
  const headers = installed(/include\/.*\.h$/);
  assert.ok(headers.some((name) => name.endsWith('hgp/eigen.h')));
  const hidden = /linalg|socp|io\/(gltf|polygon)\/|_impl\.h|json_values/;
  assert.deepEqual(
    headers.filter((name) => hidden.test(name)),
    [],
  );
  const source = project('headers', {});
  for (const name of headers) {
    const file = path.join(source, 'one.cpp');
    writeFileSync(file, `#include <${name.replace(/.*?include\//, '')}>\n`);
    const { status, stderr } = spawnSync(
      'g++',
      [
        '-std=c++20',
        '-fsyntax-only',
        `-I${path.join(prefix, 'include')}`,
        '-isystem',
        '/usr/include/eigen3',
        file,
      ],
      { encoding: 'utf8' },
    );
    assert.equal(status, 0, `${name}\n${stderr}`);
  }
});

test('the program, its manual page and its completions are where shells and man look for them', () => {
  for (const name of [
    'bin/hgp',
    'share/man/man1/hgp.1',
    'share/bash-completion/completions/hgp',
    'share/zsh/site-functions/_hgp',
    'share/fish/vendor_completions.d/hgp.fish',
  ])
    assert.ok(existsSync(path.join(prefix, name)), name);
  const text = (name) => readFileSync(path.join(prefix, 'share', name), 'utf8');
  const hgp = path.join(prefix, 'bin/hgp');
  assert.equal(text('man/man1/hgp.1'), run(hgp, 'manual'));
  assert.equal(text('bash-completion/completions/hgp'), run(hgp, 'completion', 'bash'));
  assert.equal(text('zsh/site-functions/_hgp'), run(hgp, 'completion', 'zsh'));
  assert.equal(text('fish/vendor_completions.d/hgp.fish'), run(hgp, 'completion', 'fish'));
});

test('the licence is installed', () => {
  assert.equal(installed(/\/LICENSE$/).length, 1);
});

test('as a subproject: one library, nothing else, and the Eigen that is already there', () => {
  const source = project('subproject', {
    'CMakeLists.txt': `cmake_minimum_required(VERSION 3.22)
project(around LANGUAGES CXX)
set(CMAKE_BUILD_TYPE Release)
set(BUILD_SHARED_LIBS ON)
find_package(Eigen3 REQUIRED)
add_subdirectory(${root} hgp)
get_target_property(eigen hgp::eigen INTERFACE_LINK_LIBRARIES)
get_target_property(kind hgp_base TYPE)
message(STATUS "eigen is \${eigen}, base is \${kind}")
foreach(name hgp figures generate tests_base)
  if(TARGET \${name})
    message(FATAL_ERROR "\${name} is built by a subproject")
  endif()
endforeach()
add_executable(program main.cpp)
target_link_libraries(program PRIVATE hgp::hgp)
`,
    'main.cpp': block('cpp'),
  });
  const build = path.join(source, 'build');
  const printed = run('cmake', '-G', 'Ninja', '-S', source, '-B', build);
  assert.match(printed, /eigen is Eigen3::Eigen, base is SHARED_LIBRARY/);
  assert.ok(!existsSync(path.join(build, 'hgp/lib/cmake')));
  const rules = readFileSync(path.join(build, 'hgp/cmake_install.cmake'), 'utf8');
  assert.doesNotMatch(rules, /file\(INSTALL/);
});

test('missing dependencies are named with their packages', () => {
  const source = project('nothing', {});
  const { status, stderr } = spawnSync(
    'cmake',
    [
      '-G',
      'Ninja',
      '-S',
      root,
      '-B',
      path.join(source, 'build'),
      '-DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON',
      '-DHGP_eigen_DIR=HGP_eigen_DIR-NOTFOUND',
      '-DCMAKE_IGNORE_PATH=/usr/include/eigen3',
    ],
    { encoding: 'utf8' },
  );
  assert.notEqual(status, 0);
  assert.match(stderr, /Eigen 3\.4: Debian libeigen3-dev, Homebrew eigen, vcpkg eigen3/);
});
