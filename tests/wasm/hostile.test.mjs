// Broken and malicious files end in the package as they do on the command line, one after another in
// one core, which goes on.

import assert from 'node:assert/strict';
import test from 'node:test';
import { harmlessFiles, hostileFiles } from '../gltf/hostile_files.mjs';
import { bumpyDisk } from '../support/disk.mjs';
import { asFiles, bytesOf, createCore, HgpError } from './support.mjs';

const core = await createCore();
const limits = { bytes: 256 << 20, triangles: 2e5 };

async function load(name, bytes) {
  const files = asFiles(name, new Uint8Array(bytes));
  await core.prepare(files);
  core.load(files, { limits }).free();
}

// The largest are verified by the native suite, and here with scripts/test --full.
const most = process.env.HGP_FULL ? Infinity : 10e6;

for (const { name, bytes, code, message } of hostileFiles()) {
  if (bytes.length > most) continue;
  test(name, async () => {
    await assert.rejects(load(name, bytes), (error) => {
      assert.ok(error instanceof HgpError, error.stack);
      assert.equal(error.code, code, error.message);
      assert.match(error.message, message);
      return true;
    });
  });
}

test('odd but legal files are read', async () => {
  for (const { name, bytes } of harmlessFiles()) await load(name, bytes);
});

const words = (text) => bytesOf(text);
const texts = {
  'empty.obj': '',
  'page.html': '<!doctype html>',
  'index.obj': 'v 0 0 0\nf 1 2 3\n',
  'nan.obj': 'v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n',
  'huge.off': 'OFF\n99999999999 1 0\n',
  'huge.ply': 'ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nend_header\n',
  'list.ply':
    'ply\nformat binary_little_endian 1.0\nelement face 1\nproperty list uint int vertex_indices\nend_header\n\xff\xff\xff\xff',
  'cut.stl': 'solid x\nfacet normal 0 0 0\nouter loop\nvertex 0 0',
};
for (const [name, text] of Object.entries(texts)) {
  test(name, async () => {
    await assert.rejects(load(name, words(text)), (error) => {
      assert.ok(error instanceof HgpError, error.stack);
      assert.match(error.code, /^(malformed|limit|unsupported)$/, error.message);
      return true;
    });
  });
}

test('the core still works afterwards', () => {
  const model = core.load(asFiles('disk.obj', bytesOf(bumpyDisk(5))));
  assert.equal(model.parametrize({ boundary: 'convex' }).certificate.certified, true);
});

test('cones and options of the wrong kind are errors, not results', () => {
  const model = core.load(asFiles('disk.obj', bytesOf(bumpyDisk(5))));
  const cones = (list, q = 4) => ({ format: 'hgp-cones', version: 1, q, cones: list });
  for (const wrong of [
    cones([{ vertex: -1, k: 3 }]),
    cones([{ vertex: 1e9, k: 3 }]),
    cones([{ vertex: 0.5, k: 3 }]),
    cones([{ vertex: 0, k: 1e300 }]),
    cones([{ vertex: 0, k: 3 }], 0),
    cones([{ vertex: 0, k: 3 }], 65),
    { ...cones([]), version: 7 },
    [],
    {},
  ]) {
    assert.throws(
      () => model.parametrize({ cones: wrong }),
      (error) => {
        assert.ok(error instanceof HgpError, `${JSON.stringify(wrong)}: ${error.stack}`);
        assert.match(error.code, /^(prescription|malformed|usage)$/, JSON.stringify(wrong));
        return true;
      },
    );
  }
});

test('arrays that are not a mesh are errors', () => {
  const positions = new Float64Array(9);
  for (const triangles of [
    [0, 1, 3],
    [0, 1, -1],
    [0, 1, 2 ** 31],
  ]) {
    assert.throws(
      () => core.loadMesh({ positions, triangles: Int32Array.from(triangles) }),
      HgpError,
    );
  }
  const empty = { positions: new Float64Array(0), triangles: new Uint32Array(0) };
  assert.throws(() => core.loadMesh(empty), { code: 'usage' });
});
