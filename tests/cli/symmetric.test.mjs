// Symmetric maps: the numbers that OBJ and GLB store for one side are those of the other, with −u for u, to the last bit. The
// files are read here, by nothing of the project's own.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { readers } from '../support/mapped_corners.mjs';
import { inFolder } from '../support/program.mjs';

const { at, put, good, run } = inFolder('symmetric');

let state = 1;
const random = () => (state = (48271 * state) % 2147483647) / 2147483647 - 0.5;

/** n × m squares over places of a grid, with random diagonals but where three corners would be on the rim. */
function sheet(n, m, place) {
  const id = (i, j) => i * (m + 1) + j;
  const vertices = [];
  for (let i = 0; i <= n; i++) for (let j = 0; j <= m; j++) vertices.push(place(i, j));
  const triangles = [];
  for (let i = 0; i < n; i++)
    for (let j = 0; j < m; j++) {
      const [a, b, c, d] = [id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)];
      const [isEndI, isEndJ] = [i % (n - 1) === 0, j % (m - 1) === 0];
      const isRising = isEndI && isEndJ ? (i === 0) === (j === 0) : random() > 0;
      if (isRising) triangles.push([a, b, c], [a, c, d]);
      else triangles.push([a, b, d], [b, c, d]);
    }
  return { vertices, triangles };
}

/** A mesh with x ≥ 0, and its mirror image across x = 0; vertices at equal places are one. Triangles in mixed order. */
function glued({ vertices, triangles }) {
  const ids = new Map();
  const out = { vertices: [], triangles: [] };
  const vertex = (p) => {
    const key = p.map((x) => Math.round(1e6 * x) + 0).join(' ');
    if (!ids.has(key)) ids.set(key, out.vertices.push(p) - 1);
    return ids.get(key);
  };
  const flip = ([x, y, z]) => [x === 0 ? 0 : -x, y, z];
  for (const t of triangles) {
    const [a, b, c] = t.map((v) => vertices[v].map(Math.fround));
    out.triangles.push([a, b, c].map(vertex), [a, c, b].map(flip).map(vertex));
  }
  const order = out.triangles.map((t) => [random(), t]).sort(([a], [b]) => a - b);
  out.triangles = order.map(([, t]) => t);
  return out;
}

const { PI, cos, sin } = Math;
const near = (x) => (Math.abs(x) < 1e-6 ? 0 : x);
/** Half of a torus, with x ≥ 0: its rims are two circles in the plane. */
const halfTorus = sheet(12, 10, (i, j) => {
  const [a, b] = [(PI * i) / 12 - PI / 2, (2 * PI * j) / 10];
  const r = 1 + 0.4 * cos(b) + (i > 0 && i < 12 && j > 0 && j < 10 ? 0.05 * random() : 0);
  return [near(r * cos(a)), r * sin(a), 0.4 * sin(b)];
});
/** Half of an ellipsoid, as a square that is pushed out; its only rim is in the plane. */
const halfBall = sheet(10, 10, (i, j) => {
  const [s, t] = [i / 5 - 1, j / 5 - 1];
  const [y, z] = [s * Math.sqrt(1 - (t * t) / 2), t * Math.sqrt(1 - (s * s) / 2)];
  return [near(Math.sqrt(Math.max(0, 1 - y * y - z * z))), 1.5 * y, 0.8 * z];
});
/** A hill; one of the four sides of its rim is in the plane. */
const hill = sheet(8, 8, (i, j) => [i, j, 0.5 * sin(0.7 * i + 0.3) * cos(0.5 * j)]);
const shapes = { torus: glued(halfTorus), ellipsoid: glued(halfBall), 'open hill': glued(hill) };

const toObj = ({ vertices, triangles }) =>
  [...vertices.map((p) => `v ${p.join(' ')}`), ...triangles.map((t) => `f ${t.map((i) => i + 1).join(' ')}`), ''].join('\n'); // prettier-ignore

const placeOf = (p) => p.map((x) => Math.round(1e5 * x) + 0).join(' ');
const mirrored = ([x, y, z]) => [-x, y, z];

/** Every corner has an image, whose u is the negative and whose v is the same, without any rounding. */
function checkMirrored(corners, axis = 0) {
  const uvOf = new Map();
  for (const t of corners)
    t.forEach(([p, uv], k) => {
      const others = [t[(k + 1) % 3][0], t[(k + 2) % 3][0]].map(placeOf).sort();
      uvOf.set([placeOf(p), ...others].join(' | '), uv);
    });
  for (const t of corners) {
    const [a, b, c] = t.map(([, uv]) => uv);
    assert.ok((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0, 'positive');
    t.forEach(([p, [u, v]], k) => {
      const others = [t[(k + 1) % 3][0], t[(k + 2) % 3][0]].map((q) => placeOf(mirrored(q))).sort();
      const image = uvOf.get([placeOf(mirrored(p)), ...others].join(' | '));
      assert.ok(image, 'an image');
      assert.equal(image[0] + 0, 2 * axis - u + 0);
      assert.equal(image[1], v);
    });
  }
}

for (const [name, mesh] of Object.entries(shapes))
  test(`${name}: coordinates of both sides are mirror images in the stored bits`, () => {
    put('in.obj', toObj(mesh));
    for (const plane of ['X', 'auto'])
      for (const out of ['out.obj', 'out.glb']) {
        good('param', 'in.obj', '--symmetric', plane, '-o', out, '--force', '--json', 'r.json');
        checkMirrored(readers[out.slice(4)](at(out)));
        const { certificate } = JSON.parse(readFileSync(at('r.json'), 'utf8'));
        assert.ok(certificate.certified);
      }
  });

test('squares whose diagonals are equally good are cut as their images are', () => {
  const squares = [];
  for (let i = 0; i < 4; i++)
    for (let j = 0; j < 5; j++) squares.push([[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]]); // prettier-ignore
  const images = squares.map((square) => square.map(([x, y]) => [-x, y]).reverse());
  const places = new Map();
  const faces = [...squares, ...images].map((square) =>
    square.map((p) => places.get(p.join()) ?? (places.set(p.join(), places.size + 1), places.size)),
  );
  const rows = [...places.keys()].map((key) => `v ${key.replace(',', ' ')} 0`);
  put('in.obj', [...rows, ...faces.map((face) => `f ${face.join(' ')}`), ''].join('\n'));
  good('param', 'in.obj', '--symmetric', 'X', '-o', 'out.obj', '--force');
  const square = (corners) => corners.map(([p]) => placeOf(p)).sort().join(' '); // prettier-ignore
  const mapped = readers.obj(at('out.obj'));
  const uvOf = new Map(
    mapped.flatMap((corners) => corners.map(([p, uv]) => [placeOf(p) + square(corners), uv])),
  );
  assert.equal(uvOf.size, 4 * 40);
  for (const corners of mapped)
    for (const [p, [u, v]] of corners) {
      const there = corners.map(([q]) => [mirrored(q)]);
      const image = uvOf.get(placeOf(mirrored(p)) + square(there));
      assert.deepEqual([image[0] + 0, image[1]], [-u + 0, v]);
    }
});

test('a map with a grid is mirrored as well, and its plane is on a line', () => {
  for (const [name, mesh] of Object.entries(shapes)) {
    put('in.obj', toObj(mesh));
    for (const mode of ['tile', 'quad']) {
      good('param', 'in.obj', '--symmetric', 'X', '--cells', '600', '--grid-mode', mode, '-o', 'grid.obj', '--force', '--json', 'r.json'); // prettier-ignore
      checkMirrored(readers.obj(at('grid.obj')));
      const { components } = JSON.parse(readFileSync(at('r.json'), 'utf8'));
      assert.ok(components[0].grid.aligned, `${name}, ${mode}`);
    }
    good('quads', 'in.obj', '--symmetric', 'X', '-o', 'quads.obj', '--force');
  }
});

test('an improvement is mirrored as well, with a grid and without', () => {
  for (const [name, mesh] of Object.entries(shapes)) {
    put('in.obj', toObj(mesh));
    for (const grid of [[], ['--cells', '600', '--grid-mode', 'quad']]) {
      good('param', 'in.obj', '--symmetric', 'X', grid, '--improve', 'isometric', '-o', 'better.obj', '--force', '--json', 'r.json'); // prettier-ignore
      checkMirrored(readers.obj(at('better.obj')));
      const { certificate, components } = JSON.parse(readFileSync(at('r.json'), 'utf8'));
      assert.ok(certificate.certified, name);
      const { kept, before, after, onGrid } = components[0].improvement;
      assert.ok(kept && after.symmetricDirichlet < before.symmetricDirichlet, name);
      assert.equal(onGrid !== null, grid.length > 0);
    }
  }
});

test('edges across the plane are split, as is said', () => {
  const t = (1 + Math.sqrt(5)) / 2;
  const signs = [1, -1].flatMap((a) => [1, -1].map((b) => [a, b * t]));
  const places = signs.flatMap(([a, b]) => [[0, a, b], [a, b, 0], [b, 0, a]]); // prettier-ignore
  const near = (p, q) => p.reduce((sum, x, i) => sum + (x - q[i]) ** 2, 0) < 4.1;
  const triangles = [];
  for (let i = 0; i < 12; i++)
    for (let j = 0; j < 12; j++)
      for (let k = 0; k < 12; k++) {
        const [p, q, r] = [places[i], places[j], places[k]];
        if (i >= j || i >= k || j === k || !near(p, q) || !near(q, r) || !near(r, p)) continue;
        const volume = p[0] * (q[1] * r[2] - q[2] * r[1]) - p[1] * (q[0] * r[2] - q[2] * r[0]) + p[2] * (q[0] * r[1] - q[1] * r[0]); // prettier-ignore
        if (volume > 0) triangles.push([i, j, k]);
      }
  assert.equal(triangles.length, 20);
  put('in.obj', toObj({ vertices: places, triangles }));
  for (const out of ['out.obj', 'out.glb']) {
    good('param', 'in.obj', '--symmetric', 'X', '-o', out, '--force', '--json', 'r.json');
    const corners = readers[out.slice(4)](at(out));
    assert.equal(corners.length, 24);
    checkMirrored(corners);
    const { notes } = JSON.parse(readFileSync(at('r.json'), 'utf8'));
    assert.ok(notes.some(({ code }) => code === 'symmetric-split'));
  }
});

test('creases on one side are creases on both', () => {
  const fold = sheet(8, 8, (i, j) => [i, j, Math.abs(i - 3) + 0.05 * sin(j)]);
  const { vertices, triangles } = glued(fold);
  const at4 = (p) => p[1] === 4 && p[0] >= 0 && p[0] <= 8;
  const list = vertices.flatMap((p, v) => vertices.flatMap((q, w) => (v < w && at4(p) && at4(q) && Math.abs(p[0] - q[0]) === 1 ? [`${v} ${w}`] : []))); // prettier-ignore
  assert.equal(list.length, 8);
  put('in.obj', toObj({ vertices, triangles }));
  put('list.txt', list.join('\n'));
  for (const how of [['--creases'], ['--features', 'list.txt']]) {
    good('param', 'in.obj', '--symmetric', 'X', ...how, '-o', 'out.obj', '--force', '--json', 'r.json'); // prettier-ignore
    checkMirrored(readers.obj(at('out.obj')));
    const { certificate } = JSON.parse(readFileSync(at('r.json'), 'utf8'));
    const { edges } = certificate.features;
    assert.equal(edges, 48 + 8 + 16, how.join(' '));
  }
});

test('other formats of the same map are mirrored, too', () => {
  put('in.obj', toObj(shapes.torus));
  good('param', 'in.obj', '--symmetric', 'X', '-o', 'out.obj', '--also', 'also.glb', '--force');
  checkMirrored(readers.glb(at('also.glb')));
});

test('what is not symmetric is refused, with the exit code of its reason', () => {
  const { vertices, triangles } = shapes.ellipsoid;
  put('in.obj', toObj(shapes.ellipsoid));
  const code = (...words) => run('param', 'in.obj', '-o', 'no.obj', ...words).code;
  const symmetric = ['--symmetric', 'X'];
  assert.equal(code(...symmetric, '--q', '6'), 2);
  assert.equal(code(...symmetric, '--boundary', 'convex'), 2);
  assert.equal(code(...symmetric, '--refine'), 2);
  assert.equal(code(...symmetric, '--convex-polygons'), 2);
  assert.equal(code('--symmetric', 'W'), 2);
  const inside = vertices.findIndex(([x]) => x > 0.5);
  assert.equal(code(...symmetric, '--cone', `${inside}:3`), 2);
  put('in.obj', toObj({ vertices: vertices.map(([x, y, z]) => [x + 0.1 * y * y * x, y + 0.2 * x, z]), triangles })); // prettier-ignore
  assert.equal(code(...symmetric), 4);
  put('in.obj', toObj({ vertices, triangles: triangles.slice(1) }));
  assert.equal(code(...symmetric), 4);
});

test('inspect lists the planes', () => {
  put('in.obj', toObj(shapes['open hill']));
  good('inspect', 'in.obj', '--json', 'i.json');
  const { mirrors } = JSON.parse(readFileSync(at('i.json'), 'utf8'));
  assert.equal(mirrors.length, 1);
  const [{ name, offset, edgesIn, edgesAcross }] = mirrors;
  assert.deepEqual([name, edgesIn, edgesAcross], ['X', 8, 0]);
  assert.ok(Math.abs(offset) < 1e-6);
});

/** A torus of 12 × 12 squares from two angles, with diagonals that rise where isRising(i) says so. */
function torus(place, isRising) {
  const id = (i, j) => (i % 12) * 12 + (j % 12);
  const [vertices, triangles] = [[], []];
  for (let i = 0; i < 12; i++)
    for (let j = 0; j < 12; j++) {
      vertices.push(place((PI * i) / 6, (PI * j) / 6));
      const [a, b, c, d] = [id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)];
      triangles.push(...(isRising(i) ? [[a, b, c], [a, c, d]] : [[a, b, d], [b, c, d]])); // prettier-ignore
    }
  return { vertices, triangles };
}

test('a reflection without two sides is refused, and inspect does not list it', () => {
  const free = (t, p) => [cos(t) * (2 + 1.1 * cos(p)), cos(p) + 0.2 * cos(2 * t), sin(p) * sin(t) + 0.3 * sin(2 * t)]; // prettier-ignore
  const exchanged = (t, p) => [sin(t) - sin(p) + 0.4 * (cos(t) - cos(p)), cos(t) + cos(p) + 0.3 * sin(t) * sin(p), sin(t) + sin(p) + 0.2 * cos(t) * cos(p)]; // prettier-ignore
  for (const mesh of [
    torus(free, (i) => i < 6),
    torus(exchanged, () => true),
    torus(exchanged, () => false),
  ]) {
    // prettier-ignore
    put('in.obj', toObj(mesh));
    assert.equal(run('param', 'in.obj', '--symmetric', 'X', '-o', 'no.obj').code, 4);
    good('inspect', 'in.obj', '--json', 'i.json');
    const { mirrors } = JSON.parse(readFileSync(at('i.json'), 'utf8'));
    assert.ok(mirrors.every(({ name }) => name !== 'X'));
  }
});

test('components are mirrored each at its own line', () => {
  const { vertices, triangles } = shapes.ellipsoid;
  const all = [0, 1, 2, 3].flatMap((n) => vertices.map(([x, y, z]) => [x, y, z + 3 * n]));
  const others = [0, 1, 2, 3].flatMap((n) => triangles.map((t) => t.map((v) => v + n * vertices.length))); // prettier-ignore
  put('in.obj', toObj({ vertices: all, triangles: others }));
  good('param', 'in.obj', '--symmetric', 'X', '-o', 'out.obj', '--force');
  const corners = readers.obj(at('out.obj'));
  for (const n of [0, 1, 2, 3]) {
    const own = corners.filter((t) => Math.abs(t[0][0][2] - 3 * n) < 1);
    const us = own.flatMap((t) => t.map(([, [u]]) => u));
    checkMirrored(own, (Math.min(...us) + Math.max(...us)) / 2);
  }
});

/** The shape beside its image, each of them off the plane and no image of itself, with vertices in another order. */
function besideImage({ vertices, triangles }) {
  const count = vertices.length;
  const places = vertices.map(([x, y, z]) => [x + 0.1 * y + 20, y + 0.1 * z, z + 0.2 * x].map(Math.fround)); // prettier-ignore
  const images = places.map(([x, y, z]) => [-x, y, z]).reverse();
  const turned = triangles.map((t) => t.map((v) => 2 * count - 1 - v).reverse());
  return { vertices: [...places, ...images], triangles: [...triangles, ...turned.reverse()] };
}

/** The boxes in uv of parts, each of which is a list of triangles, leave each other room, right of and above the origin; v of GLB points down from 1. */
function checkApart(parts) {
  const boxes = parts.map((part) => {
    const uv = part.flatMap((t) => t.map(([, one]) => one));
    return [0, 1].map((i) => [Math.min, Math.max].map((end) => end(...uv.map((one) => one[i]))));
  });
  assert.ok(
    boxes.every((box) => box.every(([low]) => low >= -1)),
    `${boxes}`,
  );
  boxes.forEach((a, n) => {
    for (const b of boxes.slice(n + 1))
      assert.ok(
        [0, 1].some((i) => a[i][1] < b[i][0] || b[i][1] < a[i][0]),
        `${a} and ${b}`,
      );
  });
}

/** Numbers c and d with c − u and v + d at the image of every corner, the same for all of a pair. */
function checkPair(corners, what) {
  const uvOf = new Map();
  const keyOf = (places) => places.map(placeOf).join(' | ');
  for (const t of corners)
    t.forEach(([p, uv], k) => uvOf.set(keyOf([p, t[(k + 1) % 3][0], t[(k + 2) % 3][0]]), uv));
  const seen = new Set();
  for (const t of corners)
    t.forEach(([p, [u, v]], k) => {
      if (p[0] < 0) return;
      const image = uvOf.get(keyOf([p, t[(k + 2) % 3][0], t[(k + 1) % 3][0]].map(mirrored)));
      assert.ok(image, 'an image');
      seen.add(`${image[0] + u} ${image[1] - v}`);
    });
  assert.equal(seen.size, 1, `${what}: ${[...seen]}`);
}

test('components that are images of each other are so in the stored bits, with a grid and without', () => {
  for (const name of ['torus', 'open hill']) {
    put('in.obj', toObj(besideImage(shapes[name])));
    for (const more of [[], ['--scale', 'fit'], ['--cells', '600'], ['--creases', '60']])
      for (const out of ['out.obj', 'out.glb']) {
        good('param', 'in.obj', '--symmetric', 'X', more, '-o', out, '--force', '--json', 'r.json');
        checkPair(readers[out.slice(4)](at(out)), [name, ...more, out]);
        const { certificate, notes } = JSON.parse(readFileSync(at('r.json'), 'utf8'));
        assert.ok(certificate.certified);
        assert.equal(notes.find(({ code }) => code === 'symmetric').numbers.pairs, 1);
      }
    good('quads', 'in.obj', '--symmetric', 'X', '-o', 'quads.obj', '--force');
  }
});

test('pairs beside each other leave each other room', () => {
  const all = { vertices: [], triangles: [] };
  for (const [n, name] of ['torus', 'open hill', 'ellipsoid'].entries()) {
    const { vertices, triangles } = besideImage(shapes[name]);
    const first = all.vertices.length;
    all.vertices.push(...vertices.map(([x, y, z]) => [x, y, z + 40 * n]));
    all.triangles.push(...triangles.map((t) => t.map((v) => v + first)));
  }
  put('in.obj', toObj(all));
  for (const grid of [[], ['--cells', '2000']])
    for (const out of ['out.obj', 'out.glb']) {
      good('param', 'in.obj', '--symmetric', 'X', grid, '-o', out, '--force');
      const corners = readers[out.slice(4)](at(out));
      const pairs = [0, 1, 2].map((n) => corners.filter((t) => Math.round(t[0][0][2] / 40) === n));
      pairs.forEach((pair, n) => checkPair(pair, [n, out]));
      checkApart(pairs.flatMap((pair) => [1, -1].map((sign) => pair.filter((t) => sign * t[0][0][0] > 0)))); // prettier-ignore
    }
});

test('what is split on one of a pair is split on both, and where one has no map, neither has', () => {
  const plain = { vertices: [[3, 0, 0], [5, 0.2, 0.1], [4, 1.7, 0.3], [4.2, 0.5, 1.4]], triangles: [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]] }; // prettier-ignore
  put('in.obj', toObj(besideImage(plain)));
  good('param', 'in.obj', '--symmetric', 'X', '--creases', '-o', 'out.obj', '--force');
  const corners = readers.obj(at('out.obj'));
  assert.equal(corners.length, 32);
  checkPair(corners, 'plain');
  put('in.obj', toObj(besideImage(shapes.torus)));
  const { code } = run('param', 'in.obj', '--symmetric', 'X', '--cone', '0:3', '--cone', '5:5', '--keep-going', '-o', 'out.obj', '--force', '--json', 'r.json'); // prettier-ignore
  assert.equal(code, 6);
  const { notes } = JSON.parse(readFileSync(at('r.json'), 'utf8'));
  assert.equal(notes.filter((note) => note.code === 'component-without-map').length, 2);
  assert.ok(!notes.some((note) => note.code === 'symmetric'));
});

test('a turning of the first of a pair goes with cones of the second', () => {
  const { vertices, triangles } = besideImage(shapes['open hill']);
  put('in.obj', toObj({ vertices, triangles }));
  const used = new Map();
  for (const t of triangles) for (const v of t) used.set(v, (used.get(v) ?? 0) + 1);
  const inside = [...used].find(([v, n]) => n >= 6 && vertices[v][0] < 0)[0];
  good('param', 'in.obj', '--symmetric', 'X', '--turning', '0:3', '--cone', `${inside}:3`, '-o', 'out.obj', '--force'); // prettier-ignore
  checkPair(readers.obj(at('out.obj')), 'turning');
});

test('a turning that the image of a component does not have is refused', () => {
  put('in.obj', toObj(besideImage(shapes['open hill'])));
  good('param', 'in.obj', '--symmetric', 'X', '--turning', '0:4', '-o', 'out.obj', '--force');
  good('param', 'in.obj', '--symmetric', 'X', '--turning', '1:4', '-o', 'out.obj', '--force');
  const { code } = run('param', 'in.obj', '--symmetric', 'X', '--turning', '0:4', '--turning', '1:3', '-o', 'out.obj', '--force'); // prettier-ignore
  assert.equal(code, 5);
});

test('planes are those of the triangles: other vertices do not move them', () => {
  const { vertices, triangles } = shapes.ellipsoid;
  put('in.obj', toObj({ vertices: [...vertices, [9, 0, 0]], triangles }));
  good('param', 'in.obj', '--symmetric', 'X', '-o', 'out.obj', '--force');
  checkMirrored(readers.obj(at('out.obj')));
});

test('options for cones that a symmetric map does not have are refused', () => {
  put('in.obj', toObj(shapes.ellipsoid));
  for (const words of [['--count', '8'], ['--cones-for', 'few'], ['--align']])
    assert.equal(run('param', 'in.obj', '--symmetric', 'X', ...words, '-o', 'no.obj').code, 2);
});
