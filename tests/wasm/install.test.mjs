// As a web developer has it: packed by npm, installed into an empty project, typed, built by Vite with
// no settings at all, and run in a browser under a strict Content-Security-Policy.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import path from 'node:path';
import test, { after, before } from 'node:test';
import { chromium } from 'playwright-core';
import { featureFiles } from '../gltf/features.mjs';
import { bumpyDisk } from '../support/disk.mjs';
import { cubeMesh, toGlb } from '../support/meshes.mjs';
import { built, root, scratch } from './support.mjs';

const project = scratch('project');
const run = (command, ...args) =>
  execFileSync(command, args, {
    cwd: project,
    encoding: 'utf8',
    stdio: ['ignore', 'pipe', 'pipe'],
  });
const readme = readFileSync(path.join(built, 'README.md'), 'utf8');
const example = (title) => readme.match(new RegExp(`${title}[^]*?\`\`\`js\\n([^]*?)\`\`\``))[1];
const put = (name, text) => {
  mkdirSync(path.dirname(path.join(project, name)), { recursive: true });
  writeFileSync(path.join(project, name), text);
};

before(() => {
  const packed = execFileSync('npm', ['pack', '--silent', '--pack-destination', project], {
    cwd: built,
    encoding: 'utf8',
  }).trim();
  put('package.json', '{ "private": true, "type": "module" }');
  // It has no dependencies, so nothing is asked of any registry.
  run('npm', 'install', '--offline', '--no-audit', '--no-fund', '--silent', `./${packed}`);
});

test('the packed files are those that package.json and its exports name', () => {
  const installed = path.join(project, 'node_modules/hgp');
  const { files, exports, dependencies } = JSON.parse(
    readFileSync(path.join(installed, 'package.json'), 'utf8'),
  );
  assert.equal(dependencies, undefined);
  const named = Object.values(exports).flatMap((entry) =>
    typeof entry === 'string' ? [entry] : Object.values(entry),
  );
  for (const file of [...files, ...named.filter((name) => !name.includes('*'))]) {
    assert.ok(existsSync(path.join(installed, file)), file);
  }
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

test('the examples are well typed, and so is everything they may go on to do', () => {
  put(
    'typed.ts',
    `declare const file: File;
     ${example('In a browser')}
     import { HgpError, type Cones, type Certificate } from 'hgp';
     import { createCore, type Core } from 'hgp/core';
     const given: Cones = cones;
     const judged: Certificate = await client.verify({ cones: given, tolerance: 1e-6 });
     const stored: Cones | null = await client.embeddedCones();
     const count: number = uv.length + cornerToUv.length + bytes.length + info.triangles;
     const core: Core = await createCore({ wasmUrl: 'hgp.wasm' });
     const raw = await client.parametrizeMesh({ positions: new Float32Array(9),
       triangles: new Uint32Array(3), q: 6 }, { signal: new AbortController().signal,
       onProgress: ({ stage, fraction }) => console.log(stage, fraction) });
     try { client.terminate(); } catch (error) {
       if (error instanceof HgpError && error.code === 'limit') console.log(error.details.where);
     }
     console.log(name, count, judged, stored, core.memory, raw.seams, certificate.certified);
     // @ts-expect-error -- cones have integer k
     const wrong: Cones = { q: 4, cones: [{ vertex: 1, k: 'three' }] };
     console.log(wrong);`,
  );
  const compilerOptions = {
    noEmit: true,
    strict: true,
    target: 'es2022',
    module: 'nodenext',
    lib: ['es2022', 'dom', 'esnext.disposable'],
    types: [],
  };
  put('tsconfig.json', JSON.stringify({ compilerOptions, files: ['typed.ts'] }));
  assert.equal(run(path.join(root, 'node_modules/.bin/tsc'), '-p', '.'), '');
});

/** Serves a folder with the strictest policy the README names. */
function serve(folder) {
  const types = { '.html': 'text/html', '.js': 'text/javascript', '.wasm': 'application/wasm' };
  const server = createServer((request, response) => {
    const name = new URL(request.url, 'http://x').pathname;
    const file = path.join(folder, name === '/' ? 'index.html' : name);
    if (!existsSync(file)) return response.writeHead(404).end();
    response.writeHead(200, {
      'Content-Type': types[path.extname(file)] ?? 'application/octet-stream',
      'Content-Security-Policy':
        "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; connect-src 'self'; worker-src 'self'",
    });
    response.end(readFileSync(file));
  });
  return new Promise((resolve) => server.listen(0, 'localhost', () => resolve(server)));
}

const ended = [];
after(async () => {
  for (const end of ended) await end();
});

/** Opens the page and resolves to what it reports in its title, with everything that went wrong. */
async function open(folder) {
  const server = await serve(folder);
  ended.push(() => server.close());
  const browser = await chromium.launch({
    executablePath: ['/usr/bin/chromium', '/usr/bin/google-chrome'].find(existsSync),
    args: ['--no-sandbox', '--disable-gpu', '--disable-background-networking'],
  });
  ended.push(() => browser.close());
  const page = await browser.newPage();
  const trouble = [];
  page.on('pageerror', (error) => trouble.push(String(error)));
  page.on('console', (message) => message.type() === 'error' && trouble.push(message.text()));
  await page.goto(`http://localhost:${server.address().port}/`);
  // Asked from outside: what Playwright polls with inside the page is what the policy forbids.
  for (let tries = 0; tries < 300 && trouble.length === 0 && !(await page.title()); tries++) {
    await new Promise((done) => setTimeout(done, 100));
  }
  return { title: await page.title(), trouble };
}

const page = `
const fetchFile = async (name) => new File([await (await fetch(name)).arrayBuffer()], name);
const file = await fetchFile('cube.glb');
EXAMPLE
const counts = [certificate.certified, uv.length > 0, cornerToUv.length, bytes.length > 0, name];
for (const other of ['draco.glb', 'meshopt.glb']) {
  counts.push((await client.load(await fetchFile(other))).triangles > 0);
}
// Cancelled in the middle, and alive afterwards.
const stop = new AbortController();
await client.load(await fetchFile('large.obj'));
const onProgress = () => stop.abort();
counts.push(await client.parametrize({}, { signal: stop.signal, onProgress }).catch((e) => e.name));
counts.push((await client.inspect()).triangles);
client.terminate();
document.title = JSON.stringify(counts);`;
const expected = [true, true, 3 * 12 * 36, true, 'cube.glb', true, true, 'AbortError', 15000];

async function assets(folder) {
  mkdirSync(path.join(project, folder), { recursive: true });
  const write = (name, bytes) => writeFileSync(path.join(project, folder, name), bytes);
  write('cube.glb', toGlb([cubeMesh(6)]));
  write('large.obj', bumpyDisk(50));
  for (const { name, files } of await featureFiles()) {
    if (/^(draco|meshopt)$/i.test(name))
      write(`${name.toLowerCase()}.glb`, Object.values(files)[0]);
  }
}

const source = page.replace('EXAMPLE', example('In a browser'));
const html = '<!doctype html><script type="module" src="./main.js"></script>';

test('the browser example of the README, built by Vite as it comes', async () => {
  put('index.html', html);
  put('main.js', source);
  await assets('public');
  const { build } = await import('vite');
  await build({
    root: project,
    configFile: false,
    logLevel: 'error',
    build: { target: 'es2022' },
  });
  const { title, trouble } = await open(path.join(project, 'dist'));
  assert.deepEqual(trouble, []);
  assert.deepEqual(JSON.parse(title), expected);
});

test('and without any bundler', async () => {
  put('plain/index.html', html);
  put('plain/main.js', source.replace("from 'hgp'", "from './hgp/index.js'"));
  await assets('plain');
  const { cpSync } = await import('node:fs');
  cpSync(path.join(project, 'node_modules/hgp'), path.join(project, 'plain/hgp'), {
    recursive: true,
  });
  const { title, trouble } = await open(path.join(project, 'plain'));
  assert.deepEqual(trouble, []);
  assert.deepEqual(JSON.parse(title), expected);
});
