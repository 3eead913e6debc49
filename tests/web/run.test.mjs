// Drop, Run, Download: three actions without any knowledge. And what is then on the screen.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import path from 'node:path';
import { NodeIO } from '@gltf-transform/core';
import { problems } from '../cli/schema.mjs';
import { cubesOnAnEdge } from './shapes.mjs';
import { cubeMesh, toGlb, toObj } from '../support/meshes.mjs';
import {
  certificate,
  commandLine,
  drop,
  example,
  openFiles,
  pixels,
  run,
  saveAs,
  settled,
  share,
  state,
  statusText,
  useBrowser,
} from './support.mjs';

const it = useBrowser({ deviceScaleFactor: 1 });
const { test } = it;
const cube = cubeMesh(8);

function certify(t, name, bytes) {
  const program = commandLine(t);
  if (!program) return;
  const file = path.join(it.folder, name);
  writeFileSync(file, bytes);
  const { status, stdout, stderr } = spawnSync(program, ['verify', file], { encoding: 'utf8' });
  assert.equal(status, 0, stdout + stderr);
}

test('drop, Run, Download: a GLB comes back with a certified map that another reader finds', async (t) => {
  await openFiles(it, { 'cube.glb': toGlb([cube]) });
  assert.match(await statusText(it.page), /Run suggests them/);
  // The second click of a double click meets Cancel.
  await it.page.dblclick('#run');
  await state(it.page, 'certified');
  assert.match(await statusText(it.page), /Certified.*suggested/);
  assert.match(await certificate(it), /Flipped triangles[\s\S]*0 of 768[\s\S]*same map/);
  const { name, bytes } = await saveAs(it, 'same');
  assert.equal(name, 'cube.glb');
  const document = await new NodeIO().readBinary(new Uint8Array(bytes));
  const [primitive] = document.getRoot().listMeshes()[0].listPrimitives();
  const uv = primitive.getAttribute('TEXCOORD_0').getArray();
  const position = primitive.getAttribute('POSITION').getArray();
  const index = primitive.getIndices().getArray();
  assert.equal(index.length, 3 * 768);
  // v points down in glTF: a map without flips is clockwise there, everywhere.
  for (let t = 0; t < index.length; t += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => [uv[2 * index[t + k]], uv[2 * index[t + k] + 1]]);
    const area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    assert.ok(area < 0, `triangle ${t / 3}`);
  }
  assert.equal(position.length / 3, uv.length / 2);
  certify(t, 'cube.glb', bytes);

  // Dropped again, the cones are there and the map is the same.
  const before = await it.page.locator('#cones tbody').innerText();
  await drop(it, { 'again.glb': bytes });
  await it.page.waitForSelector('.file[title="again.glb"]');
  await state(it.page, 'ready');
  assert.match(await statusText(it.page), /came with the file/);
  assert.equal(await it.page.locator('#cones tbody').innerText(), before);
});

test('the other formats hold the same map', async (t) => {
  await openFiles(it, { 'cube.obj': toObj(cube) });
  await run(it);
  const same = await saveAs(it, 'same');
  assert.equal(same.name, 'cube.obj');
  certify(t, 'same.obj', same.bytes);
  const glb = await saveAs(it, 'glb');
  const json = await new NodeIO().readBinary(new Uint8Array(glb.bytes));
  assert.equal(json.getRoot().listMeshes()[0].listPrimitives()[0].getIndices().getCount(), 3 * 768);
  const obj = await saveAs(it, 'obj');
  assert.match(String(obj.bytes), /^vt /m);
  certify(t, 'plain.obj', obj.bytes);
  const report = JSON.parse(String((await saveAs(it, 'report')).bytes));
  assert.equal(report.certificate.certified, true);
  const cones = JSON.parse(String((await saveAs(it, 'cones')).bytes));
  assert.deepEqual(problems('hgp-cones', cones), []);
  assert.match(String((await saveAs(it, 'svg')).bytes), /^<svg /);
  assert.equal((await saveAs(it, 'zip')).bytes.readUInt32LE(0), 0x04034b50);
});

test('the checker is on the mesh and in the map; overlays have their colours and numbers', async () => {
  await example(it, 'cube');
  await run(it);
  await it.page.selectOption('#pattern', 'checker');
  await settled(it.page);
  for (const view of ['#view', '#map']) {
    const seen = await pixels(it.page, view, `checker${view.replace('#', '-')}`);
    const amber = share(seen, (r, g, b) => r > b + 60 && g > b + 30);
    const navy = share(seen, (r, g, b) => b > r + 15 && b < 140);
    assert.ok(amber > 0.03 && navy > 0.03, `${view}: ${amber} ${navy}`);
  }
  await it.page.selectOption('#overlay', 'area');
  assert.match(await it.page.locator('.legend').innerText(), /Area[\s\S]*÷[\s\S]*×/);
  // Flips are offered where there are any.
  await it.page.selectOption('#overlay', 'none');
  assert.equal(await it.page.locator('#overlay option[value="flips"]').count(), 0);
  await settled(it.page);
  const red = share(await pixels(it.page, '#view'), (r, g, b) => r > 170 && g < 70 && b < 70);
  assert.equal(red, 0);
});

test('nothing is drawn while nothing changes', async () => {
  await example(it, 'sphere');
  await settled(it.page);
  const frames = () => it.page.evaluate(() => document.querySelector('#view').dataset.frames);
  const before = await frames();
  await it.page.evaluate(async () => {
    for (let i = 0; i < 30; i++) await new Promise((resolve) => requestAnimationFrame(resolve));
  });
  assert.equal(await frames(), before);
});

test('quads that share an edge: repaired, certified, run again with the same cones, and verified', async (t) => {
  const { page } = it;
  await openFiles(it, { 'cubes.obj': cubesOnAnEdge() }, 'invalid');
  await page.click('#repair-and-run');
  await state(page, 'certified');
  const { name, bytes } = await saveAs(it, 'same');
  assert.match(String(bytes), /^f \d+\/\d+ \d+\/\d+ \d+\/\d+ \d+\/\d+\s*$/m); // still quads
  certify(t, name, bytes);
  // Vertices of the edge are two each: the cones know which.
  const count = await page.locator('#cones tbody tr[data-cone]').count();
  assert.equal(count, 16);
  assert.equal(await page.locator('#cones tr.bad').count(), 0);
  await run(it);
  assert.equal(await page.locator('#cones tbody tr[data-cone]').count(), count);
});

test('a one-sided strip is cut where necessary: one click from refused to certified', async (t) => {
  const { page } = it;
  const n = 24;
  const lines = [];
  for (let i = 0; i < n; i++) {
    const angle = (2 * Math.PI * i) / n;
    for (const s of [-0.3, 0.3]) {
      const r = 1 + s * Math.cos(angle / 2);
      lines.push(`v ${r * Math.cos(angle)} ${r * Math.sin(angle)} ${s * Math.sin(angle / 2)}`);
    }
  }
  for (let i = 0; i < n; i++) {
    const [a, b] = [2 * i + 1, 2 * i + 2];
    const [c, d] = i + 1 < n ? [a + 2, b + 2] : [2, 1]; // joined upside down
    lines.push(`f ${a} ${c} ${b}`, `f ${c} ${d} ${b}`);
  }
  await openFiles(it, { 'strip.obj': `${lines.join('\n')}\n` }, 'invalid');
  await page.click('#repair-and-run');
  await state(page, 'certified');
  const { name, bytes } = await saveAs(it, 'same');
  certify(t, name, bytes);
});
