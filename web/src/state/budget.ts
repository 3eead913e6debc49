// The budget of Gauss–Bonnet, in exact integers and at once: Σ(q − kᵢ) + Σlⱼ = q·χ for every
// connected part, and what is wrong with single cones. The solver checks the same again.

import type { ModelInfo } from 'hgp';
import type { Prescription } from './prescription';
import type { Surface } from './surface';

export interface ConeState {
  isGood: boolean;
  text: string;
}

export interface PartBudget {
  part: number;
  have: number;
  need: number;
  left: number;
  /** Loops whose turning is automatic; they take what is left. */
  openLoops: number;
  isBalanced: boolean;
}

export interface Budget {
  parts: PartBudget[];
  cones: ConeState[];
  isReady: boolean;
  /** One sentence: what is missing and what would settle it. */
  text: string;
  /** Nothing forbids these cones, but they are known to be hard. */
  warnings?: string[];
}

/** Largest k that leaves every corner of the triangles at the vertex below 180°. */
export function largestK(q: number, valence: number): number {
  return Math.ceil((q * valence) / 2) - 1;
}

function judge(asked: Prescription, surface: Surface, i: number): ConeState {
  const { vertex, k } = asked.cones[i];
  const bad = (text: string): ConeState => ({ isGood: false, text });
  if (!(vertex >= 0 && vertex < surface.vertexCount)) return bad('no such vertex');
  if (asked.cones.some((other, j) => j < i && other.vertex === vertex)) return bad('duplicate');
  if (surface.isBoundary[vertex]) return bad('on the boundary: use its turning index');
  if (k < 1) return bad('k must be at least 1');
  const most = largestK(asked.q, surface.valence[vertex]);
  if (k > most) {
    return bad(
      `${surface.valence[vertex]} triangles; k = ${k} would need a corner above 180°. Largest k here: ${most}`,
    );
  }
  if (k === asked.q) return { isGood: true, text: 'no effect (k = q)' };
  for (let n = surface.starts[vertex]; n < surface.starts[vertex + 1]; n++) {
    const neighbour = surface.neighbours[n];
    const j = asked.cones.findIndex((other) => other.vertex === neighbour);
    if (j >= 0) return { isGood: true, text: `shares a triangle with cone ${j + 1}` };
  }
  return { isGood: true, text: 'ok' };
}

/** "two k = 2 or one k = 1": ways to spend what is left with cones of one kind. */
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
  parts: PartBudget[],
  cones: ConeState[],
  { q, cones: list }: Prescription,
): string {
  const wrong = cones.findIndex(({ isGood }) => !isGood);
  if (wrong >= 0) return `Cone ${wrong + 1} (v ${list[wrong].vertex}): ${cones[wrong].text}.`;
  const open = parts.find(({ isBalanced }) => !isBalanced);
  if (!open) return parts.length === 1 ? 'Balance 0' : `Balance 0 in all ${parts.length} parts`;
  const where = parts.length > 1 ? ` in part ${open.part + 1}` : '';
  const { left } = open;
  const what = left > 0 ? `${left} left` : `${-left} too much`;
  const ways = waysToSpend(left, q);
  return `${what}${where}. Cones and turnings must add up to q·χ = ${open.need}${
    ways ? `: add ${ways}` : ''
  }.`;
}

export function computeBudget(asked: Prescription, surface: Surface, info: ModelInfo): Budget {
  const components = info.components ?? [];
  const parts = components.map(({ component, eulerCharacteristic, boundaryLoops }): PartBudget => {
    const loops = boundaryLoops.map(({ loop }) => asked.turnings[loop] ?? null);
    const isHere = (v: number): boolean => components.length === 1 || surface.part[v] === component;
    const fromCones = asked.cones.filter(({ vertex }) => isHere(vertex));
    const have =
      fromCones.reduce((sum, { k }) => sum + asked.q - k, 0) +
      loops.reduce((sum: number, l) => sum + (l ?? 0), 0);
    const need = asked.q * eulerCharacteristic;
    const openLoops = loops.filter((l) => l === null).length;
    const left = need - have;
    return {
      part: component,
      have,
      need,
      left,
      openLoops,
      isBalanced: left === 0 || openLoops > 0,
    };
  });
  const cones = asked.cones.map((_, i) => judge(asked, surface, i));
  return {
    ...{ parts, cones, text: sentence(parts, cones, asked) },
    isReady: parts.every(({ isBalanced }) => isBalanced) && cones.every(({ isGood }) => isGood),
  };
}

/** The k that suits the shape: the cone angle nearest to the angle that is there. */
export function bestK(surface: Surface, vertex: number, q: number): number {
  const natural = Math.round((surface.angle[vertex] / (2 * Math.PI)) * q);
  const most = Math.max(1, largestK(q, surface.valence[vertex]));
  const k = Math.min(Math.max(natural, 1), most);
  if (k !== q) return k;
  const isSaddle = surface.angle[vertex] > 2 * Math.PI;
  return isSaddle ? Math.min(q + 1, most) : Math.max(1, q - 1);
}
