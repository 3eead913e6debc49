// Laws of the queue of calls, with a worker that a script plays: whatever is called, aborted, released or lost in whatever
// order, calls are made in the order in which they came, each ends once, and each finds the handles that it needs.

import assert from 'node:assert/strict';
import path from 'node:path';
import test from 'node:test';
import { randomFrom } from '../mutation/draw.mjs';
import { built, HgpError } from './support.mjs';

const { Queue } = await import(path.join(built, 'lib/queue.js'));
const turn = () => new Promise((resolve) => setImmediate(resolve));

const turns = async (count) => {
  for (let i = 0; i < count; i++) await turn();
};

/** A queue whose workers answer when they are told to, and take so many turns to start. */
function scripted(startTakes = () => 0) {
  const workers = [];
  const startWorker = async () => {
    await turns(startTakes());
    const worker = { posted: [], has: new Set(), isBusy: false, isEnded: false };
    workers.push(worker);
    return {
      post: (message) => worker.posted.push(structuredClone(message)),
      onMessage: (take) => (worker.tell = take),
      onLost: (take) => (worker.lose = take),
      idle: () => (worker.isBusy = false),
      busy: () => (worker.isBusy = true),
      terminate: () => (worker.isEnded = true),
    };
  };
  const queue = new Queue({ startWorker }, {}, {});
  const worker = () => workers.at(-1);
  /** The call that waits for an answer, if there is one. */
  const asked = () => (worker()?.isEnded ? undefined : worker()?.posted.find(({ id }) => id !== 0 && !worker().done?.has(id))); // prettier-ignore
  /** Answers it as a worker does that keeps what it was told to make. */
  const answer = (more = {}) => {
    const one = worker();
    const call = asked();
    (one.done ??= new Set()).add(call.id);
    for (const { id } of call.restore) one.has.add(id);
    if (call.makes !== undefined && !more.error) one.has.add(call.makes);
    if (call.method === 'release') one.has.delete(call.args[0]);
    one.tell({ id: call.id, result: `of ${call.method}`, has: [...one.has], ...more });
    return call;
  };
  return { queue, workers, worker, asked, answer };
}

/** How a call ends, as soon as it does. */
function ending(promise) {
  const end = {};
  promise.then(
    (value) => Object.assign(end, { value, count: (end.count ?? 0) + 1 }),
    (error) => Object.assign(end, { error, count: (end.count ?? 0) + 1 }),
  );
  return end;
}

test('calls are sent one after another in their order, each ends once, however they are aborted or the worker is lost', async () => {
  for (let seed = 1; seed <= 40; seed++) {
    const random = randomFrom(seed);
    const { queue, workers, worker, asked, answer } = scripted(() => Math.floor(4 * random()));
    const calls = [];
    for (let step = 0; step < 60; step++) {
      const what = random();
      const open = calls.filter(({ end }) => end.count === undefined);
      if (what < 0.45) {
        const controller = new AbortController();
        const listeners = new Set();
        const { signal } = controller;
        const [add, remove] = [signal.addEventListener, signal.removeEventListener];
        signal.addEventListener = (type, act, how) => (listeners.add(act), add.call(signal, type, act, how)); // prettier-ignore
        signal.removeEventListener = (type, act) => (listeners.delete(act), remove.call(signal, type, act)); // prettier-ignore
        const name = `call ${calls.length}`;
        const wait = random() < 0.3 ? turns(1 + Math.floor(4 * random())) : undefined;
        const end = ending(queue.add({ method: name }, () => (wait ? wait.then(() => [name]) : [name]), { signal })); // prettier-ignore
        calls.push({ name, controller, listeners, end });
      } else if (what < 0.6 && open.length > 0) {
        const one = open[Math.floor(random() * open.length)];
        one.reason = new Error(`no ${one.name}`);
        one.isLeftOut = !workers.some(({ posted }) =>
          posted.some(({ method }) => method === one.name),
        );
        one.controller.abort(one.reason);
      } else if (what < 0.65 && asked()) worker().lose('out of memory');
      else if (asked()) answer(random() < 0.2 ? { error: { code: 'no-map', message: 'no' } } : {});
      await turn();
      if (random() < 0.5) await turn();
      assert.ok(workers.filter(({ isEnded }) => !isEnded).length <= 1, 'one worker');
    }
    for (let i = 0; i < 400 && calls.some(({ end }) => end.count === undefined); i++) {
      if (asked()) answer();
      await turn();
    }
    const sent = workers.flatMap(({ posted }) => posted).filter(({ id }) => id !== 0).map(({ method }) => method); // prettier-ignore
    assert.deepEqual(sent, calls.map(({ name }) => name).filter((name) => sent.includes(name)), 'in their order, once'); // prettier-ignore
    for (const { name, end, reason, listeners, isLeftOut } of calls) {
      if (isLeftOut)
        assert.ok(!sent.includes(name), 'what is aborted before it is sent stays here');
      assert.equal(listeners.size, 0, 'nobody listens any more');
      assert.equal(end.count, 1, `${name} of seed ${seed}`);
      if (end.value !== undefined) assert.equal(end.value, `of ${name}`);
      else if (end.error !== reason) assert.ok(end.error instanceof HgpError && ['no-map', 'worker-lost'].includes(end.error.code)); // prettier-ignore
      if (reason && end.value === undefined && !(end.error instanceof HgpError)) assert.equal(end.error, reason); // prettier-ignore
      if (!sent.includes(name)) assert.equal(end.error, reason, 'what was not sent was aborted');
    }
    for (const { posted } of workers) assert.equal(posted[0].method, 'init');
    for (const { isBusy, isEnded } of workers) assert.ok(isEnded || !isBusy, 'a script may end');
  }
});

test('a call finds its model and map in whatever worker runs it; what was released is never made again', async () => {
  for (let seed = 1; seed <= 30; seed++) {
    const random = randomFrom(100 + seed);
    const pick = (all) => all[Math.floor(random() * all.length)];
    const { queue, worker, asked, answer } = scripted();
    const live = new Map();
    const ended = async (promise, act = answer) => {
      const end = ending(promise);
      for (let i = 0; i < 20 && end.count === undefined; i++) {
        await turn();
        if (asked()) act();
      }
      await turn();
      assert.equal(end.count, 1);
      return end;
    };
    /** Before a call is answered, the worker has all that it needs: of old or as the call makes it again. */
    const checked = (needs) => () => {
      const { restore } = asked();
      const made = new Set(worker().has);
      for (const { id, on } of restore) {
        assert.ok(live.has(id), 'it is still wanted');
        assert.ok(on === undefined || made.has(on), 'after that of which it is made');
        assert.ok(!made.has(id), 'once');
        made.add(id);
      }
      for (const id of needs) assert.ok(made.has(id), `${id} is there`);
      answer();
    };
    for (let step = 0; step < 40; step++) {
      const what = random();
      const models = [...live].filter(([, of]) => of === undefined).map(([id]) => id);
      const id = live.size > 0 ? pick([...live.keys()]) : 0;
      if (what < 0.25 || live.size === 0) {
        const makes = queue.newId();
        await ended(queue.add({ method: 'load', makes }, () => ['file', makes]));
        live.set(makes, undefined);
        assert.ok(queue.isLive(makes) && queue.recipeOf(makes).args[1] === makes);
      } else if (what < 0.5) {
        const [makes, on] = [queue.newId(), pick(models)];
        await ended(
          queue.add({ method: 'parametrize', on, makes }, () => [{}]),
          checked([on]),
        );
        live.set(makes, on);
        assert.equal(queue.isOfFile(makes), true);
      } else if (what < 0.7)
        await ended(queue.add({ method: 'inspect', on: id, needs: [models[0]] }, () => []), checked([id, models[0]])); // prettier-ignore
      else if (what < 0.8) {
        // The worker dies in the midst of a call.
        const { error } = await ended(queue.add({ method: 'inspect', on: id }, () => []), () => worker().lose('gone')); // prettier-ignore
        assert.equal(error.code, 'worker-lost');
      } else {
        await ended(queue.release(id));
        for (const [other, of] of [...live]) if (other === id || of === id) live.delete(other);
        assert.equal(queue.isLive(id), false);
        const refused = await ended(
          queue.add({ method: 'inspect', on: id }, () => []),
          assert.fail,
        );
        assert.equal(refused.error.code, 'usage');
      }
    }
    // All models, and nothing else, are there before they are needed.
    worker().lose('gone');
    await ended(queue.add({ method: 'ready' }, () => []), checked([...live].filter(([, of]) => of === undefined).map(([id]) => id))); // prettier-ignore
  }
});

test('of previews that wait the last one is made; an aborted one leaves the worker as it is', async () => {
  const { queue, workers, worker, asked, answer } = scripted();
  const makes = queue.newId();
  const loaded = ending(queue.add({ method: 'load', makes }, () => []));
  await turn();
  answer();
  await turn();
  assert.equal(loaded.count, 1);
  const superseded = { isOld: true };
  const preview = (name, call) => ending(queue.add({ method: name, on: makes, superseded }, () => [], call)); // prettier-ignore
  const controller = new AbortController();
  const first = preview('a', { signal: controller.signal });
  await turn();
  const waiting = ['b', 'c', 'd'].map((name) => preview(name));
  await turn();
  assert.deepEqual(
    waiting.map(({ value }) => value),
    [superseded, superseded, undefined],
  );
  assert.equal(asked().method, 'a');
  controller.abort(new Error('enough'));
  await turn();
  assert.equal(first.error.message, 'enough');
  assert.deepEqual([workers.length, worker().isEnded], [1, false]);
  assert.equal(asked().method, 'a', 'it is still under way');
  answer();
  await turn();
  assert.equal(asked().method, 'd');
  answer();
  await turn();
  assert.equal(waiting[2].value, 'of d');
  assert.equal(first.count, 1, 'the answer is ignored');
});

test('a call that is aborted while its arguments are read starts no worker', async () => {
  const { queue, workers } = scripted();
  const controller = new AbortController();
  const end = ending(queue.add({ method: 'load' }, () => turns(3).then(() => []), { signal: controller.signal })); // prettier-ignore
  await turn();
  controller.abort(new Error('enough'));
  await turns(6);
  assert.deepEqual([end.error.message, workers.length], ['enough', 0]);
});

test('a map that was aborted while its worker went on is let go when it is there', async () => {
  const { queue, worker, asked, answer } = scripted();
  const controller = new AbortController();
  const makes = queue.newId();
  const made = ending(queue.add({ method: 'load', makes }, () => [], { signal: controller.signal, keepWorker: true })); // prettier-ignore
  await turns(2);
  assert.ok(asked().leash, 'it can be stopped');
  controller.abort(new Error('enough'));
  await turn();
  assert.equal(made.error.message, 'enough');
  answer();
  await turns(2);
  assert.deepEqual([asked().method, asked().args], ['release', [makes]]);
  answer();
  await turns(2);
  assert.deepEqual([queue.isLive(makes), queue.recipeOf(makes), worker().isEnded], [false, undefined, false]); // prettier-ignore
});

test('the end of a client rejects all that waits, releases what is released, and ends the worker; nothing can be used then', async () => {
  const { queue, worker } = scripted();
  const makes = queue.newId();
  const running = ending(queue.add({ method: 'load', makes }, () => []));
  await turn();
  const waiting = ending(queue.add({ method: 'inspect' }, () => []));
  const releasing = ending(queue.add({ method: 'release' }, () => [makes]));
  queue.stop();
  await turn();
  assert.deepEqual([running.error.name, waiting.error.name, releasing.error, releasing.count], ['AbortError', 'AbortError', undefined, 1]); // prettier-ignore
  assert.equal(worker().isEnded, true);
  assert.equal(queue.isLive(makes), false);
  assert.equal(await queue.release(makes), undefined);
});

test('progress is told to its own call; what its callback throws ends the call, and the next gets another worker', async () => {
  const { queue, workers, worker, asked, answer } = scripted();
  const told = [];
  const one = ending(queue.add({ method: 'x' }, () => [], { onProgress: (now) => told.push(now.stage) })); // prettier-ignore
  await turn();
  assert.equal(asked().wantsProgress, true);
  const { id } = asked();
  for (const [of, stage] of [[id, 'a'], [id + 7, 'b'], [id, 'c']]) worker().tell({ id: of, progress: { stage } }); // prettier-ignore
  assert.deepEqual([told, one.count], [['a', 'c'], undefined]);
  answer();
  await turn();
  assert.deepEqual([one.value, worker().isBusy], ['of x', false]);
  const thrown = new Error('enough');
  const two = ending(queue.add({ method: 'y' }, () => [], { onProgress: () => { throw thrown; } })); // prettier-ignore
  await turn();
  assert.equal(worker().isBusy, true);
  worker().tell({ id: asked().id, progress: { stage: 'a' } });
  await turn();
  assert.deepEqual([two.error, workers[0].isEnded], [thrown, true]);
  const three = ending(queue.add({ method: 'z' }, () => []));
  await turn();
  assert.deepEqual([workers.length, asked().wantsProgress], [2, false]);
  answer();
  await turn();
  assert.equal(three.value, 'of z');
});
