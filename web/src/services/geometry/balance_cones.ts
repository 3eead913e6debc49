// Places missing cones where they cause the least distortion. The scale of the map is e^u with
// Δu = K − Σ 2π(q − kᵢ)/q δᵢ (curvature that cones do not absorb causes stretch), so a cone of the missing sign is
// placed where u is most extreme; one at a time, because each changes u.

import type { Cone } from '../../model/prescription';
import { largestK } from '../../model/gauss_bonnet';
import type { Surface } from '../../model/types';

export type Graph = Pick<
  Surface,
  | 'positions'
  | 'triangles'
  | 'diagonal'
  | 'neighbourStart'
  | 'neighbours'
  | 'angle'
  | 'isBoundary'
  | 'component'
  | 'valence'
  | 'representative'
>;

type Weighted = Graph & { weights: Float64Array };

const smallestWeight = 1e-2;
const apart = 0.06; // of the diagonal: cones are not placed nearer to each other if there is another place
const mostSteps = 400; // of conjugate gradients
const accuracy = 1e-4; // relative to the initial residual
const mostCones = 256;

/** Of edges, in the order of `neighbours`: the cotangent weights, kept positive. */
export function weightsOf({
  positions: p,
  triangles,
  representative,
  neighbourStart,
  neighbours,
}: Graph): Float64Array {
  const weights = new Float64Array(neighbours.length);
  const add = (v: number, w: number, x: number): void => {
    for (let n = neighbourStart[v]; n < neighbourStart[v + 1]; n++)
      if (neighbours[n] === w) weights[n] += x;
  };
  for (let c = 0; c < triangles.length; c++) {
    const t = c - (c % 3);
    const [o, a, b] = [c, t + ((c + 1) % 3), t + ((c + 2) % 3)].map((at) => triangles[at]);
    const [u, w] = [a, b].map((end) => [0, 1, 2].map((i) => p[3 * end + i] - p[3 * o + i]));
    const dot = u[0] * w[0] + u[1] * w[1] + u[2] * w[2];
    const across = Math.hypot(u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]); // prettier-ignore
    const half = dot / across / 2;
    if (!Number.isFinite(half)) continue;
    const [v, x] = [representative[a], representative[b]];
    if (v < 0 || x < 0) continue;
    add(v, x, half);
    add(x, v, half);
  }
  // Negative weights of obtuse triangles would move the extremes of u away from curvature.
  return weights.map((x) => Math.min(Math.max(x, smallestWeight), 1 / smallestWeight));
}

/** Spreads from each cone along edges as far as `reach`: the vertices that are nearer than that to one. */
function nearTo(
  { positions: p, neighbourStart, neighbours }: Graph,
  cones: readonly Cone[],
  reach: number,
): Set<number> {
  const near = new Set<number>();
  const square = reach * reach;
  for (const { vertex } of cones) {
    const open = [vertex];
    const seen = new Set(open);
    for (const v of open) {
      near.add(v);
      for (let n = neighbourStart[v]; n < neighbourStart[v + 1]; n++) {
        const w = neighbours[n];
        const [x, y, z] = [0, 1, 2].map((i) => p[3 * w + i] - p[3 * vertex + i]);
        if (seen.has(w) || x * x + y * y + z * z > square) continue;
        seen.add(w);
        open.push(w);
      }
    }
  }
  return near;
}

/** out = L x with the cotangent Laplacian. */
function laplacian(
  { neighbourStart, neighbours, weights }: Weighted,
  x: Float64Array,
  out: Float64Array,
): void {
  for (let v = 0; v + 1 < neighbourStart.length; v++) {
    let sum = 0;
    for (let n = neighbourStart[v]; n < neighbourStart[v + 1]; n++)
      sum += weights[n] * (x[v] - x[neighbours[n]]);
    out[v] = sum;
  }
}

const dot = (a: Float64Array, b: Float64Array): number => {
  let sum = 0;
  for (let i = 0; i < a.length; i++) sum += a[i] * b[i];
  return sum;
};

/** Solves L u = b by conjugate gradients, starting from u; the sum of b vanishes on every component. */
function solve(graph: Weighted, b: Float64Array, u: Float64Array): void {
  const r = new Float64Array(b.length);
  const lp = new Float64Array(b.length);
  laplacian(graph, u, r);
  for (let i = 0; i < r.length; i++) r[i] = b[i] - r[i];
  const p = r.slice();
  let rr = dot(r, r);
  const enough = accuracy ** 2 * dot(b, b);
  for (let step = 0; step < mostSteps && rr > enough; step++) {
    laplacian(graph, p, lp);
    const alpha = rr / dot(p, lp);
    for (let i = 0; i < u.length; i++) {
      u[i] += alpha * p[i];
      r[i] -= alpha * lp[i];
    }
    const next = dot(r, r);
    const beta = next / rr;
    rr = next;
    for (let i = 0; i < p.length; i++) p[i] = r[i] + beta * p[i];
  }
}

/** The curvature that cones do not absorb, minus its mean on each component. */
function rightHandSide(graph: Graph, q: number, cones: readonly Cone[]): Float64Array {
  const { angle, isBoundary, component, neighbourStart } = graph;
  const b = new Float64Array(angle.length);
  const isThere = (v: number): boolean => neighbourStart[v + 1] > neighbourStart[v];
  for (let v = 0; v < b.length; v++) {
    if (isThere(v) && !isBoundary[v]) b[v] = 2 * Math.PI - angle[v];
  }
  for (const { vertex, k } of cones) b[vertex] -= (2 * Math.PI * (q - k)) / q;
  const sums = new Map<number, [sum: number, count: number]>();
  for (let v = 0; v < b.length; v++) {
    if (!isThere(v)) continue;
    const entry = sums.get(component[v]) ?? [0, 0];
    sums.set(component[v], [entry[0] + b[v], entry[1] + 1]);
  }
  for (let v = 0; v < b.length; v++) {
    const [sum, count] = sums.get(component[v]) ?? [0, 1];
    if (isThere(v)) b[v] -= sum / count;
  }
  return b;
}

/** The vertices that share a triangle with a cone, at which no other cone may be placed. */
function takenBy({ neighbourStart, neighbours }: Graph, cones: readonly Cone[]): Set<number> {
  const taken = new Set<number>();
  for (const { vertex } of cones) {
    taken.add(vertex);
    for (let n = neighbourStart[vertex]; n < neighbourStart[vertex + 1]; n++)
      taken.add(neighbours[n]);
  }
  return taken;
}

/** The vertex where the scale of the map is most extreme, of those that may take a cone. */
function mostExtreme(
  { component, isBoundary, representative }: Graph,
  u: Float64Array,
  { of, sign, isAllowed }: { of: number; sign: number; isAllowed: (v: number) => boolean },
): number {
  let best = -1;
  for (let v = 0; v < u.length; v++) {
    if (component[v] !== of || isBoundary[v] || representative[v] !== v || !isAllowed(v)) continue;
    if (best < 0 || sign * u[v] > sign * u[best]) best = v;
  }
  return best;
}

/**
 * Adds one cone to `added`; a component of few vertices takes cones that share a triangle, and then a larger
 * share at cones that were added before. False if there is no vertex left.
 */
function addOne(
  graph: Weighted,
  q: number,
  { cones, added, u }: { cones: readonly Cone[]; added: Cone[]; u: Float64Array },
  { of, sign }: { of: number; sign: number },
): boolean {
  const all = [...cones, ...added];
  const near = takenBy(graph, all);
  const around = nearTo(graph, all, apart * graph.diagonal);
  const isCone = new Set(all.map(({ vertex }) => vertex));
  const kAt = new Map(added.map(({ vertex, k }) => [vertex, k]));
  const isWithin = (v: number, k: number): boolean => k >= 1 && k <= largestK(q, graph.valence[v]);
  const fits = (v: number): boolean => isWithin(v, q - sign);
  const ways = [
    (v: number): boolean => !around.has(v) && !near.has(v) && fits(v),
    (v: number): boolean => !near.has(v) && fits(v),
    (v: number): boolean => !isCone.has(v) && fits(v),
    (v: number): boolean => kAt.has(v) && isWithin(v, kAt.get(v)! - sign),
  ];
  for (const isAllowed of ways) {
    const vertex = mostExtreme(graph, u, { of, sign, isAllowed });
    if (vertex < 0) continue;
    const before = added.findIndex((one) => one.vertex === vertex);
    if (before < 0) added.push({ vertex, k: q - sign });
    else added[before] = { vertex, k: added[before].k - sign };
    return true;
  }
  return false;
}

/** The cones to add. `left`: the remainder of each component. */
export function balancingCones(
  surface: Graph,
  q: number,
  cones: readonly Cone[],
  left: ReadonlyMap<number, number>,
): Cone[] {
  const added: Cone[] = [];
  const graph = { ...surface, weights: weightsOf(surface) };
  const u = new Float64Array(graph.angle.length);
  const open = new Map([...left].filter(([, n]) => n !== 0));
  for (let step = 0; step < mostCones && open.size > 0; step++) {
    const [[of, n]] = open;
    const sign = Math.sign(n);
    solve(graph, rightHandSide(graph, q, [...cones, ...added]), u);
    const isAdded = addOne(graph, q, { cones, added, u }, { of, sign });
    if (!isAdded || n === sign) open.delete(of);
    else open.set(of, n - sign);
  }
  return added;
}
