// A cone that is dragged over a certified map takes the map with it. Frames are previews, of which one waits at most;
// when the cone is dropped, the map of its place is stored and becomes the result.

import type { Drag, DragFrame, SupersededFrame, UvMap } from 'hgp';
import { beforeFirst, liveMapOf } from '../model/live';
import { samePrescription, type Cone, type Prescription } from '../model/prescription';
import { requestOf } from '../model/request';
import type { Model, Solution } from '../model/types';
import { isCertified } from '../model/verdict';
import type { App } from './app';
import { setPrescription } from './edit_cones';
import { keepSolution, run } from './solve';
import { numbersOf, writeSolution } from './write_solution';

/** A drag of a cone over a map. */
interface Going {
  base: Solution;
  drag: Promise<Drag>;
  /** The vertex that was asked for last. */
  wanted: number;
  latest: Promise<DragFrame | SupersededFrame | undefined>;
  /** When the map last came nearer to a place out of its reach, and how long that took. */
  approached: { at: number; took: number };
}

function since(begin: number): Going['approached'] {
  const at = performance.now();
  return { at, took: at - begin };
}

/** Milliseconds without a movement after which a hand rests. */
const rest = 80;

/** Milliseconds on a cone after which its drag is prepared: a pointer that only passes asks for nothing. */
const dwell = 120;

/** A cone that is held, from the press of the button until the map of its place is stored or given up. */
interface Hold {
  cone: number;
  /** Its vertex when the button was pressed: elsewhere than in the map's prescription if a map of this place is missing. */
  pressed: number;
  /** Undefined before the map is prepared, and where there is none. */
  going?: Going;
  isCancelled: boolean;
  isDropped: boolean;
  /** Called when the cone is dropped; `step` names the drag in the history. */
  release: (step: string) => void;
  released: Promise<string>;
}

/** A drag that is prepared before the button is pressed. */
interface Prepared {
  base: Solution;
  vertex: number;
  drag: Promise<Drag>;
}

interface Holds {
  /** The cone under the hand. */
  current?: Hold;
  /** The cone under the pointer, while no button is pressed. */
  pointed?: number;
  timer?: ReturnType<typeof setTimeout>;
  prepared?: Prepared;
  /** How many are held or being stored. */
  open: number;
  /** The end of the last one, before which no other is prepared. */
  last: Promise<void>;
}

const holdsOf = new WeakMap<App, Holds>();

function holdsIn(app: App): Holds {
  const holds = holdsOf.get(app) ?? { open: 0, last: Promise.resolve() };
  holdsOf.set(app, holds);
  return holds;
}

type Place = Omit<Cone, 'k'>;

/** The prescription with a cone at another vertex, or at another copy of its vertex. */
function withConeAt(prescription: Prescription, cone: number, place: Place): Prescription {
  const { vertex, triangle } = prescription.cones[cone] ?? {};
  if (vertex === place.vertex && triangle === (place.triangle ?? triangle)) return prescription;
  const cones = prescription.cones.map((one, i) => (i === cone ? { ...place, k: one.k } : one));
  return { ...prescription, cones };
}

/** The map that a cone can take with it, whatever its own place in it; undefined if maps have to be made by Run. */
function baseOf({ doc }: App, prescription: Prescription, cone: number): Solution | undefined {
  const { solutions, usableModel, isBusy, solve } = doc;
  if (!usableModel || isBusy || solve.frames === 'file') return undefined;
  const isHere = (one: Solution): boolean => samePrescription(one.prescription, prescription);
  const isBeside = (one: Solution): boolean => {
    const place = one.prescription.cones[cone];
    return place && samePrescription(one.prescription, withConeAt(prescription, cone, place));
  };
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

/** The pointer is on a cone, or on none (−1). The map is prepared for a cone that will probably be dragged. */
export function pointAtCone(app: App, cone: number): void {
  const holds = holdsIn(app);
  if (cone === holds.pointed) return;
  clearTimeout(holds.timer);
  void takePrepared(holds);
  holds.pointed = cone;
  if (cone >= 0) holds.timer = setTimeout(() => prepare(app, holds, cone), dwell);
}

/** Only for the map that is shown: with another one a run may be on its way, which this would stop. */
function prepare(app: App, holds: Holds, cone: number): void {
  const { doc } = app;
  const base = holds.open === 0 ? baseOf(app, doc.prescription, cone) : undefined;
  const vertex = base?.prescription.cones[cone]?.vertex;
  if (!base || base !== doc.current || vertex === undefined) return;
  const drag = base.map.beginDrag(vertex);
  drag.catch(() => undefined); // the press tries again, and reports
  holds.prepared = { base, vertex, drag };
}

/** The drag that was prepared for a cone of a map, if there is one; any other one is given up. */
async function takePrepared(
  holds: Holds,
  base?: Solution,
  vertex?: number,
): Promise<Drag | undefined> {
  const { prepared } = holds;
  holds.prepared = undefined;
  const drag = await prepared?.drag.catch(() => undefined);
  if (!drag || (prepared?.base === base && prepared?.vertex === vertex && !drag.isDisposed))
    return drag;
  await drag.dispose().catch(() => undefined);
  return undefined;
}

/** Prepares the map for a cone that is about to be dragged; returns when the drag is over and stored. */
export async function beginLive(app: App, cone: number): Promise<void> {
  cancelLive(app); // of a button whose release was not seen
  const holds = holdsIn(app);
  const { vertex: pressed } = app.doc.prescription.cones[cone];
  let release!: Hold['release'];
  const released = new Promise<string>((resolve) => (release = resolve));
  const hold: Hold = { cone, pressed, isCancelled: false, isDropped: false, release, released };
  holds.current = hold;
  holds.open += 1;
  clearTimeout(holds.timer);
  holds.pointed = undefined;
  app.ui.holdsCone = true; // no map is made by itself: the solver is free for the frames
  const previous = holds.last;
  const work = previous.then(() => follow(app, hold));
  holds.last = work.catch(() => undefined);
  try {
    await work;
  } finally {
    holds.open -= 1;
    app.ui.holdsCone = holds.open > 0;
  }
}

/** The life of a drag: the map is prepared, follows the hand, and is stored where the cone is dropped. */
async function follow(app: App, hold: Hold): Promise<void> {
  if (hold.isCancelled) return;
  const { cone, pressed } = hold;
  const here = withConeAt(app.doc.prescription, cone, { vertex: pressed });
  const base = baseOf(app, here, cone);
  const vertex = base?.prescription.cones[cone]?.vertex;
  if (base && vertex !== undefined) {
    const latest = Promise.resolve(undefined);
    const begin = performance.now();
    const drag = takePrepared(holdsIn(app), base, vertex).then(
      (prepared) => prepared ?? base.map.beginDrag(vertex),
    );
    const going: Going = { base, drag, wanted: vertex, latest, approached: { at: begin, took: 0 } };
    drag.then(() => (going.approached = since(begin))).catch(() => undefined);
    hold.going = going;
    show(app, hold); // the hand may have moved already
    hold.going.drag.catch(() => endLive(app, hold)); // moved without its map, which Run makes
  }
  const step = await hold.released;
  if (!hold.isCancelled && hold.going) await store(app, hold.going, cone, step);
  endLive(app, hold);
}

/** Shows the map with the cone where it now is. */
export function dragLive(app: App): void {
  const hold = holdsIn(app).current;
  if (hold) show(app, hold);
}

function show(app: App, hold: Hold): void {
  const { going, cone } = hold;
  const vertex = app.doc.prescription.cones[cone]?.vertex;
  if (!going || vertex === undefined || vertex === going.wanted) return;
  going.wanted = vertex;
  app.doc.live ??= beforeFirst(going.base);
  going.latest = approach(app, hold, going, vertex);
  going.latest.catch(() => undefined); // store() looks at it
}

/**
 * Takes the map to a vertex, in several steps if it is far, until the hand has moved on or the drag has ended. Once the cone
 * is dropped a run is faster than further steps, but would not know prescribed handles, whose rotations follow the path.
 */
async function approach(
  app: App,
  hold: Hold,
  going: Going,
  vertex: number,
): Promise<DragFrame | SupersededFrame> {
  const resting = performance.now() + rest;
  const drag = await going.drag;
  let frame = await drag.dragTo(vertex);
  showFrame(app, hold, going, frame);
  while (frame.state === 'heat' && frame.isApproaching) {
    await turnOf(hold, going, resting);
    const isStepping = !hold.isDropped || hasHandles(app.doc.prescription);
    if (going.wanted !== vertex || hold.going !== going || !isStepping) break;
    const begin = performance.now();
    frame = await drag.dragTo(vertex);
    if (frame.state !== 'superseded') going.approached = since(begin);
    showFrame(app, hold, going, frame);
  }
  return frame;
}

const hasHandles = ({ handles }: Prescription): boolean => handles.some((r) => r !== null);

function showFrame(app: App, hold: Hold, going: Going, frame: DragFrame | SupersededFrame): void {
  if (frame.state === 'superseded' || hold.going !== going) return;
  app.doc.live = liveMapOf(going.base, frame, app.doc.live);
}

/**
 * A step of the map towards the cone keeps the next position waiting: it is made while the hand rests, and while it
 * moves only as often as to take a quarter of the time.
 */
async function turnOf(hold: Hold, { approached }: Going, resting: number): Promise<void> {
  const next = Math.min(resting, approached.at + 3 * approached.took);
  const left = next - performance.now();
  if (left > 0)
    await Promise.race([new Promise((rested) => setTimeout(rested, left)), hold.released]);
}

/** Ends the drag: nothing of it stays but the cone. */
export function cancelLive(app: App): void {
  const holds = holdsIn(app);
  const hold = holds.current;
  if (!hold) return;
  holds.current = undefined;
  hold.isCancelled = true;
  endLive(app, hold);
  hold.release('');
}

function endLive(app: App, hold: Hold): void {
  const { going } = hold;
  if (!going) return;
  hold.going = undefined;
  app.doc.live = undefined;
  void going.drag.then((drag) => drag.dispose()).catch(() => undefined);
}

/** Ends the drag where the cone is, and stores its map. `step` names the drag in the history. */
export function dropLive(app: App, step: string): void {
  const holds = holdsIn(app);
  const hold = holds.current;
  if (!hold) return;
  const now = app.doc.prescription.cones[hold.cone]?.vertex;
  if (now === undefined || now === hold.pressed) return cancelLive(app);
  holds.current = undefined;
  hold.isDropped = true;
  hold.release(step);
}

async function store(app: App, going: Going, cone: number, step: string): Promise<void> {
  const { doc } = app;
  const { model, settings } = doc;
  if (going.wanted === going.base.prescription.cones[cone]?.vertex) return;
  // The hand may have taken the cone further by now.
  const prescription = withConeAt(doc.prescription, cone, { vertex: going.wanted });
  const last = await going.latest.catch(() => undefined);
  if (last?.state === 'heat' && last.isApproaching && doc.prescription === prescription)
    doc.promised = doc.wanted;
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
