// The largest axis of a symmetric 3 × 3 matrix without negative eigenvalues.

export type Matrix = [number, number, number, number, number, number, number, number, number];
type Vector = [number, number, number];

const steps = 60;

const times = (m: Matrix, x: Vector): Vector => [
  m[0] * x[0] + m[1] * x[1] + m[2] * x[2],
  m[3] * x[0] + m[4] * x[1] + m[5] * x[2],
  m[6] * x[0] + m[7] * x[1] + m[8] * x[2],
];

/** By squaring the matrix, which multiplies the ratio of eigenvalues with itself. */
export function largestAxis(matrix: Matrix): { axis: Vector; value: number } {
  let m = matrix;
  for (let step = 0; step < steps; step++) {
    const max = Math.max(...m.map(Math.abs));
    if (!(max > 0)) return { axis: [1, 0, 0], value: 0 };
    m = m.map((x) => x / max) as Matrix;
    const square = [0, 1, 2].flatMap((i) =>
      [0, 1, 2].map((j) => m[3 * i] * m[j] + m[3 * i + 1] * m[3 + j] + m[3 * i + 2] * m[6 + j]),
    ) as Matrix;
    m = square;
  }
  const columns = [0, 1, 2].map((i): Vector => [m[i], m[3 + i], m[6 + i]]);
  const longest = columns.sort((a, b) => Math.hypot(...b) - Math.hypot(...a))[0];
  const length = Math.hypot(...longest);
  const axis = longest.map((x) => x / length) as Vector;
  const image = times(matrix, axis);
  return { axis, value: image[0] * axis[0] + image[1] * axis[1] + image[2] * axis[2] };
}
