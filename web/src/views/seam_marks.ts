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

const maxTicks = 4;

/** A chain shorter than this many strokes has none: they would only be scribbles. */
const shortest = 3;

interface Middle {
  seam: number;
  chain: number;
}

/** The middle edge of each chain that is long enough for strokes of length `stroke`. */
function middles(
  { chains }: Solution,
  stroke: number,
  lengthOf: (seam: number) => number,
): Middle[] {
  const of = new Map<number, number[]>();
  chains.forEach((chain, seam) => {
    const list = of.get(chain);
    if (list) list.push(seam);
    else of.set(chain, [seam]);
  });
  return [...of].flatMap(([chain, seams]) => {
    const length = seams.reduce((sum, seam) => sum + lengthOf(seam), 0);
    const enough = shortest * stroke * (1 + (chain % maxTicks) / maxTicks);
    return length < enough ? [] : [{ chain, seam: seams[Math.floor(seams.length / 2)] }];
  });
}

/** Adds marks across the segment a–b; `across` is half a mark as a vector. */
function marks(a: Vector3, b: Vector3, across: Vector3, chain: number, out: number[]): number {
  const count = (chain % maxTicks) + 1;
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
  const half = 0.012 * surface.radius;
  const endsOf = (seam: number): number[] => solution.seams[seam].a.map((end) => uvToVertex[end]);
  const lengthOf = (seam: number): number => {
    const [v, w] = endsOf(seam);
    return at(v).distanceTo(at(w));
  };
  for (const { seam, chain } of middles(solution, 2 * half, lengthOf)) {
    const [v, w] = endsOf(seam);
    const edge = at(w).sub(at(v));
    const normal = new Vector3().fromArray(surface.normals, 3 * v);
    const across = normal.cross(edge).setLength(half);
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
  const lengthOf = (seam: number): number => {
    const [i, j] = solution.seams[seam].a;
    return at(i).distanceTo(at(j));
  };
  for (const { seam, chain } of middles(solution, 2 * half, lengthOf)) {
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
