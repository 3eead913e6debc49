// What a caller can get wrong is said by the call that was wrong, before the worker sees it.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { runInNewContext } from 'node:vm';
import { Worker } from 'node:worker_threads';
import { gzipSync } from 'node:zlib';
import { bumpyDisk } from '../support/disk.mjs';
import { readTables } from '../../wasm/options.mjs';
import { cubeMesh, toGlb, toObj } from '../support/meshes.mjs';
import {
  asFiles,
  built,
  bytesOf,
  createClient,
  createCore,
  HgpError,
  withClient,
} from './support.mjs';

const { optionsOf } = await import(path.join(built, 'lib/check_options.js'));
const disk = bytesOf(bumpyDisk(4));
const cube = cubeMesh(3);

/** The calls that were sent to workers; not those by which clients begin and handles are released. */
const sent = [];
const { postMessage } = Worker.prototype;
Worker.prototype.postMessage = function post(message, ...more) {
  if (!['init', 'release', undefined].includes(message?.method)) sent.push(message.method);
  return postMessage.call(this, message, ...more);
};

/** Rejects with a usage error that says what was wrong, before the worker sees it; the client then still works. */
async function refused(client, call, message) {
  sent.length = 0;
  const error = await call().then(
    () => assert.fail(`accepted, but should say ${message}`),
    (reason) => reason,
  );
  assert.ok(error instanceof HgpError, String(error?.stack ?? error));
  assert.equal(error.code, 'usage', error.message);
  assert.match(error.message, message);
  assert.deepEqual(sent, [], 'the worker has not seen it');
  assert.doesNotMatch(error.message, /--[a-z]/, 'no flags of the command line');
}

test('a mesh without names: every index is looked at, every array is as long as it has to be', () =>
  withClient(async (client) => {
    const positions = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0];
    const triangles = [0, 1, 2, 0, 2, 3];
    const made = (mesh) => client.parametrizeMesh({ positions, ...mesh });
    assert.equal((await made({ triangles })).certificate.triangles, 2);
    for (const i of triangles.keys())
      for (const v of [4, -1, 0.5, NaN, Infinity])
        await refused(client, () => made({ triangles: triangles.with(i, v) }), new RegExp(`triangle ${Math.floor(i / 3)} .*vertex ${v};`)); // prettier-ignore
    for (const n of [0, 1, 2, 4, 5]) await refused(client, () => made({ triangles: triangles.slice(0, n) }), /indices/); // prettier-ignore
    for (const n of [0, 1, 2, 4, 10]) await refused(client, () => made({ positions: positions.slice(0, n), triangles }), /three numbers/); // prettier-ignore
    // Without indices every three vertices are a triangle.
    await refused(client, () => made({}), /there are 4/);
    const { certificate } = await made({ positions: positions.slice(0, 9) });
    assert.equal(certificate.triangles, 1);
    assert.equal((await made({ positions: Float32Array.from(positions), triangles: Uint16Array.from(triangles) })).certificate.certified, true); // prettier-ignore
  }));

test('wrong arguments are usage errors, and the model stays loaded', () =>
  withClient(async (client) => {
    const model = await client.load(disk, { name: 'disk.obj' });
    const map = await model.parametrize({ boundary: 'convex' });
    const { positions, triangles } = await model.surface();
    const big = BigInt64Array.from([0n, 1n, 2n]);
    for (const [call, message] of [
      [() => client.load(null), /not null/],
      [() => client.load('disk.obj'), /not 'disk.obj'/],
      [() => client.load([1, 2, 3]), /not an array/],
      [() => client.load({ main: 'a.obj', files: new Map() }), /no 'a.obj'/],
      [() => client.load(disk, { nmae: 'x.obj' }), /no option 'nmae'/],
      [
        () => client.load(disk, { weld: '1' }),
        /weld is 'exact', 'none' or a number of at least 0, not '1'/,
      ],
      [() => client.load(disk, { fix: { orientt: true } }), /fix.orientt/],
      [() => model.parametrize({ Q: 6 }), /did you mean 'q'/],
      [() => model.parametrize({ cone: { q: 4, cones: [] } }), /did you mean 'cones'/],
      [() => model.parametrize({ q: '6' }), /q is an integer from 1 to 64, not '6'/],
      [() => model.parametrize({ q: 4.5 }), /not 4.5/],
      [
        () => model.parametrize({ features: { rims: true, crease: 30 } }),
        /features is \{ rims, creases/,
      ],
      [() => model.parametrize({ features: { crease: 30 } }), /features is \{ rims, creases/],
      [() => model.parametrize({ cones: [{ vertex: 1, k: 3 }] }), /cones is \{ q, cones/],
      [
        () => model.parametrize({ boundary: 'round' }),
        /'free' or 'convex' or 'rectangle', not 'round'/,
      ],
      [() => model.parametrize(4), /an object, not 4/],
      [() => model.parametrize({}, { sginal: undefined }), /no option 'sginal'/],
      [() => model.inspect({ signal: 4 }), /signal is an AbortSignal, not 4/],
      [() => model.check([]), /not an array/],
      [() => model.readCones({ name: 'x.cones' }), /\{ name, text \}/],
      [() => model.verify({ tolerance: -1 }), /tolerance/],
      [() => map.write({ uvSet: 'last' }), /uvSet/],
      [() => client.parametrizeMesh(), /\{ positions, triangles/],
      [() => client.parametrizeMesh({ triangles }), /positions are numbers/],
      [() => client.parametrizeMesh({ positions: positions.subarray(1), triangles }), /there are/],
      [() => client.parametrizeMesh({ positions, triangles: [0, 1, 2, 3] }), /4 indices/],
      [() => client.parametrizeMesh({ positions, triangles: big }), /BigInt64Array/],
      [() => client.parametrizeMesh({ positions, triangles: [0, 1, 10n] }), /an array/],
      [() => client.parametrizeMesh({ positions, triangles: [0, 1, 1e6] }), /vertex 1000000/],
      [() => client.parametrizeMesh({ positions, triangles, qs: 4 }), /did you mean 'q'/],
    ]) {
      await refused(client, call, message);
    }
    assert.equal((await model.inspect()).file.name, 'disk.obj');
    assert.equal((await map.write()).name, 'disk.obj');
    await assert.rejects(createClient({ wasmURL: 'hgp.wasm' }), {
      code: 'usage',
      message: /did you mean 'wasmUrl'/,
    });
  }));

/** The calls that a model and its map have in any thread. */
const callsOf = (model, map) => ({
  suggestCones: (some) => model.suggestCones(some),
  parametrize: (some) => model.parametrize(some),
  verify: (some) => model.verify(some),
  write: (some) => map.write(some),
  quads: (some) => map.quads(some),
  listFeatures: (some) => model.listFeatures({ rims: true }, some),
});

test('every option of every call is looked at where it is given: a list is none of them', () =>
  withClient(async (client) => {
    const mesh = { positions: [0, 0, 0, 1, 0, 0, 0, 1, 0], triangles: [0, 1, 2] };
    const model = await client.load(disk, { name: 'disk.obj' });
    const map = await model.parametrize({ boundary: 'convex' });
    const calls = {
      load: (some) => client.load(disk, { name: 'disk.obj', ...some }),
      loadMesh: (some) => client.loadMesh({ ...mesh, ...some }),
      ...callsOf(model, map),
      parametrizeFile: (some) => client.parametrizeFile(disk, { name: 'disk.obj', ...some }),
      combine: (some) => client.combine([map], some),
    };
    const names = (call) => Object.keys(optionsOf[call]);
    for (const [call, act] of Object.entries(calls))
      for (const name of names(call)) await refused(client, () => act({ [name]: [] }), new RegExp(`\\b${name} is .*an array`)); // prettier-ignore
    for (const name of [...names('loadMesh'), ...names('parametrize')])
      await refused(client, () => client.parametrizeMesh({ ...mesh, [name]: [] }), new RegExp(`\\b${name} is .*an array`)); // prettier-ignore
    const given = {
      check: (bad) => model.check(bad),
      logScale: (bad) => model.logScale(bad),
      balanceCones: (bad) => model.balanceCones(bad),
      transferCones: (bad) => model.transferCones(bad, model),
      listFeatures: (bad) => model.listFeatures(bad),
      readCones: (bad) => model.readCones(bad),
      beginDrag: (bad) => map.beginDrag(bad),
    };
    for (const [call, act] of Object.entries(given))
      for (const bad of [[], 'cones', 4.5, null, { cone: 1 }]) await refused(client, () => act(bad), new RegExp(`^${call}: `)); // prettier-ignore
    for (const name of names('load')) await refused(client, () => client.parametrizeRendered(mesh, { [name]: [] }, {}), /an array/); // prettier-ignore
    for (const name of names('parametrize')) await refused(client, () => client.parametrizeRendered(mesh, {}, { [name]: [] }), /an array/); // prettier-ignore
  }));

test('the core says in the thread that calls it what is wrong with cones, features and vertices, as its client does', async () => {
  const core = await createCore();
  const model = core.load({ main: 'disk.obj', files: new Map([['disk.obj', disk]]) });
  const map = model.parametrize({ boundary: 'convex' });
  const calls = {
    check: (bad) => model.check(bad),
    logScale: (bad) => model.logScale(bad),
    balanceCones: (bad) => model.balanceCones(bad),
    transferCones: (bad) => model.transferCones(bad, model),
    parametrize: (bad) => model.parametrize({ cones: bad }),
    listFeatures: (bad) => model.listFeatures(bad),
    readCones: (bad) => model.readCones(bad),
    beginDrag: (bad) => map.beginDrag(bad),
  };
  for (const [name, call] of Object.entries(calls))
    for (const bad of [[], 'cones', 4.5, null, { cone: 1 }])
      assert.throws(() => call(bad), { code: 'usage' }, `${name}: ${JSON.stringify(bad)}`);
  const files = new Map([['disk.obj', disk]]);
  const badFiles = [undefined, null, 5, {}, { main: 'disk.obj' }, { main: 'disk.obj', files: {} }];
  badFiles.push({ main: 'other.obj', files }, { files });
  badFiles.push({ main: 'disk.obj', files: new Map([['disk.obj', 'text']]) });
  for (const bad of badFiles) {
    assert.throws(() => core.load(bad), { code: 'usage' });
    assert.throws(() => core.parametrizeFile(bad), { code: 'usage' });
    await assert.rejects(core.prepare(bad), { code: 'usage' });
  }
  // Bytes of another realm, as those of Node's files are within a test runner.
  const other = runInNewContext('Uint8Array.from(bytes)', { bytes: [...disk] });
  assert.equal(other instanceof Uint8Array, false);
  assert.equal(core.load(asFiles('disk.obj', other)).info.usable, true);
  for (const bad of [null, 5]) assert.throws(() => model.listFeatures({ rims: true }, bad), { code: 'usage' }); // prettier-ignore
  assert.equal(model.info.usable, true);
});

test('the core looks at every option of every call in the thread that calls it, and at names that are none', async () => {
  const core = await createCore();
  const source = asFiles('disk.obj', disk);
  const mesh = { positions: [0, 0, 0, 1, 0, 0, 0, 1, 0], triangles: [0, 1, 2] };
  const model = core.load(source);
  const map = model.parametrize({ boundary: 'convex' });
  const calls = {
    load: (some) => core.load(source, some),
    loadMesh: (some) => core.loadMesh(mesh, some),
    ...callsOf(model, map),
    parametrizeFile: (some) => core.parametrizeFile(source, some),
    combine: (some) => core.combine([map], some),
  };
  const refused = (call, message) =>
    assert.throws(call, { name: 'HgpError', code: 'usage', message });
  for (const [call, act] of Object.entries(calls)) {
    for (const name of Object.keys(optionsOf[call])) refused(() => act({ [name]: [] }), new RegExp(`\\b${name} is .*an array`)); // prettier-ignore
    refused(() => act({ noSuchOption: 1 }), /noSuchOption/);
    for (const bad of [null, 5, 'text']) assert.throws(() => act(bad), { code: 'usage' }, call);
  }
  const all = [...Object.keys(optionsOf.loadMesh), ...Object.keys(optionsOf.parametrize)];
  for (const name of all) refused(() => core.parametrizeMesh({ ...mesh, [name]: [] }), /an array/);
  // A usable model is left, and what was refused is not remembered.
  assert.equal(model.parametrize({ boundary: 'convex' }).certificate.certified, true);
  assert.equal(map.write().certified, true);
});

test('the options that are checked are those that are declared, and those that the core reads', () => {
  const types = readFileSync(path.join(built, 'lib/options.d.ts'), 'utf8');
  const ofClient = readFileSync(path.join(built, 'lib/client.d.ts'), 'utf8');
  const declared = (name, from = types) => {
    const [, base, body] = from.match(
      new RegExp(`interface ${name}(?: extends (\\w+))? {\\n([^]*?)\\n}`),
    );
    const own = [...body.matchAll(/^ {4}(\w+)\?[:(]/gm)].map((match) => match[1]);
    return [...own, ...(base ? declared(base, from) : [])].sort();
  };
  const checked = (call) => Object.keys(optionsOf[call]).sort();
  assert.deepEqual(checked('load'), declared('LoadOptions'));
  assert.deepEqual(checked('suggestCones'), declared('SuggestOptions'));
  assert.deepEqual(checked('parametrize'), declared('SolveOptions'));
  assert.deepEqual(checked('verify'), declared('VerifyOptions'));
  assert.deepEqual(checked('write'), declared('WriteOptions'));
  assert.deepEqual(checked('loadMesh'), declared('MeshLoadOptions'));
  assert.deepEqual(checked('quads'), declared('QuadOptions'));
  assert.deepEqual(checked('createClient'), declared('ClientOptions', ofClient + types));
  assert.deepEqual(checked('call'), declared('CallOptions', ofClient));
  const [, combined] = types.match(/type CombineOptions = Pick<WriteOptions, ([^>]*)>/);
  assert.deepEqual(checked('combine'), combined.match(/\w+/g).sort());
  assert.ok(
    checked('parametrizeFile').includes('keepGoing') &&
      !checked('parametrizeFile').includes('cones'),
  );

  // What the core's table has for each call, and what the package takes out before.
  const tables = readTables();
  const ofCore = (call) => [...new Set(tables[call].map((row) => row.name.split('.')[0]))].sort();
  const without = (call, ...names) => checked(call).filter((name) => !names.includes(name));
  assert.deepEqual(without('load', 'name'), ofCore('load'));
  assert.deepEqual(without('parametrize', 'cones', 'field', 'features'), ofCore('solve'));
  assert.deepEqual(without('verify', 'cones', 'field', 'features'), ofCore('verify'));
  assert.deepEqual(checked('write'), ofCore('write'));
});

test('a buffer that was transferred is an error, not an empty file', () =>
  withClient(async (client) => {
    const gone = new Uint8Array(disk);
    structuredClone(0, { transfer: [gone.buffer] });
    await refused(client, () => client.load(gone, { name: 'disk.obj' }), /transferred/);
    await refused(client, () => client.load(gone.buffer, { name: 'disk.obj' }), /transferred/);
  }));

test('load accepts byte arrays, buffers, views, Blobs and sets of files', () =>
  withClient(async (client) => {
    const glb = toGlb([cube]);
    const buffer = glb.buffer.slice(glb.byteOffset, glb.byteOffset + glb.byteLength);
    for (const source of [glb, buffer, new DataView(buffer), new Blob([glb])]) {
      const model = await client.load(source);
      const map = await model.parametrize();
      // Bytes have no name; what is written is called after what they were.
      assert.match((await map.write()).name, /\.glb$/);
    }
    const files = { 'cube.obj': bytesOf(toObj(cube)) };
    assert.equal((await client.load({ main: 'cube.obj', files })).info.triangles, 108);
  }));

test('gzip is decompressed, every member of it, up to the limit', () =>
  withClient(async (client) => {
    const text = toObj(cube);
    const half = text.indexOf('\nf ') + 1;
    const parts = [text.slice(0, half), text.slice(half)].map((part) => gzipSync(part));
    const { info } = await client.load(new Uint8Array(Buffer.concat(parts)), {
      name: 'cube.obj.gz',
    });
    assert.equal(info.file.name, 'cube.obj');
    assert.equal(info.triangles, 108);
    const bomb = gzipSync(Buffer.alloc(1 << 24, ' '));
    await assert.rejects(client.load(bomb, { limits: { bytes: 1 << 20 } }), { code: 'limit' });
    await assert.rejects(client.load(gzipSync(text).subarray(0, 60)), { code: 'malformed' });
  }));

test('gzip: a wrong or missing byte is an error; bytes after the last member are ignored with a note', () =>
  withClient(async (client) => {
    const text = toObj(cube);
    const half = text.indexOf('\nf ') + 1;
    const members = [text.slice(0, half), text.slice(half)].map((part) => gzipSync(part));
    const all = Buffer.concat(members);
    const damaged = { code: 'malformed', message: 'The gzip data are damaged or cut off.' };
    const ends = [members[0].length, all.length];
    // In the data, the sum and the size of each member.
    for (const end of ends)
      for (const back of [30, 8, 5, 4, 1]) {
        const wrong = Buffer.from(all);
        wrong[end - back] ^= 1;
        await assert.rejects(client.load(wrong, { name: 'a.obj.gz' }), damaged, `${end} ${back}`);
      }
    for (const missing of [1, 4, 8, 9, 30]) {
      const cut = all.subarray(0, all.length - missing);
      await assert.rejects(client.load(cut, { name: 'a.obj.gz' }), damaged, `${missing}`);
    }
    const followed = (...parts) =>
      client
        .load(Buffer.concat([all, ...parts]), { name: 'a.obj.gz' })
        .then(({ info }) => info.notes);
    assert.deepEqual(await followed(Buffer.alloc(512)), []);
    assert.deepEqual(await followed(Buffer.from('rubbish')), [
      { code: 'read-gzip-longer', numbers: { bytes: 7 }, words: {}, where: [] },
    ]);
    const zeros = Buffer.concat([members[0], Buffer.alloc(100), members[1]]);
    assert.equal((await client.load(zeros, { name: 'a.obj.gz' })).info.triangles, 108);
  }));

test('arrays: vertices at the same place are joined, unless that is not wanted', () =>
  withClient(async (client) => {
    const soup = cube.triangles.flat().flatMap((v) => cube.vertices[v]);
    const joined = await client.parametrizeMesh({ positions: soup });
    assert.equal(joined.certificate.components.length, 1);
    assert.equal(joined.triangles.length, soup.length / 3);
    const apart = await client.parametrizeMesh({ positions: soup, weld: false });
    assert.equal(apart.certificate.components.length, 108);
  }));

test('a signal rejects with its own reason', () =>
  withClient(async (client) => {
    const model = await client.load(disk, { name: 'disk.obj' });
    const reason = new Error('the user left');
    await assert.rejects(model.inspect({ signal: AbortSignal.abort(reason) }), reason);
    const large = await client.load(bytesOf(bumpyDisk(60)), { name: 'large.obj' });
    await assert.rejects(large.parametrize({}, { signal: AbortSignal.timeout(20) }), {
      name: 'TimeoutError',
    });
  }));

test('in onProgress the model of the call can be neither used nor freed, and others can', async () => {
  const core = await createCore();
  const obj = bytesOf(toObj(cubeMesh(3)));
  const [model, other] = [1, 2].map(() => core.load(asFiles('cube.obj', obj)));
  const refused = [];
  const uses = [
    () => model.free(),
    () => model.inspect(),
    () => model.parametrize(),
    () => model.suggestCones(),
  ];
  core.onProgress = () => {
    for (const use of uses) {
      try {
        use();
        refused.push('nothing');
      } catch ({ code }) {
        refused.push(code);
      }
    }
    assert.equal(other.info.usable && other.inspect().usable, true);
  };
  const map = model.parametrize();
  core.onProgress = () => {
    throw new RangeError('my own mistake');
  };
  assert.throws(() => model.parametrize(), RangeError);
  core.onProgress = undefined;
  assert.ok(refused.length >= uses.length);
  assert.deepEqual([...new Set(refused)], ['usage']);
  // The map that was made meanwhile is whole, and the model is free again when its call has ended, however it did.
  assert.equal(map.write().certified, true);
  model.free();
  assert.throws(() => model.inspect(), { code: 'usage' });
});

test('a worker that cannot be started is said at the start', async () => {
  const wrong = { code: 'wasm-unavailable', message: /could not be started/ };
  await assert.rejects(createClient({ workerUrl: 'no URL' }), wrong);
  await assert.rejects(createClient({ workerUrl: 'file:///no/such/worker.js' }), (error) => {
    assert.equal(error.code, 'wasm-unavailable');
    assert.doesNotMatch(error.message, /next call/);
    return true;
  });
  await assert.rejects(createClient({ createWorker: () => 5 }), wrong);
});

test('a client whose start fails leaves no worker behind, and says why', async () => {
  const tell = (worker, type, members) => worker.dispatchEvent(Object.assign(new Event(type), members)); // prettier-ignore
  const answer = (error) => (worker, id) => tell(worker, 'message', { data: { id, error } });
  const failures = {
    internal: answer({ code: 'internal', message: 'no such thing' }),
    limit: answer({ code: 'limit', message: 'no memory' }),
    'wasm-unavailable': (worker) => tell(worker, 'error', { message: 'a wrong script' }),
  };
  for (const [code, fail] of Object.entries(failures)) {
    const workers = [];
    class Failing extends EventTarget {
      posted = [];
      postMessage(message) {
        this.posted.push(message.method);
        if (message.id > 0) setImmediate(() => fail(this, message.id));
      }
      terminate() {
        this.isEnded = true;
      }
    }
    const createWorker = () => (workers.push(new Failing()), workers.at(-1));
    await assert.rejects(createClient({ createWorker }), { name: 'HgpError', code });
    await new Promise((resolve) => setImmediate(resolve));
    assert.deepEqual(workers.map(({ posted, isEnded }) => [posted, isEnded]), [[['init', 'ready'], true]], code); // prettier-ignore
  }
});

test('a throw in onProgress rejects the call, and the next call works', () =>
  withClient(async (client) => {
    const model = await client.load(bytesOf(bumpyDisk(40)), { name: 'large.obj' });
    const onProgress = () => {
      throw new RangeError('my own mistake');
    };
    await assert.rejects(model.parametrize({}, { onProgress }), RangeError);
    assert.equal((await model.inspect()).usable, true);
  }));

test('unavailable WebAssembly is reported as an error', async () => {
  const unavailable = { code: 'wasm-unavailable' };
  await assert.rejects(createClient({ wasmUrl: 'file:///no/such/hgp.wasm' }), unavailable);
  await assert.rejects(createClient({ wasmBinary: bytesOf('no wasm') }), unavailable);
  // A module that compiles, but is another one: it lacks what the glue wants of it.
  const empty = new WebAssembly.Module(Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0));
  await assert.rejects(createCore({ wasmModule: empty }), unavailable);
});

test('hgp.wasm by URL, as a string as well', async () => {
  const url = new URL(`file://${path.join(built, 'hgp.wasm')}`);
  for (const wasmUrl of [url, url.href, path.join(built, 'hgp.wasm')]) {
    const client = await createClient({ wasmUrl, warmUp: false });
    client.terminate();
  }
});
