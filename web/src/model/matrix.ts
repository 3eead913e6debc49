// 4 × 4 matrices by columns, as in glTF and three.js.

export type Matrix = readonly number[];

export const identity: Matrix = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/** a · b: b is applied first. */
export const product = (a: Matrix, b: Matrix): Matrix =>
  Array.from({ length: 16 }, (_, n) => {
    const [row, column] = [n % 4, n - (n % 4)];
    let sum = 0;
    for (let i = 0; i < 4; i++) sum += a[row + 4 * i] * b[column + i];
    return sum;
  });

/** Scales, then rotates by a unit quaternion x y z w, then translates. */
export function composed(
  [tx, ty, tz]: readonly number[],
  [x, y, z, w]: readonly number[],
  [sx, sy, sz]: readonly number[],
): Matrix {
  const right = [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)];
  const up = [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)];
  const back = [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)];
  return [
    ...[...right.map((n) => sx * n), 0],
    ...[...up.map((n) => sy * n), 0],
    ...[...back.map((n) => sz * n), 0],
    ...[tx, ty, tz, 1],
  ];
}

/** Of the linear part: negative for reflections. */
export const determinant = (m: Matrix): number =>
  m[0] * (m[5] * m[10] - m[9] * m[6]) -
  m[4] * (m[1] * m[10] - m[9] * m[2]) +
  m[8] * (m[1] * m[6] - m[5] * m[2]);
