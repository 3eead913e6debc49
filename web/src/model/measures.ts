// What is measured on a map.

/** Values at 0, 5, 50, 95, 99 and 100 percent: of the area for values of triangles, of their number for others. */
export interface Quantiles {
  min: number;
  p5: number;
  median: number;
  p95: number;
  p99: number;
  max: number;
}

export interface Distortion {
  /** Ratio of singular values; 1: angles preserved. */
  stretch: Quantiles;
  /** log₂ of the area scale relative to the best one of its component, as in the certificate. */
  area: Quantiles;
  /** The absolute value of `area`. */
  areaSize: Quantiles;
  seamDistance: Quantiles;
  /** Triangles that are not positive in the map. */
  flipped: Uint32Array;
  uvArea: number;
  surfaceArea: number;
}

/** Where the pattern is much larger, or much smaller, than typically. */
export interface SizePlaces {
  /** Of the surface's area. */
  share: number;
  /** The most extreme first; not more than can be outlined. */
  triangles: Uint32Array;
  /** Of each such place the most extreme vertex, the largest place first. */
  vertices: number[];
}

/** How sizes vary, weighted by area, as the certificate defines it. */
export interface Sizes {
  /** σ₁/σ₂ that half of the surface exceeds. */
  typicalStretch: number;
  /** The scale that 95 % of the surface have at most, over the one that 5 % have at most. */
  spread: number;
  /** The same for 99 % and 1 %. */
  range: number;
  /** Length in the map per length on the surface, at the median. */
  typicalScale: number;
  larger: SizePlaces;
  smaller: SizePlaces;
}

export interface SmallestArea {
  /** The smallest signed area of a triangle in the map; negative if it is flipped. */
  area: number;
  /** The mean area of all triangles. */
  mean: number;
  triangle: number;
  /** Number of triangles with negative area, and with area zero. */
  negative: number;
  zero: number;
  /** The smallest positive area. */
  smallestPositive: number;
}

export interface Overlaps {
  /** Pairs of triangles that overlap and share no corner. */
  pairs: number;
  triangles: Uint32Array;
  /** Whether counting stopped because there are too many. */
  isMore: boolean;
}
