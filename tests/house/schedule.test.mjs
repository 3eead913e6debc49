// The order in which stages of a test run are begun.

import assert from 'node:assert/strict';
import test from 'node:test';
import { runInOrder } from '../support/schedule.mjs';

async function traceOf(stages) {
  const trace = [];
  let running = 0;
  await runInOrder(new Map(Object.entries(stages)), async (name) => {
    running += 1;
    trace.push([name, running]);
    await new Promise((resolve) => setTimeout(resolve, stages[name].time ?? 1));
    running -= 1;
    trace.push([`/${name}`]);
  });
  return trace;
}
const at = (trace, name) => trace.findIndex(([one]) => one === name);

test('a stage starts when its prerequisites have ended; others may overtake it', async () => {
  const trace = await traceOf({ a: { time: 20 }, b: { after: ['a'] }, c: {} });
  assert.ok(at(trace, 'b') > at(trace, '/a') && at(trace, 'c') < at(trace, '/a'));
});

test('a stage that measures time runs alone, and at most two run at a time', async () => {
  const trace = await traceOf({ a: {}, b: { isAlone: true }, c: {}, d: { time: 5 }, e: {} });
  assert.equal(trace.find(([name]) => name === 'b')[1], 1);
  assert.ok(Math.max(...trace.map(([, running]) => running ?? 0)) === 2);
  const during = trace.slice(at(trace, 'b') + 1, at(trace, '/b'));
  assert.deepEqual(during, []);
});

test('stages outside the run are not prerequisites; a cycle is an error', async () => {
  assert.equal((await traceOf({ a: { after: ['left out'] } })).length, 2);
  await assert.rejects(
    traceOf({ a: { after: ['b'] }, b: { after: ['a'] } }),
    /wait for one another/,
  );
});
