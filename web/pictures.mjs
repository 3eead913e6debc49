// Renders the pictures of the examples that the empty page shows, and those of the page in README and
// guide: node web/pictures.mjs, after the page was built. The pictures are committed.

import { mkdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { startChromium } from './chromium.mjs';
import { examples } from './examples.mjs';
import { serve } from './serve.mjs';

const folder = path.join(import.meta.dirname, 'public/thumbnails');
const images = path.join(import.meta.dirname, '../docs/images');
const patterns = { sphere: 'hex', cube: 'brick', torus: 'wood', pipe: 'brick', pebble: 'checker', rings: 'grid', figure: 'plaid' }; // prettier-ignore
const tiles = { sphere: 16, cube: 10, torus: 9, pipe: 14, pebble: 16, rings: 22, figure: 12 };

mkdirSync(folder, { recursive: true });
const { url, server } = await serve({ port: 0 });
const browser = await startChromium('--use-angle=swiftshader', '--enable-unsafe-swiftshader');
const page = await browser.newPage({ viewport: { width: 1100, height: 700 }, reducedMotion: 'reduce', serviceWorkers: 'block' }); // prettier-ignore
/** Waits until nothing has been left to draw for some frames. */
const drawn = () =>
  page.evaluate(async () => {
    const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));
    for (let still = 0; still < 10;) {
      await frame();
      still = document.querySelector('[data-pending]') ? 0 : still + 1;
    }
  });
for (const { id } of examples()) {
  await page.goto('about:blank');
  await page.goto(`${url}#pattern=${patterns[id]}&tiles=${tiles[id]}`);
  await page.waitForSelector('body[data-state="empty"]');
  await page.click(`[data-card="${id}"]`);
  await page.waitForSelector('body[data-state="ready"]');
  await page.click('#run');
  await page.waitForSelector('body[data-state="certified"]');
  if ((await page.getAttribute('#seams', 'aria-pressed')) === 'true') await page.click('#seams');
  await page.evaluate(() => {
    const view = document.querySelector('#view');
    for (const one of document.body.querySelectorAll('*')) {
      if (one.contains(view)) one.style.background = 'transparent';
      else if (!view.contains(one)) one.style.visibility = 'hidden';
    }
    document.documentElement.style.background = document.body.style.background = 'transparent';
    Object.assign(view.style, { position: 'fixed', inset: '0', width: '240px', height: '240px', zIndex: 99 }); // prettier-ignore
  });
  await drawn();
  const clip = { x: 0, y: 0, width: 240, height: 240 };
  writeFileSync(
    path.join(folder, `${id}.png`),
    await page.screenshot({ clip, omitBackground: true }),
  );
}

/** The page as it is after Run. */
async function wholePage(id, hash, file) {
  await page.setViewportSize({ width: 1440, height: 860 });
  await page.goto('about:blank');
  await page.goto(`${url}#example=${id}${hash}`);
  await page.waitForSelector('body[data-state="ready"]');
  await page.click('#run');
  await page.waitForSelector('body[data-state="certified"]');
  await drawn();
  writeFileSync(path.join(images, file), await page.screenshot());
}
await wholePage('pebble', '&pattern=checker', 'page.png');
await wholePage('cube', '&pattern=checker', 'guide-result.png');
await browser.close();
server.close();
