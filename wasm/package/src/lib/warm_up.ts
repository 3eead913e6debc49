// A model for warming up the engine: WebAssembly functions run unoptimized until they have been called often
// enough, and engines do not switch in the middle of a call, so the first large solve would take four times
// as long as the next.

/**
 * A cube with 8 × 8 squares per side: small, but it exercises every part of the solver.
 * @internal
 */
export function warmUpMesh(n = 8): { positions: Float64Array; triangles: Uint32Array } {
  const ids = new Map<string, number>();
  const positions: number[] = [];
  const triangles: number[] = [];
  const vertex = (axis: number, side: number, i: number, j: number): number => {
    const p = [0, 0, 0];
    p[axis] = side;
    p[(axis + 1) % 3] = i;
    p[(axis + 2) % 3] = j;
    const key = p.join();
    const known = ids.get(key);
    if (known !== undefined) return known;
    const id = ids.size;
    ids.set(key, id);
    positions.push(...p);
    return id;
  };
  for (let axis = 0; axis < 3; axis++) {
    for (const side of [0, n]) {
      for (let i = 0; i < n; i++) {
        for (let j = 0; j < n; j++) {
          const at = (u: number, v: number): number => vertex(axis, side, i + u, j + v);
          const [a, b, c, d] = [at(0, 0), at(1, 0), at(1, 1), at(0, 1)];
          triangles.push(...(side ? [a, b, c, a, c, d] : [a, c, b, a, d, c]));
        }
      }
    }
  }
  return { positions: new Float64Array(positions), triangles: new Uint32Array(triangles) };
}
