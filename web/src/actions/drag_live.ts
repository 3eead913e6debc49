// A cone that is dragged over a certified map takes the map with it. Frames are previews, of which one waits at most;
// when the cone is dropped, the map of its place is stored and becomes the result.

import type { Drag, DragFrame, SupersededFrame, UvMap } from 'hgp';
import { beforeFirst, liveMapOf } from '../model/live';
import { samePrescription, type Prescription } from '../model/prescription';
import { requestOf } from '../model/request';
import type { Model, Solution } from '../model/types';
import { isCertified } from '../model/verdict';
import type { App } from './app';
import { setPrescription } from './edit_cones';
import { keepSolution, numbersOf, run, writeSolution } from './solve';

interface Going {
  base: Solution;
  /** Index of the cone. */
  cone: number;
  /** Its vertex when the button was pressed: elsewhere than in `base` if a map of this place is missing. */
  pressed: number;
  drag: Promise<Drag>;
  /** The vertex that was asked for last. */
  wanted: number;
  latest: Promise<DragFrame | SupersededFrame | undefined>;
}

/** The press of the button that lasts. */
const pressIn = new WeakMap<App, object>();
const goingIn = new WeakMap<App, Going>();
/** The end of the last drag, before which none begins. */
const storingIn = new WeakMap<App, Promise<void>>();

/** While a cone is held, no map is made by itself: the solver is free for its frames. */
function noteHold(app: App): void {
  app.ui.holdsCone = pressIn.has(app) || storingIn.has(app);
}

/** The prescription with a cone at the vertex at which another one has it. */
function withConeOf(prescription: Prescription, other: Prescription, cone: number): Prescription {
  const { vertex } = other.cones[cone] ?? {};
  if (vertex === undefined) return prescription;
  const cones = prescription.cones.map((one, i) => (i === cone ? { ...one, vertex } : one));
  return { ...prescription, cones };
}

/** The map that a cone can take with it, whatever its own place in it; undefined if maps have to be made by Run. */
function baseOf({ doc }: App, prescription: Prescription, cone: number): Solution | undefined {
  const { solutions, usableModel, isBusy, solve } = doc;
  if (!usableModel || isBusy || solve.frames === 'file') return undefined;
  const isHere = (one: Solution): boolean => samePrescription(one.prescription, prescription);
  const isBeside = (one: Solution): boolean =>
    samePrescription(one.prescription, withConeOf(prescription, one.prescription, cone));
  const isUsable = (one: Solution): boolean =>
    one.surfaceId === usableModel.surface.id &&
    one.improve === solve.improve &&
    one.features === undefined &&
    one.map.model === usableModel.solver &&
    !one.map.isDisposed &&
    isCertified(one);
  const usable = solutions.filter(isUsable);
  return usable.findLast(isHere) ?? usable.findLast(isBeside);
}

/** Prepares the map for a cone that is about to be dragged. */
export async function beginLive(app: App, cone: number): Promise<void> {
  const { prescription } = app.doc;
  const press = {};
  pressIn.set(app, press);
  noteHold(app);
  await storingIn.get(app);
  const base = baseOf(app, prescription, cone);
  const vertex = base?.prescription.cones[cone]?.vertex;
  if (!base || vertex === undefined || pressIn.get(app) !== press) return;
  const drag = base.map.beginDrag(vertex);
  const pressed = prescription.cones[cone].vertex;
  const latest = Promise.resolve(undefined);
  const going: Going = { base, cone, pressed, drag, wanted: vertex, latest };
  goingIn.set(app, going);
  dragLive(app); // the hand may have moved already
  try {
    await drag;
  } catch {
    // The cone is moved without its map, which Run makes.
    if (goingIn.get(app) === going) goingIn.delete(app);
  }
}

/** Shows the map with the cone where it now is. */
export function dragLive(app: App): void {
  const going = goingIn.get(app);
  const vertex = app.doc.prescription.cones[going?.cone ?? -1]?.vertex;
  if (!going || vertex === undefined || vertex === going.wanted) return;
  going.wanted = vertex;
  app.doc.live ??= beforeFirst(going.base);
  going.latest = going.drag
    .then((drag) => (going.wanted === vertex ? drag.dragTo(vertex) : undefined))
    .then((frame) => {
      if (frame && frame.state !== 'superseded' && goingIn.get(app) === going)
        app.doc.live = liveMapOf(going.base, frame, app.doc.live);
      return frame;
    });
  going.latest.catch(() => undefined); // dropLive() looks at it
}

/** Ends the drag: nothing of it stays but the cone. */
export function cancelLive(app: App): void {
  pressIn.delete(app);
  if (!storingIn.has(app)) endLive(app);
  noteHold(app);
}

function endLive(app: App): void {
  const going = goingIn.get(app);
  goingIn.delete(app);
  app.doc.live = undefined;
  void going?.drag.then((drag) => drag.dispose()).catch(() => undefined);
}

/** Ends the drag where the cone is, and stores its map. `step` names the drag in the history. */
export async function dropLive(app: App, step: string): Promise<void> {
  const going = goingIn.get(app);
  pressIn.delete(app);
  if (!going) return noteHold(app);
  const start = going.base.prescription.cones[going.cone]?.vertex;
  const now = app.doc.prescription.cones[going.cone]?.vertex;
  if (going.wanted === start || now === going.pressed) return cancelLive(app);
  const storing = store(app, going, step);
  storingIn.set(app, storing);
  try {
    await storing;
  } finally {
    storingIn.delete(app);
    noteHold(app);
  }
}

async function store(app: App, going: Going, step: string): Promise<void> {
  const { doc } = app;
  const { model, prescription, settings } = doc;
  try {
    const last = await going.latest.catch(() => undefined);
    const isThere = last?.state === 'certified' && last.vertex === going.wanted;
    if (!isThere || !model || !doc.live) return;
    doc.live = { ...doc.live, state: 'storing' };
    const map = await (await going.drag).endDrag();
    const dropped = completed(prescription, map.cones.handles ?? []);
    const solution = await writeDropped(app, model, going.base, dropped, map);
    // Other edits and other files may have come in the meantime.
    if (doc.model !== model || doc.settings !== settings) return;
    if (doc.prescription === prescription && dropped !== prescription)
      setPrescription(app, dropped, step);
    keepSolution(app, solution, going.base);
    if (doc.current === solution) sayDropped(app, solution);
  } finally {
    if (goingIn.get(app) === going) endLive(app);
  }
}

/** Writes the map of a cone that was dropped, with the settings of the map from which it was dragged. */
function writeDropped(
  app: App,
  model: Model,
  base: Solution,
  prescription: Prescription,
  map: UvMap,
): Promise<Solution> {
  const request = { ...requestOf(base), prescription, isDragged: true };
  const call = { signal: new AbortController().signal, onProgress: () => undefined };
  return writeSolution(app, model, request, { map, result: numbersOf(map) }, call);
}

function sayDropped(app: App, solution: Solution): void {
  const runAnew = { label: 'Run anew', run: () => run(app) };
  const [text, kind] = isCertified(solution)
    ? (['Certified: no triangle is folded. The dragged map is the result.', 'good'] as const)
    : (['The map of the drag does not pass as the file stores it. Run makes another one.', 'error'] as const); // prettier-ignore
  app.doc.say(text, kind, [runAnew]);
}

/** Rotations around handles follow the path of the cone, where they are prescribed. */
function completed(
  prescription: Prescription,
  handles: { generator: number; r: number }[],
): Prescription {
  const after = prescription.handles.map((r, i) =>
    r === null ? null : (handles.find(({ generator }) => generator === i)?.r ?? r),
  );
  const isSame = after.every((r, i) => r === prescription.handles[i]);
  return isSame ? prescription : { ...prescription, handles: after };
}
