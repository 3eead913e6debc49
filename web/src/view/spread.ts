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
  readonly #cells = new Map<string, Vector[]>();
  readonly #size: number;
  constructor(distance: number) {
    this.#size = distance;
  }
  accepts(p: Vector): boolean {
    const cell = p.map((x) => Math.floor(x / this.#size));
    for (let i = 0; i < 27; i++) {
      const [dx, dy, dz] = [i % 3, Math.floor(i / 3) % 3, Math.floor(i / 9)].map((d) => d - 1);
      const near = this.#cells.get(`${cell[0] + dx} ${cell[1] + dy} ${cell[2] + dz}`);
      const isNear = (o: Vector): boolean =>
        Math.hypot(o[0] - p[0], o[1] - p[1], o[2] - p[2]) < this.#size;
      if (near?.some(isNear)) return false;
    }
    const key = cell.join(' ');
    this.#cells.set(key, [...(this.#cells.get(key) ?? []), p]);
    return true;
  }
}

interface Face {
  e: Vector;
  f: Vector;
  area: number;
}

function faceOf({ positions: p, triangles }: Surface, t: number): Face {
  const [a, b, c] = [0, 1, 2].map((k) => 3 * triangles[3 * t + k]);
  const e = [0, 1, 2].map((i) => p[b + i] - p[a + i]) as Vector;
  const f = [0, 1, 2].map((i) => p[c + i] - p[a + i]) as Vector;
  const n: Vector = [
    e[1] * f[2] - e[2] * f[1],
    e[2] * f[0] - e[0] * f[2],
    e[0] * f[1] - e[1] * f[0],
  ];
  const size = Math.hypot(...n);
  return { e, f, area: size / 2 };
}

export function spread(surface: Surface, spacing: number): Sample[] {
  const { positions, triangles } = surface;
  const count = triangles.length / 3;
  const faces = Array.from({ length: count }, (_, t) => faceOf(surface, t));
  const area = faces.reduce((sum, face) => sum + face.area, 0);
  const wanted = Math.min((tries * area) / (spacing * spacing), mostCandidates);
  const random = sequence(7);
  const candidates: { sample: Sample; at: Vector; order: number }[] = [];
  let owed = 0.5;
  for (let t = 0; t < count; t++) {
    const { e, f, area: own } = faces[t];
    owed += (own / area) * wanted;
    for (; owed >= 1; owed -= 1) {
      let [s, r] = [random(), random()];
      if (s + r > 1) [s, r] = [1 - s, 1 - r];
      const a = 3 * triangles[3 * t];
      const at = [0, 1, 2].map((m) => positions[a + m] + s * e[m] + r * f[m]) as Vector;
      candidates.push({ sample: { triangle: t, s, r, e, f }, at, order: random() });
    }
  }
  candidates.sort((x, y) => x.order - y.order);
  const sieve = new Sieve(0.85 * spacing);
  return candidates.filter(({ at }) => sieve.accepts(at)).map(({ sample }) => sample);
}
