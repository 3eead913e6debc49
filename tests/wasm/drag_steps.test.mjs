// When a drag goes nearer to a vertex out of its reach, and what it remembers of its way. The core is a script here;
// drag.test.mjs drags in the built one.

import assert from 'node:assert/strict';
import path from 'node:path';
import test from 'node:test';
import { built, HgpError } from './support.mjs';

const { CoreDrag } = await import(path.join(built, 'lib/drag.js'));

/**
 * A drag from `start` in a core that prepares positions towards a vertex as `steps` lists them: −1 is none. A vertex is
 * certified once a step has reached it; the first that is asked for is near.
 */
function scripted(start, steps, { wantsPreparation = false } = {}) {
  const calls = [];
  let at = start;
  let isFreed = false;
  const near = (vertex) => vertex === at;
  class Drag {
    moveTo(vertex) {
      calls.push(`to ${vertex}`);
      const state = near(vertex) ? 'certified' : 'heat';
      return { state, wantsPreparation: state === 'heat' || wantsPreparation, cones: '{}' };
    }
    prepareToward(vertex) {
      const reached = steps.shift();
      calls.push(`toward ${vertex}`);
      if (reached === undefined) return { error: JSON.stringify({ code: 'internal', message: 'scripted' }) }; // prettier-ignore
      if (reached >= 0) at = reached;
      return { vertex: reached };
    }
    prepareHere() {
      calls.push('here');
      return {};
    }
    delete() {
      isFreed = true;
    }
  }
  const map = { current: () => map, beginDrag: () => ({}) };
  const drag = new CoreDrag({ Drag }, map, start);
  return { drag, calls, isFreed: () => isFreed, take: () => calls.splice(0) };
}

test('whatever vertex is reached on the way, it counts as nearer, the first of the mesh as well', () => {
  for (const vertices of [
    [4, 9, 20],
    [9, 0, 20],
    [0, 3, 20],
    [9, 3, 0],
  ]) {
    // prettier-ignore
    const goal = vertices.at(-1);
    const { drag, take } = scripted(30, [...vertices]);
    const first = drag.dragTo(goal);
    assert.deepEqual([first.state, first.isApproaching], ['heat', true], 'its scale first');
    assert.deepEqual(take(), [`to ${goal}`]);
    vertices.forEach((reached, i) => {
      const frame = drag.dragTo(goal);
      const isThere = reached === goal;
      assert.deepEqual([frame.state, frame.isApproaching, frame.vertex], [isThere ? 'certified' : 'heat', !isThere, goal]); // prettier-ignore
      assert.deepEqual(take(), [`to ${goal}`, `toward ${goal}`, `to ${goal}`]);
      assert.deepEqual(drag.path, [...vertices.slice(0, i + 1), reached]);
    });
    // It is there: nothing is prepared any more.
    drag.dragTo(goal);
    assert.deepEqual(take(), [`to ${goal}`]);
  }
});

test('where no nearer position has a map, the drag no longer approaches and remembers none', () => {
  const { drag, take } = scripted(0, [5, -1, 7]);
  const approaching = [20, 20, 20].map((vertex) => drag.dragTo(vertex).isApproaching);
  assert.deepEqual(approaching, [true, true, false]);
  assert.deepEqual(drag.path, [5, 5]);
  take();
  // Asked once more it begins anew, with the scale.
  assert.equal(drag.dragTo(20).isApproaching, true);
  assert.deepEqual(take(), ['to 20']);
  // Another vertex is no further step towards the one before.
  assert.equal(drag.dragTo(21).isApproaching, true);
  assert.deepEqual(take(), ['to 21']);
});

test('a neighbourhood is prepared once, where the core wants it, and kept in the path', () => {
  for (const wantsPreparation of [true, false]) {
    const { drag, take } = scripted(0, [], { wantsPreparation });
    drag.prepare();
    assert.deepEqual(take(), [], 'before anything was asked for');
    assert.equal(drag.dragTo(0).state, 'certified');
    take();
    drag.prepare();
    drag.prepare();
    assert.deepEqual(take(), wantsPreparation ? ['here'] : []);
    assert.deepEqual(drag.path, wantsPreparation ? [0, 0] : [0]);
    drag.dragTo(0);
    drag.prepare();
    assert.deepEqual(drag.path, wantsPreparation ? [0, 0] : [0], 'each position once');
  }
});

test('a drag whose core fails on the way has ended', () => {
  const { drag, isFreed } = scripted(0, []);
  drag.dragTo(20);
  assert.throws(() => drag.dragTo(20), { code: 'internal' });
  assert.ok(isFreed());
  assert.throws(() => drag.dragTo(20), { code: 'usage' });
});

test('what is released takes with it what was made of it, drags of its maps too; all else stays', async () => {
  const { serve } = await import(path.join(built, 'lib/worker.js'));
  const [{ CoreModel }, { CoreMap }] = await Promise.all(['core_model', 'core_map'].map((name) => import(path.join(built, `lib/${name}.js`)))); // prettier-ignore
  const freed = [];
  let made = 0;
  const handle = (Kind, members) => {
    const name = `${Kind.name} ${++made}`;
    const own = { free: () => freed.push(name), data: {}, info: {}, ...members };
    const values = Object.entries(own).map(([key, value]) => [key, { value }]);
    return Object.create(Kind.prototype, Object.fromEntries(values));
  };
  const drag = () => handle(CoreDrag);
  const map = () => handle(CoreMap, { beginDrag: drag });
  const core = { loadMesh: () => handle(CoreModel, { parametrize: map }) };
  const answers = [];
  const send = serve(async () => core, (answer) => answers.push(answer));
  let calls = 0;
  const call = async (method, more) => {
    const id = ++calls;
    send({ id, method, args: [], restore: [], wantsProgress: false, ...more });
    while (!answers.some((one) => one.id === id)) await new Promise((resolve) => setImmediate(resolve)); // prettier-ignore
    const { error, has } = answers.find((one) => one.id === id);
    assert.equal(error, undefined);
    return has;
  };
  send({ id: 0, method: 'init', args: [], restore: [] });
  // Models 1 and 2; maps 11 and 12 of the first, 21 of the second; of each map a drag.
  for (const model of [1, 2]) await call('loadMesh', { makes: model });
  for (const one of [11, 12, 21]) await call('parametrize', { on: Math.floor(one / 10), makes: one });
  for (const one of [111, 121, 211]) await call('beginDrag', { on: Math.floor(one / 10), makes: one, args: [0] }); // prettier-ignore
  const left = async (id) => (await call('release', { args: [id] })).toSorted((a, b) => a - b);
  assert.deepEqual(await left(111), [1, 2, 11, 12, 21, 121, 211]);
  assert.deepEqual(await left(12), [1, 2, 11, 21, 211]);
  await call('beginDrag', { on: 11, makes: 112, args: [0] });
  assert.deepEqual(await left(1), [2, 21, 211]);
  assert.deepEqual(await left(2), []);
  assert.equal(new Set(freed).size, made, 'each of them');
  assert.equal(freed.length, made, 'and once');
}); // prettier-ignore

test('a drag prepares once what comes next, when for eighty milliseconds no call has come, waited or been under way', async (t) => {
  const { serve } = await import(path.join(built, 'lib/worker.js'));
  const [{ CoreModel }, { CoreMap }] = await Promise.all(['core_model', 'core_map'].map((name) => import(path.join(built, `lib/${name}.js`)))); // prettier-ignore
  const handle = (Kind, members) => Object.create(Kind.prototype, Object.fromEntries(Object.entries({ data: {}, info: {}, ...members }).map(([key, value]) => [key, { value }]))); // prettier-ignore
  let prepared = 0;
  let fails = false;
  const prepare = () => {
    prepared += 1;
    if (fails) throw new HgpError({ code: 'no-map', message: 'so it is' });
  };
  const drag = handle(CoreDrag, { prepare, dragTo: () => ({ state: 'heat' }), path: [0] });
  let goOn;
  const core = {
    loadMesh: () => handle(CoreModel, { parametrize: () => handle(CoreMap, { beginDrag: () => drag }) }),
    prepare: () => new Promise((resolve) => (goOn = resolve)),
    parametrizeFile: () => ({}),
  }; // prettier-ignore
  t.mock.timers.enable({ apis: ['setTimeout'] });
  const turn = () => new Promise((resolve) => setImmediate(resolve));
  const answered = [];
  const send = serve(async () => core, ({ id }) => answered.push(id)); // prettier-ignore
  let calls = 0;
  const ask = (method, more) => send({ id: ++calls, method, args: [], restore: [], wantsProgress: false, ...more }); // prettier-ignore
  const step = () => ask('dragTo', { on: 3, args: [5] });
  const read = () => ask('parametrizeFile', { args: [{ main: 'a', files: new Map() }, {}] });
  const passes = async (milliseconds, expected, what) => {
    await turn();
    t.mock.timers.tick(milliseconds);
    await turn();
    assert.equal(prepared, expected, what);
  };
  send({ id: 0, method: 'init', args: [], restore: [] });
  ask('loadMesh', { makes: 1 });
  ask('parametrize', { on: 1, makes: 2 });
  ask('beginDrag', { on: 2, makes: 3, args: [0] });
  await passes(1000, 0, 'no step was made');
  step();
  await passes(79, 0);
  await passes(1, 1, 'at rest');
  await passes(1000, 1, 'once');
  // A call that comes in the meantime, and takes its time.
  step();
  await passes(70, 1);
  read();
  await passes(1000, 1, 'a call is under way');
  goOn({});
  await passes(79, 1);
  await passes(1, 2);
  // Calls that wait behind a step, and steps that wait behind a call.
  step();
  read();
  await passes(1000, 2, 'a call was waiting');
  step();
  goOn({});
  await passes(79, 2);
  await passes(1, 3);
  // What goes wrong at rest ends nothing.
  fails = true;
  step();
  await passes(80, 4);
  fails = false;
  step();
  await passes(80, 5);
  assert.deepEqual(
    answered,
    Array.from({ length: calls }, (_, i) => i + 1),
  );
});
