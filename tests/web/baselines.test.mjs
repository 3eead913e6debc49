// How the page looks: five states beside their pictures in tests/web/baselines, at most 2 % of the pixels
// apart. HGP_BASELINES=write makes the pictures anew; look at them before they are committed.

import assert from 'node:assert/strict';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import pixelmatch from 'pixelmatch';
import pngjs from 'pngjs';
import { example, root, run, settled, shots, useBrowser } from './support.mjs';

const folder = path.join(root, 'tests/web/baselines');
const isWriting = process.env.HGP_BASELINES === 'write';
const most = 0.02;

async function compare(page, name) {
  await page.mouse.move(0, 0);
  await settled(page);
  const bytes = await page.screenshot();
  const file = path.join(folder, `${name}.png`);
  if (isWriting) {
    mkdirSync(folder, { recursive: true });
    return writeFileSync(file, bytes);
  }
  assert.ok(existsSync(file), `${file} is not there`);
  const [seen, wanted] = [bytes, readFileSync(file)].map((one) => pngjs.PNG.sync.read(one));
  assert.deepEqual([seen.width, seen.height], [wanted.width, wanted.height]);
  const difference = new pngjs.PNG({ width: seen.width, height: seen.height });
  const { width, height } = seen;
  const count = pixelmatch(seen.data, wanted.data, difference.data, width, height, {
    threshold: 0.15,
  });
  if (count > most * width * height) {
    writeFileSync(path.join(shots, `${name}-difference.png`), pngjs.PNG.sync.write(difference));
  }
  assert.ok(count <= most * width * height, `${name}: ${((100 * count) / width / height).toFixed(1)} % differ`); // prettier-ignore
}

const wide = useBrowser({ viewport: { width: 1280, height: 800 }, antialias: true });

wide.test('empty, loaded, certified in the light and in the dark look as they should', async () => {
  const { page } = wide;
  await page.waitForSelector('.turning[data-drawn]');
  await page.waitForFunction(() => [...document.images].every((image) => image.complete));
  await compare(page, 'empty');
  await example(wide, 'cube');
  await compare(page, 'loaded');
  await run(wide);
  await compare(page, 'certified-light');
  await page.emulateMedia({ colorScheme: 'dark', reducedMotion: 'reduce' });
  await compare(page, 'certified-dark');
});

const phone = useBrowser({ viewport: { width: 390, height: 844 }, antialias: true, hasTouch: true, isMobile: true }); // prettier-ignore

phone.test('on a phone, too', async () => {
  await example(phone, 'cube');
  await run(phone);
  await compare(phone.page, 'phone');
});
