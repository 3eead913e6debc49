// Four sizes of the window: nothing to scroll sideways, nothing too small to hit; pictures.

import assert from 'node:assert/strict';
import path from 'node:path';
import { example, run, settled, shots, useBrowser, violations } from './support.mjs';

const it = useBrowser({ viewport: { width: 1440, height: 900 }, deviceScaleFactor: 1 });
const { test } = it;

/** Buttons under 24 pixels. */
function tooSmall() {
  return [...document.querySelectorAll('button, select, input:not([hidden])')]
    .filter((element) => element.checkVisibility())
    .map((element) => [element.id || element.textContent.trim(), element.getBoundingClientRect()])
    .filter(([, box]) => box.width > 1 && (box.width < 24 || box.height < 24))
    .filter(([, box]) => box.width !== box.height || box.width < 16) // ticks have their label
    .map(([name, box]) => `${name}: ${box.width} × ${box.height}`);
}

test('three sizes, and 320 pixels without sideways scrolling', async () => {
  const { page } = it;
  await example(it, 'sphere');
  await run(it);
  for (const [width, height] of [
    [1440, 900],
    [1024, 768],
    [390, 844],
    [320, 640],
  ]) {
    await page.setViewportSize({ width, height });
    await settled(page);
    await page.screenshot({ path: path.join(shots, `size-${width}.png`) });
    const wide = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(wide <= width, `${width}: ${wide}`);
    // Everything that can be pressed is large enough to be hit, and the model is not covered.
    const small = await page.evaluate(tooSmall);
    assert.deepEqual(small, [], `${width}`);
  }
  assert.deepEqual(await violations(page), []);
});
