// The package as its users have it: build/package, in Node.

import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { fileURLToPath } from 'node:url';
import { bumpyDisk } from '../support/disk.mjs';

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
const built = path.join(root, 'build/package');
const { createClient, HgpError } = await import(path.join(built, 'index.js'));
const { createCore } = await import(path.join(built, 'core.js'));

const bytes = (text) => new TextEncoder().encode(text);
const disk = (n) => bytes(bumpyDisk(n));

/** Runs with a client of its own, which is ended whatever happens. */
async function withClient(use) {
  const client = await createClient();
  try {
    return await use(client);
  } finally {
    client.terminate();
  }
}

test('types name exactly what is exported', async () => {
  for (const entry of ['index', 'core']) {
    const declared = [
      ...readFileSync(path.join(built, `${entry}.d.ts`), 'utf8').matchAll(
        /^export (?:declare )?(?:function|class|const) (\w+)|^export \{ (\w+) \}/gm,
      ),
    ].map((match) => match[1] ?? match[2]);
    const exported = Object.keys(await import(path.join(built, `${entry}.js`)));
    assert.deepEqual([...new Set(declared)].sort(), exported.sort(), entry);
  }
});

test('every file of package.json is there', () => {
  const { files, exports } = JSON.parse(readFileSync(path.join(built, 'package.json'), 'utf8'));
  const named = Object.values(exports).flatMap((entry) =>
    typeof entry === 'string' ? [entry] : Object.values(entry),
  );
  for (const file of [...files, ...named]) assert.ok(existsSync(path.join(built, file)), file);
});

test('load, inspect, parametrize, write, verify', () =>
  withClient(async (client) => {
    const info = await client.load(disk(12), { name: 'disk.obj' });
    assert.deepEqual(await client.inspect(), info);
    const result = await client.parametrize({ boundary: 'convex' });
    assert.equal(result.certificate.certified, true);
    assert.equal(result.triangles.length, 3 * 6 * 12 * 12);
    assert.equal(result.cornerToUv.length, result.triangles.length);
    assert.equal(result.uvToVertex.length, result.uv.length / 2);
    for (let c = 0; c < result.triangles.length; c++) {
      assert.equal(result.uvToVertex[result.cornerToUv[c]], result.triangles[c]);
    }
    const written = await client.write();
    await client.load(written.bytes, { name: written.name });
    assert.equal((await client.verify()).certified, true);
  }));

test('the surface is there before any solve, and cone files of other programs are read on it', () =>
  withClient(async (client) => {
    const { vertices } = await client.load(disk(6), { name: 'disk.obj' });
    const surface = await client.surface();
    assert.equal(surface.positions.length, 3 * vertices);
    assert.equal(surface.triangles.length, 3 * 6 * 6 * 6);
    const cones = await client.readCones({
      name: 'cones.obj',
      text: `${bumpyDisk(6)}c 1 1.5\n`,
      q: 4,
    });
    assert.deepEqual(
      cones.cones.map(({ vertex, k }) => [vertex, k]),
      [[0, 3]],
    );
  }));

test('the raw-array path gives the same map as the file', () =>
  withClient(async (client) => {
    await client.load(disk(6), { name: 'disk.obj' });
    const fromFile = await client.parametrize({ boundary: 'convex' });
    const { positions, triangles } = fromFile;
    const fromArrays = await client.parametrizeMesh({ positions, triangles, boundary: 'convex' });
    assert.deepEqual(fromArrays.uv, fromFile.uv);
  }));

test('a file that is no mesh is an HgpError with the code of the command line', () =>
  withClient(async (client) => {
    await assert.rejects(client.load(bytes('not a mesh'), { name: 'x.obj' }), (error) => {
      assert.ok(error instanceof HgpError);
      assert.match(error.code, /malformed|unsupported/);
      return true;
    });
    await client.load(disk(3), { name: 'disk.obj' }); // and the client goes on
  }));

test('a call without a model is a usage error, not an end', () =>
  withClient(async (client) => {
    await assert.rejects(client.inspect(), HgpError);
    await assert.rejects(client.write(), HgpError);
  }));

test('cancel in the middle of a solve: AbortError, and the next call works', () =>
  withClient(async (client) => {
    await client.load(disk(120), { name: 'disk.obj' });
    const controller = new AbortController();
    const solving = client.parametrize(
      { boundary: 'convex' },
      { signal: controller.signal, onProgress: () => controller.abort() },
    );
    setTimeout(() => controller.abort(), 50);
    await assert.rejects(solving, { name: 'AbortError' });
    const begin = performance.now();
    const info = await client.inspect(); // a fresh worker has the model again
    assert.ok(info);
    assert.ok(performance.now() - begin < 5000);
  }));

test('an aborted call that still waits leaves the running one alone', () =>
  withClient(async (client) => {
    await client.load(disk(20), { name: 'disk.obj' });
    const controller = new AbortController();
    const first = client.parametrize({ boundary: 'convex' });
    const second = client.inspect({ signal: controller.signal });
    controller.abort();
    await assert.rejects(second, { name: 'AbortError' });
    assert.equal((await first).certificate.certified, true);
  }));

test('terminate rejects what is pending', async () => {
  const client = await createClient();
  const loading = client.load(disk(60), { name: 'disk.obj' });
  await new Promise((resolve) => setTimeout(resolve, 5));
  client.terminate();
  await assert.rejects(loading, { name: 'AbortError' });
});

test('two clients at once do not mix', async () => {
  const [a, b] = await Promise.all([createClient(), createClient()]);
  await Promise.all([a.load(disk(4), { name: 'a.obj' }), b.load(disk(9), { name: 'b.obj' })]);
  const [ra, rb] = await Promise.all([
    a.parametrize({ boundary: 'convex' }),
    b.parametrize({ boundary: 'convex' }),
  ]);
  assert.equal(ra.triangles.length, 3 * 6 * 16);
  assert.equal(rb.triangles.length, 3 * 6 * 81);
  a.terminate();
  b.terminate();
});

test('memory is flat over fifty runs', async () => {
  const core = await createCore();
  const files = { main: 'disk.obj', files: new Map([['disk.obj', disk(30)]]) };
  const run = () => {
    core.load(files);
    core.parametrize({ boundary: 'convex' });
    core.write();
  };
  for (let i = 0; i < 5; i++) run();
  const settled = core.memory;
  for (let i = 0; i < 45; i++) run();
  assert.equal(core.memory, settled);
  core.free();
  assert.throws(() => core.inspect(), HgpError);
});

test('an idle client does not keep a script alive', () => {
  const script = `import { createClient } from ${JSON.stringify(path.join(built, 'index.js'))};
    await createClient(); console.log('done');`;
  const { stdout, status } = spawnSync('node', ['--input-type=module', '-e', script], {
    encoding: 'utf8',
    timeout: 20000,
  });
  assert.equal(status, 0);
  assert.equal(stdout, 'done\n');
});

test('the Node example of the README runs as printed', () => {
  const folder = path.join(root, 'build/readme-example');
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(path.join(folder, 'node_modules'), { recursive: true });
  symlinkSync(built, path.join(folder, 'node_modules/hgp'));
  const readme = readFileSync(path.join(built, 'README.md'), 'utf8');
  const [, example] = readme.match(/In Node:\n\n```js\n([\s\S]*?)```/);
  writeFileSync(path.join(folder, 'example.mjs'), example);
  writeFileSync(path.join(folder, 'disk.obj'), bumpyDisk(8));
  const printed = execFileSync('node', ['example.mjs'], { cwd: folder, encoding: 'utf8' });
  assert.equal(printed.trim(), 'true');
  assert.match(readFileSync(path.join(folder, 'mapped.obj'), 'utf8'), /^vt /m);
});

test('the browser example of the README runs as printed', () => {
  const folder = path.join(root, 'build/readme-example');
  const readme = readFileSync(path.join(built, 'README.md'), 'utf8');
  const [, example] = readme.match(/In a browser[\s\S]*?```js\n([\s\S]*?)```/);
  const around = `import { readFileSync } from 'node:fs';
    const file = new File([readFileSync('disk.obj')], 'disk.obj');
    ${example}
    console.log(uv.length > 0 && cornerToUv.length > 0 && bytes.length > 0, name, info !== null);
    console.log(typeof certificate.certified);`;
  writeFileSync(path.join(folder, 'browser.mjs'), around.replace(/(import[^;]*'hgp';)/, '$1'));
  const script = ["import { File } from 'node:buffer';", around].join('\n');
  writeFileSync(path.join(folder, 'browser.mjs'), script);
  const printed = execFileSync('node', ['browser.mjs'], { cwd: folder, encoding: 'utf8' });
  assert.match(printed, /^true disk\.obj true\nboolean\n$/);
});
