// The quad mesh that the solver writes, as an OBJ, for showing it.

export interface QuadShape {
  /** Three numbers per vertex, in the coordinates of the mesh. */
  positions: Float64Array;
  /** Four vertices per quad. */
  quads: Uint32Array;
}

/** Reads the lines v and f of an OBJ whose faces are quads. */
export function readQuads(bytes: Uint8Array): QuadShape {
  const positions: number[] = [];
  const quads: number[] = [];
  for (const line of new TextDecoder().decode(bytes).split('\n')) {
    const [word, ...rest] = line.trim().split(/\s+/);
    if (word === 'v') positions.push(...rest.slice(0, 3).map(Number));
    else if (word === 'f' && rest.length === 4) quads.push(...rest.map((x) => parseInt(x) - 1));
  }
  return { positions: Float64Array.from(positions), quads: Uint32Array.from(quads) };
}

/** Vertices by number of edges, boundary vertices left out: 3 → their number, 5 → …; and what is irregular. */
export function valencesOf({ positions, quads }: QuadShape): {
  counts: Map<number, number>;
  irregular: { vertex: number; valence: number }[];
} {
  const sides = new Map<number, number>(); // of an edge: how many quads
  const n = positions.length / 3;
  const valence = new Uint32Array(n);
  for (let c = 0; c < quads.length; c++) {
    const [v, w] = [quads[c], quads[c % 4 === 3 ? c - 3 : c + 1]];
    const key = Math.min(v, w) * n + Math.max(v, w);
    sides.set(key, (sides.get(key) ?? 0) + 1);
  }
  const isBoundary = new Uint8Array(n);
  for (const [key, count] of sides) {
    const ends = [Math.floor(key / n), key % n];
    for (const v of ends) {
      valence[v] += 1;
      if (count === 1) isBoundary[v] = 1;
    }
  }
  const counts = new Map<number, number>();
  const irregular: { vertex: number; valence: number }[] = [];
  valence.forEach((k, vertex) => {
    if (k === 0 || isBoundary[vertex]) return;
    counts.set(k, (counts.get(k) ?? 0) + 1);
    if (k !== 4) irregular.push({ vertex, valence: k });
  });
  return { counts, irregular };
}

type Vector = [number, number, number];

/** Twice the area vector at each corner of a quad. */
function cornerVectors({ positions: p, quads }: QuadShape, f: number): Vector[] {
  return [0, 1, 2, 3].map((k): Vector => {
    const [a, b, c] = [k, (k + 1) % 4, (k + 3) % 4].map((i) => 3 * quads[4 * f + i]);
    const [ux, uy, uz] = [p[b] - p[a], p[b + 1] - p[a + 1], p[b + 2] - p[a + 2]];
    const [vx, vy, vz] = [p[c] - p[a], p[c + 1] - p[a + 1], p[c + 2] - p[a + 2]];
    return [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
  });
}

/** The mean direction of a quad, and whether a corner of it is turned over against that. */
export function bendOf(shape: QuadShape, f: number): { normal: Vector; isFolded: boolean } {
  const corners = cornerVectors(shape, f);
  const normal = [0, 1, 2].map((i) => corners.reduce((sum, one) => sum + one[i], 0)) as Vector;
  const isFolded = corners.some((one) => one.reduce((sum, x, i) => sum + x * normal[i], 0) < 0);
  return { normal, isFolded };
}
