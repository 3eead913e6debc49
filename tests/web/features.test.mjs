// Lines along features on the page: creases that are found, rims, chains that are clicked, and what the file then says.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import path from 'node:path';
import { cubeMesh, toObj } from '../support/meshes.mjs';
import { arch, flatSquare } from './shapes.mjs';
import {
  commandLine,
  openFiles,
  run,
  saveAs,
  settled,
  shots,
  state,
  statusSays,
  statusText,
  useBrowser,
  violations,
} from './support.mjs';

const it = useBrowser({ permissions: ['clipboard-read', 'clipboard-write'] });
const { test } = it;
const note = () => it.page.innerText('#features-note');

test('lines follow the creases of a cube: the map and the file have them straight', async (t) => {
  const { page } = it;
  await openFiles(it, { 'cube.obj': toObj(cubeMesh(6)) });
  await page.click('#follow-creases');
  await page.waitForSelector('#features-note');
  assert.match(await note(), /After Run, lines follow 12 creases: 72 edges/);
  await run(it);
  assert.match(await statusText(page), /lines follow 12 creases, and lines meet at every seam/);
  assert.match(await note(), /^Lines follow 12 creases/);
  await settled(page);
  await page.screenshot({ path: path.join(shots, 'features.png') });
  assert.deepEqual(await violations(page, '#panel-solve'), []);
  const program = commandLine(t);
  const saved = await saveAs(it, 'same');
  if (program) {
    const file = path.join(it.folder, 'mapped.obj');
    writeFileSync(file, saved.bytes);
    const { stdout, status } = spawnSync(program, ['verify', file, '--creases'], { encoding: 'utf8' }); // prettier-ignore
    assert.equal(status, 0, stdout);
    assert.match(stdout, /12 of 12 chains straight, exactly/);
  }
  // Another choice makes the map stale.
  await page.click('#features-clear');
  await state(page, 'stale');
  assert.equal(await page.locator('#features-note').count(), 0);
});

test('a click chooses the chain to the next corners, and with Alt takes it out', async () => {
  const { page } = it;
  await openFiles(it, { 'cube.obj': toObj(cubeMesh(6)) });
  await settled(page);
  await page.click('#tool-edges');
  const box = await page.locator('#view').boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.click(x, y);
  await statusSays(it, /edges? chosen/);
  const count = async () => Number(/(\d+) edges? inside/.exec(await note())[1]);
  const chosen = await count();
  assert.ok(chosen === 1 || chosen === 6, await note());
  await page.keyboard.down('Alt');
  await page.mouse.click(x, y);
  await page.keyboard.up('Alt');
  await statusSays(it, /no longer followed/);
  assert.equal(await page.locator('#features-note').count(), 0);
});

test('a symmetric map is offered where there is a plane, and the file verifies with its two halves mirrored', async (t) => {
  const { page } = it;
  await openFiles(it, { 'cube.obj': toObj(cubeMesh(3)) });
  await settled(page);
  assert.equal(await page.locator('#symmetric').count(), 0);
  await openFiles(it, { 'arch.obj': toObj(arch(6)) });
  await page.click('#symmetric');
  await page.waitForSelector('#features-note');
  assert.match(await note(), /After Run, lines follow 1 rim and the plane of symmetry\./);
  assert.equal(await page.locator('#features-export').count(), 0);
  await run(it);
  assert.match(await statusText(page), /lines follow 1 rim and the plane of symmetry/);
  await settled(page);
  await page.screenshot({ path: path.join(shots, 'symmetric.png') });
  assert.deepEqual(await violations(page, '#panel-solve'), []);
  const program = commandLine(t);
  const saved = await saveAs(it, 'same');
  const rows = (mark) =>
    new TextDecoder().decode(saved.bytes).split('\n').filter((row) => row.startsWith(mark)); // prettier-ignore
  // The map of the triangle at the mirrored place is as large, to the last digit but those of the subtraction.
  const numbers = (mark) => rows(mark).map((row) => row.split(' ').slice(1).map(Number));
  const [places, uv] = [numbers('v '), numbers('vt ')];
  const sizes = new Map();
  for (const row of rows('f ')) {
    const corners = row.split(' ').slice(1).map((word) => word.split('/').map((n) => n - 1)); // prettier-ignore
    const [a, b, c] = corners.map(([, n]) => uv[n]);
    const middle = [0, 1, 2].map((k) => corners.reduce((sum, [v]) => sum + places[v][k], 0));
    const size = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    sizes.set(middle.map((x) => Math.round(1e6 * x) + 0).join(' '), size);
  }
  assert.ok(sizes.size >= 144);
  for (const [middle, size] of sizes) {
    const [x, y, z] = middle.split(' ').map(Number);
    assert.ok(Math.abs(sizes.get([-x + 0, y, z].join(' ')) - size) < 1e-9, middle);
  }
  if (program) {
    const file = path.join(it.folder, 'mirrored.obj');
    writeFileSync(file, saved.bytes);
    const { stdout, status } = spawnSync(program, ['verify', file], { encoding: 'utf8' });
    assert.equal(status, 0, stdout);
  }
});

test('rims are offered where there are some, and a click on one chooses them', async () => {
  const { page } = it;
  await openFiles(it, { 'square.obj': toObj(flatSquare(6)) });
  await page.click('#follow-rims');
  await page.waitForSelector('#features-note');
  assert.match(await note(), /lines follow 1 rim\./);
  await run(it);
  assert.match(await statusText(page), /lines follow 1 rim/);
  await openFiles(it, { 'cube.obj': toObj(cubeMesh(4)) });
  assert.equal(await page.locator('#follow-rims').count(), 0);
  assert.equal(await page.isChecked('#follow-creases'), false);
});

const cones = () =>
  it.page.locator('tr[data-cone]').evaluateAll(
    (rows) =>
    rows.map((row) => `${row.querySelector('td').innerText} ${row.querySelector('input').value}`).sort(), // prettier-ignore
  );

/** A cube with a map along its creases; returns the middle of the 3D view, where its first cone is. */
async function mapped() {
  const { page } = it;
  await openFiles(it, { 'cube.obj': toObj(cubeMesh(6)) });
  await page.click('#follow-creases');
  await page.waitForSelector('#features-note');
  await run(it);
  await page.click('tr[data-cone="0"] [aria-label$="frame"]');
  await settled(page);
  const box = await page.locator('#view').boundingBox();
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

async function setK(i, k) {
  const input = it.page.locator(`tr[data-cone="${i}"] input`);
  await input.fill(String(k));
  await input.press('Enter');
}

test('cones that are placed along features stay where they are put, and the copied command has them', async (t) => {
  const { page } = it;
  await openFiles(it, { 'square.obj': toObj(flatSquare(10)) });
  await page.click('#follow-rims');
  await run(it);
  assert.equal((await cones()).length, 0);
  assert.equal(await page.locator('#keep-cones').count(), 0);
  const box = await page.locator('#view').boundingBox();
  const { x, y } = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  await page.click('#tool-place');
  await page.mouse.click(x - 50, y);
  await page.mouse.click(x + 50, y);
  await setK(0, 3);
  await setK(1, 5);
  await state(page, 'stale');
  const placed = await cones();
  assert.equal(placed.length, 2);
  assert.equal(await page.isChecked('#keep-cones'), true);
  await settled(page);
  await page.screenshot({ path: path.join(shots, 'features-own.png') });
  assert.deepEqual(await violations(page, '#panel-solve'), []);
  await run(it);
  assert.match(await statusText(page), /lines follow 1 rim/);
  assert.deepEqual(await cones(), placed);
  await settled(page);
  await page.screenshot({ path: path.join(shots, 'features-own-run.png') });
  await page.click('#solve-more > summary');
  await page.click('#copy-command');
  await statusSays(it, /Copied/);
  const command = await page.evaluate(() => navigator.clipboard.readText());
  assert.match(command, /square\.obj --rims --q 4 --cone \d+:3 --cone \d+:5 /);
  const saved = await saveAs(it, 'same');
  const program = commandLine(t);
  if (!program) return;
  const file = path.join(it.folder, 'own.obj');
  writeFileSync(file, saved.bytes);
  const verified = spawnSync(program, ['verify', file, '--rims', ...placed.flatMap((cone) => ['--cone', cone.replace(' ', ':')])], { encoding: 'utf8' }); // prettier-ignore
  assert.equal(verified.status, 0, verified.stdout + verified.stderr);
});

test('cones that have no map along features are refused before Run, and Run can choose others', async () => {
  const { page } = it;
  await mapped();
  const chosen = await cones();
  await setK(0, 2);
  await setK(1, 4);
  await state(page, 'stale');
  await page.getByRole('button', { name: 'Let Run choose the cones' }).click();
  await state(page, 'certified');
  assert.deepEqual(await cones(), chosen);
  assert.equal(await page.isChecked('#keep-cones'), false);
});

test('a click on a model whose map is to be symmetric places a pair, and a drag moves both', async () => {
  const { page } = it;
  await openFiles(it, { 'arch.obj': toObj(arch(10)) });
  await page.click('#symmetric');
  await page.waitForSelector('#features-note');
  await settled(page);
  const box = await page.locator('#view').boundingBox();
  const [x, y] = [box.x + box.width / 2 + 60, box.y + box.height / 2];
  await page.click('#tool-place');
  await page.mouse.click(x, y);
  assert.equal((await cones()).length, 2);
  await setK(0, 5);
  const placed = await cones();
  assert.deepEqual(placed.map((cone) => cone.split(' ')[1]), ['5', '5']); // prettier-ignore
  await page.click('tr[data-cone="0"] [aria-label$="frame"]');
  await settled(page);
  await page.click('#tool-place');
  const at = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  await page.mouse.move(at.x + 40, at.y + 30, { steps: 5 });
  await page.mouse.up();
  const moved = await cones();
  assert.ok(
    moved.every((cone) => !placed.includes(cone)),
    `${placed} → ${moved}`,
  );
  await run(it);
  assert.match(await statusText(page), /lines follow 1 rim and the plane of symmetry/);
  assert.deepEqual(await cones(), moved);
  await page.keyboard.press('Escape');
  await settled(page);
  await page.screenshot({ path: path.join(shots, 'symmetric-pair.png') });
});
