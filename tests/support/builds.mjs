// Builds the presets and runs those of their ctest tests whose inputs have changed.

import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { must, run, sum } from './commands.mjs';
import { countCtest } from './counts.mjs';
import { contentOf, listingOf, treeContent } from './results.mjs';

/** Settings that a preset has under --full only: the figures are drawn under sanitizers, too. */
const inFull = { 'native-debug': ['-DHGP_EXAMPLES=ON'] };

/** Builds a preset: with --full all tests, otherwise those that the preset specifies. */
async function build(log, preset, isFull) {
  const text = readFileSync('CMakePresets.json', 'utf8');
  const { cacheVariables } = JSON.parse(text).configurePresets.find(({ name }) => name === preset);
  const set = isFull ? 'all' : cacheVariables.HGP_TEST_SET;
  // Configuration is skipped if presets and tools have not changed; the build itself detects other changes.
  const stamp = `build/${preset}/configured`;
  const wanted = JSON.stringify([text, set, isFull, process.env.PATH, process.env.CXXFLAGS]);
  const isConfigured =
    existsSync(`build/${preset}/build.ninja`) &&
    existsSync(stamp) &&
    readFileSync(stamp, 'utf8') === wanted;
  if (!isConfigured) {
    const more = isFull ? (inFull[preset] ?? []) : [];
    await must(log, 'cmake', '--preset', preset, `-DHGP_TEST_SET=${set}`, ...more);
    writeFileSync(stamp, wanted);
  }
  await must(log, 'cmake', '--build', '--preset', preset);
}

/** The files of the checkout that test scripts may read; compiled code is covered by the programs. */
const isReadByScripts = (name) =>
  !/^(core|bench|web|docs\/decisions)\//.test(name) &&
  !/\.(cpp|h)$/.test(name) &&
  name !== 'CHANGELOG.md';

/** All inputs of a ctest test: its command, the programs in it, scripts and data. */
function inputsOf({ name, command, properties }, data) {
  const words = JSON.stringify([name, command, properties]);
  const named = words.match(/\/[^"=\s;\\]+/g).filter((word) => existsSync(word));
  const besides = named.map((word) => word.replace(/\.js$/, '.wasm')).filter(existsSync);
  const files = [...new Set([...named, ...besides])].filter((word) => statSync(word).isFile());
  const isScript = command.some((word) => word.endsWith('.mjs'));
  return [
    words,
    ...files.map(contentOf),
    isScript ? treeContent(isReadByScripts) : '',
    listingOf(data),
  ];
}

/** Whether a test's result is not a function of its inputs: it is random, or measures time or memory. */
const isMeasurement = ({ properties }) =>
  properties.some(({ name, value }) => name === 'LABELS' && /fuzz|measures/.test(value.join()));

/** Builds a preset, runs tests that have changed, and counts all. */
export async function ctest(log, preset, { kept, data, isFull }) {
  await build(log, preset, isFull);
  const shown = execFileSync('ctest', ['--preset', preset, '--show-only=json-v1'], {
    encoding: 'utf8',
    maxBuffer: 1 << 28,
  });
  const keyOf = (test) =>
    isMeasurement(test) || !test.command ? null : kept.key(...inputsOf(test, data));
  const tests = JSON.parse(shown.slice(shown.indexOf('{'))).tests.map((test) => {
    const key = keyOf(test);
    return { ...test, key, found: kept.find(key) };
  });
  const left = tests.filter(({ found }) => !found);
  const unchanged = tests.filter(({ found }) => found);
  log.write(`unchanged since they passed: ${unchanged.map(({ name }) => name).join(' ')}\n`);
  if (left.length === 0) return sum(unchanged.map(({ found }) => found));

  const names = `^(${left.map(({ name }) => name).join('|')})$`;
  const { code, output } = await run(log, 'ctest', '--preset', preset, '-R', names);
  const report = `build/${preset}/Testing/Temporary/LastTest.log`;
  const counts = countCtest(existsSync(report) ? readFileSync(report, 'utf8') : '');
  for (const test of left) {
    const own = counts.tests.get(test.name);
    if (own && test.key) kept.keep(test.key, keyOf(test), `${preset} ${test.name}`, own);
  }
  if (code !== 0) {
    counts.failed = Math.max(counts.failed, 1);
    counts.notes.push(output.slice(-6000));
  }
  return sum([counts, ...unchanged.map(({ found }) => found)]);
}
