// The cones of a run that has none: as few as give a good map, and otherwise those that balance number and distortion.

import { HgpError, type SolveOptions } from 'hgp';
import { isAsGoodWithFew, isFewTried, isGoodWithFew, isPossibleWithFew } from '../model/few_cones';
import { gridOutcome } from '../model/grid';
import type { Model } from '../model/types';
import { solveAligned, type Aligned } from './align';
import type { App } from './app';
import { balancedStep, fewStep } from './cone_steps';
import type { JobCall } from './job';

export interface Automatic extends Aligned {
  /** Where the slider between few cones and little distortion then is. */
  step: number;
}

/**
 * Solves with few cones first; their map is kept if it is good, and aligned where that is asked. Otherwise more are tried,
 * and few kept only where more are no better.
 */
export async function solveAutomatic(
  app: App,
  model: Model,
  options: SolveOptions,
  call: JobCall,
): Promise<Automatic> {
  const few = isFewTried(model.info.triangles)
    ? await withFew(app, model, options, call)
    : undefined;
  if (few && isGoodWithFew(few.map.certificate)) return { ...few, step: fewStep };
  let more: Aligned;
  try {
    more = await solveAligned(app, model, options, call);
  } catch (error) {
    if (few && error instanceof HgpError && error.code === 'no-map')
      return { ...few, step: fewStep };
    void few?.map.dispose();
    throw error;
  }
  if (few && isAsGoodWithFew(few.map.certificate, more.map.certificate)) {
    await more.map.dispose();
    return { ...few, step: fewStep };
  }
  await few?.map.dispose();
  return { ...more, step: balancedStep };
}

/** Undefined if there is no map with few cones, or none that stretches little and is as asked. */
async function withFew(
  app: App,
  model: Model,
  options: SolveOptions,
  call: JobCall,
): Promise<Aligned | undefined> {
  try {
    const few = await solveAligned(app, model, { ...options, conesFor: 'few' }, call);
    const isAligned = gridOutcome({ result: few.map })?.isAligned ?? true;
    if (isAligned && isPossibleWithFew(few.map.certificate)) return few;
    await few.map.dispose();
    return undefined;
  } catch (error) {
    if (error instanceof HgpError && error.code === 'no-map') return undefined;
    throw error;
  }
}
