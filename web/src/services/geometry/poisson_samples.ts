// Points evenly distributed over a surface (Poisson disk sampling), at least `spacing` apart. Deterministic.

import type { Surface } from '../../model/types';
import { randomSequence } from './random_sequence';
import { areaOf } from '../../model/triangle';

export interface Sample {
  triangle: number;
  /** Position = first corner + s·e + r·f. */
  s: number;
  r: number;
  e: [number, number, number];
  f: [number, number, number];
}

type SampledSurface = Pick<Surface, 'positions' | 'triangles'>;
type Vector = [number, number, number];

const tries = 5; // candidates per point that fits
const maxCandidates = 60_000;

/** Accepts points that are far enough from all others, with a hash grid to find neighbours. */
class NeighbourGrid {
  readonly #cells = new Map<number, number[]>();
  readonly #size: number;
  constructor(distance: number) {
    this.#size = distance;
  }
  // Distant cells may have the same key, which only costs a comparison.
  #key(i: number, j: number, k: number): number {
    return (i * 73856093) ^ (j * 19349663) ^ (k * 83492791);
  }
  accepts(x: number, y: number, z: number): boolean {
    const size = this.#size;
    const [i, j, k] = [Math.floor(x / size), Math.floor(y / size), Math.floor(z / size)];
    for (let n = 0; n < 27; n++) {
      const key = this.#key(
        i + (n % 3) - 1,
        j + (Math.floor(n / 3) % 3) - 1,
        k + Math.floor(n / 9) - 1,
      );
      const near = this.#cells.get(key);
      for (let m = 0; near && m < near.length; m += 3) {
        const far = (near[m] - x) ** 2 + (near[m + 1] - y) ** 2 + (near[m + 2] - z) ** 2;
        if (far < size * size) return false;
      }
    }
    const own = this.#cells.get(this.#key(i, j, k));
    if (own) own.push(x, y, z);
    else this.#cells.set(this.#key(i, j, k), [x, y, z]);
    return true;
  }
}

function sidesOf({ positions: p, triangles }: SampledSurface, t: number): { e: Vector; f: Vector } {
  const [a, b, c] = [3 * triangles[3 * t], 3 * triangles[3 * t + 1], 3 * triangles[3 * t + 2]];
  return {
    e: [p[b] - p[a], p[b + 1] - p[a + 1], p[b + 2] - p[a + 2]],
    f: [p[c] - p[a], p[c + 1] - p[a + 1], p[c + 2] - p[a + 2]],
  };
}

/** The spacing of crosses for this number of tiles along the diagonal. */
export const spacingOf = ({ diagonal }: Pick<Surface, 'diagonal'>, tiles: number): number =>
  diagonal / (tiles * 1.3);

export function poissonSamples(surface: SampledSurface, spacing: number): Sample[] {
  const sampler = new PoissonSampler(surface, spacing);
  for (let t = 0; t < sampler.count; t++) sampler.propose(t);
  return sampler.sorted().filter((one) => sampler.accepts(one));
}

/** Proposes points in proportion to area and keeps those that are far enough from all others. */
class PoissonSampler {
  readonly count: number;
  readonly #surface: SampledSurface;
  readonly #areas: Float64Array;
  readonly #each: number; // candidates per unit of area
  readonly #random = randomSequence(7);
  readonly #grid: NeighbourGrid;
  readonly #candidates: { sample: Sample; order: number }[] = [];
  #pendingCandidates = 0.5;

  constructor(surface: SampledSurface, spacing: number) {
    this.#surface = surface;
    this.count = surface.triangles.length / 3;
    this.#areas = new Float64Array(this.count);
    let area = 0;
    for (let t = 0; t < this.count; t++) area += this.#areas[t] = areaOf(surface, t);
    const wanted = Math.min((tries * area) / (spacing * spacing), maxCandidates);
    this.#each = area > 0 ? wanted / area : 0;
    this.#grid = new NeighbourGrid(0.85 * spacing);
  }

  propose(t: number): void {
    this.#pendingCandidates += this.#areas[t] * this.#each;
    if (this.#pendingCandidates < 1) return;
    const { e, f } = sidesOf(this.#surface, t);
    for (; this.#pendingCandidates >= 1; this.#pendingCandidates -= 1) {
      let [s, r] = [this.#random(), this.#random()];
      if (s + r > 1) [s, r] = [1 - s, 1 - r];
      this.#candidates.push({ sample: { triangle: t, s, r, e, f }, order: this.#random() });
    }
  }

  /** The samples in a pseudo-random but reproducible order. */
  sorted(): Sample[] {
    return this.#candidates.sort((x, y) => x.order - y.order).map(({ sample }) => sample);
  }

  accepts({ triangle, s, r, e, f }: Sample): boolean {
    const { positions: p, triangles } = this.#surface;
    const a = 3 * triangles[3 * triangle];
    return this.#grid.accepts(
      p[a] + s * e[0] + r * f[0],
      p[a + 1] + s * e[1] + r * f[1],
      p[a + 2] + s * e[2] + r * f[2],
    );
  }
}
