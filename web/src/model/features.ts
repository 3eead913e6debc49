// Edges that become straight lines of the map: creases, rims, chosen ones and those in a plane of symmetry. Values are immutable.

import type { Features, ModelInfo } from 'hgp';
import { areaVector } from './triangle';

/** What is needed of a surface. */
export interface Shape {
  readonly places: Float64Array;
  readonly triangles: Uint32Array;
  /** The vertex that stands for each vertex after welds; −1 if a repair removed it. */
  readonly representative?: Int32Array;
}

export type Edge = readonly [number, number];

export interface FeatureChoice {
  /** Whether the creases were found by their angle, and whether all rims were asked for. */
  readonly hasCreases: boolean;
  readonly hasRims: boolean;
  /** Whether the map is its own mirror image, with lines along the plane and all rims. */
  readonly isSymmetric?: boolean;
  /** Whether Run keeps the cones that are placed; otherwise it chooses cones that fit. */
  readonly keepsCones?: boolean;
  /** Edges inside the surface by their vertices; with any of them, or with hasRims, rims are lines as well. */
  readonly edges: readonly Edge[];
  /** All edges of the boundary. */
  readonly rims: readonly Edge[];
}

export const noFeatures: FeatureChoice = { hasCreases: false, hasRims: false, edges: [], rims: [] };

/** Whether edges of the surface are asked for. */
export const hasEdges = ({ hasRims, edges }: FeatureChoice): boolean => hasRims || edges.length > 0;
export const hasFeatures = (choice: FeatureChoice): boolean =>
  choice.isSymmetric === true || hasEdges(choice);

export const toFeatures = ({ hasRims, edges }: FeatureChoice): Features => ({
  rims: hasRims,
  lines: edges.map(([v, w]) => ({ vertices: [v, w] })),
});

const keyOf = ([v, w]: Edge): string => (v < w ? `${v} ${w}` : `${w} ${v}`);

/** Whether lines follow the same edges, whoever chooses the cones. */
export function sameFeatures(a: FeatureChoice | undefined, b: FeatureChoice | undefined): boolean {
  if (a === b) return true;
  const [x, y] = [a ?? noFeatures, b ?? noFeatures];
  if (x.hasRims !== y.hasRims || x.edges.length !== y.edges.length) return false;
  if ((x.isSymmetric ?? false) !== (y.isSymmetric ?? false)) return false;
  const known = new Set(x.edges.map(keyOf));
  return y.edges.every((edge) => known.has(keyOf(edge)));
}

/** The edges of a list of features as hgp-cones. */
export const edgesOf = (text: string): Edge[] =>
  edgesAlong((JSON.parse(text) as { features?: Features }).features);

export const edgesAlong = ({ lines = [] }: Features = {}): Edge[] =>
  lines.flatMap(({ vertices }) => vertices.slice(1).map((v, i): Edge => [vertices[i], v]));

/** With a chain of edges, or without it. */
export function withChain(
  choice: FeatureChoice,
  chain: readonly Edge[],
  isRemoved: boolean,
): FeatureChoice {
  const keys = new Set(chain.map(keyOf));
  const others = choice.edges.filter((edge) => !keys.has(keyOf(edge)));
  return { ...choice, edges: isRemoved ? others : [...others, ...chain] };
}

/** Runs between vertices at which not just two edges meet; a closed run without such a vertex is one. */
export function countRuns(edges: readonly Edge[]): number {
  const at = new Map<number, number[]>();
  edges.forEach((edge, i) => {
    for (const v of edge) at.set(v, [...(at.get(v) ?? []), i]);
  });
  const root = edges.map((_, i) => i);
  const find = (i: number): number => {
    while (root[i] !== i) i = root[i];
    return i;
  };
  let count = edges.length;
  for (const meeting of at.values()) {
    if (meeting.length !== 2) continue;
    const [a, b] = meeting.map(find);
    if (a === b) continue;
    root[a] = b;
    count--;
  }
  return count;
}

/**
 * Whether creases are as long as those of something that was designed: six edges or more each on parts (21 on fandisk, 16 on
 * casting), one or two on what was scanned or modelled by hand (the cow, Suzanne).
 */
export const hasLongCreases = ({ features: found }: Pick<ModelInfo, 'features'>): boolean =>
  found !== undefined && found.creaseChains > 0 && found.creaseEdges >= 5 * found.creaseChains;

/** What lines follow: "12 creases and 1 rim". */
export function followedLines(choice: FeatureChoice, rims: number): string {
  const creases = countRuns(choice.edges);
  const many = (n: number, word: string): string => `${n} ${word}${n === 1 ? '' : 's'}`;
  const parts = creases > 0 ? [many(creases, 'crease')] : [];
  if (rims > 0 || (creases === 0 && !choice.isSymmetric)) parts.push(many(rims, 'rim'));
  if (choice.isSymmetric) parts.push('the plane of symmetry');
  return parts.length < 3 ? parts.join(' and ') : `${parts[0]}, ${parts[1]} and ${parts[2]}`;
}

/** The same as a sentence. */
export const featuresText = (choice: FeatureChoice, rims: number): string =>
  `lines follow ${followedLines(choice, rims)}`;

const cornerAngle = Math.cos((40 * Math.PI) / 180); // a chain ends where it turns by more
const sharp = Math.cos((18 * Math.PI) / 180); // edges with a smaller dihedral angle are smooth

/** Positions, triangles at edges, and dihedral angles of a surface, for following chains on it. */
export class EdgeMap {
  readonly #surface: Shape;
  readonly #sides = new Map<string, number[]>();
  readonly #at = new Map<number, Set<number>>();

  constructor(surface: Shape) {
    this.#surface = surface;
    const { triangles } = surface;
    for (let c = 0; c < triangles.length; c++) {
      const t = c - (c % 3);
      const [v, w] = this.#named([triangles[c], triangles[c % 3 === 2 ? t : c + 1]]);
      const [u] = this.#named([triangles[t + ((c + 2) % 3)], v]);
      if (Math.min(u, v, w) < 0 || u === v || v === w || w === u) continue; // no triangle any more
      const key = keyOf([v, w]);
      const sides = this.#sides.get(key);
      if (sides) sides.push(Math.floor(c / 3));
      else this.#sides.set(key, [Math.floor(c / 3)]);
      for (const [a, b] of [
        [v, w],
        [w, v],
      ]) {
        // prettier-ignore
        const around = this.#at.get(a);
        if (around) around.add(b);
        else this.#at.set(a, new Set([b]));
      }
    }
  }

  /** All edges of the boundary. */
  rims(): Edge[] {
    const rims: Edge[] = [];
    for (const [key, sides] of this.#sides) {
      const [v, w] = key.split(' ').map(Number);
      if (sides.length === 1) rims.push([v, w]);
    }
    return rims;
  }

  isRim(edge: Edge): boolean {
    return this.#sides.get(keyOf(this.#named(edge)))?.length === 1;
  }

  /** A choice of another reading of the surface, without the edges that this one does not have inside. */
  kept(choice: FeatureChoice): FeatureChoice {
    const isInside = (edge: Edge): boolean => (this.#sides.get(keyOf(edge))?.length ?? 0) > 1;
    const edges = choice.edges.map((edge) => this.#named(edge)).filter(isInside);
    const rims = this.rims();
    return { ...choice, edges, rims, hasRims: choice.hasRims && rims.length > 0 };
  }

  /** An edge by the vertices that stand for its own. */
  #named([v, w]: Edge): Edge {
    const { representative: of } = this.#surface;
    return of ? [of[v] ?? -1, of[w] ?? -1] : [v, w];
  }

  #point(v: number): number[] {
    return [...this.#surface.places.subarray(3 * v, 3 * v + 3)];
  }

  #normal(triangle: number): number[] {
    const { places, triangles } = this.#surface;
    const [a, b, c] = triangles.subarray(3 * triangle, 3 * triangle + 3).map((v) => 3 * v);
    const normal = new Float64Array(3);
    areaVector(places, a, b, c, normal);
    return unit([...normal]);
  }

  /** Whether the surface bends at an inner edge. */
  isSharp(edge: Edge): boolean {
    const sides = this.#sides.get(keyOf(edge)) ?? [];
    return sides.length === 2 && dot(this.#normal(sides[0]), this.#normal(sides[1])) < sharp;
  }

  /** The edge, and those that go on from it in both directions, of the same kind, up to the next corner or crossing. */
  chainThrough(picked: Edge): Edge[] {
    const edge = this.#named(picked);
    const isRim = this.isRim(edge);
    if (!isRim && !this.isSharp(edge)) return [edge];
    const chain = [edge];
    const taken = new Set([keyOf(edge)]);
    for (const [from, to] of [edge, [edge[1], edge[0]] as const]) {
      let [before, here] = [from, to];
      for (let next = this.#next(before, here, isRim); next !== undefined;) {
        if (taken.has(keyOf([here, next]))) break;
        taken.add(keyOf([here, next]));
        chain.push([here, next]);
        [before, here] = [here, next];
        next = this.#next(before, here, isRim);
      }
    }
    return chain;
  }

  #next(before: number, here: number, isRim: boolean): number | undefined {
    const like = [...(this.#at.get(here) ?? [])].filter(
      (v) =>
        v !== before &&
        (isRim ? this.isRim([here, v]) : this.isSharp([here, v]) || this.isRim([here, v])),
    );
    if (like.length !== 1 || this.isRim([here, like[0]]) !== isRim) return undefined;
    const along = unit(difference(this.#point(here), this.#point(before)));
    const on = unit(difference(this.#point(like[0]), this.#point(here)));
    return dot(along, on) >= cornerAngle ? like[0] : undefined;
  }
}

const difference = (a: number[], b: number[]): number[] => a.map((x, i) => x - b[i]);
const dot = (a: number[], b: number[]): number => a.reduce((sum, x, i) => sum + x * b[i], 0);
function unit(a: number[]): number[] {
  const length = Math.hypot(...a) || 1;
  return a.map((x) => x / length);
}

/** The same as a part of a sentence, after a comma; rims are counted by boundary loops. */
export const describeFollowed = (features: FeatureChoice | undefined, rims = 0): string =>
  features ? `, ${featuresText(features, rims)}` : '';
