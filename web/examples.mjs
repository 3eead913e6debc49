// The examples of the page: surfaces of our own making as compact GLBs, with the cones that go
// with them. Run by the build; nothing is copied from anywhere.

const tau = 2 * Math.PI;

/** Subdivides each triangle in four, n times; `place` puts new vertices where they belong. */
function subdivide(mesh, times, place) {
  let { vertices, triangles } = mesh;
  for (let i = 0; i < times; i++) {
    const middles = new Map();
    const points = [...vertices];
    const middle = (a, b) => {
      const key = Math.min(a, b) * 1e6 + Math.max(a, b);
      if (!middles.has(key)) {
        middles.set(key, points.length);
        points.push(place(points[a].map((x, k) => (x + points[b][k]) / 2)));
      }
      return middles.get(key);
    };
    triangles = triangles.flatMap(([a, b, c]) => {
      const [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
      return [
        [a, ab, ca],
        [ab, b, bc],
        [ca, bc, c],
        [ab, bc, ca],
      ];
    });
    vertices = points;
  }
  return { vertices, triangles };
}

const unit = (p) => p.map((x) => x / Math.hypot(...p));

function icosphere(times) {
  const t = (1 + Math.sqrt(5)) / 2;
  const vertices = [
    [-1, t, 0], [1, t, 0], [-1, -t, 0], [1, -t, 0],
    [0, -1, t], [0, 1, t], [0, -1, -t], [0, 1, -t],
    [t, 0, -1], [t, 0, 1], [-t, 0, -1], [-t, 0, 1],
  ].map(unit); // prettier-ignore
  const triangles = [
    [0, 11, 5], [0, 5, 1], [0, 1, 7], [0, 7, 10], [0, 10, 11],
    [1, 5, 9], [5, 11, 4], [11, 10, 2], [10, 7, 6], [7, 1, 8],
    [3, 9, 4], [3, 4, 2], [3, 2, 6], [3, 6, 8], [3, 8, 9],
    [4, 9, 5], [2, 4, 11], [6, 2, 10], [8, 6, 7], [9, 8, 1],
  ]; // prettier-ignore
  return subdivide({ vertices, triangles }, times, unit);
}

/** A surface over a grid that closes up in the given directions. */
function sheet(rows, columns, isClosed, at) {
  const [closedRows, closedColumns] = isClosed;
  const [high, wide] = [closedRows ? rows : rows + 1, closedColumns ? columns : columns + 1];
  const vertices = [];
  for (let j = 0; j < high; j++)
    for (let i = 0; i < wide; i++) vertices.push(at(i / columns, j / rows));
  const index = (i, j) => (j % high) * wide + (i % wide);
  const triangles = [];
  for (let j = 0; j < rows; j++) {
    for (let i = 0; i < columns; i++) {
      const [a, b, c, d] = [index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)];
      if ((i + j) % 2) triangles.push([a, b, c], [a, c, d]);
      else triangles.push([a, b, d], [b, c, d]);
    }
  }
  return { vertices, triangles };
}

function sphere() {
  return icosphere(4);
}

/** A cube blown up a little: its corners stay where a person sees them. */
function cube() {
  const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((i) =>
    [i & 1, (i >> 1) & 1, i >> 2].map((x) => 2 * x - 1),
  );
  const faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]; // prettier-ignore
  const start = {
    vertices: [
      ...corners,
      ...faces.map((face) =>
        face.reduce((sum, v) => sum.map((x, k) => x + corners[v][k] / 4), [0, 0, 0]),
      ),
    ],
    triangles: faces.flatMap((face, f) => face.map((v, k) => [v, face[(k + 1) % 4], 8 + f])),
  };
  const mesh = subdivide(start, 4, (p) => p);
  const round = (p) => {
    const q = 5;
    const size = p.reduce((sum, x) => sum + Math.abs(x) ** q, 0) ** (1 / q);
    return p.map((x) => x / size);
  };
  return { ...mesh, vertices: mesh.vertices.map(round) };
}

function torus() {
  return sheet(32, 72, [true, true], (u, v) => {
    const [a, b] = [-tau * u, tau * v];
    const r = 1 + 0.42 * Math.cos(b);
    return [r * Math.cos(a), 0.42 * Math.sin(b) + 0.12 * Math.sin(3 * a), r * Math.sin(a)];
  });
}

/** A bent, flaring pipe: two boundaries. */
function pipe() {
  return sheet(56, 48, [false, true], (u, v) => {
    const turn = (v - 0.5) * 2.2;
    const radius = 0.34 + 0.2 * v ** 3 + 0.1 * (1 - v) ** 4 + 0.035 * Math.cos(4 * tau * u) * v;
    const [x, y] = [radius * Math.cos(tau * u), radius * Math.sin(tau * u)];
    const center = [1.3 * Math.sin(turn), 1.3 * Math.cos(turn) - 1];
    return [center[0] + x * Math.sin(turn), center[1] + x * Math.cos(turn), y];
  });
}

/** Something grown: a sphere pushed and pulled by soft bumps. */
function pebble() {
  const bumps = [
    [[0.2, 0.9, 0.1], 0.85, 5],
    [[-0.8, 0.35, 0.45], 0.7, 6],
    [[0.75, 0.3, 0.6], 0.62, 6],
    [[-0.35, -0.8, 0.5], 0.55, 7],
    [[0.45, -0.75, -0.5], 0.6, 7],
    [[-0.1, 0.1, -1], 0.5, 5],
    [[0.9, -0.1, -0.4], -0.25, 6],
    [[-0.6, -0.2, -0.7], -0.2, 6],
  ].map(([at, height, width]) => [unit(at), height, width]);
  const grow = (p) => {
    const r = bumps.reduce((sum, [at, height, width]) => {
      const cosine = at.reduce((s, x, k) => s + x * p[k], 0);
      return sum + height * Math.exp(width * (cosine - 1));
    }, 0.75);
    return p.map((x) => x * r);
  };
  const mesh = icosphere(4);
  return { ...mesh, vertices: mesh.vertices.map(grow) };
}

/**
 * The zero set of a function, negative inside: one vertex per cell that it passes through, moved onto
 * it, and a quad per edge of the grid that it crosses (surface nets).
 */
function levelSet(f, [low, high], cells) {
  const step = high.map((x, i) => (x - low[i]) / cells[i]);
  const at = (i, j, k) => [low[0] + i * step[0], low[1] + j * step[1], low[2] + k * step[2]];
  const [a, b, c] = cells.map((n) => n + 1);
  const index = (i, j, k) => (k * b + j) * a + i;
  const values = new Float64Array(a * b * c);
  for (let k = 0; k < c; k++)
    for (let j = 0; j < b; j++) for (let i = 0; i < a; i++) values[index(i, j, k)] = f(at(i, j, k));
  const gradient = (p) =>
    [0, 1, 2].map((m) => {
      const h = 1e-4;
      const [x, y] = [-h, h].map((d) => f(p.map((t, n) => (n === m ? t + d : t))));
      return (y - x) / (2 * h);
    });
  const vertices = [];
  const vertexOf = new Map();
  const vertex = (i, j, k) => {
    const key = index(i, j, k);
    if (!vertexOf.has(key)) {
      let p = at(i + 0.5, j + 0.5, k + 0.5);
      for (let n = 0; n < 12; n++) {
        const g = gradient(p);
        const far = f(p) / g.reduce((sum, x) => sum + x * x, 1e-12);
        p = p.map((x, m) => x - 0.6 * far * g[m]);
      }
      vertexOf.set(key, vertices.length);
      vertices.push(p);
    }
    return vertexOf.get(key);
  };
  const triangles = [];
  const quad = (ring, isOut) => {
    const [p, q, r, s] = isOut ? ring : ring.toReversed();
    triangles.push([p, q, r], [p, r, s]);
  };
  for (let k = 1; k < c - 1; k++)
    for (let j = 1; j < b - 1; j++)
      for (let i = 1; i < a - 1; i++) {
        const here = values[index(i, j, k)] < 0;
        const crosses = (x, y, z) => here !== values[index(x, y, z)] < 0;
        const around = (cells_) => cells_.map(([x, y, z]) => vertex(x, y, z));
        if (crosses(i + 1, j, k)) quad(around([[i, j - 1, k - 1], [i, j, k - 1], [i, j, k], [i, j - 1, k]]), here); // prettier-ignore
        if (crosses(i, j + 1, k)) quad(around([[i - 1, j, k - 1], [i - 1, j, k], [i, j, k], [i, j, k - 1]]), here); // prettier-ignore
        if (crosses(i, j, k + 1)) quad(around([[i - 1, j - 1, k], [i, j - 1, k], [i, j, k], [i - 1, j, k]]), here); // prettier-ignore
      }
  return { vertices, triangles, normals: vertices.map((p) => unit(gradient(p))) };
}

/** Two rings grown together: genus 2. */
function rings() {
  const ring = (cx, tilt) => (p) => {
    const [x, y, z] = [p[0] - cx, p[1], p[2] - tilt * (p[0] - cx)];
    return Math.hypot(Math.hypot(x, y) - 0.66, z) - 0.27;
  };
  const parts = [ring(-0.72, 0.25), ring(0.72, -0.25)];
  const soft = 14;
  const f = (p) => -Math.log(parts.reduce((sum, one) => sum + Math.exp(-soft * one(p)), 0)) / soft;
  return levelSet(f, [[-1.9, -1.2, -0.75], [1.9, 1.2, 0.75]], [60, 38, 24]); // prettier-ignore
}

/** A small person with arms and legs. */
function figure() {
  const capsule =
    (a, b, r, s = r) =>
    (p) => {
      const d = b.map((x, i) => x - a[i]);
      const e = p.map((x, i) => x - a[i]);
      const dot = d.reduce((sum, x, i) => sum + x * e[i], 0);
      const t = Math.min(1, Math.max(0, dot / d.reduce((sum, x) => sum + x * x, 0)));
      return Math.hypot(...e.map((x, i) => x - t * d[i])) - (r + t * (s - r));
    };
  const parts = [
    capsule([0, 0.1, 0], [0, 0.62, 0.02], 0.26, 0.24),
    capsule([0, 1.12, 0.03], [0, 1.2, 0.05], 0.27),
    capsule([0, 0.8, 0], [0, 0.95, 0.02], 0.12),
    ...[-1, 1].flatMap((side) => [
      capsule([side * 0.2, 0.66, 0], [side * 0.62, 0.48, 0.06], 0.12, 0.095),
      capsule([side * 0.62, 0.48, 0.06], [side * 0.78, 0.82 - 0.5 * (side > 0), 0.2], 0.095, 0.1),
      capsule([side * 0.15, 0.02, 0], [side * 0.24, -0.5, 0.05], 0.16, 0.12),
      capsule([side * 0.24, -0.5, 0.05], [side * 0.27, -0.98, 0], 0.12, 0.1),
      capsule([side * 0.27, -1.0, 0], [side * 0.3, -1.03, 0.2], 0.11, 0.1),
    ]),
  ];
  const soft = 26;
  const f = (p) =>
    -Math.log(parts.reduce((sum, part) => sum + Math.exp(-soft * part(p)), 0)) / soft;
  return levelSet(f, [[-1.05, -1.3, -0.5], [1.05, 1.65, 0.55]], [50, 70, 25]); // prettier-ignore
}

/** Vertex normals: means over the triangles at each vertex, weighted by area. */
function normalsOf({ vertices, triangles }) {
  const sums = vertices.map(() => [0, 0, 0]);
  for (const triangle of triangles) {
    const [a, b, c] = triangle.map((v) => vertices[v]);
    const [d, e] = [b, c].map((p) => p.map((x, i) => x - a[i]));
    const cross = [0, 1, 2].map((i) => {
      const [j, k] = [(i + 1) % 3, (i + 2) % 3];
      return d[j] * e[k] - d[k] * e[j];
    });
    for (const v of triangle) cross.forEach((x, i) => (sums[v][i] += x));
  }
  return sums.map(unit);
}

/** Clay: the default of glTF is metal, which has no colour of its own. */
const clay = { baseColorFactor: [0.72, 0.52, 0.36, 1], metallicFactor: 0, roughnessFactor: 0.85 };

function glb(mesh, name) {
  const { vertices, triangles } = mesh;
  const wide = vertices.length > 65534;
  const indices = wide ? new Uint32Array(triangles.flat()) : new Uint16Array(triangles.flat());
  const arrays = [
    new Float32Array(vertices.flat()),
    new Float32Array((mesh.normals ?? normalsOf(mesh)).flat()),
  ];
  const bounds = [Math.min, Math.max].map((most) =>
    [0, 1, 2].map((k) => Math.fround(most(...vertices.map((p) => Math.fround(p[k]))))),
  );
  const padded = Buffer.alloc(Math.ceil(indices.byteLength / 4) * 4);
  Buffer.from(indices.buffer).copy(padded);
  const binary = Buffer.concat([...arrays.map(({ buffer }) => Buffer.from(buffer)), padded]);
  const size = arrays[0].byteLength;
  const points = { componentType: 5126, count: vertices.length, type: 'VEC3' };
  const json = JSON.stringify({
    asset: { version: '2.0', generator: 'hgp examples' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0, name }],
    materials: [{ name: 'clay', pbrMetallicRoughness: clay }],
    meshes: [
      { name, primitives: [{ attributes: { POSITION: 0, NORMAL: 1 }, indices: 2, material: 0 }] },
    ],
    accessors: [
      { bufferView: 0, ...points, min: bounds[0], max: bounds[1] },
      { bufferView: 1, ...points },
      { bufferView: 2, componentType: wide ? 5125 : 5123, count: indices.length, type: 'SCALAR' },
    ],
    bufferViews: [
      { buffer: 0, byteOffset: 0, byteLength: size, target: 34962 },
      { buffer: 0, byteOffset: size, byteLength: size, target: 34962 },
      { buffer: 0, byteOffset: 2 * size, byteLength: indices.byteLength, target: 34963 },
    ],
    buffers: [{ byteLength: binary.length }],
  });
  const text = Buffer.from(json.padEnd(Math.ceil(json.length / 4) * 4));
  const words = (...numbers) => Buffer.from(Uint32Array.from(numbers).buffer);
  const length = 12 + 8 + text.length + 8 + binary.length;
  const head = words(0x46546c67, 2, length, text.length, 0x4e4f534a);
  return Buffer.concat([head, text, words(binary.length, 0x004e4942), binary]);
}

/** The vertex nearest to a direction or point. */
function nearest(vertices, p) {
  const distances = vertices.map((v) => Math.hypot(...v.map((x, k) => x - p[k])));
  return distances.indexOf(Math.min(...distances));
}

export function examples() {
  const made = [
    { id: 'sphere', title: 'Sphere', hint: '3 cones, q = 6', q: 6, mesh: sphere() },
    { id: 'cube', title: 'Cube', hint: '8 cones, q = 4', q: 4, mesh: cube() },
    { id: 'torus', title: 'Torus', hint: 'no cones', q: 4, mesh: torus() },
    { id: 'pipe', title: 'Pipe', hint: 'two boundaries', q: 4, mesh: pipe() },
    { id: 'pebble', title: 'Pebble', hint: 'cones are suggested', q: 4, mesh: pebble() },
    { id: 'rings', title: 'Rings', hint: 'two holes', q: 4, mesh: rings() },
    { id: 'figure', title: 'Figure', hint: 'arms and legs', q: 4, mesh: figure() },
  ];
  const cones = {
    sphere: ({ vertices }) =>
      [0, 1, 2].map((i) => ({
        vertex: nearest(vertices, [
          Math.sin((tau * i) / 3 + 0.6),
          0.1,
          Math.cos((tau * i) / 3 + 0.6),
        ]),
        k: 2,
      })),
    cube: () => Array.from({ length: 8 }, (_, vertex) => ({ vertex, k: 3 })),
    torus: () => [],
    pipe: () => [],
  };
  return made.map(({ mesh, ...about }) => ({
    ...about,
    file: `${about.id}.glb`,
    bytes: glb(mesh, about.id),
    triangles: mesh.triangles.length,
    cones: cones[about.id]?.(mesh) ?? null,
  }));
}
