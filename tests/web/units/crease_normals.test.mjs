// Normals along creases: flat where the surface is flat, smooth where it is round, and the same however the triangles of
// a file are ordered, turned and joined.

import assert from 'node:assert/strict';
import test from 'node:test';
import { randomFrom } from '../../mutation/draw.mjs';
import { cubeMesh } from '../../support/meshes.mjs';
import { creaseNormals } from '../../../web/src/services/geometry/crease_normals.ts';
import { normalsOf } from '../../../web/src/services/geometry/placed_surface.ts';

const arraysOf = ({ vertices, triangles }) => ({
  positions: Float64Array.from(vertices.flat()),
  triangles: Uint32Array.from(triangles.flat()),
});

/** The normal that is drawn at each corner. */
function drawn(arrays, { corners, normals }, smooth) {
  const out = Array.from(arrays.triangles, (v) => [...smooth.subarray(3 * v, 3 * v + 3)]);
  corners.forEach((c, i) => (out[c] = [...normals.subarray(3 * i, 3 * i + 3)]));
  assert.ok(corners.every((c, i) => i === 0 || c > corners[i - 1]), 'ascending'); // prettier-ignore
  return out;
}
function cornersOf(mesh) {
  const arrays = arraysOf(mesh);
  const smooth = normalsOf(arrays);
  return drawn(arrays, creaseNormals({ ...arrays, normals: smooth }), smooth);
}
const faceNormal = (mesh, t) => {
  const [a, b, c] = mesh.triangles[t].map((v) => mesh.vertices[v]);
  const [u, w] = [b, c].map((p) => p.map((x, i) => x - a[i]));
  const n = [u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]];
  return n.map((x) => x / Math.hypot(...n));
};
const near = (a, b, what, by = 1e-6) => a.forEach((x, i) => assert.ok(Math.abs(x - b[i]) < by, `${what}: ${a} and ${b}`)); // prettier-ignore

/** A cylinder with caps, whose sides have `sides` edges. */
function cylinder(sides, height = 2) {
  const vertices = [[0, 0, 0], [0, 0, height]]; // prettier-ignore
  const triangles = [];
  for (let i = 0; i < sides; i++) {
    const at = (2 * Math.PI * i) / sides;
    for (const z of [0, height]) vertices.push([Math.cos(at), Math.sin(at), z]);
  }
  for (let i = 0; i < sides; i++) {
    const [a, b] = [2 + 2 * i, 2 + 2 * ((i + 1) % sides)];
    triangles.push([0, b, a], [1, a + 1, b + 1], [a, b, b + 1], [a, b + 1, a + 1]);
  }
  return { vertices, triangles };
}

test('flat faces that meet at a right angle are flat, and what is round stays smooth', () => {
  const box = cylinder(4);
  cornersOf(box).forEach((normal, c) => near(normal, faceNormal(box, Math.floor(c / 3)), `corner ${c}`)); // prettier-ignore
  // Round sides have normals across the axis, their caps along it.
  const round = cylinder(24);
  cornersOf(round).forEach((normal, c) => {
    const t = Math.floor(c / 3);
    const v = round.vertices[round.triangles[t][c % 3]];
    if (t % 4 < 2) near(normal, [0, 0, t % 4 === 0 ? -1 : 1], `cap ${c}`);
    else near(normal, [v[0], v[1], 0], `side ${c}`, 0.1);
  });
  const cube = cubeMesh(12);
  const onSphere = cube.vertices.map((v) => v.map((x) => x / Math.hypot(...v)));
  const sphere = arraysOf({ ...cube, vertices: onSphere });
  const { corners } = creaseNormals({ ...sphere, normals: normalsOf(sphere) });
  assert.equal(corners.length, 0);
});

test('edges of less than 40 degrees are smooth, those of more are creases', () => {
  for (const [sides, isSharp] of [
    [8, true],
    [10, false],
  ]) {
    const mesh = cylinder(sides);
    const side = mesh.triangles.findIndex((_, t) => t % 4 === 2);
    const found = cornersOf(mesh).slice(3 * side, 3 * side + 3);
    const flat = faceNormal(mesh, side);
    const isFlat = found.every((n) => n.every((x, i) => Math.abs(x - flat[i]) < 1e-6));
    assert.equal(isFlat, isSharp, `${sides} sides, ${360 / sides} degrees`);
  }
});

test('normals do not depend on the order of triangles, on their winding, or on vertices that are copies', () => {
  const random = randomFrom(4);
  for (const mesh of [cylinder(4), cylinder(12), cubeMesh(3), folded(random)]) {
    const arrays = arraysOf(mesh);
    const smooth = normalsOf(arrays);
    const before = cornersOf(mesh);
    // Every corner gets a vertex of its own, and some triangles are turned over.
    const order = mesh.triangles.map((_, t) => t).sort(() => random() - 0.5);
    const isTurned = order.map(() => random() < 0.3);
    const corners = order.flatMap((t, i) => (isTurned[i] ? [3 * t, 3 * t + 2, 3 * t + 1] : [3 * t, 3 * t + 1, 3 * t + 2])); // prettier-ignore
    const at = (values) => corners.flatMap((c) => [...values.subarray(3 * arrays.triangles[c], 3 * arrays.triangles[c] + 3)]); // prettier-ignore
    const apart = {
      positions: Float64Array.from(at(arrays.positions)),
      triangles: Uint32Array.from(corners, (_, i) => i),
      normals: Float32Array.from(at(smooth)),
      joined: Int32Array.from(corners, (c) => arrays.triangles[c]),
    };
    const after = drawn(apart, creaseNormals(apart), apart.normals);
    corners.forEach((c, i) => near(after[i], before[c], `corner ${c}`));
  }
});

test('triangles without area, vertices that are not part of the surface and far numbers change nothing else', () => {
  const mesh = cylinder(4);
  const before = cornersOf(mesh);
  const more = { vertices: [...mesh.vertices, [7, 7, 7], [NaN, 0, 0]], triangles: [...mesh.triangles, [2, 2, 3], [10, 10, 10]] }; // prettier-ignore
  const after = cornersOf(more);
  before.forEach((normal, c) => near(after[c], normal, `corner ${c}`));
  const arrays = arraysOf(mesh);
  const normals = normalsOf(arrays);
  const joined = Int32Array.from(mesh.vertices, (_, v) => (v === 0 ? -1 : v));
  const { corners } = creaseNormals({ ...arrays, normals, joined });
  assert.ok(corners.length > 0 && !corners.some((c) => arrays.triangles[c] === 0));
  // More points than vertices, as after a repair that splits some.
  const beyond = Int32Array.from(mesh.vertices, (_, v) => v + 100);
  const same = creaseNormals({ ...arrays, normals, joined: beyond });
  assert.deepEqual(same, creaseNormals({ ...arrays, normals }));
});

/** A sheet with ridges of random heights. */
function folded(random) {
  const vertices = [];
  const triangles = [];
  const heights = Array.from({ length: 7 }, () => 2 * random());
  for (let i = 0; i < 7; i++) for (let j = 0; j < 5; j++) vertices.push([i, j, heights[i]]);
  for (let i = 0; i < 6; i++) for (let j = 0; j < 4; j++) {
    const [a, b] = [5 * i + j, 5 * (i + 1) + j];
    triangles.push([a, b, b + 1], [a, b + 1, a + 1]);
  } // prettier-ignore
  return { vertices, triangles };
}
