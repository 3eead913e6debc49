// A file of several meshes, a file of many cones, and ways through the page without a mouse.

import assert from 'node:assert/strict';
import { NodeIO } from '@gltf-transform/core';
import { cubeMesh, toGlb, toGltf, toObj } from '../support/meshes.mjs';
import { cubesOnAnEdge, torusMesh } from './shapes.mjs';
import {
  certificate,
  coneCount,
  drop,
  example,
  openFiles,
  pixels,
  pngOf,
  run,
  saveAs,
  settled,
  share,
  state,
  statusSays,
  useBrowser,
  workerCalls,
} from './support.mjs';

const it = useBrowser();
const { test } = it;
const meshState = (i) => it.page.locator(`[data-mesh="${i}"]`).getAttribute('data-mesh-state');

test('all meshes of a file are run, kept while another is shown, and saved in one download', async () => {
  const { page } = it;
  await openFiles(it, { 'two.glb': toGlb([cubeMesh(3), torusMesh(16, 8)]) });
  assert.equal(await page.locator('[data-mesh="1"]').getAttribute('aria-current'), 'true');
  // Each has a picture of its shape; after Run of its map.
  const picture = (i) =>
    page.evaluate(
      (n) => [...document.querySelector(`[data-thumbnail="${n}"]`).getContext('2d').getImageData(0, 0, 48, 48).data], // prettier-ignore
      i,
    );
  await page.waitForSelector('[data-thumbnail="0"]');
  await page.waitForSelector('[data-thumbnail="1"]');
  const shapes = [await picture(0), await picture(1)];
  const seen = shapes.map((data) => data.filter((x, i) => i % 4 === 3 && x > 0).length);
  assert.ok(seen[0] > 600 && seen[1] > 300 && seen[0] !== seen[1], `${seen}`);
  // Beside the names one is run, in the bar all of them are.
  await page.click('.mesh-strip #run');
  await state(page, 'certified');
  assert.deepEqual([await meshState(0), await meshState(1)], ['waiting', 'certified']);
  assert.match(await page.getAttribute('header #run-all', 'class'), /primary/);
  await page.click('#download');
  assert.match(
    await page.innerText('dialog'),
    /One mesh of the file has no map yet; Run all makes it/,
  );
  await page.keyboard.press('Escape');
  await page.click('header #run-all');
  await statusSays(it, /2 meshes certified/);
  assert.deepEqual([await meshState(0), await meshState(1)], ['certified', 'certified']);
  const isAmber = (data) => data.some((x, i) => i % 4 === 0 && x > data[i + 2] + 60);
  assert.deepEqual(shapes.map(isAmber), [false, false]);
  await page.waitForFunction(() =>
    [...document.querySelectorAll('[data-thumbnail]')].every((canvas) => {
      const { data } = canvas.getContext('2d').getImageData(0, 0, 48, 48);
      return data.some((x, i) => i % 4 === 0 && x > data[i + 2] + 60);
    }),
  );
  // The map of the other is there at once, with its cones and its history.
  await page.click('[data-mesh="0"]');
  await state(page, 'certified');
  assert.ok((await coneCount(it)) > 0);
  await page.click('#undo');
  assert.equal(await coneCount(it), 0);
  await page.click('#redo');
  // What was solved is kept: Download only writes.
  const calls = await workerCalls(page);
  await page.click('#download');
  assert.doesNotMatch(await page.innerText('dialog'), /no map yet/);
  await page.keyboard.press('Escape');
  const { bytes } = await saveAs(it, 'same');
  const called = await calls.names();
  assert.equal(called.filter((method) => method === 'combine').length, 1, `${called}`);
  assert.ok(!called.includes('parametrize'), `${called}`);
  const document = await new NodeIO().readBinary(new Uint8Array(bytes));
  const meshes = document.getRoot().listMeshes();
  for (const mesh of meshes) {
    const [primitive] = mesh.listPrimitives();
    assert.ok(primitive.getAttribute('TEXCOORD_0'), mesh.getName());
    assert.equal(mesh.getExtras().hgp?.q, 4);
  }
  await statusSays(it, /2 meshes in one file, all certified/);
});

test('a download that is cancelled leaves the mesh that is open in the solver', async () => {
  const { page } = it;
  await openFiles(it, { 'two.glb': toGlb([cubeMesh(3), torusMesh(16, 8)]) });
  await page.click('header #run-all');
  await statusSays(it, /2 meshes certified/);
  await page.click('[data-mesh="0"]');
  await state(page, 'certified');
  // The file is never written: there is time to cancel.
  await page.evaluate(() => {
    const { postMessage } = Worker.prototype;
    Worker.prototype.postMessage = function (message, ...rest) {
      if (message?.method === 'combine') globalThis.isHeld = true;
      else postMessage.call(this, message, ...rest);
    };
  });
  await page.click('#download');
  await page.click('[data-format="same"]');
  await page.waitForFunction(() => globalThis.isHeld);
  await page.keyboard.press('Escape');
  await page.click('#cancel');
  await statusSays(it, /Cancelled/);
  await page.click('#suggest');
  await statusSays(it, /8 cones suggested for q = 4/); // of the cube, and not of the torus
  await page.click('#run');
  await statusSays(it, /Certified: no triangle is folded/);
  assert.match(await certificate(it), /of 108/);
});

test('a model is shown at once with its own materials and node transforms', async () => {
  const { page } = it;
  const { json, bin } = toGltf([cubeMesh(4)], { image: 'leaf.png' });
  const mesh = json.nodes.findIndex((node) => node.mesh === 0);
  json.nodes[mesh].scale = [0.2, 3, 0.2]; // a pillar
  await openFiles(it, {
    'pillar.gltf': JSON.stringify(json),
    'cube.bin': bin,
    'leaf.png': pngOf([[20, 190, 40]]),
  });
  await page.waitForFunction(() => document.querySelector('#view').dataset.original === 'shown');
  await settled(page);
  const isGreen = (r, g, b) => g > r + 30 && g > b + 30;
  const own = await pixels(page, '#view', 'own-material');
  const columns = new Set();
  const rows = new Set();
  for (let i = 0; i < own.data.length; i += 4) {
    if (!isGreen(own.data[i], own.data[i + 1], own.data[i + 2])) continue;
    columns.add((i / 4) % own.width);
    rows.add(Math.floor(i / 4 / own.width));
  }
  assert.ok(rows.size > 3 * columns.size, `${columns.size} × ${rows.size}`);
  await run(it);
  await settled(page);
  assert.equal(await page.getAttribute('#view', 'data-original'), 'none');
  const after = await pixels(page, '#view', 'own-mapped');
  assert.ok(share(after, isGreen) < 0.001);
  // Before and after, side by side.
  await page.locator('#wipe').fill('100');
  await settled(page);
  const whole = share(await pixels(page, '#view', 'wiped'), isGreen); // the map has taken room since `own`
  await page.locator('#wipe').fill('50');
  await settled(page);
  const half = share(await pixels(page, '#view', 'wipe'), isGreen);
  assert.ok(half > 0.3 * whole && half < 0.8 * whole, `${half} of ${whole}`);
  await page.locator('#wipe').fill('0');
});

test('a scene is shown whole: a click on a quiet mesh opens it, and meshes with maps keep their pattern', async () => {
  const { page } = it;
  const { json, bin } = toGltf([cubeMesh(4), torusMesh(16, 8)]);
  // Beside each other as the camera sees them, and the cube once more.
  json.nodes[0].translation = [-4, 0, 2.6];
  json.nodes.push({ mesh: 0, translation: [4, 0, -2.6] });
  json.scenes[0].nodes.push(2);
  await openFiles(it, { 'scene.gltf': JSON.stringify(json), 'cube.bin': bin });
  await settled(page);
  const thirds = async (isSo) => {
    const { data, width } = await pixels(page, '#view');
    const found = [0, 0, 0];
    for (let i = 0; i < data.length; i += 4) {
      const third = Math.floor((3 * ((i / 4) % width)) / width);
      found[third] += isSo(...data.subarray(i, i + 4)) ? 1 : 0;
    }
    return found;
  };
  const isDark = (r, g, b) => r + g + b < 640; // the stage is nearly white
  assert.ok(
    (await thirds(isDark)).every((n) => n > 100),
    `${await thirds(isDark)}`,
  );
  assert.equal(await page.getAttribute('[data-mesh="1"]', 'aria-current'), 'true');
  const box = await page.locator('#view').boundingBox();
  const at = [box.x + 0.2 * box.width, box.y + 0.5 * box.height];
  await page.mouse.move(...at);
  await page.waitForFunction(() =>
    /mesh 0: click/.test(document.querySelector('.hover').innerText),
  );
  await page.mouse.click(...at);
  await page.waitForSelector('[data-mesh="0"][aria-current="true"]');
  await state(page, 'ready');
  await page.click('.mesh-strip #run');
  await state(page, 'certified');
  await settled(page);
  // The other instance of the cube has the pattern as well; the torus has none.
  const isAmber = (r, g, b) => r > b + 60;
  const [left, middle, right] = await thirds(isAmber);
  assert.ok(left > 100 && right > 100 && middle < 0.2 * right, `${[left, middle, right]}`);
  await page.click('[data-mesh="1"]');
  await state(page, 'ready');
  await settled(page);
  assert.ok((await thirds(isAmber))[0] > 100);
});

test('a glTF with data: URIs is shown with its own materials', async () => {
  const { page } = it;
  const { json, bin } = toGltf([cubeMesh(3)], { image: 'leaf.png' });
  const inside = (type, bytes) => `data:${type};base64,${Buffer.from(bytes).toString('base64')}`;
  json.buffers[0].uri = inside('application/gltf-buffer', bin);
  json.images[0].uri = inside('image/png', pngOf([[20, 190, 40]]));
  await openFiles(it, { 'inside.gltf': JSON.stringify(json) });
  await page.waitForFunction(() => document.querySelector('#view').dataset.original === 'shown');
  await settled(page);
  const isGreen = (r, g, b) => g > r + 30 && g > b + 30;
  assert.ok(share(await pixels(page, '#view'), isGreen) > 0.1);
});

test('hundreds of cones are two draw calls', async () => {
  const { page } = it;
  await page.evaluate(() => {
    const { prototype } = WebGL2RenderingContext;
    globalThis.calls = 0;
    for (const name of ['drawElements', 'drawArrays']) {
      const draw = prototype[name];
      prototype[name] = function (...args) {
        globalThis.calls += 1;
        return draw.apply(this, args);
      };
    }
  });
  const mesh = cubeMesh(12);
  await openFiles(it, { 'cube.obj': toObj(mesh) });
  const cones = Array.from({ length: 400 }, (_, i) => ({ vertex: 8 + 2 * i, k: i % 2 ? 3 : 5 }));
  const file = { format: 'hgp-cones', version: 1, q: 4, cones };
  await drop(it, { 'many.cones.json': JSON.stringify(file) });
  await page.waitForSelector('#cones');
  await settled(page);
  await page.evaluate(() => (globalThis.calls = 0));
  await page.locator('#view').focus();
  await page.keyboard.press('ArrowLeft');
  await settled(page);
  const frames = await page.evaluate(() => globalThis.calls);
  assert.ok(frames > 0 && frames <= 12, `${frames} draw calls for one step of the camera`);
});

test('the toolbar and the tabs are one Tab stop each, and arrow keys move inside', async () => {
  const { page } = it;
  await example(it, 'cube');
  const focused = () => page.evaluate(() => document.activeElement.id);
  await page.locator('#tool-orbit').focus();
  await page.keyboard.press('ArrowRight');
  assert.equal(await focused(), 'tool-place');
  await page.keyboard.press('End');
  await page.keyboard.press('Home');
  assert.equal(await focused(), 'tool-orbit');
  await page.keyboard.press('ArrowLeft');
  assert.equal(await focused(), 'turntable');
  await page.keyboard.press('Tab');
  assert.equal(await focused(), 'view');
  await page.setViewportSize({ width: 900, height: 700 });
  await page.locator('#tab-surface').focus();
  await page.keyboard.press('ArrowRight');
  assert.equal(await focused(), 'tab-map');
  assert.equal(await page.getAttribute('#tab-map', 'aria-selected'), 'true');
  await page.click('#tab-surface');
});

test('every action is in the palette; Ctrl+K, a few letters, Enter', async () => {
  const { page } = it;
  await example(it, 'cube');
  await page.keyboard.press('Control+k');
  assert.ok((await page.locator('[data-action]').count()) > 25);
  assert.equal(await page.locator('[data-action="download"]').isDisabled(), true);
  await page.keyboard.type('wire');
  await page.keyboard.press('Enter');
  assert.equal(await page.getAttribute('#wire', 'aria-pressed'), 'true');
  assert.equal(await page.locator('#palette-dialog').count(), 0);
  await page.click('#wire');
  // The menu of examples goes away by itself.
  await page.click('#examples');
  await page.waitForSelector('#example-list:popover-open');
  await page.mouse.click(600, 400);
  await page.waitForSelector('#example-list:popover-open', { state: 'detached' });
});

test('a URL opens its example with its cones', async () => {
  const { page } = it;
  await page.goto('about:blank');
  await page.goto(`${it.url}#example=cube&pattern=brick`);
  await state(page, 'ready');
  assert.equal(await coneCount(it), 8);
  await run(it);
  assert.equal(await page.inputValue('#pattern'), 'brick');
  await page.waitForFunction(() => location.hash.includes('example=cube'));
});

test('the Place tool previews the cone before the click', async () => {
  const { page } = it;
  await openFiles(it, { 'cube.obj': toObj(cubeMesh(8)) });
  await settled(page);
  await page.click('#tool-place');
  const box = await page.locator('#view').boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.waitForSelector('#view[data-ghost="3"]');
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  assert.equal(await coneCount(it), 1);
  await page.click('#tool-orbit');
});

test('the Place tool repairs a mesh that needs it, says so, and places the cone', async () => {
  const { page } = it;
  await openFiles(it, { 'cubes.obj': cubesOnAnEdge() }, 'invalid');
  await settled(page);
  await page.click('#tool-place');
  const box = await page.locator('#view').boundingBox();
  await page.mouse.click(box.x + 0.45 * box.width, box.y + 0.55 * box.height);
  await statusSays(it, /Repaired first, so that cones can be placed/);
  assert.equal(await coneCount(it), 1);
  await page.click('#tool-orbit');
});
