// What the package does in a browser, with a browser that a script plays: how it fetches its files, where its workers come
// from, and how it hears that one was lost.

import assert from 'node:assert/strict';
import { resolveObjectURL } from 'node:buffer';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';

import { replace } from '../support/replaced.mjs';
import { built, HgpError } from './support.mjs';

const { compileFile, importFile, linkTo, readFile, startWorker } = await import(path.join(built, 'lib/browser.js')); // prettier-ignore
const wasm = readFileSync(path.join(built, 'hgp-lite.wasm'));
const here = new URL('https://page.example/app/index.html');

/** Answers of a server by the end of an address: a status, a type and bytes. */
function serving(t, answers) {
  const asked = [];
  replace(t, 'fetch', async (url) => {
    asked.push(String(url));
    const [status, type, content] = Object.entries(answers).find(([end]) => String(url).endsWith(end))[1]; // prettier-ignore
    return new Response(content, { status, headers: type ? { 'Content-Type': type } : {} });
  });
  return asked;
}

test('a module is compiled whatever type the server gives it, as it arrives where it may be; what is not there is named', async (t) => {
  const streamed = t.mock.method(WebAssembly, 'compileStreaming');
  serving(t, {
    'right.wasm': [200, 'application/wasm', wasm],
    'long.wasm': [200, 'application/wasm; charset=x', wasm],
    'other.wasm': [200, 'application/octet-stream', wasm],
    'plain.wasm': [200, '', wasm],
    'none.wasm': [404, 'application/wasm', ''],
    'text.bin': [200, 'text/plain', 'some bytes'],
    'none.bin': [500, '', ''],
  });
  const exported = (module) => WebAssembly.Module.exports(module).map(({ name }) => name);
  const expected = exported(await WebAssembly.compile(wasm));
  const streams = [];
  for (const name of ['right', 'long', 'other', 'plain']) {
    for (const url of [new URL(`${name}.wasm`, here), `https://page.example/${name}.wasm`]) {
      streamed.mock.resetCalls();
      // Node compiles only responses of the one type as they arrive.
      const compiled = name === 'long' ? await compileFile(url).catch(() => undefined) : await compileFile(url); // prettier-ignore
      if (compiled) assert.deepEqual(exported(compiled), expected);
      streams.push(streamed.mock.callCount());
    }
  }
  assert.deepEqual(streams, [1, 1, 1, 1, 0, 0, 0, 0]);
  for (const name of ['none.wasm', 'none.bin']) {
    const get = name.endsWith('wasm') ? compileFile : readFile;
    const isTold = (error) => error instanceof HgpError && error.code === 'wasm-unavailable' && error.message.includes(name); // prettier-ignore
    await assert.rejects(get(new URL(name, here)), isTold);
  }
  assert.equal(new TextDecoder().decode(await readFile(new URL('text.bin', here))), 'some bytes');
});

test('a decoder is what its file exports; of a script without exports what it has registered under its name', async (t) => {
  const module = (text) => new URL(`data:text/javascript,${encodeURIComponent(text)}`);
  assert.equal((await importFile(module('export const decode = 7'))).decode, 7);
  const name = Symbol.for('hgp.decoders');
  t.after(() => delete globalThis[name]);
  const empty = new URL('data:text/javascript,0//some/folder/one_decoder.min.js');
  assert.equal(await importFile(empty), undefined, 'nothing is registered');
  globalThis[name] = { one_decoder: { is: 1 }, other: { is: 2 } };
  assert.deepEqual(await importFile(empty), { is: 1 });
});

/** Workers that are started here, and what is told to them. */
function workers(t) {
  const started = [];
  replace(t, 'location', here);
  replace(t, 'Worker', class extends EventTarget {
    posted = [];
    constructor(url, options) {
      super();
      Object.assign(this, { url: String(url), options });
      started.push(this);
    }
    postMessage(...all) {
      this.posted.push(all);
    }
    terminate() {
      this.isEnded = true;
    }
  }); // prettier-ignore
  return started;
}

test('a worker of the page’s own origin is started at its address; one from elsewhere by a script of the page', async (t) => {
  const started = workers(t);
  const revoked = t.mock.method(URL, 'revokeObjectURL');
  const start = (options) => {
    startWorker(options, (at) => at('https://page.example/default.js'));
    const worker = started.pop();
    assert.deepEqual([worker.options.type, started.length], ['module', 0]);
    return worker;
  };
  assert.equal(start({}).url, 'https://page.example/default.js');
  for (const workerUrl of [
    './worker.js',
    '/lib/worker.js',
    'https://page.example/w.js',
    new URL('w.js', here),
  ])
    assert.equal(start({ workerUrl }).url, String(workerUrl));
  for (const workerUrl of [
    'https://cdn.example/w.js?a="b"',
    new URL('http://page.example/w.js'),
    'https://page.example:8443/w.js',
  ]) {
    // prettier-ignore
    revoked.mock.resetCalls();
    const worker = start({ workerUrl });
    const text = await resolveObjectURL(worker.url).text();
    assert.equal(text, `import ${JSON.stringify(String(workerUrl))};`);
    assert.match(resolveObjectURL(worker.url).type, /javascript/);
    assert.equal(revoked.mock.callCount(), 0, 'it is still read');
    for (let i = 0; i < 2; i++) worker.dispatchEvent(new Event('message'));
    assert.deepEqual(revoked.mock.calls.map(({ arguments: [url] }) => url), [worker.url]); // prettier-ignore
  }
  // One that the program makes is taken before all others.
  const own = new globalThis.Worker('own.js', { type: 'module' });
  startWorker({ createWorker: () => own, workerUrl: './worker.js' }, assert.fail).post('hello', []);
  assert.deepEqual(own.posted, [['hello', []]]);
});

test('messages of a worker are passed on; an error, also one without words, and what cannot be read are losses', (t) => {
  workers(t);
  const worker = new globalThis.Worker('x');
  const link = linkTo(worker);
  const [heard, lost] = [[], []];
  link.onMessage((message) => heard.push(message));
  link.onLost((reason) => lost.push(reason));
  const tell = (type, members) => worker.dispatchEvent(Object.assign(new Event(type), members));
  tell('message', { data: { id: 1 } });
  assert.deepEqual([heard, lost], [[{ id: 1 }], []]);
  tell('error', { message: 'out of memory' });
  tell('error', {});
  tell('messageerror', {});
  assert.deepEqual(lost.slice(0, 1), ['out of memory']);
  assert.ok(lost.length === 3 && new Set(lost).size === 3 && lost.every((text) => text.length > 5), `${lost}`); // prettier-ignore
  link.idle();
  link.busy();
  const buffer = new ArrayBuffer(8);
  link.post({ id: 2 }, [buffer]);
  assert.deepEqual(worker.posted, [[{ id: 2 }, [buffer]]]);
  assert.equal(worker.isEnded, undefined);
  link.terminate();
  assert.equal(worker.isEnded, true);
  assert.equal(heard.length, 1);
});
