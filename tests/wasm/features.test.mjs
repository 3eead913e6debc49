// Lines along features from JavaScript: options, lists, and what is refused.

import assert from 'node:assert/strict';
import test from 'node:test';
import { cubeMesh, toObj } from '../support/meshes.mjs';
import { asFiles, bytesOf, createCore, HgpError, withClient } from './support.mjs';

const cube = bytesOf(toObj(cubeMesh(4)));

test('creases are straight lines, and listed as files of every format', () =>
  withClient(async (client) => {
    const model = await client.load(cube, { name: 'cube.obj' });
    const list = await model.listFeatures({ creases: 30 });
    assert.deepEqual([list.creaseEdges, list.rimEdges, list.chains], [48, 0, 12]);
    assert.deepEqual(list.notes, []);
    const { lines } = JSON.parse(list.text).features;
    const sharp = await model.listFeatures({ lines }, { name: 'cube.sharp' });
    assert.equal(sharp.text.split('\n')[0], '48');
    const maps = [];
    for (const features of [{ creases: 30 }, { lines }, { name: 'cube.sharp', text: sharp.text }]) {
      const map = await model.parametrize({ features });
      assert.deepEqual(map.certificate.features, { edges: 48, straightEdges: 48, chains: 12, straightChains: 12, corners: 0 }); // prettier-ignore
      maps.push(map);
    }
    const { uv } = maps[0];
    assert.ok(maps.every((map) => map.uv.every((x, i) => x === uv[i])));

    const { bytes } = await maps[0].write();
    const mapped = await client.load(bytes, { name: 'cube.obj' });
    const verified = await mapped.verify({ features: { creases: 30 } });
    assert.equal(verified.features.straightChains, 12);
    assert.equal(verified.certified, true);
  }));

test('cones of one’s own go with creases, and check says before whether a field has them', () =>
  withClient(async (client) => {
    const model = await client.load(cube, { name: 'cube.obj' });
    const features = { creases: 30 };
    const { cones: chosen } = await model.parametrize({ features });
    const own = { q: chosen.q, cones: chosen.cones };
    const isPossible = async (cones) => {
      const { valid, components } = await model.check({ ...cones, features });
      assert.equal(valid, components.every(({ error }) => !error)); // prettier-ignore
      return valid;
    };
    assert.equal(await isPossible(own), true);
    const map = await model.parametrize({ cones: own, features });
    assert.equal(map.certificate.certified, true);
    assert.deepEqual(map.cones.cones.map(({ vertex, k }) => [vertex, k]), own.cones.map(({ vertex, k }) => [vertex, k])); // prettier-ignore
    // Three creases meet at a corner, with a quarter turn at least between any two.
    const sharp = { ...own, cones: own.cones.map((cone, i) => ({ ...cone, k: [2, 4][i] ?? cone.k })) }; // prettier-ignore
    assert.equal(await isPossible(sharp), false);
    assert.equal((await model.check(sharp)).valid, true, 'without creases there is a map');
    await assert.rejects(model.parametrize({ cones: sharp, features }), { code: 'prescription' });
  }));

test('creases work for whole files, too', async () => {
  const core = await createCore();
  const options = { features: { creases: 30 } };
  const { meshes } = core.parametrizeFile(asFiles('cube.obj', cube), options);
  assert.equal(meshes[0].report.certificate.features.straightEdges, 48);
});

test('features that are none are refused', () =>
  withClient(async (client) => {
    const model = await client.load(cube, { name: 'cube.obj' });
    const refused = async (features, code, message) =>
      assert.rejects(model.parametrize({ features }), (error) => {
        assert.ok(error instanceof HgpError);
        assert.equal(error.code, code, error.message);
        assert.match(error.message, message);
        return true;
      });
    await refused({ edges: [] }, 'usage', /features is \{ rims, creases, marked, lines \}/);
    await refused({ creases: 200 }, 'malformed', /angle between 0 and 180/);
    await refused({ marked: ['colours'] }, 'malformed', /"lines", "smoothing"/);
    await refused({ marked: ['materials'] }, 'prescription', /marks no edges/);
    await refused({ lines: [{ vertices: [0, 60] }] }, 'prescription', /no edge/);
    await assert.rejects(model.listFeatures(7), /features are/);
  }));
