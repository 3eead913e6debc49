// node pack.mjs MODULE_DIR OUT [CLI_DIR]: builds the npm package from its TypeScript, the module linked by Emscripten,
// the schemas, the decoders and, if CLI_DIR is given, the command line. Previous contents of OUT are removed.

import { execFileSync } from 'node:child_process';
import {
  copyFileSync,
  cpSync,
  mkdirSync,
  readFileSync,
  readdirSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import path from 'node:path';
import { writeCommonJs } from './commonjs.mjs';
import { packDecoders } from './decoders.mjs';

const [moduleDir, out, cliDir] = process.argv.slice(2).map((name) => path.resolve(name));
const root = path.resolve(import.meta.dirname, '..');

/** Removes the binary's name, which bundlers would look for; the module is passed to the glue code instead. */
function withoutBinaryName(glue, file) {
  const name = /new URL\("module\.wasm",\s*import\.meta\.url\)\.toString\(\)/g;
  const count = glue.match(name)?.length ?? 0;
  if (count !== 1) throw new Error(`module.js names module.wasm ${count} times, not once`);
  return glue.replace(name, '""').replaceAll('module.wasm', file);
}

/** Removes unused checks for Node, for which some bundlers would add a `process`. */
function withoutProcess(glue) {
  const unused = /var ENVIRONMENT_IS_NODE=[^;]*;/;
  if (!unused.test(glue) || glue.match(/ENVIRONMENT_IS_NODE/g).length !== 1) {
    throw new Error('module.js uses ENVIRONMENT_IS_NODE, or does not name it');
  }
  return glue.replace(unused, '');
}

rmSync(out, { recursive: true, force: true });
mkdirSync(out, { recursive: true });
for (const name of ['package.json', 'README.md', 'hgp.wasm.d.ts']) {
  copyFileSync(path.join(root, 'wasm/package', name), path.join(out, name));
}
copyFileSync(path.join(out, 'hgp.wasm.d.ts'), path.join(out, 'hgp-lite.wasm.d.ts'));
const compiler = path.join(root, 'node_modules/typescript/bin/tsc');
const options = ['-p', path.join(root, 'wasm'), '--noEmit', 'false', '--outDir', out];
execFileSync(process.execPath, [compiler, ...options], { stdio: 'inherit' });
writeCommonJs(out);
// Files with types alone have declarations, and scripts that nobody loads.
for (const name of readdirSync(path.join(out, 'lib')))
  if (
    name.endsWith('.js') &&
    /^(\/\/.*\n)*export \{\};?\s*$/.test(readFileSync(path.join(out, 'lib', name), 'utf8'))
  )
    rmSync(path.join(out, 'lib', name));
cpSync(path.join(root, 'docs/schema'), path.join(out, 'schema'), { recursive: true });
for (const name of ['LICENSE', 'THIRD_PARTY_NOTICES.md', 'THIRD_PARTY_LICENSES.txt']) {
  copyFileSync(path.join(root, name), path.join(out, name));
}
packDecoders(path.join(root, 'node_modules'), path.join(out, 'decoders'));
/** The module linked in a folder, its glue code as NAME. */
function packModule(folder, name, file) {
  const glue = readFileSync(path.join(folder, 'module.js'), 'utf8');
  writeFileSync(path.join(out, name), withoutProcess(withoutBinaryName(glue, file)));
  copyFileSync(path.join(folder, 'module.wasm'), path.join(out, file));
}
packModule(moduleDir, 'module.js', 'hgp.wasm');
packModule(path.join(moduleDir, 'lite'), 'lite_module.js', 'hgp-lite.wasm');

/** Without the command line, the package has no program. */
function packProgram() {
  if (cliDir) {
    mkdirSync(path.join(out, 'cli'));
    for (const name of ['cli.cjs', 'cli.wasm'])
      copyFileSync(path.join(cliDir, name), path.join(out, 'cli', name));
    return;
  }
  const { bin, ...others } = JSON.parse(readFileSync(path.join(out, 'package.json'), 'utf8'));
  others.files = others.files.filter((name) => name !== 'cli');
  for (const file of Object.values(bin))
    for (const name of [file, file.replace(/js$/, 'd.ts')]) rmSync(path.join(out, name));
  writeFileSync(path.join(out, 'package.json'), `${JSON.stringify(others, null, 2)}\n`);
}
packProgram();
