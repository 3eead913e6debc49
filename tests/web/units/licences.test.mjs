// What the page's bundle may contain.

import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { packagesOf, unlisted } from '../../../web/licences.mjs';

const root = path.resolve(import.meta.dirname, '../../..');
const { components } = JSON.parse(
  readFileSync(path.join(root, 'packaging/components.json'), 'utf8'),
);
const ids = [
  '/somewhere/web/src/main.ts',
  '/somewhere/node_modules/three/build/three.core.js',
  '/somewhere/node_modules/a/node_modules/@lit/reactive-element/decorators.js',
  '\0vite/preload-helper.js',
];

test('the package of a module is the innermost one, with its scope', () => {
  assert.deepEqual([...packagesOf(ids)].sort(), ['@lit/reactive-element', 'three', 'vite']);
});

test('a package that is bundled and not listed is named', () => {
  assert.deepEqual(unlisted(ids, components), []);
  const more = [...ids, '/x/node_modules/left-pad/index.js', '/x/node_modules/@z/y/index.js'];
  assert.deepEqual(unlisted(more, components), ['@z/y', 'left-pad']);
  const others = components.filter(({ source }) => source !== 'npm:three');
  assert.deepEqual(unlisted(ids, others), ['three']);
});

test('every npm package that is listed is one that is installed', () => {
  for (const { source, name } of components)
    if (source.startsWith('npm:'))
      assert.ok(existsSync(path.join(root, 'node_modules', source.slice(4))), name);
});
