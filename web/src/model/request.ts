// What a map is asked with: by Run, to make the same map once more, and to write it again.

import type { SolveOptions } from 'hgp';
import { hasEdges, toFeatures, type FeatureChoice } from './features';
import { toCones, type Prescription } from './prescription';
import type { DirectionField, Solution, SolveRequest } from './types';

/** Rounds of Run unless the user chose others. */
export const plainRounds = 12;

/** What decides a map, apart from its grid. */
export interface Asked {
  prescription: Prescription;
  /** Whether the solver chooses the cones. */
  isAutomatic?: boolean;
  /** Edges that lines follow; they bring their cones, unless those that are placed are kept. */
  features?: FeatureChoice;
  /** Whose directions are the frames. */
  field?: DirectionField;
  rounds: number;
  improve?: number;
  scale: NonNullable<SolveOptions['scale']>;
  /** Whether components without a map do not stop the others. */
  keepGoing: boolean;
}

/** The prescription of a run, in the one form that there is for it. */
export function runOptions(asked: Asked): SolveOptions {
  const { prescription, isAutomatic, features, field, rounds, improve, scale, keepGoing } = asked;
  const common = { maxRounds: rounds, improve, scale, keepGoing };
  const { q } = prescription;
  const isChosen = features ? !features.keepsCones : isAutomatic;
  const cones = isChosen ? { q } : { cones: toCones(prescription) };
  if (features) {
    const edges = hasEdges(features) ? { features: toFeatures(features) } : {};
    const mirrored = features.isSymmetric ? { symmetric: 'auto' as const } : {};
    return { ...cones, ...edges, ...mirrored, ...common };
  }
  const framed = field ? { field, frames: 'file' as const } : {};
  return { ...cones, ...framed, ...common };
}

/** The same for a map that exists, in a scale. */
export function optionsAgain(solution: Solution, scale: Asked['scale']): SolveOptions {
  const { prescription, features, field, improve, result } = solution;
  const { options, components } = result.report;
  const { rounds } = options;
  const keepGoing = components.length > 1;
  return runOptions({ prescription, features, field, rounds, improve, scale, keepGoing });
}

export function requestOf(solution: Solution): SolveRequest {
  const { prescription, settings, improve, frames, field, features } = solution;
  const { grid, cells, output, isDragged } = solution;
  return {
    prescription,
    settings,
    improve,
    frames,
    field,
    features,
    grid,
    cells,
    output,
    isDragged,
  };
}
