// The hooks of fault.mjs; they run in Node's loader thread.

import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { scriptOf } from './typescript_hooks.mjs';

const root = new URL('../../', import.meta.url);
const file = process.env.HGP_FAULT_FILE;
/** The script of the built package that was made of the source. */
const place = new URL(file.replace(/^wasm\/package\/src\/(.*)\.ts$/, 'build/package/$1.js'), root);

export async function load(url, context, next) {
  if (url.replace(/\?.*$/, '') !== place.href) return next(url, context);
  const text = readFileSync(process.env.HGP_FAULT_TEXT, 'utf8');
  const source = await scriptOf(fileURLToPath(new URL(file, root)), text);
  return { format: 'module', source, shortCircuit: true };
}
