// Starts the page: the document, the solver, the two views, and what connects them.

import { render } from 'lit';
import { App } from './state/app';
import { filesOfDrop } from './state/files';
import { open } from './state/open';
import { watchCones } from './state/check';
import { replaceAsked } from './state/edit';
import { createSolver, keepOffline } from './state/solver';
import { addressOf, readAddress } from './state/url';
import { Controls } from './ui/controls';
import { Keyboard } from './ui/keyboard';
import { page } from './ui/page';
import { Pointer } from './ui/pointer';
import { listenToSplitter } from './ui/splitter';
import { Views } from './ui/views';
import { MapView } from './view/map_view';
import { SurfaceView } from './view/surface_view';
import { oneOfEach } from './view/warm';

const app = new App();
const ui = new Controls(app);
const root = document.getElementById('page')!;

function draw(): void {
  render(page(app, ui), root);
  document.body.dataset.state = app.state;
  for (const dialog of root.querySelectorAll('dialog')) if (!dialog.open) dialog.showModal();
  views?.update();
  rememberAddress();
}

let hadSurface = false;
let addressTimer: ReturnType<typeof setTimeout> | undefined;
function rememberAddress(): void {
  clearTimeout(addressTimer);
  if (app.phase === 'empty' && hadSurface) history.replaceState(null, '', location.pathname);
  hadSurface = app.surface !== undefined;
  if (!hadSurface) return;
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
  const { cones, camera, q, turnings = [], handles = [] } = asked;
  const isAsking = cones !== undefined || turnings.length + handles.length > 0;
  if (!isAsking && !camera) return;
  let isApplied = false;
  app.subscribe(() => {
    if (isApplied || !app.surface || app.phase !== 'editing') return;
    isApplied = true;
    const isFitting = (cones ?? []).every(({ vertex }) => vertex < app.surface!.vertexCount);
    if (isAsking && isFitting && app.asked.cones.length === 0) {
      const from = (pairs: [number, number][], list: readonly (number | null)[]) =>
        list.map((n, i) => pairs.find(([at]) => at === i)?.[1] ?? n);
      const more = {
        turnings: from(turnings, app.asked.turnings),
        handles: from(handles, app.asked.handles),
      };
      const all = { q: q ?? app.asked.q, cones: cones ?? [], ...more };
      replaceAsked(app, all, 'cones of the address');
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
    void ui
      .surfaceView!.warm(oneOfEach(true))
      .then(() => idle(() => void ui.mapView!.warm(oneOfEach(false))));
  });
}

let views: Views | undefined;

/** The graphics card may take a picture away at any time; it comes back by itself. */
function sayContext(isLost: boolean): void {
  if (isLost) app.say('The graphics card took the picture away. It comes back by itself.', 'error');
  else app.say('The picture is back. Cones, result and history were never lost.', 'good');
}

async function start(): Promise<void> {
  draw();
  ui.surfaceView = new SurfaceView(root.querySelector<HTMLCanvasElement>('#view')!);
  ui.mapView = new MapView(root.querySelector<HTMLCanvasElement>('#map')!);
  for (const view of [ui.surfaceView, ui.mapView]) view.onContext = sayContext;
  const keyboard = new Keyboard(app, ui);
  views = new Views(app, ui, () => {
    keyboard.reset();
    ui.handlesShown = false;
  });
  new Pointer(app, ui);
  listenToSplitter(root.querySelector<HTMLElement>('#splitter')!, ui);
  listenToDrops();
  ui.surfaceView.orbit.controls.addEventListener('end', rememberAddress);
  app.subscribe(draw);
  watchCones(app);
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
