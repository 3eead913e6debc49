// Checks that the solver makes on balanced cones without solving: a few prescriptions have no map although they
// satisfy Gauss–Bonnet, and others are known to fail. The user is told before Run.

import { effect } from '@preact/signals-core';
import { toCones, type Prescription } from '../model/prescription';
import { toFeatures } from '../model/features';
import type { Model, Objection } from '../model/types';
import { messageForPage } from '../text/error_messages';
import { noteForPage } from '../text/notes';
import type { App } from './app';
import { chooseAlong } from './solve';

type Checked = Pick<Objection, 'prescription' | 'surface' | 'features'>;

const isAbout = (now: Checked, other: Partial<Checked> = {}): boolean =>
  now.prescription === other.prescription &&
  now.surface === other.surface &&
  now.features === other.features;

async function check(app: App, prescription: Prescription, model: Model): Promise<void> {
  const { doc } = app;
  const { surface, solver } = model;
  const { askedFeatures: features } = doc;
  const along = features ? { features: toFeatures(features) } : {};
  const { components, error } = await solver.check({ ...toCones(prescription), ...along });
  if (prescription !== doc.prescription || surface !== doc.model?.surface || doc.isBusy) return;
  if (features !== doc.askedFeatures) return;
  const refusal = components.find((one) => one.error)?.error ?? error;
  const text = refusal ? messageForPage(refusal.message, refusal.advice) : '';
  const warnings = components.flatMap((one) => one.warnings).map((note) => noteForPage(note));
  doc.objection = { prescription, surface, features, text, warnings };
  if (text !== '') doc.say(text, 'error', chooseAlong(app));
}

/** Checks after every change; a check takes milliseconds, and along features a part of the time of a run. */
export function watchCones(app: App): () => void {
  const { doc } = app;
  let last: Partial<Checked> = {};
  return effect(() => {
    const { prescription, usableModel, hasUserCones, budget, isBusy, objection, live, automatic } =
      doc;
    const { askedFeatures: features, choosesCones } = doc;
    if (isBusy || (live && !automatic) || !usableModel || !hasUserCones || !budget) return;
    if (choosesCones || features?.isSymmetric) return; // others come, or a plane with edges of its own
    const now = { prescription, surface: usableModel.surface, features };
    if (!budget.isReady || isAbout(now, objection) || isAbout(now, last)) return;
    last = now;
    check(app, prescription, usableModel).catch(() => undefined); // Run reports errors
  });
}
