// Runs the program under test in a temporary folder, which is removed after the test file.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { chmodSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs'; // prettier-ignore
import os from 'node:os';
import path from 'node:path';
import { after } from 'node:test';

export const hgp =
  process.env.HGP_BIN ?? path.join(import.meta.dirname, '../../build/native-release/bin/hgp');

/** Whether the program uses POSIX; otherwise it has no colours and no bar, and prints nothing in signal handlers. */
export const hasPosix = process.env.HGP_WITHOUT_POSIX === undefined;

/** Optional real meshes; tests that use them print a message if they are absent. */
export const shared =
  process.env.HGP_SHARED_MESHES ?? path.join(import.meta.dirname, '../../../shared/meshes');

/** `env`: the environment variables of every run. */
export function inFolder(topic, env = process.env) {
  const folder = mkdtempSync(path.join(os.tmpdir(), `hgp-${topic}-`));
  after(() => {
    for (const name of readdirSync(folder)) chmodSync(path.join(folder, name), 0o755);
    rmSync(folder, { recursive: true });
  });
  const at = (name) => path.join(folder, name);
  /** Writes a file, creates its folders, and returns its path. */
  const put = (name, content) => {
    mkdirSync(path.dirname(at(name)), { recursive: true });
    writeFileSync(at(name), content);
    return at(name);
  };
  const read = (name) => readFileSync(at(name), 'utf8');
  /** Runs the program with words or lists of words; a last argument has options for the process. */
  function run(...words) {
    const hasOptions = typeof words.at(-1) === 'object' && !Array.isArray(words.at(-1));
    const options = hasOptions ? words.pop() : {};
    const result = spawnSync(hgp, words.flat(), {
      encoding: 'utf8',
      cwd: folder,
      env,
      ...options,
    });
    return { code: result.status, signal: result.signal, out: result.stdout, err: result.stderr };
  }
  /** Like `run`, but fails unless the exit code is 0. */
  function good(...words) {
    const result = run(...words);
    assert.equal(result.code, 0, `${words.flat().join(' ')}\n${result.err}${result.out}`);
    return result;
  }
  return { folder, at, put, read, run, good };
}
