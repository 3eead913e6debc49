// Every change a person can make to what is asked. Each is one step of undo.

import type { App } from './app';
import { bestK, largestK } from './budget';
import { fromCones, withOrder, type Cone, type Prescription } from './prescription';
import { explain } from './explain';
import { hasDirections } from './files';
import { reload } from './load';
import { cancel } from './run';
import { save } from './autosave';

/** Whether nothing can be edited now; says so, with a way out. */
export function isLocked(app: App): boolean {
  if (app.phase !== 'running') return false;
  app.say('The cones are locked while the solver runs.', 'note', [
    { label: 'Cancel and edit', do: () => cancel(app) },
  ]);
  return true;
}

/** The one way to change what is asked. `kind` is "verb: field" for undo. */
export function replaceAsked(app: App, asked: Prescription, kind: string): void {
  if (isLocked(app)) return;
  app.history.push({ asked, settings: app.settings }, kind);
  if (app.message?.kind !== 'note') app.message = undefined; // it was about what is now past
  app.isExplicit = true;
  app.isUnsaved = true;
  if (app.selected >= asked.cones.length) app.selected = -1;
  if (app.info) void save(app.info.file.sha256, asked);
  app.changed();
}

const withCones = (app: App, cones: readonly Cone[]): Prescription => ({ ...app.asked, cones });

/** The vertex was edited just now. */
function touch(app: App, vertex: number): void {
  app.editOrder = [...app.editOrder.filter((v) => v !== vertex), vertex];
}

/** Lets the cone that was edited longest ago take up the change, by whole steps, where that is wanted. */
function balanced(app: App, cones: readonly Cone[], touched: number): readonly Cone[] {
  if (!app.keepsBalanced || cones.length < 2 || !app.info) return cones;
  const isOpen = app.asked.turnings.some((l) => l === null);
  if (isOpen || app.info.components?.length !== 1) return cones;
  const { q } = app.asked;
  const turnings = app.asked.turnings.reduce<number>((sum, l) => sum + (l ?? 0), 0);
  const left =
    q * (app.info.eulerCharacteristic ?? 0) -
    turnings -
    cones.reduce((sum, { k }) => sum + q - k, 0);
  if (left === 0) return cones;
  const age = ({ vertex }: Cone): number => app.editOrder.indexOf(vertex); // −1: never edited
  const fits = ({ vertex, k }: Cone): boolean =>
    k - left >= 1 && k - left <= largestK(q, app.surface?.valence[vertex] ?? 0);
  const [other] = cones
    .map((cone, i) => ({ cone, i }))
    .filter(({ cone, i }) => i !== touched && fits(cone))
    .sort((x, y) => age(x.cone) - age(y.cone));
  if (!other) {
    app.say(`No other cone can take up ${left}: the budget is open.`);
    return cones;
  }
  const k = other.cone.k - left;
  app.say(`Cone ${other.i + 1} is now k = ${k}, which keeps the balance.`);
  return cones.map((cone, i) => (i === other.i ? { ...cone, k } : cone));
}

/** Adds a cone where there is none, with the k that suits the shape; selects it otherwise. */
export function placeOrSelect(app: App, picked: number): void {
  if (!app.surface || !app.info?.usable) return;
  const vertex = app.surface.meaning[picked];
  if (vertex < 0) return app.say(`Vertex ${picked} was removed by a repair.`, 'error');
  const there = app.asked.cones.findIndex((cone) => cone.vertex === vertex);
  if (there >= 0) return select(app, there);
  if (app.surface.isBoundary[vertex]) {
    return app.say(
      `Vertex ${vertex} is on the boundary. Boundaries have a turning index instead of cones.`,
      'error',
    );
  }
  const k = bestK(app.surface, vertex, app.asked.q);
  const cones = [...app.asked.cones, { vertex, k }];
  touch(app, vertex);
  replaceAsked(app, withCones(app, balanced(app, cones, cones.length - 1)), 'add cone');
  if (app.phase !== 'running') select(app, cones.length - 1);
}

export function select(app: App, index: number): void {
  app.selected = index;
  app.changed();
}

export function selectNext(app: App, step: 1 | -1): void {
  const count = app.asked.cones.length;
  if (count > 0) select(app, (Math.max(app.selected, step > 0 ? -1 : 0) + step + count) % count);
}

export function setK(app: App, index: number, k: number): void {
  const cone = app.asked.cones[index];
  if (!cone || !Number.isInteger(k) || k < 1 || k === cone.k) return;
  const cones = app.asked.cones.map((one, i) => (i === index ? { ...one, k } : one));
  touch(app, cone.vertex);
  replaceAsked(app, withCones(app, balanced(app, cones, index)), `change k: ${cone.vertex}`);
}

/** `drag` names one drag, which is one step of undo however far it goes. */
export function moveCone(app: App, index: number, picked: number, drag: string): void {
  const cone = app.asked.cones[index];
  const vertex = app.surface?.meaning[picked] ?? -1;
  if (!cone || cone.vertex === vertex || vertex < 0 || app.surface!.isBoundary[vertex]) return;
  if (app.asked.cones.some((other) => other.vertex === vertex)) return;
  const cones = app.asked.cones.map((one, i) => (i === index ? { ...one, vertex } : one));
  touch(app, vertex);
  replaceAsked(app, withCones(app, cones), `move cone: ${drag}`);
}

export function deleteCone(app: App, index: number): void {
  if (!app.asked.cones[index]) return;
  app.selected = -1;
  replaceAsked(
    app,
    withCones(
      app,
      balanced(
        app,
        app.asked.cones.filter((_, i) => i !== index),
        -1,
      ),
    ),
    'delete cone',
  );
}

export function clearCones(app: App): void {
  app.selected = -1;
  replaceAsked(app, withCones(app, []), 'clear cones');
}

export function setTurning(app: App, loop: number, l: number | null): void {
  if (l !== null && !Number.isInteger(l)) return;
  const turnings = app.asked.turnings.map((old, i) => (i === loop ? l : old));
  replaceAsked(app, { ...app.asked, turnings }, `change turning: ${loop}`);
}

export function setHandle(app: App, generator: number, r: number | null): void {
  const { q } = app.asked;
  const inRange = r === null || !Number.isInteger(r) ? null : ((r % q) + q) % q;
  const handles = app.asked.handles.map((old, i) => (i === generator ? inRange : old));
  replaceAsked(app, { ...app.asked, handles }, `change handle: ${generator}`);
}

/** Converts what is there where that is exact; otherwise says so and offers to start again. */
export function setOrder(app: App, q: number): void {
  if (q === app.asked.q || !Number.isInteger(q) || q < 1 || q > 64) return;
  const converted = withOrder(app.asked, q);
  if (converted) {
    const wasExplicit = app.isExplicit;
    replaceAsked(app, converted, 'change q');
    app.isExplicit = wasExplicit;
    return;
  }
  const fresh = (): void =>
    replaceAsked(
      app,
      {
        ...{ q, cones: [] },
        turnings: app.asked.turnings.map(() => null),
        handles: app.asked.handles.map(() => null),
      },
      'change q',
    );
  app.say(`These cones are no whole multiples of 360°/${q}.`, 'error', [
    { label: `Clear them and use q = ${q}`, do: fresh },
  ]);
}

/** Gives the selected cone everything that is left. */
export function putRestOnSelected(app: App): void {
  const cone = app.asked.cones[app.selected];
  const part = app.surface && cone ? app.surface.part[cone.vertex] : 0;
  const budget = app.budget?.parts.find((one) => one.part === part) ?? app.budget?.parts[0];
  if (!cone || !budget) return;
  const k = cone.k - budget.left;
  if (k < 1) {
    return app.say(`Cone ${app.selected + 1} would need k = ${k}; k must be at least 1.`, 'error');
  }
  setK(app, app.selected, k);
}

export async function importCones(app: App, name: string, text: string): Promise<void> {
  if (isLocked(app)) return;
  try {
    const cones = await app.client!.readCones({ name, text, q: app.asked.q });
    const { turnings, handles } = app.asked;
    replaceAsked(app, fromCones(cones, turnings.length, handles.length), 'import cones');
    app.takeField(hasDirections(name) ? { name, text } : undefined);
    app.say(`${cones.cones.length} cones imported from ${name}.`);
  } catch (error) {
    app.say(explain(error, name), 'error');
  }
}

function step(app: App, move: () => void, back: () => void): void {
  if (app.phase === 'loading' || isLocked(app)) return;
  const { history } = app;
  move();
  app.message = undefined;
  app.selected = -1;
  if (app.settings !== app.loaded && app.info) {
    // A repair or a weld was undone; or not, where reading the file again was cancelled.
    void reload(app).then((isDone) => {
      if (isDone || history !== app.history) return;
      back();
      app.changed();
    });
  }
  app.changed();
}
const goBack = (app: App) => (): void => app.history.undo();
const goOn = (app: App) => (): void => app.history.redo();
export const undo = (app: App): void => step(app, goBack(app), goOn(app));
export const redo = (app: App): void => step(app, goOn(app), goBack(app));
