// The service worker that keeps the page working without a network: made by the build, which knows
// the names of all files. Cache first; a new version takes over when its page is opened anew. It also
// isolates the page where the host does not.

import { createHash } from 'node:crypto';
import { isolation } from './serve.mjs';

const script = (
  files,
  prefix,
  version,
) => `// Keeps this page working offline. Nothing else is cached, and nothing is sent.
const name = '${prefix}${version}';
const files = ${JSON.stringify(files)};
const scope = new URL('./', location.href);
// Shared memory is there only on isolated pages, and few static hosts send what isolates them. Documents and
// workers need it; everything else is passed on as it is, with what the browser has compiled of it.
const isolation = ${JSON.stringify(Object.entries(isolation))};
const isolated = ['document', 'worker', 'sharedworker'];
const isolate = (answer) => {
  if (answer.status === 0) return answer; // a redirection, or no network
  const { status, statusText } = answer;
  const headers = new Headers(answer.headers);
  for (const [header, value] of isolation) headers.set(header, value);
  return new Response(answer.body, { status, statusText, headers });
};
self.addEventListener('install', (event) => {
  // Names with a hash never change: what the page has just loaded is not loaded again.
  const modeOf = (file) => (file.startsWith('./assets/') ? 'default' : 'no-cache');
  const add = (cache) => cache.addAll(files.map((file) => new Request(file, { cache: modeOf(file) })));
  event.waitUntil(caches.open(name).then(add));
});
self.addEventListener('activate', (event) => {
  const old = (key) => key.startsWith('${prefix}') && key !== name;
  event.waitUntil(
    caches.keys().then((keys) => Promise.all(keys.filter(old).map((key) => caches.delete(key)))),
  );
});
self.addEventListener('fetch', (event) => {
  const { method, url, destination } = event.request;
  if (method !== 'GET' || !url.startsWith(scope.href)) return;
  const find = async () => {
    const cache = await caches.open(name);
    const page = url.split(/[?#]/)[0];
    return (await cache.match(page.endsWith('/') ? page + 'index.html' : page)) ?? fetch(event.request);
  };
  event.respondWith(isolated.includes(destination) ? find().then(isolate) : find());
});
`;

/**
 * `files`: name → content, all that the page needs once it is open. `prefix`: of the names of its caches; two pages of one
 * host that have the same delete one another's.
 */
export function serviceWorker(files, prefix = 'hgp-') {
  const names = [...files.keys()].sort();
  const hash = createHash('sha256');
  for (const file of names) hash.update(file).update(files.get(file));
  return script(
    names.map((file) => `./${file}`),
    prefix,
    hash.digest('hex').slice(0, 16),
  );
}
