// The package in Parcel and Next.js, which scripts/test --full installs from the registry (500 MB): built with what the
// README says, and run in a browser.

import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import path from 'node:path';
import test from 'node:test';
import { promisify } from 'node:util';
import { createProject, open, policy } from './project.mjs';
import { html, page, plainExample, putAssets, ran } from './readme_page.mjs';

const program = page(plainExample);

/** Runs in the folder of a project; fails with what was printed. */
const inside = (folder) => async (command, args, env) => {
  const options = { cwd: folder, encoding: 'utf8', env: { ...process.env, ...env } };
  return promisify(execFile)(command, args, options);
};

async function parcel() {
  const { folder, put } = createProject('parcel');
  const run = inside(folder);
  const browserslist = 'chrome >= 95, firefox >= 95, safari >= 15.4';
  put('package.json', JSON.stringify({ private: true, browserslist }));
  put('index.html', html);
  put('main.js', program);
  await putAssets(put, 'dist');
  await run('npm', ['install', '--no-audit', '--no-fund', 'parcel@2.16.4', `./hgp-0.1.0.tgz`]);
  await run('npx', ['parcel', 'build', 'index.html', '--dist-dir', 'dist', '--no-cache']);
  ran(await open(path.join(folder, 'dist')));
}

/** @param builder  --turbopack or --webpack */
async function next(builder) {
  const { folder, put } = createProject(`next${builder}`);
  const run = inside(folder);
  put('package.json', JSON.stringify({ private: true, type: 'module' }));
  // The root is the project, and not the checkout that it lies in, which has a lock file as well.
  put(
    'next.config.mjs',
    "export default { output: 'export', turbopack: { root: import.meta.dirname } };",
  );
  put(
    'app/layout.js',
    'export default ({ children }) => <html lang="en"><body>{children}</body></html>;',
  );
  const [, imports, rest] = program.match(/^([^]*?import [^\n]*\n)([^]*)$/);
  const before = imports.slice(0, imports.indexOf('import'));
  put(
    'app/page.js',
    `'use client';
import { useEffect } from 'react';
${imports.slice(before.length)}
async function main() {${before}${rest}
}
export default function Page() {
  useEffect(() => void main(), []);
  return <p>hgp</p>;
}`,
  );
  await putAssets(put, 'public');
  const packages = ['next@16.4.6', 'react@19', 'react-dom@19', './hgp-0.1.0.tgz'];
  await run('npm', ['install', '--no-audit', '--no-fund', ...packages]);
  const { stderr } = await run('npx', ['next', 'build', builder], { NEXT_TELEMETRY_DISABLED: '1' });
  assert.doesNotMatch(stderr, /warn|error/i);
  // Next.js writes scripts into the page; the worker and the binary need no more than elsewhere.
  const inline = policy.replace("script-src 'self'", "script-src 'self' 'unsafe-inline'");
  ran(await open(path.join(folder, 'out'), inline));
}

if (process.env.HGP_FULL === '1') {
  test('Parcel 2, with the browserslist of the README', parcel);
  test('Next.js 16, Turbopack', () => next('--turbopack'));
  test('Next.js 16, webpack', () => next('--webpack'));
} else {
  test('Parcel and Next.js are named in the README', async () => {
    const { readFileSync } = await import('node:fs');
    const { built } = await import('./support.mjs');
    const readme = readFileSync(path.join(built, 'README.md'), 'utf8');
    assert.match(readme, /Next\.js 16/);
    assert.match(readme, /"browserslist": "chrome >= 95, firefox >= 95, safari >= 15\.4"/);
  });
}
