// Quad meshes with faults are certified or refused for what is wrong with them, and what is certified is right. The maps
// are read here, in exact integers, and cut into triangles by nothing of the project's own.
import assert from 'node:assert/strict';
import test from 'node:test';
import { inFolder } from '../support/program.mjs';

const { put, read, run } = inFolder('quad-faults');
const seeds = Number(process.env.HGP_QUAD_FAULTS ?? 64);

function randomNumbers(seed) {
  let state = seed * 7919 + 17;
  const next = () => (state = (state * 48271) % 2147483647) / 2147483647;
  for (let i = 0; i < 8; i++) next();
  return next;
}

const keyOf = (ring) => [...ring].sort((a, b) => a - b).join(' ');
const turned = (ring, by) => ring.map((_, k) => ring[(k + by) % ring.length]);
const between = (a, b, t) => a.map((x, i) => x + t * (b[i] - x));

/** A sheet, a tube or a torus of quads, with vertices moved at random. */
function surface(seed, random) {
  const [wrapsAcross, wrapsAlong] = [seed % 3 > 0, seed % 3 > 1];
  const [m, n] = [7 + (seed % 4), 5 + (seed % 3)];
  const [columns, rows] = [wrapsAcross ? m : m + 1, wrapsAlong ? n : n + 1];
  const noise = () => 0.12 * (random() - 0.5);
  const positions = [];
  for (let j = 0; j < rows; j++)
    for (let i = 0; i < columns; i++) {
      const [a, b] = [(2 * Math.PI * i) / m, (2 * Math.PI * j) / n];
      const r = 2 + 0.8 * Math.cos(b);
      const p = wrapsAlong
        ? [r * Math.cos(a), r * Math.sin(a), 0.8 * Math.sin(b)]
        : wrapsAcross
          ? [Math.cos(a), Math.sin(a), 0.6 * j]
          : [0.5 * i, 0.5 * j, 0.2 * Math.sin(i + j)];
      positions.push(p.map((x) => x + noise()));
    }
  const id = (i, j) => (j % rows) * columns + (i % columns);
  const rings = [];
  for (let j = 0; j < n; j++)
    for (let i = 0; i < m; i++)
      rings.push([id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)]);
  return { positions, rings };
}

/** Faults by name: each changes the mesh at quad `at`. */
const faults = {
  doublet({ positions, rings }, at, random) {
    const [a, b, c, d] = turned(rings[at], Math.floor(4 * random()));
    const x = positions.push(between(positions[a], positions[c], 0.3 + 0.4 * random())) - 1;
    rings[at] = [a, b, c, x];
    rings.push([a, x, c, d]);
  },
  fin({ positions, rings }, at, random) {
    const [a, b] = turned(rings[at], Math.floor(4 * random()));
    if (rings.filter((ring) => ring.includes(a) && ring.includes(b)).length < 2) return;
    const lift = 0.4 + 0.3 * random();
    const far = [b, a].map((v) => positions.push(positions[v].map((x) => x * 1.1 + lift)) - 1);
    rings.push([a, b, ...far]);
  },
  folded({ positions, rings }, at, random) {
    const [a, , c] = turned(rings[at], Math.floor(4 * random()));
    positions[a] = between(positions[a], positions[c], 1.1 + 0.4 * random());
  },
  repeated({ rings, copied }, at, random) {
    const copy = turned(rings[at], Math.floor(4 * random()));
    copied.add(keyOf(copy));
    rings.push(random() < 0.5 ? copy : copy.reverse());
  },
};

function meshOf(seed) {
  const random = randomNumbers(seed);
  const mesh = { ...surface(seed, random), copied: new Set() };
  const names = Object.keys(faults);
  const [first, second] = [seed % names.length, Math.floor(seed / names.length) % names.length];
  const free = mesh.rings.map((_, at) => at);
  for (const name of new Set([names[first], names[second]]))
    for (let count = 1 + Math.floor(3 * random()); count > 0; count--) {
      const [at] = free.splice(Math.floor(free.length * random()), 1);
      faults[name](mesh, at, random);
    }
  return { ...mesh, names: [...new Set([names[first], names[second]])] };
}

const toObj = ({ positions, rings }) =>
  [
    ...positions.map((p) => `v ${p.join(' ')}`),
    ...rings.map((ring) => `f ${ring.map((v) => v + 1).join(' ')}`),
    '',
  ].join('\n');

/** The polygons of an OBJ: ids of vertices, and uv as float64 and as integers in units of 2^-1000, which are exact. */
function readPolygons(text) {
  const uv = [];
  const polygons = [];
  for (const line of text.split('\n')) {
    const [word, ...rest] = line.trim().split(/\s+/);
    if (word === 'vt') uv.push(rest.slice(0, 2).map(Number));
    if (word !== 'f') continue;
    const corners = rest.map((corner) => corner.split('/').map((x) => Number(x) - 1));
    const points = corners.map((c) => uv[c[1]]);
    const whole = points.map((p) => p.map((x) => BigInt(x * 2 ** 1000)));
    polygons.push({ ring: corners.map((c) => c[0]), points, whole });
  }
  return polygons;
}

function isPositive(whole, ...corners) {
  const [a, b, c] = corners.map((k) => whole[k]);
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0n;
}

function diagonalsOf({ whole }) {
  const has = (a, b, c) => isPositive(whole, a, b, c);
  return [has(0, 1, 2) && has(0, 2, 3), has(0, 1, 3) && has(1, 2, 3)];
}

/** The angle of a corner of a polygon that is positive along a diagonal, between 0 and 2π. */
function angleAt({ points }, k) {
  const [from, p, to] = [points[(k + 3) % 4], points[k], points[(k + 1) % 4]];
  const [a, b] = [to, from].map((x) => [x[0] - p[0], x[1] - p[1]]);
  const angle = Math.atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
  return angle > 0 ? angle : angle + 2 * Math.PI;
}

/** Whether b is a turned by a multiple of 90°, to 1e-6 of its length. */
const isTurned = (a, b) =>
  [[a[0], a[1]], [-a[1], a[0]], [-a[0], -a[1]], [a[1], -a[0]]] // prettier-ignore
    .some((c) => Math.hypot(c[0] - b[0], c[1] - b[1]) <= 1e-6 * Math.hypot(...a));

/** Sides of polygons by their ends in order of ids. */
function sidesOf(polygons) {
  const sides = new Map();
  for (const polygon of polygons)
    polygon.ring.forEach((a, k) => {
      const b = polygon.ring[(k + 1) % 4];
      const [p, q] = [polygon.points[k], polygon.points[(k + 1) % 4]];
      const edge = a < b ? [q[0] - p[0], q[1] - p[1]] : [p[0] - q[0], p[1] - q[1]];
      const key = Math.min(a, b) + ' ' + Math.max(a, b);
      sides.set(key, [...(sides.get(key) ?? []), { edge, isUp: a < b }]);
    });
  return sides;
}

/** Vertices that have one fan of faces all around them. */
function innerVertices(polygons, sides) {
  const around = new Map();
  for (const { ring } of polygons)
    ring.forEach((v, k) => {
      const list = around.get(v) ?? [];
      list.push([ring[(k + 1) % 4], ring[(k + 3) % 4]]);
      around.set(v, list);
    });
  const isWhole = ([v, pairs]) => {
    const next = new Map(pairs);
    const manifold = pairs.every(([to]) => {
      const both = sides.get(Math.min(v, to) + ' ' + Math.max(v, to));
      return both.length === 2 && both[0].isUp !== both[1].isUp;
    });
    if (!manifold || next.size !== pairs.length) return false;
    let [steps, at] = [0, pairs[0][0]];
    do {
      at = next.get(at);
      steps++;
    } while (at !== undefined && at !== pairs[0][0] && steps <= pairs.length);
    return at === pairs[0][0] && steps === pairs.length;
  };
  return new Set([...around].filter(isWhole).map(([v]) => v));
}

/** What is certified holds: positive quads, no uv of another quad, seams turned by 90°, and the angles that are said. */
function assertRight(name, certificate, mesh) {
  const all = readPolygons(read(`${name}.obj`));
  assert.equal(all.length, mesh.rings.length, name);
  const seen = new Map();
  const polygons = [];
  all.forEach((polygon, at) => {
    assert.deepEqual(polygon.ring, mesh.rings[at], `${name}: quad ${at} has other vertices`);
    const key = keyOf(polygon.ring);
    const first = seen.get(key);
    if (!first || sameCycle(first.ring, polygon.ring) === 0) {
      seen.set(key, polygon);
      polygons.push(polygon);
    } else
      polygon.ring.forEach((v, k) =>
        assert.deepEqual(polygon.points[k], first.points[first.ring.indexOf(v)], `${name}: ${at}`),
      );
  });
  const { stored } = certificate;
  assert.equal(stored.verified, 2 * polygons.length, `${name}: verified triangles`);
  assert.equal(stored.duplicates, 2 * (all.length - polygons.length), `${name}: copies`);
  assert.equal(stored.differing, 0, name);
  const ways = polygons.map(diagonalsOf);
  ways.forEach((way, at) => assert.ok(way.includes(true), `${name}: quad ${at} is not positive`));
  const notConvex = ways.filter((way) => way.includes(false)).length;
  assert.equal(stored.notConvex, notConvex, `${name}: quads that are not convex`);
  const sides = sidesOf(polygons);
  for (const [key, both] of sides)
    if (both.length === 2)
      assert.ok(isTurned(both[0].edge, both[1].edge), `${name}: edge ${key} is no seam`);
  const cones = new Map(
    certificate.components.flatMap((part) => part.cones.map((c) => [c.vertex, c.measured])),
  );
  const sums = new Map();
  for (const polygon of polygons)
    polygon.ring.forEach((v, k) => sums.set(v, (sums.get(v) ?? 0) + angleAt(polygon, k)));
  const inner = innerVertices(polygons, sides);
  for (const v of inner) {
    const wanted = ((cones.get(v) ?? 4) * Math.PI) / 2;
    assert.ok(Math.abs(sums.get(v) - wanted) < 1e-5, `${name}: ${sums.get(v)} around vertex ${v}`);
  }
  const bent = polygons.filter((_, at) => ways[at].includes(false)).map((one) => all.indexOf(one));
  return {
    quads: polygons.length,
    copies: all.length - polygons.length,
    notConvex,
    bent: new Set(bent),
    inner: inner.size,
  };
}

/** 1 if the second ring is the first from another corner, −1 if it is that turned over, otherwise 0. */
function sameCycle(a, b) {
  const from = b.indexOf(a[0]);
  if (from < 0) return 0;
  if (turned(b, from).every((v, k) => v === a[k])) return 1;
  const back = [...b].reverse();
  return turned(back, back.indexOf(a[0])).every((v, k) => v === a[k]) ? -1 : 0;
}

/** The map of a mesh, written even if it is not certified, and its report. */
function solve(name, file, ...words) {
  const { code, err } = run(
    ['param', file, '-o', `${name}.obj`, '--json', `${name}.json`],
    ['--allow-uncertified', ...words],
  );
  assert.ok(code === 0 || code === 6, `${name}: ${err}`);
  const { certified, certificate } = JSON.parse(read(`${name}.json`));
  assert.equal(certified, code === 0, name);
  return certificate;
}

/** The only rule that is broken is that every quad is convex, and the quads that are named and counted break it. */
function assertOnlyNotConvex(name, certificate, found) {
  const reasons = certificate.components.flatMap((part) => part.reasons);
  assert.deepEqual([...new Set(reasons.map((reason) => reason.rule))], ['orientation'], name);
  for (const { message, where } of reasons) {
    assert.match(message, /not convex in the map, and convex polygons were asked for/);
    for (const { id } of where) assert.ok(found.bent.has(Math.floor(id / 2)), `${name}: ${id}`);
  }
  const count = reasons.reduce((sum, reason) => sum + reason.count, 0);
  assert.equal(count, found.notConvex, name);
}

/** Edges of quads with more than two faces, and those with two that go the same way. */
function badEdges({ rings }) {
  const sides = sidesOf(rings.map((ring) => ({ ring, points: ring.map(() => [0, 0]) })));
  const crowded = [...sides].filter(([, both]) => both.length > 2);
  const twisted = [...sides].filter(
    ([, both]) => both.length === 2 && both[0].isUp === both[1].isUp,
  );
  return { crowded: new Set(crowded.map(([key]) => key)), twisted: twisted.length };
}

/** Without repairs: refused for exactly the faults that the mesh has, at places where it has them. */
function assertRefused(name, file, mesh) {
  const { code, err } = run('param', file, '--strict', '-o', 'strict.obj', '--json', 'strict.json');
  const { crowded, twisted } = badEdges(mesh);
  const wanted = [];
  if (mesh.copied.size > 0) wanted.push('degenerate');
  if (crowded.size + mesh.copied.size > 0) wanted.push('split');
  if (twisted > 0) wanted.push('orient');
  if (wanted.length === 0) return assert.equal(code, 0, `${name}: ${err}`);
  assert.equal(code, 4, `${name}: ${err}`);
  const { advice, where } = JSON.parse(read('strict.json'));
  assert.equal(advice[0].words.fixes, wanted.join(','), name);
  for (const { kind, id, other } of where) {
    const quad = mesh.rings[Math.floor(id / 2)];
    if (kind === 'triangle') assert.ok(mesh.copied.has(keyOf(quad)), `${name}: triangle ${id}`);
    const isDiagonal = mesh.rings.some(
      (ring) => mesh.copied.has(keyOf(ring)) && ring.includes(id) && ring.includes(other),
    );
    const key = `${Math.min(id, other)} ${Math.max(id, other)}`;
    if (kind === 'edge' && twisted === 0)
      assert.ok(isDiagonal || crowded.has(key), `${name}: edge ${key}`);
  }
  return undefined;
}

test('quad meshes with doublets, fins, folds and copies: what is certified is right, what is refused is named', () => {
  const total = { quads: 0, copies: 0, notConvex: 0, inner: 0 };
  const certified = [0, 0];
  for (let seed = 0; seed < seeds; seed++) {
    const mesh = meshOf(seed);
    const what = `${seed} ${mesh.names.join(' ')}`;
    const file = put(`${seed}.obj`, toObj(mesh));
    for (const [mode, words] of [[], ['--convex-polygons']].entries()) {
      const certificate = solve(`out ${what}`, file, ...words);
      // A map that is only refused for quads that are not convex is right otherwise, and held to that.
      const found = assertRight(`out ${what}`, certificate, mesh);
      if (mode === 0) assert.ok(certificate.certified, what);
      else if (certificate.certified) assert.equal(found.notConvex, 0, what);
      else assertOnlyNotConvex(what, certificate, found);
      certified[mode] += Number(certificate.certified);
      for (const key of Object.keys(total)) total[key] += found[key];
    }
    assertRefused(what, file, mesh);
  }
  console.log(`${certified[0]} of ${seeds} certified, ${certified[1]} with convex quads`, total);
  assert.ok(certified[1] > seeds / 4, 'too few are certified with convex quads to test them');
  for (const [key, count] of Object.entries(total)) assert.ok(count > seeds, key);
});

test('the reading above finds a vertex out of its place, the uv of another quad, and a wrong count', () => {
  const mesh = surface(1, randomNumbers(1));
  mesh.rings.push([...mesh.rings[20]]);
  const certificate = solve('whole', put('whole-in.obj', toObj(mesh)));
  const text = read('whole.obj');
  assertRight('whole', certificate, mesh);
  const lines = text.split('\n');
  const rows = lines.flatMap((line, at) => (line.startsWith('f ') ? [at] : []));
  const withUv = (at, uvs) => {
    const corners = lines[rows[at]].slice(2).split(' ');
    const row = corners.map((corner, k) => `${corner.split('/')[0]}/${uvs[k]}`);
    return lines.map((line, n) => (n === rows[at] ? `f ${row.join(' ')}` : line)).join('\n');
  };
  const uvsOf = (at) => lines[rows[at]].slice(2).split(' ').map((corner) => corner.split('/')[1]); // prettier-ignore
  const vt = lines.flatMap((line, at) => (line.startsWith('vt ') ? [at] : []));
  const moved = vt[Number(uvsOf(20)[2]) - 1];
  const [, u, v] = lines[moved].split(' ').map(Number);
  const faulty = {
    'is not positive': lines.map((line, n) => (n === moved ? `vt ${u - 3} ${v - 3}` : line)).join('\n'), // prettier-ignore
    'is no seam': withUv(10, uvsOf(11)),
    'whole: ': withUv(mesh.rings.length - 1, uvsOf(3)),
  };
  for (const [words, changed] of Object.entries(faulty)) {
    put('whole.obj', changed);
    assert.throws(() => assertRight('whole', certificate, mesh), new RegExp(words), words);
  }
  put('whole.obj', text);
  certificate.stored.notConvex += 1;
  assert.throws(() => assertRight('whole', certificate, mesh), /not convex/);
});
