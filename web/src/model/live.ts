// What is shown of a cone while it is dragged: maps that are not stored.

import type { DragFrame } from 'hgp';
import type { Solution } from './types';

/**
 * `heat`: only the scale at this place is known, and the map is that of an earlier one. `certified`: this map passes the
 * certificate and is not stored. `fails`: it does not pass. `storing`: the map that passed is being written and verified.
 */
export type LiveState = DragFrame['state'] | 'storing';

export interface LiveMap {
  /** The solution from which the cone is dragged. */
  base: Solution;
  state: LiveState;
  /** Two numbers per triangle corner. */
  cornerUv: Float32Array;
  /** log₂ of the area scale by surface vertex, relative to its mean; NaN on other components; empty unless `heat`. */
  heat: Float32Array;
  notPositive: Uint32Array;
  reasons: string[];
}

function cornersOf({ uv, cornerToUv }: DragFrame): Float32Array {
  const out = new Float32Array(2 * cornerToUv.length);
  for (let c = 0; c < cornerToUv.length; c++) {
    out[2 * c] = uv[2 * cornerToUv[c]];
    out[2 * c + 1] = uv[2 * cornerToUv[c] + 1];
  }
  return out;
}

function heatOf(logScale: Float32Array): Float32Array {
  const heat = logScale.map((u) => (2 * u) / Math.LN2);
  const known = heat.filter((x) => !Number.isNaN(x));
  const mean = known.reduce((sum, x) => sum + x, 0) / Math.max(1, known.length);
  return heat.map((x) => x - mean);
}

/** The picture until the first frame is there. */
export const beforeFirst = (base: Solution): LiveMap => ({
  base,
  state: 'heat',
  cornerUv: base.cornerUv,
  heat: new Float32Array(0),
  notPositive: new Uint32Array(0),
  reasons: [],
});

/** The map of other cones, with the scale that these will have. */
export const heatMapOf = (base: Solution, logScale: Float32Array): LiveMap => ({
  ...beforeFirst(base),
  heat: heatOf(logScale),
});

/** The next picture of a drag; without a map, the previous one stays. */
export function liveMapOf(base: Solution, frame: DragFrame, before: LiveMap | undefined): LiveMap {
  const isHeat = frame.state === 'heat';
  return {
    base,
    state: frame.state,
    cornerUv: isHeat ? (before?.cornerUv ?? base.cornerUv) : cornersOf(frame),
    heat: isHeat ? heatOf(frame.logScale) : new Float32Array(0),
    notPositive: frame.notPositive,
    reasons: frame.reasons,
  };
}
