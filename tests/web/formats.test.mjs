// Every format that the page takes, dropped as a person drops it.

import assert from 'node:assert/strict';
import path from 'node:path';
import { zipSync } from 'fflate';
import { featureFiles } from '../gltf/features.mjs';
import { cubeMesh, toGlb, toGltf, toObj, toOff, toPly, toStl } from '../support/meshes.mjs';
import {
  drop,
  dropPaths,
  failure,
  model,
  modelSays,
  openFiles,
  pngOf,
  run,
  saveAs,
  state,
  useBrowser,
} from './support.mjs';

const it = useBrowser();
const { test } = it;
const cube = cubeMesh(4);
const shown = async () => {
  await state(it.page, 'ready');
  await it.page.waitForFunction(
    () => Number(document.querySelector('#view').dataset.triangles) > 0,
  );
  return model(it);
};

test('OBJ, OFF, PLY, STL and GLB one after another', async () => {
  const files = {
    'cube.obj': `mtllib cube.mtl\n${toObj(cube)}`,
    'cube.off': toOff(cube),
    'cube.ply': toPly(cube),
    'cube.stl': toStl(cube),
    'cube.glb': toGlb([cube]),
  };
  for (const [name, content] of Object.entries(files)) {
    await drop(it, { [name]: content });
    await it.page.waitForSelector(`.file[title="${name}"]`);
    assert.match(await shown(), /Triangles\s*192/, name);
    assert.match(await model(it), /Vertices\s*(98|576 → 98)/, name);
  }
});

test('a folder with a glTF, its buffer and its image', async () => {
  const { json, bin } = toGltf([cube], { buffer: 'data/cube%20one.bin', image: 'wood.png' });
  await drop(it, {
    'model/cube.gltf': JSON.stringify(json),
    'model/data/cube one.bin': bin,
    'model/wood.png': Buffer.from('not really an image'),
  });
  await state(it.page, 'ready', 'needs-files');
  await dropPaths(it, [path.join(it.folder, 'model')]);
  assert.match(await shown(), /Triangles\s*192/);
});

test('a glTF without its files asks for them; a second drop adds them', async () => {
  const { json, bin } = toGltf([cube], { image: 'wood.png' });
  await drop(it, { 'cube.gltf': JSON.stringify(json) });
  await state(it.page, 'needs-files');
  const dialog = it.page.locator('#needs-files');
  assert.match(await dialog.innerText(), /cube\.bin[\s\S]*wood\.png/);
  assert.equal(await it.page.locator('#without-images').count(), 0);
  await drop(it, { 'cube.bin': bin });
  await it.page.waitForSelector('#without-images');
  assert.doesNotMatch(await dialog.innerText(), /cube\.bin/);
  await it.page.click('#without-images');
  assert.match(await shown(), /Triangles\s*192/);
});

test('a ZIP; one that names files outside its folder is refused', async () => {
  const text = new TextEncoder().encode(toObj(cube));
  await drop(it, { 'evil.zip': zipSync({ '../cube.obj': text }) });
  assert.match(await failure(it), /outside its folder/);
  await drop(it, { 'cube.zip': zipSync({ 'a/cube.obj': text, 'a/readme.txt': text.slice(0, 5) }) });
  assert.match(await shown(), /Triangles\s*192/);
});

test('several meshes: whether each is usable, and the largest usable one suggested', async () => {
  const { page } = it;
  const broken = cubeMesh(6);
  broken.triangles.push([0, 8, 20], [0, 8, 30]);
  const { json, bin } = toGltf([cubeMesh(2), broken, cube]);
  json.nodes.push({ mesh: 2 }, { mesh: 2 }); // used three times
  json.nodes = json.nodes.filter(({ mesh }) => mesh !== 1); // and this one never
  json.scenes[0].nodes = json.nodes.map((_, i) => i);
  json.nodes[0].scale = [1, -1, 1];
  json.nodes.push({ children: [0], scale: [2, 2, 2] });
  const name = json.buffers[0].uri;
  await openFiles(it, { 'three.gltf': JSON.stringify(json), [name]: bin });
  const mesh = (i) => page.locator(`[data-mesh="${i}"]`);
  assert.equal(await mesh(2).getAttribute('aria-current'), 'true');
  assert.equal(await mesh(1).getAttribute('data-mesh-state'), 'unusable');
  assert.match(await mesh(1).getAttribute('title'), /434 triangles, non manifold edge/);
  await page.click('[data-mesh="0"]');
  await modelSays(it, /Triangles\s*48/);
  assert.match(await model(it), /A node mirrors it/);
  // And from there to another one.
  await page.click('[data-mesh="2"]');
  await modelSays(it, /Triangles\s*192/);
  assert.match(await model(it), /Used 3 times/);
  assert.doesNotMatch(await model(it), /mirrors/);
  await page.click('[data-mesh="1"]');
  await state(page, 'invalid');
});

test('an OBJ with its .mtl and image, dropped together', async () => {
  const mtl = 'newmtl wood\nmap_Kd wood.png\n';
  await drop(it, {
    'desk.obj': `mtllib desk.mtl\nusemtl wood\n${toObj(cube)}`,
    'desk.mtl': mtl,
    'wood.png': pngOf([[150, 90, 40]]),
  });
  assert.match(await shown(), /Triangles\s*192/);
  await run(it);
  const saved = await saveAs(it, 'same');
  assert.equal(saved.name, 'desk.obj');
  assert.match(String(saved.bytes), /^mtllib desk\.mtl\nusemtl wood\n/m);
});

test('a path that leaves the folder is refused by name', async () => {
  const { json } = toGltf([cube], { buffer: '../../secret.bin' });
  await drop(it, { 'cube.gltf': JSON.stringify(json) });
  assert.match(await failure(it), /secret\.bin|outside/);
});

test('Draco and meshopt are decoded in the worker', async () => {
  const features = await featureFiles();
  // The generated meshes are made to be awkward; the largest usable one is suggested.
  for (const [kind, reached, triangles] of [
    ['Draco', 'ready', 32],
    ['meshopt', 'ready', 144],
  ]) {
    const { files } = features.find(({ name }) => name === kind);
    await drop(it, files);
    await state(it.page, reached);
    const text = await model(it);
    assert.match(text, new RegExp(`Triangles\\s*${triangles}\\b`), kind);
  }
});
