// "Five minutes with" JavaScript and three.js, and the examples of the package's README that need other packages,
// from an empty home, exactly as printed. What `npm install` asks for comes from what is installed here.

import assert from 'node:assert/strict';
import { mkdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import test, { after } from 'node:test';
import { execFile } from 'node:child_process';
import { promisify } from 'node:util';
import { NodeIO } from '@gltf-transform/core';
import { startChromium } from '../../web/chromium.mjs';
import { emptyHome, root, runPage, startServer } from '../support/page.mjs';
import { startRegistry } from '../support/registry.mjs';
import { cubeMesh, toGlb } from '../support/meshes.mjs';
import { example } from './project.mjs';

const registry = await startRegistry(path.join(root, 'node_modules'));
after(() => registry.close());
const settings = { npm_config_registry: registry.origin, npm_config_update_notifier: 'false' };

async function inEmptyHome(use) {
  const { home, remove } = emptyHome();
  try {
    return await use(home);
  } finally {
    remove();
  }
}

test('docs/five-minutes/javascript.md', () =>
  inEmptyHome((home) => runPage('five-minutes/javascript.md', home, settings)));

test('docs/five-minutes/three.md: the page that it ends with shows a textured knot', () =>
  inEmptyHome(async (home) => {
    const { server, ...where } = await runPage('five-minutes/three.md', home, settings);
    const { url, stop } = await startServer(server, where);
    const browser = await startChromium('--use-angle=swiftshader');
    try {
      const page = await browser.newPage({ viewport: { width: 480, height: 360 } });
      const trouble = [];
      page.on('pageerror', (error) => trouble.push(String(error)));
      await page.goto(url);
      await page.waitForFunction(() => /certified/.test(document.title), undefined, {
        timeout: 60000,
      });
      assert.equal(await page.title(), 'certified');
      const { PNG } = await import('pngjs');
      const shot = path.join(root, 'build/package-tests/three-page.png');
      const seen = { red: 0, blue: 0 };
      // The model turns: at some moment a seam is in front.
      for (let tries = 0; tries < 40 && seen.red <= 50; tries++) {
        await page.waitForTimeout(500);
        const { data } = PNG.sync.read(await page.screenshot({ path: shot }));
        seen.red = seen.blue = 0;
        for (let i = 0; i < data.length; i += 4) {
          const [r, g, b] = data.subarray(i, i + 3);
          if (r > 150 && g < 90 && b < 110) seen.red += 1;
          if (b > 90 && b > r + 30) seen.blue += 1;
        }
      }
      assert.ok(seen.red > 50 && seen.blue > 2000, JSON.stringify(seen));
      assert.deepEqual(trouble, []);
    } finally {
      await browser.close();
      stop();
    }
  }));

test('the three.js and glTF-Transform examples of the README run as printed', () =>
  inEmptyHome(async (home) => {
    const folder = path.join(home, 'examples');
    mkdirSync(folder);
    const env = { PATH: process.env.PATH, HOME: home, ...settings };
    const run = async (command, ...args) =>
      (await promisify(execFile)(command, args, { cwd: folder, env })).stdout.trim();
    const packed = await run('npm', 'pack', '--silent', path.join(home, 'hgp/build/package'));
    writeFileSync(path.join(folder, 'package.json'), '{ "type": "module" }');
    await run('npm', 'install', '--silent', 'three', '@gltf-transform/core', `./${packed}`);
    writeFileSync(path.join(folder, 'three.js'), example('## three.js'));
    assert.equal(await run('node', 'three.js'), 'true');
    writeFileSync(path.join(folder, 'model.glb'), toGlb([cubeMesh(4), cubeMesh(3)]));
    writeFileSync(path.join(folder, 'gltf.js'), example('## glTF-Transform'));
    await run('node', 'gltf.js');
    const written = await new NodeIO().read(path.join(folder, 'mapped.glb'));
    const sets = written.getRoot().listMeshes().map((mesh) =>
      mesh.listPrimitives()[0].listSemantics().filter((name) => name.startsWith('TEXCOORD_')),
    ); // prettier-ignore
    assert.ok(sets.length === 2 && sets.every((names) => names.length > 0), JSON.stringify(sets));
  }));
