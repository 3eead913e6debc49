// The plane of symmetry is found from the shape, wherever it is; vertices have their counterparts; and shapes without a plane
// have none. Corners near a pointer are found, and a flat or round place has none.

import assert from 'node:assert/strict';
import test from 'node:test';
import { cornerNear } from '../../../web/src/model/snapping.ts';
import { Mirror } from '../../../web/src/services/geometry/mirror_plane.ts';
import { locatedSurface } from '../../../web/src/services/geometry/placed_surface.ts';
import { largestAxis } from '../../../web/src/services/geometry/symmetric_matrix.ts';
import { cubeMesh } from '../../support/meshes.mjs';
import { hornedBox } from '../shapes.mjs';
import { plainFacts } from './plain_facts.mjs';

function surfaceOf(mesh) {
  const arrays = {
    positions: Float64Array.from(mesh.vertices.flat()),
    triangles: Uint32Array.from(mesh.triangles.flat()),
  };
  return { id: 1, ...locatedSurface(arrays, plainFacts(mesh)) };
}

for (const [turn, shift] of [
  [0, 0],
  [0.4, 5],
  [0.7, 0.3],
  [1.1, -3],
]) {
  test(`a shape turned by ${turn} is its own image in one plane, in which every vertex has its counterpart`, () => {
    const { mesh, normal } = hornedBox(turn, shift);
    const mirror = new Mirror(surfaceOf(mesh));
    assert.ok(mirror.plane);
    const cosine = mirror.plane.normal.reduce((sum, x, i) => sum + x * normal[i], 0);
    assert.ok(Math.abs(cosine) > 0.999, `${mirror.plane.normal}`);
    const { offset } = mirror.plane;
    const { diagonal } = surfaceOf(mesh);
    const distance = (p) => Math.abs(p.reduce((sum, x, i) => sum + x * mirror.plane.normal[i], -offset)); // prettier-ignore
    let pairs = 0;
    mesh.vertices.forEach((p, v) => {
      const w = mirror.opposite(v);
      assert.ok(w >= 0);
      if (w === v) return assert.ok(distance(p) < 0.02 * diagonal, `${v} is on the plane`);
      const middle = p.map((x, i) => (x + mesh.vertices[w][i]) / 2);
      const off = middle.reduce((sum, x, i) => sum + x * mirror.plane.normal[i], -offset);
      assert.ok(Math.abs(off) < 1e-6 + 0.01, `${v} and ${w}: ${off}`);
      assert.equal(mirror.opposite(w), v);
      pairs += 1;
    });
    assert.ok(pairs > 0.7 * mesh.vertices.length, `${pairs}`);
  });
}

test('a shape that is no image of itself has no plane', () => {
  const mesh = cubeMesh(8);
  for (const p of mesh.vertices) {
    const [x, y, z] = p;
    p[0] = x + 0.35 * y + 0.04 * z * z;
    p[1] = y * (1 + 0.08 * x) + 0.3 * z;
    p[2] = 1.4 * z + 0.1 * x * y;
  }
  assert.equal(new Mirror(surfaceOf(mesh)).plane, undefined);
});

test('the largest axis of a symmetric matrix', () => {
  const { axis, value } = largestAxis([2, 1, 0, 1, 2, 0, 0, 0, 1]);
  assert.ok(Math.abs(value - 3) < 1e-9);
  assert.ok(Math.abs(Math.abs(axis[0] * axis[1]) - 0.5) < 1e-9 && Math.abs(axis[2]) < 1e-9);
  assert.equal(largestAxis(Array(9).fill(0)).value, 0);
});

test('a click near the corner of a cube is at the corner; in the middle of a side or far away it stays', () => {
  const mesh = cubeMesh(8);
  // With sharp edges.
  for (const p of mesh.vertices) {
    const most = Math.max(...p.map(Math.abs));
    p.forEach((x, i) => (p[i] = x / most));
  }
  const surface = surfaceOf(mesh);
  const isCorner = (v) => v < 8;
  const far = (v, w) => Math.hypot(...mesh.vertices[v].map((x, i) => x - mesh.vertices[w][i]));
  const cell = 2 / 8;
  let near = 0;
  for (let v = 0; v < mesh.vertices.length; v++) {
    const found = cornerNear(surface, v, (w) => far(v, w) < 1.5 * cell);
    const corner = mesh.vertices.findIndex((_, w) => isCorner(w) && far(v, w) < 1.2 * cell);
    if (corner >= 0) {
      assert.equal(found, corner);
      near += 1;
    } else if (!mesh.vertices.some((_, w) => isCorner(w) && far(v, w) < 1.5 * cell)) {
      assert.equal(found, v);
    }
  }
  assert.ok(near >= 32, `${near}`);
});
