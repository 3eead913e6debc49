// The cones that a model has when it is opened: of its file, of the previous version of the file, or of another reading.

import type { Model as SolverModel, ModelInfo } from 'hgp';
import {
  alongFeatures,
  emptyPrescription,
  fromCones,
  isSilent,
  toCones,
  type Prescription,
} from '../model/prescription';
import type { Model } from '../model/types';
import { restorable } from '../services/cone_storage';
import { ensureWorker } from '../services/solver';
import { describeError, isAbort } from '../text/error_messages';
import { plural } from '../text/format';
import { describeTransfer } from '../text/transfer';
import { solverOf, type App } from './app';
import { setPrescription } from './edit_cones';
import { andLines, takeFeaturesOf } from './keep_features';
import type { JobCall } from './job';

export const emptyFor = (q: number, info: ModelInfo): Prescription =>
  emptyPrescription(q, info.boundaryLoops ?? 0, 2 * (info.genus ?? 0));

interface Transferred {
  prescription: Prescription;
  kept: number;
  /** What was kept and what was not. */
  text: string;
}

/** A prescription on another reading of its surface. */
export async function transferred(
  { solver, info }: Model,
  prescription: Prescription,
  from: SolverModel,
  call: JobCall,
): Promise<Transferred> {
  if (!info.usable) {
    // Another repair may make the mesh usable; the cones are kept until then.
    const waiting = { ...prescription, turnings: [], handles: [] };
    return { prescription: waiting, kept: prescription.cones.length, text: '' };
  }
  const { cones, lost } = await solver.transferCones(toCones(prescription), from, call);
  const empty = emptyFor(prescription.q, info);
  const kept = cones.cones.length;
  return {
    prescription: fromCones(cones, empty.turnings.length, empty.handles.length),
    kept,
    text: describeTransfer(kept, lost),
  };
}

/** Whether a model is another version of the file of a previous one. */
function isNextVersion(model: Model, previous: Model): boolean {
  const { info, main, solver } = previous;
  return (
    main === model.main &&
    !solver.isDisposed &&
    info.file.sha256 !== model.info.file.sha256 &&
    (model.info.surfaces.length === 1 || info.surface === model.info.surface)
  );
}

/**
 * Moves the cones from the previous version of the file, as one undo step, and lets go of that version. Returns whether
 * it has told what became of them.
 */
export async function moveFromPrevious(app: App, model: Model, call: JobCall): Promise<boolean> {
  const { doc } = app;
  const { previous } = doc;
  doc.previous = undefined;
  if (!previous || !isNextVersion(model, previous.model)) return false;
  const another = `Another version of ${model.main}.`;
  try {
    const moved = await transferred(model, previous.prescription, previous.model.solver, call);
    if (moved.kept === 0) return false;
    // A job that loads does not prevent edits.
    setPrescription(app, moved.prescription, 'carry cones over');
    doc.say(`${another}${moved.text} Undo removes them.`);
    return true;
  } catch (error) {
    if (isAbort(error) || call.signal.aborted) throw error;
    ensureWorker(solverOf(app));
    const why = describeError(error, previous.model.main);
    doc.say(`${another} The cones of the one before could not be moved to it. ${why}`, 'error');
    return true;
  }
}

/** Takes cones from the file or its previous version. */
export async function findCones(app: App, model: Model, call: JobCall): Promise<void> {
  const { doc } = app;
  const { turnings, handles } = doc.prescription;
  const embedded = await model.solver.embeddedCones().catch(() => null);
  const hasLines = embedded !== null && takeFeaturesOf(app, embedded);
  if (!embedded || (embedded.cones.length === 0 && !hasLines))
    return void (await moveFromPrevious(app, model, call));
  doc.previous = undefined;
  const cones = hasLines ? alongFeatures(embedded) : embedded;
  doc.begin(fromCones(cones, turnings.length, handles.length));
  doc.hasUserCones = true;
  const what = `${plural(embedded.cones.length, 'cone')} came with the file`;
  const text =
    embedded.cones.length > 0
      ? `${what}${hasLines ? andLines : ''}.`
      : 'Edges that lines follow came with the file.';
  doc.message = { kind: 'note', text };
}

/** Offers the cones of an earlier session, when the browser has found them: loading does not wait for its storage. */
export async function offerSaved(app: App, model: Model): Promise<void> {
  const { doc } = app;
  const saved = await restorable(model.info);
  const count = saved?.prescription.cones.length ?? 0;
  if (!saved || count === 0) return;
  if (doc.model !== model || doc.isBusy || !isSilent(doc.prescription)) return;
  const cones = plural(count, 'cone');
  const when = new Date(saved.time).toLocaleDateString(undefined, { dateStyle: 'medium' });
  const restore = (): void => {
    setPrescription(app, saved.prescription, 'restore cones');
    doc.say(`${cones} restored.`);
  };
  const { text = '', actions = [], kind = 'note' } = doc.message ?? {};
  doc.message = {
    kind,
    text: `${text} You placed ${cones} on this file (${when}).`.trim(),
    actions: [...actions, { label: `Restore ${cones}`, run: restore }],
  };
}
