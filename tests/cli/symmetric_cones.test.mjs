// Cones of one's own in symmetric maps: pairs off features and on them are what the map has, as the numbers of both sides say; and
// features of both sides that meet in one triangle.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { inFolder } from '../support/program.mjs';

const { at, put, good, run } = inFolder('symmetric-cones');
const report = () => JSON.parse(readFileSync(at('r.json'), 'utf8'));

const N = 20;
const M = 24;
/** A sphere of rings around Y, symmetric across X. */
function sphere() {
  const vertices = [[0, 1, 0]];
  for (let i = 1; i < M / 2; i++)
    for (let j = 0; j < N; j++) {
      const [a, b] = [(2 * Math.PI * i) / M, (2 * Math.PI * j) / N];
      const near = (x) => (Math.abs(x) < 1e-12 ? 0 : x);
      vertices.push([near(Math.sin(a) * Math.sin(b)), Math.cos(a), Math.sin(a) * Math.cos(b)]);
    }
  vertices.push([0, -1, 0]);
  const id = (i, j) => (i === 0 ? 0 : i === M / 2 ? vertices.length - 1 : 1 + (i - 1) * N + ((j + N) % N)); // prettier-ignore
  const triangles = [];
  for (let i = 0; i < M / 2; i++)
    for (let j = 0; j < N; j++) {
      const [a, b, c, d] = [id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)];
      const isFirst = j < N / 2; // diagonals of the other half are the images
      const cut = isFirst ? [[a, b, c], [a, c, d]] : [[a, b, d], [b, c, d]]; // prettier-ignore
      triangles.push(...cut.filter((t) => new Set(t).size === 3));
    }
  const image = (v) => {
    const [x, y, z] = vertices[v];
    const distance = (w) => Math.hypot(w[0] + x, w[1] - y, w[2] - z);
    return vertices.findIndex((w) => distance(w) < 1e-9);
  };
  return { vertices, triangles, id, image };
}

const { vertices, triangles, id, image } = sphere();
put('in.obj', [...vertices.map((p) => `v ${p.join(' ')}`), ...triangles.map((t) => `f ${t.map((v) => v + 1).join(' ')}`), ''].join('\n')); // prettier-ignore
const equator = Array.from({ length: N }, (_, j) => `${id(M / 4, j)} ${id(M / 4, j + 1)}`);
put('equator.txt', equator.join('\n'));

const conesOf = (cones) => [...cones].flatMap(([v, k]) => ['--cone', `${v}:${k}`]);
const mapWith = (cones, ...more) => run('param', 'in.obj', '--symmetric', 'X', ...conesOf(cones), ...more, '-o', 'out.obj', '--force', '--json', 'r.json'); // prettier-ignore
const ownCones = () => new Map(report().cones.cones.map(({ vertex, k }) => [vertex, k]));
const sorted = (cones) => [...cones].filter(([, k]) => k !== 4).sort(([a], [b]) => a - b);
const add = (cones, v, units) => cones.set(v, (cones.get(v) ?? 4) + units);

for (const features of [[], ['--features', 'equator.txt']])
  test(`cones in pairs, in the plane and on features are those of the map: ${features.length ? 'an equator' : 'no other features'}`, () => {
    assert.equal(mapWith([], ...features).code, 0);
    const own = ownCones();
    assert.equal(mapWith(own, ...features).code, 0, 'the same again');
    const pairs = [
      [id(3, 3), id(8, 6)],
      [id(4, 2), id(9, 7)],
      [id(M / 4, 4), id(8, 3)],
      [id(3, 6), id(M / 4, 5)],
    ];
    for (const pair of pairs) {
      const cones = new Map(own);
      pair.forEach((v, i) => [v, image(v)].forEach((w) => add(cones, w, i === 0 ? -1 : 1)));
      const { code, stderr } = mapWith(cones, ...features);
      assert.equal(code, 0, `${pair}: ${stderr}`);
      assert.deepEqual(sorted(ownCones()), sorted(cones));
    }
    const inPlane = new Map(own);
    add(inPlane, id(2, 0), -2);
    for (const w of [id(5, 4), image(id(5, 4))]) add(inPlane, w, 1);
    const { code, stderr } = mapWith(inPlane, ...features);
    assert.equal(code, 0, stderr);
    assert.deepEqual(sorted(ownCones()), sorted(inPlane));
  });

test('a cone in the plane with an odd k is refused at its place', () => {
  assert.equal(mapWith([]).code, 0);
  const cones = ownCones();
  add(cones, id(2, 0), -1);
  add(cones, id(9, 0), 1);
  const { code } = run('param', 'in.obj', '--symmetric', 'X', ...conesOf(cones), '-o', 'no.obj', '--json', 'r.json'); // prettier-ignore
  assert.equal(code, 2);
  assert.deepEqual(report().where.map((place) => place.id).sort((a, b) => a - b), [id(2, 0), id(9, 0)]); // prettier-ignore
});

test('a triangle between features of both sides is split, and so is its image', () => {
  const t = triangles.find((vs) => vs.every((v) => vertices[v][0] > 0.3));
  const [a, b, c] = t;
  const edges = [[a, b], [image(b), image(c)], [c, a]]; // prettier-ignore
  put('list.txt', edges.map((edge) => edge.join(' ')).join('\n'));
  assert.equal(mapWith([], '--features', 'list.txt').code, 0);
  const { certificate, notes, refined } = report();
  assert.ok(certificate.certified);
  assert.equal(certificate.features.straightEdges, certificate.features.edges);
  assert.ok(notes.some(({ code }) => code === 'features-split'));
  assert.ok(refined);
  good('verify', 'out.obj');
});
