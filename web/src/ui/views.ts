// Keeps the two views up to date with what the page is about: one after the other, each in a task of
// its own where there is much to do.

import { Color, type Group } from 'three';
import type { App } from '../state/app';
import { pause } from '../state/breath';
import type { Palette } from '../view/material';
import { loadOriginal } from '../view/original';
import type { Controls } from './controls';

const palettes: Record<'light' | 'dark', Palette> = {
  light: { paper: new Color('#e9edf2'), ink: new Color('#1d3f63'), second: new Color('#f3b63f') },
  dark: { paper: new Color('#b9c4d0'), ink: new Color('#14304d'), second: new Color('#f0b038') },
};

export class Views {
  readonly #app: App;
  readonly #ui: Controls;
  /** Told of another surface. */
  readonly #onSurface: () => void;
  #known = {} as { surface?: unknown; shown?: unknown; look?: unknown; key?: string };
  #cones = '';
  #original?: { of: unknown; group?: Group };
  #isBusy = false;
  #isAgain = false;

  constructor(app: App, ui: Controls, onSurface: () => void) {
    this.#app = app;
    this.#ui = ui;
    this.#onSurface = onSurface;
  }

  update(): void {
    if (this.#isBusy) this.#isAgain = true;
    else void this.#run();
  }

  async #run(): Promise<void> {
    this.#isBusy = true;
    document.body.dataset.pending = '';
    do {
      this.#isAgain = false;
      await this.#once();
    } while (this.#isAgain);
    this.#isBusy = false;
    delete document.body.dataset.pending;
  }

  async #once(): Promise<void> {
    const surfaceView = this.#ui.surfaceView!;
    const mapView = this.#ui.mapView!;
    const { surface, shown, look, asked, selected, budget } = this.#app;
    const q = shown?.asked.q ?? asked.q;
    const isStale = this.#app.state === 'stale';
    const known = this.#known;
    if (surface !== known.surface) this.#onSurface();
    const isOther = surface !== known.surface || shown !== known.shown;
    const key = `${isStale} ${q} ${this.#ui.isDark}`;
    const isLook = isOther || look !== known.look || key !== known.key;
    const cones = JSON.stringify([asked.cones, asked.q, selected, budget?.cones]);
    const isCones = isOther || cones !== this.#cones;
    this.#known = { surface, shown, look, key };
    this.#cones = cones;
    const palette = palettes[this.#ui.isDark ? 'dark' : 'light'];
    const bad = budget?.cones.map(({ isGood }) => !isGood) ?? [];
    for (const view of [surfaceView, mapView]) {
      if (isOther) await pause(); // the page's own text first
      if (isOther) view.setModel(surface, shown);
      if (isOther) await pause();
      if (isLook) view.setLook(look, q, isStale, palette);
      if (isCones) view.setCones(asked, bad, selected);
    }
    this.#updateOriginal();
  }

  /** Reads the written file with its materials, once, when that is what should be seen. */
  #updateOriginal(): void {
    const app = this.#app;
    const surfaceView = this.#ui.surfaceView!;
    const { shown, look, info, files } = app;
    if (look.pattern !== 'material' || !shown) return surfaceView.setOriginal(undefined);
    if (this.#original?.of === shown) return surfaceView.setOriginal(this.#original.group);
    const own: { of: unknown; group?: Group } = (this.#original = { of: shown });
    loadOriginal(shown.written.files, files, info?.surface ?? 0)
      .then((group) => {
        own.group = group;
        app.changed();
      })
      .catch((error: Error) => app.say(`The materials cannot be shown: ${error.message}`, 'error'));
  }
}
