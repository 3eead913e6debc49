// Checks that the solver makes on balanced cones without solving: a few prescriptions have no map although they
// satisfy Gauss–Bonnet, and others are known to fail. The user is told before Run.

import { effect } from '@preact/signals-core';
import { toCones, type Prescription } from '../model/prescription';
import type { Model } from '../model/types';
import { messageForPage } from '../text/error_messages';
import { noteForPage } from '../text/notes';
import type { App } from './app';

async function check(app: App, prescription: Prescription, model: Model): Promise<void> {
  const { doc } = app;
  const { surface, solver } = model;
  const { components, error } = await solver.check(toCones(prescription));
  if (prescription !== doc.prescription || surface !== doc.model?.surface || doc.isBusy) return;
  const refusal = components.find((one) => one.error)?.error ?? error;
  const text = refusal ? messageForPage(refusal.message, refusal.advice) : '';
  const warnings = components.flatMap((one) => one.warnings).map((note) => noteForPage(note));
  doc.objection = { prescription, surface, text, warnings };
  if (text !== '') doc.say(text, 'error');
}

/** Checks after every change; a check takes milliseconds. */
export function watchCones(app: App): () => void {
  const { doc } = app;
  let last: { prescription?: Prescription; surface?: Model['surface'] } = {};
  return effect(() => {
    const { prescription, usableModel, hasUserCones, budget, isBusy, objection, live, automatic } =
      doc;
    if (isBusy || (live && !automatic) || !usableModel || !hasUserCones || !budget) return;
    const { surface } = usableModel;
    if (objection?.prescription === prescription && objection.surface === surface) return;
    if (!budget.isReady || (last.prescription === prescription && last.surface === surface)) return;
    last = { prescription, surface };
    check(app, prescription, usableModel).catch(() => undefined); // Run reports errors
  });
}
