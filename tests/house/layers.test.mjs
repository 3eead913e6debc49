// The directions in which modules may include one another. This table is the law; a change of it is a
// change of the design and wants a page in docs/decisions.

import assert from 'node:assert/strict';
import test from 'node:test';
import { filesOf, moduleOf, textOf } from './source_tree.mjs';

// The judge shares no code with the judged: verify sees mesh and base and nothing else.
// io speaks of meshes and prescriptions and nothing else; only api, the API boundary, sees everything.
const mayInclude = {
  base: [],
  linalg: ['base'],
  mesh: ['base'],
  verify: ['mesh', 'base'],
  text: ['base'],
  prescription: ['text', 'mesh', 'base'],
  io: ['prescription', 'text', 'mesh', 'base'],
  field: ['linalg', 'mesh', 'base'],
  cut: ['field', 'linalg', 'mesh', 'base'],
  system: ['cut', 'field', 'linalg', 'mesh', 'base'],
  socp: ['linalg', 'base'],
  optimize: ['system', 'cut', 'field', 'socp', 'linalg', 'mesh', 'base'],
  grid: ['verify', 'socp', 'linalg', 'mesh', 'base'],
};
mayInclude.improve = ['optimize', ...mayInclude.optimize, 'verify'];
mayInclude.parametrize = [...new Set([...Object.keys(mayInclude), 'verify'])].filter(
  (module) => !['io', 'prescription', 'text'].includes(module),
);
mayInclude.api = [...Object.keys(mayInclude)];
// Headers of the library as a whole, beside the modules; no sources.
mayInclude.hgp = [...Object.keys(mayInclude)];

const sources = filesOf('core/hgp', '.h', '.cpp', '.inc');

/** Modules that a source file includes, with the line that does it. */
function includedModules(file) {
  return [...textOf(file).matchAll(/^\s*#\s*include\s+["<](hgp\/[^">]+)[">]/gm)].map(
    ([line, header]) => ({ line: line.trim(), module: moduleOf(`core/${header}`) }),
  );
}

test('every folder of core/hgp is a module of the plan', () => {
  const unknown = sources.filter((file) => !(moduleOf(file) in mayInclude));
  assert.deepEqual(unknown, []);
});

test('what lies beside the modules is headers for programs', () => {
  const beside = sources.filter((file) => moduleOf(file) === 'hgp');
  assert.deepEqual(
    beside.filter((file) => !file.endsWith('.h')),
    [],
  );
});

for (const [module, allowed] of Object.entries(mayInclude)) {
  test(`${module} includes only ${allowed.join(', ') || 'itself'}`, () => {
    const wrong = [];
    for (const file of sources.filter((name) => moduleOf(name) === module)) {
      for (const { line, module: other } of includedModules(file)) {
        if (other !== module && !allowed.includes(other)) wrong.push(`${file}: ${line}`);
      }
    }
    assert.deepEqual(wrong, []);
  });
}

test('targets link only what their module may include', () => {
  const wrong = [];
  for (const file of filesOf('core/hgp', 'CMakeLists.txt')) {
    const text = textOf(file).replace(/#.*/g, '');
    for (const [, body] of text.matchAll(/hgp_module\(([^)]*)\)/g)) {
      const words = body.split(/\s+/).filter(Boolean);
      const module = words[words.indexOf('NAME') + 1];
      assert.ok(module in mayInclude, `${file}: unknown module ${module}`);
      let inLinks = false;
      for (const word of words) {
        if (/^[A-Z_]+$/.test(word)) inLinks = word.endsWith('LINKS');
        else if (inLinks && word in mayInclude && !mayInclude[module].includes(word)) {
          wrong.push(`${module} links ${word}`);
        }
      }
    }
  }
  assert.deepEqual(wrong, []);
});

test('only io reads files of other formats through tinygltf', () => {
  const users = sources.filter((file) => /#\s*include\s+[<"]tiny_gltf\.h/.test(textOf(file)));
  assert.deepEqual(
    users.filter((file) => moduleOf(file) !== 'io'),
    [],
  );
});

test('the core knows no file system and no console', () => {
  const wrong = sources.filter((file) =>
    /#\s*include\s+<(iostream|filesystem|fstream)>/.test(textOf(file)),
  );
  // tinygltf without its file system still needs <fstream> to be seen before it.
  const excused = (file) => /tiny_gltf\.h/.test(textOf(file)) && !/<iostream>/.test(textOf(file));
  assert.deepEqual(
    wrong.filter((file) => !excused(file)),
    [],
  );
});

test('the page imports the package and never the sources', () => {
  const wrong = [];
  for (const file of filesOf('web', '.ts', '.js', '.mjs')) {
    for (const [, from] of textOf(file).matchAll(/\bfrom\s+['"]([^'"]+)['"]/g)) {
      if (/(^|\/)(core\/hgp|wasm\/(?!package))/.test(from)) wrong.push(`${file}: ${from}`);
    }
  }
  assert.deepEqual(wrong, []);
});
