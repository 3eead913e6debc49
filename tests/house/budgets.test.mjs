// Files stay small enough to be read in one sitting. A file that must be longer says why:
// `// budget: reason`.

import assert from 'node:assert/strict';
import test from 'node:test';
import { filesOf, textOf } from './source_tree.mjs';

/** Whether a file is not made from others. */
const isWritten = (file) => !textOf(file).startsWith('// Made from');

const limits = [
  { what: 'headers', files: filesOf('core/hgp', '.h'), lines: 120 },
  { what: 'sources', files: filesOf('core/hgp', '.cpp'), lines: 350 },
  { what: 'the command line tool', files: filesOf('examples', '.h', '.cpp'), lines: 350 },
  { what: 'the bindings', files: filesOf('wasm', 'bindings.cpp'), lines: 150 },
  { what: 'the bindings of Python', files: filesOf('python/src', '.h', '.cpp'), lines: 350 },
  { what: 'the page', files: filesOf('web', '.ts'), lines: 350 },
  { what: 'the package', files: filesOf('wasm/package/src', '.ts').filter(isWritten), lines: 350 },
];

const lineCount = (text) => text.replace(/\n$/, '').split('\n').length;

for (const { what, files, lines } of limits) {
  test(`${what}: at most ${lines} lines a file`, () => {
    const over = files
      .map((file) => ({ file, text: textOf(file) }))
      .filter(({ text }) => lineCount(text) > lines && !/^\s*(\/\/|#) budget: \S/m.test(text))
      .map(({ file, text }) => `${file}: ${lineCount(text)} lines`);
    assert.deepEqual(over, []);
  });
}

/** Functions at namespace level longer than 50 lines; relies on clang-format's closing braces. */
function longFunctions(file) {
  const found = [];
  let begin = -1;
  textOf(file)
    .split('\n')
    .forEach((line, index) => {
      if (/^[A-Za-z~].*\(/.test(line)) begin = index;
      if (/^(namespace|struct|class|enum|union)\b/.test(line)) begin = -1;
      if (line.startsWith('}') && begin >= 0) {
        if (index - begin + 1 > 50) found.push(`${file}:${begin + 1}: ${index - begin + 1} lines`);
        begin = -1;
      }
    });
  return found;
}

test('functions have at most 50 lines', () => {
  assert.deepEqual(filesOf('core/hgp', '.cpp').flatMap(longFunctions), []);
});

test('no file or folder is named utils, common, helpers, details or misc', () => {
  const names = /(^|\/)(utils?|commons?|helpers?|details?|misc)(\.|\/|$)/;
  const wrong = filesOf('.', '').filter((file) => names.test(file));
  assert.deepEqual(wrong, []);
});
