// Compressed glTF in the package: decoded by draco3dgltf and meshoptimizer, which are loaded when the
// first file needs them, and never believed.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { featureFiles } from '../gltf/features.mjs';
import { bytesOf, createCore, hasShared, HgpError, shared, withClient } from './support.mjs';

const features = await featureFiles();
const compressed = features.filter(({ name }) => /draco|meshopt/i.test(name));
const setOf = (files) => {
  const map = new Map(Object.entries(files).map(([name, bytes]) => [name, new Uint8Array(bytes)]));
  return { main: [...map.keys()][0], files: map };
};

test('the generated files include Draco and meshopt', () => {
  for (const kind of [/draco/i, /meshopt/i]) {
    assert.ok(
      compressed.some(({ name }) => kind.test(name)),
      `${kind}`,
    );
  }
});

for (const { name, files } of compressed) {
  test(`${name} is read, mapped and written`, () =>
    withClient(async (client) => {
      const model = await client.load(setOf(files));
      const { info } = model;
      assert.ok(info.triangles > 0);
      if (!info.usable) return;
      const map = await model.parametrize();
      const written = await map.write({ allowUncertified: true });
      const again = new Map(written.files.map((file) => [file.name, file.bytes]));
      const reread = await client.load({ main: written.name, files: again });
      assert.equal(reread.info.triangles, info.triangles);
    }));
}

test('a core without decoders says what is missing; prepare() loads them', async () => {
  const core = await createCore();
  const files = setOf(compressed.find(({ name }) => /draco/i.test(name)).files);
  const load = () => core.load(files);
  const before = (() => {
    try {
      return load();
    } catch (error) {
      return error;
    }
  })();
  // A file may carry an uncompressed copy of everything; the generated ones do not.
  assert.ok(before instanceof HgpError);
  assert.equal(before.code, 'unsupported');
  assert.match(before.message, /no decoder/);
  await core.prepare(files);
  assert.ok(load().info.triangles > 0);
});

test('a glTF as text has its decoders too, also behind a byte order mark and blanks', async () => {
  for (const { files } of compressed) {
    const [glb] = setOf(files).files.values();
    const size = new DataView(glb.buffer, glb.byteOffset).getUint32(12, true);
    const json = JSON.parse(new TextDecoder().decode(glb.subarray(20, 20 + size)));
    json.buffers[0].uri = 'a.bin';
    const bin = glb.slice(28 + size);
    for (const start of ['', '\ufeff', ' \t\r\n', '\ufeff\n']) {
      const core = await createCore();
      const set = { main: 'a.gltf', files: new Map([['a.gltf', bytesOf(start + JSON.stringify(json))], ['a.bin', bin]]) }; // prettier-ignore
      await core.prepare(set);
      assert.ok(core.load(set).info.triangles > 0);
    }
  }
});

test('nothing is loaded for files that need no decoder', async () => {
  const [core, other] = [await createCore(), await createCore()];
  const asked = [];
  const { instantiate } = WebAssembly;
  WebAssembly.instantiate = (...args) => (asked.push(args), instantiate(...args));
  try {
    const plain = features.find(({ files }) => Object.keys(files)[0].endsWith('.glb')).files;
    for (const files of [setOf({ 'a.obj': bytesOf('v 0 0 0\n') }), setOf(plain)]) {
      await core.prepare(files);
    }
    assert.equal(asked.length, 0);
    // What was loaded once is there for every file and every core.
    const packed = setOf(compressed.find(({ name }) => /draco/i.test(name)).files);
    await core.prepare(packed);
    asked.length = 0;
    for (const one of [core, other]) await one.prepare(packed);
    assert.equal(asked.length, 0);
  } finally {
    WebAssembly.instantiate = instantiate;
  }
});

test('a wrong byte anywhere in a Draco or meshopt file is handled', async () => {
  const core = await createCore();
  for (const { name, files } of compressed) {
    const set = setOf(files);
    await core.prepare(set);
    const main = set.files.get(set.main);
    const begin = main.length - Math.min(main.length, 600);
    for (let at = begin; at < main.length; at += 7) {
      const changed = main.slice();
      changed[at] ^= 0x41;
      try {
        core.load({ main: set.main, files: new Map([...set.files, [set.main, changed]]) }).free();
      } catch (error) {
        assert.ok(error instanceof HgpError, `${name} byte ${at}: ${error.stack}`);
        assert.notEqual(error.code, 'internal', `${name} byte ${at}: ${error.message}`);
      }
    }
  }
});

test('real compressed files', { skip: hasShared ? false : `${shared} is not there` }, () =>
  withClient(async (client) => {
    for (const name of ['Box_Draco.glb', 'BoxMeshopt.glb']) {
      const model = await client.load(readFileSync(path.join(shared, 'gltf', name)), { name });
      assert.equal(model.info.triangles, 12, name);
      assert.equal((await model.parametrize()).certificate.certified, true, name);
    }
  }),
);
