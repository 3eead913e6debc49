// Starts the page: the document, the solver, the two views, and what connects them.

import { render } from 'lit';
import { Color, type Group } from 'three';
import { App } from './state/app';
import { filesOfDrop } from './state/files';
import { open } from './state/open';
import { replaceAsked } from './state/edit';
import { createSolver, keepOffline } from './state/solver';
import { addressOf, readAddress } from './state/url';
import { Controls } from './ui/controls';
import { Keyboard } from './ui/keyboard';
import { page } from './ui/page';
import { Pointer } from './ui/pointer';
import { listenToSplitter } from './ui/splitter';
import { MapView } from './view/map_view';
import { loadOriginal } from './view/original';
import { SurfaceView } from './view/surface_view';
import { oneOfEach } from './view/warm';
import type { Palette } from './view/material';

const app = new App();
const ui = new Controls(app);
const root = document.getElementById('page')!;

const palettes: Record<'light' | 'dark', Palette> = {
  light: { paper: new Color('#e9edf2'), ink: new Color('#1d3f63'), second: new Color('#f3b63f') },
  dark: { paper: new Color('#b9c4d0'), ink: new Color('#14304d'), second: new Color('#f0b038') },
};

function draw(): void {
  render(page(app, ui), root);
  document.body.dataset.state = app.state;
  for (const dialog of root.querySelectorAll('dialog')) if (!dialog.open) dialog.showModal();
  updateViews();
}

let original: { of: unknown; group?: Group } | undefined;

/** Reads the written file with its materials, once, when that is what should be seen. */
function updateOriginal(): void {
  const { shown, look, info, files } = app;
  if (look.pattern !== 'material' || !shown) return ui.surfaceView!.setOriginal(undefined);
  if (original?.of === shown) return ui.surfaceView!.setOriginal(original.group);
  const own: typeof original = (original = { of: shown });
  loadOriginal(shown.written.files, files, info?.surface ?? 0)
    .then((group) => {
      own.group = group;
      app.changed();
    })
    .catch((error: Error) => app.say(`The materials cannot be shown: ${error.message}`, 'error'));
}

let known = {} as { surface?: unknown; shown?: unknown; look?: unknown; key?: string };

function updateViews(): void {
  const { surfaceView, mapView } = ui;
  if (!surfaceView || !mapView) return;
  const { surface, shown, look, asked, selected, budget } = app;
  const q = shown?.asked.q ?? asked.q;
  const isStale = app.state === 'stale';
  if (surface !== known.surface) {
    keyboard.reset();
    ui.handlesShown = false;
  }
  const isOther = surface !== known.surface || shown !== known.shown;
  if (isOther) {
    surfaceView.setModel(surface, shown);
    mapView.setModel(surface, shown);
  }
  const key = `${isStale} ${q} ${ui.isDark}`;
  if (isOther || look !== known.look || key !== known.key) {
    const palette = palettes[ui.isDark ? 'dark' : 'light'];
    surfaceView.setLook(look, q, isStale, palette);
    mapView.setLook(look, q, isStale, palette);
  }
  updateOriginal();
  const cones = JSON.stringify([asked.cones, asked.q, selected, budget?.cones]);
  if (isOther || cones !== knownCones) {
    const bad = budget?.cones.map(({ isGood }) => !isGood) ?? [];
    surfaceView.setCones(asked, bad, selected);
    mapView.setCones(asked, bad, selected);
    knownCones = cones;
  }
  known = { surface, shown, look, key };
  rememberAddress();
}
let knownCones = '';

let addressTimer: ReturnType<typeof setTimeout> | undefined;
function rememberAddress(): void {
  if (!app.surface) return;
  clearTimeout(addressTimer);
  addressTimer = setTimeout(() => {
    history.replaceState(null, '', addressOf(app, ui.surfaceView?.orbit.toText()));
  }, 400);
}

/** What the address asked for, once there is a model that it can be about. */
function applyAddress(): void {
  const asked = readAddress(location.hash);
  const { pattern = app.look.pattern, overlay = app.look.overlay, tiles = app.look.tiles } = asked;
  app.look = { ...app.look, pattern, overlay, tiles };
  if (asked.q) app.begin({ ...app.asked, q: asked.q });
  const { cones, camera, q } = asked;
  if (!cones && !camera) return;
  let isApplied = false;
  app.subscribe(() => {
    if (isApplied || !app.surface || app.phase !== 'editing') return;
    isApplied = true;
    const isFitting = cones?.every(({ vertex }) => vertex < app.surface!.vertexCount);
    if (cones && isFitting && app.asked.cones.length === 0) {
      replaceAsked(app, { ...app.asked, q: q ?? app.asked.q, cones }, 'cones of the address');
    }
    if (camera) ui.surfaceView?.orbit.fromText(camera);
  });
}

function listenToDrops(): void {
  let depth = 0;
  const mark = (): void => void document.body.classList.toggle('over', depth > 0);
  document.addEventListener('dragenter', () => {
    depth += 1;
    mark();
  });
  document.addEventListener('dragleave', () => {
    depth -= 1;
    mark();
  });
  document.addEventListener('dragover', (event) => event.preventDefault());
  document.addEventListener('drop', (event) => {
    event.preventDefault();
    depth = 0;
    mark();
    if (event.dataTransfer && app.client) {
      void filesOfDrop(event.dataTransfer).then((files) => open(app, files));
    }
  });
}

/** While nobody waits for anything. */
function warmViews(): void {
  const idle = globalThis.requestIdleCallback ?? ((act: () => void) => setTimeout(act, 300));
  idle(() => {
    ui.surfaceView!.warm(oneOfEach(true));
    idle(() => ui.mapView!.warm(oneOfEach(false)));
  });
}

let keyboard: Keyboard;

async function start(): Promise<void> {
  draw();
  ui.surfaceView = new SurfaceView(root.querySelector<HTMLCanvasElement>('#view')!);
  ui.mapView = new MapView(root.querySelector<HTMLCanvasElement>('#map')!);
  keyboard = new Keyboard(app, ui);
  new Pointer(app, ui);
  listenToSplitter(root.querySelector<HTMLElement>('#splitter')!, ui);
  listenToDrops();
  ui.surfaceView.orbit.controls.addEventListener('end', rememberAddress);
  app.subscribe(draw);
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => app.changed());
  addEventListener('beforeunload', (event) => {
    if (app.phase === 'running' || app.isUnsaved) event.preventDefault();
  });
  setInterval(() => app.progress && app.changed(), 1000); // the clock of a run
  applyAddress();
  try {
    app.client = await createSolver();
    app.phase = 'empty';
    performance.mark('hgp-ready');
    keepOffline();
    warmViews();
  } catch (error) {
    app.say(`The solver could not start: ${(error as Error).message}`, 'error');
  }
  app.changed();
}

void start();
