// Results that are kept between runs: what has changed, failed or was skipped runs again.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import test, { after } from 'node:test';
import { countCtest, countNodeTest } from '../support/counts.mjs';
import { contentOf, KeptResults, listingOf } from '../support/results.mjs';

const folder = mkdtempSync(path.join(os.tmpdir(), 'hgp-results-'));
after(() => rmSync(folder, { recursive: true }));
const input = path.join(folder, 'input/file.txt');
const put = (text) => writeFileSync(input, text);
const passed = { passed: 3, failed: 0, skipped: 0 };
const kept = new KeptResults(path.join(folder, 'input'));
put('one');

test('keys depend on the contents of a file, and of all files in a folder', () => {
  const [file, all] = [contentOf(input), contentOf(path.dirname(input))];
  const listed = listingOf(path.dirname(input));
  put('two');
  assert.notEqual(contentOf(input), file);
  assert.notEqual(contentOf(path.dirname(input)), all);
  assert.notEqual(listingOf(path.dirname(input)), listed);
  put('one');
  assert.equal(contentOf(input), file);
  assert.equal(contentOf(path.dirname(input)), all);
});

test('a passed result is found again for the same inputs and for no others', () => {
  const store = new KeptResults(path.join(folder, 'passed'));
  const key = store.key('test', contentOf(input));
  if (key === null) {
    // No list of the system's packages: nothing is kept here.
    store.keep(key, key, 'test', passed);
    assert.equal(store.find(key), undefined);
    return;
  }
  assert.equal(store.find(key), undefined);
  store.keep(key, key, 'test', passed);
  assert.deepEqual(store.find(key), { ...passed, unchanged: 3, notes: [] });
  put('two');
  assert.equal(store.find(store.key('test', contentOf(input))), undefined);
  put('one');
  const again = new KeptResults(path.join(folder, 'passed'), { isRead: false });
  assert.equal(again.find(key), undefined);
});

test('results that failed, were skipped, ran nothing or changed meanwhile are not kept', () => {
  const store = new KeptResults(path.join(folder, 'failed'));
  const key = store.key('test');
  store.keep(key, key, 'test', { ...passed, failed: 1 });
  store.keep(key, key, 'test', { ...passed, skipped: 1 });
  store.keep(key, key, 'test', { ...passed, passed: 0 });
  store.keep(key, store.key('other'), 'test', passed);
  assert.equal(store.find(key), undefined);
  assert.equal(kept.find(null), undefined);
});

test('an HGP_ environment variable is an input of every test', () => {
  const before = new KeptResults(path.join(folder, 'variables')).key('test');
  process.env.HGP_RESULTS_TEST = '1';
  const after = new KeptResults(path.join(folder, 'variables')).key('test');
  delete process.env.HGP_RESULTS_TEST;
  if (before !== null) assert.notEqual(before, after);
});

test('each test of ctest has counts of its own', () => {
  const log = `1/4 Testing: a
[==========] 3 tests
[  PASSED  ] 2 tests.
[  SKIPPED ] 1 test, listed below
Test Passed.
2/4 Testing: b
Test Failed.
3/4 Testing: c
Test Pass Reason:
Required regular expression found. Regex=[x]
4/4 Testing: d
Test Fail Reason:
Required regular expression not found. Regex=[x]
`;
  const counts = countCtest(log);
  assert.deepEqual([counts.passed, counts.failed, counts.skipped], [3, 2, 1]);
  assert.equal(counts.tests.get('a').skipped, 1);
  assert.equal(counts.tests.get('b').failed, 1);
  assert.equal(counts.tests.get('d').failed, 1);
});

test('the note of a failed test of Node says why, and leaves out where and for how long it ran', () => {
  const file = path.join(folder, 'fails.test.mjs');
  writeFileSync(
    file,
    "import test from 'node:test'; test('odd', () => { throw Error('a\\nb'); });",
  );
  const own = { ...process.env };
  delete own.NODE_TEST_CONTEXT; // or the inner runner reports to this one
  const arguments_ = ['--test', '--test-reporter=tap', file];
  const { stdout } = spawnSync(process.execPath, arguments_, { env: own, encoding: 'utf8' });
  const { failed, notes } = countNodeTest(stdout);
  assert.equal(failed, 1);
  assert.equal(notes.length, 1);
  assert.match(notes[0], /^not ok 1 - odd\n *---\n *error: \|-\n *a\n *b\n$/);
});
