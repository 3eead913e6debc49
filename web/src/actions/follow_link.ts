// What the address of the page asks for: settings at once, cones and features of a model when it is open.

import { effect, untracked } from '@preact/signals-core';
import { modelTag, type HashState } from '../formats/hash_state';
import type { Model } from '../model/types';
import type { App } from './app';
import { setPrescription } from './edit_cones';
import { takeFeatures } from './keep_features';
import { setLook } from './view';

type Listed = HashState['turnings'];

const hasSomething = ({ cones, turnings = [], handles = [], features }: HashState): boolean =>
  cones !== undefined || features !== undefined || turnings.length + handles.length > 0;

/** Whether every vertex of the link is one of the model. */
function isOf({ info, surface }: Model, { model, cones = [], features }: HashState): boolean {
  const vertices = [...cones.map(({ vertex }) => vertex), ...(features?.edges ?? []).flat()];
  const isSame = model === undefined || model === modelTag(info);
  return isSame && vertices.every((vertex) => vertex < surface.vertexCount);
}

function takeCones(app: App, { q, cones, turnings, handles }: HashState): void {
  const { prescription } = app.doc;
  if (!cones && !turnings && !handles) return;
  const from = (pairs: Listed = [], list: readonly (number | null)[]): (number | null)[] =>
    list.map((n, i) => pairs.find(([at]) => at === i)?.[1] ?? n);
  const all = {
    q: q ?? prescription.q,
    cones: cones ?? [],
    turnings: from(turnings, prescription.turnings),
    handles: from(handles, prescription.handles),
  };
  setPrescription(app, all, 'take cones of the link');
}

/** Takes what belongs to a model, unless it has cones already. */
function takeWork(app: App, model: Model, state: HashState): void {
  const { doc } = app;
  if (!hasSomething(state)) return;
  if (!isOf(model, state)) {
    return doc.say('The cones in the link belong to another model and were left out.');
  }
  if (doc.prescription.cones.length > 0) return;
  takeCones(app, state);
  if (state.features) takeFeatures(app, state.features);
}

export function followLink(app: App, state: HashState): void {
  const { doc } = app;
  const { look, solve } = doc;
  const { pattern = look.pattern, overlay = look.overlay, tiles = look.tiles } = state;
  setLook(app, { pattern, overlay, tiles });
  if (state.q) doc.begin({ ...doc.prescription, q: state.q });
  const { grid = solve.grid, improve = solve.improve } = state;
  const { rounds = solve.rounds, timeLimit = solve.timeLimit, camera } = state;
  doc.solve = { ...solve, grid, improve, rounds, timeLimit };
  if (!hasSomething(state) && !camera) return;
  const dispose = effect(() => {
    const model = doc.usableModel;
    if (!model || doc.isBusy) return;
    queueMicrotask(() => dispose());
    untracked(() => takeWork(app, model, state));
    if (camera) setTimeout(() => app.views?.model.orbit.fromText(camera), 50);
  });
}
