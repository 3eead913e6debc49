// What users are told is a code with numbers (docs/notes.md): the core's catalogue, its callers, the documentation and
// the package agree on the codes, and nobody recognises a sentence.

import assert from 'node:assert/strict';
import test from 'node:test';
import {
  catalogueFiles,
  declarePhrases,
  isForCommandLine,
  readCatalogue,
} from '../../wasm/phrases.mjs';
import { filesOf, textOf } from './source_tree.mjs';

const catalogue = readCatalogue();
const codes = [...catalogue.keys()];
const join = (files) => files.map(textOf).join('\n');
const isQuoted = (text, code) => text.includes(`'${code}'`) || text.includes(`"${code}"`);

/** Sources that make notes. */
const makers = join(
  [
    ...filesOf('core/hgp', '.cpp', '.h'),
    ...filesOf('examples/cli', '.cpp'),
    ...filesOf('python/src', '.cpp'),
    ...filesOf('wasm/package/src', '.ts'),
  ].filter((file) => !/phrases\.(?:cpp|ts)$/.test(file)),
);

test('the catalogue is read whole', () => {
  const entries = catalogueFiles
    .map((name) => textOf(`core/hgp/base/${name}`))
    .join('')
    .match(/^ {4}\{"/gm);
  assert.equal(codes.length, entries.length);
  assert.ok(codes.length > 100);
});

test('every code of the catalogue is made somewhere, and every code that is made is in it', () => {
  const ofDefects = (code) => code.startsWith('defect-') && isQuoted(makers, code.slice(7));
  assert.deepEqual(
    codes.filter((code) => !isQuoted(makers, code) && !ofDefects(code)),
    [],
  );
  const made = [...makers.matchAll(/\bNote\("([a-z0-9-]+)"|notes\.emplace_back\("([a-z0-9-]+)"/g)];
  assert.ok(made.length > 70);
  const known = new Set(codes);
  assert.deepEqual(
    made.map(([, a, b]) => a ?? b).filter((code) => !known.has(code)),
    [],
  );
});

/** The fixed parts of a template, in order: between them, values and optional parts stand for any text. */
const partsOf = (template) => template.split(/\{[^}]*\}|\[[^\]]*\]/);

/** Whether the parts occur in the sentence in their order. */
function isMadeBy(template, sentence) {
  let at = 0;
  for (const part of partsOf(template)) {
    const found = sentence.indexOf(part, at);
    if (found < 0) return false;
    at = found + part.length;
  }
  return true;
}

test('docs/notes.md has a row for every code with its values and a sentence that the template makes', () => {
  const rows = textOf('docs/notes.md').matchAll(/^\| `([a-z0-9-]+)` \|([^|]*)\| (.*) \|$/gm);
  const table = new Map([...rows].map(([, code, values, example]) => [code, { values, example }]));
  assert.deepEqual([...table.keys()].sort(), [...codes].sort());
  for (const [code, template] of catalogue) {
    const { values, example } = table.get(code);
    const named = [...template.matchAll(/\{([^}@:|#]+)|\[!?([^:\]]+):/g)].map(([, a, b]) => a ?? b);
    const listed = [...values.matchAll(/`(\w+)`/g)].map(([, name]) => name);
    assert.deepEqual([...new Set(listed)].sort(), [...new Set(named)].sort(), code);
    assert.ok(isMadeBy(template, example), `${code}: ${example}`);
  }
});

test('the package has a sentence for every code, and none names an option of the command line', async () => {
  assert.equal(textOf('wasm/package/src/lib/core_phrases.ts'), await declarePhrases());
  const own = textOf('wasm/package/src/lib/phrases.ts');
  for (const [code, template] of catalogue) {
    if (!isForCommandLine(template)) continue;
    assert.ok(own.includes(`'${code}':`) || own.includes(`  ${code}:`), code);
  }
  for (const file of ['core_phrases', 'phrases'].map((name) => `wasm/package/src/lib/${name}.ts`))
    assert.doesNotMatch(
      textOf(file).replace(/^\s*(?:\/\/|\*|\/\*).*$/gm, ''),
      /[\s(]--[a-z]/,
      file,
    );
});

/** Words of a template that stand together: what a program would look for to recognise the sentence. */
const wordsOf = (template) =>
  template
    .split(/\{[^}]*\}|\[[^\]]*\]|[;:,.()]/)
    .map((part) => part.trim())
    .filter((part) => part.split(' ').length >= 4);

test('no code of the page, the package or the tests recognises a sentence of the core', () => {
  const isPhrasing =
    /phrases\.ts$|text\/(?:notes|repairs)\.ts$|phrase_test\.cpp$|house\/notes\.test\.mjs$|units\/notes\.test\.mjs$/;
  const files = [
    ...filesOf('web/src', '.ts'),
    ...filesOf('wasm', '.ts', '.mjs', '.cpp', '.h'),
    ...filesOf('tests', '.mjs', '.cpp', '.h', '.py'),
  ].filter((file) => !isPhrasing.test(file));
  const found = [];
  for (const file of files) {
    const text = textOf(file).replace(/^\s*(?:\/\/|\*|\/\*).*$/gm, '');
    for (const [code, template] of catalogue)
      for (const words of wordsOf(template))
        if (text.includes(words)) found.push(`${file}: ${code}: ${words}`);
  }
  assert.deepEqual(found, []);
});
