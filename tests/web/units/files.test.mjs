import assert from 'node:assert/strict';
import test from 'node:test';
import {
  embeddedCones,
  findMissing,
  readGltfJson,
  relativeName,
  safeName,
  unpack,
} from '../../../web/src/state/files.ts';

const bytes = (text) => new TextEncoder().encode(text);
const gltf = (json) => bytes(JSON.stringify(json));

test('a name is relative, inside the folder and decoded once, or it is refused', () => {
  assert.equal(relativeName('./a%20b/c.bin'), 'a b/c.bin');
  assert.equal(relativeName('%2525.bin'), '%25.bin');
  const refused = [
    '../a',
    'a/../../b',
    '/a',
    '\\a',
    'a\\b',
    'http://x/a',
    'file:a',
    'C:a',
    '%2e%2e/a',
    '%00',
    '%',
  ];
  for (const uri of refused) assert.equal(relativeName(uri), undefined, uri);
});

test('a download has a harmless name', () => {
  assert.equal(safeName('a/b c.glb'), 'b_c.glb');
  assert.equal(safeName('..'), 'model');
  assert.equal(safeName(`${'x'.repeat(100)}.obj`).length, 80);
});

test('files that are named and missing are found, by name where folders were lost', async () => {
  const json = {
    buffers: [{ uri: 'geo/a.bin' }, { uri: 'b.bin' }, { uri: 'data:,' }, {}],
    images: [{ uri: 'c.png' }, { uri: '../d.png' }],
  };
  const files = new Map([
    ['m/x.gltf', gltf(json)],
    ['elsewhere/a.bin', bytes('a')],
  ]);
  const { missing, refused } = await findMissing(files, 'm/x.gltf');
  assert.deepEqual(missing, [
    { name: 'b.bin', isNeeded: true },
    { name: 'c.png', isNeeded: false },
  ]);
  assert.deepEqual(refused, ['../d.png']);
  assert.deepEqual(files.get('geo/a.bin'), bytes('a'));
});

test('what is no glTF at all has no JSON: the solver says why', async () => {
  for (const [name, text] of [
    ['x.glb', ''],
    ['x.glb', 'glTF and then nothing of use to anybody'],
    ['x.gltf', '{'],
    ['x.gltf', ''],
  ]) {
    assert.deepEqual(await readGltfJson(name, bytes(text)), {}, text);
  }
});

test('the folder that everything is in is taken away, and what systems leave behind', async () => {
  const names = ['top/a.obj', 'top/b/c.mtl', '__MACOSX/top/._a.obj', 'top/.DS_Store'];
  const found = await unpack(new Map(names.map((name) => [name, bytes('')])));
  assert.deepEqual([...found.keys()], ['a.obj', 'b/c.mtl']);
});

test('cones in a file are found where an earlier run left them', async () => {
  const cones = { q: 4, cones: [] };
  const glb = gltf({ meshes: [{}, { extras: { hgp: cones } }] });
  const files = new Map([
    ['a.gltf', glb],
    ['b.obj', bytes('v 0 0 0\n# hgp-cones {}\n')],
    ['c.obj', bytes('v 0 0 0\n')],
  ]);
  assert.deepEqual(JSON.parse(await embeddedCones(files, 'a.gltf', 1)), cones);
  assert.equal(await embeddedCones(files, 'a.gltf', 0), undefined);
  assert.match(await embeddedCones(files, 'b.obj', 0), /hgp-cones/);
  assert.equal(await embeddedCones(files, 'c.obj', 0), undefined);
});
