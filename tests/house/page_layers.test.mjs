// The directions in which the folders of the page may import one another, and that no file imports
// itself by a detour. The table is the law, as layers.test.mjs is for the core.

import assert from 'node:assert/strict';
import path from 'node:path';
import test from 'node:test';
import { exists, filesOf, textOf } from './source_tree.mjs';

const mayImport = {
  model: [],
  formats: ['model'],
  text: ['model', 'formats'],
  services: ['model', 'formats', 'text'],
  views: ['model', 'formats', 'text', 'services'],
  actions: ['model', 'formats', 'text', 'services', 'views'],
  input: ['model', 'formats', 'text', 'services', 'views', 'actions'],
  panels: ['model', 'formats', 'text', 'services', 'views', 'actions', 'styles'],
};
const folders = 'web/src';
const sources = filesOf(folders, '.ts').filter((file) => !file.endsWith('.d.ts'));
const folderOf = (file) => file.match(/^web\/src\/([^/]+)\//)?.[1];

/** Files of the page that a file imports: from any import, type or not, static or not. */
function importsOf(file) {
  const found = [];
  for (const [, from] of textOf(file).matchAll(/\b(?:from|import)\s*\(?\s*['"](\.[^'"]+)['"]/g)) {
    const plain = path.posix.join(path.posix.dirname(file), from.replace(/\?.*$/, ''));
    found.push(exists(`${plain}.ts`) ? `${plain}.ts` : plain);
  }
  return found;
}

test('every folder of web/src is in the table, and every file except main.ts is in a folder', () => {
  const wrong = sources.filter((file) => !(folderOf(file) in mayImport));
  assert.deepEqual(wrong, ['web/src/main.ts']);
});

for (const [folder, allowed] of Object.entries(mayImport)) {
  test(`${folder} imports only ${allowed.join(', ') || 'itself'}`, () => {
    const wrong = [];
    for (const file of sources.filter((one) => folderOf(one) === folder)) {
      for (const other of importsOf(file)) {
        const to = folderOf(other);
        if (to !== folder && !allowed.includes(to)) wrong.push(`${file}: ${other}`);
      }
    }
    assert.deepEqual(wrong, []);
  });
}

test('no import cycles, not of types either', () => {
  const done = new Set();
  const circles = [];
  const visit = (file, above) => {
    if (above.includes(file)) circles.push([...above.slice(above.indexOf(file)), file].join(' → '));
    if (done.has(file) || above.includes(file)) return;
    for (const other of importsOf(file))
      if (sources.includes(other)) visit(other, [...above, file]);
    done.add(file);
  };
  for (const file of sources) visit(file, []);
  assert.deepEqual(circles, []);
});

/** The geometry worker, a script of its own, makes trees for picking; nothing else outside of the views has three.js. */
const withThree = ['web/src/services/geometry_worker.ts'];

test('only panels draw with lit, only views with three; text is never put in as HTML', () => {
  const wrong = [];
  for (const file of sources) {
    const text = textOf(file);
    if (/from 'lit/.test(text) && folderOf(file) !== 'panels') wrong.push(`${file}: lit`);
    const hasThree = /\b(?:from|import)\s*\(?\s*'three/.test(text.replace(/^import type.*$/gm, ''));
    if (hasThree && folderOf(file) !== 'views' && !withThree.includes(file))
      wrong.push(`${file}: three`);
    if (/innerHTML|unsafeHTML|insertAdjacentHTML/.test(text)) wrong.push(`${file}: HTML`);
  }
  assert.deepEqual(wrong, []);
});

test('only actions write the document: views, panels and input have it in a type whose members are readonly', () => {
  const readers = sources.filter((file) => ['views', 'panels', 'input'].includes(folderOf(file)));
  const named = readers.filter((file) =>
    /\bimport\b[^;]*\b(?:App|Document|OpenDocument)\b[^;]*\bfrom\b/.test(textOf(file)),
  );
  assert.deepEqual(named, []);
  assert.match(textOf('web/src/panels/panel.ts'), /declare app: AppView;/);
  assert.match(textOf('web/src/model/document.ts'), /ReadonlyDocument = Readonly<OpenDocument>/);
});
