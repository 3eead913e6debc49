// Gauss–Bonnet in exact integers, without the solver: Σ(q − kᵢ) + Σlⱼ = q·χ for every
// connected component, and errors of single cones. The solver checks both again.

import type { ModelInfo } from 'hgp';
import type { Prescription } from './prescription';
import { curvatureAround } from './surface';
import type { Surface } from './types';

export interface ConeState {
  isGood: boolean;
  text: string;
}

export interface ComponentBudget {
  component: number;
  have: number;
  need: number;
  left: number;
  /** Loops whose turning is automatic; they take the remainder. */
  openLoops: number;
  isBalanced: boolean;
}

export interface Budget {
  components: ComponentBudget[];
  cones: ConeState[];
  isReady: boolean;
  /** One sentence: what is missing and how to add it. */
  text: string;
  /** These cones are valid, but known to be difficult. */
  warnings?: string[];
}

/** Largest k that leaves every corner of the triangles at the vertex below 180°. */
export function largestK(q: number, valence: number): number {
  return Math.ceil((q * valence) / 2) - 1;
}

/** The error of one cone, if any; `coneAt` maps each vertex to the first cone there. */
function checkCone(
  { q, cones }: Prescription,
  surface: Surface,
  i: number,
  coneAt: ReadonlyMap<number, number>,
): ConeState {
  const { vertex, k } = cones[i];
  const bad = (text: string): ConeState => ({ isGood: false, text });
  if (!(vertex >= 0 && vertex < surface.vertexCount)) return bad('no such vertex');
  const first = coneAt.get(vertex)!;
  const isOther = (cones[first].triangle ?? -1) !== (cones[i].triangle ?? -1);
  if (first !== i && !isOther) return bad('there is a cone here already');
  if (surface.isBoundary[vertex])
    return bad('on the boundary: set its turning under Boundaries and handles');
  if (k < 1) return bad('k must be at least 1');
  const valence = surface.valence[vertex];
  const max = largestK(q, valence);
  if (k > max) {
    return bad(
      `${valence} triangles; k = ${k} would need a corner above 180°. Largest k here: ${max}`,
    );
  }
  if (k === q) return { isGood: true, text: 'no effect (k = q)' };
  for (let n = surface.neighbourStart[vertex]; n < surface.neighbourStart[vertex + 1]; n++) {
    const j = coneAt.get(surface.neighbours[n]);
    if (j !== undefined) return { isGood: true, text: `shares a triangle with cone ${j + 1}` };
  }
  return { isGood: true, text: 'ok' };
}

function checkCones(prescription: Prescription, surface: Surface): ConeState[] {
  const coneAt = new Map<number, number>();
  prescription.cones.forEach(({ vertex }, i) => {
    if (!coneAt.has(vertex)) coneAt.set(vertex, i);
  });
  return prescription.cones.map((_, i) => checkCone(prescription, surface, i, coneAt));
}

/** "two k = 2 or one k = 1": cones of one kind that use up the remainder. */
export function waysToSpend(left: number, q: number): string {
  const step = Math.sign(left);
  const ways: string[] = [];
  for (let size = 1; size <= q && ways.length < 2; size++) {
    const k = q - step * size;
    if (k < 1 || left % size !== 0) continue;
    const count = Math.abs(left) / size;
    if (count > 12) continue;
    ways.push(`${count === 1 ? 'one cone' : `${count} cones`} with k = ${k}`);
  }
  return ways.join(' or ');
}

function sentence(
  components: ComponentBudget[],
  states: ConeState[],
  { q, cones }: Prescription,
): string {
  const wrong = states.findIndex(({ isGood }) => !isGood);
  if (wrong >= 0) return `Cone ${wrong + 1} (v ${cones[wrong].vertex}): ${states[wrong].text}.`;
  const open = components.find(({ isBalanced }) => !isBalanced);
  if (!open) return 'Balanced';
  const where = components.length > 1 ? ` in component ${open.component + 1}` : '';
  const { left } = open;
  const what = left > 0 ? `${left} left` : `${-left} too much`;
  const ways = waysToSpend(left, q);
  return `${what}${where}${ways ? `: add ${ways}, or Balance for me` : '. Balance for me settles it'}.`;
}

/** Σ(q − k) over the cones of each component. */
function spentByComponent({ q, cones }: Prescription, surface: Surface): Map<number, number> {
  const spent = new Map<number, number>();
  for (const { vertex, k, triangle = -1 } of cones) {
    const ofTriangle = surface.triangleComponent[triangle] ?? -1;
    const component = ofTriangle >= 0 ? ofTriangle : (surface.component[vertex] ?? 0);
    spent.set(component, (spent.get(component) ?? 0) + q - k);
  }
  return spent;
}

export function computeBudget(
  prescription: Prescription,
  surface: Surface,
  info: ModelInfo,
): Budget {
  const list = info.components ?? [];
  const { q, turnings } = prescription;
  const spent = spentByComponent(prescription, surface);
  const all = [...spent.values()].reduce((sum, n) => sum + n, 0);
  const components = list.map((one): ComponentBudget => {
    const loops = one.boundaryLoops.map(({ loop }) => turnings[loop] ?? null);
    const byCones = list.length === 1 ? all : (spent.get(one.component) ?? 0);
    const have = byCones + loops.reduce((sum: number, l) => sum + (l ?? 0), 0);
    const need = q * one.eulerCharacteristic;
    const openLoops = loops.filter((l) => l === null).length;
    const left = need - have;
    const isBalanced = left === 0 || openLoops > 0;
    return { component: one.component, have, need, left, openLoops, isBalanced };
  });
  const cones = checkCones(prescription, surface);
  return {
    components,
    cones,
    text: sentence(components, cones, prescription),
    isReady: components.every((one) => one.isBalanced) && cones.every(({ isGood }) => isGood),
  };
}

/**
 * The k for a cone placed by a click, from the curvature around the vertex and the remainder. If cones are
 * missing, the new one reduces the remainder and never exceeds it.
 */
export function suggestedK(surface: Surface, vertex: number, q: number, left: number): number {
  const max = Math.max(1, largestK(q, surface.valence[vertex]));
  const within = (k: number): number => Math.min(Math.max(k, 1), max);
  const bends = curvatureAround(surface, vertex);
  const natural = q - Math.round((bends / (2 * Math.PI)) * q);
  if (left > 0) return within(Math.max(Math.min(natural, q - 1), q - left));
  if (left < 0) return within(Math.min(Math.max(natural, q + 1), q - left));
  if (natural !== q) return within(natural);
  return within(bends < 0 ? q + 1 : q - 1);
}

/** The remainder of the vertex' component; 0 if boundary loops take it. */
export function leftAt(budget: Budget | undefined, surface: Surface, vertex: number): number {
  const component = surface.component[vertex];
  const found =
    budget?.components.find((one) => one.component === component) ?? budget?.components[0];
  return found && found.openLoops === 0 ? found.left : 0;
}
