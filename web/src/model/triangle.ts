/** Writes twice the area vector of the triangle whose corners start at a, b and c in `p` to `out`; does not allocate,
 * because it is called for every triangle. */
export function areaVector(
  p: ArrayLike<number>,
  a: number,
  b: number,
  c: number,
  out: Float64Array,
): void {
  const ux = p[b] - p[a];
  const uy = p[b + 1] - p[a + 1];
  const uz = p[b + 2] - p[a + 2];
  const vx = p[c] - p[a];
  const vy = p[c + 1] - p[a + 1];
  const vz = p[c + 2] - p[a + 2];
  out[0] = uy * vz - uz * vy;
  out[1] = uz * vx - ux * vz;
  out[2] = ux * vy - uy * vx;
}

const lengthOf = (v: Float64Array): number => Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);

const vector = new Float64Array(3);

/** The area of triangle `t`. */
export function areaOf(
  { positions: p, triangles }: { positions: ArrayLike<number>; triangles: ArrayLike<number> },
  t: number,
): number {
  areaVector(p, 3 * triangles[3 * t], 3 * triangles[3 * t + 1], 3 * triangles[3 * t + 2], vector);
  return lengthOf(vector) / 2;
}
