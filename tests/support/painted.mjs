// A cube whose attributes are linear functions of the position on each face, so that they are known everywhere.

/** The cube's faces: a corner and two sides of it, counterclockwise from outside. */
export const cubeFaces = [
  [[0, 0, 1], [1, 0, 0], [0, 1, 0]],
  [[0, 1, 1], [1, 0, 0], [0, 0, -1]],
  [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
  [[0, 0, 0], [0, 0, 1], [0, 1, 0]],
  [[0, 0, 0], [1, 0, 0], [0, 0, 1]],
  [[0, 0, 0], [0, 1, 0], [1, 0, 0]],
]; // prettier-ignore
export const dot = (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0);
export const minus = (a, b) => a.map((x, k) => x - b[k]);
export const cross = (a, b) => [0, 1, 2].map((k) => {
  const [i, j] = [(k + 1) % 3, (k + 2) % 3];
  return a[i] * b[j] - a[j] * b[i];
}); // prettier-ignore

/** uv, colour and normal of the cube at a point of face f: linear in the position on each face. */
export const uvOf = (f, p) => {
  const [corner, a, b] = cubeFaces[f];
  const way = minus(p, corner);
  return [(f % 3) / 3 + 0.3 * dot(way, a), Math.floor(f / 3) / 2 + 0.45 * dot(way, b)];
};
export const colorOf = (p) => p.map((x) => 0.1 + 0.8 * x);
export const normalOf = (f) => cross(cubeFaces[f][1], cubeFaces[f][2]);

export const isClose = (a, b, e) =>
  a.length === b.length && a.every((x, k) => Math.abs(x - b[k]) <= e);
/** The faces of the cube that hold all these points. */
export const facesWith = (points, e = 1e-9) =>
  [0, 1, 2, 3, 4, 5].filter((f) =>
    points.every((p) => Math.abs(dot(minus(p, cubeFaces[f][0]), normalOf(f))) < e),
  );
