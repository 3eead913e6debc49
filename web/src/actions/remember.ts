// Keeps cones, settings and view in the address of the page.

import { modelTag, writeHash } from '../formats/hash_state';
import type { App } from './app';
import { exampleById } from './open';

/** Writes the address at once. */
export function flushAddress({ doc, views }: App): void {
  const { model, look, prescription, solve } = doc;
  if (!model) return;
  const camera = views?.model.orbit.toText();
  const example = exampleById(model.main.replace(/\.glb$/, ''))?.id;
  const state = { example, look, prescription, solve, camera, model: modelTag(model.info) };
  history.replaceState(null, '', writeHash(state));
}
