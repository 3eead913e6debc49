// Settings for a purpose, by one click.

import { hasLongCreases } from '../model/features';
import type { App } from './app';
import { setConeStep } from './cone_slider';
import { fewStep } from './cone_steps';
import { followCreases } from './features';
import { isLocked } from './job';
import { run } from './solve';

export type Preset = 'tiling' | 'quads' | 'few';

export const presets: readonly { id: Preset; label: string; hint: string }[] = [
  { id: 'tiling', label: 'Tiling texture', hint: 'lines of a texture meet at every seam' },
  {
    id: 'quads',
    label: 'Quad mesh',
    hint: 'cones on grid points, lines along long creases; Download offers quads',
  },
  { id: 'few', label: 'Few cones', hint: 'as few cones as keep sizes reasonably even' },
];

/** A quad mesh of a part that cuts across its creases is of no use. */
async function followLongCreases(app: App): Promise<void> {
  const { usableModel: model, features, prescription } = app.doc;
  if (model && !features && prescription.q === 4 && hasLongCreases(model.info)) {
    await followCreases(app, true);
  }
}

/** Sets what a purpose needs; a map that is there is made anew. */
export async function usePreset(app: App, preset: Preset): Promise<void> {
  const { doc, ui } = app;
  if (isLocked(app)) return;
  if (preset === 'few') {
    const hadMap = doc.displayed !== undefined;
    await setConeStep(app, fewStep);
    if (hadMap && !doc.current) await run(app);
    return;
  }
  const isForQuads = preset === 'quads';
  if (isForQuads) ui.setTarget('quads');
  else if (ui.target === 'quads') ui.setTarget('blender');
  const hadMap = doc.current !== undefined;
  const grid = { isOn: true, mode: isForQuads ? 'quad' : 'tile', cells: undefined } as const;
  doc.solve = { ...doc.solve, grid: { ...doc.solve.grid, ...grid } };
  if (isForQuads) await followLongCreases(app);
  if (hadMap && !doc.current && !doc.isBusy) await run(app);
}

/** Whether the settings are those of a preset. */
export function isPreset({ doc }: App, preset: Preset): boolean {
  const { grid } = doc.solve;
  if (preset === 'few') return doc.coneStep === fewStep;
  return grid.isOn && grid.cells === undefined && (grid.mode === 'quad') === (preset === 'quads');
}
