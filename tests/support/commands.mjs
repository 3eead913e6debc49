// Runs the commands of a stage with their output in its log, and counts tests.

import { spawn } from 'node:child_process';
import { countNodeTest } from './counts.mjs';

/** Runs a command with its output in the stage's log; resolves to the exit code and the output. */
export function run(log, command, ...args) {
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
export async function must(log, ...command) {
  const { code, output } = await run(log, ...command);
  if (code !== 0) {
    throw new Error(`${command.join(' ')} ended with ${code}\n${output.slice(-3000)}`);
  }
  return output;
}

/** Checks that count one test each. */
export async function checks(log, commands) {
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

/** Runs test files by `node` with these arguments, and counts. */
export async function counted(log, ...args) {
  const { code, output } = await run(log, 'node', '--test-reporter=tap', ...args);
  const counts = countNodeTest(output);
  if (code !== 0) counts.failed = Math.max(counts.failed, 1);
  return counts;
}

/** Sums counts. `unchanged`: how many of the passed tests were not run again. */
export function sum(all) {
  const total = { passed: 0, failed: 0, skipped: 0, unchanged: 0, notes: [] };
  for (const counts of all) {
    for (const key of ['passed', 'failed', 'skipped', 'unchanged']) total[key] += counts[key] ?? 0;
    total.notes.push(...counts.notes);
  }
  return total;
}

/** Calls `act` on all items, several at a time; resolves to its results. */
export async function inParallel(items, lanes, act) {
  const left = [...items.entries()];
  const results = [];
  const work = async () => {
    for (let next = left.shift(); next; next = left.shift()) results[next[0]] = await act(next[1]);
  };
  await Promise.all(Array.from({ length: lanes }, work));
  return results;
}
