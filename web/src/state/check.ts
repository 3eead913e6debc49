// What the solver knows about balanced cones without solving anything: the few that no map can have
// although they add up, and those known to be out of its reach. Said before Run, not after.

import type { App } from './app';
import { toCones, type Prescription } from './prescription';
import type { Surface } from './surface';

export interface Objection {
  asked: Prescription;
  surface: Surface;
  /** Empty where there is none. */
  text: string;
  warnings: string[];
}

async function ask(app: App, asked: Prescription, surface: Surface): Promise<void> {
  const { components, error } = await app.client!.check(toCones(asked));
  if (asked !== app.asked || surface !== app.surface || app.phase !== 'editing') return;
  const text = components.find((one) => one.error)?.error?.message ?? error?.message ?? '';
  const warnings = components.flatMap((one) => one.warnings);
  app.objection = { asked, surface, text, warnings };
  if (text !== '') app.say(text, 'error');
  else app.changed();
}

/** Asks after every change, which takes milliseconds. */
export function watchCones(app: App): void {
  let last: { asked?: Prescription; surface?: Surface } = {};
  app.subscribe(() => {
    const { asked, surface, phase, budget } = app;
    if (phase !== 'editing' || !surface || !app.isExplicit || !budget?.isReady) return;
    if (last.asked === asked && last.surface === surface) return;
    last = { asked, surface };
    ask(app, asked, surface).catch(() => undefined); // Run says what is wrong
  });
}
