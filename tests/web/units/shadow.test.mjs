// The shadow under a model: darkest where it stands, none beside it, and only of what is low.

import assert from 'node:assert/strict';
import test from 'node:test';
import { groundShadow, shadowCells } from '../../../web/src/services/geometry/shadow_map.ts';

/** Points of a horizontal square of half side `half` at height y. */
function plate(y, half, [cx, cz] = [0, 0]) {
  const points = [];
  for (let i = -20; i <= 20; i++)
    for (let j = -20; j <= 20; j++) points.push(cx + (half * i) / 20, y, cz + (half * j) / 20);
  return points;
}

const at = ({ dark, x, z, side }, px, pz) => {
  const [i, j] = [px - x, pz - z].map((d) => Math.floor((d / side + 0.5) * shadowCells));
  return dark[j * shadowCells + i];
};

test('a plate on the ground is dark below its middle, lighter at its edge, and not far outside', () => {
  const shadow = groundShadow(plate(2, 1));
  assert.deepEqual([shadow.x, shadow.y, shadow.z], [0, 2, 0]);
  assert.ok(at(shadow, 0, 0) > 0.95);
  assert.ok(at(shadow, 1, 0) > 0.3 && at(shadow, 1, 0) < 0.9);
  assert.ok(at(shadow, 1.5, 0) < 0.01);
  assert.ok(Math.max(...shadow.dark) <= 1 && Math.min(...shadow.dark) >= 0);
});

test('what is higher is lighter, and from a third of the size on has no shadow', () => {
  const feet = plate(0, 0.5, [-2, 0]);
  const shadow = groundShadow([...feet, ...plate(0.4, 0.5, [0, 0]), ...plate(3, 0.5, [2, 0])]);
  assert.ok(at(shadow, -2, 0) > at(shadow, 0, 0));
  assert.ok(at(shadow, 0, 0) > 0.2);
  assert.ok(at(shadow, 2, 0) < 0.01);
});

test('a point, and nothing, have no shadow; numbers that are not finite are passed over', () => {
  assert.equal(groundShadow([1, 2, 3]), undefined);
  assert.equal(groundShadow([]), undefined);
  assert.ok(groundShadow([...plate(0, 1), NaN, Infinity, NaN]).side < 4);
});

test('between few points the ground is dark for some cells around each; of very many points only some are looked at', () => {
  const few = groundShadow([[-1, -1], [-1, 1], [1, -1], [1, 1], [0, 0]].flatMap(([x, z]) => [x, 0, z])); // prettier-ignore
  const cell = few.side / shadowCells;
  // Four cells, and three for each of three rounds of blurring.
  for (let n = 1; n < 20; n++) assert.equal(at(few, (n + 0.5) * cell, 0.5 * cell) > 0, n <= 4 + 9, `${n} cells away`);
  const many = Array.from({ length: 50_000 }, (_, i) => [Math.cos(i), (i % 7) / 70, Math.sin(i)]);
  const others = many.map(() => [0, 0, 0]);
  const mixed = many.flatMap((point, i) => [point, others[i]]);
  assert.deepEqual(groundShadow(mixed.flat()), groundShadow(many.flat()));
  const less = mixed.slice(0, 60_000).flat();
  assert.notDeepEqual(groundShadow(less), groundShadow(many.slice(0, 30_000).flat()), 'up to 60 000 all'); // prettier-ignore
}); // prettier-ignore
