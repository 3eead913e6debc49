// The server of the page: compressed, with validators, and with names that never change kept for good.

import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { request } from 'node:http';
import { tmpdir } from 'node:os';
import path from 'node:path';
import test, { after } from 'node:test';
import { brotliDecompressSync } from 'node:zlib';
import { headers, isolation, serve } from '../../../web/serve.mjs';

const folder = mkdtempSync(path.join(tmpdir(), 'hgp-serve-'));
mkdirSync(path.join(folder, 'assets'));
const text = 'seamless '.repeat(2000);
writeFileSync(path.join(folder, 'index.html'), text);
writeFileSync(path.join(folder, 'assets/a-1234.js'), text);
writeFileSync(path.join(folder, 'small.bin'), 'x');
writeFileSync(path.join(folder, 'b.png'), text);
const { server, url } = await serve({ folder, port: 0 });
after(() => {
  server.close();
  rmSync(folder, { recursive: true });
});

/** An answer as it is on the wire. */
const get = (name, sent = {}, method = 'GET') =>
  new Promise((resolve, reject) => {
    const { port } = new URL(url);
    request({ host: 'localhost', port, path: name, headers: sent, method }, (response) => {
      const chunks = [];
      response.on('data', (chunk) => chunks.push(chunk));
      response.on('end', () =>
        resolve({
          status: response.statusCode,
          headers: response.headers,
          body: Buffer.concat(chunks),
        }),
      );
    })
      .on('error', reject)
      .end();
  });

test('who takes Brotli gets it, and everybody gets the same content', async () => {
  const packed = await get('/index.html', { 'Accept-Encoding': 'gzip, br' });
  assert.equal(packed.headers['content-encoding'], 'br');
  assert.ok(packed.body.length < 200);
  assert.equal(Number(packed.headers['content-length']), packed.body.length);
  assert.equal(brotliDecompressSync(packed.body).toString(), text);
  for (const sent of [{}, { 'Accept-Encoding': 'gzip' }]) {
    const plain = await get('/', sent);
    assert.equal(plain.headers['content-encoding'], undefined);
    assert.equal(plain.body.toString(), text);
    assert.notEqual(plain.headers.etag, packed.headers.etag);
  }
  assert.equal(packed.headers.vary, 'Accept-Encoding');
  // Pictures are compressed already, and what would grow stays as it is.
  for (const name of ['/b.png', '/small.bin']) {
    const answer = await get(name, { 'Accept-Encoding': 'br' });
    assert.equal(answer.headers['content-encoding'], undefined, name);
  }
});

test('names with a hash are kept for a year, others are asked for again and not sent again', async () => {
  const asset = await get('/assets/a-1234.js');
  assert.match(asset.headers['cache-control'], /max-age=31536000, immutable/);
  const page = await get('/index.html');
  assert.equal(page.headers['cache-control'], 'no-cache');
  const { etag } = page.headers;
  const again = await get('/index.html', { 'If-None-Match': etag });
  assert.deepEqual([again.status, again.body.length], [304, 0]);
  assert.equal(again.headers.etag, etag);
  writeFileSync(path.join(folder, 'index.html'), `${text}!`);
  const changed = await get('/index.html', { 'If-None-Match': etag });
  assert.deepEqual([changed.status, changed.body.length], [200, text.length + 1]);
});

test('every answer has the policy; nothing outside of the folder is served', async () => {
  for (const [name, status, method] of [
    ['/index.html', 200, 'GET'],
    ['/index.html', 200, 'HEAD'],
    ['/nothing', 404, 'GET'],
    ['/../etc/passwd', 404, 'GET'],
    ['/..%2f..%2fetc/passwd', 403, 'GET'],
    ['/%', 400, 'GET'],
    ['/a%00b', 403, 'GET'],
    ['/index.html', 405, 'POST'],
  ]) {
    const answer = await get(name, {}, method);
    assert.equal(answer.status, status, `${method} ${name}`);
    assert.equal(answer.headers['content-security-policy'], headers['Content-Security-Policy']);
    for (const [key, value] of Object.entries(isolation))
      assert.equal(answer.headers[key.toLowerCase()], value, name);
    if (method === 'HEAD') assert.equal(answer.body.length, 0);
  }
});
