// Every edit of the prescription. Each is one undo step.

import { withKOfPair, withoutPair, withPair, withPairAt } from '../model/cone_pairs';
import { leftAt, suggestedK } from '../model/gauss_bonnet';
import {
  alongFeatures,
  fromCones,
  isSilent,
  orders,
  samePrescription,
  toCones,
  withOrder,
  type Cone,
  type Prescription,
} from '../model/prescription';
import type { Model } from '../model/types';
import { hasDirections } from '../formats/file_set';
import { saveCones } from '../services/cone_storage';
import { describeError } from '../text/error_messages';
import { listed, plural } from '../text/format';
import type { App } from './app';
import { isLocked } from './job';
import { andLines, takeFeaturesOf } from './keep_features';
import { oppositeIn } from './opposite';

/** The only function that changes the prescription. `kind` is "verb: field" for undo. */
export function setPrescription(app: App, prescription: Prescription, kind: string): boolean {
  if (isLocked(app)) return false;
  const { doc } = app;
  doc.history = doc.history.push({ prescription, settings: doc.settings }, kind);
  if (doc.message?.kind !== 'note') doc.message = undefined; // it was about the previous prescription
  doc.hasUserCones = true;
  if (doc.askedFeatures) keepCones(app, kind !== 'suggest cones' && !isSilent(prescription));
  doc.isUnsaved = true;
  if (doc.selected >= prescription.cones.length) doc.selected = -1;
  if (doc.model) void saveCones(doc.model.info, prescription);
  return true;
}

/** Whether Run keeps the cones that are placed, along features. */
export function keepCones({ doc }: App, keepsCones: boolean): void {
  const { features } = doc;
  if (features && (features.keepsCones ?? false) !== keepsCones)
    doc.features = { ...features, keepsCones };
}

const setCones = (app: App, cones: readonly Cone[], kind: string): boolean =>
  setPrescription(app, { ...app.doc.prescription, cones }, kind);

/** The cone that a click at a vertex would place; undefined if the vertex cannot be a cone. */
export function coneToPlace(app: App, picked: number): Cone | undefined {
  const { doc } = app;
  const model = doc.usableModel;
  const vertex = model?.surface.representative[picked] ?? -1;
  if (!model || vertex < 0 || model.surface.isBoundary[vertex]) return undefined;
  const { surface } = model;
  const left = leftAt(doc.budget, surface, vertex);
  const image = oppositeIn(app)(vertex);
  const share = image < 0 || image === vertex ? left : Math.trunc(left / 2); // for each of a pair
  return { vertex, k: suggestedK(surface, vertex, doc.prescription.q, share) };
}

/** Selects the cone at a vertex or, if there is none, adds one with a suitable k. */
export function placeOrSelect(app: App, picked: number): void {
  const { doc } = app;
  const model = doc.usableModel;
  if (!model) return;
  const vertex = model.surface.representative[picked];
  if (vertex < 0) return doc.say(`Vertex ${picked} was removed by a repair.`, 'error');
  const { cones } = doc.prescription;
  const there = cones.findIndex((cone) => cone.vertex === vertex);
  if (there >= 0) return select(app, there);
  const cone = coneToPlace(app, picked);
  if (!cone) {
    const rule = 'Boundaries have a turning instead of cones: see Boundaries and handles.';
    return doc.say(`Vertex ${vertex} is on the boundary. ${rule}`, 'error');
  }
  const placed = withPair(cones, cone, oppositeIn(app));
  if (setCones(app, placed, `add cone: ${vertex}`)) select(app, cones.length);
}

export function select({ doc }: App, index: number): void {
  doc.selected = index;
}

export function selectNext({ doc }: App, step: 1 | -1): void {
  const count = doc.prescription.cones.length;
  if (count > 0) doc.selected = (Math.max(doc.selected, step > 0 ? -1 : 0) + step + count) % count;
}

export function setK(app: App, index: number, k: number): void {
  const { cones } = app.doc.prescription;
  const cone = cones[index];
  if (!cone || k === cone.k) return;
  if (!Number.isInteger(k) || k < 1) {
    return app.doc.say(`k must be a whole number from 1, not ${k}.`, 'error');
  }
  setCones(app, withKOfPair(cones, index, k, oppositeIn(app)), `change k: ${cone.vertex}`);
}

/** Moves a cone. `drag` identifies the drag, all moves of which are one undo step. */
export function moveCone(app: App, index: number, picked: number, drag: string): void {
  const { cones } = app.doc.prescription;
  const surface = app.doc.usableModel?.surface;
  const cone = cones[index];
  const vertex = surface?.representative[picked] ?? -1;
  if (!cone || cone.vertex === vertex || vertex < 0 || surface!.isBoundary[vertex]) return;
  const moved = withPairAt(cones, index, vertex, oppositeIn(app));
  if (moved) setCones(app, moved, `move cone: ${drag}`);
}

export function deleteCone(app: App, index: number): void {
  const { cones } = app.doc.prescription;
  const cone = cones[index];
  if (!cone || isLocked(app)) return;
  app.doc.selected = -1;
  setCones(app, withoutPair(cones, index, oppositeIn(app)), `delete cone: ${cone.vertex}`);
}

export function clearCones(app: App): void {
  if (setCones(app, [], 'clear cones')) app.doc.selected = -1;
}

/** These cones and those that the solver adds for a balance, the given ones first. */
export async function balanced(
  { solver }: Model,
  prescription: Prescription,
): Promise<readonly Cone[]> {
  const { turnings, handles, cones: given } = prescription;
  const all = await solver.balanceCones(toCones(prescription));
  const added = [...fromCones(all, turnings.length, handles.length).cones];
  const take = (isSame: (one: Cone) => boolean): boolean => {
    const at = added.findIndex(isSame);
    if (at >= 0) added.splice(at, 1);
    return at >= 0;
  };
  // Copies of a vertex that a repair split are told apart by their triangles, of which the solver may name another.
  const others = given.filter(
    ({ vertex, triangle }) => !take((one) => one.vertex === vertex && one.triangle === triangle),
  );
  for (const { vertex } of others) take((one) => one.vertex === vertex);
  return [...given, ...added];
}

/** Adds the missing cones where they cause the least distortion. */
export async function balance(app: App): Promise<void> {
  const { doc } = app;
  const model = doc.usableModel;
  const { prescription, budget } = doc;
  if (!model || !budget || isLocked(app)) return;
  if (budget.components.every(({ isBalanced }) => isBalanced))
    return doc.say('The cones are balanced already.');
  const { cones } = prescription;
  let all: readonly Cone[];
  try {
    all = await balanced(model, prescription);
  } catch (error) {
    return doc.say(describeError(error, model.main), 'error');
  }
  if (doc.prescription !== prescription) return; // edited in the meantime
  if (!setCones(app, all, 'balance')) return;
  const added = all.slice(cones.length);
  const kinds = [...new Set(added.map(({ k }) => k))].sort((a, b) => a - b).map(String);
  const text = `${plural(added.length, 'cone')} added, with k = ${listed(kinds)}`;
  doc.say(`${text}. Undo removes them.`, 'good');
}

export function setTurning(app: App, loop: number, l: number | null): void {
  if (l !== null && !Number.isInteger(l)) return;
  const { prescription } = app.doc;
  const turnings = prescription.turnings.map((old, i) => (i === loop ? l : old));
  setPrescription(app, { ...prescription, turnings }, `change turning: ${loop}`);
}

export function setHandle(app: App, generator: number, r: number | null): void {
  const { prescription } = app.doc;
  const { q } = prescription;
  const inRange = r === null || !Number.isInteger(r) ? null : ((r % q) + q) % q;
  const handles = prescription.handles.map((old, i) => (i === generator ? inRange : old));
  setPrescription(app, { ...prescription, handles }, `change handle: ${generator}`);
}

/** Converts the prescription to order q if that is exact; otherwise says so and offers to start again. */
export function setOrder(app: App, q: number): void {
  const { doc } = app;
  const { prescription, hasUserCones } = doc;
  if (q === prescription.q) return;
  if (!Number.isInteger(q) || q < orders.min || q > orders.max) {
    const range = `a whole number from ${orders.min} to ${orders.max}`;
    return doc.say(`The symmetry q is ${range}, not ${q}. It stays ${prescription.q}.`, 'error');
  }
  const converted = withOrder(prescription, q);
  if (converted) {
    if (setPrescription(app, converted, 'change q')) doc.hasUserCones = hasUserCones;
    return;
  }
  const { turnings, handles } = prescription;
  const none = { turnings: turnings.map(() => null), handles: handles.map(() => null) };
  const clear = (): unknown => setPrescription(app, { q, cones: [], ...none }, 'change q');
  doc.say(`The angles of these cones are not whole multiples of 360°/${q}.`, 'error', [
    { label: `Clear them and use q = ${q}`, run: clear },
  ]);
}

export async function importCones(app: App, name: string, text: string): Promise<void> {
  const { doc } = app;
  const { model } = doc;
  if (!model || isLocked(app)) return;
  try {
    const cones = await model.solver.readCones({ name, text, q: doc.prescription.q });
    if (doc.model !== model || isLocked(app)) return; // another file or a run in the meantime
    const { turnings, handles } = doc.prescription;
    doc.takeField(hasDirections(name) ? { name, text } : undefined);
    const hasLines = takeFeaturesOf(app, cones);
    const own = hasLines ? alongFeatures(cones) : cones;
    setPrescription(app, fromCones(own, turnings.length, handles.length), 'import cones');
    const lines = hasLines ? andLines : '';
    doc.say(`${plural(cones.cones.length, 'cone')} imported from ${name}${lines}.`);
  } catch (error) {
    doc.say(describeError(error, name), 'error');
  }
}

/** Cones that a run has chosen, because there were none or along features, become those of the document. */
export function takeCones(app: App, chosen: Prescription): void {
  if (!samePrescription(chosen, app.doc.prescription))
    setPrescription(app, chosen, 'suggest cones');
}
