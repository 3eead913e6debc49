// Everything that is compiled into the program, the library and the Python module, or linked to them, is in
// THIRD_PARTY_LICENSES.txt, which is installed.

import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import {
  components,
  headersOf,
  librariesOf,
  packagesOf,
  toolchain,
  unlisted,
} from '../support/compiled.mjs';

const root = path.resolve(import.meta.dirname, '../..');
const build = path.join(root, 'build/native-release');
const module = readdirSync(path.join(build, 'python/hgp')).find((name) => name.endsWith('.so'));

test('every header that is compiled into program and library is of a listed work', () => {
  const packages = packagesOf(headersOf(build, /^(core|examples\/cli)\//));
  assert.ok(packages.has('libeigen3-dev') && packages.has('libcli11-dev'), [...packages.keys()]);
  assert.deepEqual(unlisted(packages, ['native']), {});
  assert.deepEqual(unlisted(new Map([...packages, ['libx-dev', 'x.h']]), ['native']), {
    'libx-dev': 'x.h',
  });
});

test('every header that is compiled into the Python module is of a listed work', () => {
  const packages = packagesOf(headersOf(build, /^(core|python)\//));
  assert.ok(packages.has('pybind11-dev'));
  assert.deepEqual(unlisted(packages, ['python']), {});
  assert.ok('pybind11-dev' in unlisted(packages, ['native']));
});

test('every shared library that is linked is of a listed work', () => {
  for (const [file, part] of [
    ['bin/hgp', 'native'],
    [`python/hgp/${module}`, 'python'],
  ]) {
    const listed = components
      .filter(({ parts }) => parts.includes(part))
      .flatMap(({ libraries = [] }) => libraries);
    const needed = librariesOf(path.join(build, file));
    const others = needed.filter((name) => !listed.includes(name));
    const system = /^(libc|libm|libstdc\+\+|libgcc_s|ld-linux-x86-64)\.so\.\d+$/;
    assert.ok(needed.includes('libdraco.so.7'), needed.join());
    assert.deepEqual(
      others.filter((name) => !system.test(name)),
      [],
      file,
    );
  }
});

test('no work is listed for the program that is not in it', () => {
  const packages = packagesOf(headersOf(build, /^(core|examples\/cli)\//));
  for (const { source, parts, name } of components)
    if (parts.includes('native')) assert.ok(packages.has(source.replace('debian:', '')), name);
  for (const name of Object.keys(toolchain)) assert.ok(toolchain[name].length > 10, name);
});

test('the licences are installed', () => {
  const rules = readFileSync(path.join(build, 'cmake_install.cmake'), 'utf8');
  assert.match(rules, /share\/doc\/hgp" TYPE FILE[^)]*\/THIRD_PARTY_LICENSES\.txt"/);
});
