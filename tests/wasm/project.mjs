// An empty project with the packed package installed, and a browser that opens what it builds.

import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import path from 'node:path';
import { startChromium } from '../../web/chromium.mjs';
import { built, scratch } from './support.mjs';

const readme = readFileSync(path.join(built, 'README.md'), 'utf8');

/** The first block of code below these words of the package's README. */
export const example = (title, language = 'js') =>
  readme.match(new RegExp(`${title}[^]*?\`\`\`${language}\\n([^]*?)\`\`\``))[1];

/** What the package.json of a folder names, in `files`, `exports` and `bin`, and is not there. */
export function missingFiles(folder) {
  const {
    files,
    exports,
    bin = {},
  } = JSON.parse(readFileSync(path.join(folder, 'package.json'), 'utf8'));
  const leaves = (entry) =>
    typeof entry === 'string' ? [entry] : Object.values(entry).flatMap(leaves);
  const isThere = (name) => {
    if (!name.includes('*')) return existsSync(path.join(folder, name));
    const [before, after] = path.basename(name).split('*');
    const inside = path.join(folder, path.dirname(name));
    const matches = (file) => file.startsWith(before) && file.endsWith(after);
    return existsSync(inside) && readdirSync(inside).some(matches);
  };
  return [...files, ...leaves(exports), ...leaves(bin)].filter((name) => !isThere(name));
}

/** A project below build/package-tests: { folder, run, put }. */
export function createProject(name) {
  const folder = scratch(name);
  const put = (file, text) => {
    mkdirSync(path.dirname(path.join(folder, file)), { recursive: true });
    writeFileSync(path.join(folder, file), text);
  };
  const run = (command, ...args) =>
    execFileSync(command, args, {
      cwd: folder,
      encoding: 'utf8',
      stdio: ['ignore', 'pipe', 'pipe'],
    });
  const packed = execFileSync('npm', ['pack', '--silent', '--pack-destination', folder], {
    cwd: built,
    encoding: 'utf8',
  }).trim();
  put('package.json', '{ "private": true, "type": "module" }');
  // It has no dependencies, so nothing is asked of any registry.
  run('npm', 'install', '--offline', '--no-audit', '--no-fund', '--silent', `./${packed}`);
  return { folder, put, run };
}

/** The strictest policy that the README names. */
export const policy =
  "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; connect-src 'self'; worker-src 'self'";

const types = {
  '.html': 'text/html',
  '.svg': 'image/svg+xml',
  '.css': 'text/css',
  '.js': 'text/javascript',
  '.wasm': 'application/wasm',
};

/** Serves a folder; resolves to { origin, close }. */
export function serve(folder, headers = {}) {
  const server = createServer((request, response) => {
    const name = new URL(request.url, 'http://x').pathname;
    const file = path.join(folder, name === '/' ? 'index.html' : name);
    if (!existsSync(file)) return response.writeHead(404).end();
    response.writeHead(200, {
      'Content-Type': types[path.extname(file)] ?? 'application/octet-stream',
      ...headers,
    });
    response.end(readFileSync(file));
  });
  return new Promise((resolve) =>
    server.listen(0, 'localhost', () =>
      resolve({ origin: `http://localhost:${server.address().port}`, close: () => server.close() }),
    ),
  );
}

/** Opens a page and resolves to what it says in its title, with everything that went wrong. */
export async function openUrl(url) {
  const browser = await startChromium('--disable-gpu');
  try {
    const page = await browser.newPage();
    const trouble = [];
    page.on('pageerror', (error) => trouble.push(String(error)));
    page.on('console', (message) => {
      if (['error', 'warning'].includes(message.type())) trouble.push(message.text());
    });
    await page.goto(url);
    // Asked from outside: what Playwright polls with inside the page is what the policy forbids.
    for (let tries = 0; tries < 300 && trouble.length === 0 && !(await page.title()); tries++) {
      await new Promise((done) => setTimeout(done, 100));
    }
    return { title: await page.title(), trouble };
  } finally {
    await browser.close();
  }
}

/** The same for a folder, served under a policy. */
export async function open(folder, security = policy) {
  const server = await serve(folder, { 'Content-Security-Policy': security });
  try {
    return await openUrl(`${server.origin}/`);
  } finally {
    server.close();
  }
}
