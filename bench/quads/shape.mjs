// What a quad mesh is like: valences, angles, evenness, and how far it lies from a surface.
// Role: measurements of bench/quads/quads.mjs; counted by nothing of the library's own.

import { along, cross, dot, length, mean, minus } from './vectors.mjs';

const variation = (list) => {
  const m = mean(list);
  return Math.sqrt(mean(list.map((x) => (x - m) ** 2))) / m;
};
const quantile = (list, share) =>
  list.slice().sort((a, b) => a - b)[Math.min(list.length - 1, Math.floor(share * list.length))];

/** OBJ or OFF; polygons become fans. */
export function readSurface(text) {
  const rows = text.split('\n').map((line) => line.trim().split(/\s+/));
  const fan = (ids) => ids.slice(2).map((_, i) => [ids[0], ids[i + 1], ids[i + 2]]);
  if (!rows[0][0].startsWith('OFF'))
    return {
      points: rows.filter((r) => r[0] === 'v').map((r) => r.slice(1, 4).map(Number)),
      triangles: rows
        .filter((r) => r[0] === 'f')
        .flatMap((r) => fan(r.slice(1).map((c) => parseInt(c, 10) - 1))),
    };
  const data = rows.slice(1).filter((r) => r[0] !== '' && r[0][0] !== '#');
  const [vertices, faces] = data[0].map(Number);
  return {
    points: data.slice(1, 1 + vertices).map((r) => r.slice(0, 3).map(Number)),
    triangles: data
      .slice(1 + vertices, 1 + vertices + faces)
      .flatMap((r) => fan(r.slice(1, 1 + Number(r[0])).map(Number))),
  };
}

export function readQuads(text) {
  const rows = text.split('\n').map((line) => line.split(' '));
  return {
    points: rows.filter((r) => r[0] === 'v').map((r) => r.slice(1, 4).map(Number)),
    quads: rows.filter((r) => r[0] === 'f').map((r) => r.slice(1).map((c) => parseInt(c, 10) - 1)),
  };
}

/** Ericson's nearest point, by regions: the distance from p to a triangle. */
function distanceTo(p, [a, b, c]) {
  const [ab, ac, ap] = [minus(b, a), minus(c, a), minus(p, a)];
  const [d1, d2] = [dot(ab, ap), dot(ac, ap)];
  if (d1 <= 0 && d2 <= 0) return length(ap);
  const bp = minus(p, b);
  const [d3, d4] = [dot(ab, bp), dot(ac, bp)];
  if (d3 >= 0 && d4 <= d3) return length(bp);
  const vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return length(minus(p, along(a, d1 / (d1 - d3), ab)));
  const cp = minus(p, c);
  const [d5, d6] = [dot(ab, cp), dot(ac, cp)];
  if (d6 >= 0 && d5 <= d6) return length(cp);
  const vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return length(minus(p, along(a, d2 / (d2 - d6), ac)));
  const va = d3 * d6 - d5 * d4;
  const [e, f] = [d4 - d3, d5 - d6];
  if (va <= 0 && e >= 0 && f >= 0) return length(minus(p, along(b, e / (e + f), minus(c, b))));
  const n = cross(ab, ac);
  return Math.abs(dot(ap, n)) / length(n);
}

/** The distance to a surface; its triangles are found in cubes of this size around the point. */
function distances({ points, triangles }, size) {
  const cubes = new Map();
  const at = (x) => Math.floor(x / size);
  for (const t of triangles) {
    const corners = t.map((v) => points[v]);
    const [low, high] = [Math.min, Math.max].map((f) =>
      [0, 1, 2].map((k) => at(f(...corners.map((p) => p[k])))),
    );
    for (let x = low[0]; x <= high[0]; x++)
      for (let y = low[1]; y <= high[1]; y++)
        for (let z = low[2]; z <= high[2]; z++) {
          const key = `${x} ${y} ${z}`;
          if (!cubes.has(key)) cubes.set(key, []);
          cubes.get(key).push(corners);
        }
  }
  return (p) => {
    let best = Infinity;
    for (let ring = 0; best > (ring - 1) * size; ring++) {
      const [x, y, z] = p.map(at);
      for (let i = -ring; i <= ring; i++)
        for (let j = -ring; j <= ring; j++)
          for (let k = -ring; k <= ring; k++) {
            if (Math.max(Math.abs(i), Math.abs(j), Math.abs(k)) !== ring) continue;
            for (const t of cubes.get(`${x + i} ${y + j} ${z + k}`) ?? [])
              best = Math.min(best, distanceTo(p, t));
          }
      if (ring > 60) break;
    }
    return best;
  };
}

function diagonalOf(points) {
  const ends = [0, 1, 2].map((k) => {
    const [low, high] = [Infinity, -Infinity];
    return points.reduce(([a, b], p) => [Math.min(a, p[k]), Math.max(b, p[k])], [low, high]);
  });
  return length(ends.map(([a, b]) => b - a));
}

/** Interior vertices of another valence than 4, and edges with one quad. */
function valencesOf({ points, quads }) {
  const sides = new Map();
  for (const q of quads)
    q.forEach((a, k) => {
      const key = [a, q[(k + 1) % 4]].sort((x, y) => x - y).join(' ');
      sides.set(key, (sides.get(key) ?? 0) + 1);
    });
  const valence = new Array(points.length).fill(0);
  const isRim = new Array(points.length).fill(false);
  for (const [key, count] of sides)
    for (const v of key.split(' ').map(Number)) {
      valence[v]++;
      isRim[v] ||= count === 1;
    }
  return {
    rims: [...sides.values()].filter((count) => count === 1).length,
    irregular: valence.filter((n, v) => n > 0 && !isRim[v] && n !== 4).length,
  };
}

/** All columns of the table for a mesh of quads and the surface it was made of. */
export function measureQuads(mesh, surface) {
  const { points, quads } = mesh;
  const [angles, edges, areas, samples] = [[], [], [], []];
  let [folded, dented] = [0, 0];
  for (const q of quads) {
    const p = q.map((v) => points[v]);
    const side = p.map((a, k) => minus(p[(k + 1) % 4], a));
    const normal = cross(minus(p[2], p[0]), minus(p[3], p[1]));
    areas.push(length(normal) / 2);
    let turned = 0;
    side.forEach((e, k) => {
      const before = minus([0, 0, 0], side[(k + 3) % 4]);
      const cosine = dot(e, before) / (length(e) * length(before));
      angles.push(Math.abs(90 - (180 / Math.PI) * Math.acos(Math.max(-1, Math.min(1, cosine)))));
      if (dot(cross(e, before), normal) < 0) turned++;
      edges.push(length(e));
      samples.push(along(p[k], 0.5, e));
    });
    folded += turned > 1;
    dented += turned === 1;
    samples.push([0, 1, 2].map((i) => mean(p.map((x) => x[i]))));
  }
  const diagonal = diagonalOf(surface.points);
  const distance = distances(surface, mean(edges));
  const off = samples.map((p) => (100 * distance(p)) / diagonal);
  return {
    ...{ quads: quads.length, ...valencesOf(mesh), folded, dented },
    ...{ angle: mean(angles), angle95: quantile(angles, 0.95) },
    ...{ edge: variation(edges), area: variation(areas) },
    ...{ distance: mean(off), farthest: off.reduce((a, b) => Math.max(a, b), 0) },
  };
}
