// What follows an edit without dragging: the scale at once, then the certified map by itself. Another edit, a drag or a
// job takes its place; the solver stops at its next step and keeps what it has prepared.

import { effect, untracked } from '@preact/signals-core';
import { heatMapOf } from '../model/live';
import { samePrescription, toCones, type Prescription } from '../model/prescription';
import type { Model, SolveSettings } from '../model/types';
import type { App } from './app';
import type { JobCall } from './job';
import { takeCones } from './edit_cones';
import { keepSolution, sayRunFailure, sayVerdict, solve, whyNotRun } from './solve';

const quick = 2000; // milliseconds: where the first run was faster, maps follow edits unless the user chose otherwise

/** Whether maps are made without Run: as the user chose, otherwise where that takes little time. */
export const isAutomatic = ({ doc, ui }: App): boolean =>
  ui.automatic ?? (doc.firstRun !== undefined && doc.firstRun < quick);

interface Renewal {
  prescription: Prescription;
  solve: SolveSettings;
  model: Model;
  controller: AbortController;
}

/** The map that is to be made now; undefined if the one that is shown is right, or others have precedence. */
function wanted(app: App): Omit<Renewal, 'controller'> | undefined {
  const { doc, ui } = app;
  const { prescription, solve: settings, usableModel: model, displayed, current } = doc;
  if (!isAutomatic(app) || !model || !displayed || current) return undefined;
  if (ui.holdsCone || doc.needsCones || whyNotRun(app) !== '') return undefined;
  return { prescription, solve: settings, model };
}

const isSame = (a: Renewal | undefined, b: Omit<Renewal, 'controller'> | undefined): boolean =>
  a?.prescription === b?.prescription && a?.solve === b?.solve && a?.model === b?.model;

/** Makes the maps of edits while that is switched on. */
export function watchEdits(app: App): () => void {
  let going: Renewal | undefined;
  return effect(() => {
    const next = wanted(app);
    if (isSame(going, next)) return; // also after a failure: nothing is tried twice
    const before = going;
    going = next && { ...next, controller: new AbortController() };
    const now = going;
    untracked(() => {
      before?.controller.abort();
      if (!now) end(app);
    });
    // The edit is shown first.
    if (now) setTimeout(() => void renew(app, now));
  });
}

function end({ doc }: App): void {
  if (!doc.automatic) return;
  doc.automatic = undefined;
  doc.live = undefined;
}

async function renew(app: App, { prescription, model, controller }: Renewal): Promise<void> {
  const { doc } = app;
  const { signal } = controller;
  const base = doc.displayed;
  if (signal.aborted || !base) return;
  const isOn = (): boolean => !signal.aborted && doc.automatic?.controller === controller;
  const onProgress: JobCall['onProgress'] = ({ stage }) => {
    if (isOn() && doc.automatic?.stage !== stage) doc.automatic = { controller, stage };
  };
  const call: JobCall = { signal, onProgress, keepWorker: true };
  doc.automatic = { controller, stage: 'prepare' };
  try {
    if (!samePrescription(base.prescription, prescription)) {
      const scale = await model.solver.logScale(toCones(prescription), call).catch(() => undefined);
      if (isOn() && scale) doc.live = heatMapOf(base, scale);
    }
    if (!isOn()) return;
    const solution = await solve(app, model, base.output, call);
    if (!isOn()) return void solution.map.dispose();
    end(app);
    takeCones(app, solution.prescription);
    keepSolution(app, solution, base);
    sayVerdict(app, solution, false);
  } catch (error) {
    if (!isOn()) return;
    end(app);
    sayRunFailure(app, error);
  }
}
