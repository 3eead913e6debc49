// Edits of cones where what is done to one is done to its mirror image, too. Values are immutable.

import type { ModelInfo } from 'hgp';
import type { Cone } from './prescription';

/** The vertex opposite to one: itself in the plane, −1 if there is none or the map is not to be symmetric. */
export type Opposite = (vertex: number) => number;

/** The plane of a symmetric map: one that no edges cross, if there is one. */
export const planeOf = ({ mirrors = [] }: Pick<ModelInfo, 'mirrors'>) =>
  mirrors.find(({ edgesAcross }) => edgesAcross === 0) ?? mirrors.at(0);

/** The index of the cone opposite to one; −1 if there is none, or if it is the same. */
export function partnerOf(cones: readonly Cone[], index: number, opposite: Opposite): number {
  const { vertex } = cones[index];
  const image = opposite(vertex);
  return image < 0 || image === vertex ? -1 : cones.findIndex((cone) => cone.vertex === image);
}

/** With a cone, and the one opposite to it. */
export function withPair(cones: readonly Cone[], cone: Cone, opposite: Opposite): Cone[] {
  const image = opposite(cone.vertex);
  const isFree = image >= 0 && image !== cone.vertex && cones.every((one) => one.vertex !== image);
  return [...cones, cone, ...(isFree ? [{ vertex: image, k: cone.k }] : [])];
}

export function withoutPair(cones: readonly Cone[], index: number, opposite: Opposite): Cone[] {
  const partner = partnerOf(cones, index, opposite);
  return cones.filter((_, i) => i !== index && i !== partner);
}

export function withKOfPair(
  cones: readonly Cone[],
  index: number,
  k: number,
  opposite: Opposite,
): Cone[] {
  const partner = partnerOf(cones, index, opposite);
  return cones.map((cone, i) => (i === index || i === partner ? { ...cone, k } : cone));
}

/**
 * With a cone at another vertex, and its partner opposite to it; undefined where another cone is there, and where a pair
 * would meet in the plane or a cone in the plane would leave it.
 */
export function withPairAt(
  cones: readonly Cone[],
  index: number,
  vertex: number,
  opposite: Opposite,
): Cone[] | undefined {
  const partner = partnerOf(cones, index, opposite);
  const from = cones[index].vertex;
  const image = opposite(vertex);
  const isInPlane = opposite(from) === from;
  if (isInPlane ? image !== vertex : partner >= 0 && (image < 0 || image === vertex))
    return undefined;
  const isTaken = (v: number): boolean =>
    cones.some((one, i) => i !== index && i !== partner && one.vertex === v);
  if (isTaken(vertex) || (partner >= 0 && isTaken(image))) return undefined;
  // Not in the triangle of a copy of the vertex before.
  return cones.map((cone, i) =>
    i === index ? { vertex, k: cone.k } : i === partner ? { vertex: image, k: cone.k } : cone,
  );
}
