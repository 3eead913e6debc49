// docs/paper-map.md leads from each equation of [BCW17] to the function that implements it and to the
// test that holds it to account. Written as `core/hgp/cut/cut_mesh.h:cutToDisk` and
// `tests/core/cut/cut_mesh_test.cpp:CutMesh.IsADisk`; these tests keep it from going stale.

import assert from 'node:assert/strict';
import path from 'node:path';
import test from 'node:test';
import { exists, filesOf, textOf } from './source_tree.mjs';

const map = exists('docs/paper-map.md') ? textOf('docs/paper-map.md') : '';
const references = [
  ...map.matchAll(
    /\b((?:core|wasm|examples|tests)\/[\w./-]+\.(?:h|cpp|mjs|js))(?::([A-Za-z_][\w.]*))?/g,
  ),
].map(([, file, name]) => ({ file, name: name?.replace(/\.$/, '') }));

test('the map exists and names code and tests', () => {
  assert.ok(references.some(({ file }) => file.startsWith('core/')));
  assert.ok(references.some(({ file }) => file.startsWith('tests/')));
});

/** Whether C++ or JavaScript text declares or defines a name: uses, includes and comments do not count. */
function declares(text, name) {
  const code = text
    .replace(/\/\*[^]*?\*\//g, '')
    .replace(/\/\/.*$/gm, '')
    .replace(/^#include.*$/gm, '');
  const type = new RegExp(`\\b(?:struct|class|enum class|enum|using|concept)\\s+${name}\\b`);
  const callable = new RegExp(
    `^(?!\\s*(?:return|else|throw|co_return)\\b)[ \\t]*[\\w:<>,&*\\[\\] ]*[\\w>&*][ \\n]+[&*]*(?:\\w+::)*${name}\\s*\\(`,
    'm',
  );
  const value = new RegExp(
    `\\b(?:const|constexpr|let|var|function)\\b[^;=(]*\\b${name}\\b\\s*[=({;]`,
  );
  return type.test(code) || callable.test(code) || value.test(code);
}

test('what counts as a declaration', () => {
  assert.ok(declares('static Result<std::vector<int>>\nsolve(int a);', 'solve'));
  assert.ok(declares('  double& at(int);\nstruct State {};', 'State'));
  assert.ok(declares('export function makeCut(a) {}', 'makeCut'));
  assert.ok(!declares('#include "hgp/parametrize/a.h"\n// parametrize (x)\n', 'parametrize'));
  assert.ok(!declares('  return parametrize(mesh, 2);\n', 'parametrize'));
});

test('every function listed exists', () => {
  const wrong = references
    .filter(({ file }) => !file.startsWith('tests/'))
    .filter(({ file, name }) => {
      if (!exists(file)) return true;
      return name !== undefined && !declares(textOf(file), name.split('.').pop());
    });
  assert.deepEqual(wrong, []);
});

test('every test listed exists', () => {
  const wrong = references
    .filter(({ file }) => file.startsWith('tests/'))
    .filter(({ file, name }) => {
      if (!exists(file)) return true;
      if (name === undefined) return false;
      const [suite, law] = name.split('.');
      const text = textOf(file);
      if (law === undefined) return !text.includes(suite);
      return !new RegExp(`TEST(_F|_P)?\\(\\s*${suite},\\s*${law}\\s*\\)`).test(text);
    });
  assert.deepEqual(wrong, []);
});

test('every equation cited in the code is on the map', () => {
  const missing = new Set();
  for (const file of filesOf('core/hgp', '.h', '.cpp')) {
    for (const [, cited] of textOf(file).matchAll(/\[BCW17 ([^\]]+)\]/g)) {
      for (const [equation] of cited.matchAll(/\(\d+\)/g)) {
        if (!map.includes(equation)) missing.add(`${equation} in ${file}`);
      }
    }
  }
  assert.deepEqual([...missing], []);
});

test('decisions are numbered without gaps', () => {
  const numbers = filesOf('docs/decisions', '.md')
    .map((file) => Number(file.match(/\/(\d{3})-[^/]*$/)?.[1]))
    .filter((number) => !Number.isNaN(number));
  assert.ok(numbers.length > 0);
  assert.deepEqual(
    numbers.sort((a, b) => a - b),
    numbers.map((_, index) => index + 1),
  );
});

test('decisions follow the template: number, title, status, context, decision', () => {
  const parts = [
    /^# \d{3} · \S/,
    /^\*\*Status:\*\* /m,
    /^\*\*Context\.\*\* /m,
    /^\*\*Decision\.\*\*/m,
  ];
  const wrong = filesOf('docs/decisions', '.md')
    .filter((file) => !file.endsWith('README.md'))
    .filter((file) => !parts.every((part) => part.test(textOf(file))));
  assert.deepEqual(wrong, []);
});

test('the index of decisions has every page once, with its title, and says which are out of force', () => {
  const index = textOf('docs/decisions/README.md');
  const listed = [...index.matchAll(/^- \[(\d{3})\]\(([^)]+)\) (.*(?:\n {2}.*)*)/gm)].map(
    ([line, number, file, title]) => ({ line, number, file, title: title.replace(/\s+/g, ' ') }),
  );
  const pages = filesOf('docs/decisions', '.md').filter((file) => !file.endsWith('README.md'));
  assert.deepEqual(
    listed.map(({ file }) => file).sort(),
    pages.map((file) => path.basename(file)).sort(),
  );
  const wrong = [];
  for (const { number, file, title, line } of listed) {
    const text = textOf(`docs/decisions/${file}`);
    const own = text.match(/^# (\d{3}) · (.*)/);
    if (own?.[1] !== number || !title.startsWith(own[2])) wrong.push(`${file}: ${own?.[2]}`);
    const isReplaced = /^\*\*Status:\*\* [Rr]eplaced by/m.test(text);
    const isOut = index.indexOf(line) > index.indexOf('## No longer in force');
    if (isReplaced !== isOut) wrong.push(`${file}: ${isReplaced ? '' : 'not '}replaced`);
  }
  assert.deepEqual(wrong, []);
});
