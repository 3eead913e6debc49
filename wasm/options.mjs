// node options.mjs: writes package/src/lib/option_table.ts, the names, types and bounds of options, from the table of the
// core. `npm run types` calls it; a test compares.

import { readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import prettier from 'prettier';

const root = path.resolve(import.meta.dirname, '..');
const style = await prettier.resolveConfig(path.join(root, 'package.json'));

const kinds = {
  kFlag: 'flag',
  kInteger: 'integer',
  kNumber: 'number',
  kText: 'text',
  kWord: 'word',
  kWordOrNumber: 'wordOrNumber',
  kFlagOrNumber: 'flagOrNumber',
  kWords: 'words',
};
/** A bound, where there is one. */
const boundOf = (text) => (/^k/.test(text ?? 'k') ? undefined : Number(text));

/** The tables of core/hgp/api/option_table.cpp by the call: rows with name, flag, keyword, kind, words and bounds. */
export function readTables() {
  const source = readFileSync(path.join(root, 'core/hgp/api/option_table.cpp'), 'utf8');
  const tables = {};
  for (const [, call, body] of source.matchAll(/constexpr std::array k(\w+)Rows\{([^]*?)\n\};/g)) {
    tables[call.toLowerCase()] = [...body.matchAll(/OptionRow\{([^}]*)\}/g)].map(([, row]) => {
      const [name, flag, keyword, kind, words = '""', low, high, isOpen] = row.split(/,\s*/);
      const text = (literal) => JSON.parse(literal);
      return {
        ...{ name: text(name), flag: text(flag), keyword: text(keyword) },
        kind: kinds[kind.replace('K::', '')],
        words: text(words) ? text(words).split('|') : undefined,
        ...{ low: boundOf(low), high: boundOf(high), isOpen: isOpen === 'true' || undefined },
      };
    });
  }
  return tables;
}

export async function declareOptions() {
  const ofPackage = ({ flag: _flag, keyword: _keyword, ...row }) => row;
  const tables = Object.fromEntries(
    Object.entries(readTables()).map(([call, rows]) => [call, rows.map(ofPackage)]),
  );
  const text = `// Made from core/hgp/api/option_table.cpp by wasm/options.mjs: the options that the core reads, by the call.

/**
 * "grid.cells" is \`cells\` of the object \`grid\`; \`isOpen\`: above \`low\`, not equal to it.
 * @internal
 */
export interface OptionRow {
  name: string;
  kind: ${Object.values(kinds)
    .map((kind) => `'${kind}'`)
    .join(' | ')};
  words?: string[];
  low?: number;
  high?: number;
  isOpen?: boolean;
}

/** @internal */
export const optionTable: Record<'${Object.keys(tables).join("' | '")}', OptionRow[]> = ${JSON.stringify(tables)};
`;
  return prettier.format(text, { ...style, parser: 'typescript' });
}

if (import.meta.filename === process.argv[1])
  writeFileSync(path.join(root, 'wasm/package/src/lib/option_table.ts'), await declareOptions());
