// Serves the built page with the headers it is meant to be served with. No dependencies.

import { createReadStream, statSync } from 'node:fs';
import { createServer } from 'node:http';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const here = path.dirname(fileURLToPath(import.meta.url));
const built = path.resolve(here, '../build/page');

const types = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.css': 'text/css; charset=utf-8',
  '.json': 'application/json',
  '.wasm': 'application/wasm',
  '.svg': 'image/svg+xml',
  '.png': 'image/png',
  '.webmanifest': 'application/manifest+json',
  '.glb': 'model/gltf-binary',
  '.bin': 'application/octet-stream',
  '.obj': 'text/plain; charset=utf-8',
};

export const headers = {
  'Content-Security-Policy':
    "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; " +
    "img-src 'self' blob: data:; connect-src 'self' blob:; worker-src 'self'; manifest-src 'self'; " +
    "require-trusted-types-for 'script'; trusted-types lit-html hgp; " +
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
  'X-Content-Type-Options': 'nosniff',
  'Referrer-Policy': 'no-referrer',
  'Cache-Control': 'no-cache',
};

/** Listens on localhost; port 0 takes a free one. Resolves to the server and its address. */
export function serve({ folder = built, port = 8080 } = {}) {
  const server = createServer((request, response) => {
    const fail = (status) => response.writeHead(status, headers).end();
    let name;
    try {
      name = decodeURIComponent(new URL(request.url, 'http://localhost').pathname);
    } catch {
      return fail(400);
    }
    if (name.endsWith('/')) name += 'index.html';
    const file = path.join(folder, name);
    if (!file.startsWith(folder + path.sep) || name.includes('\0')) return fail(403);
    if (request.method !== 'GET' && request.method !== 'HEAD') return fail(405);
    const stat = statSync(file, { throwIfNoEntry: false });
    if (!stat?.isFile()) return fail(404);
    response.writeHead(200, {
      ...headers,
      'Content-Type': types[path.extname(file)] ?? 'application/octet-stream',
      'Content-Length': stat.size,
    });
    if (request.method === 'HEAD') return response.end();
    createReadStream(file).pipe(response);
  });
  return new Promise((resolve, reject) => {
    server.once('error', reject);
    server.listen(port, 'localhost', () =>
      resolve({ server, url: `http://localhost:${server.address().port}/` }),
    );
  });
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const port = Number(process.env.PORT ?? 8080);
  try {
    const { url } = await serve({ port });
    console.log(`hgp is ready: ${url}   (Ctrl+C stops it)`);
  } catch (error) {
    console.error(error.code === 'EADDRINUSE' ? `port ${port} is taken; set PORT` : error.message);
    process.exitCode = 1;
  }
}
