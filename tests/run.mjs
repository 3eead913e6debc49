// Runs the stages of scripts/test and adds up what they counted.
// The last line is always "N passed, N failed, N skipped".

import { spawn, execFileSync } from 'node:child_process';
import {
  createWriteStream,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  readdirSync,
  rmSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { countCtest, countNodeTest } from './support/counts.mjs';
import { runInOrder } from './support/schedule.mjs';

const root = path.dirname(path.dirname(fileURLToPath(import.meta.url)));
process.chdir(root);
const full = process.argv.includes('--full');
const only = process.argv.slice(2).filter((word) => !word.startsWith('--'));
const data = process.env.HGP_SHARED_MESHES ?? path.join(root, '../shared/meshes');
const logs = path.join(root, 'build/logs');
mkdirSync(logs, { recursive: true });
if (full) process.env.HGP_FULL = '1';

/** Runs a command with its output in the stage's log; resolves to the exit code and the output. */
function run(log, command, ...args) {
  return new Promise((resolve) => {
    const child = spawn(command, args, { stdio: ['ignore', 'pipe', 'pipe'] });
    let output = '';
    const take = (chunk) => {
      output += chunk;
      log.write(chunk);
    };
    log.write(`\n$ ${command} ${args.join(' ')}\n`);
    child.stdout.on('data', take);
    child.stderr.on('data', take);
    child.on('error', (error) => resolve({ code: 127, output: output + error.message }));
    child.on('close', (code) => resolve({ code: code ?? 1, output }));
  });
}

/** A command that must succeed before anything can be counted. */
async function must(log, ...command) {
  const { code, output } = await run(log, ...command);
  if (code !== 0) {
    throw new Error(`${command.join(' ')} ended with ${code}\n${output.slice(-3000)}`);
  }
  return output;
}

/** Files git knows or could know, of the given endings. */
function sources(...endings) {
  const listed = execFileSync('git', ['ls-files', '-co', '--exclude-standard'], {
    encoding: 'utf8',
    maxBuffer: 1 << 28,
  });
  return listed
    .split('\n')
    .filter((name) => endings.some((ending) => name.endsWith(ending)) && existsSync(name));
}

/** Checks that count one test each. */
async function checks(log, commands) {
  const counts = { passed: 0, failed: 0, skipped: 0, notes: [] };
  for (const command of commands) {
    const { code, output } = await run(log, ...command);
    if (code === 0) {
      counts.passed += 1;
    } else {
      counts.failed += 1;
      counts.notes.push(`${command.slice(0, 3).join(' ')} …\n${output.slice(-3000)}`);
    }
  }
  return counts;
}

/** With --full all tests run in every build, otherwise those that the preset names. */
async function build(log, preset) {
  const presets = JSON.parse(readFileSync('CMakePresets.json', 'utf8')).configurePresets;
  const { HGP_TEST_SET } = presets.find(({ name }) => name === preset).cacheVariables;
  await must(log, 'cmake', '--preset', preset, `-DHGP_TEST_SET=${full ? 'all' : HGP_TEST_SET}`);
  await must(log, 'cmake', '--build', '--preset', preset);
}

async function ctest(log, preset) {
  await build(log, preset);
  const { code, output } = await run(log, 'ctest', '--preset', preset);
  const report = `build/${preset}/Testing/Temporary/LastTest.log`;
  const counts = countCtest(existsSync(report) ? readFileSync(report, 'utf8') : '');
  if (code !== 0) {
    counts.failed = Math.max(counts.failed, 1);
    counts.notes.push(output.slice(-6000));
  }
  return counts;
}

/** Runs test files by `node` with these arguments, and counts. */
async function counted(log, ...args) {
  const { code, output } = await run(log, 'node', '--test-reporter=tap', ...args);
  const counts = countNodeTest(output);
  if (code !== 0) counts.failed = Math.max(counts.failed, 1);
  return counts;
}

function sum(all) {
  const total = { passed: 0, failed: 0, skipped: 0, notes: [] };
  for (const counts of all) {
    for (const key of ['passed', 'failed', 'skipped']) total[key] += counts[key];
    total.notes.push(...counts.notes);
  }
  return total;
}

const testFiles = (folder) =>
  readdirSync(path.join('tests', folder))
    .filter((name) => name.endsWith('.test.mjs'))
    .map((name) => path.join('tests', folder, name));

const nodeTests = (log, folder) =>
  counted(log, '--test', '--test-concurrency=1', ...testFiles(folder));

/** Test files in one process, which takes `claims` of those that no other lane has begun. */
async function lane(log, claims, files, ...args) {
  return counted(log, ...args, 'tests/support/lane.mjs', claims, ...files);
}

/** Makes a folder for the claims of lanes, and counts what they ran of `files`. */
async function inLanes(files, run) {
  const claims = mkdtempSync(path.join(tmpdir(), 'hgp-lanes-'));
  const counts = sum(await Promise.all(run(claims)));
  rmSync(claims, { recursive: true });
  // A lane counts one test more per file: that it came to its end.
  counts.passed -= files.length;
  return counts;
}

/** The page's TypeScript without a browser: one process, as most of the time goes into starting it. */
function unitTests(log) {
  const files = testFiles('web/units');
  const hooks = '--import=./tests/support/typescript.mjs';
  return inLanes(files, (claims) => [lane(log, claims, files, hooks)]);
}

/** The package's tests: two files beside each other; then, alone, what measures time. */
async function packageTests(log) {
  const alone = 'tests/wasm/cost.test.mjs';
  const files = testFiles('wasm').filter((file) => file !== alone);
  const both = await counted(log, '--test', '--test-concurrency=2', ...files);
  return sum([both, await counted(log, '--test', alone)]);
}

/**
 * The page's tests: two lanes that take file after file, each with one browser; then, alone, what
 * measures time. Long files first, so that both lanes end at about the same time.
 */
async function webTests(log) {
  const alone = 'tests/web/speed.test.mjs';
  const long = [
    'pictures',
    'looks',
    'panels',
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
  const both = await inLanes(files, (claims) => [
    lane(log, claims, files),
    lane(log, claims, files),
  ]);
  return sum([both, await counted(log, '--test', alone)]);
}

/** Every file compiled alone, so that none takes an include from its neighbour. */
const compileFiles = (log) =>
  checks(log, [
    ['cmake', '--preset', 'native-files'],
    ['cmake', '--build', '--preset', 'native-files'],
  ]);

const lint = (log) =>
  checks(log, [
    ['clang-format', '--dry-run', '-Werror', ...sources('.cpp', '.h')],
    ['node_modules/.bin/prettier', '--check', '.'],
    ['node_modules/.bin/eslint', '.'],
    ['node_modules/.bin/tsc', '--noEmit', '-p', 'web'],
    ['node_modules/.bin/tsc', '--noEmit', '-p', 'wasm'],
  ]);

/** Planted faults count as tests: caught is passed. */
async function mutate(log) {
  const { code, output } = await run(log, 'scripts/mutate', ...(full ? [] : ['--short']));
  const [, caught = 0, missed = 0] =
    output.match(/^(\d+) of \d+ faults caught, (\d+) missed$/m) ?? [];
  const notes = output.split('\n').filter((line) => /^(WRONG|no test noticed)/.test(line));
  // In full a few may be missed; how many, scripts/mutate knows.
  const failed = code === 0 ? 0 : Math.max(1, Number(missed));
  return { passed: Number(caught), failed, skipped: 0, notes };
}

async function web(log) {
  await must(log, 'node_modules/.bin/vite', 'build', 'web');
  return webTests(log);
}

/** `isLong`: by name or in full; `isAlone`: it measures time. */
const stages = {
  lint: { run: lint },
  'native-debug': { run: (log) => ctest(log, 'native-debug') },
  house: { run: (log) => nodeTests(log, 'house') },
  'native-release': { run: (log) => ctest(log, 'native-release') },
  files: { run: compileFiles, isLong: true },
  portable: { run: (log) => ctest(log, 'native-portable'), isLong: true },
  'wasm-release': { run: (log) => ctest(log, 'wasm-release') },
  install: { run: (log) => nodeTests(log, 'install'), after: ['native-release'] },
  tidy: {
    run: (log) => checks(log, [['node', 'tests/support/tidy.mjs']]),
    after: ['native-debug', 'native-release'],
  },
  mutate: { run: mutate, after: ['native-debug'] },
  units: { run: unitTests, after: ['wasm-release'] },
  package: {
    run: packageTests,
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

const total = { passed: 0, failed: 0, skipped: 0 };

async function runStage(name) {
  const begin = performance.now();
  const log = createWriteStream(path.join(logs, `${name}.log`));
  let counts;
  try {
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
  const { passed, failed, skipped } = counts;
  console.log(
    `${failed ? 'FAIL' : 'ok  '} ${name.padEnd(15)} ${seconds.padStart(7)} s   ` +
      `${passed} passed, ${failed} failed, ${skipped} skipped`,
  );
  for (const note of counts.notes) console.log(note.trimEnd().replace(/^/gm, '     | '));
  for (const key of Object.keys(total)) total[key] += counts[key];
}

const isChosen = ([name, { isLong }]) => (only.length > 0 ? only.includes(name) : full || !isLong);
await runInOrder(new Map(Object.entries(stages).filter(isChosen)), runStage);

process.exitCode = total.failed > 0 ? 1 : 0;
console.log(`${total.passed} passed, ${total.failed} failed, ${total.skipped} skipped`);
