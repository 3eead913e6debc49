// Cones in pairs across a plane, against a model that only knows sets: whatever is done, a set that is its own mirror
// image stays one, and without a plane each cone is alone.

import assert from 'node:assert/strict';
import test from 'node:test';
import { planeOf, withKOfPair, withoutPair, withPair, withPairAt } from '../../../web/src/model/cone_pairs.ts'; // prettier-ignore
import { mirrorImages } from '../../../web/src/services/geometry/mirror_images.ts';
import { randomFrom } from '../../mutation/draw.mjs';
import { cubeMesh } from '../../support/meshes.mjs';

const none = () => -1;
/** Vertices 0 to 8 in the plane, 9 without an image, and the others in pairs: 10 with 11, 12 with 13, … */
const opposite = (v) => (v < 9 ? v : v === 9 ? -1 : v ^ 1);
const sorted = (cones) => cones.map(({ vertex, k }) => `${vertex}:${k}`).toSorted();

/** The pair of a vertex, as a set. */
const orbit = (v, image) => new Set(image(v) < 0 ? [v] : [v, image(v)]);

for (const [name, image] of Object.entries({ 'across a plane': opposite, 'without a plane': none }))
  test(`cones are placed, moved, changed and deleted with those opposite: ${name}`, () => {
    const random = randomFrom(71);
    const below = (n) => Math.floor(n * random());
    const counts = { refused: 0, moved: 0 };
    for (let round = 0; round < 200; round++) {
      let cones = [];
      let known = new Map();
      for (let step = 0; step < 12; step++) {
        const vertex = below(30);
        const k = 1 + below(7);
        const index = below(cones.length);
        const cone = cones[index];
        switch (below(4)) {
          case 0:
            if (known.has(vertex)) break;
            cones = withPair(cones, { vertex, k }, image);
            for (const v of orbit(vertex, image)) known.set(v, k);
            assert.equal(cones.findIndex((one) => one.vertex === vertex), known.size - orbit(vertex, image).size); // prettier-ignore
            break;
          case 1:
            if (!cone) break;
            cones = withKOfPair(cones, index, k, image);
            for (const v of orbit(cone.vertex, image)) known.set(v, k);
            assert.equal(cones[index].vertex, cone.vertex, 'rows stay where they are');
            break;
          case 2:
            if (!cone) break;
            cones = withoutPair(cones, index, image);
            for (const v of orbit(cone.vertex, image)) known.delete(v);
            break;
          default: {
            if (!cone) break;
            const [from, to] = [orbit(cone.vertex, image), orbit(vertex, image)];
            const others = new Map([...known].filter(([v]) => !from.has(v)));
            const isFree = [...to].every((v) => !others.has(v));
            const isInPlane = (v) => image(v) === v;
            const isAlike = isInPlane(cone.vertex) === isInPlane(vertex) && (image(vertex) >= 0 || from.size === 1); // prettier-ignore
            if (from.size === 1 && !isInPlane(cone.vertex) && image !== none) break; // alone: below
            const moved = withPairAt(cones, index, vertex, image);
            assert.equal(moved !== undefined, isFree && isAlike, `${cone.vertex} to ${vertex}`);
            counts[moved ? 'moved' : 'refused'] += 1;
            if (!moved) break;
            assert.equal(moved[index].vertex, vertex);
            cones = moved;
            known = others;
            for (const v of to) known.set(v, cone.k);
          }
        }
        assert.deepEqual(sorted(cones), [...known].map(([v, n]) => `${v}:${n}`).toSorted());
      }
    }
    assert.ok(counts.refused > 5 && counts.moved > 100, JSON.stringify(counts));
  });

test('a cone whose opposite is missing goes alone, and one that is placed does not replace that which is there', () => {
  const lonely = [{ vertex: 10, k: 3, triangle: 4 }];
  assert.deepEqual(withPairAt(lonely, 0, 12, opposite), [{ vertex: 12, k: 3 }]);
  assert.deepEqual(withPairAt(lonely, 0, 11, opposite), [{ vertex: 11, k: 3 }]);
  assert.deepEqual(withKOfPair(lonely, 0, 5, opposite), [{ vertex: 10, k: 5, triangle: 4 }]);
  assert.deepEqual(withoutPair(lonely, 0, opposite), []);
  assert.deepEqual(withPair(lonely, { vertex: 11, k: 5 }, opposite), [...lonely, { vertex: 11, k: 5 }]); // prettier-ignore
  const pair = withPair([], { vertex: 10, k: 3 }, opposite);
  assert.equal(withPairAt(pair, 0, 9, opposite), undefined, 'it has no opposite there');
  assert.deepEqual(withPairAt(pair, 0, 11, opposite), [{ vertex: 11, k: 3 }, { vertex: 10, k: 3 }]); // prettier-ignore
});

test('the plane is the first that no edges cross, otherwise the first', () => {
  const planes = [3, 0, 2, 0].map((edgesAcross, name) => ({ edgesAcross, name }));
  assert.equal(planeOf({ mirrors: planes }), planes[1]);
  assert.equal(planeOf({ mirrors: [planes[0], planes[2]] }), planes[0]);
  assert.deepEqual([planeOf({ mirrors: [] }), planeOf({})], [undefined, undefined]);
});

test('images of vertices are exact across a plane of the surface, and missing where nothing is', () => {
  const { vertices } = cubeMesh(4);
  const shape = (moved) => ({ positions: Float64Array.from(vertices.map(moved).flat()), representative: Int32Array.from(vertices.keys()), diagonal: 2, vertexCount: vertices.length }); // prettier-ignore
  const offset = 0.3;
  const at = ([x, y, z]) => [x, y + offset, z];
  const plane = { normal: [0, 1, 0], offset };
  const same = (p, q) => p.every((x, i) => Math.abs(x - q[i]) < 1e-9);
  const place = shape(at);
  const images = mirrorImages(place, plane, 0);
  vertices.forEach(([x, y, z], v) => {
    assert.ok(same(vertices[images[v]], [x, -y, z]), `${v}`);
    assert.equal(images[images[v]], v);
    assert.equal(images[v] === v, Math.abs(y) < 1e-12);
  });
  // Another one stands for a vertex, or it was removed; another is moved off by less or more than twice the distance.
  const [a, b, c] = [0, 1, 2];
  place.representative[a] = -1;
  place.positions[3 * b] += 1.9e-3;
  place.positions[3 * c] += 2.1e-3;
  const off = mirrorImages(place, plane, 1e-3);
  assert.deepEqual([off[a], off[images[a]]], [-1, -1]);
  assert.deepEqual([off[b], off[images[b]]], [images[b], b]);
  assert.deepEqual([off[c], off[images[c]]], [-1, -1]);
});
