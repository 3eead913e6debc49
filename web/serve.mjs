// Serves the built page with the headers it is meant to be served with, compressed. No dependencies.

import { createHash } from 'node:crypto';
import { statSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { brotliCompress, constants } from 'node:zlib';

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

/** What isolates a page from others, so that it may share memory with its workers; all that it loads is its own. */
export const isolation = {
  'Cross-Origin-Opener-Policy': 'same-origin',
  'Cross-Origin-Embedder-Policy': 'require-corp',
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

/** Names in this folder contain a hash of the content, so that a file with this name never changes. */
export const hashed = { folder: 'assets', cacheControl: 'public, max-age=31536000, immutable' };

const isHashed = (name) => name.startsWith(`/${hashed.folder}/`);
const isCompressible = (name) => !/\.(png|jpg|webp|zip|gz)$/.test(name);
const compress = promisify(brotliCompress);

/** A file's content, compressed content and ETag, read again if it has changed. */
function fileCache() {
  const known = new Map();
  const read = async (file) => {
    const bytes = await readFile(file);
    const etag = `"${createHash('sha256').update(bytes).digest('base64url').slice(0, 22)}"`;
    return { bytes, etag, packed: undefined };
  };
  const pack = ({ bytes }) =>
    compress(bytes, {
      params: {
        [constants.BROTLI_PARAM_QUALITY]: 9,
        [constants.BROTLI_PARAM_LGWIN]: 22,
        [constants.BROTLI_PARAM_SIZE_HINT]: bytes.length,
      },
    });
  return async (file, { mtimeMs, size }, isPacked) => {
    const key = `${file} ${mtimeMs} ${size}`;
    if (!known.has(key)) known.set(key, read(file));
    const entry = await known.get(key);
    if (!isPacked) return entry;
    entry.packed ??= pack(entry);
    const packed = await entry.packed;
    return packed.length < entry.bytes.length
      ? { bytes: packed, etag: entry.etag.replace(/"$/, '-br"'), encoding: 'br' }
      : entry;
  };
}

/**
 * Listens on localhost; port 0 takes a free one. Resolves to the server and its address. `isIsolating: false` serves as
 * hosts do that know nothing of the page's headers for isolation.
 */
export function serve({ folder = built, port = 8080, isIsolating = true } = {}) {
  const cached = fileCache();
  const always = isIsolating ? { ...headers, ...isolation } : headers;
  const answer = async (request, response) => {
    const fail = (status) => response.writeHead(status, always).end();
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
    const wantsPacked =
      isCompressible(name) && /\bbr\b/.test(request.headers['accept-encoding'] ?? '');
    const { bytes, etag, encoding } = await cached(file, stat, wantsPacked);
    const about = {
      ...always,
      ...(isHashed(name) ? { 'Cache-Control': hashed.cacheControl } : {}),
      ...{ ETag: etag, Vary: 'Accept-Encoding' },
    };
    if (request.headers['if-none-match'] === etag) return response.writeHead(304, about).end();
    response.writeHead(200, {
      ...about,
      'Content-Type': types[path.extname(file)] ?? 'application/octet-stream',
      'Content-Length': bytes.length,
      ...(encoding ? { 'Content-Encoding': encoding } : {}),
    });
    response.end(request.method === 'HEAD' ? undefined : bytes);
  };
  const server = createServer((request, response) => {
    answer(request, response).catch(() => response.destroy()); // the file vanished while it was read
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
