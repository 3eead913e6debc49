// One name, one type: two types of the same name in one namespace are one to the linker, which keeps the functions of
// either. A build in which these were not inlined read beyond its memory.

import assert from 'node:assert/strict';
import test from 'node:test';
import { filesOf, textOf } from './source_tree.mjs';

/** The types that a file defines at namespace level, outside unnamed namespaces, each as "namespace::name". */
function typesIn(file) {
  const found = [];
  let space = '';
  let isUnnamed = false;
  for (const line of textOf(file).split('\n')) {
    const named = line.match(/^namespace ([\w:]+) \{/);
    if (named) space = named[1];
    if (/^namespace \{/.test(line)) isUnnamed = true;
    if (/^\} {2}\/\/ namespace$/.test(line)) isUnnamed = false;
    const type = line.match(/^(?:struct|class|enum class) (\w+)(?: final)?(?: :.*)? \{/);
    if (type && !isUnnamed) found.push(`${space}::${type[1]}`);
  }
  return found;
}

test('no two types have the same name in the same namespace', () => {
  const files = filesOf('core/hgp', '.h', '.cpp');
  const places = new Map();
  for (const file of files)
    for (const type of typesIn(file)) places.set(type, [...(places.get(type) ?? []), file]);
  assert.ok(places.size > 300, `only ${places.size} types were found`);
  const twice = [...places].filter(([, where]) => where.length > 1);
  assert.deepEqual(twice, []);
});
