// The checkout holds sources and nothing of the machine it was written on.

import assert from 'node:assert/strict';
import test from 'node:test';
import { filesOf, textOf } from './source_tree.mjs';

const endings =
  '.h .cpp .mjs .js .ts .md .txt .cmake .json .py .pyi .toml .yml scripts/release packaging/elsewhere';
const texts = filesOf('.', ...endings.split(' '));

test('no path of a particular machine', () => {
  const path = new RegExp(`(^|[\\s"'=(])/${'(work|home|root)'}/[a-z]`, 'm');
  assert.deepEqual(
    texts.filter((file) => path.test(textOf(file))),
    [],
  );
});

test('nothing that a program has made from sources is kept', () => {
  assert.deepEqual(filesOf('.', '.pyc', '.o', '.so', '.whl', '.deb', '.tgz'), []);
});

test('the lock file holds no download addresses', () => {
  const lock = JSON.parse(textOf('package-lock.json'));
  const withAddress = Object.entries(lock.packages).filter(([, entry]) => entry.resolved);
  assert.deepEqual(withAddress, []);
});

test('sources say `#pragma once` and end with a line break', () => {
  const wrong = filesOf('core', '.h').filter(
    (file) => !/^#pragma once$/m.test(textOf(file)) || !textOf(file).endsWith('}\n'),
  );
  assert.deepEqual(
    wrong.filter((file) => !textOf(file).includes('}  // namespace')),
    [],
  );
});

test('every JSON schema has an absolute identifier, in which its name is', () => {
  for (const file of filesOf('docs/schema', '.json'))
    assert.equal(
      new URL(JSON.parse(textOf(file)).$id).pathname.split('/').at(-1),
      file.split('/').at(-1),
    );
});
