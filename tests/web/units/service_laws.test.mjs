// Laws of what the page takes from the browser: storage, trusted scripts, the worker for offline use, preferences. Whatever
// of it is not there or not allowed, the page works.

import assert from 'node:assert/strict';
import test from 'node:test';
import { restorable, saveCones } from '../../../web/src/services/cone_storage.ts';
import { keepOffline } from '../../../web/src/services/solver.ts';
import { keepRecent, recentFiles, forgetRecent } from '../../../web/src/services/recent_files.ts';
import { UiState, targetIds } from '../../../web/src/model/ui_state.ts';
import { randomFrom } from '../../mutation/draw.mjs';
import { cubeMesh, toGlb, toGltf } from '../../support/meshes.mjs';
import { database } from './database_stand_in.mjs';
import { replace } from '../../support/replaced.mjs';

const turn = () => new Promise((resolve) => setImmediate(resolve));
async function until(condition) {
  for (let i = 0; i < 2000 && !condition(); i++) await turn();
  assert.ok(condition());
}

test('cones come back as they were stored, each mesh its own, the last ones that were stored', async (t) => {
  const kept = database((act) => setImmediate(act));
  replace(t, 'indexedDB', kept);
  const random = randomFrom(8);
  const whole = (below) => Math.floor(below * random());
  const list = (make) => Array.from({ length: whole(4) }, make);
  const index = () => (random() < 0.3 ? null : whole(9) - 4);
  const places = ['a', 'b', 'a.1'].flatMap((sha256) => [0, 1, 2].map((surface) => ({ file: { sha256 }, surface }))).filter(({ file, surface }) => !(file.sha256 === 'a.1' && surface === 0)); // prettier-ignore
  const last = new Map();
  for (let i = 0; i < 60; i++) {
    const place = places[whole(places.length)];
    const prescription = { q: 1 + whole(6), cones: list(() => ({ vertex: whole(99), k: whole(9) })), turnings: list(index), handles: list(index) }; // prettier-ignore
    await saveCones(place, prescription);
    last.set(place, prescription);
    const asked = places[whole(places.length)];
    assert.deepEqual((await restorable(asked))?.prescription, last.get(asked));
  }
  await until(() => kept.openCount() === 0);
});

test('whoever has the database open lets another page make a new version of it, and loses nothing', async (t) => {
  const kept = database((act) => setImmediate(act));
  replace(t, 'indexedDB', kept);
  const place = { file: { sha256: 'x' }, surface: 0 };
  const prescription = { q: 4, cones: [{ vertex: 0, k: 3 }], turnings: [], handles: [] };
  await saveCones(place, prescription);
  const reading = restorable(place);
  const upgraded = await new Promise((resolve, reject) => {
    const opening = kept.open('hgp', 7);
    opening.onsuccess = () => resolve(opening.result);
    opening.onerror = reject;
  });
  assert.deepEqual((await reading)?.prescription, prescription);
  assert.equal(upgraded.version, 7);
  upgraded.close();
  assert.deepEqual((await restorable(place))?.prescription, prescription, 'in the new version');
});

test('storage that fails at any of its steps is as none: nothing is there, nothing throws', async (t) => {
  const place = { file: { sha256: 'x' }, surface: 1 };
  const prescription = { q: 4, cones: [], turnings: [], handles: [] };
  const refused = (error) => {
    const request = { error };
    setImmediate(() => request.onerror?.());
    return request;
  };
  const opens = {
    'there is none': undefined,
    forbidden: () => {
      throw new Error('forbidden');
    },
    'not now': () => refused(new Error('not now')),
    'without a reason': () => refused(),
    'nothing in it': () => {
      const request = { result: { objectStoreNames: { contains: () => true }, transaction: () => ({ objectStore: () => ({ put: refused, get: refused, getAll: refused, count: refused, clear: refused }) }) } }; // prettier-ignore
      setImmediate(() => request.onsuccess());
      return request;
    },
  };
  for (const [step, open] of Object.entries(opens)) {
    replace(t, 'indexedDB', open && { open });
    await saveCones(place, prescription);
    await keepRecent('a', 'b', new Map([['b', new Uint8Array(3)]]));
    await forgetRecent();
    assert.deepEqual([await restorable(place), await recentFiles()], [undefined, []], step);
  }
});

test('six files are kept, the newest first; of one that is opened again the last version, and none that is large', async (t) => {
  const kept = database((act) => setImmediate(act));
  replace(t, 'indexedDB', kept);
  let now = 5;
  t.mock.method(Date, 'now', () => (now += 1));
  const random = randomFrom(2);
  let wanted = [];
  for (let i = 0; i < 40; i++) {
    const id = `${Math.floor(9 * random())}`;
    const isLarge = random() < 0.2;
    const content = isLarge ? new Proxy(new Blob(['x']), { get: (of, key) => (key === 'size' ? 48 * 2 ** 20 : of[key]) }) : new Blob([`${i}`]); // prettier-ignore
    await keepRecent(id, `${i}.obj`, new Map([['a', content], ['b', new Uint8Array(1)]])); // prettier-ignore
    if (!isLarge) wanted = [{ id, main: `${i}.obj` }, ...wanted.filter((one) => one.id !== id)].slice(0, 6); // prettier-ignore
    await until(() => kept.openCount() === 0);
    assert.deepEqual((await recentFiles()).map(({ id, main }) => ({ id, main })), wanted); // prettier-ignore
  }
  await forgetRecent();
  assert.deepEqual(await recentFiles(), []);
});

test('a browser with trusted types gets only the scripts of the page as such; another takes every address as it is', async (t) => {
  const rules = [];
  replace(t, 'trustedTypes', {
    createPolicy(name, rule) {
      rules.push([name, rule]);
      return { createScriptURL: (url) => ({ trusted: rule.createScriptURL(url) }) };
    },
  });
  const trusted = await import('../../../web/src/services/trusted_types.ts?with');
  const own = [trusted.workerUrl, trusted.geometryUrl, trusted.validatorUrl, trusted.offlineUrl];
  for (const url of own) assert.deepEqual(trusted.scriptUrl(url), { trusted: url });
  for (const url of [
    './other.js',
    `${trusted.offlineUrl}?x`,
    'https://elsewhere.example/sw.js',
    ' ',
  ])
    assert.throws(() => trusted.scriptUrl(url), TypeError, url);
  assert.equal(rules.length, 1, 'one policy');
  replace(t, 'trustedTypes', undefined);
  const plain = await import('../../../web/src/services/trusted_types.ts?without');
  for (const url of [...own, './other.js']) assert.equal(plain.scriptUrl(url), url);
});

test('the worker for offline use is registered once, when there is time; without one the page goes on', async (t) => {
  const registered = [];
  const worker = (answer) => ({ serviceWorker: { register: (url) => (registered.push(url), answer()) } }); // prettier-ignore
  const waiting = [];
  replace(t, 'requestIdleCallback', (act, { timeout }) => waiting.push([act, timeout]));
  for (const answer of [async () => {}, () => Promise.reject(new Error('not allowed'))]) {
    replace(t, 'navigator', worker(answer));
    keepOffline();
    assert.deepEqual(registered, [], 'not at once');
    const [[act, timeout]] = waiting.splice(0);
    assert.ok(timeout >= 1000 && timeout <= 10_000, `${timeout} milliseconds at most`);
    act();
    await turn();
    assert.deepEqual(registered.splice(0), ['./sw.js']);
  }
  replace(t, 'navigator', {});
  keepOffline();
  assert.deepEqual(waiting, []);
  delete globalThis.requestIdleCallback;
  replace(
    t,
    'navigator',
    worker(async () => {}),
  );
  t.mock.timers.enable({ apis: ['setTimeout'] });
  keepOffline();
  t.mock.timers.tick(900);
  assert.deepEqual(registered, []);
  t.mock.timers.tick(9000);
  assert.deepEqual(registered, ['./sw.js']);
});

test('the validator finds the files of a glTF by their decoded names, and tells what is wrong with one', async (t) => {
  let listen;
  const answers = [];
  replace(t, 'document', undefined); // a worker has none, and the validator looks
  replace(t, 'addEventListener', (type, act) => (assert.equal(type, 'message'), (listen = act)));
  replace(t, 'postMessage', (message) => answers.push(message));
  await import('../../../web/src/services/validator_worker.ts?alone');
  const bytes = (content) => new Uint8Array(typeof content === 'string' ? new TextEncoder().encode(content) : content); // prettier-ignore
  const ask = async (main, files) => {
    const { length } = answers;
    listen({ data: { main, files: new Map(Object.entries(files).map(([name, content]) => [name, bytes(content)])) } }); // prettier-ignore
    const end = Date.now() + 20_000;
    while (answers.length === length && Date.now() < end) await new Promise((resolve) => setTimeout(resolve, 2)); // prettier-ignore
    return answers.at(-1);
  };
  const good = (await ask('a.glb', { 'a.glb': toGlb([cubeMesh(2)]) })).report;
  assert.deepEqual([good.issues.numErrors, good.uri, good.validatedAt], [0, 'a.glb', undefined]);
  const { json, bin } = toGltf([cubeMesh(2)], { buffer: 'a%20b.bin' });
  const text = JSON.stringify(json);
  const found = (await ask('a.gltf', { 'a.gltf': text, 'a b.bin': bin })).report;
  assert.equal(found.issues.numErrors, 0);
  const missing = (await ask('a.gltf', { 'a.gltf': text, 'a%20b.bin': bin })).report;
  assert.ok(missing.issues.messages.some(({ message }) => message.includes('a%20b.bin is not here'))); // prettier-ignore
  // Of very many issues, a hundred.
  const many = { ...json, nodes: Array.from({ length: 300 }, () => ({ mesh: 99 })) };
  const all = (await ask('a.gltf', { 'a.gltf': JSON.stringify(many), 'a b.bin': bin })).report.issues; // prettier-ignore
  assert.deepEqual([all.truncated, all.messages.length], [true, 100]);
  const { error, report } = await ask('b.glb', { 'a.glb': 'x' });
  assert.ok(typeof error === 'string' && error.length > 0 && report === undefined);
});

/** A window whose preferences change, and a storage. */
function withWindow(t, stored, isAllowed = true) {
  const queries = new Map();
  const matching = new Set();
  replace(t, 'matchMedia', (query) => {
    const one = { matches: matching.has(query), addEventListener: (type, act) => (one.act = act) };
    queries.set(query, one);
    return one;
  });
  const refuse = () => {
    throw new Error('storage is not allowed');
  };
  const storage = { getItem: (key) => stored.get(key) ?? null, setItem: (key, value) => void stored.set(key, value) }; // prettier-ignore
  replace(t, 'localStorage', isAllowed ? storage : { getItem: refuse, setItem: refuse });
  const style = new Map();
  const root = { dataset: {}, style: { setProperty: (name, value) => style.set(name, value) } };
  replace(t, 'document', { documentElement: root });
  return { queries, matching, style, root };
}

test('preferences are those that were chosen last, also in a new page, and also where nothing can be stored', (t) => {
  const fields = ({ theme, hasKeys, automatic, target, isDark }) => ({ theme, hasKeys, automatic, target, isDark }); // prettier-ignore
  const random = randomFrom(6);
  for (const isAllowed of [true, false]) {
    const stored = new Map();
    const { root } = withWindow(t, stored, isAllowed);
    const first = fields(new UiState());
    assert.deepEqual(first, { theme: 'auto', hasKeys: true, automatic: undefined, target: 'blender', isDark: false }); // prettier-ignore
    const ui = new UiState();
    for (let i = 0; i < 60; i++) {
      const before = fields(ui);
      const isOn = random() < 0.5;
      const target = targetIds[Math.floor(random() * targetIds.length)];
      const change = [
        ['hasKeys', () => ui.setKeys(isOn), isOn],
        ['automatic', () => ui.setAutomatic(isOn), isOn],
        ['target', () => ui.setTarget(target), target],
        ['theme', () => ui.nextTheme(), { auto: 'light', light: 'dark', dark: 'auto' }[ui.theme]],
      ][Math.floor(4 * random())];
      change[1]();
      const wanted = { ...before, [change[0]]: change[2] };
      wanted.isDark = wanted.theme === 'dark';
      assert.deepEqual(fields(ui), wanted);
      if (change[0] === 'theme') assert.equal(root.dataset.theme, ui.theme);
      assert.deepEqual(fields(new UiState()), isAllowed ? wanted : first);
    }
    // What is stored by hand, or by another version.
    for (const key of stored.keys()) stored.set(key, 'nonsense');
    assert.deepEqual(fields(new UiState()), first);
  }
});

test('the page follows the window: phones, narrow ones, and the system’s colours unless others were chosen', (t) => {
  const { queries, matching } = withWindow(t, new Map());
  const members = { isPhone: /640/, isNarrow: /900/, isSystemDark: /dark/ };
  for (const [name, pattern] of Object.entries(members)) {
    const ui = new UiState();
    const [query, one] = [...queries].find(([text]) => pattern.test(text));
    const all = () => Object.keys(members).filter((each) => ui[each]);
    assert.deepEqual(all(), []);
    one.act({ matches: true });
    assert.deepEqual(all(), [name]);
    assert.equal(ui.isDark, name === 'isSystemDark');
    one.act({ matches: false });
    assert.deepEqual(all(), []);
    matching.add(query);
    assert.deepEqual(Object.keys(members).filter((each) => new UiState()[each]), [name], 'from the start'); // prettier-ignore
    matching.clear();
  }
});

test('the views are a fifth to four fifths wide, in whole percents; a column is sorted up, then down, then up', (t) => {
  const { style } = withWindow(t, new Map());
  const ui = new UiState();
  for (const percent of [-50, 0, 19.9, 20, 20.4, 33.3, 50, 79.6, 80, 81, 1e9]) {
    ui.setSplit(percent);
    assert.ok(ui.split >= 20 && ui.split <= 80 && Number.isInteger(ui.split), `${percent}`);
    if (percent >= 20 && percent <= 80) assert.ok(Math.abs(ui.split - percent) <= 0.5);
    assert.equal(Number(style.get('--part')), ui.split / 100);
  }
  const seen = ['vertex', 'vertex', 'vertex', 'k', 'number', 'number', 'k'].map((by) => {
    ui.sortBy(by);
    assert.equal(ui.sort.by, by);
    return ui.sort.isDown;
  });
  assert.deepEqual(seen, [false, true, false, false, false, true, false]);
});
