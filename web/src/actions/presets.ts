// Settings for a purpose, by one click.

import type { App } from './app';
import { setConeStep } from './cone_slider';
import { fewStep } from './cone_steps';
import { isLocked } from './job';
import { realign, run } from './solve';

export type Preset = 'tiling' | 'quads' | 'few';

export const presets: readonly { id: Preset; label: string; hint: string }[] = [
  { id: 'tiling', label: 'Tiling texture', hint: 'lines of a texture meet at every seam' },
  { id: 'quads', label: 'Quad mesh', hint: 'cones on grid points; Download offers quads' },
  { id: 'few', label: 'Few cones', hint: 'as few cones as keep sizes reasonably even' },
];

/** Sets what a purpose needs; a map that is there is made anew. */
export async function usePreset(app: App, preset: Preset): Promise<void> {
  const { doc, ui } = app;
  if (isLocked(app)) return;
  const hadMap = doc.displayed !== undefined;
  if (preset === 'few') {
    await setConeStep(app, fewStep);
    if (hadMap && !doc.current) await run(app);
    return;
  }
  if (preset === 'quads') ui.setTarget('quads');
  else if (ui.target === 'quads') ui.setTarget('blender');
  await realign(app, { isOn: true, mode: preset === 'quads' ? 'quad' : 'tile', cells: undefined });
}

/** Whether the settings are those of a preset. */
export function isPreset({ doc }: App, preset: Preset): boolean {
  const { grid } = doc.solve;
  if (preset === 'few') return doc.coneStep === fewStep;
  return grid.isOn && grid.cells === undefined && (grid.mode === 'quad') === (preset === 'quads');
}
