// Which edges become straight lines: creases that are found, rims, chains that are chosen.

import {
  edgesOf,
  hasFeatures,
  noFeatures,
  toFeatures,
  withChain,
  type Edge,
  type FeatureChoice,
} from '../model/features';
import { describeError } from '../text/error_messages';
import { plural } from '../text/format';
import type { App } from './app';
import { saveFile } from './download';
import { isLocked } from './job';
import { edgeMap } from './keep_features';

function choose(app: App, choice: FeatureChoice): void {
  const rims = edgeMap(app)?.rims() ?? [];
  app.doc.features = hasFeatures(choice) ? { ...choice, rims } : undefined;
}

/** Takes the creases that hgp finds, beside what is chosen already; or none of them. */
export async function followCreases(app: App, isOn: boolean): Promise<void> {
  const { doc } = app;
  const { usableModel: model, features = noFeatures } = doc;
  const map = edgeMap(app);
  if (!model || !map || isLocked(app)) return;
  try {
    const { text } = await model.solver.listFeatures({ creases: 30 });
    if (doc.usableModel !== model) return;
    const found = edgesOf(text).filter((edge) => !map.isRim(edge));
    if (isOn && found.length === 0) {
      doc.say('The surface bends by more than 30° at no edge. Choose edges in the 3D view.');
      doc.features = features === noFeatures ? undefined : { ...features };
      return;
    }
    choose(app, { ...withChain(features, found, !isOn), hasCreases: isOn });
  } catch (error) {
    doc.say(describeError(error, model.main), 'error');
  }
}

export function followRims(app: App, isOn: boolean): void {
  if (isLocked(app)) return;
  choose(app, { ...(app.doc.features ?? noFeatures), hasRims: isOn });
}

/** Asks for a map that is its own mirror image. */
export function mirrorMap(app: App, isOn: boolean): void {
  if (isLocked(app)) return;
  choose(app, { ...(app.doc.features ?? noFeatures), isSymmetric: isOn });
}

/** Chooses the chain through an edge, or takes it out. */
export function chooseChain(app: App, edge: Edge, isRemoved: boolean): void {
  const { doc } = app;
  const map = edgeMap(app);
  if (!map || isLocked(app)) return;
  const chain = map.chainThrough(edge);
  if (map.isRim(edge)) return followRims(app, !isRemoved);
  choose(app, withChain(doc.features ?? noFeatures, chain, isRemoved));
  const what = plural(chain.length, 'edge');
  doc.say(
    isRemoved ? `${what} no longer followed.` : `${what} chosen. Alt and a click removes them.`,
  );
}

export function clearFeatures(app: App): void {
  if (!isLocked(app)) app.doc.features = undefined;
}

/** Saves the chosen edges, for `hgp param --features`. */
export async function exportFeatures({ doc }: App): Promise<void> {
  const { usableModel: model, features } = doc;
  if (!model || !features) return;
  const { text } = await model.solver.listFeatures(toFeatures(features));
  const stem = model.main.replace(/^.*\//, '').replace(/\.[^.]*$/, '');
  const bytes = new TextEncoder().encode(text);
  await saveFile({ name: `${stem}.features.json`, bytes, type: 'application/json' });
}
