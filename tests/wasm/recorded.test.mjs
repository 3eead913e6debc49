// Recorded: every public function of the package with its options, its answers and its refusals, the adapters, and the
// sentence of every code.

import test from 'node:test';
import { gzipSync } from 'node:zlib';
import { Document, NodeIO } from '@gltf-transform/core';
import { Gunzip } from 'fflate';
import * as THREE from 'three';
import { beside, blocks, eight } from '../support/blocks.mjs';
import {
  cubeMesh,
  packGlb,
  toGlb,
  toGltf,
  toObj,
  toOff,
  toPly,
  toStl,
} from '../support/meshes.mjs';
import { Recording, valueText } from '../support/recording.mjs';
import { asFiles, bytesOf, createClient, createCore, HgpError } from './support.mjs';
import { seamless } from '../../build/package/gltf-transform.js';
import { readMembers } from '../../build/package/gzip.js';
import { corePhrases } from '../../build/package/lib/core_phrases.js';
import { packagePhrases, phrase } from '../../build/package/lib/phrases.js';
import { createLite } from '../../build/package/node/lite.js';
import { parametrizeGeometry } from '../../build/package/three.js';

const box = (n) => {
  const { vertices, triangles } = cubeMesh(n);
  return { vertices: vertices.map(([x, y, z]) => [1.3 * x + 0.03 * y, y + 0.02 * z * z, 0.8 * z]), triangles }; // prettier-ignore
};
const arraysOf = ({ vertices, triangles }) => ({ positions: vertices.flat(), triangles: triangles.flat() }); // prettier-ignore
const small = box(2);
const open = blocks(['##'], { n: 2, open: ['0 0 +z'] });
/** What is another in every run: times, and the version. */
const left = /^(?:seconds|time|timings|version|milliseconds|hgp|program|generator|sha256)$/i;

function bare(value, depth = 6) {
  if (value === null || typeof value !== 'object' || ArrayBuffer.isView(value)) return value;
  if (depth === 0) return '…';
  if (value instanceof Map) return new Map([...value].map(([key, one]) => [key, bare(one, depth - 1)])); // prettier-ignore
  if (Array.isArray(value)) return value.map((one) => bare(one, depth - 1));
  return Object.fromEntries(Object.entries(value).filter(([key, one]) => !left.test(key) && typeof one !== 'function').map(([key, one]) => [key, bare(one, depth - 1)])); // prettier-ignore
}

/** Of a certificate what this package has to do with: its numbers are the core's. */
const shortly = ({ certified, precision, triangles, components, reasons }) => ({ certified, precision, triangles, components: components?.length, reasons }); // prettier-ignore

/** What a call gives, or how it fails. */
async function outcome(act) {
  try {
    return valueText(bare(await act()), 6);
  } catch (error) {
    const { code, message: text, stage, where, rule } = error;
    // Engines word theirs in their own way.
    const message = code === 'wasm-unavailable' ? text.replace(/loaded: (?!.*HTTP).*/s, 'loaded') : text; // prettier-ignore
    const isOwn = error instanceof HgpError;
    return `fails: ${isOwn ? '' : error.name}${valueText({ code, message, stage, where, rule: rule === text ? undefined : rule })}`; // prettier-ignore
  }
}

function session(t, name) {
  const recording = new Recording(name, import.meta.dirname);
  return {
    say: async (what, act) => recording.add(`${what}: ${await outcome(act)}`),
    note: (...lines) => recording.add(...lines),
    end: () => recording.end(),
  };
}

const mapText = ({ certificate, uv, cornerToUv, uvToVertex, seams, cones, notes, report }) => ({ certificate: shortly(certificate), uv, cornerToUv, uvToVertex, seams: seams.length ?? seams, cones, notes, report: Object.keys(report ?? {}) }); // prettier-ignore

test('models, maps and files', async (t) => {
  const { say, note, end } = session(t, 'package');
  const client = await createClient();
  t.after(() => client.terminate());
  const load = (mesh, options, as = toObj, name = 'm.obj') => client.load(asFiles(name, bytesOf(as(mesh))), options); // prettier-ignore
  note('# loading');
  for (const [name, as] of Object.entries({ 'm.obj': toObj, 'm.off': toOff, 'm.ply': toPly, 'm.stl': toStl })) await say(`load ${name}`, async () => (await load(small, {}, as, name)).inspect()); // prettier-ignore
  await say('load a view', async () => (await client.load(new Uint8Array(toGlb([small, open])), { name: 'm.glb', surface: 1 })).inspect()); // prettier-ignore
  await say('load a blob', async () => (await client.load(new Blob([toObj(small)]), { name: 'm.obj' })).inspect()); // prettier-ignore
  await say('load a file', async () =>
    (await client.load(new File([toObj(small)], 'f.obj'))).inspect(),
  );
  await say('load gzip', async () => (await client.load(asFiles('m.obj.gz', gzipSync(toObj(small))))).inspect()); // prettier-ignore
  const { json, bin } = toGltf([small]);
  await say('load a set', async () => (await client.load({ main: 'm.gltf', files: new Map([['m.gltf', bytesOf(JSON.stringify(json))], ['cube.bin', bin]]) })).placements()); // prettier-ignore
  await say('load a set of which one is missing', () => client.load(asFiles('m.gltf', bytesOf(JSON.stringify(json))))); // prettier-ignore
  await say('load a mesh', async () => (await client.loadMesh(arraysOf(small))).inspect());
  await say('load typed arrays', async () => (await client.loadMesh({ positions: Float32Array.from(small.vertices.flat()), triangles: Uint16Array.from(small.triangles.flat()), weld: false })).inspect()); // prettier-ignore
  await say('load a soup', async () => (await client.loadMesh({ positions: small.triangles.flatMap((one) => one.flatMap((v) => small.vertices[v])), triangles: null })).inspect()); // prettier-ignore
  const [a, b, c] = small.triangles[3];
  const broken = { vertices: small.vertices, triangles: [...small.triangles.with(3, [a, c, b]), [1, 1, 4]] }; // prettier-ignore
  await say('load defects', async () => (await load(broken)).inspect());
  await say('strictly', () => load(broken, { strict: true }));
  await say('and fix them', async () => (await load(broken, { fix: { orient: true, degenerate: true } })).surface()); // prettier-ignore
  for (const options of [{ weld: -1 }, { weld: 'x' }, { surface: 1.5 }, { surface: 7 }, { limits: { triangles: 3 } }, { limits: { bytes: 9 } }, { limits: 3 }, { fix: 'all' }, { unknown: 1 }, { target: 'x' }, { name: 3 }]) await say(`load with ${valueText(options)}`, () => load(small, options)); // prettier-ignore
  for (const source of [undefined, 3, 'm.obj', {}, { main: 'a' }, { main: 'a', files: new Map() }, { main: 'a', files: {} }, new Uint8Array(0)]) await say(`load ${valueText(source)}`, () => client.load(source)); // prettier-ignore
  for (const mesh of [undefined, {}, { positions: [1, 2] }, { positions: [0, 0, 0, 1, 0, 0, 0, 1, 0], triangles: [0, 1] }, { positions: [0, 0, 0, 1, 0, 0, 0, 1, 0], triangles: [0, 1, 9] }, { positions: [0, 0, NaN, 1, 0, 0, 0, 1, 0], triangles: [0, 1, 2] }, { positions: [0, 0, 0, 1, 0, 0, 0, 1, 0], triangles: [0, 1, -2] }, { positions: 'x', triangles: [] }, { ...arraysOf(small), q: 4 }]) await say(`load the mesh ${valueText(mesh)}`, () => client.loadMesh(mesh)); // prettier-ignore

  note('# a model');
  const model = await load(small);
  for (const method of ['inspect', 'surface', 'facts', 'placements', 'loops', 'embeddedCones', 'suggestCones', 'listFeatures']) await say(method, () => model[method]()); // prettier-ignore
  for (const options of [{ q: 6 }, { count: 8 }, { conesFor: 'few' }, { conesFor: 'fewer' }, { conesFor: 'more' }, { conesFor: 'low-distortion' }, { alignToCurvature: true }, { conesFor: 'x' }, { q: 0 }, { q: 2.5 }, { count: -1 }]) await say(`suggest ${valueText(options)}`, () => model.suggestCones(options)); // prettier-ignore
  const cones = await model.suggestCones();
  await say('features of 20 degrees', () => model.listFeatures({ creases: 20 }));
  await say('features as a file', () => model.listFeatures({ creases: 20 }, { name: 'x.json' }));
  const some = { ...cones, cones: cones.cones.slice(2) };
  for (const [name, one] of Object.entries({
    cones,
    some,
    none: { q: 4, cones: [] },
    odd: { q: 4, cones: [{ vertex: 0, k: 0 }] },
    far: { q: 4, cones: [{ vertex: 999, k: 3 }] },
    nothing: undefined,
    unknown: { ...cones, colour: 1 },
  })) {
    // prettier-ignore
    await say(`check ${name}`, () => model.check(one));
    await say(`balance ${name}`, () => model.balanceCones(one));
    await say(`scale of ${name}`, () => model.logScale(one));
  }
  const coneFile = JSON.stringify({ format: 'hgp-cones', version: 1, ...cones });
  await say('cones of a file', () => model.readCones({ name: 'a.cones.json', text: coneFile }));
  await say('cones of bytes', () => model.readCones({ name: 'a.cones.json', bytes: bytesOf(coneFile) })); // prettier-ignore
  await say('cones of no file', () => model.readCones({ name: 'a.sing', text: 'x' }));
  const finer = await load(box(3));
  await say('moved cones', () => finer.transferCones(cones, model));
  await say('moved from nothing', () => finer.transferCones(cones, {}));
  const rims = await load(open);
  await say('a rim', () => rims.loops());
  const eights = await load(blocks(eight, { n: 1 }));
  await say('handles', () => eights.loops());

  note('# maps');
  const options = [{}, { cones }, { q: 2 }, { q: 6 }, { conesFor: 'few' }, { improve: 'isometric' }, { improve: 'area' }, { improve: -0.5 }, { quality: true }, { scale: 'unit' }, { scale: 'fit' }, { grid: 'auto' }, { grid: { cells: 60 } }, { grid: { spacing: 0.5, mode: 'quad' } }, { features: { creases: 30 } }, { method: 'soft' }, { method: 'printed' }, { method: 'harmonic' }, { maxRounds: 1 }, { alignToCurvature: true }, { keepGoing: true, cones: { q: 4, cones: [{ vertex: 0, k: 12 }] } }, { cones: some }, { refine: true }]; // prettier-ignore
  for (const one of options) await say(`map with ${valueText(one)}`, async () => mapText(await model.parametrize(one))); // prettier-ignore
  for (const one of [{ q: 4, cones: { ...cones, q: 6 } }, { boundary: 'x' }, { improve: 3 }, { improve: 'x' }, { grid: 'x' }, { grid: { cells: 0 } }, { grid: { cells: 9, spacing: 1 } }, { maxRounds: 0 }, { features: 3 }, { frames: 'file' }, { scale: 2 }, { tolerance: 1 }, 3, null]) await say(`no map with ${valueText(one)}`, () => model.parametrize(one)); // prettier-ignore
  await say('with a convex rim', async () =>
    mapText(await rims.parametrize({ boundary: 'convex' })),
  );
  await say('along the rim', async () => mapText(await rims.parametrize({ features: { rims: true } }))); // prettier-ignore
  const map = await model.parametrize({ cones, grid: 'auto' });
  await say('measures', () => map.measure());
  await say('quads', () => map.quads());
  await say('quads by name', () => map.quads({ name: 'q' }));
  for (const one of [{}, { format: 'glb' }, { format: 'gltf' }, { format: 'obj' }, { format: 'flat-obj' }, { format: 'svg' }, { gridMaterial: 2 }, { gridMaterial: true }, { embedCones: false }, { name: 'other' }, { uvSet: 2 }, { format: 'x' }, { uvSet: -1 }, { gridMaterial: -2 }]) await say(`written with ${valueText(one)}`, async () => (await map.write(one)).files.map(({ name, bytes }) => ({ name, head: new TextDecoder('latin1').decode(bytes.subarray(0, 60)), bytes: /glb|gltf/.test(name) ? 0 : bytes.length }))); // prettier-ignore
  const written = await map.write();
  await say('notes of writing', () => ({ ...written, files: written.files.length }));
  const again = await client.load(asFiles('m.obj', written.files[0].bytes));
  await say('the cones in it', () => again.embeddedCones());
  for (const one of [{}, { cones }, { cones: some }, { q: 3 }, { tolerance: 1e-3 }, { uvSet: 4 }, { tolerance: -1 }]) await say(`verified with ${valueText(one)}`, async () => shortly(await again.verify(one))); // prettier-ignore
  await say('verified without a map', async () => shortly(await model.verify()));
  note('# drags');
  const drag = await map.beginDrag(cones.cones[0].vertex);
  const { neighbours, neighbourStart } = await model.facts();
  const next = neighbours[neighbourStart[cones.cones[0].vertex]];
  await say('dragged', async () => { const { uv, state, vertex } = await drag.dragTo(next); return { uv: uv?.length, state, vertex }; }); // prettier-ignore
  for (const one of [-1, 1.5, 9999, 'x']) await say(`dragged to ${one}`, () => drag.dragTo(one));
  await say('dropped', async () => { const { certificate, cones: at } = await drag.endDrag(); return { certified: certificate.certified, at }; }); // prettier-ignore
  await say('once more', () => drag.dragTo(next));
  await say('where no cone is', () => map.beginDrag(next));
  note('# whole files');
  const two = new Uint8Array(toGlb([small, open]));
  for (const one of [{ name: 'm.glb' }, { name: 'm.glb', surface: 1 }, { name: 'm.glb', keepGoing: true }, { name: 'm.glb', write: { format: 'obj' } }, { name: 'm.glb', write: { embedCones: false } }, { name: 'm.glb', cones }, { name: 'm.glb', unknown: 1 }]) await say(`a whole file with ${valueText(one)}`, async () => { const { files, meshes, ...others } = await client.parametrizeFile(two, one); return { files: files.map(({ name }) => name), meshes: meshes?.map(({ certificate, error, ...more }) => ({ certified: certificate?.certified, error, keys: Object.keys(more) })), ...others }; }); // prettier-ignore
  const parts = [];
  for (const surface of [0, 1])
    parts.push(await (await client.load(two, { name: 'm.glb', surface })).parametrize());
  await say('combined', async () => { const { files, ...others } = await client.combine(parts, { embedCones: false }); return { files: files.map(({ name }) => name), ...others }; }); // prettier-ignore
  for (const [name, args] of Object.entries({ nothing: [[]], 'no list': [3], 'one option too few': [parts, [{}]], 'of arrays': [[await (await client.loadMesh(arraysOf(small))).parametrize()]], 'other options': [parts, { format: 'obj' }] })) await say(`combined: ${name}`, () => client.combine(...args)); // prettier-ignore
  await say('a mesh at once', async () => mapText(await client.parametrizeMesh({ ...arraysOf(small), q: 4, weld: 0 }))); // prettier-ignore
  await say('a mesh at once, wrongly', () => client.parametrizeMesh({ ...arraysOf(small), q: 4, colour: 1 })); // prettier-ignore
  note('# ends');
  await say('a call that is aborted', () => model.parametrize({}, { signal: AbortSignal.abort(new Error('no')) })); // prettier-ignore
  await say('a call with a wrong signal', () => model.parametrize({}, { signal: 3 }));
  const stages = [];
  await say('progress', async () => void (await finer.parametrize({}, { onProgress: ({ stage }) => stages.includes(stage) || stages.push(stage) }))); // prettier-ignore
  await say('progress that throws', () => finer.parametrize({ improve: 0 }, { onProgress: () => { throw new Error('enough'); } })); // prettier-ignore
  await say('disposed', async () => { await map.dispose(); return [map.isDisposed, model.isDisposed]; }); // prettier-ignore
  await say('a map after its end', () => map.measure());
  await say('the model', async () => { await model.dispose(); return [map.isDisposed, model.isDisposed]; }); // prettier-ignore
  await say('a model after its end', () => model.inspect());
  client.terminate();
  await say('a client after its end', () => finer.inspect());
  for (const one of [{ warmUp: 3 }, { wasmUrl: 'file:///nowhere.wasm' }, { wasmUrl: 'data:application/wasm;base64,AAAA' }, { wasmBinary: new Uint8Array(8) }, { colour: 1 }]) await say(`a client with ${valueText(one)}`, () => createClient(one)); // prettier-ignore
  end();
});

test('the solver in this thread, without files, and in other programs', async (t) => {
  const { say, note, end } = session(t, 'adapters');
  note('# the core');
  const core = await createCore();
  const model = core.load({ main: 'm.obj', files: new Map([['m.obj', bytesOf(toObj(small))]]) });
  await say('inspect', () => model.inspect());
  await say('cones', () => model.suggestCones({ conesFor: 'few' }));
  const map = model.parametrize({ grid: 'auto' });
  await say('map', () => mapText(map));
  await say('write', () => map.write({ format: 'obj' }).files.map(({ name, bytes }) => [name, bytes.length])); // prettier-ignore
  const seen = [];
  core.onProgress = ({ stage, round }) => void seen.push(`${stage} ${round}`);
  await say('another map', () => mapText(model.parametrize({ q: 6 })));
  note(`stages ${[...new Set(seen)].join(', ')}`);
  core.onProgress = () => false;
  await say('stopped', () => model.parametrize());
  core.onProgress = undefined;
  note('# lite');
  const lite = await createLite();
  const arrays = arraysOf(small);
  for (const one of [{}, { q: 6 }, { count: 8 }, { conesFor: 'few' }, { improve: 'area' }, { precision: 'single' }, { weld: false }, { cones: { q: 4, cones: [{ vertex: 0, k: 3 }] } }, { q: 4, cones: { q: 6, cones: [] } }, { cones: { q: 4, cones: [], handles: [] } }, { colour: 1 }, { improve: 4 }, { precision: 'x' }, { triangles: [0, 1, 2] }, { positions: [] }]) await say(`lite with ${valueText(one)}`, () => lite.parametrizeMesh({ ...arrays, ...one })); // prettier-ignore
  const flat = lite.parametrizeMesh(arrays);
  for (const one of [{}, { q: 2 }, { tolerance: 1e-3 }, { cones: { q: 4, cones: [{ vertex: 3, k: 3 }] } }, { uv: [0] }, { cornerToUv: [0] }, { tolerance: 0 }]) await say(`lite verifies with ${valueText(one)}`, () => lite.verifyMesh({ ...arrays, uv: flat.uv, cornerToUv: flat.cornerToUv, ...one })); // prettier-ignore
  lite.onProgress = () => false;
  await say('lite stopped', () => lite.parametrizeMesh(arrays));
  lite.onProgress = undefined;

  const client = await createClient();
  t.after(() => client.terminate());
  note('# three.js');
  const bent = (geometry) => { const { position } = geometry.attributes; for (let i = 0; i < position.count; i++) position.setX(i, position.getX(i) * 1.3 + 0.05 * position.getY(i)); return geometry; }; // prettier-ignore
  const geometryText = ({ geometry, seams, certificate }) => ({ attributes: Object.entries(geometry.attributes).map(([name, { array, itemSize, normalized }]) => [name, itemSize, normalized, array]), index: geometry.index?.array, groups: geometry.groups, morphs: Object.keys(geometry.morphAttributes), seams: seams.geometry.attributes.position.array, certified: certificate.certified }); // prettier-ignore
  const boxed = bent(new THREE.BoxGeometry(1, 2, 3, 2, 2, 2));
  const morphed = boxed.clone();
  morphed.morphAttributes.position = [boxed.attributes.position.clone()];
  const cases = { box: [boxed], 'no index': [boxed.toNonIndexed()], morphs: [morphed], uv2: [boxed, { attribute: 'uv2' }], few: [boxed, { conesFor: 'few' }], welded: [boxed, { weld: 1e-4 }], 'no positions': [new THREE.BufferGeometry()], 'no geometry': [{}], wrong: [boxed, { colour: 1 }], limited: [boxed, { limits: { triangles: 2 } }] }; // prettier-ignore
  for (const [name, [geometry, options]] of Object.entries(cases)) {
    await say(`three: ${name}`, async () => geometryText(await parametrizeGeometry(client, geometry, options))); // prettier-ignore
    await say(`three with lite: ${name}`, async () => geometryText(await parametrizeGeometry(lite, geometry, options))); // prettier-ignore
  }
  await say('three with lite, aborted', () => parametrizeGeometry(lite, boxed, {}, { signal: AbortSignal.abort(new Error('no')) })); // prettier-ignore
  note('# glTF-Transform');
  const io = new NodeIO();
  const documents = { two: toGlb([small, open]), textured: packGlb(toGltf([small], { uv: { 0: ([x, y]) => [x, y] } })), parts: toGlb([beside(small, small)]) }; // prettier-ignore
  for (const [name, bytes] of Object.entries(documents)) {
    for (const options of [
      {},
      { texcoord: 0 },
      { texcoord: 3, conesFor: 'few' },
      { weld: 1e-4, q: 2 },
      { colour: 1 },
      { limits: { triangles: 3 } },
    ]) {
      const meshes = [];
      await say(`transform ${name} with ${valueText(options)}`, async () => {
        const document = await io.readBinary(new Uint8Array(bytes));
        await document.transform(seamless({ client, onMesh: (mesh, { certificate }) => meshes.push([mesh.getName(), certificate.certified]), ...options })); // prettier-ignore
        return [meshes, ...document.getRoot().listMeshes().flatMap((mesh) => mesh.listPrimitives().map((one) => [one.listSemantics(), one.getIndices()?.getArray(), ...one.listAttributes().map((each) => each.getArray())]))]; // prettier-ignore
      });
    }
  }
  await say('transform nothing', () => new Document().transform(seamless({ client })));
  await say('transform without a client', () => new Document().transform(seamless({})));
  note('# gzip');
  const packed = gzipSync(Buffer.from('some text\n'.repeat(99)));
  for (const [name, bytes] of Object.entries({ whole: packed, twice: Buffer.concat([packed, packed]), cut: packed.subarray(0, -9), damaged: Buffer.from(packed.map((x, i) => (i === 30 ? x ^ 255 : x))), more: Buffer.concat([packed, Buffer.from('more')]), none: Buffer.from('none') })) await say(`gunzip ${name}`, async () => {
      const read = [];
      const left = await readMembers(new Uint8Array(bytes), { Gunzip, add: (chunk) => read.push(...chunk), pause: async () => undefined }); // prettier-ignore
      return [left, read];
    }); // prettier-ignore
  end();
});

test('every code has its sentence', (t) => {
  const { note, end } = session(t, 'phrases');
  for (const [code, template] of Object.entries({ ...corePhrases, ...packagePhrases })) {
    const names = [...template.matchAll(/[{[]!?([a-zA-Z]+)/g)].map(([, name]) => name);
    const where = [{ kind: 'vertex', id: 5 }, { kind: 'edge', id: 2, other: 7 }, { kind: 'loop', id: 1 }]; // prettier-ignore
    const few = Object.fromEntries(names.map((name, i) => [name, i % 2 ? 1 : 12345.678]));
    const many = Object.fromEntries(names.map((name, i) => [name, 0.000034567 * 10 ** i]));
    note(`${code}: ${phrase({ code, numbers: few, words: {}, where })}`);
    note(`  ${phrase({ code, numbers: { ...many, more: 1 }, words: {}, where: where.slice(1) })}`);
    if (names.length > 0)
      note(`  ${phrase({ code, numbers: {}, words: { [names[0] ?? '']: 'word' }, where: [] })}`);
  }
  note(phrase({ code: 'nobody', numbers: {}, words: {}, where: [] }));
  note(phrase({ code: 'x', numbers: { n: 3 }, words: {}, where: [] }, { x: '{n|mesh|meshes}[n: and more]' })); // prettier-ignore
  end();
});
