// Actions on the views: highlights, loops, patterns, projections. None of them changes the prescription.

import type { Where } from 'hgp';
import { lights, overlays, patterns, type Look, type Model, type Pattern } from '../model/types';
import { count } from '../text/format';
import { highlightTargets } from '../views/highlight_targets';
import type { App } from './app';
import { select } from './edit_cones';

export function setLook({ doc }: App, part: Partial<Look>): void {
  doc.look = { ...doc.look, ...part };
}

/** Patterns that need no further input. */
const plainPatterns: readonly Pattern[] = patterns.filter(
  (name) => name !== 'image' && name !== 'material',
);

export function nextPattern(app: App): void {
  const at = plainPatterns.indexOf(app.doc.look.pattern);
  setLook(app, { pattern: plainPatterns[(at + 1) % plainPatterns.length] });
}

export function nextLight(app: App): void {
  const at = lights.indexOf(app.doc.look.light);
  setLook(app, { light: lights[(at + 1) % lights.length] });
}

export function nextOverlay(app: App): void {
  const at = overlays.indexOf(app.doc.look.overlay);
  setLook(app, { overlay: overlays[(at + 1) % overlays.length] });
}

const decades = 2; // range of the scale as a power of ten: from 3 tiles to 300
export const sliderOf = (tiles: number): number =>
  Math.round((100 / decades) * Math.log10(tiles / 3));
export const tilesOf = (slider: number): number => 3 * 10 ** ((decades * slider) / 100);

/** Asks for one file. */
export function chooseFile(accept: string): Promise<File | undefined> {
  const input = document.createElement('input');
  input.type = 'file';
  input.accept = accept;
  return new Promise((resolve) => {
    input.addEventListener('change', () => resolve(input.files?.[0]));
    input.addEventListener('cancel', () => resolve(undefined));
    input.click();
  });
}

export async function choosePattern(app: App, pattern: Pattern): Promise<void> {
  if (pattern !== 'image') return setLook(app, { pattern });
  const file = await chooseFile('image/png,image/jpeg,image/webp');
  if (!file) return setLook(app, {}); // so that the list shows the previous choice again
  try {
    const image = await createImageBitmap(file, { imageOrientation: 'flipY' });
    setLook(app, { pattern: 'image', image });
  } catch {
    app.doc.say(`“${file.name}” is not an image that this browser can read.`, 'error');
    setLook(app, {});
  }
}

/** Centres a cone in the view and selects it. */
export function lookAtCone(app: App, index: number): void {
  const cone = app.doc.prescription.cones[index];
  if (!cone) return;
  select(app, index);
  app.views?.model.lookAt(cone.vertex);
  app.ui.tab = 'surface';
}

/** Centres the selected cone, or shows the whole model. */
export function frame(app: App): void {
  const { doc, views } = app;
  if (doc.selected >= 0) return lookAtCone(app, doc.selected);
  views?.model.orbit.fit();
  views?.uv.fit();
  views?.model.draw();
}

/** Outlines places in both views and shows a vertex, by default of the first. */
export function showPlaces({ doc, ui, views }: App, where: Where[], at?: number): void {
  const { model, displayed } = doc;
  if (!model) return;
  const targets = highlightTargets(where, model.surface, displayed);
  views?.model.highlight(targets.triangles, targets.edges);
  views?.uv.highlight(targets.triangles, targets.uvEdges);
  const first = at ?? targets.first;
  if (first >= 0) views?.model.lookAt(first, false);
  const isPlain = where.every(({ kind }) => kind === 'triangle');
  const what = isPlain ? 'triangles are outlined' : 'places are shown';
  doc.say(
    where.length === 1 ? `Shown: ${targets.text}.` : `${count(where.length)} ${what}, in pink.`,
  );
  ui.tab = 'surface';
}

export function clearHighlight({ views }: App): void {
  views?.model.highlight([]);
  views?.uv.highlight([]);
}

async function handleLines(app: App, model: Model): Promise<Float32Array[]> {
  const { surface, solver } = model;
  const { handles } = await solver.loops();
  if (app.doc.model !== model) return [];
  return app.geometry.call('loopSegments', [surface.id, handles]);
}

/** Shows or hides the loops around handles, in the colours of their rows in the panel. */
export async function showHandles(app: App, isOn: boolean): Promise<void> {
  const { doc, ui, views } = app;
  ui.handlesShown = isOn;
  const { model } = doc;
  const loops = isOn && model ? await handleLines(app, model) : [];
  if (doc.model === model) views?.model.setHandles(loops);
}

/** Moves the focus to the other view, which in a narrow window replaces this one. */
export function otherView({ ui }: App): void {
  const isMap = document.activeElement?.id === 'map';
  ui.tab = isMap ? 'surface' : 'map';
  setTimeout(() => document.querySelector<HTMLElement>(isMap ? '#view' : '#map')?.focus());
}
