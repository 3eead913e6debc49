// The hooks of typescript.mjs; they run in Node's loader thread.

import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

/** Scripts by the hash of what they were made of, as starting the compiler takes longer than most tests. */
const kept = new URL('../../build/scripts/', import.meta.url);
const own = readFileSync(new URL(import.meta.url));
const versions = readFileSync(new URL('../../package-lock.json', import.meta.url));

async function compiled(fileName, text) {
  const { default: ts } = await import('typescript');
  const compilerOptions = {
    ...{ target: ts.ScriptTarget.ES2022, module: ts.ModuleKind.ESNext },
    ...{ verbatimModuleSyntax: false, inlineSourceMap: true, inlineSources: true },
  };
  const script = ts.transpileModule(text, { fileName, compilerOptions }).outputText;
  // What the page's bundler puts in its place.
  return script.replaceAll('import.meta.env.DEV', 'false');
}

/** The script of a source; those that were made before are read. */
export async function scriptOf(fileName, text) {
  const hash = createHash('sha256').update(own).update(versions).update(fileName).update(text);
  const place = new URL(`${hash.digest('hex').slice(0, 32)}.js`, kept);
  if (existsSync(place)) return readFileSync(place, 'utf8');
  const script = await compiled(fileName, text);
  mkdirSync(kept, { recursive: true });
  const begun = new URL(`${place.href}.${process.pid}`);
  writeFileSync(begun, script);
  renameSync(begun, place);
  return script;
}

const builtPackage = new URL('../../build/package/', import.meta.url);
const packageSources = new URL('../../wasm/package/src/', import.meta.url).href;

/** A source; with a query it is loaded once more, as where something else is global. */
const isSource = /\.ts(\?|$)/;

/** The file to which the page's bundler would resolve `specifier`, or undefined if Node resolves it itself. */
function sourceOf(specifier, parent) {
  // The address of a worker, which no test under Node starts.
  if (specifier.endsWith('?worker&url')) return new URL('data:text/javascript,export default ""');
  if (specifier.endsWith('.css')) return new URL('data:text/javascript,export {}');
  if (specifier === 'virtual:examples') return new URL('./page_examples.mjs', import.meta.url);
  if (specifier === 'hgp') return new URL('index.js', builtPackage);
  if (specifier === 'hgp/gzip') return new URL('gzip.js', builtPackage);
  if (!/^\.{1,2}\//.test(specifier) || !isSource.test(parent ?? '')) return undefined;
  // A source of the package that is not part of every build, among the scripts that are.
  if (parent.startsWith(packageSources))
    return new URL(new URL(specifier, parent).href.slice(packageSources.length), builtPackage);
  const url = new URL(`${specifier}.ts`, parent);
  return existsSync(fileURLToPath(url)) ? url : undefined;
}

export function resolve(specifier, context, next) {
  const url = sourceOf(specifier, context.parentURL);
  return url ? { url: url.href, shortCircuit: true } : next(specifier, context);
}

/** The file with the text of a source that has a fault (tests/mutation); undefined for all others. */
function faulty(fileName) {
  const { HGP_FAULT_FILE: file, HGP_FAULT_TEXT: text } = process.env;
  return file && fileURLToPath(new URL(`../../${file}`, import.meta.url)) === fileName
    ? text
    : undefined;
}

export async function load(url, context, next) {
  if (!url.startsWith('file:') || !isSource.test(url)) return next(url, context);
  const fileName = fileURLToPath(url);
  const source = await scriptOf(fileName, readFileSync(faulty(fileName) ?? fileName, 'utf8'));
  return { format: 'module', source, shortCircuit: true };
}
