// The package in the hands of bundlers and servers: built as the README says, without a warning, and
// run in a browser under a strict Content-Security-Policy.

import assert from 'node:assert/strict';
import { cpSync, existsSync, readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { cubeMesh } from '../support/meshes.mjs';
import { createProject, example, open, openUrl, policy, serve } from './project.mjs';
import { html, page, plainExample, putAssets, ran } from './readme_page.mjs';

const { folder: project, put } = createProject('bundlers');
const installed = path.join(project, 'node_modules/hgp');

/** The example with the options that a section of the README gives to createClient(). */
const exampleWith = (options) =>
  plainExample.replace(/const client = await createClient\(\);/, () =>
    options.replace(/^import.*\n/gm, ''),
  );

const runs = async (folder, security) => ran(await open(path.join(project, folder), security));

for (const version of ['vite', 'vite6']) {
  test(`${version}, with no settings at all`, async () => {
    put(`${version}/index.html`, html);
    put(`${version}/main.js`, page(plainExample));
    await putAssets(put, `${version}/public`);
    const { build, createLogger } = await import(version);
    const warnings = [];
    const customLogger = { ...createLogger('silent'), warn: (text) => warnings.push(text) };
    await build({
      root: path.join(project, version),
      configFile: false,
      customLogger,
      // Top-level await is the example's own.
      build: { target: 'es2022', chunkSizeWarningLimit: 2000 },
    });
    assert.deepEqual(warnings, []);
    await runs(`${version}/dist`);
  });

  test(`${version}, development server, with the setting of the README`, async () => {
    put(`${version}-dev/index.html`, html);
    put(`${version}-dev/main.js`, page(plainExample));
    await putAssets(put, `${version}-dev/public`);
    const { createServer, createLogger } = await import(version);
    const warnings = [];
    const customLogger = { ...createLogger('silent'), warn: (text) => warnings.push(text) };
    const readme = readFileSync(path.join(installed, 'README.md'), 'utf8');
    assert.match(readme, /`optimizeDeps: \{ exclude: \['hgp'\] \}`/);
    const server = await createServer({
      root: path.join(project, `${version}-dev`),
      configFile: false,
      customLogger,
      optimizeDeps: { exclude: ['hgp'] },
      // The server's own connection to the page is a WebSocket.
      server: { headers: { 'Content-Security-Policy': policy.replace("'self'; worker", "'self' ws:; worker") } }, // prettier-ignore
    });
    try {
      await server.listen(0);
      ran(await openUrl(server.resolvedUrls.local[0]));
      assert.deepEqual(warnings, []);
    } finally {
      await server.close();
    }
  });
}

for (const mode of ['production', 'development']) {
  test(`webpack 5, ${mode}, with no settings but the entry`, async () => {
    const folder = `webpack-${mode}`;
    put(`${folder}/entry.js`, page(plainExample));
    put(`${folder}/dist/index.html`, html);
    await putAssets(put, `${folder}/dist`);
    const { default: webpack } = await import('webpack');
    const stats = await new Promise((resolve, reject) =>
      webpack(
        {
          mode,
          context: path.join(project, folder),
          entry: './entry.js',
          output: { path: path.join(project, folder, 'dist'), filename: 'main.js' },
          // Its default for development is eval(), which the policy forbids; and it finds any
          // WebAssembly too large.
          devtool: false,
          performance: { hints: false },
        },
        (error, done) => (error ? reject(error) : resolve(done.toJson())),
      ),
    );
    assert.deepEqual(stats.errors, []);
    assert.deepEqual(stats.warnings, []);
    await runs(`${folder}/dist`);
  });
}

test('hgp/lite in Vite and webpack 5, with no settings at all', async () => {
  const { vertices, triangles } = cubeMesh(2);
  const mesh = { positions: vertices.flat(), triangles: triangles.flat() };
  const program = `import { createLite } from 'hgp/lite';
const lite = await createLite();
const { certificate } = lite.parametrizeMesh(${JSON.stringify(mesh)});
document.title = JSON.stringify(certificate.certified);`;
  put('lite/index.html', html);
  put('lite/main.js', program);
  put('lite/packed/index.html', html);
  const { build, createLogger } = await import('vite');
  const root = path.join(project, 'lite');
  await build({
    ...{ root, configFile: false, customLogger: createLogger('silent') },
    build: { target: 'es2022' },
  });
  const { default: webpack } = await import('webpack');
  const stats = await new Promise((resolve, reject) =>
    webpack(
      {
        ...{ mode: 'production', context: root, entry: './main.js', performance: { hints: false } },
        output: { path: path.join(root, 'packed'), filename: 'main.js' },
      },
      (error, done) => (error ? reject(error) : resolve(done.toJson())),
    ),
  );
  assert.deepEqual([...stats.errors, ...stats.warnings], []);
  for (const folder of ['lite/dist', 'lite/packed']) {
    const { title, trouble } = await open(path.join(project, folder));
    assert.deepEqual([title, trouble], ['true', []], folder);
    const binaries = readdirSync(path.join(project, folder), { recursive: true, encoding: 'utf8' });
    assert.equal(binaries.filter((name) => name.endsWith('.wasm')).length, 1, folder);
  }
});

/** Bundlers that do not follow workers: the package is copied beside the bundle. */
const copied = exampleWith(example('copy the package'));

test('esbuild, with the package copied beside the bundle', async () => {
  put('esbuild/entry.js', page(copied));
  put('esbuild/dist/index.html', html);
  await putAssets(put, 'esbuild/dist');
  cpSync(installed, path.join(project, 'esbuild/dist/hgp'), { recursive: true });
  const { build } = await import('esbuild');
  const { errors, warnings } = await build({
    entryPoints: [path.join(project, 'esbuild/entry.js')],
    bundle: true,
    format: 'esm',
    outfile: path.join(project, 'esbuild/dist/main.js'),
    logLevel: 'silent',
  });
  assert.deepEqual([...errors, ...warnings], []);
  await runs('esbuild/dist');
});

test('rollup, with the package copied beside the bundle', async () => {
  put('rollup/entry.js', page(copied));
  put('rollup/dist/index.html', html);
  await putAssets(put, 'rollup/dist');
  cpSync(installed, path.join(project, 'rollup/dist/hgp'), { recursive: true });
  const { rollup } = await import('rollup');
  const { default: nodeResolve } = await import('@rollup/plugin-node-resolve');
  const warnings = [];
  const bundle = await rollup({
    input: path.join(project, 'rollup/entry.js'),
    plugins: [nodeResolve({ browser: true })],
    onwarn: ({ message }) => warnings.push(message),
  });
  await bundle.write({ file: path.join(project, 'rollup/dist/main.js'), format: 'es' });
  assert.deepEqual(warnings, []);
  await runs('rollup/dist');
});

test('no bundler at all', async () => {
  put('plain/index.html', html);
  put('plain/main.js', page(plainExample.replace("from 'hgp'", "from './hgp/index.js'")));
  await putAssets(put, 'plain');
  cpSync(installed, path.join(project, 'plain/hgp'), { recursive: true });
  await runs('plain');
});

test('from another origin (a CDN)', async () => {
  const cdn = await serve(path.join(project, 'node_modules'), {
    'Access-Control-Allow-Origin': '*',
  });
  try {
    put('cdn/index.html', html);
    const source = plainExample.replace("from 'hgp'", `from '${cdn.origin}/hgp/index.js'`);
    put('cdn/main.js', page(source));
    await putAssets(put, 'cdn');
    const security = policy
      .replace("script-src 'self'", `script-src 'self' ${cdn.origin}`)
      .replace("connect-src 'self'", `connect-src 'self' ${cdn.origin}`)
      .replace("worker-src 'self'", `worker-src blob: ${cdn.origin}`);
    await runs('cdn', security);
  } finally {
    cdn.close();
  }
});

test('under Trusted Types, by the recipe', async () => {
  put('trusted/index.html', html);
  const recipe = exampleWith(example('Trusted Types'));
  put('trusted/main.js', page(recipe.replace("from 'hgp'", "from './hgp/index.js'")));
  await putAssets(put, 'trusted');
  cpSync(installed, path.join(project, 'trusted/hgp'), { recursive: true });
  await runs('trusted', `${policy}; require-trusted-types-for 'script'; trusted-types hgp`);
});

test('no file for browsers names a module of Node, and none the binary by an old name', () => {
  const files = readdirSync(installed, { recursive: true, encoding: 'utf8' }).filter(
    (name) => name.endsWith('.js') && !name.startsWith('node/'),
  );
  assert.ok(files.includes('index.js') && files.includes(path.join('lib', 'core.js')));
  for (const name of files) {
    const text = readFileSync(path.join(installed, name), 'utf8');
    if (!name.startsWith('decoders')) assert.doesNotMatch(text, /['"]node:/, name);
    assert.doesNotMatch(text, /module\.wasm/, name);
    if (!name.startsWith('decoders')) assert.doesNotMatch(text, /\bprocess\b/, name);
  }
  assert.ok(existsSync(path.join(installed, 'hgp.wasm')));
});
