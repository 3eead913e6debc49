// What is nearest, against plain searches: the side of a triangle under a pointer; and the ball around points.

import assert from 'node:assert/strict';
import test from 'node:test';
import { BufferAttribute, InterleavedBuffer, InterleavedBufferAttribute } from 'three';
import { ballAround } from '../../../web/src/views/ball.ts';
import { edgeUnder } from '../../../web/src/views/nearest_side.ts';
import { randomFrom } from '../../mutation/draw.mjs';

test('the edge under a pointer is the nearest side of the triangle in front, wherever its corners are on the screen', () => {
  const random = randomFrom(3);
  const surface = { triangles: Uint32Array.of(9, 8, 7, 2, 0, 1, 3, 4, 5) };
  const box = { left: 31, top: 17 };
  /** From a pointer to a side, by looking at many of its points. */
  const farFrom = (pointer, a, b) => {
    let least = Infinity;
    for (let i = 0; i <= 400; i++) {
      const [x, y] = ['x', 'y'].map((k) => a[k] + (i / 400) * (b[k] - a[k]));
      least = Math.min(least, Math.hypot(pointer.x - x, pointer.y - y));
    }
    return least;
  };
  for (let round = 0; round < 400; round++) {
    const some = () => ({ x: 200 * random(), y: 200 * random() });
    const places = Array.from({ length: 10 }, some);
    if (round % 8 === 0) places[0] = places[2]; // two corners at one place of the screen
    const pointer = some();
    const triangle = round % 3;
    const view = { pick: () => ({ triangle }), toScreen: (v) => places[v], canvas: { getBoundingClientRect: () => box } }; // prettier-ignore
    const found = edgeUnder(view, surface, { clientX: pointer.x + box.left, clientY: pointer.y + box.top }); // prettier-ignore
    const [a, b, c] = surface.triangles.subarray(3 * triangle, 3 * triangle + 3);
    const sides = [[a, b], [b, c], [c, a]]; // prettier-ignore
    const is = sides.findIndex(([v, w]) => v === found[0] && w === found[1]);
    assert.ok(is >= 0, `${found} is no side`);
    const far = sides.map(([v, w]) => farFrom(pointer, places[v], places[w]));
    assert.ok(far[is] <= Math.min(...far) + 1, `${far}, not ${is}`);
  }
  const nothing = { pick: () => undefined, toScreen: assert.fail, canvas: { getBoundingClientRect: () => box } }; // prettier-ignore
  assert.equal(edgeUnder(nothing, surface, { clientX: 1, clientY: 1 }), undefined);
});

test('the ball around points is that of their box; where a number is not finite, or there are none, it is empty', () => {
  const random = randomFrom(7);
  for (let round = 0; round < 60; round++) {
    const count = Math.floor(12 * random());
    const values = Float32Array.from({ length: 3 * count }, () => 100 * random() - 50);
    const odd = round % 4 === 3 && count > 0;
    if (odd) values[Math.floor(3 * count * random())] = [NaN, Infinity, -Infinity][round % 3];
    const mixed = new Float32Array(5 * count);
    for (let i = 0; i < count; i++) mixed.set(values.subarray(3 * i, 3 * i + 3), 5 * i + 1);
    for (const points of [
      new BufferAttribute(values, 3),
      new InterleavedBufferAttribute(new InterleavedBuffer(mixed, 5), 3, 1),
    ]) {
      // prettier-ignore
      const ball = ballAround(points);
      if (odd || count === 0) {
        assert.deepEqual([ball.center.toArray(), ball.radius], [[0, 0, 0], -1]);
        continue;
      }
      const ends = [0, 1, 2].map((k) => values.filter((_, i) => i % 3 === k)).map((some) => [Math.min(...some), Math.max(...some)]); // prettier-ignore
      ball.center.toArray().forEach((x, k) => assert.ok(Math.abs(x - (ends[k][0] + ends[k][1]) / 2) < 1e-4)); // prettier-ignore
      assert.ok(Math.abs(ball.radius - Math.hypot(...ends.map(([low, high]) => high - low)) / 2) < 1e-4); // prettier-ignore
    }
  }
});
