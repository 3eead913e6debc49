// Normals along creases, where one normal per vertex would round off what is sharp: the triangles at a vertex are
// divided by the creases that meet there, and each part has the area-weighted mean of its own normals.

import { forEachIndex } from './loops';
import { areaVector } from '../../model/triangle';

/** Corners that do not have the normal of their vertex, ascending, and three numbers for each. */
export interface CreaseNormals {
  corners: Uint32Array;
  normals: Float32Array;
}

export interface Shaded {
  positions: Float64Array;
  triangles: Uint32Array;
  /** Vertex normals, three numbers each. */
  normals: Float32Array;
  /** Vertices with the same number are one point; −1 if the vertex is not part of the surface. */
  joined?: Int32Array;
}

/** Edges whose triangles' normals differ by more are shaded as creases: rounder than what counts as a feature (30°), since
 * a coarse mesh of something round looks better without facets. */
export const creaseAngle = (40 / 180) * Math.PI;
const leastDot = Math.cos(creaseAngle);
/** If no triangle at a vertex differs from its normal by more than half of it, no two of them differ by all. */
const leastToMean = Math.cos(creaseAngle / 2);

/** Of the corner before and after one, in its triangle. */
const nextOf = (c: number): number => (c % 3 === 2 ? c - 2 : c + 1);
const previousOf = (c: number): number => (c % 3 === 0 ? c + 2 : c - 1);

/** Twice the area vector of every triangle, on the side to which the normals of its vertices point. */
function areaVectors({ positions, triangles, normals }: Shaded): Float64Array {
  const areas = new Float64Array(triangles.length);
  const area = new Float64Array(3);
  forEachIndex(triangles.length / 3, (t) => {
    const a = 3 * triangles[3 * t];
    const b = 3 * triangles[3 * t + 1];
    const c = 3 * triangles[3 * t + 2];
    areaVector(positions, a, b, c, area);
    let along = 0;
    for (let i = 0; i < 3; i++)
      along += area[i] * (normals[a + i] + normals[b + i] + normals[c + i]);
    for (let i = 0; i < 3; i++) areas[3 * t + i] = along < 0 ? -area[i] : area[i];
  });
  return areas;
}

/** Whether two directions differ by less than an angle, whose cosine is `least`; not if one of them has no length. */
function isNear(
  p: ArrayLike<number>,
  i: number,
  q: ArrayLike<number>,
  j: number,
  least: number,
): boolean {
  const dot = p[i] * q[j] + p[i + 1] * q[j + 1] + p[i + 2] * q[j + 2];
  const ofP = p[i] * p[i] + p[i + 1] * p[i + 1] + p[i + 2] * p[i + 2];
  const ofQ = q[j] * q[j] + q[j + 1] * q[j + 1] + q[j + 2] * q[j + 2];
  return dot > 0 && dot * dot >= least * least * ofP * ofQ;
}

/** The corners at points where there may be creases, point by point. */
interface Around {
  /** Where those of each point begin. */
  start: Uint32Array;
  corners: Uint32Array;
  /** The points at the far ends of the two edges of each. */
  ends: Int32Array;
}

/** Calls `meet` for places of corners that share an edge, one after the other. */
type Join = (ends: Int32Array, first: number, last: number, meet: (i: number, j: number) => void) => void; // prettier-ignore

const joinFew: Join = (ends, first, last, meet) => {
  for (let i = first; i < last; i++) {
    const a = ends[2 * i];
    const b = ends[2 * i + 1];
    for (let j = first; j < i; j++) {
      const c = ends[2 * j];
      const d = ends[2 * j + 1];
      if (a === c || a === d || b === c || b === d) meet(i, j);
    }
  }
};

const joinMany: Join = (ends, first, last, meet) => {
  const seen = new Map<number, number>();
  for (let i = 2 * first; i < 2 * last; i++) {
    const before = seen.get(ends[i]);
    if (before !== undefined) meet(i >> 1, before);
    seen.set(ends[i], i >> 1);
  }
};

/** Triangles without area have no normal of their own. */
function normalsFrom(sums: Float64Array, place: Uint32Array): CreaseNormals {
  const lengthAt = (at: number): number =>
    Math.sqrt(sums[at] ** 2 + sums[at + 1] ** 2 + sums[at + 2] ** 2);
  const isOwn = (c: number): boolean => place[c] > 0 && lengthAt(place[c] - 1) > 0;
  let count = 0;
  forEachIndex(place.length, (c) => (count += Number(isOwn(c))));
  const corners = new Uint32Array(count);
  count = 0;
  forEachIndex(place.length, (c) => void (isOwn(c) && (corners[count++] = c)));
  const normals = new Float32Array(3 * corners.length);
  corners.forEach((c, i) => {
    const at = place[c] - 1;
    const length = lengthAt(at);
    for (let k = 0; k < 3; k++) normals[3 * i + k] = sums[at + k] / length;
  });
  return { corners, normals };
}

class Creases {
  readonly #triangles: Uint32Array;
  readonly #normals: Float32Array;
  /** The point of every vertex. */
  readonly #points: ArrayLike<number>;
  readonly #pointCount: number;
  readonly #areas: Float64Array;

  constructor(shaded: Shaded) {
    const vertices = shaded.normals.length / 3;
    this.#triangles = shaded.triangles;
    this.#normals = shaded.normals;
    this.#points = shaded.joined ?? Uint32Array.from({ length: vertices }, (_, v) => v);
    let count = vertices;
    for (const point of shaded.joined ?? []) count = Math.max(count, point + 1);
    this.#pointCount = count;
    this.#areas = areaVectors(shaded);
  }

  /** Whether two triangles, given by a corner each, differ by less than a crease does. */
  #isSmooth(c: number, d: number): boolean {
    const [i, j] = [this.#areaAt(c), this.#areaAt(d)];
    return isNear(this.#areas, i, this.#areas, j, leastDot);
  }

  readonly #pointOf = (c: number): number => this.#points[this.#triangles[c]];
  readonly #areaAt = (c: number): number => c - (c % 3);

  /** 1 for points where a triangle differs much from the normal. */
  #sharpPoints(): Uint8Array {
    const isSharp = new Uint8Array(this.#pointCount);
    forEachIndex(this.#triangles.length, (c) => {
      const point = this.#pointOf(c);
      const v = 3 * this.#triangles[c];
      if (point < 0 || isSharp[point]) return;
      if (!isNear(this.#areas, this.#areaAt(c), this.#normals, v, leastToMean)) isSharp[point] = 1;
    });
    return isSharp;
  }

  #around(isSharp: Uint8Array): Around {
    const start = new Uint32Array(isSharp.length + 2);
    const each = (act: (c: number, point: number) => void): void =>
      forEachIndex(this.#triangles.length, (c) => {
        const point = this.#pointOf(c);
        if (isSharp[point]) act(c, point);
      });
    each((_, point) => start[point + 2]++);
    for (let i = 2; i < start.length; i++) start[i] += start[i - 1];
    const corners = new Uint32Array(start[start.length - 1]);
    each((c, point) => (corners[start[point + 1]++] = c));
    const ends = new Int32Array(2 * corners.length);
    forEachIndex(corners.length, (i) => {
      ends[2 * i] = this.#pointOf(nextOf(corners[i]));
      ends[2 * i + 1] = this.#pointOf(previousOf(corners[i]));
    });
    return { start, corners, ends };
  }

  /** Joins the corners first … last − 1, which are at one point, over edges that are no creases: whether parts are left. */
  #join({ corners, ends }: Around, first: number, last: number, part: Uint32Array): boolean {
    const rootOf = (i: number): number => {
      while (part[i] !== i) i = part[i] = part[part[i]];
      return i;
    };
    for (let i = first; i < last; i++) part[i] = i;
    const meet = (i: number, j: number): void => {
      const [one, other] = [rootOf(i), rootOf(j)];
      if (one === other || !this.#isSmooth(corners[i], corners[j])) return;
      part[Math.max(one, other)] = Math.min(one, other);
    };
    if (last - first > 24) joinMany(ends, first, last, meet);
    else joinFew(ends, first, last, meet);
    let isDivided = false;
    for (let i = first; i < last; i++) {
      part[i] = rootOf(i);
      isDivided ||= part[i] !== first;
    }
    return isDivided;
  }

  /** For every corner at a sharp point, the place of the first one of its part; undivided points count as smooth. */
  #parts(isSharp: Uint8Array, around: Around): Uint32Array {
    const { start, corners } = around;
    const part = new Uint32Array(corners.length);
    forEachIndex(isSharp.length, (point) => {
      const first = start[point];
      const last = start[point + 1];
      if (first < last && !this.#join(around, first, last, part)) isSharp[point] = 0;
    });
    return part;
  }

  find(): CreaseNormals {
    const isSharp = this.#sharpPoints();
    const around = this.#around(isSharp);
    const part = this.#parts(isSharp, around);
    const sums = new Float64Array(3 * part.length);
    /** By corner, where its part's sum begins, plus one. */
    const place = new Uint32Array(this.#triangles.length);
    forEachIndex(part.length, (i) => {
      const c = around.corners[i];
      if (!isSharp[this.#pointOf(c)]) return;
      const at = 3 * part[i];
      place[c] = at + 1;
      const area = this.#areaAt(c);
      for (let k = 0; k < 3; k++) sums[at + k] += this.#areas[area + k];
    });
    return normalsFrom(sums, place);
  }
}

export const creaseNormals = (shaded: Shaded): CreaseNormals => new Creases(shaded).find();
