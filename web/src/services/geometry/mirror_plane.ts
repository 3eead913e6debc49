// The plane in which a surface is its own mirror image, found from its shape: planes through the centre across the axes of
// the file and of inertia are tried on a sample of vertices, moved to fit, and the best is taken if it fits well.

import type { Surface } from '../../model/types';
import { NearestVertex } from './nearest_vertex';
import { randomSequence } from './random_sequence';
import { largestAxis, type Matrix } from './symmetric_matrix';

type Vector = [number, number, number];
type Shape = Pick<Surface, 'positions' | 'representative' | 'diagonal' | 'vertexCount'>;

export interface Plane {
  normal: Vector;
  /** n · x = offset. */
  offset: number;
}

const maxSamples = 1500;
const rounds = 6; // of fitting
/** Mean distance of mirrored vertices to the next vertex, of the diagonal, beyond the one that spacing explains. */
const maxOff = 0.008;
/** A mirrored vertex farther than this from every vertex has no counterpart. */
const farthest = 0.05;

const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const minus = (a: Vector, b: Vector): Vector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];

export function reflected({ normal, offset }: Plane, x: Vector): Vector {
  const twice = 2 * (dot(normal, x) - offset);
  return [x[0] - twice * normal[0], x[1] - twice * normal[1], x[2] - twice * normal[2]];
}

const outer = (sum: number[], d: Vector): void => {
  for (let i = 0; i < 3; i++) for (let j = 0; j < 3; j++) sum[3 * i + j] += d[i] * d[j];
};

/**
 * Some of many vertices, from all of their order; all of a few. Not every n-th one, which may be in one half of the
 * surface only: files often have the two halves in turn.
 */
function sampleOf(vertices: readonly number[]): number[] {
  if (vertices.length < 2 * maxSamples) return [...vertices];
  const share = vertices.length / maxSamples;
  const random = randomSequence(11);
  return Array.from({ length: maxSamples }, (_, i) => vertices[Math.floor((i + random()) * share)]);
}

/** Directions that planes are tried across. */
function candidates(inertia: readonly number[]): Vector[] {
  const first = largestAxis(inertia as Matrix);
  const rest = inertia.map((x, at) => {
    const [i, j] = [Math.floor(at / 3), at % 3];
    return x - first.value * first.axis[i] * first.axis[j];
  });
  const second = largestAxis(rest as Matrix).axis;
  const [a, b] = [first.axis, second];
  const third: Vector = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]; // prettier-ignore
  return [[1, 0, 0], [0, 1, 0], [0, 0, 1], a, b, third];
}

export class Mirror {
  readonly plane: Plane | undefined;
  readonly #shape: Shape;
  readonly #nearest: NearestVertex;

  constructor(shape: Shape) {
    this.#shape = shape;
    const { positions, representative, vertexCount } = shape;
    const own: number[] = [];
    for (let v = 0; v < vertexCount; v++) if (representative[v] === v) own.push(v);
    this.#nearest = new NearestVertex(positions, own, farthest * shape.diagonal);
    if (own.length > 0) this.plane = this.#find(own);
  }

  /** The vertex opposite to v; −1 if there is none, v itself if it is on the plane. */
  opposite(v: number): number {
    if (!this.plane) return -1;
    const at = this.#at(v);
    const off = Math.abs(dot(this.plane.normal, at) - this.plane.offset);
    const found = this.#nearest.of(reflected(this.plane, at));
    // The next vertex to the image of one that is nearly on the plane may be a neighbour.
    return off < maxOff * this.#shape.diagonal ? v : found;
  }

  #at(v: number): Vector {
    const { positions: p } = this.#shape;
    return [p[3 * v], p[3 * v + 1], p[3 * v + 2]];
  }

  /** The centre of vertices, and their products of inertia around it. */
  #spread(vertices: readonly number[]): [Vector, number[]] {
    const sum: Vector = [0, 0, 0];
    for (const v of vertices) this.#at(v).forEach((x, i) => (sum[i] += x));
    const centre = sum.map((x) => x / vertices.length) as Vector;
    const inertia = new Array<number>(9).fill(0);
    for (const v of vertices) outer(inertia, minus(this.#at(v), centre));
    return [centre, inertia];
  }

  #find(vertices: readonly number[]): Plane | undefined {
    // Of all vertices: those of a sample may be more on one side.
    const [centre, inertia] = this.#spread(vertices);
    const samples = sampleOf(vertices).map((v) => this.#at(v));
    // The spacing of vertices, which distances to the next vertex cannot be expected to be below.
    const spacing = Math.sqrt(this.#nearest.meanSpacing / 3);
    let best: { plane: Plane; off: number } | undefined;
    for (const normal of candidates(inertia)) {
      const fitted = this.#fit(samples, { normal, offset: dot(normal, centre) });
      if (!best || fitted.off < best.off) best = fitted;
    }
    const allowed = maxOff * this.#shape.diagonal + 0.4 * spacing;
    return best && best.off <= allowed ? best.plane : undefined;
  }

  /** Moves a plane so that mirrored samples come nearer to vertices. */
  #fit(samples: readonly Vector[], plane: Plane): { plane: Plane; off: number } {
    let best = { plane, off: this.#pairs(samples, plane).off };
    for (let round = 0; round < rounds; round++) {
      const { pairs } = this.#pairs(samples, best.plane);
      const across = new Array<number>(9).fill(0);
      for (const [p, q] of pairs) outer(across, minus(p, q));
      const { axis: normal } = largestAxis(across as Matrix);
      const sum = pairs.reduce((all, [p, q]) => all + dot(normal, p) + dot(normal, q), 0);
      const moved: Plane = { normal, offset: sum / (2 * Math.max(1, pairs.length)) };
      const { off } = this.#pairs(samples, moved);
      if (off >= best.off) break;
      best = { plane: moved, off };
    }
    return best;
  }

  /** Samples with the vertices nearest to their images, and how far these are on average. */
  #pairs(samples: readonly Vector[], plane: Plane): { pairs: [Vector, Vector][]; off: number } {
    const pairs: [Vector, Vector][] = [];
    let sum = 0;
    for (const p of samples) {
      const image = reflected(plane, p);
      const v = this.#nearest.of(image);
      sum += v < 0 ? farthest * this.#shape.diagonal : Math.hypot(...minus(this.#at(v), image));
      if (v >= 0) pairs.push([p, this.#at(v)]);
    }
    return { pairs, off: sum / samples.length };
  }
}
