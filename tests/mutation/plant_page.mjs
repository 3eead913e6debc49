// Plants a fault in a source of the page or the package without changing a file: Node loads the changed text instead
// (tests/support/fault_hooks.mjs), and those unit tests run that load the source.

import { spawn } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import ts from 'typescript';

const limit = 400_000; // milliseconds, after which a fault counts as endless

/** The tests of the package that need neither a bundler nor a long time, the shortest first. */
const packageTests = ['parts', 'queue_laws', 'browser_parts', 'npx_script', 'packed', 'drag_steps', 'recorded', 'arguments', 'policies', 'write_formats', 'adapters', 'decoders', 'features', 'files', 'lite', 'hostile', 'package', 'drag', 'interleavings']; // prettier-ignore

/** Whether a changed text still compiles; what does not is no fault that a test has to see. */
export function typeChecker(root) {
  const projects = ['web', 'wasm'].map((folder) => {
    const file = path.join(root, folder, 'tsconfig.json');
    const { config } = ts.readConfigFile(file, ts.sys.readFile);
    const { options, fileNames } = ts.parseJsonConfigFileContent(config, ts.sys, path.join(root, folder)); // prettier-ignore
    const changed = new Map();
    const versions = new Map();
    const service = ts.createLanguageService({
      ...ts.sys,
      useCaseSensitiveFileNames: () => true,
      getCompilationSettings: () => options,
      getScriptFileNames: () => fileNames,
      getScriptVersion: (name) => String(versions.get(name) ?? 0),
      getScriptSnapshot: (name) => {
        const text = changed.get(name) ?? ts.sys.readFile(name);
        return text === undefined ? undefined : ts.ScriptSnapshot.fromString(text);
      },
      getCurrentDirectory: () => root,
      getDefaultLibFileName: ts.getDefaultLibFilePath,
    });
    const set = (name, text) => {
      versions.set(name, (versions.get(name) ?? 0) + 1);
      if (text === undefined) changed.delete(name);
      else changed.set(name, text);
    };
    return { service, set };
  });
  return ({ file, text }) => {
    const { service, set } = projects[file.startsWith('web/') ? 0 : 1];
    const name = path.join(root, file);
    set(name, text);
    const errors = [...service.getSyntacticDiagnostics(name), ...service.getSemanticDiagnostics(name)]; // prettier-ignore
    set(name, undefined);
    return errors.length === 0;
  };
}

/** The TypeScript that a test or source loads, itself included. */
function loadedBy(file, known = new Set()) {
  if (known.has(file) || !existsSync(file)) return known;
  known.add(file);
  const text = readFileSync(file, 'utf8');
  for (const [, name] of text.matchAll(/(?:from|import|import\()\s*'(\.[^']*)'/g)) {
    const target = path.join(path.dirname(file), name.replace(/\.ts\?.*$/, '.ts'));
    loadedBy(/\.m?[tj]s$/.test(target) ? target : `${target}.ts`, known);
  }
  return known;
}

/** The test files that may see a fault in a file, in groups that run one after another. */
export function testsFor(root, file) {
  const units = path.join(root, 'tests/web/units');
  const own = readdirSync(units)
    .filter((name) => name.endsWith('.test.mjs'))
    .map((name) => path.join(units, name));
  const uses = (test, name) => readFileSync(test, 'utf8').includes(name);
  const isRecorded = (test) => uses(test, './recorded_session.mjs');
  const isWhole = (test) => isRecorded(test) || uses(test, './whole_page.mjs');
  const sorted = (tests) => [...tests.filter(isRecorded), ...tests.filter((one) => !isRecorded(one))]; // prettier-ignore
  if (file.startsWith('web/')) {
    const near = own.filter((test) => loadedBy(test).has(path.join(root, file)));
    const quick = near.filter((test) => !isWhole(test));
    return [quick, ...sorted(near.filter(isWhole)).map((test) => [test])].filter((group) => group.length > 0); // prettier-ignore
  }
  const ofPackage = packageTests.map((name) => path.join(root, 'tests/wasm', `${name}.test.mjs`));
  return [...ofPackage, ...sorted(own.filter(isWhole))].map((test) => [test]);
}

/** Runs tests with a fault, or with none; which test failed first, or '' if none did. */
export function failing(root, tests, fault) {
  const folder = path.join(root, 'build/faults');
  mkdirSync(folder, { recursive: true });
  const env = { ...process.env };
  const hooks = ['--import', path.join(root, 'tests/support/typescript.mjs')];
  if (fault) {
    const text = path.join(folder, `${fault.id}.ts`);
    writeFileSync(text, fault.text);
    Object.assign(env, { HGP_FAULT_FILE: fault.file, HGP_FAULT_TEXT: text });
    env.NODE_OPTIONS = `${env.NODE_OPTIONS ?? ''} --import ${path.join(root, 'tests/support/fault.mjs')}`; // prettier-ignore
  }
  // All in one process: starting one for each file would take longer than the tests.
  const all = path.join(folder, `${fault?.id ?? 'plain'}-${createHash('md5').update(tests.join()).digest('hex')}.mjs`); // prettier-ignore
  writeFileSync(all, tests.map((test) => `import ${JSON.stringify(test)};\n`).join(''));
  const child = spawn('node', [...hooks, '--test-reporter=tap', all], {
    ...{ cwd: root, env, detached: true, stdio: ['ignore', 'pipe', 'pipe'] },
  });
  return new Promise((resolve) => {
    let output = '';
    const timer = setTimeout(() => end('does not end'), limit);
    const end = (by) => {
      clearTimeout(timer);
      try {
        process.kill(-child.pid, 'SIGKILL');
      } catch {
        // It has ended by itself.
      }
      resolve(by);
    };
    const look = (part) => {
      output += part;
      const by = output.match(/^ *not ok \d+ - ([^\n]*)\n/m)?.[1];
      if (by !== undefined) end(by);
    };
    child.stdout.on('data', look);
    child.on('close', (code) => end(code === 0 ? '' : 'ends with an error'));
  });
}
