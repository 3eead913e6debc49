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
    const model = await client.load(bytesOf(toObj(cubeMesh(3))), { name: 'my cube.obj' });
    const map = await model.parametrize();
    const { uv, cornerToUv } = map;
    const made = {};
    for (const format of ['same', 'glb', 'gltf', 'obj', 'flat-obj', 'svg']) {
      made[format] = await map.write({ format });
      assert.equal(made[format].certified, true, format);
      assert.ok(made[format].bytes.length > 100);
    }
    assert.deepEqual(
      Object.values(made).map(({ name }) => name),
      ['obj', 'glb', 'gltf', 'obj', 'flat.obj', 'svg'].map((end) => `my cube.${end}`),
    );
    assert.deepEqual(made.gltf.files.map(({ name }) => name), ['my cube.gltf', 'my cube.bin']); // prettier-ignore
    for (const format of ['glb', 'obj']) {
      const again = await client.load(made[format].bytes, { name: made[format].name });
      assert.equal((await again.verify({ q: 4 })).certified, true, format);
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
    const model = await client.load(toGlb([cubeMesh(3)]), { name: 'cube.glb' });
    const map = await model.parametrize();
    const { bytes } = await map.write({ gridMaterial: 5 });
    assert.match(text(bytes), /"scale":\[2\.5,2\.5\]/);
    assert.equal((await validator.validateBytes(bytes)).issues.numErrors, 0);
    const { files } = await map.write({ format: 'obj', gridMaterial: true });
    assert.deepEqual(files.map(({ name }) => name), ['cube.obj', 'cube.grid.mtl', 'cube.grid.png']); // prettier-ignore
    assert.doesNotMatch(text((await map.write({ gridMaterial: false })).bytes), /hgp grid/);
    const isUsage = (error) => error instanceof HgpError && error.code === 'usage';
    await assert.rejects(map.write({ gridMaterial: -1 }), isUsage);
    await assert.rejects(map.write({ format: 'stl' }), isUsage);
  }));

test('a result in single precision is written as OBJ for every q, also where rotations are inexact', () =>
  withClient(async (client) => {
    for (const q of [2, 3, 4, 5, 6, 8]) {
      const model = await client.load(toGlb([cubeMesh(3)]), { name: 'cube.glb' });
      const map = await model.parametrize({ q });
      assert.equal(map.certificate.certified, true, `${q}`);
      const [obj, glb] = await Promise.all(['obj', 'glb'].map((format) => map.write({ format })));
      for (const { bytes, name, certified } of [obj, glb]) {
        assert.equal(certified, true, `${q} ${name}`);
        const again = await client.load(bytes, { name });
        assert.equal((await again.verify({ q })).certified, true, `${q} ${name}`);
      }
    }
  }));

test('every map is written again as it was, whatever was solved since', () =>
  withClient(async (client) => {
    const model = await client.load(toGlb([cubeMesh(3)]), { name: 'cube.glb' });
    const made = [];
    const filesOf = (map) => Promise.all(['same', 'obj'].map((format) => map.write({ format })));
    for (const q of [4, 2, 6]) {
      const map = await model.parametrize({ q });
      made.push({ map, files: await filesOf(map) });
    }
    const other = await client.load(toGlb([cubeMesh(4)]), { name: 'cube.glb' });
    await other.parametrize();
    for (const i of [0, 2, 0, 1, 1]) {
      const { map, files } = made[i];
      assert.deepEqual(await filesOf(map), files);
      assert.equal((await map.measure()).stretch.length, 108);
    }
    await made[1].map.dispose();
    await assert.rejects(made[1].map.write(), { code: 'usage', message: /disposed of/ });
    assert.deepEqual(await filesOf(made[2].map), made[2].files);
    await model.dispose();
    await assert.rejects(made[2].map.write(), { code: 'usage' });
    await assert.rejects(model.inspect(), { code: 'usage' });
    assert.equal((await other.inspect()).usable, true);
  }));

test('combine: the maps of several meshes go into one file without another solve', () =>
  withClient(async (client) => {
    const both = toGlb([cubeMesh(3), torusMesh(12, 8)]);
    const load = (surface, file = both) => client.load(file, { name: 'both.glb', surface });
    const models = [await load(0), await load(1)];
    const maps = [];
    for (const model of models) maps.push(await model.parametrize({ q: 4 }));
    const { bytes, certified, notes } = await client.combine(maps);
    assert.equal(certified, true);
    assert.ok(notes.every(({ mesh }) => mesh === 0 || mesh === 1));
    for (const surface of [0, 1]) {
      const again = await load(surface, bytes);
      assert.equal((await again.verify({ q: 4 })).certified, true);
    }
    // The same as when each is solved in its turn, and in any order.
    const whole = await client.parametrizeFile(both, { name: 'both.glb', q: 4 });
    assert.deepEqual(whole.bytes, bytes);
    const [one, other] = await Promise.all([
      client.combine([maps[1]]),
      client.combine([...maps].reverse(), [{ uvSet: 0 }, { name: 'other.glb' }]),
    ]);
    assert.equal(other.name, 'other.glb');
    const sets = async (file) => {
      const verdicts = [];
      for (const surface of [0, 1]) {
        const model = await load(surface, file);
        verdicts.push(await model.verify({ q: 4 }).then(({ certified: is }) => is, ({ code }) => code)); // prettier-ignore
      }
      return verdicts;
    };
    assert.deepEqual(await sets(one.bytes), ['unsupported', true]);
    assert.deepEqual(await sets(other.bytes), [true, true]);
    // Wrong uses are told.
    const third = await client.load(toGlb([cubeMesh(2)]), { name: 'third.glb' });
    const stranger = await third.parametrize();
    const arrays = await client.loadMesh({ positions: [0, 0, 0, 1, 0, 0, 0, 1, 0] });
    for (const [wrong, message] of [
      [[], /no maps/],
      [[maps[0], stranger], /different files/],
      [[maps[0], maps[0]], /two maps are of mesh 0/],
      [[models[0]], /takes a list of maps/],
      [maps[0], /takes a list of maps/],
      [[await arrays.parametrize()], /not of arrays/],
    ])
      await assert.rejects(client.combine(wrong), { code: 'usage', message });
  }));

test('a file that cannot be read leaves other models and maps as they were', () =>
  withClient(async (client) => {
    const model = await client.load(toGlb([cubeMesh(3)]), { name: 'cube.glb' });
    const map = await model.parametrize({ q: 4 });
    const { bytes } = await map.write();
    const garbage = new TextEncoder().encode('v 0 0 0\nf 1 2 3\n');
    await assert.rejects(client.load(garbage, { name: 'bad.obj' }), { code: 'malformed' });
    assert.deepEqual((await map.write()).bytes, bytes);
    assert.equal((await model.parametrize({ q: 4 })).certificate.certified, true);
  }));

test('measures and loops: a value for each triangle and seam edge, walks that are closed', () =>
  withClient(async (client) => {
    const mesh = torusMesh(12, 8);
    const model = await client.load(bytesOf(toObj(mesh)), { name: 'torus.obj' });
    const { boundaries, handles } = await model.loops();
    assert.deepEqual([boundaries.length, handles.length], [0, 2]);
    const map = await model.parametrize();
    const { seams, certificate } = map;
    const measures = await map.measure();
    assert.equal(measures.stretch.length, mesh.triangles.length);
    assert.equal(measures.seamChains.length, seams.length);
    assert.equal(measures.flipped.length, 0);
    const mu = Math.max(...Array.from(measures.stretch, (s) => (s - 1) / (s + 1)));
    assert.ok(Math.abs(mu - certificate.components[0].distortion.maxMu) < 1e-6);
    assert.equal(measures.overlaps.pairs > 0, measures.overlaps.triangles.length > 0);
  }));
