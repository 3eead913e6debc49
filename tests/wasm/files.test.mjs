// Files of several meshes through the package: all of them at once, one that is bad, other formats, and which set
// the materials use.

import assert from 'node:assert/strict';
import test from 'node:test';
import { cubeMesh, toGlb, toGltf, toObj } from '../support/meshes.mjs';
import { HgpError, asFiles, bytesOf, createCore, withClient } from './support.mjs';

const point = { vertices: Array(3).fill([1, 1, 1]), triangles: [[0, 1, 2]] };
const glb = (...meshes) => new Uint8Array(toGlb(meshes));
const jsonOf = (bytes) => {
  const size = new DataView(bytes.buffer, bytes.byteOffset).getUint32(12, true);
  return JSON.parse(new TextDecoder().decode(bytes.subarray(20, 20 + size)));
};
const verdicts = (result) => result.meshes.map(({ mesh, certified }) => [mesh, certified]);

/** Whether every one of these meshes has a certified map in the file. */
async function areCertified(client, files, main, meshes) {
  for (const surface of meshes) {
    const source = { main, files: new Map(files.map((f) => [f.name, f.bytes])) };
    const model = await client.load(source, { surface });
    assert.equal((await model.verify()).certified, true, `mesh ${surface}`);
  }
}

test('every mesh of a file is mapped and written, with progress that says which', () =>
  withClient(async (client) => {
    const seen = new Set();
    const onProgress = ({ mesh, meshes }) => seen.add(`${mesh} of ${meshes}`);
    const source = glb(cubeMesh(3), cubeMesh(6), cubeMesh(2));
    const result = await client.parametrizeFile(source, { name: 'three.glb' }, { onProgress });
    assert.equal(result.certified, true);
    assert.deepEqual(
      verdicts(result),
      [0, 1, 2].map((m) => [m, true]),
    );
    assert.ok(
      [...seen].every((text) => /^[012] of 3$/.test(text)) && seen.size > 0,
      `${[...seen]}`,
    );
    assert.equal(result.name, 'three.glb');
    for (const { report } of result.meshes) assert.equal(report.format, 'hgp-report');
    await areCertified(client, result.files, result.name, [0, 1, 2]);
  }));

test('one mesh that fails: nothing is written, and with keepGoing all the others', () =>
  withClient(async (client) => {
    const source = glb(cubeMesh(3), point, cubeMesh(2));
    const strict = await client.parametrizeFile(source, { name: 'bad.glb' });
    assert.equal(strict.certified, false);
    assert.deepEqual([strict.files, strict.bytes], [[], undefined]);
    assert.equal(strict.meshes[1].error.code, 'unsupported');
    assert.match(strict.meshes[1].error.message, /nothing is left to parametrize/);
    const kept = await client.parametrizeFile(source, { name: 'bad.glb', keepGoing: true });
    assert.equal(kept.certified, false);
    assert.deepEqual(verdicts(kept), [
      [0, true],
      [1, false],
      [2, true],
    ]);
    await areCertified(client, kept.files, kept.name, [0, 2]);
    const { meshes } = jsonOf(kept.bytes);
    assert.deepEqual(
      meshes.map(({ primitives: [p] }) => 'TEXCOORD_0' in p.attributes),
      [true, false, true],
    );
  }));

test('keepGoing in one mesh: the component without a map is cut to a disk, the others are certified', () =>
  withClient(async (client) => {
    // Onto a convex polygon: a closed surface cannot be, the disk beside it can.
    const octahedron = [[1, 2, 3], [1, 3, 4], [1, 4, 5], [1, 5, 2], [6, 3, 2], [6, 4, 3], [6, 5, 4], [6, 2, 5]]; // prettier-ignore
    const points = ['0 0 1', '1 0 0', '0 1 0', '-1 0 0', '0 -1 0', '0 0 -1', '9 0 0', '10 0 0', '9 1 0']; // prettier-ignore
    const faces = [...octahedron, [7, 8, 9]];
    const text = `${points.map((p) => `v ${p}\n`).join('')}${faces.map((f) => `f ${f.join(' ')}\n`).join('')}`;
    const model = await client.load(bytesOf(text), { name: 'pair.obj' });
    await assert.rejects(model.parametrize({ boundary: 'convex' }), HgpError);
    const map = await model.parametrize({ boundary: 'convex', keepGoing: true });
    const { certificate } = map;
    assert.equal(certificate.certified, false);
    assert.deepEqual(
      certificate.components.map(({ reasons }) => reasons.length === 0),
      [false, true],
    );
    await assert.rejects(map.write(), { code: 'no-map' });
    const { bytes } = await map.write({ allowUncertified: true });
    assert.equal(new TextDecoder().decode(bytes).match(/^f /gm).length, 9);
  }));

test('target: an OBJ becomes a GLB or a .gltf, a file of two meshes an OBJ of both', () =>
  withClient(async (client) => {
    const obj = bytesOf(toObj(cubeMesh(3)));
    const mapOf = async (source, options) => (await client.load(source, options)).parametrize();
    const inGlb = await mapOf(obj, { name: 'cube.obj', target: 'glb' });
    assert.equal(inGlb.certificate.certified, true);
    const asGlb = await inGlb.write({ name: 'cube.glb' });
    await areCertified(client, asGlb.files, 'cube.glb', [0]);

    const inGltf = await mapOf(obj, { name: 'cube.obj', target: 'gltf' });
    const apart = await inGltf.write({ name: 'cube.gltf' });
    assert.deepEqual(
      apart.files.map(({ name }) => name),
      ['cube.gltf', 'cube.bin'],
    );
    await areCertified(client, apart.files, 'cube.gltf', [0]);

    const pair = glb(cubeMesh(2), cubeMesh(3));
    const inObj = await mapOf(pair, { name: 'pair.glb', target: 'obj' });
    const { certificate } = inObj;
    assert.deepEqual([certificate.certified, certificate.components.length], [true, 2]);
    const asObj = await inObj.write({ name: 'pair.obj' });
    assert.equal(new TextDecoder().decode(asObj.bytes).match(/^o /gm).length, 2);
    // A GLB of several meshes as a .gltf, all of them mapped.
    const whole = await client.parametrizeFile(pair, {
      name: 'pair.glb',
      write: { name: 'pair.gltf' },
    });
    assert.equal(whole.name, 'pair.gltf');
    await areCertified(client, whole.files, 'pair.gltf', [0, 1]);
  }));

test('without a name, the result has that of the file, with the extension of what it is', () =>
  withClient(async (client) => {
    const obj = bytesOf(toObj(cubeMesh(2)));
    const inGlb = glb(cubeMesh(2));
    const { json, bin } = toGltf([cubeMesh(2)]);
    const gltf = { 'a.gltf': bytesOf(JSON.stringify(json)), 'cube.bin': new Uint8Array(bin) };
    const triangle = '3 0 0\n1 0 0\n0 1 0\n';
    const off = bytesOf(`OFF\n3 1 0\n${triangle}3 0 1 2\n`);
    for (const [source, options, name] of [
      [obj, { name: 'a.obj', target: 'glb' }, 'a.glb'],
      [obj, { name: 'a.obj', target: 'gltf' }, 'a.gltf'],
      [obj, { name: 'v1.2.OBJ' }, 'v1.2.OBJ'],
      [obj, { name: 'v1.2' }, 'v1.2.obj'],
      [obj, { name: '.obj' }, 'mesh.obj'],
      [inGlb, { name: 'in/named.obj' }, 'named.glb'],
      [inGlb, { name: 'a.vrm' }, 'a.glb'],
      [inGlb, { name: 'a.glb', target: 'obj' }, 'a.obj'],
      [inGlb, { name: 'a.glb', target: 'gltf' }, 'a.gltf'],
      [{ main: 'a.gltf', files: gltf }, {}, 'a.gltf'],
      [{ main: 'a.gltf', files: gltf }, { target: 'glb' }, 'a.glb'],
      [off, { name: 'a.off' }, 'a.obj'],
    ]) {
      const map = await (await client.load(source, options)).parametrize();
      const made = await map.write();
      assert.equal(made.name, name);
      assert.equal(made.certified, true);
      const whole = await client.parametrizeFile(source, options);
      assert.equal(whole.name, name);
    }
    const toPly = client.load(obj, { name: 'a.obj', target: 'ply' });
    await assert.rejects(toPly, { code: 'usage', message: /'ply'/ });
  }));

test('use: the materials of every mesh use the set that was written', () =>
  withClient(async (client) => {
    const { json, bin } = toGltf([cubeMesh(3), cubeMesh(2)], { image: 'pixel.png' });
    const files = {
      'look.gltf': bytesOf(JSON.stringify(json)),
      'cube.bin': new Uint8Array(bin),
      'pixel.png': new Uint8Array(8),
    };
    const setsOf = ({ files: [{ bytes }] }) => {
      const { materials, meshes } = JSON.parse(new TextDecoder().decode(bytes));
      return meshes.map(
        ({ primitives: [p] }) =>
          materials[p.material].pbrMetallicRoughness.baseColorTexture.texCoord ?? 0,
      );
    };
    const first = await client.parametrizeFile({ main: 'look.gltf', files });
    assert.equal(first.certified, true);
    const made = { ...files, ...Object.fromEntries(first.files.map((f) => [f.name, f.bytes])) };
    // As another program writes it: sets that are marked as hgp's own would be replaced.
    const unmarked = new TextDecoder()
      .decode(made['look.gltf'])
      .replaceAll('"extras":{"hgp":"uv"}', '"extras":{}');
    made['look.gltf'] = bytesOf(unmarked);
    const kept = await client.parametrizeFile({ main: 'look.gltf', files: made });
    assert.deepEqual(setsOf(kept), [0, 0]);
    const unused = kept.notes.filter(({ code }) => code === 'write-set-unused');
    assert.ok(unused.some(({ mesh, numbers }) => mesh === 1 && numbers.set === 1));
    const used = await client.parametrizeFile(
      { main: 'look.gltf', files: made },
      { write: { use: true } },
    );
    assert.deepEqual(setsOf(used), [1, 1]);
    // One of the two: the other one's material stays as it was.
    const model = await client.load({ main: 'look.gltf', files: made }, { surface: 1 });
    const map = await model.parametrize();
    assert.deepEqual(setsOf(await map.write({ use: true })), [0, 1]);
  }));

test('a file of several meshes is cancelled as a whole, and wrong options are usage errors', async () => {
  const core = await createCore();
  const source = asFiles('three.glb', glb(cubeMesh(3), cubeMesh(4)));
  core.onProgress = ({ mesh }) => mesh === 0;
  assert.throws(() => core.parametrizeFile(source), { code: 'cancelled' });
  core.onProgress = undefined;
  for (const options of [
    { cones: { q: 4, cones: [] } },
    { surface: 0 },
    { write: { useit: true } },
  ])
    assert.throws(() => core.parametrizeFile(source, options), { code: 'usage' });
  assert.throws(() => core.parametrizeFile(asFiles('x.glb', bytesOf('glTF'))), {
    code: 'malformed',
  });
  assert.equal(core.parametrizeFile(source).certified, true);
});
