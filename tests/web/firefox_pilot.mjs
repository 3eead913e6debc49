// Drives Firefox by WebDriver BiDi, its own protocol, and does what a person does: drop a model, Run, read the
// banner, download. Run by firefox.test.mjs with Node's WebSocket; prints what it saw as JSON.
//   node --experimental-websocket firefox_pilot.mjs FIREFOX FOLDER

import { spawn } from 'node:child_process';
import { mkdirSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { setTimeout as sleep } from 'node:timers/promises';
import { serve } from '../../web/serve.mjs';
import { cubeMesh, toObj } from '../support/meshes.mjs';

const [firefox, folder] = process.argv.slice(2);
const downloads = path.join(folder, 'downloads');
const profile = path.join(folder, 'profile');
mkdirSync(downloads);
mkdirSync(profile);
const preferences = {
  'browser.download.folderList': 2,
  'browser.download.dir': downloads,
  'browser.download.useDownloadDir': true,
  'browser.download.always_ask_before_handling_new_types': false,
  'browser.shell.checkDefaultBrowser': false,
  'datareporting.policy.dataSubmissionEnabled': false,
  'toolkit.telemetry.enabled': false,
  'app.update.enabled': false,
};
writeFileSync(
  path.join(profile, 'user.js'),
  Object.entries(preferences)
    .map(([name, value]) => `user_pref(${JSON.stringify(name)}, ${JSON.stringify(value)});`)
    .join('\n'),
);

/** Starts it; resolves to where it listens. */
function start() {
  const words = ['--headless', '--remote-debugging-port=0', '--profile', profile, 'about:blank'];
  const browser = spawn(firefox, words, { env: { ...process.env, HOME: folder } });
  const address = new Promise((resolve, reject) => {
    let text = '';
    browser.stderr.on('data', (part) => {
      text += part;
      const [, found] = text.match(/BiDi listening on (ws:\S+)/) ?? [];
      if (found) resolve(found);
    });
    browser.on('exit', (code) => reject(new Error(`Firefox ended (${code}): ${text}`)));
  });
  return { browser, address };
}

/** Commands and their answers over one connection; errors of the page's console are kept. */
async function connect(address) {
  const socket = new WebSocket(`${address}/session`);
  await new Promise((resolve, reject) => {
    socket.onopen = resolve;
    socket.onerror = () => reject(new Error(`no connection to ${address}`));
  });
  const waiting = new Map();
  const problems = [];
  let last = 0;
  socket.onmessage = ({ data }) => {
    const message = JSON.parse(data);
    if (message.method === 'log.entryAdded' && message.params.level === 'error')
      problems.push(message.params.text);
    const { resolve, reject } = waiting.get(message.id) ?? {};
    waiting.delete(message.id);
    if (message.type === 'error') reject?.(new Error(`${message.error}: ${message.message}`));
    else resolve?.(message.result);
  };
  const send = (method, params = {}) =>
    new Promise((resolve, reject) => {
      const id = ++last;
      waiting.set(id, { resolve, reject });
      socket.send(JSON.stringify({ id, method, params }));
    });
  return { send, problems, close: () => socket.close() };
}

async function pilot({ send, problems }, url) {
  const { capabilities } = await send('session.new', { capabilities: {} });
  await send('session.subscribe', { events: ['log.entryAdded'] });
  const { contexts } = await send('browsingContext.getTree');
  const [{ context }] = contexts;
  /** Runs a function of the page with a text. */
  const ask = async (work, text = '') => {
    const { type, result, exceptionDetails } = await send('script.callFunction', {
      functionDeclaration: String(work),
      ...{ awaitPromise: true, target: { context } },
      arguments: [{ type: 'string', value: text }],
    });
    if (type === 'exception') throw new Error(exceptionDetails.text);
    return result.value;
  };
  const until = async (wanted) => {
    const state = () => ask(() => document.body?.dataset.state);
    for (let i = 0; i < 600 && (await state()) !== wanted; i++) await sleep(100);
    const now = await state();
    if (now !== wanted) throw new Error(`${now}, not ${wanted}; ${problems.join('; ')}`);
  };
  await send('browsingContext.navigate', { context, url, wait: 'complete' });
  await until('empty');
  const hasPictures = await ask(() =>
    String(document.createElement('canvas').getContext('webgl2') !== null),
  );
  await ask(
    (text) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([text], 'cube.obj'));
      document.body.dispatchEvent(
        new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }),
      );
    },
    toObj(cubeMesh(4)),
  );
  await until('ready');
  await ask(() => document.querySelector('#run').click());
  await until('certified');
  const status = await ask(() => document.querySelector('#status').innerText);
  const banner = await ask(() => document.querySelector('#panel-result').innerText);
  await ask(async () => {
    document.querySelector('#download').click();
    while (!document.querySelector('dialog .primary.big'))
      await new Promise((r) => setTimeout(r, 20));
    document.querySelector('dialog .primary.big').click();
  });
  const saved = () => readdirSync(downloads).filter((name) => !name.endsWith('.part'));
  for (let i = 0; i < 100 && saved().length === 0; i++) await sleep(100);
  await sleep(200);
  const [name] = saved();
  const text = name ? readFileSync(path.join(downloads, name), 'utf8') : '';
  const { browserVersion } = capabilities;
  return {
    browserVersion,
    hasPictures: hasPictures === 'true',
    status,
    banner,
    name,
    text,
    problems,
  };
}

const { url, server } = await serve({ port: 0 });
const { browser, address } = start();
try {
  const connection = await connect(await address);
  console.log(JSON.stringify(await pilot(connection, url)));
  connection.close();
} finally {
  browser.removeAllListeners('exit');
  browser.kill();
  await new Promise((resolve) => browser.on('close', resolve));
  server.close();
}
