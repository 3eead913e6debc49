// What the command line prints for a note, as a pattern: tests name codes, and not words.

import { readCatalogue } from '../../wasm/phrases.mjs';

const catalogue = readCatalogue();
const escape = (text) => text.replace(/[.*+?^${}()|[\]\\]/g, '\\$&');

/**
 * The sentence of a code; places for values stand for any text on one line, optional parts may be absent.
 * @param values  texts of some values, by name
 */
export function sentenceOf(code, values = {}) {
  const template = catalogue.get(code);
  if (template === undefined) throw new Error(`no such code: ${code}`);
  const pattern = template.split(/(\{[^}]*\}|\[[^\]]*\])/).map((part) => {
    if (part.startsWith('[')) return '.*';
    if (!part.startsWith('{')) return escape(part);
    const value = values[/^\{(\w+)/.exec(part)?.[1]];
    return value === undefined ? '.*' : `${escape(String(value))}[^;:,]*?`;
  });
  return new RegExp(pattern.join(''));
}
