// Aligned to a grid: after Run lines meet at every seam, in the picture and in the file, and the page says
// so exactly then; densities, patterns that turn, and the cells as a quad mesh.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { NodeIO } from '@gltf-transform/core';
import { cubeMesh, toObj } from '../support/meshes.mjs';
import { flatSquare } from './shapes.mjs';
import {
  certificate,
  commandLine,
  download,
  example,
  isPink,
  openDetails,
  openFiles,
  pixels,
  root,
  run,
  saveAs,
  settled,
  share,
  showSeams,
  state,
  statusSays,
  useBrowser,
} from './support.mjs';

const it = useBrowser({
  viewport: { width: 1150, height: 800 },
  deviceScaleFactor: 1,
  antialias: true,
});
const { test } = it;
const note = () => it.page.locator('.seam-note').innerText();

/** Moves a slider as a person does who lets it go. */
async function slide(selector, value) {
  const slider = it.page.locator(selector);
  await slider.fill(String(value));
  await slider.dispatchEvent('change');
}

/** Waits for the run that follows a change; what it says may be what was said before. */
async function rerun(act, ...states) {
  await it.page.evaluate(() => {
    let isBegun = false;
    window.hasRunAgain = false;
    const observer = new MutationObserver(() => {
      if (document.body.dataset.state === 'running') isBegun = true;
      else window.hasRunAgain = isBegun;
      if (window.hasRunAgain) observer.disconnect();
    });
    observer.observe(document.body, { attributeFilter: ['data-state'] });
  });
  await act();
  await it.page.waitForFunction(() => window.hasRunAgain);
  await state(it.page, ...(states.length > 0 ? states : ['certified']));
}

/** Vertices, uv and corners of an OBJ, as another reader sees them. */
function readObj(bytes) {
  const out = { v: [], vt: [], faces: [] };
  for (const line of String(bytes).split('\n')) {
    const [word, ...rest] = line.trim().split(/\s+/);
    if (word === 'v' || word === 'vt') out[word].push(rest.map(Number));
    if (word === 'f') out.faces.push(rest.map((one) => one.split('/').map((n) => Number(n) - 1)));
  }
  return out;
}

/** Of every edge with two sides in uv: whether z' = i^r z + t for an r and a whole t, to the last bit. */
function seamsOf({ vt, faces }) {
  const sides = new Map();
  let [seams, whole] = [0, 0];
  for (const face of faces) {
    face.forEach(([v, t], i) => {
      const [w, u] = face[(i + 1) % face.length];
      const twin = sides.get(`${w} ${v}`);
      if (!twin) return sides.set(`${v} ${w}`, [t, u]);
      if (twin[1] === t && twin[0] === u) return undefined;
      seams += 1;
      const [a, b, c, d] = [vt[twin[1]], vt[twin[0]], vt[t], vt[u]];
      for (let r = 0, turn = ([x, y]) => [x, y]; r < 4; r++) {
        const shift = [turn(a), turn(b)].map((p, k) => [0, 1].map((n) => [c, d][k][n] - p[n]));
        const isSame = shift[0].every((x, n) => x === shift[1][n] && Number.isInteger(x));
        if (isSame) {
          whole += 1;
          break;
        }
        const last = turn;
        turn = (p) => (([x, y]) => [-y, x])(last(p));
      }
      return undefined;
    });
  }
  return { seams, whole };
}

test('after Run lines meet at every seam: the note, the certificate and the file agree', async () => {
  const { page } = it;
  await openFiles(it, { 'cube.obj': toObj(cubeMesh(8)) });
  await run(it);
  assert.equal(await note(), 'Lines meet at every seam.');
  assert.match(await page.locator('#status').innerText(), /lines meet at every seam/);
  assert.equal(await page.getAttribute('#seams', 'aria-pressed'), 'false');
  assert.match(await certificate(it), /Lines meet\s*seams shifted by whole cells\s*(\d+) of \1\b/);
  const aligned = seamsOf(readObj((await saveAs(it, 'same')).bytes));
  assert.ok(aligned.seams > 0);
  assert.equal(aligned.whole, aligned.seams);

  // Without a grid nobody says so, and the same check of the file finds that it is not so.
  await rerun(() => page.locator('#align').uncheck());
  assert.match(await note(), /lines may be shifted there/);
  assert.equal(await page.getAttribute('#seams', 'aria-pressed'), 'true');
  const plain = seamsOf(readObj((await saveAs(it, 'same')).bytes));
  assert.ok(plain.seams > 0 && plain.whole < plain.seams, JSON.stringify(plain));
  assert.doesNotMatch(await page.locator('#status').innerText(), /lines meet/);
});

/** Part of a seam along which one side is dark and the other light. */
async function breaksAtSeam(page) {
  const find = (name) => pixels(page, '#view', name);
  await showSeams(page, true);
  await settled(page);
  const shown = await find('aligned-seam-shown');
  await showSeams(page, false);
  await settled(page);
  const picture = await find('aligned-seam-hidden');
  const { width, height, data } = picture;
  const far = (x, y) =>
    [0, 1, 2].reduce((sum, k) => {
      const at = 4 * (y * width + x) + k;
      return sum + Math.abs(data[at] - shown.data[at]);
    }, 0);
  const onSeam = [];
  for (let y = 130; y < height - 60; y++) {
    for (let x = 60; x < width - 60; x++) {
      const fromCone = Math.hypot(x - width / 2, y - height / 2);
      if (far(x, y) > 150 && fromCone > 60 && fromCone < 0.3 * height) onSeam.push([x, y]);
    }
  }
  assert.ok(onSeam.length > 60, `${onSeam.length} pixels of the seam`);
  const [first, last] = [onSeam[0], onSeam.at(-1)];
  const isWide = Math.abs(last[0] - first[0]) > Math.abs(last[1] - first[1]);
  const [dx, dy] = isWide ? [0, 1] : [1, 0];
  const grey = (x, y) => data[4 * (y * width + x)];
  const differ = onSeam.filter(
    ([x, y]) => Math.abs(grey(x - 2 * dx, y - 2 * dy) - grey(x + 2 * dx, y + 2 * dy)) > 100,
  );
  return differ.length / onSeam.length;
}

test('the texture continues across the seam of a cone with the grid, and breaks without it', async () => {
  const { page } = it;
  const square = flatSquare(24);
  const cones = Buffer.from(JSON.stringify([[square.middle, 3]])).toString('base64url');
  await page.goto('about:blank'); // otherwise the page reloads itself for the new link
  await page.goto(`${it.url}#q=4&pattern=checker&tiles=13&camera=0,0,3.9,0,0,0&cones=${cones}`);
  await state(page, 'empty');
  await openFiles(it, { 'square.obj': toObj(square) });
  await run(it);
  await rerun(() => slide('#cells', 30)); // so few that the lines are far apart in pixels
  assert.equal(await note(), 'Lines meet at every seam.');
  const aligned = await breaksAtSeam(page);
  await rerun(() => page.locator('#align').uncheck());
  const plain = await breaksAtSeam(page);
  assert.ok(aligned < 0.1, `${aligned} of the seam`);
  assert.ok(plain > 0.2, `${plain} of the seam`);
});

test('scale in whole steps, density by slider, and as many cells as the cones need where fewer are asked for', async () => {
  const { page } = it;
  await example(it, 'pebble');
  await run(it);
  const scale = page.locator('#scale');
  assert.deepEqual([await scale.getAttribute('min'), await scale.getAttribute('step')], ['1', '1']);
  await settled(page);
  const one = await pixels(page, '#view');
  await scale.fill('3');
  assert.equal(await scale.getAttribute('aria-valuetext'), '3 tiles along a cell');
  await settled(page);
  const three = await pixels(page, '#view');
  assert.ok(one.data.some((x, i) => Math.abs(x - three.data[i]) > 60));
  await scale.fill('1');
  const before = await page.locator('#grid-outcome').innerText();
  assert.match(before, /^[\d ]+ cells, \d+ for each cone/);
  await rerun(() => slide('#cells', 95));
  assert.match(await page.locator('#cells-shown').innerText(), /^6[\d ]+/);
  assert.notEqual(await page.locator('#grid-outcome').innerText(), before);
  assert.equal(await note(), 'Lines meet at every seam.');

  // Ten cells for forty cones: fewer cones or more cells, as many as the map needs.
  await rerun(() => slide('#cells', 0));
  assert.equal(await note(), 'Lines meet at every seam.');
  assert.match(
    await page.locator('#grid-outcome').innerText(),
    /^[1-9]\d? cells, \d+ for each cone/,
  );
  // Back to the first run, which the solver has kept: at once, so that no run need be seen.
  const few = await page.locator('#grid-outcome').innerText();
  await page.click('#cells-automatic');
  await page.waitForFunction(
    (text) => document.querySelector('#grid-outcome').innerText !== text,
    few,
  );
  await state(page, 'certified');
  assert.equal(await note(), 'Lines meet at every seam.');
});

test('bricks are turned where the map turns by a quarter, and the seams that do it are shown', async () => {
  const { page } = it;
  await example(it, 'cube');
  await run(it);
  await page.selectOption('#pattern', 'brick');
  const [, turned, all] = /Brick is turned across (\d+) of (\d+) seams?\./.exec(await note());
  assert.ok(Number(turned) > 0 && Number(turned) <= Number(all));
  await settled(page);
  assert.equal(share(await pixels(page, '#view'), isPink), 0);
  await page.click('#show-turned');
  await settled(page);
  assert.ok(share(await pixels(page, '#view'), isPink) > 0.0005);
  await page.selectOption('#pattern', 'plaid'); // the same after a quarter turn
  assert.equal(await note(), 'Lines meet at every seam.');
});

test('a q without square cells cannot be aligned, and the page says why', async () => {
  const { page } = it;
  await example(it, 'sphere');
  assert.equal(await page.locator('#q').inputValue(), '6');
  assert.equal(await page.locator('#align').isDisabled(), true);
  assert.match(await page.locator('#panel-solve').innerText(), /Squares need q = 2 or 4, not 6/);
  await run(it);
  assert.match(await note(), /lines may be shifted there/);
});

/** What makes a closed surface of quads one. */
function checkQuads({ v, faces }, cones) {
  assert.ok(faces.every((face) => face.length === 4));
  const edges = new Map();
  const valence = new Array(v.length).fill(0);
  for (const face of faces) {
    face.forEach(([a], i) => {
      const [b] = face[(i + 1) % 4];
      const key = a < b ? `${a} ${b}` : `${b} ${a}`;
      edges.set(key, (edges.get(key) ?? 0) + (a < b ? 1 : -1));
      valence[a] += 1;
    });
  }
  assert.ok(
    [...edges.values()].every((sum) => sum === 0),
    'each edge once in each direction',
  );
  assert.equal(v.length - edges.size + faces.length, 2);
  assert.equal(valence.filter((n) => n !== 4).length, cones);
}

test('Quad mesh: the map that is shown stays; pure quads of the right valences, seen on the model, as OBJ and GLB', async (t) => {
  const { page } = it;
  await example(it, 'pebble');
  await run(it);
  const cones = await page.locator('#cones tbody tr[data-cone]').count();
  await page.click('#download');
  await page.selectOption('#target', 'quads');
  assert.match(await page.locator('#target-hint').innerText(), /the map that you see stays/);
  const certified = await page.locator('#certificate').textContent();
  const { name, bytes } = await download(page, () => page.click('[data-format="quads"]'));
  assert.equal(name, 'pebble.quads.obj');
  checkQuads(readObj(bytes), cones);
  await statusSays(it, /^\d[\d ]* quads saved as pebble\.quads\.obj/);
  assert.equal(await page.locator('#grid-mode').inputValue(), 'tile');
  assert.equal(await page.locator('#certificate').textContent(), certified);
  // They are on the model, with their numbers, until one goes back.
  const { faces } = readObj(bytes);
  const note = await page.innerText('#quads-note');
  assert.ok(note.replaceAll(/\s/g, '').includes(`${faces.length}quads.`), note);
  const irregular = [...note.matchAll(/with [^4]\s+(\d+)/g)].reduce((sum, [, n]) => sum + Number(n), 0); // prettier-ignore
  assert.equal(irregular, cones);
  await settled(page);
  const isAmber = (r, g, b) => r > b + 60;
  assert.ok(share(await pixels(page, '#view'), isAmber) < 0.02);
  await page.click('#hide-quads');
  await settled(page);
  assert.ok(share(await pixels(page, '#view'), isAmber) > 0.05);
  await page.click('#preview-quads');
  await page.waitForSelector('#quads-note'); // at once: they are kept

  // Nobody asked for a density: the command line takes the same one, and has the same quads.
  const program = commandLine(t);
  if (program) {
    const exported = await download(page, () => page.click('#export-cones'));
    const [cones, out] = ['quads.cones.json', 'quads.obj'].map((file) =>
      path.join(it.folder, file),
    );
    writeFileSync(cones, exported.bytes);
    const model = path.join(root, 'build/page/examples/pebble.glb');
    execFileSync(program, ['quads', model, '--cones', cones, '--reproducible', '-o', out]);
    assert.deepEqual(readObj(readFileSync(out)).faces, readObj(bytes).faces);
  }

  await page.click('#download');
  await openDetails(page, '#more-formats');
  const glb = await download(page, () => page.click('[data-format="quads-glb"]'));
  const read = await new NodeIO().readBinary(new Uint8Array(glb.bytes));
  const [primitive] = read.getRoot().listMeshes()[0].listPrimitives();
  const { length } = readObj(bytes).faces;
  assert.equal(primitive.getIndices().getCount(), 6 * length);
  // And as it was for the next test.
  await page.click('#download');
  await page.selectOption('#target', 'blender');
  await page.keyboard.press('Escape');
});

test('one button saves the format for the chosen program; the choice is remembered', async () => {
  const { page } = it;
  await openFiles(it, { 'cube.obj': toObj(cubeMesh(6)) });
  await run(it);
  const saved = async (target) => {
    await page.click('#download');
    await page.selectOption('#target', target);
    return download(page, () => page.click('dialog .primary.big'));
  };
  assert.equal((await saved('blender')).name, 'cube.obj');
  const web = await saved('three');
  assert.equal(web.name, 'cube.glb');
  assert.equal(web.bytes.readUInt32LE(0), 0x46546c67);
  await page.click('#download');
  assert.equal(await page.locator('#target').inputValue(), 'three');
  await page.selectOption('#target', 'engine');
  assert.match(await page.locator('#target-hint').innerText(), /repeat of an image is one cell/);
  await page.selectOption('#target', 'blender');
  await page.keyboard.press('Escape');
});
