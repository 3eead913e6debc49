// What is seen: every pattern, overlays, wireframe, the link between the views, the address; and that
// the texture goes on in the same direction across a seam.

import assert from 'node:assert/strict';
import { cubeMesh, toGltf, toObj } from '../support/meshes.mjs';
import { flatSquare } from './shapes.mjs';
import {
  isPink,
  openFiles,
  pixels,
  pngOf,
  run,
  settled,
  share,
  showSeams,
  state,
  statusText,
  useBrowser,
} from './support.mjs';

const it = useBrowser({ viewport: { width: 1150, height: 700 }, deviceScaleFactor: 1 });
const { test } = it;
const isInk = (r, g, b) => b > r + 15 && b < 140;

async function solvedCube() {
  await openFiles(it, { 'cube.obj': toObj(cubeMesh(6)) });
  await run(it);
}

async function look(name) {
  await settled(it.page);
  return pixels(it.page, '#view', name);
}

/** Part of the pixels in which two pictures differ. */
function difference(a, b) {
  let count = 0;
  for (let i = 0; i < a.data.length; i += 4) {
    const far = [0, 1, 2].some((k) => Math.abs(a.data[i + k] - b.data[i + k]) > 20);
    if (far) count += 1;
  }
  return count / (a.data.length / 4);
}

test('every pattern is drawn on the mesh and differs from the others', async () => {
  const { page } = it;
  await solvedCube();
  await showSeams(page, false);
  const seen = new Map();
  for (const pattern of [
    'plain',
    'cross',
    'grid',
    'checker',
    'hex',
    'circles',
    'brick',
    'wood',
    'plaid',
  ]) {
    await page.selectOption('#pattern', pattern);
    const picture = await look(`pattern-${pattern}`);
    for (const [other, before] of seen) {
      assert.ok(difference(picture, before) > 0.02, `${pattern} looks like ${other}`);
    }
    seen.set(pattern, picture);
    const isInked = ['cross', 'grid', 'checker', 'hex', 'circles'].includes(pattern);
    if (isInked) assert.ok(share(picture, isInk) > 0.01, pattern);
  }
  // Coarser and finer.
  await page.locator('#scale').fill('80');
  assert.ok(difference(await look('pattern-fine'), seen.get('plaid')) > 0.02);
});

test('an image of your own repeats on the mesh; a file that is no image is refused by name', async () => {
  const { page } = it;
  await solvedCube();
  const choose = async (name, buffer) => {
    const [chooser] = await Promise.all([
      page.waitForEvent('filechooser'),
      page.selectOption('#pattern', 'image'),
    ]);
    await chooser.setFiles({ name, mimeType: 'image/png', buffer });
  };
  await choose('notes.png', Buffer.from('no picture'));
  await page.waitForSelector('#status.error');
  assert.match(await statusText(page), /notes\.png.*not an image/);
  await choose('fields.png', pngOf([[250, 20, 200], [20, 200, 60], [20, 200, 60], [250, 20, 200]])); // prettier-ignore
  await page.waitForFunction(() => document.querySelector('#pattern').value === 'image');
  const picture = await look('pattern-image');
  const magenta = share(picture, (r, g, b) => r > g + 60 && b > g + 40);
  const green = share(picture, (r, g, b) => g > r + 40 && g > b + 40);
  assert.ok(magenta > 0.05 && green > 0.05, `${magenta} ${green}`);
});

test('the original material, as the written file has it', async () => {
  const { page } = it;
  const { json, bin } = toGltf([cubeMesh(4)], { image: 'leaf.png' });
  await openFiles(it, {
    'cube.gltf': JSON.stringify(json),
    'cube.bin': bin,
    'leaf.png': pngOf([[20, 190, 40]]),
  });
  await run(it);
  await page.selectOption('#pattern', 'material');
  await page.waitForFunction(() => document.querySelector('#view').dataset.original === 'shown');
  const picture = await look('pattern-material');
  const green = share(picture, (r, g, b) => g > r + 30 && g > b + 30);
  assert.ok(green > 0.1, `${green}`);
});

test('wireframe, seams, parallel projection and overlays answer to their keys', async () => {
  const { page } = it;
  await solvedCube();
  await page.selectOption('#pattern', 'plain');
  await page.locator('#view').focus();
  await page.keyboard.press('Shift'); // the ring of the focus is there from now on
  const plain = await look();
  await page.keyboard.press('l');
  const wire = await look('key-wire');
  assert.ok(difference(wire, plain) > 0.01, `${difference(wire, plain)}`);
  await page.keyboard.press('l');
  assert.ok(difference(await look(), plain) < 0.002);
  await page.keyboard.press('o');
  assert.ok(difference(await look('key-parallel'), plain) > 0.01);
  await page.keyboard.press('o');
  assert.ok(difference(await look(), plain) < 0.002);
  await page.selectOption('#overlay', 'seams');
  assert.match(await page.locator('.legend').innerText(), /Distance to a seam\s*0[\s\S]*≥ [\d.]+/);
  const yellow = (r, g, b) => r > b + 50 && g > b + 40;
  assert.ok(share(await look('overlay-seams'), yellow) > 0.01);
});

test('pointing at one view outlines the same triangle in the other; a seam names its twin', async () => {
  const { page } = it;
  await solvedCube();
  await page.selectOption('#pattern', 'plain');
  await settled(page);
  const box = await page.locator('#view').boundingBox();
  assert.equal(share(await pixels(page, '#map'), isPink), 0);
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2 + 15);
  await page.waitForSelector('.hover:not([hidden])');
  assert.match(await page.locator('.hover').innerText(), /v \d+ · valence \d+ · curvature/);
  await settled(page);
  assert.ok(share(await pixels(page, '#map', 'hover-map'), isPink) > 0.0001);
  // A seam: the map's picture is searched along lines until one is met.
  const map = await page.locator('#map').boundingBox();
  let text = '';
  for (const x of [0.5, 0.4, 0.6])
    for (let y = 0.1; y < 0.9 && !text.startsWith('Seam'); y += 0.01) {
      await page.mouse.move(map.x + map.width * x, map.y + map.height * y);
      await settled(page);
      text = await page.locator('.hover').textContent();
    }
  assert.match(text, /^Seam: turns by \d·360°\/4 = \d+°, shifts by \(/);
  assert.ok(share(await pixels(page, '#view', 'hover-seam'), isPink) > 0.0001);
  // A double click brings a place to the middle: no one has to drag.
  for (const [view, at] of [
    ['#view', [box.x + box.width / 2 + 60, box.y + box.height / 2 + 40]],
    ['#map', [map.x + map.width / 2, map.y + map.height / 2]],
  ]) {
    const before = await pixels(page, view);
    await page.mouse.dblclick(...at);
    await settled(page);
    assert.ok(difference(await pixels(page, view), before) > 0.01, view);
  }
  await page.mouse.move(5, 5);
  await page.waitForSelector('.hover[hidden]', { state: 'attached' });
});

/** Direction of the lines in a window, as an angle modulo 90° in degrees. */
function directionAt({ data, width }, x, y, half) {
  const grey = (i, j) => {
    const at = 4 * (j * width + i);
    return 0.3 * data[at] + 0.6 * data[at + 1] + 0.1 * data[at + 2];
  };
  let [cosine, sine] = [0, 0];
  for (let j = y - half; j <= y + half; j++) {
    for (let i = x - half; i <= x + half; i++) {
      const [gx, gy] = [grey(i + 1, j) - grey(i - 1, j), grey(i, j + 1) - grey(i, j - 1)];
      const size = gx * gx + gy * gy;
      const turn = 4 * Math.atan2(gy, gx);
      cosine += size * Math.cos(turn);
      sine += size * Math.sin(turn);
    }
  }
  return (Math.atan2(sine, cosine) * 180) / Math.PI / 4;
}

test('the URL restores cones, camera and pattern; lines continue across the seam', async () => {
  const { page } = it;
  const square = flatSquare(24);
  const cones = Buffer.from(JSON.stringify([[square.middle, 3]])).toString('base64url');
  await page.goto('about:blank'); // otherwise the page reloads itself for the new link
  await page.goto(`${it.url}#q=4&pattern=grid&tiles=34&camera=0,0,3.9,0,0,0&cones=${cones}`);
  await state(page, 'empty');
  await openFiles(it, { 'square.obj': toObj(square) });
  assert.equal(await page.locator('tr[data-cone="0"] input').inputValue(), '3');
  await run(it);
  assert.equal(await page.locator('#pattern').inputValue(), 'grid');
  await showSeams(page, true);
  const withSeams = await look('seam-shown');
  await showSeams(page, false);
  const picture = await look('seam-hidden');
  // The seam is where the pictures differ.
  const { width, height } = picture;
  const onSeam = [];
  for (let y = 60; y < height - 60; y++) {
    for (let x = 60; x < width - 60; x++) {
      const at = 4 * (y * width + x);
      const far = [0, 1, 2].reduce(
        (sum, k) => sum + Math.abs(picture.data[at + k] - withSeams.data[at + k]),
        0,
      );
      const fromCone = Math.hypot(x - width / 2, y - height / 2);
      if (far > 150 && fromCone > 70 && fromCone < 0.3 * height) onSeam.push([x, y]);
    }
  }
  assert.ok(onSeam.length > 100, `${onSeam.length} pixels of the seam`);
  const isWide = Math.abs(onSeam.at(-1)[0] - onSeam[0][0]) > Math.abs(onSeam.at(-1)[1] - onSeam[0][1]); // prettier-ignore
  const differences = [];
  for (let i = 0; i < onSeam.length; i += Math.ceil(onSeam.length / 12)) {
    const [x, y] = onSeam[i];
    const [dx, dy] = isWide ? [0, 24] : [24, 0];
    const turn =
      directionAt(picture, x + dx, y + dy, 18) - directionAt(picture, x - dx, y - dy, 18);
    differences.push(Math.abs(((turn + 135) % 90) - 45));
  }
  differences.sort((a, b) => a - b);
  const median = differences[Math.floor(differences.length / 2)];
  assert.ok(median < 8, `directions differ by ${differences.map((d) => d.toFixed(0)).join(' ')}`);
});
