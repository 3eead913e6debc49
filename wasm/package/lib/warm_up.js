// A model to warm the engine up with: WebAssembly runs unoptimized code until a function has been busy
// for a while, and cannot switch in the middle of one, so the first large solve would take four times
// as long as the next.

/** A cube of 8 × 8 squares a side: small, and every part of the solver has work to do on it. */
export function warmUpMesh(n = 8) {
  const ids = new Map();
  const positions = [];
  const triangles = [];
  const vertex = (axis, side, i, j) => {
    const p = [];
    p[axis] = side;
    p[(axis + 1) % 3] = i;
    p[(axis + 2) % 3] = j;
    const key = p.join();
    if (!ids.has(key)) {
      ids.set(key, ids.size);
      positions.push(...p);
    }
    return ids.get(key);
  };
  for (let axis = 0; axis < 3; axis++) {
    for (const side of [0, n]) {
      for (let i = 0; i < n; i++) {
        for (let j = 0; j < n; j++) {
          const at = (u, v) => vertex(axis, side, i + u, j + v);
          const [a, b, c, d] = [at(0, 0), at(1, 0), at(1, 1), at(0, 1)];
          triangles.push(...(side ? [a, b, c, a, c, d] : [a, c, b, a, d, c]));
        }
      }
    }
  }
  return { positions: new Float64Array(positions), triangles: new Uint32Array(triangles) };
}
