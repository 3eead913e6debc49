// node phrases.mjs: writes package/src/lib/core_phrases.ts, the templates of notes that suit every user, from the
// catalogue of the core. Those that name an option of the command line are written by hand in lib/phrases.ts. `npm run
// types` calls it; a test compares.

import { readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import prettier from 'prettier';

const root = path.resolve(import.meta.dirname, '..');
const style = await prettier.resolveConfig(path.join(root, 'package.json'));

/** The sources of the catalogue in core/hgp/base. */
export const catalogueFiles = ['defect_phrases.cpp', 'phrases.cpp', 'map_phrases.cpp'];

/** The catalogue: code → template. */
export function readCatalogue() {
  const source = catalogueFiles
    .map((name) => readFileSync(path.join(root, 'core/hgp/base', name), 'utf8'))
    .join('');
  const entry = /\{"([a-z0-9-]+)",\s*((?:"(?:[^"\\]|\\.)*"\s*)+)\}/g;
  const pieces = /"((?:[^"\\]|\\.)*)"/g;
  return new Map(
    [...source.matchAll(entry)].map(([, code, text]) => [
      code,
      [...text.matchAll(pieces)].map(([, piece]) => JSON.parse(`"${piece}"`)).join(''),
    ]),
  );
}

/** Whether a template names an option of the command line. */
export const isForCommandLine = (template) => /(?:^|[\s(])--?[a-z]/.test(template);

export async function declarePhrases() {
  const shared = [...readCatalogue()].filter(([, template]) => !isForCommandLine(template));
  const text = `// Made from the catalogue in core/hgp/base by wasm/phrases.mjs: the templates of notes that suit every user.

/** @internal */
export const corePhrases = ${JSON.stringify(Object.fromEntries(shared))} as const;
`;
  return prettier.format(text, { ...style, parser: 'typescript' });
}

if (import.meta.filename === process.argv[1])
  writeFileSync(path.join(root, 'wasm/package/src/lib/core_phrases.ts'), await declarePhrases());
