// Edges that lines follow, as the page chooses them: chains up to the next corner, runs, and the command for them.

import assert from 'node:assert/strict';
import test from 'node:test';
import { Quaternion, Vector3 } from 'three';
import { keepFeatures } from '../../../web/src/actions/keep_features.ts';
import {
  countRuns,
  EdgeMap,
  featuresText,
  hasEdges,
  hasFeatures,
  noFeatures,
  sameFeatures,
  toFeatures,
  withChain,
} from '../../../web/src/model/features.ts';
import { cliCommand } from '../../../web/src/text/cli_command.ts';
import { randomFrom } from '../../mutation/draw.mjs';
import { flatSquare } from '../shapes.mjs';

const surfaceOf = ({ vertices, triangles }) => ({
  places: Float64Array.from(vertices.flat()),
  triangles: Uint32Array.from(triangles.flat()),
});
const n = 4;
/** A box of n × n squares a side. */
function box() {
  const [vertices, triangles, ids] = [[], [], new Map()];
  const id = (p) => {
    const key = p.join();
    if (!ids.has(key)) ids.set(key, vertices.push(p) - 1);
    return ids.get(key);
  };
  for (let axis = 0; axis < 3; axis++)
    for (const side of [0, n])
      for (let i = 0; i < n; i++)
        for (let j = 0; j < n; j++) {
          const corner = (u, v) => {
            const p = [0, 0, 0];
            [p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3]] = [side, u, v];
            return id(p);
          };
          const [a, b, c, d] = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)]; // prettier-ignore
          triangles.push(...(side ? [[a, b, c], [a, c, d]] : [[a, c, b], [a, d, c]])); // prettier-ignore
        }
  return { vertices, triangles };
}
const cube = surfaceOf(box());
const at = (...p) => [...Array(cube.places.length / 3).keys()].find((v) => p.every((x, i) => cube.places[3 * v + i] === x)); // prettier-ignore

test('a chain goes on to the corners of a cube, from whichever of its edges', () => {
  const map = new EdgeMap(cube);
  const row = [...Array(n + 1).keys()].map((i) => at(i, 0, 0));
  const keys = (chain) => chain.map((edge) => [...edge].sort((a, b) => a - b).join(' ')).sort();
  const all = keys(row.slice(1).map((v, i) => [row[i], v]));
  for (let i = 0; i < n; i++) {
    assert.deepEqual(keys(map.chainThrough([row[i], row[i + 1]])), all);
    assert.deepEqual(keys(map.chainThrough([row[i + 1], row[i]])), all);
  }
  // An edge within a side is chosen alone.
  const inside = [at(1, 1, 0), at(2, 1, 0)];
  assert.deepEqual(map.chainThrough(inside), [inside]);
  assert.deepEqual(map.rims(), []);
});

test('the rim of a square is known, and a chain on it ends at the corners', () => {
  const square = surfaceOf(flatSquare(n));
  const map = new EdgeMap(square);
  const rims = map.rims();
  assert.equal(rims.length, 4 * n);
  assert.equal(countRuns(rims), 1);
  assert.equal(map.chainThrough(rims[0]).length, n);
});

/** Places in space, turned and moved at random. */
function turnedAtRandom(random) {
  const turn = new Quaternion(...[0, 1, 2, 3].map(() => random() - 0.5)).normalize();
  const move = new Vector3(...[0, 1, 2].map(() => 5 * random()));
  return (p) => new Vector3(...p).applyQuaternion(turn).add(move).toArray();
}

test('an edge is sharp if the surface bends there by more than 18 degrees, up or down, however it lies and is wound', () => {
  const random = randomFrom(3);
  for (const degrees of [0, 1, 10, 17.9, 18.1, 30, 89, 120, 179])
    for (let round = 0; round < 12; round++) {
      const bend = ((round % 2 ? degrees : -degrees) * Math.PI) / 180;
      const place = turnedAtRandom(random);
      const [far, other] = [0.2 + 3 * random(), 0.2 + 3 * random()];
      const vertices = [[0, 0, 0], [0, 2 + random(), 0], [-far, random(), 0], [other * Math.cos(bend), random(), other * Math.sin(bend)]].map(place); // prettier-ignore
      // Each triangle begins at any of its corners; both are wound in the one way or the other.
      const begun = (triangle) => { const k = Math.floor(3 * random()); return [...triangle.slice(k), ...triangle.slice(0, k)]; }; // prettier-ignore
      const triangles = [[0, 1, 2], [1, 0, 3]].map((one) => begun(round % 4 < 2 ? one : one.toReversed())); // prettier-ignore
      const map = new EdgeMap(surfaceOf({ vertices, triangles }));
      for (const edge of [[0, 1], [1, 0]]) assert.equal(map.isSharp(edge), degrees > 18, `${degrees} of ${round}`); // prettier-ignore
      for (const edge of [[0, 2], [1, 3], [2, 3]]) assert.equal(map.isSharp(edge), false, 'a rim, and no edge'); // prettier-ignore
    }
});

test('a chain goes on along a rim up to where it turns by more than 40 degrees, in both directions', () => {
  const random = randomFrom(5);
  for (let round = 0; round < 60; round++) {
    const turns = [];
    for (let left = 360; left > 0;) {
      const one = Math.min(left, [5, 20, 39.5, 40.5, 60][Math.floor(5 * random())]);
      turns.push(one);
      left -= one;
    }
    if (turns.length < 4) continue;
    // A polygon around a circle, which its sides touch; side k ends at corner k, where it turns.
    const count = turns.length;
    let angle = 0;
    const around = turns.map((turn) => {
      const half = (turn * Math.PI) / 360;
      const at = (angle * Math.PI) / 180 + half;
      angle += turn;
      return [Math.cos(at) / Math.cos(half), Math.sin(at) / Math.cos(half), 0];
    });
    const vertices = [...around, [0, 0, 0]].map(turnedAtRandom(random));
    const triangles = around.map((_, k) => [(k + count - 1) % count, k, count]);
    const map = new EdgeMap(surfaceOf({ vertices, triangles }));
    const nameOf = ([a, b]) => `${Math.min(a, b)} ${Math.max(a, b)}`;
    const side = (k) => [(k + count - 1) % count, k % count];
    for (let k = 0; k < count; k++) {
      const expected = new Set([nameOf(side(k))]);
      for (let at = k; turns[at % count] <= 40 && at < k + count; at++) expected.add(nameOf(side(at + 1))); // prettier-ignore
      for (let at = k + count; turns[(at - 1) % count] <= 40 && at > k; at--) expected.add(nameOf(side(at - 1))); // prettier-ignore
      for (const picked of [side(k), side(k).toReversed()]) {
        const chain = map.chainThrough(picked).map(nameOf);
        assert.deepEqual([new Set(chain), chain.length], [expected, expected.size]);
      }
    }
  }
});

test('chosen chains are added once and taken out again', () => {
  const chain = [[0, 1], [2, 1]]; // prettier-ignore
  const once = withChain(noFeatures, chain, false);
  const twice = withChain(once, [[1, 0]], false);
  assert.equal(twice.edges.length, 2);
  assert.ok(sameFeatures(once, twice));
  assert.ok(sameFeatures(noFeatures, undefined));
  const none = withChain(twice, chain, true);
  assert.ok(sameFeatures(none, undefined));
  assert.ok(!sameFeatures(once, { ...once, hasRims: true }));
  assert.deepEqual(toFeatures(once), { rims: false, lines: [{ vertices: [0, 1] }, { vertices: [2, 1] }] }); // prettier-ignore
});

test('runs are counted between crossings', () => {
  assert.equal(countRuns([]), 0);
  assert.equal(countRuns([[0, 1], [1, 2], [2, 0]]), 1); // prettier-ignore
  assert.equal(countRuns([[0, 1], [0, 2], [0, 3]]), 3); // prettier-ignore
  const choice = { ...noFeatures, edges: [[0, 1], [1, 2], [5, 6]] }; // prettier-ignore
  assert.equal(featuresText(choice, 0), 'lines follow 2 creases');
  assert.equal(featuresText(choice, 1), 'lines follow 2 creases and 1 rim');
  assert.equal(featuresText({ ...noFeatures, hasRims: true }, 2), 'lines follow 2 rims');
  const mirrored = { ...noFeatures, isSymmetric: true };
  assert.equal(featuresText(mirrored, 0), 'lines follow the plane of symmetry');
  assert.equal(featuresText(mirrored, 1), 'lines follow 1 rim and the plane of symmetry');
  assert.equal(featuresText({ ...choice, isSymmetric: true }, 1), 'lines follow 2 creases, 1 rim and the plane of symmetry'); // prettier-ignore
});

test('the command has features instead of cones', () => {
  const model = { main: 'part.obj', loaded: { fix: {}, hasAllRepairs: true }, info: { surface: 0, surfaces: [{}], components: [{}], file: { format: 'obj' } } }; // prettier-ignore
  const prescription = { q: 4, cones: [{ vertex: 3, k: 3 }], turnings: [], handles: [] };
  const features = { ...noFeatures, hasRims: true, edges: [[0, 1]] };
  const options = { rounds: 12, scale: 'solved', gridMode: 'tile', features };
  const command = cliCommand(model, prescription, options, { embedCones: true });
  assert.match(command, / --rims --features part\.features\.json /);
  assert.doesNotMatch(command, /--cone/);
  const mirrored = { ...noFeatures, isSymmetric: true };
  const other = cliCommand(model, prescription, { ...options, features: mirrored }, { embedCones: true }); // prettier-ignore
  assert.match(other, / --symmetric=auto /);
  assert.doesNotMatch(other, /--cone|--rims|--features/);
  assert.ok(hasFeatures(mirrored) && !hasEdges(mirrored) && !hasFeatures(noFeatures));
});

test('after a weld, edges are named by the vertices that stand for theirs; a seam that is closed is no rim', () => {
  // Two squares of two triangles, side by side, that share no vertex: 1 and 4, and 2 and 7, are at the same place.
  const places = Float64Array.from([0,0,0, 1,0,0, 1,1,0, 0,1,0, 1,0,0, 2,0,0, 2,1,0, 1,1,0]); // prettier-ignore
  const triangles = Uint32Array.from([0,1,2, 0,2,3, 4,5,6, 4,6,7]); // prettier-ignore
  const apart = new EdgeMap({ places, triangles });
  assert.ok(apart.isRim([4, 7]));
  const joined = new EdgeMap({ places, triangles, representative: Int32Array.of(0, 1, 2, 3, 1, 5, 6, 2) }); // prettier-ignore
  assert.equal(joined.isRim([4, 7]), false);
  assert.equal(joined.rims().length, 6);
  assert.deepEqual(joined.chainThrough([4, 7]), [[1, 2]]);
  const choice = { ...noFeatures, hasRims: true, edges: [[0, 2], [7, 4], [0, 6], [0, 1]] }; // prettier-ignore
  const kept = joined.kept(choice);
  assert.deepEqual(kept.edges, [[0, 2], [2, 1]]); // prettier-ignore
  assert.equal(kept.rims.length, 6);
  assert.equal(kept.hasRims, true);
  // A vertex that a repair removed has no edges; of a closed surface there are no rims.
  const less = new EdgeMap({ places, triangles, representative: Int32Array.of(0, -1, 2, 3, 4, 5, 6, 7) }); // prettier-ignore
  assert.deepEqual(
    less.kept(choice).edges,
    [[7, 4]].filter(() => false),
  );
  assert.equal(new EdgeMap(cube).kept(choice).hasRims, false);
});

test('what a repair takes away of the edges that lines follow is said', () => {
  const places = Float64Array.from([0,0,0, 1,0,0, 1,1,0, 0,1,0]); // prettier-ignore
  const surface = { places, triangles: Uint32Array.of(0, 1, 2, 0, 2, 3) };
  const app = { doc: { usableModel: { surface } } };
  assert.equal(keepFeatures(app, undefined), '');
  assert.equal(keepFeatures(app, { ...noFeatures, edges: [[0, 2]] }), '');
  assert.deepEqual(app.doc.features.edges, [[0, 2]]);
  const edges = [[0, 2], [1, 3], [5, 6]]; // prettier-ignore
  assert.match(keepFeatures(app, { ...noFeatures, edges }), /^ 2 of 3 edges that lines follow are gone\.$/); // prettier-ignore
  assert.deepEqual(app.doc.features.edges, [[0, 2]]);
  app.doc.usableModel = { surface: cube };
  assert.match(keepFeatures(app, { ...noFeatures, hasRims: true }), /no rim any more/);
  assert.equal(app.doc.features, undefined);
});
