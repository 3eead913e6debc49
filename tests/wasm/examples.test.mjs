// The example pages of three.js and glTF-Transform, built by Vite and used in a browser.

import assert from 'node:assert/strict';
import { cpSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import test, { after } from 'node:test';
import { NodeIO } from '@gltf-transform/core';
import { build } from 'vite';
import { startChromium } from '../../web/chromium.mjs';
import { cubeMesh, toGlb } from '../support/meshes.mjs';
import { createProject, serve } from './project.mjs';
import { root } from './support.mjs';

const { folder: project } = createProject('examples');
const browser = await startChromium('--use-angle=swiftshader');
after(() => browser.close());

/** Builds the example, opens it, and hands the page over. */
async function withPage(name, use) {
  cpSync(path.join(root, 'examples', name), path.join(project, name), { recursive: true });
  await build({
    root: path.join(project, name),
    configFile: false,
    logLevel: 'error',
    build: { target: 'es2022' },
  });
  const server = await serve(path.join(project, name, 'dist'));
  const page = await browser.newPage({ viewport: { width: 480, height: 360 } });
  const trouble = [];
  page.on('pageerror', (error) => trouble.push(String(error)));
  try {
    await page.goto(server.origin);
    await use(page);
    assert.deepEqual(trouble, []);
  } finally {
    await page.close();
    server.close();
  }
}

function coloursIn(data) {
  const seen = { red: 0, blue: 0 };
  for (let i = 0; i < data.length; i += 4) {
    const [r, g, b] = data.subarray(i, i + 3);
    if (r > 150 && g < 90 && b < 110) seen.red += 1;
    if (b > 90 && b > r + 30) seen.blue += 1;
  }
  return seen;
}

test('three.js: a textured knot with its seams', () =>
  withPage('three', async (page) => {
    await page.waitForFunction(() => document.title !== '', undefined, { timeout: 60000 });
    assert.equal(await page.title(), 'certified');
    assert.match(await page.textContent('p'), /\d+ triangles, \d+ seam edges: certified/);
    // The picture has the pattern's two colours and the red of the seams, which the knot hides for a while as
    // it turns.
    const { PNG } = await import('pngjs');
    let seen = {};
    for (let shots = 0; shots < 20 && !(seen.red > 50 && seen.blue > 2000); shots += 1) {
      await page.waitForTimeout(500);
      const shot = await page.screenshot({ path: path.join(project, 'three.png') });
      seen = coloursIn(PNG.sync.read(shot).data);
    }
    assert.ok(seen.red > 50 && seen.blue > 2000, JSON.stringify(seen));
  }));

test('glTF-Transform: the same file with one more set', () =>
  withPage('gltf-transform', async (page) => {
    const file = path.join(project, 'cube.glb');
    writeFileSync(file, toGlb([cubeMesh(4)]));
    await page.setInputFiles('input', file);
    await page.waitForFunction(() => document.title !== '', undefined, { timeout: 60000 });
    assert.equal(await page.title(), 'done', await page.textContent('[role=status]'));
    const [download] = await Promise.all([page.waitForEvent('download'), page.click('a')]);
    const written = await new NodeIO().read(await download.path());
    const [primitive] = written.getRoot().listMeshes()[0].listPrimitives();
    assert.ok(primitive.listSemantics().some((name) => name.startsWith('TEXCOORD_')));
  }));
