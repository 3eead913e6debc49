// The light of the 3D view: its nine numbers against the integral that they approximate.

import assert from 'node:assert/strict';
import test from 'node:test';
import { irradiance, radiance } from '../../../web/src/views/studio_light.ts';

const unit = (p) => p.map((x) => x / Math.hypot(...p));

/** What a white matte surface with this normal reflects: the integral of light times cosine, over π. */
function reflected([a, b, c]) {
  const [rows, columns] = [200, 400];
  let sum = 0;
  for (let i = 0; i < rows; i++) {
    const y = -1 + (2 * i + 1) / rows; // rings of equal area
    for (let j = 0; j < columns; j++) {
      const angle = (2 * Math.PI * j) / columns;
      const [x, z] = [Math.cos(angle), Math.sin(angle)].map((t) => t * Math.sqrt(1 - y * y));
      sum += radiance(x, y, z) * Math.max(0, a * x + b * y + c * z);
    }
  }
  return (4 * sum) / (rows * columns);
}

const approximated = ([x, y, z]) =>
  [1, y, z, x, x * y, y * z, 3 * z * z - 1, x * z, x * x - y * y].reduce(
    (sum, term, i) => sum + term * irradiance[i],
    0,
  );

/** The mean of the light over the sphere of directions. */
function mean() {
  const [rows, columns] = [400, 800];
  let sum = 0;
  for (let i = 0; i < rows; i++) {
    const y = -1 + (2 * i + 1) / rows;
    for (let j = 0; j < columns; j++) {
      const angle = (2 * Math.PI * j) / columns;
      const [x, z] = [Math.cos(angle), Math.sin(angle)].map((t) => t * Math.sqrt(1 - y * y));
      sum += radiance(x, y, z);
    }
  }
  return sum / (rows * columns);
}

const normals = [
  ...[-1, 1].flatMap((s) => [0, 1, 2].map((k) => [0, 1, 2].map((i) => (i === k ? s : 0)))),
  ...[0, 1, 2, 3, 4, 5, 6, 7].map((i) => unit([i & 1, (i >> 1) & 1, i >> 2].map((b) => 2 * b - 1))),
];

test('nine numbers give what a matte surface reflects, within 0.03', () => {
  for (const normal of normals) {
    const [seen, wanted] = [approximated(normal), reflected(normal)];
    assert.ok(Math.abs(seen - wanted) < 0.03, `${normal}: ${seen}, not ${wanted}`);
  }
});

test('the first of the nine numbers is the mean of the light', () => {
  assert.ok(Math.abs(irradiance[0] / mean() - 1) < 1e-4, `${irradiance[0]}, ${mean()}`);
});

test('a white surface that faces the lamp is white, and no side is black', () => {
  const seen = normals.map(approximated);
  assert.ok(Math.max(...seen) > 0.85 && Math.max(...seen) < 1.05, `${Math.max(...seen)}`);
  assert.ok(Math.min(...seen) > 0.12, `${Math.min(...seen)}`);
});
