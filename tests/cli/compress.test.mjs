// --compress: what is stored is decoded by others (meshoptimizer in JavaScript, glTF-Transform) to the bytes
// that the file has without it.
import assert from 'node:assert/strict';
import { mkdirSync, readdirSync, statSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { featureFiles } from '../gltf/features.mjs';
import { readIndependently } from '../gltf/independent.mjs';
import { cubeMesh, toGlb, toGltf, toObj } from '../support/meshes.mjs';
import { inFolder } from '../support/program.mjs';

const { at, put, run, good } = inFolder('compress');

const bytes = (array) =>
  array ? Buffer.from(array.buffer, array.byteOffset, array.byteLength) : null;

/** Every array of a document, by where it is used. */
function arraysOf(document) {
  const root = document.getRoot();
  const out = {};
  root.listMeshes().forEach((mesh, m) =>
    mesh.listPrimitives().forEach((primitive, p) => {
      out[`${m}/${p}/indices`] = bytes(primitive.getIndices()?.getArray());
      for (const name of primitive.listSemantics())
        out[`${m}/${p}/${name}`] = bytes(primitive.getAttribute(name).getArray());
      primitive.listTargets().forEach((target, t) => {
        for (const name of target.listSemantics())
          out[`${m}/${p}/${t}/${name}`] = bytes(target.getAttribute(name).getArray());
      });
    }),
  );
  root.listAnimations().forEach((animation, a) =>
    animation.listSamplers().forEach((sampler, s) => {
      out[`animation ${a}/${s}`] = Buffer.concat([
        bytes(sampler.getInput().getArray()),
        bytes(sampler.getOutput().getArray()),
      ]);
    }),
  );
  root
    .listSkins()
    .forEach((skin, s) => (out[`skin ${s}`] = bytes(skin.getInverseBindMatrices()?.getArray())));
  root.listTextures().forEach((texture, t) => (out[`texture ${t}`] = bytes(texture.getImage())));
  return out;
}

async function isSameDecoded(packed, plain) {
  const [a, b] = await Promise.all([readIndependently(at(packed)), readIndependently(at(plain))]);
  assert.deepEqual(arraysOf(a.document), arraysOf(b.document), packed);
  const places = ['buffers', 'bufferViews', 'extensionsUsed', 'extensionsRequired'];
  const others = (json) => Object.entries(json).filter(([key]) => !places.includes(key));
  assert.deepEqual(others(a.json), others(b.json), 'nothing but bytes and their places');
  return a.json;
}

test('a large GLB becomes smaller, and every decoded array is the same', async () => {
  put('cube.glb', toGlb([cubeMesh(24), cubeMesh(3)]));
  good('param', 'cube.glb', '-o', 'plain.glb');
  const { err } = good('param', 'cube.glb', '-o', 'packed.glb', '--compress');
  assert.match(err, /compressed with meshopt, lossless: \d+ bytes/);
  const json = await isSameDecoded('packed.glb', 'plain.glb');
  assert.ok(json.extensionsRequired.includes('EXT_meshopt_compression'));
  const sizes = ['packed.glb', 'plain.glb'].map((name) => statSync(at(name)).size);
  assert.ok(sizes[0] < 0.6 * sizes[1], `${sizes}`);
  assert.match(good('verify', 'packed.glb').out, /2 of 2 meshes certified/);
  // Mapped once more, compressed input and output.
  good('param', 'packed.glb', '-o', 'again.glb', '--compress', '--uv-set', '0');
  good('param', 'plain.glb', '-o', 'again_plain.glb', '--uv-set', '0');
  await isSameDecoded('again.glb', 'again_plain.glb');
});

test('every glTF feature file decodes to the same data with and without compression', async () => {
  let packedCount = 0;
  for (const { name, files } of await featureFiles({ isSolved: true })) {
    const main = Object.keys(files).find((file) => /\.(glb|gltf)$/.test(file));
    for (const [file, content] of Object.entries(files)) put(`features/${name}/${file}`, content);
    const input = `features/${name}/${main}`;
    const ending = path.extname(main);
    mkdirSync(at(`features/${name}/out`), { recursive: true });
    const plain = run('param', input, '-o', `features/${name}/out/plain${ending}`, '--keep-going');
    const packed = run('param', input, '-o', `features/${name}/out/packed${ending}`, '--keep-going', '--compress'); // prettier-ignore
    if (name.endsWith('unknown extension')) {
      assert.equal(packed.code, 2, packed.err);
      continue;
    }
    assert.equal(packed.code, plain.code, `${name}\n${packed.err}`);
    if (plain.code !== 0 && plain.code !== 6) continue;
    const json = await isSameDecoded(
      `features/${name}/out/packed${ending}`,
      `features/${name}/out/plain${ending}`,
    );
    const isPacked = JSON.stringify(json.bufferViews).includes('EXT_meshopt_compression');
    packedCount += isPacked ? 1 : 0;
    assert.doesNotMatch(packed.err, /stored uncompressed/, name);
  }
  assert.ok(packedCount >= 3, `${packedCount}`); // most are too small to gain
});

test('a .gltf has one packed file beside it, or none with --embed', async () => {
  const { json, bin } = toGltf([cubeMesh(12)], { buffer: 'cube.bin' });
  put('model/cube.gltf', JSON.stringify(json));
  put('model/cube.bin', bin);
  mkdirSync(at('apart'));
  good('param', 'model/cube.gltf', '-o', 'apart/plain.gltf');
  mkdirSync(at('packed'));
  good('param', 'model/cube.gltf', '-o', 'packed/cube.gltf', '--compress');
  assert.deepEqual(readdirSync(at('packed')).sort(), ['cube-packed.bin', 'cube.gltf']);
  await isSameDecoded('packed/cube.gltf', 'apart/plain.gltf');
  good('verify', 'packed/cube.gltf');
  mkdirSync(at('inside'));
  good('param', 'model/cube.gltf', '-o', 'inside/cube.gltf', '--compress', '--embed');
  assert.deepEqual(readdirSync(at('inside')), ['cube.gltf']);
  await isSameDecoded('inside/cube.gltf', 'apart/plain.gltf');
  good('param', 'model/cube.gltf', '-o', 'cube.glb', '--compress');
  good('verify', 'cube.glb');
});

test('what cannot be compressed is refused or noted', () => {
  put('cube.obj', toObj(cubeMesh(2)));
  const wrong = run('param', 'cube.obj', '-o', 'out.obj', '--compress');
  assert.equal(wrong.code, 2);
  assert.match(wrong.err, /--compress is for glTF/);
  const { json, bin } = toGltf([cubeMesh(2)], { buffer: 'cube.bin' });
  json.extensionsUsed = ['XYZ_points_into_buffers'];
  json.extensions = { XYZ_points_into_buffers: { bufferView: 0 } };
  put('unknown/cube.gltf', JSON.stringify(json));
  put('unknown/cube.bin', bin);
  const unknown = run('param', 'unknown/cube.gltf', '-o', 'unknown/out.gltf', '--compress');
  assert.equal(unknown.code, 2, unknown.err);
  assert.match(unknown.err, /compressing: an extension of this file may point into its buffers/);
  assert.doesNotMatch(unknown.err, /certified/, 'refused before anything is solved');
  assert.deepEqual(readdirSync(at('unknown')).sort(), ['cube.bin', 'cube.gltf']);
});

test('a note gives the size of input that is no longer compressed, side files included', () => {
  put('cube.glb', toGlb([cubeMesh(12)]));
  good('param', 'cube.glb', '-o', 'small.glb', '--compress');
  good('param', 'cube.glb', '-o', 'small.gltf', '--compress');
  const sizeOf = (...names) => names.reduce((sum, name) => sum + statSync(at(name)).size, 0);
  for (const [input, output, parts] of [
    ['small.glb', 'loose.glb', ['loose.glb']],
    ['small.gltf', 'loose.gltf', ['loose.gltf', 'loose-uv.bin', 'small-packed.bin']],
  ]) {
    const { err } = good('param', input, '-o', output, '--q', '6');
    const [, bytes, times] = err.match(
      /stored uncompressed: (\d+) bytes, ([\d.]+) times the input/,
    );
    assert.equal(Number(bytes), sizeOf(...parts));
    assert.ok(Number(times) > 1, times);
  }
});
