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

/** Where the libraries are that the installed archives need; they are hidden from find_library. */
const withoutLibraries = [
  '-DCMAKE_IGNORE_PATH=/usr/lib/x86_64-linux-gnu;/lib/x86_64-linux-gnu;/usr/lib;/lib',
];

test('hgp::core is found and linked without any library of file formats', () => {
  const build = path.join(folder, 'example');
  const source = path.join(here, 'example');
  const settings = [`-DCMAKE_PREFIX_PATH=${prefix}`, ...withoutLibraries];
  run('cmake', '-G', 'Ninja', '-S', source, '-B', build, ...settings);
  run('cmake', '--build', build);
  assert.match(run(path.join(build, 'example')), /^certified: yes$/m);
  assert.doesNotMatch(run('ldd', path.join(build, 'example')), /draco|meshopt/);
});

test('find_package asks for what the archives need, and for nothing that no header includes', () => {
  const [targets] = installed(/hgpTargets\.cmake$/);
  const named = readFileSync(path.join(prefix, targets), 'utf8').match(/hgp::\w+/g);
  const strangers = ['json', 'tinygltf', 'fast_float', 'cli11', 'cholmod', 'metis', 'zlib'];
  for (const name of strangers) assert.ok(!named.includes(`hgp::${name}`), name);
  const source = project('strict', { 'CMakeLists.txt': block('cmake'), 'main.cpp': block('cpp') });
  const configure = (...more) =>
    spawnSync(
      'cmake',
      [
        ...['-G', 'Ninja', '-S', source, '-B', path.join(source, `build${more.length}`)],
        `-DCMAKE_PREFIX_PATH=${prefix}`,
        ...more,
      ],
      { encoding: 'utf8' },
    );
  const found = configure();
  assert.equal(found.status, 0, found.stderr);
  assert.doesNotMatch(found.stdout, /third party/);
  if (!named.includes('hgp::draco')) return;
  const missing = configure(...withoutLibraries);
  assert.notEqual(missing.status, 0);
  assert.match(missing.stderr, /hgp needs:\s+Draco 1\.5: Debian libdraco-dev/);
  assert.doesNotMatch(missing.stderr, /nlohmann|tinygltf/);
});

test('no installed file for build systems has a path of the machine that built it', () => {
  for (const name of installed(/\.(cmake|pc)$/)) {
    const text = readFileSync(path.join(prefix, name), 'utf8');
    assert.ok(!text.includes(root), name);
    assert.doesNotMatch(text, /lib\w+\.(a|so)\b.*\/usr\/|\/usr\/lib\/x86/, name);
  }
});

test('a program may have a tinygltf of its own', () => {
  const source = project('two', {
    'CMakeLists.txt': block('cmake'),
    'main.cpp': `#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#include <tiny_gltf.h>
#include <hgp/api/session.h>
#include <cstdio>
int main() {
  tinygltf::TinyGLTF loader;
  tinygltf::Model model;
  std::string errors, warnings;
  const std::string text = R"({"asset":{"version":"2.0"}})";
  const bool isRead = loader.LoadASCIIFromString(&model, &errors, &warnings, text.data(), text.size(), "");
  hgp::io::FileSet files;
  files.name = "a.gltf";
  files.main.assign(text.begin(), text.end());
  hgp::api::Session session;
  std::printf("%d %s\\n", isRead, session.load(std::move(files), {}).error().message.c_str());
}
`,
  });
  const build = path.join(source, 'build');
  run('cmake', '-G', 'Ninja', '-S', source, '-B', build, `-DCMAKE_PREFIX_PATH=${prefix}`);
  run('cmake', '--build', build);
  assert.match(run(path.join(build, 'your_program')), /^1 .*no mesh/);
});

test('an incomplete build is not installed: what to build is said before anything is copied', () => {
  const build = path.join(root, 'build/native-release');
  const check = readFileSync(path.join(build, 'hgp_is_built-Release.cmake'), 'utf8');
  const rules = readFileSync(path.join(build, 'cmake_install.cmake'), 'utf8');
  assert.ok(rules.indexOf('hgp_is_built') < rules.indexOf('file(INSTALL'));
  const source = project('incomplete', {
    'whole.cmake': check,
    'part.cmake': check.replace('libhgp_api.a', 'libhgp_none.a').replace('hgp.1', 'none.1'),
  });
  run('cmake', '-P', path.join(source, 'whole.cmake'));
  const part = spawnSync('cmake', ['-P', path.join(source, 'part.cmake')], { encoding: 'utf8' });
  assert.notEqual(part.status, 0);
  assert.match(part.stderr, /nothing is installed; missing:\s+libhgp_none\.a\s+none\.1/);
  assert.match(part.stderr, /cmake --build\s+\S+\s+--target\s+hgp_installed/);
});

test('of a build of which nothing is made, cmake --install copies nothing and says what to build', () => {
  const build = path.join(folder, 'unmade');
  const parts = ['TESTS', 'BENCH', 'PYTHON'].map((part) => `-DHGP_${part}=OFF`);
  run('cmake', '-G', 'Ninja', '-S', root, '-B', build, '-DCMAKE_BUILD_TYPE=Release', ...parts);
  const to = path.join(folder, 'nothing');
  const { status, stderr } = spawnSync('cmake', ['--install', build, '--prefix', to], {
    encoding: 'utf8',
  });
  assert.notEqual(status, 0);
  assert.match(stderr, /nothing is installed; missing:/);
  assert.match(stderr, /libhgp_\w+\.a/);
  assert.match(stderr, /cmake --build\s+\S+\s+--target\s+hgp_installed/);
  assert.ok(!existsSync(to));
});

test('pkg-config gives the flags that a program needs', () => {
  const [pc] = installed(/hgp\.pc$/);
  const env = { ...process.env, PKG_CONFIG_PATH: path.dirname(path.join(prefix, pc)) };
  const flags = execFileSync('pkg-config', ['--static', '--cflags', '--libs', 'hgp'], {
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
  const hidden =
    /linalg|socp|io\/(?!(document|written|polygons|placements)\.h)|_impl\.h|json_values/;
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
    'share/zsh/vendor-completions/_hgp',
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
