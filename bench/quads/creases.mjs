// How much of a surface's creases lies on edges of a quad mesh.
// Role: a column of bench/quads/quads.mjs; finds creases and edges itself, without anything of the library's own.
import { along, cross, dot, length, mean, minus } from './vectors.mjs';

const kDegrees = 30; // dihedral angle above which an edge is a crease
const kNear = 0.1; // of the mean edge of the quads
const kSkew = 20; // degrees between crease and edge
const kSamples = 4; // points of a crease edge

/** The edges whose two triangles meet at more than kDegrees, each as its two ends. */
export function creasesOf({ points, triangles }) {
  const normals = triangles.map(([a, b, c]) =>
    cross(minus(points[b], points[a]), minus(points[c], points[a])),
  );
  const other = new Map();
  const creases = [];
  triangles.forEach((t, f) =>
    t.forEach((a, k) => {
      const b = t[(k + 1) % 3];
      const g = other.get(`${b} ${a}`);
      if (g === undefined) {
        other.set(`${a} ${b}`, f);
        return;
      }
      const cosine = dot(normals[f], normals[g]) / (length(normals[f]) * length(normals[g]));
      if (cosine < Math.cos((kDegrees * Math.PI) / 180)) creases.push([points[a], points[b]]);
    }),
  );
  return creases;
}

function edgesOf({ points, quads }) {
  const edges = new Map();
  for (const q of quads)
    q.forEach((a, k) => {
      const ends = [a, q[(k + 1) % 4]].sort((x, y) => x - y);
      edges.set(ends.join(' '), ends);
    });
  return [...edges.values()].map((ends) => ends.map((v) => points[v]));
}

/** Edges by the cubes of this size that they come near to. */
function byCube(edges, size) {
  const cubes = new Map();
  for (const edge of edges) {
    const steps = Math.ceil((2 * length(minus(edge[1], edge[0]))) / size);
    const seen = new Set();
    for (let i = 0; i <= steps; i++)
      seen.add(keyOf(along(edge[0], i / steps, minus(edge[1], edge[0])), size));
    for (const key of seen) {
      if (!cubes.has(key)) cubes.set(key, []);
      cubes.get(key).push(edge);
    }
  }
  return cubes;
}
const keyOf = (p, size) => p.map((x) => Math.floor(x / size)).join(' ');

function distanceToEdge(p, [a, b]) {
  const d = minus(b, a);
  const t = Math.max(0, Math.min(1, dot(minus(p, a), d) / dot(d, d)));
  return length(minus(p, along(a, t, d)));
}

/** The share of the length of these creases that lies on edges of quads: nearer than kNear and within kSkew. */
export function shareOnEdges(creases, mesh) {
  const edges = edgesOf(mesh);
  const size = mean(edges.map(([a, b]) => length(minus(b, a))));
  const cubes = byCube(edges, size);
  const around = (p) => {
    const found = [];
    for (const x of [-1, 0, 1])
      for (const y of [-1, 0, 1])
        for (const z of [-1, 0, 1])
          found.push(...(cubes.get(keyOf(along(p, size, [x, y, z]), size)) ?? []));
    return found;
  };
  const least = Math.cos((kSkew * Math.PI) / 180);
  let [on, all] = [0, 0];
  for (const [a, b] of creases) {
    const d = minus(b, a);
    for (let i = 0; i < kSamples; i++) {
      const p = along(a, (i + 0.5) / kSamples, d);
      const isOn = around(p).some((edge) => {
        const e = minus(edge[1], edge[0]);
        return (
          distanceToEdge(p, edge) < kNear * size &&
          Math.abs(dot(d, e)) > least * length(d) * length(e)
        );
      });
      all += length(d);
      if (isOn) on += length(d);
    }
  }
  return all > 0 ? on / all : 0;
}
