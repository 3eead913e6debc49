// What Download makes, before the eyes of others: Khronos' validator on the page and in Node, another
// reader, and the grid that may be assigned; and cones from the fields of other programs.

import assert from 'node:assert/strict';
import path from 'node:path';
import { Logger, NodeIO } from '@gltf-transform/core';
import { unzipSync } from 'fflate';
import pngjs from 'pngjs';
import validator from 'gltf-validator';
import { cubeCrosses, cubeMesh, toGlb, toGltf, toObj } from '../support/meshes.mjs';
import {
  coarseGrid,
  certificate,
  coneCount,
  drop,
  kOf,
  openFiles,
  openMesh,
  pixels,
  run,
  saveAs,
  settled,
  share,
  shots,
  state,
  statusText,
  useBrowser,
  openDetails,
} from './support.mjs';

const it = useBrowser({ permissions: ['clipboard-read', 'clipboard-write'] });
const { test } = it;

async function validate() {
  const { page } = it;
  await page.click('#download');
  await openDetails(page, '#more-formats');
  await page.click('#validate');
  await page.waitForFunction(() => document.querySelector('#validation').textContent.trim() !== '');
  const text = await page.locator('.validation').innerText();
  await page.keyboard.press('Escape');
  return text;
}

const errorsOf = async (bytes, more = {}) =>
  (await validator.validateBytes(new Uint8Array(bytes), { ...more, maxIssues: 50 })).issues;

/** Chooses the grid in the Download dialog, and waits until it is written and verified. */
async function chooseGrid() {
  const { page } = it;
  await page.click('#download');
  await openDetails(page, '#more-formats');
  await page.check('#grid-material');
  await page.waitForSelector('#downloads ul:not([aria-busy="true"])');
  await page.waitForFunction(() => document.querySelector('#grid-material').checked);
  await page.screenshot({ path: path.join(shots, 'download-grid.png') });
  await page.keyboard.press('Escape');
}

const jsonOf = (glb) => String(glb.subarray(20, 20 + glb.readUInt32LE(12)));

test('Validate output: the Khronos validator agrees, and its errors are shown where it does not', async () => {
  const { page } = it;
  await openFiles(it, { 'cube.glb': toGlb([cubeMesh(4)]) });
  await run(it);
  assert.match(await validate(), /0 errors, 0 warnings, \d remarks? \(glTF Validator 2/);
  const saved = await saveAs(it, 'same');
  assert.equal((await errorsOf(saved.bytes)).numErrors, 0);

  // What nobody but the validator minds: bounds that are not those of the positions.
  const { json, bin } = toGltf([cubeMesh(4)], { buffer: 'cube.bin' });
  json.accessors.find(({ max }) => max).max[0] = 7;
  await openFiles(it, { 'wrong.gltf': JSON.stringify(json), 'cube.bin': bin });
  await page.waitForSelector('.file[title="wrong.gltf"]');
  await run(it);
  const text = await validate();
  assert.match(text, /1 error,[\s\S]*Error: .*\/accessors\/0\/max/);
  assert.equal(await page.locator('#download').isVisible(), true);
});

test('a grid as material: other readers see it, and all other bytes are kept', async () => {
  const { page } = it;
  const plain = toGlb([cubeMesh(4)]);
  // A number that no double holds, where nobody but its owner looks.
  const text = jsonOf(plain).replace(
    '"asset":{',
    '"asset":{"extras":{"id":9007199254740993,"x":1.50},',
  );
  const padded = text.trimEnd().padEnd(Math.ceil(text.trimEnd().length / 4) * 4);
  const rest = plain.subarray(20 + plain.readUInt32LE(12));
  const head = Buffer.from(plain.subarray(0, 20));
  head.writeUInt32LE(padded.length, 12);
  head.writeUInt32LE(20 + padded.length + rest.length, 8);
  await openFiles(it, { 'cube.glb': Buffer.concat([head, Buffer.from(padded), rest]) });
  await coarseGrid(page);
  await run(it);
  const before = await saveAs(it, 'same');
  await chooseGrid();
  assert.match(await certificate(it), /same map/);
  assert.match(await validate(), /0 errors, 0 warnings/);
  const { bytes } = await saveAs(it, 'same');
  assert.equal((await errorsOf(bytes)).numErrors, 0);
  assert.match(jsonOf(bytes), /"id":9007199254740993,"x":1\.50/);
  const [was, is] = [before.bytes, bytes].map((glb) => JSON.parse(jsonOf(glb)));
  for (const key of ['asset', 'scenes', 'nodes', 'accessors']) assert.deepEqual(is[key], was[key]);
  assert.deepEqual(is.bufferViews.slice(0, -1), was.bufferViews);

  const io = new NodeIO().setLogger(new Logger(Logger.Verbosity.SILENT));
  const document = await io.readBinary(new Uint8Array(bytes));
  const [primitive] = document.getRoot().listMeshes()[0].listPrimitives();
  const material = primitive.getMaterial();
  const image = pngjs.PNG.sync.read(Buffer.from(material.getBaseColorTexture().getImage()));
  assert.equal(material.getBaseColorTextureInfo().getTexCoord(), 0);
  const [{ pbrMetallicRoughness }] = is.materials;
  const [scale] = pbrMetallicRoughness.baseColorTexture.extensions.KHR_texture_transform.scale;
  assert.ok(scale > 0.5 && scale < 100, `${scale}`);
  assert.deepEqual([...image.data.subarray(0, 3)], [29, 63, 99]); // a line
  assert.deepEqual([...image.data.subarray(4 * (64 * 10 + 10), 4 * (64 * 10 + 10) + 3)], [233, 237, 242]); // prettier-ignore

  // And on the page, as three.js reads the very file.
  await page.selectOption('#pattern', 'material');
  await page.waitForFunction(() => document.querySelector('#view').dataset.original === 'shown');
  await settled(page);
  const isLine = (r, g, b) => b > r + 12 && r < 150;
  const seen = share(await pixels(page, '#view', 'grid-material'), isLine);
  assert.ok(seen > 0.02, `${seen}`);
});

test('the grid in a glTF of several files, and in the GLB of an OBJ', async () => {
  const { json, bin } = toGltf([cubeMesh(3)], { buffer: 'cube.bin' });
  await openFiles(it, { 'cube.gltf': JSON.stringify(json), 'cube.bin': bin });
  await run(it);
  await chooseGrid();
  assert.match(await certificate(it), /same map/);
  // The download brings the buffer along: nobody is asked to keep it.
  assert.doesNotMatch(await it.page.locator('#panel-result').innerText(), /keep cube\.bin/);
  const files = unzipSync(new Uint8Array((await saveAs(it, 'same')).bytes));
  assert.deepEqual(Buffer.from(files['cube.bin']), bin); // what the glTF names comes along
  const [main] = Object.keys(files).filter((name) => name.endsWith('.gltf'));
  const found = (uri) => Promise.resolve(files[decodeURIComponent(uri)]);
  const issues = await errorsOf(files[main], { externalResourceFunction: found });
  assert.equal(issues.numErrors, 0, JSON.stringify(issues.messages));
  assert.match(String(Buffer.from(files[main])), /"hgp grid"/);
  assert.match(await validate(), /Validate output[\s\S]*0 errors/);

  await openFiles(it, { 'cube.obj': toObj(cubeMesh(3)) });
  await it.page.waitForSelector('.file[title="cube.obj"]');
  await run(it);
  const plain = await saveAs(it, 'glb');
  await chooseGrid();
  const { bytes } = await saveAs(it, 'glb');
  assert.equal((await errorsOf(bytes)).numErrors, 0);
  assert.doesNotMatch(jsonOf(plain.bytes), /hgp grid/);
  assert.match(jsonOf(bytes), /"hgp grid"/);
  const zip = unzipSync(new Uint8Array((await saveAs(it, 'zip')).bytes));
  const inside = (uri) => Promise.resolve(zip[decodeURIComponent(uri)]);
  const unzipped = await validator.validateBytes(zip['cube.gltf'], {
    externalResourceFunction: inside,
  });
  assert.equal(unzipped.issues.numErrors, 0);
  assert.deepEqual(unzipped.info.resources.map(({ image }) => image?.width).filter(Boolean), [64]);
  assert.match(await validate(), /Validate the GLB[\s\S]*0 errors/);
});

test('the grid as material of an OBJ: in a ZIP with its .mtl; other lines keep their bytes', async () => {
  const { page } = it;
  // Carriage returns, a name that is no UTF-8, groups: whatever is in the file stays.
  const head = Buffer.from('# caf\xe9\r\nmtllib desk.mtl\r\n', 'latin1');
  const middle = Buffer.from('g one\nusemtl wood\n');
  const [vertices, faces] = toObj(cubeMesh(3)).split(/(?=f )(.*)/s);
  const source = Buffer.concat([head, Buffer.from(vertices), middle, Buffer.from(faces)]);
  await openFiles(it, { 'my desk.obj': source });
  await run(it);
  const before = await saveAs(it, 'same');
  await chooseGrid();
  assert.match(await certificate(it), /same map/);
  await page.click('#download');
  assert.match(await page.locator('[data-format="same"]').innerText(), /my_desk\.zip/);
  await page.keyboard.press('Escape');
  const { name, bytes } = await saveAs(it, 'same');
  assert.equal(name, 'my_desk.zip');
  const files = unzipSync(new Uint8Array(bytes));
  assert.deepEqual(Object.keys(files), ['my desk.obj', 'my_desk.grid.mtl', 'my_desk.grid.png']);
  const obj = Buffer.from(files['my desk.obj']).toString('latin1');
  assert.match(obj, /^mtllib my_desk\.grid\.mtl\nusemtl hgp_grid\n/);
  const undone = obj.replace(/^mtllib .*\nusemtl .*\n/, '').replace(/^# (?=usemtl|mtllib)/gm, '');
  assert.equal(undone, before.bytes.toString('latin1'));
  assert.equal(obj.match(/^usemtl/gm).length, 1);
  const mtl = Buffer.from(files['my_desk.grid.mtl']).toString();
  const [, scale, image] = mtl.match(/^map_Kd -s ([\d.]+) \1 1 (.*)$/m);
  assert.ok(scale > 0.1 && scale < 100, scale);
  assert.equal(pngjs.PNG.sync.read(Buffer.from(files[image])).width, 64);
  // The plain OBJ has it, too; and the page reads back what it made.
  const plain = unzipSync(new Uint8Array((await saveAs(it, 'obj')).bytes));
  assert.match(Buffer.from(plain['my_desk.obj']).toString(), /^mtllib my_desk\.grid\.mtl/);
  await openFiles(it, { 'again.zip': bytes });
  await page.waitForSelector('.file[title="my desk.obj"]');
});

test('a cross field of another program brings its cones', async () => {
  const { page } = it;
  const mesh = cubeMesh(4);
  await openMesh(it, mesh);
  await drop(it, { 'cube.rosy': cubeCrosses(mesh) });
  await page.waitForSelector('#cones');
  assert.match(await statusText(page), /8 cones imported from cube\.rosy/);
  assert.equal(await coneCount(it), 8);
  for (let i = 0; i < 8; i++) assert.equal(await kOf(it, i), '3');
  await run(it);
  // And its directions as frames, on request: another run, which belongs to that choice.
  await page.click('#solve-more > summary');
  await page.selectOption('#frames', 'file');
  await state(page, 'stale');
  await run(it);
  await page.selectOption('#frames', 'auto');
  await state(page, 'certified');
  await page.selectOption('#frames', 'file');
  await page.click('#copy-command');
  await page.waitForFunction(() => /Copied/.test(document.querySelector('#status')?.textContent));
  const command = await page.evaluate(() => navigator.clipboard.readText());
  assert.match(command, /--field cube\.rosy --frames file/);
  // Without the field's cones: refused, with a way out.
  await page.click('#clear-cones');
  await page.click('#run');
  await page.waitForSelector('#status.error');
  assert.match(await statusText(page), /field has a cone of k = 3/);
  assert.ok(await page.getByRole('button', { name: 'Run with automatic frames' }).isVisible());
  // The same by the button in the panel.
  const [chooser] = await Promise.all([
    page.waitForEvent('filechooser'),
    page.click('#field-file'),
  ]);
  await chooser.setFiles(path.join(it.folder, 'cube.rosy'));
  await page.waitForSelector('#cones');
  assert.equal(await coneCount(it), 8);
});
