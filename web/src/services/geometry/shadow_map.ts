// How dark the ground is under a model that stands on it: the nearer the surface is to the ground, the darker.

/** Cells along a side of the map. */
export const shadowCells = 96;
const margin = 0.28; // of the model's width, around it
const tall = 0.3; // of the model's size: what is higher than that has no shadow
const blur = 3; // cells
const rounds = 3; // of blurring, which together are nearly a Gaussian
const widestGap = 4; // cells between points that are filled
const maxPoints = 60_000;

export interface GroundShadow {
  /** How dark each cell is, 0 to 1, by rows of growing z. */
  dark: Float32Array;
  /** The middle of the square, and its side. */
  x: number;
  y: number;
  z: number;
  side: number;
}

function boundsOf(places: ArrayLike<number>, step: number): { low: number[]; high: number[] } {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let at = 0; at + 2 < places.length; at += step) {
    for (let i = 0; i < 3; i++) {
      const x = places[at + i];
      if (!Number.isFinite(x)) continue;
      low[i] = Math.min(low[i], x);
      high[i] = Math.max(high[i], x);
    }
  }
  return { low, high };
}

type Gather = (from: Float32Array, first: number, last: number, along: number) => number;

/** What `gather` makes of the cells up to `reach` away, in both directions, one after the other. */
function filtered(from: Float32Array, reach: number, gather: Gather): Float32Array {
  let now = from;
  for (const [along, across] of [
    [1, shadowCells],
    [shadowCells, 1],
  ]) {
    const out = new Float32Array(now.length);
    for (let row = 0; row < shadowCells; row++) {
      for (let at = 0; at < shadowCells; at++) {
        const [low, high] = [Math.max(0, at - reach), Math.min(shadowCells - 1, at + reach)];
        const begin = row * across;
        out[begin + at * along] = gather(now, begin + low * along, begin + high * along, along);
      }
    }
    now = out;
  }
  return now;
}

const largest: Gather = (from, first, last, along) => {
  let max = 0;
  for (let at = first; at <= last; at += along) max = Math.max(max, from[at]);
  return max;
};

const mean: Gather = (from, first, last, along) => {
  let sum = 0;
  for (let at = first; at <= last; at += along) sum += from[at];
  return sum / (2 * blur + 1);
};

/** Points of the surface as displayed, three numbers each; undefined if they have no extent. */
export function groundShadow(places: ArrayLike<number>): GroundShadow | undefined {
  const step = 3 * Math.max(1, Math.ceil(places.length / 3 / maxPoints));
  const { low, high } = boundsOf(places, step);
  const wide = Math.max(high[0] - low[0], high[2] - low[2]);
  const size = Math.max(wide, high[1] - low[1]);
  if (!(wide > 0)) return undefined;
  const side = wide * (1 + 2 * margin);
  const [x, z] = [(low[0] + high[0]) / 2, (low[2] + high[2]) / 2];
  let dark: Float32Array = new Float32Array(shadowCells * shadowCells);
  const cellOf = (value: number, middle: number): number =>
    Math.min(shadowCells - 1, Math.floor(((value - middle) / side + 0.5) * shadowCells));
  for (let at = 0; at + 2 < places.length; at += step) {
    const above = (places[at + 1] - low[1]) / (tall * size);
    if (!(above < 1)) continue;
    const cell = cellOf(places[at + 2], z) * shadowCells + cellOf(places[at], x);
    dark[cell] = Math.max(dark[cell], (1 - above) ** 2);
  }
  // Between points that are far apart, too.
  const gap = Math.ceil((0.7 * shadowCells) / Math.sqrt(places.length / step));
  dark = filtered(dark, Math.min(gap, widestGap), largest);
  for (let round = 0; round < rounds; round++) dark = filtered(dark, blur, mean);
  return { dark, x, y: low[1], z, side };
}
