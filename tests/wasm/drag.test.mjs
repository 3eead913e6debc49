// A cone that is dragged: every certified frame is a map by an independent check; previews are superseded, never end
// the worker, and go on in the next one.

import assert from 'node:assert/strict';
import path from 'node:path';
import test from 'node:test';
import { Worker } from 'node:worker_threads';
import { blocks, ring } from '../support/blocks.mjs';
import { bumpyDisk } from '../support/disk.mjs';
import { assertCertified, faultOf, walk } from '../support/frames.mjs';
import { cubeMesh } from '../support/meshes.mjs';
import { built, bytesOf, createClient, createCore, withClient } from './support.mjs';

const arraysOf = ({ vertices, triangles }) => ({
  positions: new Float64Array(vertices.flat()),
  triangles: new Uint32Array(triangles.flat()),
});

/** In a worker: no timer of 80 ms, which is the rest after which a drag prepares where it is, so that its path depends on time. */
const restless = `const later = globalThis.setTimeout;
  globalThis.setTimeout = (act, ms, ...args) => (ms === 80 ? 0 : later(act, ms, ...args));`;

/** A client with its workers and the names of the messages that they get. */
async function watched({ rests = true } = {}) {
  const [messages, workers] = [[], []];
  const execArgv = rests
    ? []
    : ['--import', `data:text/javascript,${encodeURIComponent(restless)}`];
  const createWorker = () => {
    const worker = new Worker(path.join(built, 'node/worker.js'), { execArgv });
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

/** A map of a rounded cube, and a walk of a cone. */
async function mapped(client, { mesh = cubeMesh(12), options = {}, steps = 12 } = {}) {
  const model = await client.loadMesh(arraysOf(mesh));
  const map = await model.parametrize(options);
  const cones = map.cones.cones.map(({ vertex }) => vertex);
  const isFree = (v) => !cones.includes(v);
  const track = walk(map, await model.facts(), cones[0], steps, isFree);
  return { model, map, cone: cones[0], track };
}

for (const [name, setting] of Object.entries({
  'a sphere': {},
  'a sphere with q = 6': { options: { q: 6 } },
  'a ring of blocks, across its handle': { mesh: blocks(ring, { n: 6 }), steps: 30 },
})) {
  test(`every frame of a long drag is a map with its cones by a check of its arrays: ${name}`, () =>
    withClient(async (client) => {
      const { map, cone, track } = await mapped(client, setting);
      assert.ok(track.length > 8, `${track.length} steps`);
      const drag = await map.beginDrag(cone);
      let certified = 0;
      for (const vertex of track) {
        const frame = await drag.dragTo(vertex);
        assert.notEqual(frame.state, 'superseded');
        assert.equal(frame.vertex, vertex);
        assert.ok(frame.cones.cones.some((one) => one.vertex === vertex));
        assert.ok(frame.logScale.length === map.positions.length / 3);
        if (frame.state !== 'certified') continue;
        assertCertified(map.triangles, frame);
        certified += 1;
      }
      assert.ok(certified >= 0.9 * track.length, `${certified} of ${track.length}`);
      const dropped = await drag.endDrag();
      assert.equal(dropped.certificate.certified, true);
      assertCertified(dropped.triangles, dropped);
      assert.ok(drag.isDisposed);
      const { bytes, certified: isWritten } = await dropped.write();
      assert.ok(isWritten && bytes.length > 0);
    }));
}

test('a leap is reached by asking again, also by the next worker when one dies', async () => {
  const { client, workers } = await watched();
  const { map, cone } = await mapped(client, { mesh: cubeMesh(16) });
  const { positions } = map;
  const cones = map.cones.cones.map(({ vertex }) => vertex);
  const edge = Math.max(...positions) - Math.min(...positions);
  // From a corner of the cube to a vertex one edge of the cube away: sixteen edges of triangles.
  const away = (v) =>
    Math.abs(
      Math.hypot(...[0, 1, 2].map((i) => positions[3 * v + i] - positions[3 * cone + i])) - edge,
    );
  let far = cones.includes(0) ? 1 : 0;
  for (let v = 0; v < positions.length / 3; v++)
    if (!cones.includes(v) && away(v) < away(far)) far = v;
  const drag = await map.beginDrag(cone);
  const frames = [];
  do frames.push(await drag.dragTo(far));
  while (frames.at(-1).isApproaching);
  assert.ok(frames.length > 1, 'it is far');
  assert.ok(frames.slice(0, -1).every(({ state }) => state === 'heat'));
  assert.equal(frames.at(-1).state, 'certified');
  assertCertified(map.triangles, frames.at(-1));
  const dropped = await drag.endDrag();
  assert.ok(dropped.cones.cones.some(({ vertex }) => vertex === far));
  const { bytes } = await dropped.write();
  await workers.at(-1).terminate();
  assert.deepEqual((await dropped.write()).bytes, bytes, 'made again from its path');
  client.terminate();
});

test('the check of frames refuses a flipped triangle, a torn seam and a wrong cone', () =>
  withClient(async (client) => {
    const { map, cone, track } = await mapped(client);
    const drag = await map.beginDrag(cone);
    const frame = await drag.dragTo(track[0]);
    const flipped = { ...frame, uv: frame.uv.map((x, i) => (i % 2 ? -x : x)) };
    assert.match(faultOf(map.triangles, flipped), /not positive/);
    assert.match(faultOf(map.triangles, { ...frame, cones: map.cones }), /turns at vertex/);
    const one = frame.cornerToUv[0];
    const torn = frame.uv.map((x, i) => (i === 2 * one ? x + 1e-3 : x));
    assert.notEqual(faultOf(map.triangles, { ...frame, uv: torn }), '');
  }));

test('one preview waits; an older one is superseded and never sent', async () => {
  const { client, messages } = await watched();
  const { map, model, cone, track } = await mapped(client);
  const drag = await map.beginDrag(cone);
  messages.length = 0;
  const busy = model.parametrize({ q: 2 });
  const previews = track.slice(0, 4).map((vertex) => drag.dragTo(vertex));
  const behind = model.inspect();
  const states = (await Promise.all(previews)).map(({ state }) => state);
  assert.deepEqual(states, ['superseded', 'superseded', 'superseded', 'certified']);
  assert.deepEqual((await previews[1]).vertex, track[1]);
  await Promise.all([busy, behind]);
  const sent = messages.map(({ method }) => method);
  assert.deepEqual(sent, ['parametrize', 'dragTo', 'inspect']);
  assertCertified(map.triangles, await previews[3]);
  client.terminate();
});

test('two drags have a slot each', () =>
  withClient(async (client) => {
    const { map, model, cone, track } = await mapped(client);
    const drags = [await map.beginDrag(cone), await map.beginDrag(cone)];
    void model.facts();
    const frames = await Promise.all(drags.map((drag) => drag.dragTo(track[0])));
    assert.deepEqual(frames[0], frames[1]);
    assert.equal(frames[0].state, 'certified');
  }));

test('aborting a preview leaves the worker and the drag alone', async () => {
  const { client, workers } = await watched();
  const { map, cone, track } = await mapped(client);
  const drag = await map.beginDrag(cone);
  const stop = new AbortController();
  const running = drag.dragTo(track[0], { signal: stop.signal });
  // It goes to the worker, whose answer cannot be seen before this turn ends.
  for (let i = 0; i < 50; i++) await null;
  const waiting = drag.dragTo(track[1], { signal: stop.signal });
  stop.abort();
  await assert.rejects(running, { name: 'AbortError' });
  await assert.rejects(waiting, { name: 'AbortError' });
  assertCertified(map.triangles, await drag.dragTo(track[2]));
  assert.equal(workers.length, 1);
  client.terminate();
});

test('a drag goes on in the next worker when one dies, with the maps that it would have had', async () => {
  const { client, workers } = await watched({ rests: false });
  const { map, cone, track } = await mapped(client);
  const alone = await map.beginDrag(cone);
  const expected = [];
  for (const vertex of track) {
    expected.push(await alone.dragTo(vertex));
    await new Promise((resolve) => setTimeout(resolve, 60)); // as on a busy machine
  }
  const drag = await map.beginDrag(cone);
  for (const vertex of track.slice(0, 6)) await drag.dragTo(vertex);
  const lost = drag.dragTo(track[6]);
  void workers.at(-1).terminate();
  await assert.rejects(lost, { code: 'worker-lost' });
  for (const [i, vertex] of track.entries()) {
    if (i < 6) continue;
    assert.deepEqual(await drag.dragTo(vertex), expected[i]);
  }
  const [one, other] = [await alone.endDrag(), await drag.endDrag()];
  assert.deepEqual(one.uv, other.uv);
  const { bytes } = await one.write();
  await workers.at(-1).terminate();
  assert.deepEqual((await other.write()).bytes, bytes, 'made again from its path');
  assert.equal(workers.length, 3);
  client.terminate();
});

test('a drag of a dropped map is made again with both drags; the first map may be gone', async () => {
  const { client, workers } = await watched();
  const { map, cone, track } = await mapped(client);
  const first = await map.beginDrag(cone);
  await first.dragTo(track[0]);
  const half = await first.endDrag();
  await map.dispose();
  const second = await half.beginDrag(track[0]);
  await second.dragTo(track[2]);
  const done = await second.endDrag();
  await half.dispose();
  const { bytes } = await done.write();
  await workers.at(-1).terminate();
  assert.deepEqual((await done.write()).bytes, bytes);
  assertCertified(done.triangles, done);
  client.terminate();
});

test('a run with the cones of a drag depends on nothing else', () =>
  withClient(async (client) => {
    const { map, model, cone, track } = await mapped(client);
    const drag = await map.beginDrag(cone);
    for (const vertex of track.slice(0, 3)) await drag.dragTo(vertex);
    const dropped = await drag.endDrag();
    const fresh = await model.parametrize({ cones: dropped.cones });
    const alone = await withClient(async (other) => {
      const again = await other.loadMesh(arraysOf(cubeMesh(12)));
      return again.parametrize({ cones: dropped.cones });
    });
    assert.deepEqual(fresh.uv, alone.uv);
    assert.notDeepEqual(fresh.uv, dropped.uv);
  }));

test('a run that keeps the worker stops at its next step, and leaves maps and later runs as they would be', async () => {
  const { client, messages, workers } = await watched();
  const { map, model, cone, track } = await mapped(client);
  const moved = { ...map.cones, cones: map.cones.cones.map((one) => ({ ...one })) };
  moved.cones.find(({ vertex }) => vertex === cone).vertex = track[0];
  const stop = new AbortController();
  const stages = [];
  const onProgress = ({ stage }) => {
    stages.push(stage);
    stop.abort();
  };
  const call = { signal: stop.signal, keepWorker: true, onProgress };
  await assert.rejects(model.parametrize({ cones: moved }, call), { name: 'AbortError' });
  assert.equal(stages.length, 1, 'nothing is reported of a call that was aborted');
  await assert.rejects(model.parametrize({ cones: moved }, call), { name: 'AbortError' });
  const waiting = new AbortController();
  const busy = model.parametrize({ q: 2 });
  const never = model.inspect({ signal: waiting.signal, keepWorker: true });
  waiting.abort();
  await assert.rejects(never, { name: 'AbortError' });
  await busy;
  messages.length = 0;
  const drag = await map.beginDrag(cone);
  assertCertified(map.triangles, await drag.dragTo(track[0]));
  await drag.dispose();
  assert.ok(
    messages.every(({ restore }) => restore.length === 0),
    'everything is still there',
  );
  const run = await model.parametrize({ cones: moved }, { keepWorker: true });
  const alone = await withClient(async (other) => {
    const again = await other.loadMesh(arraysOf(cubeMesh(12)));
    return again.parametrize({ cones: moved });
  });
  assert.deepEqual(run.uv, alone.uv);
  assert.equal(workers.length, 1);
  client.terminate();
});

test('a map that was finished when its run was aborted does not stay in the worker', async () => {
  const { client, messages, workers } = await watched();
  const { model } = await mapped(client);
  messages.length = 0;
  const stop = new AbortController();
  const late = model.parametrize({ q: 2 }, { signal: stop.signal, keepWorker: true });
  const answered = new Promise((done) => {
    workers[0].on('message', ({ result }) => result && done());
  });
  // The answer is there before the client reads it: both happen in one turn.
  workers[0].prependOnceListener('message', () => stop.abort());
  await answered;
  await assert.rejects(late, { name: 'AbortError' });
  await model.inspect();
  assert.deepEqual(
    messages.map(({ method }) => method),
    ['parametrize', 'release', 'inspect'],
  );
  client.terminate();
});

test('the scale of cones is that of their map, before there is one', () =>
  withClient(async (client) => {
    const { map, model, cone, track } = await mapped(client);
    const drag = await map.beginDrag(cone);
    const { cones, logScale } = await drag.dragTo(track[0]);
    const scale = await model.logScale(cones);
    assert.equal(scale.length, logScale.length);
    assert.ok(scale.every((u, v) => Math.abs(u - logScale[v]) < 1e-4));
    assert.ok(Math.max(...scale) - Math.min(...scale) > 0.1);
    const few = { ...cones, cones: cones.cones.slice(1) };
    await assert.rejects(model.logScale(few), { code: 'prescription' });
    await assert.rejects(model.logScale({}), { code: 'usage' });
  }));

test('what cannot be dragged is refused with what can be done', () =>
  withClient(async (client) => {
    const { map, cone, track } = await mapped(client);
    await assert.rejects(map.beginDrag(track[0]), { code: 'usage', message: /is not a cone/ });
    // Beyond 2³¹ as well, where a number of 32 bits would be another one.
    for (const bad of [-1, 2 ** 31, 2 ** 32, 2 ** 32 + track[0]])
      await assert.rejects(map.beginDrag(bad), { code: 'usage', message: /an integer from 0 to/ });
    const drag = await map.beginDrag(cone);
    const other = map.cones.cones[1].vertex;
    await assert.rejects(drag.dragTo(other), { code: 'usage', message: /another cone/ });
    await assert.rejects(drag.dragTo('1'), { code: 'usage' });
    assert.equal((await drag.dragTo(track[0])).state, 'certified', 'it goes on');
    await drag.dispose();
    await assert.rejects(drag.dragTo(track[1]), { code: 'usage', message: /disposed of/ });
    const disk = await client.load(bytesOf(bumpyDisk(8)), { name: 'disk.obj' });
    const flat = await disk.parametrize({ boundary: 'convex' });
    await assert.rejects(flat.beginDrag(0), { code: 'usage' });
    const going = await map.beginDrag(cone);
    await map.dispose();
    assert.ok(going.isDisposed, 'with its map');
  }));

test('the core itself drags in the thread that calls it', async () => {
  const core = await createCore();
  const model = core.loadMesh(arraysOf(cubeMesh(12)));
  const map = model.parametrize();
  const [cone, second] = map.cones.cones.map(({ vertex }) => vertex);
  const track = walk(map, model.facts(), cone, 3, (v) => v !== second);
  const drag = map.beginDrag(cone);
  assertCertified(map.triangles, drag.dragTo(track[0]));
  model.parametrize({ q: 2 });
  assertCertified(map.triangles, drag.dragTo(track[1]));
  assertCertified(map.triangles, drag.endDrag());
  assert.throws(() => drag.dragTo(track[2]), { code: 'usage', message: 'this drag has ended' });
  const late = map.beginDrag(cone);
  model.free();
  assert.throws(() => late.dragTo(track[0]), { code: 'usage' });
  late.free();
});
