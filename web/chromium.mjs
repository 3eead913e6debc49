// Starts a Chromium without a window, for the tests of the page and its pictures. Debian's headless shell needs a third
// fewer packages than the whole browser and less processor time to draw.

import { existsSync } from 'node:fs';
import { chromium } from 'playwright-core';

const programs = ['chromium-headless-shell', 'chromium', 'google-chrome'];

/** @param {string[]} flags  more arguments of the command line */
export function startChromium(...flags) {
  const executablePath = programs.map((name) => `/usr/bin/${name}`).find(existsSync);
  if (!executablePath)
    throw new Error(`None of ${programs.join(', ')} is in /usr/bin; scripts/setup installs one.`);
  const args = ['--no-sandbox', '--disable-background-networking', ...flags];
  return chromium.launch({ executablePath, args });
}
