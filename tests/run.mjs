// Runs the stages of scripts/test and adds up their counts.
// The last line is always "N passed, N failed, N skipped".

import {
  createWriteStream,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  rmSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { ctest } from './support/builds.mjs';
import { checks, counted, inParallel, must, run, sum } from './support/commands.mjs';
import { countPytest } from './support/counts.mjs';
import { lint } from './support/lint.mjs';
import { contentOf, KeptResults, listingOf, treeContent } from './support/results.mjs';
import { runInOrder } from './support/schedule.mjs';

const root = path.dirname(path.dirname(fileURLToPath(import.meta.url)));
process.chdir(root);
const words = process.argv.slice(2);
const full = words.includes('--full');
const isAgain = full || words.includes('--again');
const only = words.filter((word) => !word.startsWith('--'));
const data = process.env.HGP_SHARED_MESHES ?? path.join(root, '../shared/meshes');
const logs = path.join(root, 'build/logs');
mkdirSync(logs, { recursive: true });
if (full) process.env.HGP_FULL = '1';
const kept = new KeptResults(path.join(root, 'build/results'), { isRead: !isAgain });

const testBuild = (log, preset) => ctest(log, preset, { kept, data, isFull: full });

const testFiles = (folder) =>
  readdirSync(path.join('tests', folder))
    .filter((name) => name.endsWith('.test.mjs'))
    .map((name) => path.join('tests', folder, name));

const nodeTests = (log, folder) =>
  counted(log, '--test', '--test-concurrency=1', ...testFiles(folder));

/** Runs test files in one process, which claims files that no other lane has started. */
async function lane(log, claims, files, ...args) {
  return counted(log, ...args, 'tests/support/lane.mjs', claims, ...files);
}

/** Makes a folder for the claims of lanes, and counts the tests that they ran of `files`. */
async function inLanes(files, run) {
  const claims = mkdtempSync(path.join(tmpdir(), 'hgp-lanes-'));
  const counts = sum(await Promise.all(run(claims)));
  rmSync(claims, { recursive: true });
  // A lane counts one additional test per file: that the file was completed.
  counts.passed = Math.max(0, counts.passed - files.length);
  return counts;
}

/** Unit tests of the page's TypeScript without a browser, in two processes, since starting them takes most of the time. */
function runUnits(log) {
  const files = testFiles('web/units');
  const hooks = '--import=./tests/support/typescript.mjs';
  // Those that run the whole page put a document into their process, which units of views must not find there.
  const isOf = (kind) => (file) => path.basename(file).startsWith(kind);
  const [page, recorded] = ['page_', 'recorded_'].map((kind) => files.filter(isOf(kind)));
  const others = files.filter((file) => ![...page, ...recorded].includes(file));
  // Each of these begins the page anew, which is possible once in a process.
  const inTurn = async (claims, groups) => {
    const counts = [];
    for (const group of groups) counts.push(await lane(log, claims, group, hooks));
    return sum(counts);
  };
  const alone = (some) => some.map((file) => [file]);
  return inLanes(files, (claims) => [
    inTurn(claims, [others, ...alone(recorded)]),
    inTurn(claims, alone(page)),
  ]);
}

/** Counts tests that depend on their inputs alone: those of the last time if nothing has changed since they passed. */
async function unlessUnchanged(log, name, inputs, count) {
  const keyNow = () => kept.key(name, ...inputs());
  const key = keyNow();
  const found = kept.find(key);
  if (found) {
    log.write(`unchanged since it passed: ${name}\n`);
    return found;
  }
  const counts = await count();
  kept.keep(key, keyNow(), name, counts);
  return counts;
}

/** Runs test files whose inputs have changed since they passed, several at a time, and counts all. */
async function runChanged(log, files, lanes, inputs) {
  return sum(
    await inParallel(files, lanes, (file) =>
      unlessUnchanged(log, file, inputs, () => counted(log, '--test', file)),
    ),
  );
}

const program = 'build/native-release/bin/hgp';

/** What tests of the page and of the site may read: everything but the tests of other stages. */
const pageInputs =
  (...built) =>
  () => [
    ...[program, 'build/native-release/python/hgp', 'build/package', ...built].map(contentOf),
    treeContent((name) => !/^tests\/(core|cli|install|python)\//.test(name)),
    listingOf(data),
  ];

const isOf = (folders) => (name) => folders.test(name) && !/\.(cpp|h)$/.test(name);

const unitTests = (log) => unlessUnchanged(log, 'units', pageInputs(), () => runUnits(log));

/** Tests of the installed library; their inputs are its sources and the files that they read. */
const installTests = (log) =>
  runChanged(log, testFiles('install'), 1, () => [
    contentOf(program),
    contentOf('build/native-release/lib'),
    treeContent((name) => !/^(web|bench|tests\/(core|web|wasm|cli))\//.test(name)),
    listingOf(data),
  ]);

/** The package's tests that measure time. */
const measures = 'tests/wasm/cost.test.mjs';

/** The package's tests, two files at a time. */
const packageTests = (log) =>
  runChanged(
    log,
    testFiles('wasm').filter((file) => file !== measures),
    2,
    () => [
      contentOf(program),
      contentOf('build/package'),
      treeContent(isOf(/^(wasm|docs|examples|packaging|tests\/(wasm|support|gltf|cli))\/|^[^/]*$/)),
      listingOf(data),
    ],
  );

/**
 * The page's tests: two lanes that run file after file, each with one browser; then, alone, those that
 * measure time. Long files come first, so that both lanes end at about the same time.
 */
async function webTests(log) {
  const alone = 'tests/web/speed.test.mjs';
  const long = [
    'pictures',
    'looks',
    'panels',
    'aligned',
    'output',
    'cones',
    'trouble',
    'hurry',
    'run',
    'touch',
  ];
  const rank = (file) => (long.indexOf(path.basename(file, '.test.mjs')) + 99) % 99;
  const files = testFiles('web').filter((file) => file !== alone);
  files.sort((a, b) => rank(a) - rank(b));
  const inBoth = () =>
    inLanes(files, (claims) => [lane(log, claims, files), lane(log, claims, files)]);
  const both = await unlessUnchanged(log, 'web', pageInputs('build/page'), inBoth);
  return sum([both, await counted(log, '--test', alone)]);
}

/** Compiles every file separately, to find missing includes. */
const compileFiles = (log) =>
  checks(log, [
    ['cmake', '--preset', 'native-files'],
    ['cmake', '--build', '--preset', 'native-files'],
  ]);

const python = '/usr/bin/python3';
const inPython =
  /^(python|blender|packaging|\.github|docs|examples|tests\/(python|support))\/|^[^/]*$/;

/** Tests of the Python package, and of its page in the documentation. */
async function pythonTests(log) {
  const inputs = () => [
    contentOf(program),
    contentOf('build/native-release/python/hgp'),
    treeContent((name) => inPython.test(name)),
  ];
  return unlessUnchanged(log, 'python', inputs, async () => {
    const { code, output } = await run(log, python, '-m', 'pytest', '-q');
    return sum([countPytest(output, code), await nodeTests(log, 'python')]);
  });
}

/** Introduced faults count as tests, which pass if the fault is caught. */
async function mutate(log) {
  const how = [...(full ? [] : ['--short']), ...(isAgain ? ['--again'] : [])];
  const { code, output } = await run(log, 'scripts/mutate', ...how);
  const [, caught = 0, missed = 0] =
    output.match(/^(\d+) of \d+ faults caught, (\d+) missed$/m) ?? [];
  const unchanged = output.match(/^unchanged since it was caught/gm)?.length ?? 0;
  const notes = output.split('\n').filter((line) => /^(WRONG|no test noticed)/.test(line));
  // A few faults may be missed in the full run; scripts/mutate decides how many.
  const failed = code === 0 ? 0 : Math.max(1, Number(missed));
  return { passed: Number(caught), failed, skipped: 0, unchanged, notes };
}

async function web(log) {
  await must(log, 'node_modules/.bin/vite', 'build', 'web');
  return webTests(log);
}

/** The inputs of stages, each with the stage that makes it. */
const makers = { [program]: 'native-release', 'build/package': 'wasm-release' };

function checkInputs({ after = [] }) {
  for (const [file, maker] of Object.entries(makers))
    if (after.includes(maker) && !existsSync(file))
      throw new Error(`${file} is not there; the stage ${maker} makes it`);
}

/** `isLong`: only by name or with --full; `isAlone`: it measures time. */
const stages = {
  lint: { run: (log) => lint(log, { isAgain }) },
  'native-debug': { run: (log) => testBuild(log, 'native-debug') },
  house: { run: (log) => nodeTests(log, 'house') },
  'native-release': { run: (log) => testBuild(log, 'native-release') },
  files: { run: compileFiles, isLong: true },
  portable: { run: (log) => testBuild(log, 'native-portable'), isLong: true },
  'wasm-release': { run: (log) => testBuild(log, 'wasm-release') },
  install: { run: installTests, after: ['native-release'] },
  tidy: {
    run: (log) => checks(log, [['node', 'tests/support/tidy.mjs']]),
    after: ['native-debug', 'native-release'],
  },
  mutate: { run: mutate, after: ['native-debug'] },
  python: { run: pythonTests, after: ['native-release'] },
  units: { run: unitTests, after: ['native-release', 'wasm-release'] },
  package: { run: packageTests, after: ['native-release', 'wasm-release'] },
  measures: {
    run: (log) => counted(log, '--test', measures),
    ...{ after: ['native-release', 'wasm-release'], isAlone: true },
  },
  web: { run: web, after: ['native-release', 'wasm-release'], isAlone: true },
};

const unknown = only.filter((name) => !(name in stages));
if (unknown.length > 0) {
  console.error(`no such stage: ${unknown.join(' ')}; there are ${Object.keys(stages).join(' ')}`);
  process.exit(2);
}
const hasData = existsSync(data);
if (!hasData) console.log(`SKIPPING tests on real meshes: ${data} is not there`);
const hasBlender = process.env.PATH.split(':').some((at) => existsSync(path.join(at, 'blender')));
if (!hasBlender && (only.length === 0 || only.includes('python')))
  console.log(
    'SKIPPING the add-on in Blender: `scripts/setup full` installs Blender, which is large',
  );

const total = { passed: 0, failed: 0, skipped: 0, unchanged: 0 };

async function runStage(name) {
  const begin = performance.now();
  const log = createWriteStream(path.join(logs, `${name}.log`));
  let counts;
  try {
    checkInputs(stages[name]);
    counts = await stages[name].run(log);
    if (counts.passed + counts.failed === 0) {
      counts = { ...counts, failed: 1, notes: [...counts.notes, 'the stage ran no test at all'] };
    }
    if (counts.skipped > 0 && hasData) {
      counts.failed += 1;
      counts.notes.push('tests were skipped though the optional data is there');
    }
  } catch (error) {
    counts = { passed: 0, failed: 1, skipped: 0, notes: [error.message] };
  }
  log.end();
  const seconds = ((performance.now() - begin) / 1000).toFixed(1);
  const { passed, failed, skipped, unchanged = 0 } = counts;
  const since = unchanged > 0 ? ` (${unchanged} unchanged since they passed)` : '';
  console.log(
    `${failed ? 'FAIL' : 'ok  '} ${name.padEnd(15)} ${seconds.padStart(7)} s   ` +
      `${passed} passed${since}, ${failed} failed, ${skipped} skipped`,
  );
  for (const note of counts.notes) console.log(note.trimEnd().replace(/^/gm, '     | '));
  for (const key of Object.keys(total)) total[key] += counts[key] ?? 0;
}

const isChosen = ([name, { isLong }]) => (only.length > 0 ? only.includes(name) : full || !isLong);
await runInOrder(new Map(Object.entries(stages).filter(isChosen)), runStage);

if (total.unchanged > 0) {
  console.log(`${total.unchanged} are unchanged since they passed here; --again runs them, too`);
}
process.exitCode = total.failed > 0 ? 1 : 0;
console.log(`${total.passed} passed, ${total.failed} failed, ${total.skipped} skipped`);
