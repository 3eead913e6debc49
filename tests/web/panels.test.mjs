// The inspector: repairs and welds with undo, boundaries and handles, Solve, the table of cones, the
// choices of Download.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { NodeIO } from '@gltf-transform/core';
import { cubeMesh, toGlb, toObj } from '../support/meshes.mjs';
import { crackedCube, flatSquare, torusMesh } from './shapes.mjs';
import {
  certificate,
  commandLine,
  download,
  drop,
  example,
  kOf,
  model,
  modelSays,
  openFiles,
  openMesh,
  pixels,
  pngOf,
  run,
  settled,
  share,
  showSeams,
  shots,
  state,
  statusText,
  useBrowser,
  openDetails,
  coneCount,
} from './support.mjs';

const it = useBrowser({ permissions: ['clipboard-read', 'clipboard-write'] });
const { test } = it;

test('a weld and a repair are steps of undo like any other', async () => {
  const { page } = it;
  await openMesh(it, crackedCube());
  const before = await model(it);
  assert.match(before, /Components\s*2[\s\S]*Boundaries\s*2/);
  await page.locator('#weld').fill('0.001');
  await page.locator('#weld').press('Enter');
  await modelSays(it, /Components\s*1/);
  assert.match(await model(it), /Boundaries\s*0/);
  await page.click('#undo');
  await modelSays(it, /Components\s*2/);
  assert.equal(await page.locator('#weld').inputValue(), '');
  await page.click('#redo');
  await modelSays(it, /Components\s*1/);

  const { vertices, triangles } = cubeMesh(3);
  const fin = [...triangles, [triangles[0][0], triangles[0][1], vertices.length]];
  await openFiles(
    it,
    { 'fin.obj': toObj({ vertices: [...vertices, [-2, -2, -2]], triangles: fin }) },
    'invalid',
  );
  await page.click('[data-fix="split"]');
  await state(page, 'ready', 'unbalanced');
  await page.click('#undo');
  await state(page, 'invalid');
  await page.click('#redo');
  await state(page, 'ready', 'unbalanced');
});

test('turning indices: by stepper, in the budget, and as they were solved', async () => {
  const { page } = it;
  const square = flatSquare(8);
  await openMesh(it, square);
  const loop = page.locator('[data-loop="0"]');
  assert.match(
    await loop.innerText(),
    /Boundary 1[\s\S]*32 vertices · length 8[\s\S]*by its shape 4/,
  );
  await loop.locator('button[aria-label$="larger"]').click();
  assert.equal(await loop.locator('input').inputValue(), '4');
  await loop.locator('button[aria-label$="larger"]').click();
  assert.match(await page.locator('#run-why').textContent(), /1 too much/);
  await page.locator('#panel-cones').scrollIntoViewIfNeeded();
  await loop.locator('button[aria-label$="smaller"]').click();
  await run(it);
  assert.match(await certificate(it), /Boundary turning\s*[\s\S]*0 wrong/);
  await page.waitForFunction(() => location.hash.includes('turnings='));
  await loop.locator('button.link').click();
  assert.match(await statusText(page), /boundary 1/);
  await loop.locator('input').fill('');
  await loop.locator('input').press('Enter');
  await state(page, 'stale', 'ready');
});

test('handle loops have rows, steppers and colours on the surface', async () => {
  const { page } = it;
  await openMesh(it, torusMesh(24, 12));
  assert.match(await model(it), /Genus g\s*1/);
  await run(it);
  await openDetails(page, '#panel-turnings');
  assert.match(await page.locator('[data-handle="0"]').innerText(), /0°/);
  await page.selectOption('#pattern', 'plain');
  await showSeams(page, false);
  const isRed = (r, g, b) => r > 200 && g < 130 && b < 90;
  const isTeal = (r, g, b) => g > 120 && r < 80 && b > 100;
  await page.locator('[data-handle="0"] button.link').click();
  await page.click('[aria-label="Frame the model"]');
  await settled(page);
  const seen = await pixels(page, '#view', 'handles');
  assert.ok(share(seen, isRed) + share(seen, isTeal) > 0.001);
  await page.locator('[data-handle="1"] button.link').click();
  await settled(page);
  assert.ok(share(await pixels(page, '#view'), isRed) < 0.0001);
  // A torus without cones cannot turn along a handle: refused before Run, with the reason.
  await page.locator('[data-handle="0"] [aria-label$="larger"]').click();
  assert.match(await page.locator('[data-handle="0"]').innerText(), /90°/);
  await page.waitForSelector('#status.error');
  assert.match(await statusText(page), /handles cannot rotate/);
  await state(page, 'stale');
  assert.equal(await page.locator('#run').getAttribute('aria-disabled'), 'true');
  assert.match(await page.locator('#run-why').textContent(), /handles cannot rotate/);
  await page.click('#undo');
  await state(page, 'certified');
});

test('the divider between the views is moved with the arrow keys and by dragging', async () => {
  const { page } = it;
  await example(it, 'cube');
  const width = async () => (await page.locator('#view').boundingBox()).width;
  const whole = await width();
  assert.equal(await page.isVisible('#splitter'), false); // until there is a map
  await run(it);
  const before = await width();
  assert.ok(before < 0.7 * whole, `${before} of ${whole}`);
  const splitter = page.locator('#splitter');
  const value = async () => Number(await splitter.getAttribute('aria-valuenow'));
  const from = await value();
  await splitter.focus();
  for (let i = 0; i < 3; i++) await page.keyboard.press('ArrowLeft');
  assert.equal(await value(), from - 12);
  const narrow = await width();
  assert.ok(narrow < before - 60, `${narrow} of ${before}`);
  for (let i = 0; i < 40; i++) await page.keyboard.press('ArrowRight');
  assert.equal(await value(), 80); // neither view can be pushed away
  assert.ok((await width()) > before + 60);
  const box = await splitter.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + 100);
  await page.mouse.down();
  await page.mouse.move(box.x - 150, box.y + 100, { steps: 4 });
  await page.mouse.up();
  assert.ok((await value()) < 70);
  // Without dragging: one click after another.
  const now = await splitter.boundingBox();
  await page.mouse.click(now.x + now.width / 2, now.y + 200);
  const first = await value();
  const then = await splitter.boundingBox();
  await page.mouse.click(then.x + then.width / 2, then.y + 200);
  assert.notEqual(await value(), first);
  assert.equal(await page.evaluate(() => document.activeElement.id), 'splitter');
});

test('Balance for me adds the missing cones where they cost least, as one step of undo', async () => {
  const { page } = it;
  await openMesh(it, cubeMesh(8));
  // One corner by hand: what a click places is a cone of the missing sign.
  await page.click('#tool-place');
  const box = await page.locator('#view').boundingBox();
  await settled(page); // what is not drawn cannot be clicked
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  await page.waitForSelector('tr[data-cone="0"]');
  assert.equal(await kOf(it, 0), '3');
  const cell = 'tr[data-cone] td:nth-of-type(1)';
  const before = (await page.locator(cell).allInnerTexts()).map(Number);
  await page.click('#balance');
  await page.waitForSelector('.budget.good');
  assert.equal(await coneCount(it), 8);
  // The corners of the cube are where the curvature is: the added cones are at them or one edge away.
  const { vertices } = cubeMesh(8);
  const isCorner = (v) => vertices[v].every((x) => Math.abs(x) > 0.6);
  const placed = await page.locator(cell).allInnerTexts();
  const added = placed.map(Number).filter((v) => !before.includes(v));
  assert.ok(added.length === 7 && added.every(isCorner), `${placed}`);
  await page.click('#undo');
  assert.equal(await coneCount(it), 1);
  await page.click('#tool-orbit');
});

test('the table of cones is sorted by its columns, and a cone can be centred', async () => {
  const { page } = it;
  await example(it, 'cube');
  // All of each row is in sight, the last button included.
  const side = await page.locator('aside').boundingBox();
  const last = await page.locator('tr[data-cone="7"] [aria-label$="delete"]').boundingBox();
  assert.ok(last.x + last.width <= side.x + side.width, `${last.x + last.width}`);
  await page.click('tr[data-cone="2"] [aria-label$="smaller k"]');
  const first = () => page.locator('#cones tbody tr').first().getAttribute('data-cone');
  await page.click('[data-sort="k"]');
  assert.equal(await first(), '2');
  assert.equal(
    await page.locator('#cones th[aria-sort="ascending"]').innerText(),
    await page.locator('[data-sort="k"]').innerText(),
  );
  await page.click('[data-sort="vertex"]');
  await page.click('[data-sort="vertex"]');
  assert.equal(await first(), '7');
  await settled(page);
  const before = await pixels(page, '#view');
  await page.click('tr[data-cone="7"] [aria-label$="frame"]');
  await settled(page);
  const after = await pixels(page, '#view');
  assert.notDeepEqual(before.data, after.data);
  assert.equal(await page.locator('tr.selected').getAttribute('data-cone'), '7');
});

test('Solve: the estimate, the time limit, and the command line that does the same', async (t) => {
  const { page } = it;
  await openMesh(it, cubeMesh(8), "it's a cube.obj");
  await page.click('#suggest');
  await page.waitForSelector('#cones');
  await page.click('#solve-more > summary');
  assert.match(await page.locator('#estimate').innerText(), /Memory[\s\S]*\d+ MB[\s\S]*Time/);
  await page.click('#copy-command');
  await page.waitForSelector('#status.good');
  const command = await page.evaluate(() => navigator.clipboard.readText());
  assert.match(command, /^hgp param 'it'\\''s a cube\.obj' --q 4 --cone \d+:\d+/);
  await page.screenshot({ path: path.join(shots, 'panel-solve.png') });
  const program = commandLine(t);
  if (program) {
    writeFileSync(path.join(it.folder, 'run.sh'), command.replace(/^hgp/, `"${program}"`));
    const made = spawnSync('sh', ['run.sh'], { cwd: it.folder, encoding: 'utf8' });
    assert.equal(made.status, 0, made.stderr);
    assert.ok(existsSync(path.join(it.folder, "it's a cube.mapped.obj")));
  }
  await page.click('#log');
  assert.match(await page.locator('#log-dialog').innerText(), /Copied[\s\S]*suggested/);
});

/** The same GLB with a picture on its first mesh. */
async function textured(bytes) {
  const document = await new NodeIO().readBinary(new Uint8Array(bytes));
  const picture = document.createTexture().setImage(pngOf([[20, 190, 40]])).setMimeType('image/png'); // prettier-ignore
  const material = document.createMaterial().setBaseColorTexture(picture);
  document.getRoot().listMeshes()[0].listPrimitives()[0].setMaterial(material);
  // As another program writes it: a set that is marked as hgp's own would be replaced.
  for (const accessor of document.getRoot().listAccessors()) accessor.setExtras({});
  return new NodeIO().writeBinary(document);
}

test('Download: another uv set, another scale, without cones; each is verified again', async () => {
  const { page } = it;
  await openFiles(it, { 'cube.glb': toGlb([cubeMesh(4)]) });
  await run(it);
  const idle = () =>
    page.waitForSelector('#downloads ul:not([aria-busy="true"])', { state: 'attached' });
  await page.click('#download');
  await openDetails(page, '#more-formats');
  await page.uncheck('#embed-cones');
  await idle();
  const saved = await download(page, () => page.click('[data-format="same"]'));
  // The file now has a set: the next run takes the next one, or replaces it on request.
  await drop(it, { 'again.glb': await textured(saved.bytes) });
  await page.waitForSelector('.file[title="again.glb"]');
  await state(page, 'ready');
  assert.equal(await page.locator('#cones').count(), 0); // they were not embedded
  await run(it);
  const sets = async () => {
    const { bytes } = await download(page, () => page.click('[data-format="same"]'));
    const document = await new NodeIO().readBinary(new Uint8Array(bytes));
    const mesh = document.getRoot().listMeshes()[0];
    const [primitive] = mesh.listPrimitives();
    return { primitive, extras: mesh.getExtras(), names: primitive.listSemantics() };
  };
  await page.click('#download');
  const next = await sets();
  assert.equal(next.extras.hgp?.q, 4);
  assert.deepEqual(next.names.filter((name) => name.startsWith('TEXCOORD')), ['TEXCOORD_0', 'TEXCOORD_1']); // prettier-ignore
  // The textures of the file are pointed at the new set, and the old one stays.
  const texCoord = ({ primitive }) => primitive.getMaterial().getBaseColorTextureInfo().getTexCoord(); // prettier-ignore
  assert.equal(texCoord(next), 0);
  await page.click('#download');
  assert.equal(await page.locator('#uv-set').inputValue(), 'keep');
  // Where the new set is found, in the words of each program, and what becomes of the old textures.
  const hints = { three: /texture\.channel = 1/, engine: /channel 1/, blender: /“UVMap\.001”/ };
  for (const [target, hint] of Object.entries(hints)) {
    await page.selectOption('#target', target);
    assert.match(await page.innerText('#target-hint'), hint);
  }
  assert.match(await page.innerText('#own-textures'), /stay on the old coordinates/);
  await page.selectOption('#uv-set', 'use');
  await idle();
  await page.waitForFunction(() => document.querySelector('#uv-set')?.value === 'use');
  const used = await sets();
  assert.deepEqual(used.names.filter((name) => name.startsWith('TEXCOORD')), ['TEXCOORD_0', 'TEXCOORD_1']); // prettier-ignore
  assert.equal(texCoord(used), 1);
  await page.click('#download');
  await page.selectOption('#uv-set', '0');
  await idle();
  await page.waitForFunction(() => document.querySelector('#uv-set')?.value === '0');
  assert.doesNotMatch(await page.innerText('#target-hint'), /UVMap\.0/);
  assert.match(await page.innerText('#own-textures'), /painted for the old ones and will not fit/);
  await openDetails(page, '#more-formats');
  await page.selectOption('#uv-scale', 'fit');
  await idle();
  await page.screenshot({ path: path.join(shots, 'download-choices.png') });
  const replaced = await sets();
  assert.deepEqual(replaced.names.filter((name) => name.startsWith('TEXCOORD')), ['TEXCOORD_0']); // prettier-ignore
  const uv = replaced.primitive.getAttribute('TEXCOORD_0').getArray();
  assert.ok(Math.min(...uv) >= -1e-6 && Math.max(...uv) <= 1 + 1e-6);
  assert.ok(Math.max(...uv) > 0.9);
  await state(page, 'certified');
  assert.match(await certificate(it), /same map/);
});
