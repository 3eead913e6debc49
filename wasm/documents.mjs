// node documents.mjs: writes package/src/lib/documents.ts, the TypeScript of the JSON documents, from the
// schemas that the command line follows as well. `npm run types` calls it; a test compares.

import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { compile } from 'json-schema-to-typescript';
import prettier from 'prettier';

const names = {
  'hgp-certificate.schema.json': 'Certificate',
  'hgp-check.schema.json': 'CheckReport',
  'hgp-cones.schema.json': 'ConesDocument',
  'hgp-error.schema.json': 'Failure',
  'hgp-file.schema.json': 'FileReport',
  'hgp-inspect.schema.json': 'ModelInfo',
  'hgp-report.schema.json': 'Report',
};
const nameOf = (file) => names[file] ?? file.replace(/\W+(\w)/g, (_, c) => c.toUpperCase());

/** A definition of a schema as a schema of its own. */
const withDefinitions = ({ $defs }, name) => {
  const { [name]: one, ...others } = $defs;
  return { ...one, $defs: others };
};

/** One declaration per schema in the folder, and Where and Note, which several of them use. */
export async function declareDocuments(folder) {
  const declare = (schema, name) =>
    compile(schema, name, {
      additionalProperties: false,
      bannerComment: '',
      cwd: folder + path.sep,
      customName: ({ $id }) => ($id ? nameOf(path.basename($id)) : undefined),
      declareExternallyReferenced: false,
      format: false,
    });
  const read = (file) => JSON.parse(readFileSync(path.join(folder, file), 'utf8'));
  const parts = [
    '// Made from schema/*.schema.json by wasm/documents.mjs: the JSON documents of calls and files.\n',
    await declare(read('hgp-error.schema.json').$defs.where, 'Where'),
    await declare(withDefinitions(read('hgp-error.schema.json'), 'note'), 'Note'),
    await declare(withDefinitions(read('hgp-check.schema.json'), 'error'), 'Refusal'),
  ];
  for (const file of readdirSync(folder).sort()) {
    parts.push(await declare(read(file), nameOf(file)));
  }
  // The name of the definition is also that of a global of JavaScript.
  const text = parts.join('\n').replace(/\berror\?: Error\b/g, 'error?: Refusal');
  return prettier.format(text, { ...style, parser: 'typescript' });
}

const root = path.resolve(import.meta.dirname, '..');
const style = await prettier.resolveConfig(path.join(root, 'package.json'));

if (import.meta.filename === process.argv[1]) {
  const text = await declareDocuments(path.join(root, 'docs/schema'));
  writeFileSync(path.join(root, 'wasm/package/src/lib/documents.ts'), text);
}
