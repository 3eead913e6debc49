// What is decided for the user (which cones are missing, where they go in another version of a mesh, how many cells a grid
// has, what becomes of the meshes of a file) is decided in the core: the package gives the bytes of the command line.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { Matrix4, Quaternion, Vector3 } from 'three';
import { blocks, eight, ring } from '../support/blocks.mjs';
import { bumpyDisk } from '../support/disk.mjs';
import { cubeMesh, toGlb, toGltf, toObj } from '../support/meshes.mjs';
import { asFiles, bytesOf, createCore, native, scratch, withClient } from './support.mjs';

const folder = scratch('policies');
const core = await createCore();
const hasNative = existsSync(native);
if (!hasNative) console.log(`SKIPPING comparison with the native program: ${native} is not there`);
const skip = hasNative ? false : 'no native program';

const toBytes = (content) => (typeof content === 'string' ? bytesOf(content) : new Uint8Array(content)); // prettier-ignore
function put(name, content) {
  writeFileSync(path.join(folder, name), content);
  return toBytes(content);
}
const conesOf = (list, q = 4) => ({
  format: 'hgp-cones',
  version: 1,
  q,
  cones: list.map(([vertex, k]) => ({ vertex, k })),
});
function run(...args) {
  const { status, stdout, stderr } = spawnSync(native, args, { cwd: folder, encoding: 'utf8' });
  assert.equal(status, 0, stderr);
  return { stdout, stderr };
}
const load = (name, bytes, options) => core.load(asFiles(name, bytes), options);
/** Cones with their positions as they were read back from text. */
const plain = (cones) => JSON.parse(JSON.stringify(cones));

const shapes = [
  ['sphere', toObj(cubeMesh(5)), [[3, 3], [40, 5]], 4], // prettier-ignore
  ['sphere, q = 6', toObj(cubeMesh(5)), [[7, 4]], 6],
  ['genus 2', toObj(blocks(eight, { n: 3 })), [[11, 5]], 4],
  ['disk', bumpyDisk(10), [[30, 3]], 4],
];

for (const [what, text, list, q] of shapes) {
  test(
    `balance: ${what}: as the command line, exactly Gauss–Bonnet, given cones kept`,
    { skip },
    () => {
      const name = `${what.replace(/\W+/g, '-')}.obj`;
      const model = load(name, put(name, text));
      const given = conesOf(list, q);
      put('given.json', JSON.stringify(given));
      const made = model.balanceCones(given);
      const { stdout } = run('cones', name, '--balance', 'given.json');
      assert.deepEqual(plain(made), JSON.parse(stdout));
      for (const { vertex, k } of given.cones)
        assert.ok(made.cones.some((one) => one.vertex === vertex && one.k === k));
      const report = model.check(made);
      assert.equal(report.valid, true);
      for (const { budget } of report.components)
        assert.ok(budget.left === 0 || budget.openLoops > 0);
      model.free();
    },
  );
}

test(
  'transfer: as the command line, to a version with other numbers and a vertex that moved',
  { skip },
  () => {
    const mesh = cubeMesh(4);
    const last = mesh.vertices.length - 1;
    const vertices = mesh.vertices.map((_, v) => [...mesh.vertices[last - v]]);
    vertices[last - 9][0] += 1e-9;
    const triangles = mesh.triangles.map((t) => t.map((v) => last - v));
    const old = load('old.obj', put('old.obj', toObj(mesh)));
    const now = load('new.obj', put('new.obj', toObj({ vertices, triangles })));
    const asked = conesOf([[5, 3], [9, 3], [20, 3]]); // prettier-ignore
    put('old.json', JSON.stringify(asked));
    const { cones, lost } = now.transferCones(asked, old);
    assert.deepEqual(cones.cones.map(({ vertex, k }) => [vertex, k]), [[last - 5, 3], [last - 20, 3]]); // prettier-ignore
    assert.deepEqual(lost.map(({ code, numbers }) => [code, numbers.vertex]), [['moved-cone-gone', 9]]); // prettier-ignore
    const { stdout, stderr } = run(
      'cones',
      'new.obj',
      '--transfer',
      'old.json',
      '--from',
      'old.obj',
    );
    assert.deepEqual(plain(cones), JSON.parse(stdout));
    assert.match(stderr, /note: .*vertex 9/);
    old.free();
    now.free();
  },
);

test('models and maps of another client or core are not taken for those of this one', () =>
  withClient((one) =>
    withClient(async (other) => {
      const load = (client, n) => client.load(bytesOf(toObj(cubeMesh(n))), { name: 'a.obj' });
      const [mine, foreign] = await Promise.all([load(one, 2), load(other, 3)]);
      const theirs = await foreign.parametrize();
      const wrong = { code: 'usage', message: /another client/ };
      await assert.rejects(one.combine([theirs]), wrong); // when no handle has its number
      const own = await mine.parametrize();
      await assert.rejects(one.combine([theirs]), wrong); // when one has
      await assert.rejects(one.combine([own, theirs]), wrong);
      assert.equal((await one.combine([own])).certified, true);
      await assert.rejects(mine.transferCones(conesOf([]), foreign), { code: 'usage' });
      const elsewhere = await createCore();
      const [here, there] = [core, elsewhere].map((of) =>
        of.load(asFiles('a.obj', bytesOf(toObj(cubeMesh(2))))),
      );
      assert.throws(() => here.transferCones(conesOf([]), there), { code: 'usage' });
    }),
  ));

test('transfer of a client: both models are made again after the worker was ended', () =>
  withClient(async (client) => {
    const [old, now] = [
      await client.load(bytesOf(toObj(cubeMesh(3))), { name: 'a.obj' }),
      await client.load(bytesOf(toObj(cubeMesh(3))), { name: 'b.obj' }),
    ];
    const controller = new AbortController();
    const running = old.parametrize({}, { signal: controller.signal });
    await old.inspect({}).catch(() => undefined);
    void running.catch(() => undefined);
    const next = now.parametrize({}, { signal: controller.signal, onProgress: () => controller.abort() }); // prettier-ignore
    await assert.rejects(next, { name: 'AbortError' });
    const { cones, lost } = await now.transferCones(conesOf([[4, 3]]), old);
    assert.deepEqual([cones.cones[0].vertex, lost], [4, []]);
    await assert.rejects(now.transferCones(conesOf([]), {}), /of another model of this client/);
    await old.dispose();
    await assert.rejects(now.transferCones(conesOf([[4, 3]]), old), /disposed/);
  }));

for (const conesFor of ['few', 'fewer', 'balanced', 'more', 'low-distortion']) {
  test(`cones for ${conesFor}: as the command line`, { skip }, () => {
    const text = toObj(blocks(ring, { n: 3 }));
    const model = load('ring.obj', put('ring.obj', text));
    const { stdout } = run('cones', 'ring.obj', '--cones-for', conesFor);
    assert.deepEqual(plain(model.suggestCones({ conesFor })), JSON.parse(stdout));
    model.free();
  });
}

for (const [name, content] of [
  ['auto.obj', toObj(cubeMesh(8))],
  ['auto.glb', toGlb([blocks(ring, { n: 3 })])],
]) {
  test(`a grid without a number of cells: ${name}: the bytes of --cells auto`, { skip }, () => {
    const model = load(name, put(name, content));
    const map = model.parametrize({ grid: 'auto' });
    const same = model.parametrize({ grid: { cells: 'auto', mode: 'tile' } });
    const out = `out-${name}`;
    run('param', name, '-o', out, '--cells', 'auto', '--reproducible', '--force');
    const { bytes } = map.write();
    assert.ok(Buffer.from(bytes).equals(readFileSync(path.join(folder, out))));
    assert.ok(Buffer.from(same.write().bytes).equals(Buffer.from(bytes)));
    assert.ok(map.report.options.grid.cells >= 800);
    assert.ok(map.report.components.every(({ grid }) => grid.aligned));
    model.free();
  });
}

const three = () => new Uint8Array(toGlb([cubeMesh(3), blocks(ring, { n: 2 }), cubeMesh(5)]));
const cases = [
  ['plain', {}, []],
  ['with a grid', { grid: { cells: 900 } }, ['--cells', '900']],
  ['with settings of the writer', { write: { embedCones: true, gridMaterial: true, uvSet: 1 } }, ['--embed-cones', '--grid-material', '--uv-set', '1']], // prettier-ignore
];
for (const [what, options, words] of cases) {
  test(
    `all meshes of a file, ${what}: the bytes of the command line, of the package, and of combine`,
    { skip },
    () => {
      const source = asFiles('three.glb', put('three.glb', three()));
      const whole = core.parametrizeFile(source, options);
      run('param', 'three.glb', '-o', 'all.glb', '--reproducible', '--force', ...words);
      const expected = readFileSync(path.join(folder, 'all.glb'));
      assert.ok(Buffer.from(whole.bytes).equals(expected));
      assert.equal(whole.certified, true);
      const { write = {}, ...solve } = options;
      const spacing = whole.meshes[0].report.options.grid?.spacing;
      const shared = solve.grid ? { grid: { spacing } } : {};
      const models = [0, 1, 2].map((surface) => core.load(source, { surface }));
      const maps = models.map((model) => model.parametrize({ ...solve, ...shared }));
      const made = core.combine(maps, write);
      assert.ok(Buffer.from(made.bytes).equals(expected));
      models.forEach((model) => model.free());
    },
  );
}

test('combine: each map with its own settings, as written by itself', () => {
  const source = asFiles('three.glb', three());
  const models = [0, 1, 2].map((surface) => core.load(source, { surface }));
  const maps = models.map((model) => model.parametrize());
  const options = [{ uvSet: 2 }, { embedCones: true }, { uvSet: 1, gridMaterial: 5 }];
  const made = core.combine(maps, options);
  const json = jsonOf(made.bytes);
  const sets = json.meshes.map(({ primitives: [{ attributes }] }) => Object.keys(attributes).filter((key) => key.startsWith('TEXCOORD')).sort()); // prettier-ignore
  assert.deepEqual(sets, [
    ['TEXCOORD_0', 'TEXCOORD_1', 'TEXCOORD_2'],
    ['TEXCOORD_0'],
    ['TEXCOORD_0', 'TEXCOORD_1'],
  ]);
  assert.deepEqual(json.meshes.map(({ extras }) => extras !== undefined), [false, true, false]); // prettier-ignore
  assert.equal(json.materials.length, 1);
  for (const surface of [0, 1, 2]) {
    const written = core.load(asFiles('x.glb', made.bytes), { surface });
    assert.equal(written.verify().certified, true);
    written.free();
  }
  const [again] = [core.load(source, { surface: 1 })];
  const map = again.parametrize();
  assert.throws(() => core.combine([maps[1], map]), /two maps are of mesh 1/);
  const other = core.load(asFiles('o.glb', new Uint8Array(toGlb([cubeMesh(2), cubeMesh(3)]))), { surface: 0 }); // prettier-ignore
  assert.throws(() => core.combine([maps[1], other.parametrize()]), /different files/);
  [...models, again, other].forEach((model) => model.free());
});

function jsonOf(bytes) {
  const size = new DataView(bytes.buffer, bytes.byteOffset).getUint32(12, true);
  return JSON.parse(new TextDecoder().decode(bytes.subarray(20, 20 + size)));
}

/** Nodes in a random tree, each with a matrix or with parts of one, as three.js places them. */
function randomNodes(count, random) {
  const nodes = [];
  const worlds = [];
  const parents = [];
  for (let n = 0; n < count; n++) {
    const t = new Vector3(random(), random(), random());
    const r = new Quaternion(random(), random(), random(), random() + 1).normalize();
    const s = new Vector3(1 + random() / 2, (random() < 0 ? -1 : 1) * (1 + random() / 2), 1);
    const local = new Matrix4().compose(t, r, s);
    const parts = { translation: t.toArray(), rotation: r.toArray(), scale: s.toArray() };
    nodes.push(random() < 0 ? { matrix: local.toArray() } : parts);
    const parent = n === 0 || random() > 0.6 ? -1 : Math.floor(((random() + 1) / 2) * n);
    parents.push(parent);
    worlds.push(parent < 0 ? local : worlds[parent].clone().multiply(local));
    if (parent >= 0) (nodes[parent].children ??= []).push(n);
  }
  return { nodes, worlds };
}

test('the nodes of a glTF place its meshes as three.js does; which mirror them is known', () => {
  let state = 12345;
  const random = () => (state = (1103515245 * state + 12345) % 2 ** 31) / 2 ** 30 - 1;
  const { json, bin } = toGltf([cubeMesh(1), cubeMesh(2)], { buffer: 'side.bin' });
  const { nodes, worlds } = randomNodes(40, random);
  const of = [[], []];
  nodes.forEach((node, n) => {
    if (n % 3 === 2) return;
    node.mesh = n % 2;
    of[n % 2].push(worlds[n]);
  });
  const file = { ...json, nodes, scenes: [{ nodes: [0] }], scene: 0 };
  const files = new Map([['x.gltf', bytesOf(JSON.stringify(file))], ['side.bin', new Uint8Array(bin)]]); // prettier-ignore
  const model = core.load({ main: 'x.gltf', files });
  const found = model.placements();
  assert.equal(found.length, 2);
  found.forEach(({ count, isMirrored, matrices }, mesh) => {
    assert.equal(count, of[mesh].length);
    assert.equal(isMirrored, of[mesh].some((world) => world.determinant() < 0)); // prettier-ignore
    const theirs = of[mesh].flatMap((world) => world.toArray());
    assert.equal(matrices.length, theirs.length);
    theirs.forEach((x, i) => assert.ok(Math.abs(x - matrices[i]) < 1e-9));
    const { uses, mirrored } = model.info.surfaces[mesh];
    assert.deepEqual([uses, mirrored], [count, isMirrored]);
  });
  model.free();
});

test('a skinned mesh is where its joint is; copies count; flat nodes show nothing; lines are no meshes', () => {
  const { json, bin } = toGltf([cubeMesh(1), cubeMesh(2)], { buffer: 'side.bin' });
  const [first, second] = json.meshes;
  const lines = { primitives: [{ ...first.primitives[0], mode: 1 }] };
  const file = {
    ...json,
    meshes: [lines, first, second],
    skins: [{ joints: [3] }],
    extensionsUsed: ['EXT_mesh_gpu_instancing'],
    nodes: [
      { mesh: 1, translation: [1, 2, 3] },
      { children: [0], scale: [2, 2, -2] },
      { mesh: 2, skin: 0, translation: [9, 9, 9] },
      { translation: [0, 5, 0] },
      { mesh: 2, scale: [0, 0, 0] },
      { mesh: 0 },
      { mesh: 2, translation: [7, 0, 0], extensions: { EXT_mesh_gpu_instancing: { attributes: { TRANSLATION: 0 } } } }, // prettier-ignore
    ],
    scenes: [{ nodes: [1, 2, 3, 4, 5, 6] }],
    scene: 0,
  };
  const files = new Map([['x.gltf', bytesOf(JSON.stringify(file))], ['side.bin', new Uint8Array(bin)]]); // prettier-ignore
  const model = core.load({ main: 'x.gltf', files });
  const [a, b] = model.placements();
  assert.deepEqual([a.count, a.isMirrored, [...a.matrices.slice(12, 15)]], [1, true, [2, 4, -6]]);
  assert.equal(b.count, 2 + json.accessors[0].count);
  assert.equal(b.isMirrored, false);
  assert.deepEqual([...b.matrices].filter((_, i) => i % 16 === 12), [0, 7]); // prettier-ignore
  assert.deepEqual([...b.matrices.slice(12, 15)], [0, 5, 0]);
  model.free();
  assert.deepEqual(load('cube.obj', bytesOf(toObj(cubeMesh(1)))).placements(), []);
});
