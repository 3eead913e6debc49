// Five sizes of the window: nothing to scroll sideways, nothing past the side panel's padding or too small to hit; pictures.

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

/** What reaches beyond the right padding of its section in the side panel. */
function past() {
  return [...document.querySelectorAll('aside details[id^=panel-]')]
    .filter((section) => section.checkVisibility())
    .flatMap((section) => {
      const end = section.getBoundingClientRect().right - parseFloat(getComputedStyle(section).paddingRight); // prettier-ignore
      return [...section.querySelectorAll('select, dd, dd button, p, label')]
        .filter((one) => one.checkVisibility() && one.getBoundingClientRect().right > end + 1)
        .map((one) => `${one.id || one.textContent.trim()}: ${one.getBoundingClientRect().right} > ${end}`); // prettier-ignore
    });
}

test('five sizes, down to 320 pixels', async () => {
  const { page } = it;
  await example(it, 'cube');
  await run(it);
  for (const [width, height] of [
    [1440, 900],
    [1024, 768],
    [768, 1024],
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
    assert.deepEqual(await page.evaluate(past), [], `${width}`);
  }
  assert.deepEqual(await violations(page), []);
});
