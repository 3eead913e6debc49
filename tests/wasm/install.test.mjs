// As a developer has it: packed by npm, installed into an empty project, typed, and run in Node.

import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { bumpyDisk } from '../support/disk.mjs';
import { createProject, example, missingFiles } from './project.mjs';
import { built, root } from './support.mjs';

const { folder: project, put, run } = createProject('project');

test('the packed files are those that package.json and its exports name', () => {
  const installed = path.join(project, 'node_modules/hgp');
  const { dependencies } = JSON.parse(readFileSync(path.join(installed, 'package.json'), 'utf8'));
  assert.equal(dependencies, undefined);
  assert.deepEqual(missingFiles(installed), []);
  assert.deepEqual(missingFiles(built), []);
  assert.deepEqual(
    readdirSync(path.join(installed, 'schema')).sort(),
    readdirSync(path.join(root, 'docs/schema')).sort(),
  );
});

test('the Node example of the README runs as printed', () => {
  put('example.js', example('In Node'));
  put('disk.obj', bumpyDisk(8));
  assert.equal(run('node', 'example.js'), 'true\n');
  assert.match(readFileSync(path.join(project, 'mapped.obj'), 'utf8'), /^vt /m);
});

test('the schemas and the binary can be resolved by name', () => {
  put(
    'resolve.js',
    `import { readFileSync } from 'node:fs';
     import { fileURLToPath } from 'node:url';
     const at = (name) => readFileSync(fileURLToPath(import.meta.resolve(name)));
     console.log(JSON.parse(at('hgp/schema/hgp-cones.schema.json')).title, at('hgp/hgp.wasm').length > 1e6);`,
  );
  assert.match(run('node', 'resolve.js'), /hgp-cones.* true\n/);
});

test('the examples and further calls of the package are well typed', () => {
  put(
    'typed.ts',
    `declare const file: File;
     ${example('In a browser')}
     import { HgpError, type Cones, type Certificate, type Model, type UvMap } from 'hgp';
     import { createCore, type Core } from 'hgp/core';
     const given: Cones = cones;
     const verified: Certificate = await model.verify({ cones: given, tolerance: 1e-6 });
     const stored: Cones | null = await model.embeddedCones();
     const count: number = uv.length + cornerToUv.length + bytes.length + model.info.triangles;
     const again: UvMap = map;
     await (again.model satisfies Model).dispose();
     const core: Core = await createCore({ wasmUrl: 'hgp.wasm' });
     const raw = await client.parametrizeMesh({ positions: new Float32Array(9),
       triangles: new Uint32Array(3), q: 6 }, { signal: new AbortController().signal,
       onProgress: ({ stage, fraction }) => console.log(stage, fraction) });
     try { client.terminate(); } catch (error) {
       if (error instanceof HgpError && error.code === 'limit') console.log(error.where, error.details);
     }
     console.log(name, count, verified, stored, core.memory, raw.seams, certificate.certified);
     // @ts-expect-error -- cones have integer k
     const wrong: Cones = { q: 4, cones: [{ vertex: 1, k: 'three' }] };
     console.log(wrong);`,
  );
  const compilerOptions = {
    noEmit: true,
    strict: true,
    target: 'es2022',
    module: 'nodenext',
    lib: ['es2022', 'dom'],
    types: [],
  };
  put('tsconfig.json', JSON.stringify({ compilerOptions, files: ['typed.ts'] }));
  assert.equal(run(path.join(root, 'node_modules/.bin/tsc'), '-p', '.'), '');
});

test('every declaration is well typed in four module modes, from ESM and CommonJS, with and without the DOM', () => {
  // three.js and glTF-Transform declare much that needs the DOM; they are not installed here.
  const calls = `import { createClient, HgpError, type Client, type ClientOptions, type Report } from 'hgp';
     import { compile, Core, createCore, type CoreMap } from 'hgp/core';
     import { readMembers } from 'hgp/gzip';
     import 'hgp/worker';
     export async function use(client: Client, options: ClientOptions): Promise<Report> {
       const model = await client.load(new Uint8Array(1), { name: 'a.obj' });
       const core: Core = await createCore({ wasmModule: await compile({ wasmUrl: 'hgp.wasm' }) });
       const map: CoreMap = core.load({ main: 'a', files: new Map() }).parametrize();
       const own = (await createClient(options)) satisfies Client;
       const error: unknown = [map.uv, model.info.usable, readMembers, own];
       if (error instanceof HgpError) throw error;
       // @ts-expect-error -- models come from load()
       client.parametrize();
       // @ts-expect-error -- a signal is not a number
       return (await model.parametrize({}, { signal: 1 })).report;
     }`;
  put('all.ts', calls);
  put('all.cts', calls);
  put(
    'dispose.ts',
    `import type { Client } from 'hgp';
     export async function use(client: Client): Promise<void> {
       await using model = await client.load(new Uint8Array(1), { name: 'a.obj' });
       await model.inspect();
     }`,
  );
  const modes = [
    ['nodenext', 'nodenext'],
    ['node16', 'node16'],
    ['esnext', 'bundler'],
    ['preserve', 'bundler'],
  ];
  const dom = ['es2022', 'dom', 'dom.iterable', 'dom.asynciterable', 'esnext.disposable'];
  const files = ['all.ts', 'all.cts', 'dispose.ts'];
  for (const [module, moduleResolution] of modes)
    for (const [lib, types] of [
      [dom, []],
      [['es2022', 'esnext.disposable'], ['node']],
      [['es2022'], []],
    ]) {
      const compilerOptions = {
        ...{ noEmit: true, strict: true, skipDefaultLibCheck: true, target: 'es2022' },
        ...{ exactOptionalPropertyTypes: true, noUncheckedIndexedAccess: true },
        ...{ module, moduleResolution, lib, types },
        typeRoots: [path.join(root, 'node_modules/@types')],
      };
      put('tsconfig.json', JSON.stringify({ compilerOptions, files }));
      assert.equal(
        run(path.join(root, 'node_modules/.bin/tsc'), '-p', '.'),
        '',
        `${module} ${lib}`,
      );
    }
});

test('publint reports nothing for the packed files', async () => {
  const { publint } = await import('publint');
  const { messages } = await publint({ pkgDir: path.join(project, 'node_modules/hgp') });
  assert.deepEqual(messages, []);
});

test('arethetypeswrong reports nothing for any entry except that the URLs of the binaries are ESM', async () => {
  const { checkPackage, createPackageFromTarballData } = await import('@arethetypeswrong/core');
  const packed = readdirSync(project).find((name) => name.endsWith('.tgz'));
  const tarball = createPackageFromTarballData(readFileSync(path.join(project, packed)));
  const { types, entrypoints, problems } = await checkPackage(tarball);
  assert.ok(types);
  const { exports } = JSON.parse(tarball.readFile('/node_modules/hgp/package.json'));
  assert.deepEqual(Object.keys(entrypoints).sort(), Object.keys(exports).sort());
  const told = problems.filter(
    ({ entrypoint, kind }) => !(entrypoint.endsWith('.wasm') && kind === 'CJSResolvesToESM'),
  );
  assert.deepEqual(told, []);
});

test('CommonJS can require it', () => {
  put('required.cjs', "require('hgp').createClient().then((c) => console.log(c.terminate()));");
  assert.match(run('node', '--no-warnings', 'required.cjs'), /^undefined\n$/);
  // The same objects as import gives, so that instanceof holds between both.
  put(
    'same.cjs',
    `const required = [require('hgp'), require('hgp/core'), require('hgp/lite'), require('hgp/gzip')];
     Promise.all([import('hgp'), import('hgp/core'), import('hgp/lite'), import('hgp/gzip')]).then((imported) =>
       console.log(imported.every((one, i) => Object.keys(one).every((name) => one[name] === required[i][name]))));`,
  );
  assert.equal(run('node', '--no-warnings', 'same.cjs'), 'true\n');
});

test('the declared documents are made from the schemas as they are', async () => {
  const { declareDocuments } = await import('../../wasm/documents.mjs');
  assert.equal(
    readFileSync(path.join(root, 'wasm/package/src/lib/documents.ts'), 'utf8'),
    await declareDocuments(path.join(root, 'docs/schema')),
    'docs/schema has changed: run `npm run types`',
  );
});
