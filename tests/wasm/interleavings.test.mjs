// Calls that overlap: whatever is called when, each call gives what it gives alone. One client is used by several
// parts of a program at once; buffers are reused, calls are cancelled, workers die, models are disposed of.

import assert from 'node:assert/strict';
import path from 'node:path';
import test from 'node:test';
import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { Worker } from 'node:worker_threads';
import * as THREE from 'three';
import { bumpyDisk } from '../support/disk.mjs';
import { faultOf } from '../support/frames.mjs';
import { cubeMesh, toGlb, toObj } from '../support/meshes.mjs';
import { torusMesh } from '../web/shapes.mjs';
import { built, bytesOf, createClient, withClient } from './support.mjs';
import { parametrizeGeometry } from '../../build/package/three.js';

const scaled = ({ vertices, triangles }, scale) => ({
  positions: Float64Array.from(vertices.flat(), (x) => scale * x),
  triangles: Uint32Array.from(triangles.flat()),
});
const largest = (numbers) => numbers.reduce((a, b) => Math.max(a, Math.abs(b)), 0);

test('two tori at once: each has its own map', () =>
  withClient(async (client) => {
    const [a, b] = [scaled(torusMesh(12, 8), 1), scaled(torusMesh(12, 8), 3)];
    const both = await Promise.all([a, b].map((mesh) => client.parametrizeMesh(mesh)));
    for (const [i, mesh] of [a, b].entries()) {
      assert.deepEqual(both[i].positions, mesh.positions);
      assert.deepEqual(both[i].uv, (await client.parametrizeMesh(mesh)).uv);
    }
  }));

test('two three.js geometries at once: each has its own map', () =>
  withClient(async (client) => {
    const make = [1, 3].map((scale) => () => new THREE.TorusGeometry(scale, scale / 3, 8, 12));
    const both = await Promise.all(make.map((one) => parametrizeGeometry(client, one())));
    for (const [i, one] of make.entries()) {
      const alone = await parametrizeGeometry(client, one());
      assert.deepEqual(both[i].geometry.attributes.uv.array, alone.geometry.attributes.uv.array);
    }
    assert.ok(largest(both[1].result.uv) > 2 * largest(both[0].result.uv));
  }));

test('calls run in the order made, also behind a file that is still being read', () =>
  withClient(async (client) => {
    const order = [];
    const slow = new Blob([bumpyDisk(30)]);
    const read = slow.arrayBuffer.bind(slow);
    slow.arrayBuffer = async () => {
      await new Promise((done) => setTimeout(done, 50));
      return read();
    };
    const first = client.load(slow, { name: 'slow.obj' }).then(() => order.push('file'));
    const second = client.loadMesh(scaled(cubeMesh(2), 1)).then(() => order.push('arrays'));
    await Promise.all([first, second]);
    assert.deepEqual(order, ['file', 'arrays']);
  }));

test('options and arrays are those of the moment of the call', () =>
  withClient(async (client) => {
    const mesh = scaled(torusMesh(9, 6), 1);
    const options = { q: 2 };
    const busy = client.parametrizeMesh(scaled(cubeMesh(4), 1));
    const first = client.parametrizeMesh({ ...mesh, ...options });
    const model = await client.loadMesh(mesh);
    const second = model.parametrize(options);
    options.q = 6;
    mesh.positions.fill(0);
    assert.equal((await first).cones.q, 2);
    assert.equal((await second).cones.q, 2);
    assert.ok(largest((await first).positions) > 1);
    await busy;
  }));

test('a buffer that its owner reuses or transfers is loaded again after a cancelled call', () =>
  withClient(async (client) => {
    const bytes = bytesOf(bumpyDisk(20));
    const gone = bytes.slice();
    const models = [
      await client.load(bytes, { name: 'disk.obj' }),
      await client.load(gone, { name: 'disk.obj' }),
    ];
    bytes.fill(32);
    structuredClone(gone, { transfer: [gone.buffer] });
    const stop = new AbortController();
    const solving = models[0].parametrize({ q: 4 }, { signal: stop.signal });
    setTimeout(() => stop.abort(), 20);
    await assert.rejects(solving, { name: 'AbortError' });
    for (const model of models) {
      assert.deepEqual(await model.inspect(), model.info);
      assert.equal((await model.parametrize({ boundary: 'convex' })).certificate.certified, true);
    }
  }));

/** A client with the messages that its workers get. */
async function watched() {
  const messages = [];
  const workers = [];
  const createWorker = () => {
    const worker = new Worker(path.join(built, 'node/worker.js'), { execArgv: [] });
    const post = worker.postMessage.bind(worker);
    worker.postMessage = (message, ...rest) => {
      messages.push(message);
      post(message, ...rest);
    };
    workers.push(worker);
    return worker;
  };
  const client = await createClient({ createWorker, warmUp: false });
  messages.length = 0;
  return { client, messages, workers };
}

test('one operation is one message; what a new worker lacks is in it', async () => {
  const { client, messages, workers } = await watched();
  const named = () => messages.splice(0).map(({ method, restore }) => [method, ...restore.map((one) => one.method)]); // prettier-ignore
  await client.parametrizeMesh(scaled(cubeMesh(3), 1));
  await parametrizeGeometry(client, new THREE.BoxGeometry());
  await client.parametrizeFile(toGlb([cubeMesh(2), cubeMesh(3)]), { name: 'two.glb' });
  assert.deepEqual(named(), [['parametrizeMesh'], ['parametrizeRendered'], ['parametrizeFile']]);
  const [model, other] = [
    await client.load(toGlb([cubeMesh(2)]), { name: 'a.glb' }),
    await client.load(toGlb([cubeMesh(3)]), { name: 'b.glb' }),
  ];
  const map = await model.parametrize();
  const { bytes } = await map.write();
  assert.deepEqual(named(), [['load'], ['load'], ['parametrize'], ['write']]);
  await workers[0].terminate();
  assert.deepEqual((await map.write()).bytes, bytes);
  assert.deepEqual(named(), [['init'], ['write', 'load', 'parametrize']]);
  assert.equal((await other.inspect()).triangles, 108);
  await other.inspect();
  await model.dispose();
  assert.deepEqual(named(), [['inspect', 'load'], ['inspect'], ['release']]);
  await other.dispose();
  await other.dispose();
  assert.deepEqual(named(), [['release']]);
  client.terminate();
});

test('a new client warms its engine up after it is ready, unless that is not wanted', async () => {
  const started = async (options) => {
    const methods = [];
    const createWorker = () => {
      const worker = new Worker(path.join(built, 'node/worker.js'), { execArgv: [] });
      const post = worker.postMessage.bind(worker);
      worker.postMessage = (message, ...rest) => {
        methods.push(message.method);
        post(message, ...rest);
      };
      return worker;
    };
    const client = await createClient({ createWorker, ...options });
    client.terminate();
    return methods;
  };
  assert.deepEqual(await started({}), ['init', 'ready', 'warmUp']);
  assert.deepEqual(await started({ warmUp: true }), ['init', 'ready', 'warmUp']);
  assert.deepEqual(await started({ warmUp: false }), ['init', 'ready']);
});

test('a waiting call that is aborted is never executed, and the running one goes on', async () => {
  const { client, messages } = await watched();
  const model = await client.load(bytesOf(bumpyDisk(20)), { name: 'disk.obj' });
  const stop = new AbortController();
  const first = model.parametrize({ boundary: 'convex' });
  const second = model.loops({ signal: stop.signal });
  const third = model.facts();
  stop.abort();
  await assert.rejects(second, { name: 'AbortError' });
  assert.equal((await first).certificate.certified, true);
  await third;
  assert.deepEqual(
    messages.map(({ method }) => method),
    ['load', 'parametrize', 'facts'],
  );
  client.terminate();
});

test('cancelling a file that is still being read leaves the worker alone', async () => {
  const { client, workers } = await watched();
  const endless = new Blob([bumpyDisk(4)]);
  endless.arrayBuffer = () => new Promise(() => undefined);
  const stop = new AbortController();
  const loading = client.load(endless, { name: 'x.obj' }, { signal: stop.signal });
  const behind = client.parametrizeMesh(scaled(cubeMesh(2), 1));
  setTimeout(() => stop.abort(), 5);
  await assert.rejects(loading, { name: 'AbortError' });
  assert.equal((await behind).certificate.certified, true);
  assert.equal(workers.length, 1);
  client.terminate();
});

test('what a program has lost is released', async () => {
  setFlagsFromString('--expose-gc');
  const collect = runInNewContext('gc');
  const { client, messages } = await watched();
  const lose = async () => void (await client.loadMesh(scaled(cubeMesh(2), 1)));
  for (let i = 0; i < 3; i++) await lose();
  for (let i = 0; i < 100 && !messages.some(({ method }) => method === 'release'); i++) {
    collect();
    await new Promise((done) => setTimeout(done, 10));
  }
  assert.ok(messages.some(({ method }) => method === 'release'));
  client.terminate();
});

/** Numbers from 0 to 1 that are the same in every run. */
function randomFrom(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

const sources = [
  () => ['disk.obj', bytesOf(bumpyDisk(5))],
  () => ['cube.glb', new Uint8Array(toGlb([cubeMesh(3)]))],
  () => ['torus.obj', bytesOf(toObj(torusMesh(8, 6)))],
  () => ['small.obj', bytesOf(toObj(cubeMesh(2)))],
];
const settings = [{ q: 4 }, { q: 2 }, { q: 6, scale: 'unit' }, { q: 4, conesFor: 'few' }];

/** What every call gives when nothing else happens: the oracle. */
async function resultsAlone() {
  const alone = { infos: [], maps: [], bytes: [], meshes: [] };
  for (const [i, make] of sources.entries()) {
    await withClient(
      async (client) => {
        const [name, bytes] = make();
        const model = await client.load(bytes, { name });
        alone.infos[i] = model.info;
        alone.maps[i] = [];
        alone.bytes[i] = [];
        for (const [k, options] of settings.entries()) {
          const map = await model.parametrize(options);
          alone.maps[i][k] = map.uv;
          alone.bytes[i][k] = (await map.write()).bytes;
        }
      },
      { warmUp: false },
    );
  }
  await withClient(async (client) => {
    for (const k of [0, 1])
      alone.meshes[k] = (await client.parametrizeMesh(scaled(torusMesh(8, 6), k + 1))).uv;
  });
  return alone;
}

const rounds = process.env.HGP_FULL ? 100 : 10;
const steps = 40;

/** Makes calls at random, some of them without waiting, and compares each with the oracle. */
async function play(random, alone) {
  const { client, workers } = await watched();
  const pick = (list) => list[Math.floor(random() * list.length)];
  const models = [];
  const maps = [];
  const dropped = [];
  const pending = [];
  let isKilled = 0;
  let checked = 0;
  /** The outcome of a call is that of the oracle; failures are those that were caused. */
  const expects = (promise, check, mayFail) =>
    pending.push(
      promise.then(
        (value) => {
          check(value);
          checked += 1;
        },
        (error) => {
          const isExpected = typeof mayFail === 'function' ? mayFail(error) : mayFail;
          const isCaused = isExpected || (isKilled > 0 && error.code === 'worker-lost');
          if (!isCaused) throw error;
        },
      ),
    );
  /** A signal that, with some probability, aborts after a while. */
  const call = () => {
    if (random() > 0.25) return { options: {}, mayFail: false };
    const stop = new AbortController();
    setTimeout(() => stop.abort(), 30 * random());
    return { options: { signal: stop.signal }, mayFail: true };
  };
  const acts = {
    load() {
      const i = Math.floor(random() * sources.length);
      const [name, bytes] = sources[i]();
      const { options, mayFail } = call();
      const loading = client.load(random() < 0.5 ? bytes : new Blob([bytes]), { name }, options);
      if (random() < 0.5) bytes.fill(48);
      else structuredClone(0, { transfer: [bytes.buffer] });
      const check = (model) => {
        assert.deepEqual(model.info, alone.infos[i]);
        models.push({ model, i });
      };
      expects(loading, check, mayFail);
    },
    parametrize() {
      if (models.length === 0) return;
      const { model, i } = pick(models);
      const k = Math.floor(random() * settings.length);
      const { options, mayFail } = call();
      const asked = { ...settings[k] };
      const solving = model.parametrize(asked, options);
      asked.q = 5;
      const check = (map) => {
        assert.deepEqual(map.uv, alone.maps[i][k]);
        maps.push({ map, i, k });
      };
      expects(solving, check, mayFail);
    },
    write() {
      if (maps.length === 0) return;
      const { map, i, k } = pick(maps);
      const { options, mayFail } = call();
      expects(map.write({}, options), ({ bytes }) => assert.deepEqual(bytes, alone.bytes[i][k]), mayFail); // prettier-ignore
    },
    drag() {
      const { map } = maps.length > 0 ? pick(maps) : {};
      const isUsed = (v) => map.cones.cones.some(({ vertex }) => vertex === v);
      const of = map?.cones.cones[0]?.vertex;
      const corner = map?.triangles.findIndex(
        (v, i) => v === of && !isUsed(map.triangles[beside(i)]),
      );
      if (corner === undefined || corner < 0) return;
      const to = map.triangles[beside(corner)];
      const isGone = (error) => map.isDisposed || error.code === 'worker-lost';
      const whole = async () => {
        const drag = await map.beginDrag(of);
        const frames = await Promise.all([of, to, of, to].map((v) => drag.dragTo(v)));
        const last = frames.at(-1);
        assert.notEqual(last.state, 'superseded');
        for (const frame of frames)
          if (frame.state === 'certified') assert.equal(faultOf(map.triangles, frame), '');
        const made = await drag.endDrag();
        assert.equal(made.certificate.certified, true);
        dropped.push({ made, bytes: (await made.write()).bytes });
      };
      // Beside a boundary the way may lead to it.
      expects(
        whole(),
        () => undefined,
        (error) => /no cone can be/.test(error.message) || isGone(error),
      );
    },
    inspect() {
      if (models.length === 0) return;
      const { model, i } = pick(models);
      expects(model.inspect(), (info) => assert.deepEqual(info, alone.infos[i]));
    },
    mesh() {
      const k = random() < 0.5 ? 0 : 1;
      const mesh = scaled(torusMesh(8, 6), k + 1);
      const { options, mayFail } = call();
      const solving = client.parametrizeMesh(mesh, options);
      mesh.positions.fill(NaN);
      expects(solving, ({ uv }) => assert.deepEqual(uv, alone.meshes[k]), mayFail);
    },
    dispose() {
      if (models.length < 3) return;
      const [{ model }] = models.splice(Math.floor(random() * models.length), 1);
      const isOf = ({ map }) => map.model === model;
      for (let at = maps.length - 1; at >= 0; at--) if (isOf(maps[at])) maps.splice(at, 1);
      const before = model.inspect();
      expects(before, (info) => assert.deepEqual(info, model.info));
      expects(model.dispose(), () => undefined);
      pending.push(assert.rejects(model.inspect(), { code: 'usage' }));
    },
    crash() {
      if (random() > 0.3) return;
      isKilled += 1;
      void workers.at(-1).terminate();
    },
  };
  const names = Object.keys(acts);
  for (let step = 0; step < steps; step++) {
    acts[pick(names)]();
    if (random() < 0.4) await pending.at(-1);
  }
  await Promise.all(pending);
  // Whatever happened, all that is left works.
  for (const { model, i } of models) assert.deepEqual(await model.inspect(), alone.infos[i]);
  for (const { map, i, k } of maps) assert.deepEqual((await map.write()).bytes, alone.bytes[i][k]);
  for (const { made, bytes } of dropped) {
    if (!made.isDisposed) assert.deepEqual((await made.write()).bytes, bytes);
  }
  client.terminate();
  drags += dropped.length;
  return checked;
}
let drags = 0;
/** The next corner of its triangle. */
const beside = (corner) => (corner % 3 === 2 ? corner - 2 : corner + 1);

test('calls at random, cancelled, with reused buffers and dying workers: each gives what it gives alone', async (t) => {
  const alone = await resultsAlone();
  let checked = 0;
  // How many maps are dragged depends on which calls are cancelled in time; more rounds follow until there are enough.
  for (let seed = 1; seed <= rounds || (drags < rounds && seed <= 2 * rounds); seed++) {
    await t.test(`seed ${seed}`, async () => {
      checked += await play(randomFrom(seed), alone);
    });
  }
  t.diagnostic(`${checked} results compared, ${drags} maps dragged`);
  assert.ok(drags >= rounds, `${drags} maps dragged`);
  assert.ok(checked >= rounds * 10, `${checked} results compared`);
});
