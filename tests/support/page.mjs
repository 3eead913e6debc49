// Runs a page of the documentation as a reader would: all blocks in order, in one shell, in an empty
// home folder. `~/hgp` is the checkout. A block below a line "`name`:" is a file of that name; `sh` blocks are run, and
// the `text` block after one is the expected output, in which … matches anything; `sh server` keeps running.

import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, symlinkSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';

export const root = path.resolve(import.meta.dirname, '../..');

/** The blocks of a page: { kind, file, text }, kind 'file', 'sh', 'server' or 'text'. */
export function blocksOf(markdown) {
  const blocks = [];
  for (const [, file, info, text] of markdown.matchAll(
    /(?:^`([\w./-]+)`:\n\n)?^```([^\n]*)\n([^]*?)^```$/gm,
  )) {
    if (file) blocks.push({ kind: 'file', file, text });
    else if (info === 'sh') blocks.push({ kind: 'sh', text });
    else if (info === 'sh server') blocks.push({ kind: 'server', text });
    else if (info === 'text') blocks.push({ kind: 'text', text });
    else assert.fail(`a block is neither a file nor run nor output: ${info}\n${text}`);
  }
  return blocks;
}

/** An empty home folder that contains the checkout; remove() deletes it. */
export function emptyHome() {
  const home = mkdtempSync(path.join(os.tmpdir(), 'hgp-home-'));
  symlinkSync(root, path.join(home, 'hgp'));
  return { home, remove: () => rmSync(home, { recursive: true, force: true }) };
}

const mark = (n) => `<<< ${n} >>>`;

/** One script of all blocks up to the server, with a marker before the output of each. */
function scriptOf(blocks) {
  const lines = ['set -e', 'cd ~'];
  blocks.forEach(({ kind, file, text }, n) => {
    if (kind === 'file') {
      lines.push(`mkdir -p "$(dirname '${file}')"`, `cat >'${file}' <<'END_OF_BLOCK'`);
      lines.push(`${text}END_OF_BLOCK`);
    }
    if (kind === 'sh') lines.push(`echo '${mark(n)}'`, text);
  });
  return [...lines, `echo '${mark('end')}'`, 'pwd', ''].join('\n');
}

const pattern = (text) =>
  new RegExp(
    `^${text
      .trim()
      .split('…')
      .map((part) => part.replace(/[.*+?^${}()|[\]\\]/g, '\\$&'))
      .join('[^]*?')}$`,
  );

/** Runs a script; resolves to its exit code and its output. */
function bash(script, env) {
  const child = spawn('bash', ['-c', `exec 2>&1\n${script}`], { env });
  let printed = '';
  child.stdout.setEncoding('utf8').on('data', (chunk) => (printed += chunk));
  return new Promise((resolve) => child.on('close', (status) => resolve({ status, printed })));
}

/** Runs the page; resolves to { folder, server }: the final working folder, and the command of `sh server`. */
export async function runPage(name, home, more = {}) {
  const page = readFileSync(path.join(root, 'docs', name), 'utf8');
  const blocks = blocksOf(page);
  const server = blocks.findIndex(({ kind }) => kind === 'server');
  const run = server < 0 ? blocks : blocks.slice(0, server);
  assert.ok(
    run.some(({ kind }) => kind === 'text'),
    `${name} shows no output`,
  );
  const env = { PATH: process.env.PATH, LANG: 'C.UTF-8', HOME: home, ...more };
  const { status, printed: all } = await bash(scriptOf(run), env);
  assert.equal(status, 0, `${name}\n${all}`);
  const printed = (n) =>
    all
      .split(`${mark(n)}\n`)[1]
      .split(/^<<< \w+ >>>$/m)[0]
      .trim();
  run.forEach(({ kind, text }, n) => {
    if (kind === 'text')
      assert.match(printed(n - 1), pattern(text), `${name}:\n${run[n - 1].text}`);
  });
  const folder = printed('end');
  return { folder, env, server: server < 0 ? undefined : blocks[server].text };
}

/** Starts a server; resolves to { url, stop } when it has printed an address. */
export function startServer(command, { folder, env }) {
  const child = spawn('bash', ['-c', command], { cwd: folder, env, detached: true });
  const stop = () => process.kill(-child.pid);
  return new Promise((resolve, reject) => {
    let text = '';
    const read = (chunk) => {
      // Removes the colour codes between host and port.
      text += String(chunk).replace(/\u001b\[[\d;]*m/g, ''); // eslint-disable-line no-control-regex
      const [url] = text.match(/http:\/\/localhost:\d+\//) ?? [];
      if (url) resolve({ url, stop });
    };
    child.stdout.on('data', read);
    child.stderr.on('data', read);
    child.on('exit', () => reject(new Error(`${command}\n${text}`)));
  });
}
