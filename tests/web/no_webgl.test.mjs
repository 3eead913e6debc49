// A browser without WebGL 2: the page says so once, and does everything but draw.

import assert from 'node:assert/strict';
import { cubeMesh } from '../support/meshes.mjs';
import { openMesh, run, saveAs, statusText, useBrowser } from './support.mjs';

const it = useBrowser({ flags: ['--disable-3d-apis'] });

it.test(
  'without WebGL maps are made, verified and saved, and the page says that none is drawn',
  async () => {
    it.allowed = [/WebGL/];
    const { page } = it;
    await page.reload();
    await page.waitForSelector('#status.error');
    assert.match(await statusText(page), /has no WebGL 2, so models are not drawn/);
    await openMesh(it, cubeMesh(4));
    await run(it);
    const { bytes } = await saveAs(it, 'same');
    assert.match(String(bytes), /^vt /m);
  },
);
