// Points spread evenly over a surface, the same every time: none nearer to another than the spacing.

import type { Surface } from '../state/surface';

export interface Sample {
  triangle: number;
  /** Position = first corner + s·e + r·f. */
  s: number;
  r: number;
  e: [number, number, number];
  f: [number, number, number];
}

type Vector = [number, number, number];

const tries = 5; // candidates per point that fits
const mostCandidates = 60_000;

/** Evenly spread numbers in (0, 1) from a seed. */
function sequence(seed: number): () => number {
  let x = seed | 0;
  return () => {
    x = (Math.imul(x, 1664525) + 1013904223) | 0;
    return (x >>> 8) / 2 ** 24;
  };
}

/** Accepts points that keep their distance, with a hash of cells to find the neighbours. */
class Sieve {
  readonly #cells = new Map<number, number[]>();
  readonly #size: number;
  constructor(distance: number) {
    this.#size = distance;
  }
  // Cells far apart may share a number: that costs a comparison and nothing else.
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

function sidesOf({ positions: p, triangles }: Surface, t: number): { e: Vector; f: Vector } {
  const [a, b, c] = [3 * triangles[3 * t], 3 * triangles[3 * t + 1], 3 * triangles[3 * t + 2]];
  return {
    e: [p[b] - p[a], p[b + 1] - p[a + 1], p[b + 2] - p[a + 2]],
    f: [p[c] - p[a], p[c + 1] - p[a + 1], p[c + 2] - p[a + 2]],
  };
}

function areasOf(surface: Surface): Float64Array {
  return Float64Array.from({ length: surface.triangles.length / 3 }, (_, t) => {
    const { e, f } = sidesOf(surface, t);
    const [x, y, z] = [
      e[1] * f[2] - e[2] * f[1],
      e[2] * f[0] - e[0] * f[2],
      e[0] * f[1] - e[1] * f[0],
    ];
    return Math.sqrt(x * x + y * y + z * z) / 2;
  });
}

let last: { surface: Surface; spacing: number; samples: Sample[] } | undefined;

/** Both views ask for the same points one after the other. */
export function spread(surface: Surface, spacing: number): Sample[] {
  if (last?.surface !== surface || last.spacing !== spacing) {
    last = { surface, spacing, samples: compute(surface, spacing) };
  }
  return last.samples;
}

function compute(surface: Surface, spacing: number): Sample[] {
  const { positions, triangles } = surface;
  const areas = areasOf(surface);
  const area = areas.reduce((sum, own) => sum + own, 0);
  const wanted = Math.min((tries * area) / (spacing * spacing), mostCandidates);
  const random = sequence(7);
  const candidates: { sample: Sample; order: number }[] = [];
  let owed = 0.5;
  for (let t = 0; t < areas.length; t++) {
    owed += (areas[t] / area) * wanted;
    if (owed < 1) continue;
    const { e, f } = sidesOf(surface, t);
    for (; owed >= 1; owed -= 1) {
      let [s, r] = [random(), random()];
      if (s + r > 1) [s, r] = [1 - s, 1 - r];
      candidates.push({ sample: { triangle: t, s, r, e, f }, order: random() });
    }
  }
  candidates.sort((x, y) => x.order - y.order);
  const sieve = new Sieve(0.85 * spacing);
  const isIn = ({ triangle, s, r, e, f }: Sample): boolean => {
    const a = 3 * triangles[3 * triangle];
    const [x, y, z] = [0, 1, 2].map((i) => positions[a + i] + s * e[i] + r * f[i]);
    return sieve.accepts(x, y, z);
  };
  return candidates.map(({ sample }) => sample).filter(isIn);
}
