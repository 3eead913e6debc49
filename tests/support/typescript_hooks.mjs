// The hooks of typescript.mjs; they run in Node's loader thread.

import { existsSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import ts from 'typescript';

const options = {
  ...{ target: ts.ScriptTarget.ES2022, module: ts.ModuleKind.ESNext },
  ...{ verbatimModuleSyntax: false, inlineSourceMap: true, inlineSources: true },
};
const builtPackage = new URL('../../build/package/', import.meta.url);

/** The file to which the page's bundler would resolve `specifier`, or undefined if Node resolves it itself. */
function sourceOf(specifier, parent) {
  // The address of a worker, which no test under Node starts.
  if (specifier.endsWith('?worker&url')) return new URL('data:text/javascript,export default ""');
  if (specifier === 'hgp') return new URL('index.js', builtPackage);
  if (specifier === 'hgp/gzip') return new URL('gzip.js', builtPackage);
  if (!/^\.{1,2}\//.test(specifier) || !parent?.endsWith('.ts')) return undefined;
  const url = new URL(`${specifier}.ts`, parent);
  return existsSync(fileURLToPath(url)) ? url : undefined;
}

export function resolve(specifier, context, next) {
  const url = sourceOf(specifier, context.parentURL);
  return url ? { url: url.href, shortCircuit: true } : next(specifier, context);
}

export function load(url, context, next) {
  if (!url.startsWith('file:') || !url.endsWith('.ts')) return next(url, context);
  const fileName = fileURLToPath(url);
  const text = readFileSync(fileName, 'utf8');
  const { outputText } = ts.transpileModule(text, { fileName, compilerOptions: options });
  return { format: 'module', source: outputText, shortCircuit: true };
}
