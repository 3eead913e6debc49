// Extracts the numbers of tests from the output of ctest, GoogleTest and node:test.

const first = (text, pattern) => Number(text.match(pattern)?.[1] ?? 0);

/** The counts of one ctest test: those of all tests of a GoogleTest program, otherwise one. */
function countBlock(name, block) {
  const ended = /^Test (Passed\.|Pass Reason:)$/m.test(block);
  if (!block.includes('[==========]')) {
    return { passed: ended ? 1 : 0, failed: ended ? 0 : 1, skipped: 0, notes: [] };
  }
  const failed = first(block, /\[ {2}FAILED {2}\] (\d+) tests?, listed below/);
  const counts = {
    passed: first(block, /\[ {2}PASSED {2}\] (\d+) tests?\./),
    skipped: first(block, /\[ {2}SKIPPED \] (\d+) tests?, listed below/),
    failed: !ended && failed === 0 ? 1 : failed, // a crash leaves no summary
    notes: [],
  };
  if (counts.passed + counts.failed + counts.skipped === 0) {
    counts.failed = 1;
    counts.notes.push(`${name}: no test was counted`);
  }
  for (const [, reason] of block.matchAll(/Skipped\n([\s\S]*?)\n\[ {2}SKIPPED/g)) {
    counts.notes.push(`skipped in ${name}: ${reason.trim()}`);
  }
  return counts;
}

/**
 * @param {string} log  Testing/Temporary/LastTest.log
 * @returns the total counts, and those of each test by name in `tests`
 */
export function countCtest(log) {
  const counts = { passed: 0, failed: 0, skipped: 0, notes: [], tests: new Map() };
  // A block runs from "3/9 Testing: name" to "Test Passed." or "Test Failed.".
  // GoogleTest colours its output if it takes the pipe for a terminal (as in WebAssembly).
  // eslint-disable-next-line no-control-regex
  const plain = log.replace(/\x1b\[[\d;]*m/g, '');
  for (const block of plain.split(/^\d+\/\d+ Testing: /m).slice(1)) {
    const name = block.slice(0, block.indexOf('\n'));
    const own = countBlock(name, block);
    counts.tests.set(name, own);
    for (const key of ['passed', 'failed', 'skipped']) counts[key] += own[key];
    counts.notes.push(...own.notes);
  }
  return counts;
}

/** @param {string} tap  output of node --test --test-reporter=tap */
export function countNodeTest(tap) {
  const counts = {
    passed: first(tap, /^# pass (\d+)$/m),
    failed: first(tap, /^# fail (\d+)$/m) + first(tap, /^# cancelled (\d+)$/m),
    skipped: first(tap, /^# skipped (\d+)$/m) + first(tap, /^# todo (\d+)$/m),
    notes: [],
  };
  for (const [line] of tap.matchAll(/^ *ok .* # SKIP.*$/gm)) counts.notes.push(line.trim());
  for (const match of tap.matchAll(/^( *)not ok [\s\S]*?\n\1 {2}\.\.\.$/gm)) {
    counts.notes.push(
      match[0]
        .replace(/^ *(duration_ms|location|failureType):.*\n/gm, '')
        .replace(/^ *(stack|expected|actual|code|name|operator):[\s\S]*/m, '')
        .slice(0, 3000),
    );
  }
  return counts;
}

/** @param {string} text  output of pytest -q  @param {number} code  its exit code */
export function countPytest(text, code) {
  const last = text.trimEnd().split('\n').at(-1);
  const count = (word) => first(last, new RegExp(`(\\d+) ${word}`));
  const failed = count('failed') + count('errors?');
  const notes = [...text.matchAll(/^(FAILED|ERROR|E {2}) .*$/gm)].map(([line]) => line);
  return {
    passed: count('passed'),
    failed: code === 0 ? failed : Math.max(1, failed),
    skipped: count('skipped'),
    notes: failed > 0 || code !== 0 ? notes.slice(0, 60) : [],
  };
}
