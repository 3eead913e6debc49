// Places missing cones where they cause the least distortion. The scale of the map is e^u with
// Δu = K − Σ 2π(q − kᵢ)/q δᵢ (curvature that cones do not absorb causes stretch), so a cone of the missing sign is
// placed where u is most extreme; one at a time, because each changes u.

import type { Cone } from '../../model/prescription';
import { largestK } from '../../model/gauss_bonnet';
import type { Surface } from '../../model/types';

type Graph = Pick<
  Surface,
  | 'neighbourStart'
  | 'neighbours'
  | 'angle'
  | 'isBoundary'
  | 'component'
  | 'valence'
  | 'representative'
>;

const mostSteps = 400; // of conjugate gradients
const accuracy = 1e-4; // relative to the initial residual
const mostCones = 256;

/** out = L x with the combinatorial Laplacian. */
function laplacian(
  { neighbourStart, neighbours }: Graph,
  x: Float64Array,
  out: Float64Array,
): void {
  for (let v = 0; v + 1 < neighbourStart.length; v++) {
    let sum = 0;
    for (let n = neighbourStart[v]; n < neighbourStart[v + 1]; n++) sum += x[v] - x[neighbours[n]];
    out[v] = sum;
  }
}

const dot = (a: Float64Array, b: Float64Array): number => {
  let sum = 0;
  for (let i = 0; i < a.length; i++) sum += a[i] * b[i];
  return sum;
};

/** Solves L u = b by conjugate gradients, starting from u; the sum of b vanishes on every component. */
function solve(graph: Graph, b: Float64Array, u: Float64Array): void {
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
  graph: Graph,
  q: number,
  { cones, added, u }: { cones: readonly Cone[]; added: Cone[]; u: Float64Array },
  { of, sign }: { of: number; sign: number },
): boolean {
  const all = [...cones, ...added];
  const near = takenBy(graph, all);
  const isCone = new Set(all.map(({ vertex }) => vertex));
  const kAt = new Map(added.map(({ vertex, k }) => [vertex, k]));
  const isWithin = (v: number, k: number): boolean => k >= 1 && k <= largestK(q, graph.valence[v]);
  const fits = (v: number): boolean => isWithin(v, q - sign);
  const ways = [
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
  graph: Graph,
  q: number,
  cones: readonly Cone[],
  left: ReadonlyMap<number, number>,
): Cone[] {
  const added: Cone[] = [];
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
