// Keeps cones, settings and view in the address of the page.

import { modelTag, writeHash } from '../formats/hash_state';
import type { App } from './app';
import { exampleById } from './open';

/** Writes the address at once; returns what it leaves out because it is too long. */
export function flushAddress({ doc, views }: App): string[] {
  const { model, look, prescription, solve, features } = doc;
  if (!model) return [];
  const camera = views?.model.orbit.toText();
  const example = exampleById(model.main.replace(/\.glb$/, ''))?.id;
  const tag = modelTag(model.info);
  const state = { example, look, prescription, solve, features, camera, model: tag };
  const { hash, omitted } = writeHash(state);
  history.replaceState(null, '', hash);
  return omitted;
}
