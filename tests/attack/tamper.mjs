// What is done to a map, or to its surface, before it is checked. Each changes `map` in place and returns
// nothing; what a change means for the verdict is for the exact check to find out.

const amounts = [1e-9, 1e-7, 5e-7, 9e-7, 1.1e-6, 2e-6, 1e-5, 1e-3, 0.1];

const copyUv = (map, index) => {
  map.uv[index] = [...map.uv[index]];
  return map.uv[index];
};

/** The shortest side of a triangle that has this uv. */
function shortestSide(map, index) {
  let shortest = Infinity;
  for (const corners of map.corners) {
    const k = corners.indexOf(index);
    if (k < 0) continue;
    for (const other of [corners[(k + 1) % 3], corners[(k + 2) % 3]]) {
      const [a, b] = [map.uv[index], map.uv[other]];
      shortest = Math.min(shortest, Math.hypot(a[0] - b[0], a[1] - b[1]));
    }
  }
  return shortest;
}

const anyCorner = (map, random) => {
  const t = random.integer(0, map.corners.length - 1);
  return [t, random.integer(0, 2)];
};

const nextUp = (x, steps) => {
  const view = new DataView(new ArrayBuffer(8));
  view.setFloat64(0, x);
  view.setBigInt64(0, view.getBigInt64(0) + BigInt(steps));
  return view.getFloat64(0);
};

export const tampers = {
  nothing() {},

  /** One uv moved by a share of the shortest side there: a torn seam, or merely another inner point. */
  moveUv(map, random) {
    const [t, k] = anyCorner(map, random);
    const index = map.corners[t][k];
    const by = shortestSide(map, index) * random.pick(amounts);
    const angle = random.between(0, 2 * Math.PI);
    const uv = copyUv(map, index);
    uv[0] += by * Math.cos(angle);
    uv[1] += by * Math.sin(angle);
  },

  /** One uv put on the opposite side of a triangle, or a step of the number type beside it. */
  flatten(map, random) {
    const [t, k] = anyCorner(map, random);
    const [a, b] = [map.corners[t][(k + 1) % 3], map.corners[t][(k + 2) % 3]].map((i) => map.uv[i]);
    const share = random.chance(0.5) ? 2 ** -random.integer(1, 4) : random.unit();
    const uv = copyUv(map, map.corners[t][k]);
    for (const n of [0, 1])
      uv[n] = nextUp(a[n] + (b[n] - a[n]) * share, random.chance(0.5) ? random.integer(-1, 1) : 0);
  },

  /** A triangle with two uv exchanged. */
  flip(map, random) {
    const t = random.integer(0, map.corners.length - 1);
    const [a, b, c] = map.corners[t];
    map.corners[t] = [b, a, c];
  },

  mirror(map) {
    map.uv = map.uv.map(([u, v]) => [-u, v]);
  },

  /** A cone asked for with another index, or at a regular vertex. */
  otherIndex(map, random) {
    const [t, k] = anyCorner(map, random);
    const vertex = map.triangles[t][k];
    map.cones.set(vertex, (map.cones.get(vertex) ?? map.q) + random.pick([-1, 1]));
    if (map.cones.get(vertex) < 1) map.cones.set(vertex, map.q + 1);
  },

  forgottenCone(map, random) {
    const vertices = [...map.cones.keys()];
    if (vertices.length > 0) map.cones.delete(random.pick(vertices));
  },

  otherOrder(map, random) {
    const order = random.pick([1, 2, 3, 4, 5, 6, 8]);
    for (const [vertex, k] of map.cones) {
      const other = (k * order) / map.q;
      map.cones.set(vertex, Number.isInteger(other) ? other : Math.max(1, Math.round(other)));
    }
    map.q = order;
  },

  scalePowerOfTwo(map, random) {
    const factor = 2 ** random.integer(-300, 300);
    map.uv = map.uv.map((p) => p.map((x) => x * factor));
  },

  scale(map, random) {
    const factor = random.between(0.1, 10);
    map.uv = map.uv.map((p) => p.map((x) => x * factor));
  },

  /** Far from the origin small edges lose their digits. */
  translate(map, random) {
    const [du, dv] = [random.between(-1, 1), random.between(-1, 1)];
    const size = 2 ** random.integer(-20, 45);
    map.uv = map.uv.map(([u, v]) => [u + du * size, v + dv * size]);
  },

  /** By 16 digits' worth of noise at most, everywhere. */
  noise(map, random) {
    const size = 10 ** random.between(-17, -8);
    map.uv = map.uv.map((p) => p.map((x) => x * (1 + size * random.between(-1, 1))));
  },

  /** Every triangle with uv of its own: whether sides agree is then a matter of numbers alone. */
  soup(map) {
    const uv = [];
    map.corners = map.corners.map((corners) => corners.map((c) => uv.push([...map.uv[c]]) - 1));
    map.uv = uv;
  },

  /** Copies of triangles, wound either way, with the uv of their twins or others. */
  duplicate(map, random) {
    const count = random.integer(1, 3);
    for (let n = 0; n < count; n++) {
      const t = random.integer(0, map.triangles.length - 1);
      const order = random.pick([[0, 1, 2], [1, 2, 0], [0, 2, 1]]); // prettier-ignore
      map.triangles.push(order.map((k) => map.triangles[t][k]));
      const isSame = random.chance(0.7);
      map.corners.push(order.map((k) => map.corners[t][isSame ? k : (k + 1) % 3]));
    }
  },

  /** Triangles that name a vertex twice. */
  fold(map, random) {
    const t = random.integer(0, map.triangles.length - 1);
    map.triangles.push([0, 0, 1].map((k) => map.triangles[t][k]));
    map.corners.push([0, 0, 1].map((k) => map.corners[t][k]));
  },

  /** A vertex of the surface put on the middle of an edge beside it: a triangle without area. */
  flatTriangle(map, random) {
    const [t, k] = anyCorner(map, random);
    const [v, a, b] = [0, 1, 2].map((n) => map.triangles[t][(k + n) % 3]);
    // Small integers, so that the three are on a line exactly.
    const whole = (p) => p.map((x) => 2 * Math.round(8 * x));
    map.positions[a] = whole(map.positions[a]);
    map.positions[b] = whole(map.positions[b]);
    map.positions[v] = map.positions[a].map((x, n) => (x + map.positions[b][n]) / 2);
  },

  /** Some triangles wound the other way in the file. */
  reverse(map, random) {
    const count = random.integer(1, Math.min(3, map.triangles.length));
    for (let n = 0; n < count; n++) {
      const t = random.integer(0, map.triangles.length - 1);
      map.triangles[t].reverse();
      map.corners[t].reverse();
    }
  },

  /** Two vertices become one: a point where the surface touches itself. */
  pinch(map, random) {
    const [t, k] = anyCorner(map, random);
    const [s, l] = anyCorner(map, random);
    const [a, b] = [map.triangles[t][k], map.triangles[s][l]];
    const around = (v) => new Set(map.triangles.filter((c) => c.includes(v)).flat());
    const [near, far] = [around(a), around(b)];
    // Cones are named by vertex; and edges must not meet.
    if (a === b || map.cones.has(a) || map.cones.has(b) || [...near].some((v) => far.has(v)))
      return;
    for (const corners of map.triangles)
      for (let n = 0; n < 3; n++) if (corners[n] === b) corners[n] = a;
  },

  /** Stored as glTF does. v may be small, and 1 − v then has digits that float32 has not. */
  float32(map, random) {
    map.precision = 'float32';
    map.vIs = random.pick(['1 - v', '-v']);
  },
};
export const tamperNames = Object.keys(tampers);
