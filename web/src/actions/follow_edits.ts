// What follows an edit without dragging: the scale at once, then the certified map by itself. Another edit, a drag or a
// job takes its place; the solver stops at its next step and keeps what it has prepared.

import { effect, untracked } from '@preact/signals-core';
import { heatMapOf } from '../model/live';
import { sameWanted, type Wanted } from '../model/wanted';
import { samePrescription, toCones } from '../model/prescription';
import { plural } from '../text/format';
import type { App } from './app';
import type { JobCall } from './job';
import { takeCones } from './edit_cones';
import { keepSolution, run, sayRunFailure, sayVerdict, solve, whyNotRun } from './solve';

const quick = 2000; // milliseconds: where the first run was faster, maps follow edits unless the user chose otherwise
const maxSeconds = 60; // for a map that nobody asked for, whatever the limit of Run

/** Whether maps are made without Run: as the user chose, otherwise where that takes little time. */
export const isAutomatic = ({ doc, ui }: App): boolean =>
  ui.automatic ?? (doc.firstRun !== undefined && doc.firstRun < quick);

interface Renewal {
  wanted: Wanted;
  controller: AbortController;
}

/** The map that is to be made now; undefined if the one that is shown is right, or others have precedence. */
function nextMap(app: App): Wanted | undefined {
  const { doc, ui } = app;
  const { wanted, displayed, current, promised } = doc;
  const isMade = isAutomatic(app) || (promised !== undefined && sameWanted(promised, wanted));
  if (!isMade || !displayed || current) return undefined;
  if (ui.holdsCone || doc.needsCones || whyNotRun(app) !== '') return undefined;
  // Whoever cancelled a run, or saw it fail, asks for the next one.
  return wanted && !sameWanted(doc.notAgain, wanted) ? wanted : undefined;
}

/** Makes the maps of edits while that is switched on. */
export function watchEdits(app: App): () => void {
  let going: Renewal | undefined;
  return effect(() => {
    const next = nextMap(app);
    if (sameWanted(going?.wanted, next)) return;
    const before = going;
    const now = next && { wanted: next, controller: new AbortController() };
    going = now;
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

/** Ends the map that is being made; Run makes it. */
function giveUp(app: App, wanted: Wanted, why: string): void {
  const { doc } = app;
  doc.notAgain = wanted;
  doc.automatic?.controller.abort();
  end(app);
  doc.say(why, 'note', [{ label: 'Run', run: () => run(app) }]);
}

/** Stops the map that is being made without Run. */
export function stopAutomatic(app: App): void {
  const { automatic, wanted } = app.doc;
  if (automatic && wanted) giveUp(app, wanted, 'Stopped. Run makes the map of these cones.');
}

async function renew(app: App, { wanted, controller }: Renewal): Promise<void> {
  const { doc } = app;
  const { signal } = controller;
  const { model, prescription } = wanted;
  const base = doc.displayed;
  if (signal.aborted || !base) return;
  const isOn = (): boolean => !signal.aborted && doc.automatic?.controller === controller;
  const onProgress: JobCall['onProgress'] = ({ stage }) => {
    if (isOn() && doc.automatic?.stage !== stage) doc.automatic = { controller, stage };
  };
  const call: JobCall = { signal, onProgress, keepWorker: true };
  const seconds = Math.min(wanted.solve.timeLimit ?? Infinity, maxSeconds);
  const stopLate = (): void =>
    giveUp(app, wanted, `No map of this edit within ${plural(seconds, 'second')}. Run makes it.`);
  const timer = setTimeout(() => isOn() && stopLate(), 1000 * seconds);
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
    doc.notAgain = wanted;
    end(app);
    sayRunFailure(app, error);
  } finally {
    clearTimeout(timer);
  }
}
