// --also and --grid-material: the result in other formats, read again by glTF-Transform, Khronos' validator
// and the program's own verifier.
import { NodeIO } from '@gltf-transform/core';
import { KHRTextureTransform } from '@gltf-transform/extensions';
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import test from 'node:test';
import pngjs from 'pngjs';
import validator from 'gltf-validator';
import { cubeMesh, toGlb, toObj } from '../support/meshes.mjs';
import { inFolder } from '../support/program.mjs';

const { at, put, read, run, good } = inFolder('also');
put('cube.obj', toObj(cubeMesh(4)));
put('cube.glb', toGlb([cubeMesh(4)]));

const io = new NodeIO().registerExtensions([KHRTextureTransform]);
const numbers = (text, word) =>
  text
    .split('\n')
    .filter((line) => line.startsWith(`${word} `))
    .map((line) => line.split(' ').slice(1).map(Number));

async function assertValid(name) {
  const found = (uri) => Promise.resolve(new Uint8Array(readFileSync(at(uri))));
  const { issues } = await validator.validateBytes(new Uint8Array(readFileSync(at(name))), {
    externalResourceFunction: found,
  });
  assert.equal(issues.numErrors, 0, JSON.stringify(issues.messages));
}

test('one run writes every format, each certified as stored', async () => {
  const names = ['a.glb', 'b.gltf', 'c.obj', 'd.flat.obj', 'e.svg'];
  const { err } = good('param', 'cube.obj', '-o', 'm.obj', names.map((name) => ['--also', name]).flat()); // prettier-ignore
  for (const name of names) assert.match(err, new RegExp(`also wrote ${name}\n`));
  for (const name of ['m.obj', ...names.slice(0, 3)]) good('verify', name);
  for (const name of ['a.glb', 'b.gltf']) {
    await assertValid(name);
    const document = await io.read(at(name));
    const [primitive] = document.getRoot().listMeshes()[0].listPrimitives();
    assert.equal(primitive.getIndices().getCount(), 3 * cubeMesh(4).triangles.length);
    assert.ok(primitive.getAttribute('TEXCOORD_0'));
  }
  assert.ok(existsSync(at('b.bin')));
  // The very numbers of the map: as an OBJ, as a flat mesh, and rounded in a drawing.
  const uv = numbers(read('m.obj'), 'vt');
  assert.deepEqual(numbers(read('c.obj'), 'vt'), uv);
  assert.deepEqual(numbers(read('d.flat.obj'), 'v'), uv.map(([u, v]) => [u, v, 0])); // prettier-ignore
  const svg = read('e.svg');
  const [edges, seams] = [...svg.matchAll(/ d="([^"]*)"/g)].map(([, d]) => d.split('M').length - 1);
  const inside = (3 * cubeMesh(4).triangles.length - seams) / 2;
  assert.equal(edges, inside + seams);
});

test('a grid as material: in a GLB by itself, beside an OBJ in a library', async () => {
  good('param', 'cube.glb', '-o', 'g.glb', '--grid-material', '6', '--also', 'g.obj');
  await assertValid('g.glb');
  const [material] = (await io.read(at('g.glb'))).getRoot().listMaterials();
  const image = pngjs.PNG.sync.read(Buffer.from(material.getBaseColorTexture().getImage()));
  assert.equal(image.width, 64);
  const transform = material.getBaseColorTextureInfo().getExtension('KHR_texture_transform');
  assert.deepEqual(transform.getScale(), [3, 3]);
  assert.match(read('g.obj'), /^mtllib g\.grid\.mtl\nusemtl hgp_grid\n/);
  assert.match(read('g.grid.mtl'), /map_Kd -s 3 3 1 g\.grid\.png/);
  assert.equal(pngjs.PNG.sync.read(readFileSync(at('g.grid.png'))).width, 64);
  good('verify', 'g.glb');
  // Without a number: two tiles to a cell where there are cells.
  good('param', 'cube.obj', '-o', 'h.obj', '--grid-material', '--cells', '200');
  assert.match(read('h.grid.mtl'), /map_Kd -s 1 1 1 /);
});

test('impossible outputs are refused before anything is written', () => {
  const refused = (words, message) => {
    const { code, err } = run('param', 'cube.obj', words);
    assert.equal(code, 2, err);
    assert.match(err, message);
  };
  refused(['-o', 'x.obj', '--also', 'x.stl'], /--also.*must be x\.obj, x\.flat\.obj.*not 'x\.stl'/);
  refused(['-o', 'x.obj', '--also', 'x.obj'], /x\.obj is named for two outputs/);
  refused(['-o', 'x.obj', '--also', 'cube.obj', '--force'], /cube\.obj is read/);
  refused(['-o', 'x.ply', '--grid-material'], /--grid-material is for glTF and OBJ/);
  refused(['-o', 'x.obj', '--grid-material', '0'], /must be a number > 0, not '0'/);
  assert.equal(existsSync(at('x.obj')), false);
});

test('a map that separates vertices which a glTF joins is not written as glTF', () => {
  put('cut.obj', 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 4 5 6\n');
  const words = ['param', 'cut.obj', '--weld', 'none', '-o', 'y.obj'];
  const { code, err } = run(words, '--also', 'y.glb');
  assert.equal(code, 4, err);
  assert.match(err, /y\.glb: as a glTF this would be read as another surface/);
  assert.equal(existsSync(at('y.obj')), false);
  good(words, '--also', 'z.obj');
});
