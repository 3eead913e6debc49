// The model with its own materials: every instance where its node puts it, normals where the file has none, and nothing that is not
// in the files that were dropped.

import assert from 'node:assert/strict';
import test from 'node:test';
import { inflateSync } from 'node:zlib';
import { Matrix4, Vector3 } from 'three';
import { disposeScene, loadGltfScene } from '../../../web/src/views/gltf_scene.ts';
import { randomFrom } from '../../mutation/draw.mjs';
import { cubeMesh, packGlb, toGlb, toGltf } from '../../support/meshes.mjs';

globalThis.self ??= globalThis;
globalThis.ProgressEvent ??= class extends Event {};

const bytesOf = (content) => new Uint8Array(typeof content === 'string' ? new TextEncoder().encode(content) : content); // prettier-ignore
const unit = new Matrix4().toArray();
const sourceOf = (name, content, files = {}, meshes = [{ mesh: 0, matrices: [unit] }]) => ({ written: [{ name, bytes: bytesOf(content) }], files: new Map(Object.entries(files)), meshes }); // prettier-ignore
const meshesOf = (instance) => instance.children.filter((one) => one.isMesh);
function pointsOf(mesh) {
  const { position } = mesh.geometry.attributes;
  return Array.from({ length: position.count }, (_, i) => new Vector3().fromBufferAttribute(position, i).applyMatrix4(mesh.matrix)); // prettier-ignore
}
const farthest = (mesh, key) => Math.max(...pointsOf(mesh).map((p) => p[key]));

test('each mesh has an instance for each of its matrices, in its place, with a material of its own', async () => {
  const to = new Matrix4().makeTranslation(5, 0, -2).toArray();
  const small = toGlb([cubeMesh(1), cubeMesh(2)]);
  const none = sourceOf('a.glb', small, {}, [{ mesh: 1, matrices: [unit, to] }, { mesh: 0, matrices: [] }]); // prettier-ignore
  const { group, instances } = await loadGltfScene(none);
  assert.deepEqual([...instances].map(([mesh, list]) => [mesh, list.length]), [[1, 2], [0, 0]]); // prettier-ignore
  assert.deepEqual(group.children, [...instances.get(1)]);
  const [[first], [second]] = instances.get(1).map(meshesOf);
  assert.deepEqual([farthest(first, 'x') + 5, farthest(first, 'z') - 2], [farthest(second, 'x'), farthest(second, 'z')]); // prettier-ignore
  assert.notEqual(first.material, second.material);
  assert.equal(first.geometry.index?.count ?? first.geometry.attributes.position.count, 3 * cubeMesh(2).triangles.length); // prettier-ignore
  for (const mesh of [first, second]) {
    assert.deepEqual([mesh.material.side, mesh.frustumCulled, mesh.matrixAutoUpdate], [2, false, false]); // prettier-ignore
    const shader = { uniforms: {}, fragmentShader: 'void main() {\n#include <colorspace_fragment>\n}' }; // prettier-ignore
    mesh.material.onBeforeCompile(shader);
    const { quiet, paper } = mesh === first ? instances.get(1)[0] : instances.get(1)[1];
    assert.deepEqual([shader.uniforms.quiet === quiet, shader.uniforms.quietPaper === paper], [true, true]); // prettier-ignore
    assert.ok(shader.fragmentShader.includes('uniform float quiet') && shader.fragmentShader.includes('seen * seen')); // prettier-ignore
  }
  const freed = [];
  for (const [name, one] of Object.entries({ geometry: first.geometry, material: first.material })) one.addEventListener('dispose', () => freed.push(name)); // prettier-ignore
  const map = { isTexture: true, dispose: () => freed.push('map') };
  first.material.map = map;
  disposeScene(group);
  assert.deepEqual(new Set(freed), new Set(['geometry', 'material', 'map']));
  disposeScene(undefined);
});

test('meshes without normals get smooth ones with creases, large ones smooth ones; those of the file stay', async () => {
  const normalsOf = async (content) => {
    const { instances } = await loadGltfScene(sourceOf('a.glb', content));
    const [mesh] = meshesOf(instances.get(0)[0]);
    return { mesh, normal: mesh.geometry.attributes.normal };
  };
  const parts = (n) => {
    const { vertices, triangles } = cubeMesh(n);
    const flat = (p) => p.map((x) => x / Math.max(...p.map(Math.abs)));
    const all = toGltf([{ vertices: vertices.map(flat), triangles }]);
    for (const { attributes } of all.json.meshes[0].primitives) delete attributes.NORMAL;
    return packGlb(all);
  };
  const sharp = await normalsOf(parts(2));
  assert.equal(sharp.mesh.material.flatShading, false);
  for (let i = 0; i < sharp.normal.count; i++) {
    const n = new Vector3().fromBufferAttribute(sharp.normal, i);
    assert.ok(Math.abs(Math.max(Math.abs(n.x), Math.abs(n.y), Math.abs(n.z)) - 1) < 1e-6, 'a side of a cube is flat'); // prettier-ignore
  }
  // 12 n² triangles: creases are found in sixty thousand, not in more.
  const bends = async (n) => {
    const { normal } = await normalsOf(parts(n));
    return Array.from({ length: normal.count }, (_, i) => new Vector3().fromBufferAttribute(normal, i)).some((p) => Math.max(Math.abs(p.x), Math.abs(p.y), Math.abs(p.z)) < 0.99); // prettier-ignore
  };
  assert.deepEqual([await bends(70), await bends(71)], [false, true]);
});

test('normals of the file are shown as they are, however unlike those of the shape, on each mesh that has them', async () => {
  const random = randomFrom(3);
  const { json, bin } = toGltf([cubeMesh(2), cubeMesh(1)]);
  const [first, second] = json.meshes.map(({ primitives }) => primitives[0].attributes);
  const { count } = json.accessors[first.POSITION];
  const normals = Float32Array.from({ length: 3 * count }, () => 2 * random() - 1);
  const content = new Uint8Array(bin.byteLength + normals.byteLength);
  content.set(new Uint8Array(bin.buffer ?? bin, bin.byteOffset ?? 0, bin.byteLength));
  content.set(new Uint8Array(normals.buffer), bin.byteLength);
  json.buffers[0].byteLength = content.length;
  json.bufferViews.push({ buffer: 0, byteOffset: bin.byteLength, byteLength: normals.byteLength });
  first.NORMAL = json.accessors.push({ bufferView: json.bufferViews.length - 1, componentType: 5126, count, type: 'VEC3' }) - 1; // prettier-ignore
  delete second.NORMAL;
  const parts = [0, 1].map((mesh) => ({ mesh, matrices: [unit] }));
  const source = sourceOf('a.gltf', JSON.stringify(json), { [json.buffers[0].uri]: content }, parts); // prettier-ignore
  const { instances } = await loadGltfScene(source);
  const [shown, made] = parts.map(({ mesh }) => meshesOf(instances.get(mesh)[0])[0].geometry);
  assert.deepEqual([...shown.attributes.normal.array], [...normals]);
  assert.equal(shown.index.count, 3 * cubeMesh(2).triangles.length, 'and its corners are shared as they were'); // prettier-ignore
  const { normal } = made.attributes;
  for (let i = 0; i < normal.count; i++) assert.ok(Math.abs(new Vector3().fromBufferAttribute(normal, i).length() - 1) < 1e-6); // prettier-ignore
});

test('buffers come from the files, from data in the file, and from nowhere else', async () => {
  const { json, bin } = toGltf([cubeMesh(2)]);
  const gltf = (uri) => JSON.stringify({ ...json, buffers: [{ ...json.buffers[0], uri }] });
  const count = async (...source) => {
    const { instances } = await loadGltfScene(sourceOf(...source));
    return pointsOf(meshesOf(instances.get(0)[0])[0]).length > 0;
  };
  const made = [];
  const freed = [];
  const { createObjectURL, revokeObjectURL } = URL;
  URL.createObjectURL = (blob) => (made.push(createObjectURL.call(URL, blob)), made.at(-1));
  URL.revokeObjectURL = (url) => (freed.push(url), revokeObjectURL.call(URL, url));
  try {
    const inFile = `data:application/octet-stream;base64,${Buffer.from(bin).toString('base64')}`;
    const asText = `data:application/octet-stream,${encodeURIComponent(String.fromCharCode(...new Uint8Array(bin)))}`; // prettier-ignore
    assert.equal(await count('a.gltf', gltf('a%20b.bin'), { 'a b.bin': bytesOf(bin) }), true);
    assert.equal(await count('a.gltf', gltf('./a.bin'), { 'a.bin': new Blob([bin]) }), true);
    assert.equal(await count('a.gltf', gltf(inFile)), true);
    assert.equal(await count('a.gltf', gltf(asText)), true);
    await assert.rejects(count('a.gltf', gltf('a.bin'), { 'b.bin': bytesOf(bin) }));
    assert.ok(made.length >= 5);
    assert.deepEqual(freed, made, 'all are let go');
  } finally {
    Object.assign(URL, { createObjectURL, revokeObjectURL });
  }
  // The file that was written takes the place of the one that was dropped.
  const written = sourceOf('a.gltf', gltf('a.bin'), { 'a.bin': new Blob(['short']) });
  written.written.push({ name: 'a.bin', bytes: bytesOf(bin) });
  assert.equal((await loadGltfScene(written)).group.children.length, 1);
});

test('a GLB whose header is shorter than its chunks is read, and the file is left as it is', async () => {
  const glb = bytesOf(toGlb([cubeMesh(1)]));
  new DataView(glb.buffer).setUint32(8, 20, true);
  const before = glb.slice();
  const { instances } = await loadGltfScene(sourceOf('a.glb', glb));
  assert.equal(instances.get(0).length, 1);
  assert.deepEqual(glb, before);
});

test('in place of an image that is missing stands a PNG of one white pixel', async (t) => {
  const made = [];
  t.mock.method(URL, 'createObjectURL', (blob) => `blob:${made.push(blob)}`);
  const { json, bin } = toGltf([cubeMesh(1)]);
  const file = { ...json, images: [{ uri: 'gone.png' }], textures: [{ source: 0 }], materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }] }; // prettier-ignore
  file.meshes = json.meshes.map((mesh) => ({ ...mesh, primitives: mesh.primitives.map((one) => ({ ...one, material: 0 })) })); // prettier-ignore
  const source = sourceOf('a.gltf', JSON.stringify(file), { [json.buffers[0].uri]: bin }, [{ mesh: 0, matrices: [unit] }]); // prettier-ignore
  await loadGltfScene(source).catch(() => undefined); // what reads images is in browsers alone
  const images = made.filter(({ type }) => type === 'image/png');
  assert.ok(images.length > 0);
  for (const image of images) {
    const png = Buffer.from(await image.arrayBuffer());
    assert.equal(png.toString('latin1', 0, 8), '\x89PNG\r\n\x1a\n');
    assert.deepEqual([png.readUInt32BE(16), png.readUInt32BE(20), ...png.subarray(24, 26)], [1, 1, 8, 0]); // prettier-ignore
    const at = png.indexOf('IDAT');
    assert.deepEqual([...inflateSync(png.subarray(at + 4, at + 4 + png.readUInt32BE(at - 4)))], [0, 255]); // prettier-ignore
  }
});
