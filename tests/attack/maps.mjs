// Seamless maps that are known without solving: doubled plane regions, tori, and cones, with areas that
// may span 2^120. Each is { positions, triangles, uv, corners, q, cones, precision }.

import { Random } from './random.mjs';

const evenOrders = [2, 4, 6, 8];
const anyOrder = [1, 2, 3, 4, 5, 6, 8];

/** Ascending numbers that are dense around 0: ±2^−a. */
function dyadicLines(random, count, deepest) {
  const lines = new Set();
  while (lines.size < count)
    lines.add((random.chance(0.5) ? 1 : -1) * 2 ** -random.integer(0, deepest));
  return [...lines].sort((a, b) => a - b);
}

/** Ascending from 0, by widths 2^−a. */
function dyadicWidths(random, count, deepest) {
  const lines = [0];
  for (let i = 0; i < count; i++) lines.push(lines.at(-1) + 2 ** -random.integer(0, deepest));
  return lines;
}

const withMiddles = (lines) =>
  lines.flatMap((x, i) => (i + 1 < lines.length ? [x, x + (lines[i + 1] - x) / 2] : [x]));

/** Connected cells of an n × m grid whose boundary is a curve; it may have holes. */
function region(random, n, m) {
  for (;;) {
    const isIn = Array.from({ length: n }, () => new Array(m).fill(false));
    const grown = [[random.integer(0, n - 1), random.integer(0, m - 1)]];
    isIn[grown[0][0]][grown[0][1]] = true;
    const target = random.integer(Math.min(3, n * m), n * m);
    for (let tries = 0; grown.length < target && tries < 400; tries++) {
      const [i, j] = random.pick(grown);
      const [di, dj] = random.pick([[1, 0], [-1, 0], [0, 1], [0, -1]]); // prettier-ignore
      const [a, b] = [i + di, j + dj];
      if (a < 0 || b < 0 || a >= n || b >= m || isIn[a][b]) continue;
      isIn[a][b] = true;
      grown.push([a, b]);
    }
    const at = (i, j) => isIn[i]?.[j] ?? false;
    let isCurve = true;
    for (let i = 0; i <= n; i++)
      for (let j = 0; j <= m; j++) {
        const [a, b, c, d] = [at(i - 1, j - 1), at(i, j - 1), at(i - 1, j), at(i, j)];
        isCurve &&= !((a && d && !b && !c) || (b && c && !a && !d));
      }
    if (isCurve) return isIn;
  }
}

/**
 * Two copies of a region of the grid, sewn along its boundary: a closed surface whose genus is the
 * number of holes. The back has the mirror image of the front, so that seams are turned by 0 or π.
 */
function doubled(random) {
  const [n, m] = [random.integer(1, 5), random.integer(1, 5)];
  const isIn = region(random, n, m);
  const deepest = random.pick([3, 20, 30, 60]);
  // Every cell is halved both ways and has its middle, so that no two triangles share all vertices.
  const x = withMiddles(dyadicLines(random, n + 1, deepest));
  const y = withMiddles(dyadicLines(random, m + 1, deepest));
  const fine = (i, j) => isIn[i >> 1]?.[j >> 1] ?? false;
  const map = empty(random.pick(evenOrders));
  const vertices = new Map();
  const shift = random.chance(0.3) ? random.integer(-8, 8) : 0;
  const uvs = new Map();
  const uvOf = (key, u, v) => {
    if (!uvs.has(key)) {
      uvs.set(key, map.uv.length);
      map.uv.push([u, v]);
    }
    return uvs.get(key);
  };
  const vertexOf = (key, position) => {
    if (!vertices.has(key)) {
      vertices.set(key, map.positions.length);
      map.positions.push(position);
    }
    return vertices.get(key);
  };
  for (const side of [1, -1]) {
    const corner = (i, j) => {
      const around = [fine(i - 1, j - 1), fine(i, j - 1), fine(i - 1, j), fine(i, j)];
      const isInside = around.every(Boolean);
      const vertex = vertexOf(isInside ? `${side} ${i} ${j}` : `${i} ${j}`, [
        i + random.between(-0.2, 0.2),
        j + random.between(-0.2, 0.2),
        isInside ? side * random.between(0.2, 0.6) : 0,
      ]);
      // In units of half a turn: convex corners 1, straight 2, reflex 3.
      const inside = around.filter(Boolean).length;
      if (!isInside && inside !== 2) map.cones.set(vertex, (inside * map.q) / 2);
      return [vertex, uvOf(`${side} ${i} ${j}`, x[i] + (side < 0 ? shift : 0), side * y[j])];
    };
    for (let i = 0; i < 2 * n; i++)
      for (let j = 0; j < 2 * m; j++) {
        if (!fine(i, j)) continue;
        const around = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
        const middle = [
          vertexOf(`${side} ${i} ${j} middle`, [i + 0.5, j + 0.5, side * 0.5]),
          uvOf(
            `${side} ${i} ${j} middle`,
            x[i] + (x[i + 1] - x[i]) / 2 + (side < 0 ? shift : 0),
            side * (y[j] + (y[j + 1] - y[j]) / 2),
          ),
        ];
        for (let k = 0; k < 4; k++) {
          const [a, b] = [around[k], around[(k + 1) % 4]];
          add(map, side > 0 ? [a, b, middle] : [b, a, middle]);
        }
      }
  }
  return map;
}

/** n × m squares with opposite sides sewn together by translations. */
function torus(random) {
  const [n, m] = [random.integer(3, 7), random.integer(3, 7)];
  const deepest = random.pick([2, 10, 25]);
  const [x, y] = [dyadicWidths(random, n, deepest), dyadicWidths(random, m, deepest)];
  const map = empty(random.pick(anyOrder));
  for (let i = 0; i < n; i++)
    for (let j = 0; j < m; j++) {
      const [a, b] = [(2 * Math.PI * i) / n, (2 * Math.PI * j) / m];
      const R = 2 + Math.cos(b) * random.between(0.7, 1);
      map.positions.push([R * Math.cos(a), R * Math.sin(a), Math.sin(b)]);
    }
  for (const v of y) for (const u of x) map.uv.push([u, v]);
  const corner = (i, j) => [(i % n) * m + (j % m), j * (n + 1) + i];
  for (let i = 0; i < n; i++)
    for (let j = 0; j < m; j++) {
      const [a, b, c, d] = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
      const isRising = random.chance(0.5);
      add(map, isRising ? [a, b, c] : [a, b, d]);
      add(map, isRising ? [a, c, d] : [b, c, d]);
    }
  return map;
}

/** A disk of rings around one cone of angle 2πk/q, whose radii may span 2^60. */
function cone(random) {
  const q = random.pick(anyOrder);
  const map = empty(q);
  const k = random.integer(1, 3 * q);
  const sectors = Math.max(3, Math.ceil((3 * k) / q)) + random.integer(0, 4);
  const rings = random.integer(1, 8);
  const step = random.pick([0.3, 1, 4, 7]);
  const away = random.chance(0.3) ? 2 ** random.integer(-40, 10) : 0;
  map.positions.push([0, 0, random.between(0, 1)]);
  map.uv.push([away, away]);
  map.cones.set(0, k);
  for (let r = 1; r <= rings; r++)
    for (let s = 0; s <= sectors; s++) {
      const radius = 2 ** (-step * (rings - r)) * (s % sectors === 0 ? 1 : random.between(0.95, 1));
      const angle = (2 * Math.PI * k * s) / (q * sectors);
      map.uv.push([away + radius * Math.cos(angle), away + radius * Math.sin(angle)]);
      const around = (2 * Math.PI * s) / sectors;
      if (s < sectors)
        map.positions.push([r * Math.cos(around), r * Math.sin(around), random.between(0, 0.2)]);
    }
  const corner = (r, s) =>
    r === 0 ? [0, 0] : [1 + (r - 1) * sectors + (s % sectors), 1 + (r - 1) * (sectors + 1) + s];
  for (let s = 0; s < sectors; s++) {
    add(map, [corner(0, 0), corner(1, s), corner(1, s + 1)]);
    for (let r = 1; r < rings; r++) {
      add(map, [corner(r, s), corner(r + 1, s), corner(r + 1, s + 1)]);
      add(map, [corner(r, s), corner(r + 1, s + 1), corner(r, s + 1)]);
    }
  }
  if (k === q) map.cones.delete(0);
  return map;
}

const empty = (q) => ({
  positions: [],
  triangles: [],
  uv: [],
  corners: [],
  q,
  cones: new Map(),
  precision: 'float64',
});

function add(map, corners) {
  map.triangles.push(corners.map(([vertex]) => vertex));
  map.corners.push(corners.map(([, uv]) => uv));
}

const families = { doubled, torus, cone };
export const familyNames = Object.keys(families);

/** @param family  one of `familyNames` */
export const makeMap = (family, seed) => families[family](new Random(seed));
