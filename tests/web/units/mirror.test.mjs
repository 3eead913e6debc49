// The plane of symmetry is found from the shape, wherever it is; vertices have their counterparts; and shapes without a plane
// have none. Corners near a pointer are found, and a flat or round place has none.

import assert from 'node:assert/strict';
import test from 'node:test';
import { Box3, Vector3 } from 'three';
import { randomFrom } from '../../mutation/draw.mjs';
import { cornerNear } from '../../../web/src/model/snapping.ts';
import { Mirror } from '../../../web/src/services/geometry/mirror_plane.ts';
import { NearestVertex } from '../../../web/src/services/geometry/nearest_vertex.ts';
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

/**
 * Points of an egg that is its own image across x = 0 alone, as wide as `sizes` say.
 * @param more  points of one half that the other has not, for each that both have
 */
function egg(sizes, count, more = 0) {
  const points = [];
  const on = ([x, y, z]) => [sizes[0] * x, sizes[1] * (y + 0.4 * x * x + 0.2 * z), sizes[2] * (z + 0.35 * y * y)]; // prettier-ignore
  // Points of a spiral are spread evenly over a ball.
  const spiral = (n, by) => Array.from({ length: n }, (_, i) => {
    const [z, turn] = [1 - (2 * i + 1) / n, (i + by) * Math.PI * (3 - Math.sqrt(5))];
    return [Math.sqrt(1 - z * z) * Math.cos(turn), Math.sqrt(1 - z * z) * Math.sin(turn), z];
  }).filter(([x]) => x > 0); // prettier-ignore
  const half = spiral(count, 0);
  points.push(...half.map(on), ...half.map(([x, y, z]) => on([-x, y, z])));
  for (const p of spiral(Math.round(more * count), 0.4)) points.push(on(p));
  return points;
}

/** The counterparts of the vertices of an egg: one half comes after the other. */
const oppositeIn = (points, v) => (v + points.length / 2) % points.length;

/** Points turned and moved, as a shape of which the plane is looked for, and that plane. */
function posed(points, seed) {
  const random = randomFrom(seed);
  const [a, b] = [0, 1].map(() => new Vector3(random() - 0.5, random() - 0.5, random() - 0.5));
  const [x, y] = [a.normalize(), b.projectOnPlane(a).normalize()];
  const z = x.clone().cross(y);
  const shift = new Vector3(random(), random(), random()).multiplyScalar(9);
  const all = points.map((p) => shift.clone().addScaledVector(x, p[0]).addScaledVector(y, p[1]).addScaledVector(z, p[2])); // prettier-ignore
  const diagonal = new Box3().setFromPoints(all).getSize(new Vector3()).length();
  return {
    shape: {
      positions: Float64Array.from(all.flatMap((p) => p.toArray())),
      representative: Uint32Array.from(all.keys()),
      vertexCount: all.length,
      diagonal,
    },
    normal: x,
    offset: shift.dot(x),
  };
}
function assertPlane({ plane }, { normal, offset, shape }, within, what) {
  assert.ok(plane, what);
  const sign = Math.sign(normal.dot(new Vector3(...plane.normal)));
  const off = new Vector3(...plane.normal).multiplyScalar(sign).distanceTo(normal);
  assert.ok(off < within, `${what}: ${off} aside`);
  const middle = new Box3().setFromArray(shape.positions).getCenter(new Vector3());
  const [found, is] = [new Vector3(...plane.normal).dot(middle) - plane.offset, normal.dot(middle) - offset]; // prettier-ignore
  assert.ok(Math.abs(sign * found - is) < within * shape.diagonal, `${what}: ${found} and ${is}`);
}
const widths = [[1, 1.6, 2.4], [1.6, 1, 2.4], [2.4, 1, 1.6]]; // prettier-ignore

test('the plane is found whichever way a shape is turned in space, be it across its longest, middle or shortest side', () => {
  widths.forEach((sizes, i) => {
    const points = egg(sizes, 500);
    const pose = posed(points, i + 1);
    const mirror = new Mirror(pose.shape);
    assertPlane(mirror, pose, 1e-6, `${sizes}`);
    const { shape, normal, offset } = pose;
    const at = (v) => new Vector3().fromArray(shape.positions, 3 * v);
    for (let v = 0; v < shape.vertexCount; v++) {
      const off = Math.abs(at(v).dot(normal) - offset) / shape.diagonal;
      if (off < 0.007) assert.equal(mirror.opposite(v), v);
      if (off > 0.009) assert.equal(mirror.opposite(v), oppositeIn(points, v));
    }
  });
});

test('the plane is that of the shape, not of its vertices, of which one half may have more', () => {
  widths.slice(0, 2).forEach((sizes, i) => {
    const pose = posed(egg(sizes, 500, 0.2), i + 30);
    assertPlane(new Mirror(pose.shape), pose, 0.02, `${sizes}`);
  });
});

test('small differences of the halves leave the plane, large ones do not', () => {
  const sizes = [1, 1.6, 2.4];
  /** One half is wavy, by a share of the diagonal. */
  const bent = (by) => {
    const points = egg(sizes, 900);
    for (const p of points) if (p[0] > 0) p[1] += by * 6 * Math.sin(6 * p[0]);
    return posed(points, 60);
  };
  const pose = bent(0.01);
  assertPlane(new Mirror(pose.shape), pose, 0.02, 'one hundredth');
  assert.equal(new Mirror(bent(0.08).shape).plane, undefined, 'eight hundredths');
});

test('what only one half has has no counterpart; all the rest has', () => {
  const points = egg([1, 1.6, 2.4], 500);
  const tip = points.findIndex(([x]) => x > 0.9);
  points[tip] = points[tip].map((x) => 1.8 * x);
  const pose = posed(points, 5);
  const mirror = new Mirror(pose.shape);
  assertPlane(mirror, pose, 0.01, 'with a thorn');
  assert.equal(mirror.opposite(tip), -1);
  points.forEach(([x], v) => {
    const w = oppositeIn(points, v);
    if (v !== tip && w !== tip && Math.abs(x) > 0.1) assert.equal(mirror.opposite(v), w);
  });
});

test('of vertices that a file has more than once the one that stands for all is the counterpart; nothing has no plane', () => {
  const points = egg([1, 1.6, 2.4], 400);
  const count = points.length;
  const { shape } = posed([...points, ...points], 6);
  shape.representative = shape.representative.map((v) => count + (v % count));
  const mirror = new Mirror(shape);
  for (let v = 0; v < 2 * count; v++)
    if (Math.abs(points[v % count][0]) > 0.1)
      assert.equal(mirror.opposite(v), count + oppositeIn(points, v % count));
  const none = new Mirror({ ...shape, vertexCount: 0 });
  assert.equal(none.plane, undefined);
  assert.equal(none.opposite(0), -1);
});

test('of a large surface some thousands of vertices are tried, and of a small one all', (t) => {
  // Where nothing has a counterpart, each of six planes is tried as it is and moved once.
  const looked = t.mock.method(NearestVertex.prototype, 'of', () => -1);
  for (const count of [200, 1400, 5000, 20_000]) {
    const { shape } = posed(egg([1, 1.6, 2.4], count), 7);
    looked.mock.resetCalls();
    assert.equal(new Mirror(shape).plane, undefined);
    const calls = looked.mock.callCount();
    assert.ok(calls >= 6 * Math.min(shape.vertexCount, 1400), `${count}: ${calls}`);
    assert.ok(calls <= 6 * 3 * Math.min(shape.vertexCount, 3000), `${count}: ${calls}`);
  }
});

test('the plane is the same in whatever order the vertices of the halves come: in turn, in runs, one half after the other', () => {
  const sizes = [1, 1.6, 2.4];
  // So many that a sample of them is looked at.
  for (const [count, run] of [
    [3100, 1],
    [3100, 3],
    [6200, 1],
  ]) {
    const points = egg(sizes, count);
    const half = points.length / 2;
    // Runs of one half and of the other alternate.
    const order = [...points.keys()].sort((v, w) => {
      const [a, b] = [v, w].map((x) => [Math.floor((x % half) / run), Math.floor(x / half), x]);
      return a[0] - b[0] || a[1] - b[1] || a[2] - b[2];
    });
    const pose = posed(order.map((v) => points[v]), 8); // prettier-ignore
    const mirror = new Mirror(pose.shape);
    assertPlane(mirror, pose, 1e-6, `${count} in runs of ${run}`);
  }
});

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
