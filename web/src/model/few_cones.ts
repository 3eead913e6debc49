// When few automatic cones are enough: where the map hardly stretches, and its pattern has much the same size everywhere
// or would not with more cones either. More cones make a map better than that, but also harder to look through, and
// each is a place where a pattern breaks.

import type { Certificate } from 'hgp';

/** σ₁/σ₂ − 1 that half of the surface may exceed. */
const maxStretch = 0.15;
/** The scale at the 95 % mark of the surface over the one at the 5 % mark. */
const maxSpread = 2.5;
/** Where more cones leave sizes that vary at least this much as much, few are as good. */
const asMuch = 0.9;
/** Triangles of surfaces for which choosing few cones, and a second run, are not too much to wait for. */
const maxTriangles = 100_000;

interface Measured {
  distortion?: { medianMu?: number; sizeSpread?: number };
}

const parts = ({ components }: Certificate): Measured[] => components;

const spreadOf = (certificate: Certificate): number =>
  Math.max(...parts(certificate).map(({ distortion }) => distortion?.sizeSpread ?? Infinity));

/** Whether a map of few cones is certified and stretches every component little. */
export const isPossibleWithFew = (certificate: Certificate): boolean =>
  certificate.certified &&
  parts(certificate).every(({ distortion }) => {
    const { medianMu = 1 } = distortion ?? {};
    return (2 * medianMu) / (1 - medianMu) <= maxStretch;
  });

/** Whether such a map needs no comparison with one of more cones. */
export const isGoodWithFew = (few: Certificate): boolean => spreadOf(few) <= maxSpread;

/** Whether few cones are as good as more. */
export const isAsGoodWithFew = (few: Certificate, more: Certificate): boolean =>
  !more.certified || spreadOf(more) >= asMuch * spreadOf(few);

export const isFewTried = (triangles: number): boolean => triangles <= maxTriangles;
