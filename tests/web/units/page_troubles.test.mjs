// What goes wrong around the page: files that are too large or come while others are read, networks that are not there, clipboards
// that are closed, workers that end, maps that the solver no longer has.

import assert from 'node:assert/strict';
import test from 'node:test';
import { gzipSync } from 'node:zlib';
import { examples } from '../../support/page_examples.mjs';
import { cubeMesh, packGlb, toGlb, toGltf, toObj } from '../../support/meshes.mjs';
import {
  $,
  copied,
  drawn,
  openFiles,
  openPage,
  runNow,
  saved,
  skip,
  until,
} from './whole_page.mjs';
import { replace } from '../../support/replaced.mjs';

const load = (name) => import(`../../../web/src/actions/${name}.ts`);
const { close, open, openExample, supply, loadWithoutImages } = await load('open');
const { setPrescription } = await load('edit_cones');
const { watchCones } = await load('check_cones');
const { download } = await load('download');
const { copyCommand } = await load('copy_command');
const { copyLink } = await load('share');
const { switchMesh } = await load('load');
const { rewrite } = await load('solve');
const { saveTurntable, savePicture, whyNoTurntable } = await load('picture');
const { validate } = await load('validate');
const { GeometryClient } = await import('../../../web/src/services/geometry_client.ts');
const { seamLimit, areaLimit, stretchLimit } = await import('../../../web/src/services/geometry/overlay_colours.ts'); // prettier-ignore

const bytes = (text) => new TextEncoder().encode(text);
const fileSet = (files) => new Map(Object.entries(files));
async function pageWith(t, files) {
  const app = await openPage(t);
  await openFiles(app, files);
  app.ui.setAutomatic(false);
  return app;
}
test('what a test replaces in the global object is there again after it, however often it replaces it', async (t) => {
  const names = ['Worker', 'fetch', 'navigator', 'noSuchThing'];
  const there = () => names.map((name) => Object.getOwnPropertyDescriptor(globalThis, name));
  const before = there();
  for (const times of [1, 2, 3])
    await t.test(`${times}`, (inner) => {
      for (let i = 0; i < times; i++)
        for (const name of names) {
          replace(inner, name, `${name} ${i}`);
          assert.equal(globalThis[name], `${name} ${i}`);
        }
    });
  assert.deepEqual(there(), before);
  assert.equal('noSuchThing' in globalThis, false);
});

test(
  'files up to half a gigabyte are read, larger ones refused; who opens another file sees the last one',
  { skip },
  async (t) => {
    class Sized extends Blob {
      constructor(size, text) {
        super([text]);
        Object.defineProperty(this, 'size', { value: size });
      }
    }
    const app = await openPage(t);
    const { doc } = app;
    const most = 512 * 2 ** 20;
    const cube = toObj(cubeMesh(1));
    await open(app, fileSet({ 'cube.obj': bytes(cube), 'b.bin': new Sized(most + 1 - cube.length, 'x') })); // prettier-ignore
    assert.deepEqual([doc.stateName, doc.message.kind], ['empty', 'error']);
    await open(app, fileSet({ 'cube.obj': bytes(cube), 'b.bin': new Sized(most - cube.length, 'x') })); // prettier-ignore
    assert.equal(doc.usableModel?.main, 'cube.obj');

    const { model } = doc;
    await open(app, new Map());
    assert.equal(doc.model, model, 'nothing was dropped');
    await Promise.all([
      open(app, fileSet({ 'first.obj': bytes(toObj(cubeMesh(2))) })),
      open(app, fileSet({ 'second.obj': bytes(cube) })),
    ]);
    await until(() => !doc.isBusy);
    assert.equal(doc.model.main, 'second.obj');
    await supply(app, fileSet({ 'c.bin': bytes('x') }));
    await loadWithoutImages(app);
    assert.equal(doc.model.main, 'second.obj', 'nothing is missing');

    // Closing overtakes what is about to be read, also where another file comes then that takes longer.
    const packed = new Blob([gzipSync(toObj(cubeMesh(12)))]);
    const before = open(app, fileSet({ 'before.obj': bytes(cube) }));
    close(app);
    const after = open(app, fileSet({ 'after.obj.gz': packed }));
    await Promise.all([before, after]);
    await until(() => !doc.isBusy);
    assert.equal(doc.model?.main, 'after.obj');

    // What is dropped while the solver starts is opened then; of several the last.
    const { client } = app;
    doc.clearModel();
    doc.state = { kind: 'starting' };
    const asked = [
      open(app, fileSet({ 'early.obj': bytes(cube) })),
      open(app, fileSet({ 'late.obj': bytes(cube) })),
    ];
    await drawn();
    assert.deepEqual([doc.stateName, doc.message.kind], ['starting', 'note']);
    doc.state = { kind: 'empty' };
    await Promise.all(asked);
    await until(() => !doc.isBusy);
    assert.equal(doc.model?.main, 'late.obj');
    doc.clearModel();
    doc.state = { kind: 'starting' };
    app.client = undefined;
    const never = open(app, fileSet({ 'never.obj': bytes(cube) }));
    doc.state = { kind: 'failed' };
    await never;
    assert.equal(doc.stateName, 'failed');
    app.client = client;
  },
);

test(
  'a file that refers to what is outside of its folder is told of, and read without it',
  { skip },
  async (t) => {
    const { json, bin } = toGltf([cubeMesh(2)]);
    json.images = [{ uri: '../secret.png' }];
    const app = await openPage(t);
    await openFiles(app, { 'cube.gltf': JSON.stringify(json), 'cube.bin': bin });
    assert.ok(app.doc.log.some(({ text }) => text.includes('../secret.png')));
  },
);

test(
  'an example comes with its q and cones; without a network, or where another file came first, it does not',
  { skip },
  async (t) => {
    const [example] = examples.filter(({ cones }) => cones?.length > 0);
    const app = await pageWith(t, { 'own.obj': toObj(cubeMesh(2)) });
    const { doc } = app;
    const { model } = doc;
    const answers = {
      'no network': () => Promise.reject(new Error('offline')),
      'not there': () => Promise.resolve({ ok: false, status: 404 }),
    };
    for (const [what, fetch] of Object.entries(answers)) {
      replace(t, 'fetch', fetch);
      await assert.rejects(openExample(app, example), (error) => error.message.includes(what === 'not there' ? '404' : 'offline')); // prettier-ignore
      assert.equal(doc.model, model, what);
    }
    const file = toGlb([cubeMesh(4)]);
    let give;
    replace(t, 'fetch', (url) => new Promise((resolve) => (give = () => resolve({ ok: url.endsWith(example.file), arrayBuffer: async () => new Uint8Array(file).buffer })))); // prettier-ignore
    const late = openExample(app, example);
    await openFiles(app, { 'mine.obj': toObj(cubeMesh(1)) });
    give();
    await late;
    await drawn();
    assert.equal(doc.model.main, 'mine.obj');
    const opened = openExample(app, example);
    give();
    await opened;
    await until(() => !doc.isBusy);
    assert.deepEqual([doc.model.main, doc.prescription.q, doc.prescription.cones, doc.hasUserCones], [example.file, example.q, example.cones, true]); // prettier-ignore
    assert.deepEqual([doc.history.canUndo, doc.message], [false, undefined]);
  },
);

test(
  'what cannot be copied is shown; what a command or a link leaves out is named',
  { skip },
  async (t) => {
    const app = await pageWith(t, { 'cube.obj': toObj(cubeMesh(3)) });
    const { doc } = app;
    const kinds = [];
    const say = async (act) => {
      doc.message = undefined;
      await act(app);
      kinds.push(doc.message.kind);
      return doc.message.text;
    };
    const plain = await say(copyCommand);
    const command = copied.at(-1);
    const link = await say(copyLink);
    const edges = [[doc.model.surface.triangles[0], doc.model.surface.triangles[1]]];
    doc.features = { hasCreases: false, hasRims: false, edges, rims: [] };
    assert.ok((await say(copyCommand)).length > plain.length, 'the file of edges');
    doc.features = undefined;
    const cones = Array.from({ length: 300 }, (_, i) => ({ vertex: i % 50, k: 3 }));
    doc.begin({ ...doc.prescription, cones });
    assert.ok((await say(copyCommand)).length > plain.length, 'the file of cones');
    doc.begin({ ...doc.prescription, cones: [] });
    doc.field = { name: 'a.rosy', text: '' };
    doc.solve = { ...doc.solve, frames: 'file' };
    assert.ok((await say(copyLink)).includes('a.rosy'));
    doc.solve = { ...doc.solve, frames: 'auto' };
    assert.equal(await say(copyLink), link);
    assert.ok(link.includes('cube.obj'));
    assert.deepEqual([...new Set(kinds)], ['good']);
    await runNow(app);
    const result = await say(copyCommand);
    doc.solutions = [{ ...doc.current, isDragged: true }];
    assert.notEqual(await say(copyCommand), result);
    const { length } = copied;
    replace(t, 'navigator', { ...navigator, clipboard: { writeText: () => Promise.reject(new Error('no')) } }); // prettier-ignore
    doc.solutions = [];
    doc.begin({ ...doc.prescription, cones: [] });
    assert.ok((await say(copyCommand)).includes(command));
    await say(copyLink);
    assert.deepEqual([kinds.slice(-2), copied.length], [['note', 'note'], length]);
  },
);

test(
  'a map that the solver no longer has is made again for the file of all meshes, with the settings of the one that is open',
  { skip },
  async (t) => {
    const parts = toGltf([cubeMesh(3), cubeMesh(4)], { uv: { 1: ([x, y]) => [x / 3, y / 3] } });
    const app = await pageWith(t, { 'two.glb': packGlb(parts) });
    const { doc, client } = app;
    const first = doc.model.info.surface;
    await runNow(app);
    await switchMesh(app, 1 - first);
    await runNow(app);
    const waiting = doc.meshes.get(first);
    const saves = async () => {
      const count = saved.length;
      await download(app, 'same');
      await until(() => saved.length > count && saved.at(-1).name);
      const files = new Map([['a.glb', new Uint8Array(await saved.at(-1).blob.arrayBuffer())]]);
      const seen = [];
      for (const surface of [0, 1]) {
        const model = await client.load({ main: 'a.glb', files }, { surface });
        const { certified, triangles } = await model.verify();
        seen.push([certified, triangles, model.info.surfaces[surface].uvSets]);
      }
      return seen;
    };
    const triangles = doc.model.info.surfaces.map((one) => one.triangles);
    const whole = await saves();
    assert.deepEqual(whole.map(([good, count]) => [good, count]), triangles.map((count) => [true, count])); // prettier-ignore
    assert.equal(doc.message.kind, 'good');
    await waiting.solutions.at(-1).map.dispose();
    assert.deepEqual(await saves(), whole, 'the map was made again');
    await waiting.model.solver.dispose();
    assert.deepEqual(await saves(), whole, 'so was its mesh');
    await rewrite(app, { scale: 'fit' });
    assert.deepEqual(await saves(), whole, 'in the scale of the open one');
    await rewrite(app, { hasGrid: true });
    assert.equal((await saves()).every(([good]) => good), true); // prettier-ignore
    const sets = doc.model.info.surfaces.map(({ uvSets }) => uvSets ?? []);
    if (sets[doc.model.info.surface].length > 0) {
      await rewrite(app, { hasGrid: false, uvSet: 0 });
      assert.equal((await saves()).every(([good]) => good), true, 'a set that one of them has not'); // prettier-ignore
    }
    // A single map is made again as well.
    await doc.current.map.dispose();
    const count = saved.length;
    await download(app, 'obj');
    await until(() => saved.length > count && saved.at(-1).name);
    assert.equal(doc.current.map.isDisposed, false);
    await switchMesh(app, first);
    assert.deepEqual([doc.model.solver.isDisposed, doc.model.info.surface], [false, first]);
    assert.equal(doc.displayed.result, waiting.solutions.at(-1).result, 'its work is there');
  },
);

test(
  'the solver’s objection to cones is asked for once, for the cones that are there, and said',
  { skip },
  async (t) => {
    const app = await pageWith(t, { 'cube.obj': toObj(cubeMesh(3)) });
    const { doc } = app;
    const asked = [];
    const answer = { components: [{ warnings: [{ code: 'some-warning', numbers: {}, words: {}, where: [] }] }], error: undefined }; // prettier-ignore
    let answers = answer;
    const { solver } = doc.model;
    const check = (cones) => (asked.push(cones.features ?? cones.cones.length), Promise.resolve(answers)); // prettier-ignore
    const model = { ...doc.model, solver: new Proxy(solver, { get: (of, key) => (key === 'check' ? check : of[key]) }) }; // prettier-ignore
    doc.state = { kind: 'open', model };
    t.after(watchCones(app));
    const eight = (k = 3) => [...Array(8).keys()].map((vertex) => ({ vertex, k }));
    const place = async (cones) => {
      setPrescription(app, { ...doc.prescription, cones }, 'place');
      await drawn();
      return asked.splice(0);
    };
    await drawn();
    assert.deepEqual(asked, [], 'no cones were placed');
    assert.deepEqual(await place(eight()), [8]);
    assert.deepEqual([doc.objection.text, doc.objection.warnings.length], ['', 1]);
    assert.equal(doc.message, undefined);
    assert.equal(doc.budget.warnings.length, 1);
    assert.deepEqual(await place(eight().slice(1)), [], 'Gauss–Bonnet objects first');
    const refusal = { message: 'so it is', advice: [] };
    answers = { components: [{ warnings: [], error: refusal }], error: { message: 'in general', advice: [] } }; // prettier-ignore
    assert.deepEqual(await place(eight()), [8]);
    assert.ok(doc.objection.text.includes('so it is'));
    assert.deepEqual([doc.message.kind, doc.message.text], ['error', doc.objection.text]);
    assert.equal(doc.budget.isReady, false);
    answers = { components: [], error: refusal };
    assert.deepEqual(await place([...eight().slice(1), { vertex: 9, k: 3 }]), [8]);
    assert.ok(doc.objection.text.includes('so it is'));
    answers = answer;
    // While a cone is held the map of its place tells more; while maps are made by themselves there is none.
    const live = { base: undefined, state: 'heat', cornerUv: new Float32Array(), heat: new Float32Array(), notPositive: new Uint32Array(), reasons: [] }; // prettier-ignore
    doc.live = live;
    assert.deepEqual(await place(eight()), []);
    doc.live = undefined;
    await drawn();
    assert.deepEqual(asked.splice(0), [8], 'when it is dropped');
    doc.live = live;
    doc.automatic = { controller: new AbortController(), stage: 'solve' };
    assert.deepEqual(await place([...eight().slice(1), { vertex: 9, k: 3 }]), [8]);
    [doc.live, doc.automatic] = [undefined, undefined];
    await drawn();
    assert.deepEqual(asked.splice(0), [], 'once');
    const job = { kind: 'run', title: '', stage: 'read', entered: [], detail: '', fraction: 0, begin: 0, controller: new AbortController() }; // prettier-ignore
    doc.job = job;
    doc.begin({ ...doc.prescription, cones: eight() });
    await drawn();
    assert.deepEqual(asked.splice(0), []);
    doc.job = undefined;
    await drawn();
    assert.deepEqual(asked.splice(0), [8]);
    // Along features, with them; but not where Run chooses others, or where a plane has edges of its own.
    const features = { hasCreases: false, hasRims: false, edges: [[0, 1]], rims: [] };
    doc.features = features;
    await drawn();
    assert.deepEqual(asked.splice(0), []);
    const along = [{ rims: false, lines: [{ vertices: [0, 1] }] }];
    answers = { components: [], error: refusal };
    assert.deepEqual(await place([...eight().slice(1), { vertex: 9, k: 3 }]), along);
    assert.deepEqual([doc.budget.isReady, doc.message.actions.map(({ label }) => label)], [false, ['Let Run choose the cones']]); // prettier-ignore
    const { features: kept } = doc;
    doc.features = { ...kept, isSymmetric: true };
    await drawn();
    assert.deepEqual([doc.budget.isReady, asked.splice(0)], [true, []]);
    doc.features = kept;
    await drawn();
    assert.deepEqual([doc.budget.isReady, asked.splice(0)], [false, []], 'known already');
    answers = answer;
    doc.features = { ...kept, edges: [[1, 2]] };
    await drawn();
    assert.equal(asked.splice(0).length, 1);
    assert.equal(doc.budget.isReady, true);
  },
);

test(
  'a film is one turn at thirty frames a second, of its own kind; stopped, it is not saved',
  { skip },
  async (t) => {
    const app = await pageWith(t, { 'cube.obj': toObj(cubeMesh(2)) });
    const { doc, ui } = app;
    const canvas = $('#view');
    await savePicture(app);
    assert.equal(doc.message, undefined, 'there is no view');
    assert.notEqual(whyNoTurntable(), '');
    const [asked, told, stopped] = [[], [], []];
    let now = 0;
    let supported = 'video/mp4';
    class Recorder {
      static isTypeSupported = (kind) => kind === supported;
      listeners = {};
      constructor(stream, options) {
        asked.push({ rate: stream.rate, ...options });
      }
      addEventListener(type, act) {
        this.listeners[type] = act;
      }
      start() {}
      stop() {
        this.listeners.dataavailable({ data: new Blob(['film']) });
        this.listeners.stop();
      }
    }
    replace(t, 'MediaRecorder', Recorder);
    replace(t, 'requestAnimationFrame', (act) => setTimeout(() => act((now += 500))));
    const { prototype } = globalThis.HTMLCanvasElement;
    prototype.captureStream = (rate) => ({
      rate,
      getTracks: () => [{ stop: () => stopped.push(1) }],
    });
    t.after(() => delete prototype.captureStream);
    const orbit = { toText: () => 'place', fromText: (text) => told.push(text), move: (angle) => told.push(angle) }; // prettier-ignore
    const model = { canvas, orbit, setBacking() {}, draw() {}, picture: async (width) => (asked.push(width), new Blob(['png'])) }; // prettier-ignore
    app.views = { model };
    t.after(() => (app.views = undefined));
    const count = saved.length;
    ui.tab = 'map';
    await savePicture(app);
    assert.deepEqual([saved.at(-1).name, asked.pop(), ui.tab], ['cube.png', 2048, 'surface']);
    for (const [kind, name] of [
      ['video/mp4', 'cube.mp4'],
      ['video/webm', 'cube.webm'],
      ['video/webm;codecs=vp8', 'cube.webm'],
      ['video/webm;codecs=vp9', 'cube.webm'],
    ]) {
      // prettier-ignore
      supported = kind;
      assert.equal(whyNoTurntable(), '');
      await saveTurntable(app);
      assert.equal(saved.at(-1).name, name);
      assert.equal(await saved.at(-1).blob.text(), 'film');
      assert.deepEqual(asked.splice(0), [{ rate: 30, mimeType: kind, videoBitsPerSecond: 8e6 }]);
      assert.equal(told.pop(), 'place');
      const turned = told.splice(0);
      assert.ok(Math.abs(turned.reduce((sum, x) => sum + x) - 2 * Math.PI) < 1e-9);
      assert.equal(turned.length, 12, 'six seconds');
      assert.deepEqual([ui.isRecording, stopped.splice(0).length], [false, 1]);
    }
    assert.equal(saved.length, count + 5);
    const going = saveTurntable(app);
    assert.equal(ui.isRecording, true);
    await new Promise((resolve) => setTimeout(resolve, 4));
    await saveTurntable(app);
    await going;
    assert.deepEqual([saved.length, ui.isRecording, told.at(-1)], [count + 5, false, 'place']);
    const second = saveTurntable(app);
    doc.message.actions[0].run();
    await second;
    assert.equal(saved.length, count + 5);
    supported = '';
    assert.notEqual(whyNoTurntable(), '');
  },
);

test('a validator that fails, or does not start, is told as such', { skip }, async (t) => {
  const app = await pageWith(t, { 'cube.obj': toObj(cubeMesh(2)) });
  const { doc } = app;
  await validate(app);
  assert.equal(doc.validation, undefined, 'there is no map');
  await runNow(app);
  const issue = (severity, i) => ({ severity, message: `m${i}`, pointer: i === 0 ? '/a' : undefined }); // prettier-ignore
  const issues = (count, truncated, errors) => ({ numErrors: errors, numWarnings: 0, numInfos: 1, numHints: 2, truncated, messages: Array.from({ length: count }, (_, i) => issue(i % 4, i)) }); // prettier-ignore
  const ends = [];
  const answering = (act) =>
    class {
      postMessage({ main, files }) {
        assert.deepEqual([main, files.has(main)], ['cube.glb', true]);
        setTimeout(() => act(this));
      }
      terminate() {
        ends.push(1);
      }
    };
  const report = (count, truncated, errors) => (worker) => worker.onmessage({ data: { report: { issues: issues(count, truncated, errors), validatorVersion: '2' } } }); // prettier-ignore
  const seen = async (act) => {
    replace(t, 'Worker', answering(act));
    await validate(app);
    assert.equal(doc.validation.of, doc.current);
    assert.equal(ends.splice(0).length, 1);
    return [doc.validation.isGood, doc.validation.issues.length];
  };
  assert.deepEqual(await seen(report(0, false, 0)), [true, 0]);
  // As many as fit, of which those that are left out are the least severe.
  for (const count of [1, 2, 11, 12, 13, 40, 500]) {
    const [, lines] = await seen(report(count, false, 0));
    assert.equal(lines, Math.min(count, 13), `${count}`);
    const worst = Math.ceil(count / 4);
    assert.equal(doc.validation.issues.filter((line) => line.startsWith('Error')).length, Math.min(12, worst)); // prettier-ignore
  }
  assert.deepEqual(await seen(report(12, false, 0)), [true, 12]);
  assert.deepEqual(await seen(report(13, false, 1)), [false, 13]);
  assert.deepEqual(await seen(report(4, true, 0)), [true, 5]);
  const [first] = doc.validation.issues;
  assert.ok(first.includes('m0') && first.includes('/a'), 'the most severe first');
  assert.ok(!doc.validation.issues[1].includes('('));
  assert.deepEqual(await seen((worker) => worker.onmessage({ data: { error: 'so it is' } })), [false, 0]); // prettier-ignore
  assert.ok(doc.validation.text.includes('so it is'));
  assert.deepEqual(await seen((worker) => worker.onerror()), [false, 0]);
});

test('a geometry worker that ends fails what it was asked, and the next call starts another', async (t) => {
  const workers = [];
  replace(t, 'Worker', class {
    listeners = {};
    posted = [];
    constructor() {
      workers.push(this);
    }
    addEventListener(type, act) {
      this.listeners[type] = act;
    }
    postMessage(message) {
      this.posted.push(message);
    }
    terminate() {
      this.isEnded = true;
    }
    answer(data) {
      this.listeners.message({ data });
    }
  }); // prettier-ignore
  const client = new GeometryClient();
  client.prepare();
  client.prepare();
  assert.equal(workers.length, 1);
  const [one, other] = [client.call('opposite', [1, 2]), client.call('opposite', [1, 3])];
  assert.deepEqual(workers[0].posted.map(({ method, args }) => [method, ...args]), [['opposite', 1, 2], ['opposite', 1, 3]]); // prettier-ignore
  const [a, b] = workers[0].posted.map(({ call }) => call);
  assert.notEqual(a, b);
  workers[0].answer({ call: b, result: 'second' });
  assert.equal(await other, 'second');
  workers[0].answer({ call: a, error: 'no' });
  await assert.rejects(one, /^Error: no$/);
  const surface = client.surface({}, {}, []);
  const map = client.analyse({ id: 1 }, {}, {}, [], {});
  const lost = client.call('opposite', [1, 2]);
  workers[0].listeners.error({ message: 'out of memory' });
  await assert.rejects(lost, /out of memory/);
  for (const call of [surface, map]) await assert.rejects(call, /out of memory/);
  assert.equal(workers[0].isEnded, true);
  client.keepOnly(new Set(), new Set());
  assert.equal(workers.length, 1, 'nothing is left to forget');
  const again = client.call('opposite', [1, 2]);
  assert.equal(workers.length, 2);
  workers[1].answer({ call: workers[1].posted[0].call, result: 'new' });
  assert.equal(await again, 'new');
  void client.surface({}, {}, []);
  void client.surface({}, {}, []);
  const ids = workers[1].posted.slice(1).map(({ args: [id] }) => id);
  assert.equal(new Set(ids).size, 2);
  client.keepOnly(new Set([ids[1]]), new Set());
  assert.deepEqual(workers[1].posted.at(-1).args, [[ids[0]], []]);
  const { length } = workers[1].posted;
  client.keepOnly(new Set([ids[1]]), new Set());
  assert.equal(workers[1].posted.length, length, 'it is forgotten already');
});

test('the end of a ramp is its outermost percent, and a number in any case', () => {
  for (const [given, limit] of [[3, 3], [0, 1], [Infinity, 1], [NaN, 1], [0.2, 0.2]]) assert.equal(seamLimit({ seamDistance: { p99: given } }), limit); // prettier-ignore
  for (const [given, limit] of [[3, 3], [0, 0.01], [0.02, 0.02]]) assert.equal(areaLimit({ areaSize: { p99: given } }), limit); // prettier-ignore
  for (const [given, limit] of [[3, 3], [1, 1.001]]) assert.equal(stretchLimit({ stretch: { p99: given } }), limit); // prettier-ignore
});
