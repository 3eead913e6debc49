// Starts the page: the document, the workers, the two views, and what connects them.

import { effect } from '@preact/signals-core';
import type { App } from './actions/app';
import { attempt } from './actions/app';
import { watchEdits } from './actions/follow_edits';
import { watchCones } from './actions/check_cones';
import { watchOpposite } from './actions/opposite';
import { followLink } from './actions/follow_link';
import { watchMemory } from './actions/free_unused';
import { notifyAtEnd } from './actions/notify_at_end';
import { exampleById, openExample } from './actions/open';
import { refreshRecent } from './actions/recent';
import { flushAddress } from './actions/remember';
import { watchThumbnails } from './actions/thumbnails';
import { readHash } from './formats/hash_state';
import { ignoreSecondClicks } from './input/double_click';
import { listenToDrops } from './input/drop';
import { Keyboard } from './input/keyboard';
import { Pointer } from './input/pointer';
import { listenToSplitter } from './input/splitter';
import { Document } from './model/document';
import { UiState } from './model/ui_state';
import { GeometryClient } from './services/geometry_client';
import { createSolver, keepOffline } from './services/solver';
import type { Panel } from './panels/panel';
import './panels/app_page';
import './panels/top_bar';

const app: App = {
  doc: new Document(),
  ui: new UiState(),
  geometry: new GeometryClient(),
  client: undefined,
  views: undefined,
};
const { doc, ui } = app;

/** Keeps the state of the page in its address, so that it can be shared. */
function rememberState(): void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  let hadModel = false;
  const soon = (): void => {
    clearTimeout(timer);
    timer = setTimeout(() => flushAddress(app), 400);
  };
  effect(() => {
    const { model } = doc;
    void [doc.look, doc.prescription, doc.solve, doc.features];
    clearTimeout(timer);
    if (!model && hadModel) history.replaceState(null, '', location.pathname);
    hadModel = model !== undefined;
    if (model) soon();
  });
  app.views?.model.orbit.controls.addEventListener('end', soon);
}

type Drawing = typeof import('./views/drawing');

/** Prepares the views while the page is idle. */
function warmViews({ model, uv }: NonNullable<App['views']>, { oneOfEach }: Drawing): void {
  const idle = globalThis.requestIdleCallback ?? ((act: () => void) => setTimeout(act, 300));
  const warmUv = (): void => void uv.warm(oneOfEach(false)).catch(() => undefined);
  idle(() => {
    model.warm(oneOfEach(true)).then(
      () => idle(warmUv),
      () => undefined,
    );
  });
}

/** Tells the user that a WebGL context was lost; it is restored automatically. */
function sayContext(isLost: boolean): void {
  if (isLost)
    doc.say('The graphics card lost the picture. It will be restored automatically.', 'error');
  else doc.say('The picture is back. Cones, result and history were not lost.', 'good');
}

function connectViews(
  { ModelView, UvView, ViewUpdates }: Drawing,
  page: Panel,
  keyboard: Keyboard,
): void {
  const model = new ModelView(page.querySelector<HTMLCanvasElement>('#view')!);
  const uv = new UvView(page.querySelector<HTMLCanvasElement>('#map')!);
  model.onContext = uv.onContext = sayContext;
  app.views = { model, uv };
  uv.onScale = (pixels) => (ui.mapScale = pixels);
  const onSurface = (): void => {
    keyboard.reset();
    ui.handlesShown = false;
  };
  new ViewUpdates({ doc, ui, geometry: app.geometry, model, uv, onSurface });
  new Pointer(app, model, uv);
  listenToSplitter(page.querySelector<HTMLElement>('#splitter')!, ui);
}

/** Reports errors that nothing has caught. */
function catchTheRest(): void {
  const sayIt = (reason: unknown): void =>
    doc.say(
      `Something went wrong: ${reason instanceof Error ? reason.message : String(reason)}`,
      'error',
    );
  addEventListener('unhandledrejection', (event) => sayIt(event.reason));
  // Without an error: the browser's own remarks, such as on observers of sizes.
  addEventListener('error', ({ error }: { error?: unknown }) => {
    if (error) sayIt(error);
  });
}

async function start(): Promise<void> {
  catchTheRest();
  ignoreSecondClicks(document);
  listenToDrops(app); // at once: the browser would leave the page for the file
  const page = document.createElement('hgp-page') as Panel;
  page.app = app;
  document.getElementById('page')!.replaceChildren(page); // instead of the first screen
  effect(() => void (document.body.dataset.state = doc.stateName));
  await page.updateComplete;
  const keyboard = new Keyboard(app);
  // The page is on the screen; what draws and what solves are loaded at the same time.
  const [drawing, client] = await Promise.allSettled([import('./views/drawing'), createSolver()]);
  let hasViews = drawing.status === 'fulfilled';
  try {
    if (drawing.status === 'fulfilled') connectViews(drawing.value, page, keyboard);
  } catch {
    hasViews = false; // three.js has written the reason to the console
  }
  // Another link, opened in this tab: the page writes its own address without this event.
  addEventListener('hashchange', () => location.reload());
  rememberState();
  notifyAtEnd(app);
  watchCones(app);
  watchOpposite(app);
  watchThumbnails(app);
  watchMemory(app);
  watchEdits(app);
  addEventListener('beforeunload', (event) => {
    if (doc.job?.kind === 'run' || doc.isUnsaved) event.preventDefault();
  });
  setInterval(() => doc.job && (ui.now = performance.now()), 500); // updates the elapsed time of a run
  const asked = readHash(location.hash);
  followLink(app, asked);
  if (client.status === 'rejected') {
    doc.state = { kind: 'failed' };
    const advice =
      'Another browser, or a newer version of this one, may work; the command line needs none.';
    const { message } = client.reason as Error;
    return doc.say(`The solver could not start: ${message}. ${advice}`, 'error');
  }
  app.client = client.value;
  doc.state = { kind: 'empty' };
  performance.mark('hgp-ready');
  app.geometry.prepare();
  keepOffline();
  if (app.views && drawing.status === 'fulfilled') warmViews(app.views, drawing.value);
  if (drawing.status === 'rejected') {
    doc.say('The 3D view could not be loaded. Reload the page.', 'error');
  } else if (!hasViews) {
    const rest = 'maps are made, verified and saved all the same';
    doc.say(`This browser has no WebGL 2, so models are not drawn; ${rest}.`, 'error');
  }
  void refreshRecent(app);
  const example = exampleById(asked.example);
  if (!example && asked.model)
    doc.say('Open the file that this link is about: its cones and settings come with the link.');
  if (example) await attempt(app, () => openExample(app, example));
}

void start();
