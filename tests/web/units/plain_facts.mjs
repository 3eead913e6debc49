// What is known of a surface, counted as plainly as can be: beside what the solver tells, and for tests without
// the solver.

const sub = (a, b) => a.map((x, i) => x - b[i]);
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];

/** Of a mesh { vertices, triangles } that nothing was repaired or welded in. */
export function plainFacts({ vertices, triangles }) {
  const count = vertices.length;
  const sides = new Map(); // of every edge: how many triangles
  const angle = new Array(count).fill(0);
  const valence = new Array(count).fill(0);
  const around = vertices.map(() => new Set());
  let area = 0;
  for (const t of triangles) {
    for (let k = 0; k < 3; k++) {
      const [v, w, u] = [0, 1, 2].map((i) => t[(k + i) % 3]);
      const [a, b] = [sub(vertices[w], vertices[v]), sub(vertices[u], vertices[v])];
      const twice = Math.sqrt(dot(cross(a, b), cross(a, b)));
      angle[v] += Math.atan2(twice, dot(a, b));
      area += twice / 6;
      valence[v] += 1;
      for (const end of [w, u]) around[v].add(end);
      const key = `${Math.min(v, w)} ${Math.max(v, w)}`;
      sides.set(key, (sides.get(key) ?? 0) + 1);
    }
  }
  const isBoundary = new Array(count).fill(0);
  for (const [key, n] of sides) if (n === 1) for (const v of key.split(' ')) isBoundary[v] = 1;
  const component = new Array(count).fill(-1);
  let number = 0;
  for (const [first] of triangles) {
    if (component[first] >= 0) continue;
    const open = [first];
    component[first] = number;
    for (const v of open) {
      for (const w of around[v]) {
        if (component[w] >= 0) continue;
        component[w] = number;
        open.push(w);
      }
    }
    number += 1;
  }
  const neighbours = around.flatMap((all) => [...all].sort((a, b) => a - b));
  const neighbourStart = [0];
  for (const all of around) neighbourStart.push(neighbourStart.at(-1) + all.size);
  return {
    representative: Int32Array.from(vertices, (_, v) => v),
    angle: Float64Array.from(angle),
    valence: Uint32Array.from(valence),
    isBoundary: Uint8Array.from(isBoundary),
    component: Int32Array.from(component),
    triangleComponent: Int32Array.from(triangles, ([v]) => component[v]),
    neighbourStart: Uint32Array.from(neighbourStart),
    neighbours: Uint32Array.from(neighbours),
    area,
  };
}
