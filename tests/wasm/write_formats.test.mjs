// write() in other formats, and the grid as material: what the command line calls --also.

import assert from 'node:assert/strict';
import test from 'node:test';
import validator from 'gltf-validator';
import { cubeMesh, toGlb, toObj } from '../support/meshes.mjs';
import { torusMesh } from '../web/shapes.mjs';
import { bytesOf, HgpError, withClient } from './support.mjs';

const text = (bytes) => new TextDecoder().decode(bytes);

test('one map in every format; each mesh format is certified as stored', () =>
  withClient(async (client) => {
    await client.load(bytesOf(toObj(cubeMesh(3))), { name: 'my cube.obj' });
    const { uv, cornerToUv } = await client.parametrize();
    const made = {};
    for (const format of ['same', 'glb', 'gltf', 'obj', 'flat-obj', 'svg']) {
      made[format] = await client.write({ format });
      assert.equal(made[format].certified, true, format);
      assert.ok(made[format].bytes.length > 100);
    }
    assert.deepEqual(
      Object.values(made).map(({ name }) => name),
      ['obj', 'glb', 'gltf', 'obj', 'flat.obj', 'svg'].map((end) => `my cube.${end}`),
    );
    assert.deepEqual(made.gltf.files.map(({ name }) => name), ['my cube.gltf', 'my cube.bin']); // prettier-ignore
    for (const format of ['glb', 'obj']) {
      await client.load(made[format].bytes, { name: made[format].name });
      assert.equal((await client.verify({ q: 4 })).certified, true, format);
    }
    const { issues } = await validator.validateBytes(made.glb.bytes);
    assert.equal(issues.numErrors, 0);
    const flat = text(made['flat-obj'].bytes).match(/^v .*$/gm);
    assert.equal(flat.length, uv.length / 2);
    assert.equal(flat[cornerToUv[0]], `v ${uv[2 * cornerToUv[0]]} ${uv[2 * cornerToUv[0] + 1]} 0`);
    assert.match(text(made.svg.bytes), /^<svg /);
  }));

test('a grid as material, with a given or the default number of tiles', () =>
  withClient(async (client) => {
    await client.load(toGlb([cubeMesh(3)]), { name: 'cube.glb' });
    await client.parametrize();
    const { bytes } = await client.write({ gridMaterial: 5 });
    assert.match(text(bytes), /"scale":\[2\.5,2\.5\]/);
    assert.equal((await validator.validateBytes(bytes)).issues.numErrors, 0);
    const { files } = await client.write({ format: 'obj', gridMaterial: true });
    assert.deepEqual(files.map(({ name }) => name), ['cube.obj', 'cube.grid.mtl', 'cube.grid.png']); // prettier-ignore
    assert.doesNotMatch(text((await client.write({ gridMaterial: false })).bytes), /hgp grid/);
    const isUsage = (error) => error instanceof HgpError && error.code === 'usage';
    await assert.rejects(client.write({ gridMaterial: -1 }), isUsage);
    await assert.rejects(client.write({ format: 'stl' }), isUsage);
  }));

test('a result in single precision is written as OBJ for every q, also where rotations are inexact', () =>
  withClient(async (client) => {
    for (const q of [2, 3, 4, 5, 6, 8]) {
      await client.load(toGlb([cubeMesh(3)]), { name: 'cube.glb' });
      const { certificate } = await client.parametrize({ q });
      assert.equal(certificate.certified, true, `${q}`);
      const [obj, glb] = await Promise.all(
        ['obj', 'glb'].map((format) => client.write({ format })),
      );
      for (const { bytes, name, certified } of [obj, glb]) {
        assert.equal(certified, true, `${q} ${name}`);
        await client.load(bytes, { name });
        assert.equal((await client.verify({ q })).certified, true, `${q} ${name}`);
      }
    }
  }));

test('kept results are written again as they were, whatever was solved since', () =>
  withClient(async (client) => {
    await client.load(toGlb([cubeMesh(3)]), { name: 'cube.glb' });
    await client.keep('nothing yet');
    assert.equal(await client.recall('nothing yet'), false);
    const made = new Map();
    for (const q of [4, 2, 6]) {
      const { uv } = await client.parametrize({ q });
      await client.keep(`q${q}`);
      made.set(q, { uv, files: await Promise.all(['same', 'obj'].map((format) => client.write({ format })))}); // prettier-ignore
    }
    for (const q of [4, 6, 4, 2, 2]) {
      assert.equal(await client.recall(`q${q}`), true, `${q}`);
      const again = await Promise.all(['same', 'obj'].map((format) => client.write({ format })));
      assert.deepEqual(again, made.get(q).files);
      assert.equal((await client.measure()).stretch.length, 108);
    }
    await client.parametrize({ q: 3 }); // is not kept, and takes the oldest of three away
    assert.equal(await client.recall('q3'), false);
    const left = [];
    for (const q of [2, 4, 6]) if (await client.recall(`q${q}`)) left.push(q);
    assert.deepEqual(left, [2, 4]);
    // They are of this surface, in whatever file, and of no other.
    await client.load(toGlb([cubeMesh(4)]), { name: 'cube.glb' });
    assert.equal(await client.recall('q4'), false);
    await assert.rejects(client.write(), { code: 'usage' });
    await client.load(toGlb([cubeMesh(3)]), { name: 'cube.glb' });
    assert.equal(await client.recall('q2'), true);
    assert.deepEqual((await client.write({ format: 'same' })).bytes, made.get(2).files[0].bytes);
  }));

test('the maps of several meshes are written into one file without another solve', () =>
  withClient(async (client) => {
    const both = toGlb([cubeMesh(3), torusMesh(12, 8)]);
    const uvs = [];
    for (const surface of [0, 1]) {
      await client.load(both, { name: 'both.glb', surface });
      uvs.push((await client.parametrize({ q: 4 })).uv);
      await client.keep(`${surface}`);
    }
    let bytes = both;
    for (const surface of [0, 1]) {
      await client.load(bytes, { name: 'both.glb', surface });
      assert.equal(await client.recall(`${1 - surface}`), false);
      assert.equal(await client.recall(`${surface}`), true);
      ({ bytes } = await client.write());
    }
    for (const surface of [0, 1]) {
      await client.load(bytes, { name: 'both.glb', surface });
      assert.equal((await client.verify({ q: 4 })).certified, true);
      await client.load(both, { name: 'both.glb', surface });
      assert.deepEqual((await client.parametrize({ q: 4 })).uv, uvs[surface]);
    }
    // The same as when each is solved in its turn.
    const whole = await client.parametrizeFile(both, { name: 'both.glb', q: 4 });
    assert.deepEqual(whole.bytes, bytes);
  }));

test('a file that cannot be read leaves the model and its result as they were', () =>
  withClient(async (client) => {
    await client.load(toGlb([cubeMesh(3)]), { name: 'cube.glb' });
    await client.parametrize({ q: 4 });
    const { bytes } = await client.write();
    const garbage = new TextEncoder().encode('v 0 0 0\nf 1 2 3\n');
    await assert.rejects(client.load(garbage, { name: 'bad.obj' }), { code: 'malformed' });
    assert.deepEqual((await client.write()).bytes, bytes);
    assert.equal((await client.parametrize({ q: 4 })).certificate.certified, true);
  }));

test('measures and loops: a value for each triangle and seam edge, walks that are closed', () =>
  withClient(async (client) => {
    const mesh = torusMesh(12, 8);
    await client.load(bytesOf(toObj(mesh)), { name: 'torus.obj' });
    const { boundaries, handles } = await client.loops();
    assert.deepEqual([boundaries.length, handles.length], [0, 2]);
    await assert.rejects(client.measure(), { code: 'usage' });
    const { seams, certificate } = await client.parametrize();
    const measures = await client.measure();
    assert.equal(measures.stretch.length, mesh.triangles.length);
    assert.equal(measures.seamChains.length, seams.length);
    assert.equal(measures.flipped.length, 0);
    const mu = Math.max(...Array.from(measures.stretch, (s) => (s - 1) / (s + 1)));
    assert.ok(Math.abs(mu - certificate.components[0].distortion.maxMu) < 1e-6);
    assert.equal(measures.overlaps.pairs > 0, measures.overlaps.triangles.length > 0);
  }));
