// Marks that distinguish seams without colour: short strokes across the middle of each chain, like the tick marks
// for equal sides in geometry. Both sides of a chain have the same number of strokes.

import { Color, Vector3 } from 'three';
import type { Solution, Surface } from '../model/types';

// Colours that most people can distinguish on both backgrounds; further chains repeat them.
const hues = [
  '#e4572e',
  '#1b998b',
  '#8f5bd6',
  '#d1247c',
  '#2e86de',
  '#7a9e1f',
  '#b8741a',
  '#00a6c7',
].map((hue) => new Color(hue));
/** A shared object, which must not be modified. */
export const chainColour = (chain: number): Color => hues[chain % hues.length];

const mostTicks = 4;

/** The middle edge of each chain, with the chain. */
function middles({ chains }: Solution): { seam: number; chain: number }[] {
  const of = new Map<number, number[]>();
  chains.forEach((chain, seam) => {
    const list = of.get(chain);
    if (list) list.push(seam);
    else of.set(chain, [seam]);
  });
  return [...of].map(([chain, seams]) => ({ chain, seam: seams[Math.floor(seams.length / 2)] }));
}

/** Adds marks across the segment a–b; `across` is half a mark as a vector. */
function marks(a: Vector3, b: Vector3, across: Vector3, chain: number, out: number[]): number {
  const count = (chain % mostTicks) + 1;
  const gap = 0.9 * across.length();
  const along = b.clone().sub(a).setLength(gap);
  const middle = a.clone().lerp(b, 0.5);
  for (let i = 0; i < count; i++) {
    const at = middle.clone().addScaledVector(along, i - (count - 1) / 2);
    out.push(...at.clone().add(across).toArray(), ...at.clone().sub(across).toArray());
  }
  return count;
}

export interface Coloured {
  points: number[];
  colours: Color[];
}

export function ticksOnSurface(surface: Surface, solution: Solution): Coloured {
  const points: number[] = [];
  const colours: Color[] = [];
  const at = (v: number): Vector3 => new Vector3().fromArray(surface.places, 3 * v);
  const { uvToVertex } = solution.result;
  for (const { seam, chain } of middles(solution)) {
    const [v, w] = solution.seams[seam].a.map((end) => uvToVertex[end]);
    const edge = at(w).sub(at(v));
    const normal = new Vector3().fromArray(surface.normals, 3 * v);
    const across = normal.cross(edge).setLength(0.006 * surface.radius * 2);
    const count = marks(at(v), at(w), across, chain, points);
    for (let i = 0; i < count; i++) colours.push(chainColour(chain));
  }
  return { points, colours };
}

/** Marks on both sides of each chain; `half` is half the length of a mark in uv. */
export function ticksInMap(solution: Solution, half: number): Coloured {
  const points: number[] = [];
  const colours: Color[] = [];
  const { uv } = solution.result;
  const at = (i: number): Vector3 => new Vector3(uv[2 * i], uv[2 * i + 1], 0.002);
  for (const { seam, chain } of middles(solution)) {
    const { a, b } = solution.seams[seam];
    for (const [i, j] of [a, b]) {
      const edge = at(j).sub(at(i));
      const across = new Vector3(-edge.y, edge.x, 0).setLength(half);
      const count = marks(at(i), at(j), across, chain, points);
      for (let k = 0; k < count; k++) colours.push(chainColour(chain));
    }
  }
  return { points, colours };
}
