// The entries of the package for CommonJS: each requires the ECMAScript module, so that there is one copy of everything,
// and declares its values in a file that TypeScript takes for CommonJS, which may not import declarations of the other kind.

import { readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';

/** The names of the values that a declaration file exports. */
function valuesOf(text) {
  const own = text.matchAll(/^export declare (?:function|class|const) (\w+)/gm);
  const passedOn = text.matchAll(/^export \{ ([^}]*) \} from/gm);
  const listed = [...passedOn].flatMap(([, list]) => list.split(', '));
  const values = listed.filter((name) => !/^type /.test(name));
  return [...new Set([...[...own].map(([, name]) => name), ...values])]; // overloads are declared once
}

/** The declarations of an entry for CommonJS. */
function declarations(name, values) {
  const mode = `{ with: { 'resolution-mode': 'import' } }`;
  const module = `import('./${name}.js', ${mode})`;
  const lines = values.flatMap((value) => [
    `export declare const ${value}: typeof ${module}.${value};`,
    // The names of classes are types as well.
    ...(/^[A-Z]/.test(value) ? [`export type ${value} = ${module}.${value};`] : []),
  ]);
  const types = `export type * from './${name}.js' with { 'resolution-mode': 'import' };`;
  return `${[types, ...lines].join('\n')}\n`;
}

/** Writes NAME.cjs and NAME.d.cts of all entries that package.json names for `require`. */
export function writeCommonJs(out) {
  const { exports } = JSON.parse(readFileSync(path.join(out, 'package.json'), 'utf8'));
  for (const { node } of Object.values(exports)) {
    if (!node?.require) continue;
    const { require, types } = node;
    const name = path.basename(types, '.d.ts');
    const values = valuesOf(readFileSync(path.join(out, types), 'utf8'));
    writeFileSync(
      path.join(out, require.default),
      `module.exports = require('${node.default}');\n`,
    );
    writeFileSync(path.join(out, require.types), declarations(name, values));
  }
}
