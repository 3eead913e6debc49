// Laws of what the geometry worker computes, each against the plainest way to compute the same.

import assert from 'node:assert/strict';
import test from 'node:test';
import { flatCrosses, surfaceCrosses } from '../../../web/src/services/geometry/cross_lines.ts';
import { boxOf, smallestArea, quantilesOf } from '../../../web/src/services/geometry/distortion.ts';
import { loopSegments } from '../../../web/src/services/geometry/handle_loops.ts';
import { NearestVertex } from '../../../web/src/services/geometry/nearest_vertex.ts';
import { overlayColours } from '../../../web/src/services/geometry/overlay_colours.ts';
import {
  locatedSurface,
  normalsOf,
  placed,
} from '../../../web/src/services/geometry/placed_surface.ts';
import { poissonSamples, spacingOf } from '../../../web/src/services/geometry/poisson_samples.ts';
import { distanceToSeams } from '../../../web/src/services/geometry/seam_distance.ts';
import { drawThumbnail } from '../../../web/src/services/geometry/thumbnail.ts';
import { randomFrom } from '../../mutation/draw.mjs';
import { cubeMesh } from '../../support/meshes.mjs';
import { plainFacts } from './plain_facts.mjs';

const near = (a, b, what, within = 1e-9) =>
  assert.ok(Math.abs(a - b) <= within * Math.max(1, Math.abs(b)), `${what}: ${a} and ${b}`);
const numbers = (random, count, low = -1, high = 1) =>
  Array.from({ length: count }, () => low + (high - low) * random());

const cube = cubeMesh(4);
const arrays = {
  positions: Float64Array.from(cube.vertices.flat()),
  triangles: Uint32Array.from(cube.triangles.flat()),
};
const surface = { id: 1, ...locatedSurface(arrays, plainFacts(cube)) };
const at = (p, v) => [p[3 * v], p[3 * v + 1], p[3 * v + 2]];
const apart = (a, b) => Math.hypot(...a.map((x, i) => x - b[i]));

test('quantiles are those of the sorted list; ends are the extremes; values without a weight do not count', () => {
  const random = randomFrom(3);
  for (const count of [1, 2, 7, 203]) {
    const values = Float32Array.from(numbers(random, count, -5, 5));
    const sorted = [...values].sort((a, b) => a - b);
    const found = quantilesOf(values);
    assert.equal(found.min, sorted[0]);
    assert.equal(found.max, sorted.at(-1));
    for (const [name, share] of [
      ['p5', 0.05],
      ['median', 0.5],
      ['p95', 0.95],
      ['p99', 0.99],
    ])
      // prettier-ignore
      assert.equal(found[name], sorted[Math.ceil(share * count - 1e-9) - 1], `${name} of ${count}`);
    const weights = new Float64Array(count).fill(2);
    assert.deepEqual(quantilesOf(values, weights), found);
    // A value far outside that weighs nothing.
    const more = Float32Array.from([...values, 1000, -1000]);
    assert.deepEqual(quantilesOf(more, Float64Array.from([...weights, 0, 0])), found);
  }
  const none = { min: 0, p5: 0, median: 0, p95: 0, p99: 0, max: 0 };
  assert.deepEqual(quantilesOf(new Float32Array(0)), none);
});

test('the least area, its triangle and how many are negative or zero', () => {
  // Two corners of a triangle at (0, 0) and (1, 0), the third at height h: area h / 2.
  const heights = [0.5, 2, 0, -0.25, 1, 0, -3];
  const uv = Float64Array.from(heights.flatMap((h, i) => [i, 7, i + 1, 7, i + 0.3, 7 + h]));
  const found = smallestArea(uv);
  near(found.area, -1.5, 'least');
  assert.equal(found.triangle, 6);
  assert.deepEqual([found.negative, found.zero], [2, 2]);
  near(found.smallestPositive, 0.25, 'smallest positive');
  near(found.mean, heights.reduce((sum, h) => sum + h / 2, 0) / heights.length, 'mean');
});

test('the box touches the outermost points on all four sides', () => {
  const points = [3, -2, -4, 5, 1, 1, 0, 9];
  assert.deepEqual(boxOf(points), { x: -4, y: -2, width: 7, height: 11 });
});

test('the distance to seams is the shortest along edges', () => {
  const { neighbourStart, neighbours, vertexCount, positions } = surface;
  const seams = [[0, 9], [9, 20]].map((a) => ({ a, b: a, r: 0 })); // prettier-ignore
  const own = Uint32Array.from({ length: vertexCount }, (_, v) => v);
  const found = distanceToSeams(surface, seams, own);
  // Until nothing changes: no vertex is farther than a neighbour and the edge to it.
  const plain = Array.from({ length: vertexCount }, (_, v) => ([0, 9, 20].includes(v) ? 0 : Infinity)); // prettier-ignore
  for (let changed = true; changed;) {
    changed = false;
    for (let v = 0; v < vertexCount; v++)
      for (let n = neighbourStart[v]; n < neighbourStart[v + 1]; n++) {
        const far = plain[neighbours[n]] + apart(at(positions, v), at(positions, neighbours[n]));
        if (far < plain[v] - 1e-12) [plain[v], changed] = [far, true];
      }
  }
  plain.forEach((far, v) => near(found[v], far, `vertex ${v}`, 1e-5));
  assert.ok(distanceToSeams(surface, [], own).every((far) => far === Infinity));
  // Nearest first: each vertex is finished once, and looks along each of its edges.
  let looks = 0;
  const get = (list, key) => {
    if (/^\d+$/.test(String(key))) looks += 1;
    return list[key];
  };
  distanceToSeams({ ...surface, neighbours: new Proxy(neighbours, { get }) }, seams, own);
  assert.equal(looks, neighbours.length);
});

test('the nearest vertex is that of a search among all, and none beyond the reach', () => {
  const random = randomFrom(5);
  const positions = Float64Array.from(numbers(random, 3 * 300));
  const vertices = [...Array(300).keys()].filter((v) => v % 3 !== 0);
  for (const reach of [0.05, 0.3, 3]) {
    const grid = new NearestVertex(positions, vertices, reach);
    for (let i = 0; i < 300; i++) {
      const point = numbers(random, 3, -1.3, 1.3);
      const all = vertices.map((v) => [apart(at(positions, v), point), v]).sort((a, b) => a[0] - b[0]); // prettier-ignore
      const [far, v] = all[0];
      assert.equal(grid.of(point), far < reach ? v : -1, `${point} within ${reach}`);
    }
  }
  // Whatever the unit of length is, and wherever the origin.
  const points = Array.from({ length: 50 }, () => numbers(random, 3, -1.3, 1.3));
  const foundIn = (unit, shift) => {
    const grid = new NearestVertex(positions.map((x) => unit * (x + shift)), vertices, 0.3 * unit); // prettier-ignore
    return points.map((point) => grid.of(point.map((x) => unit * (x + shift))));
  };
  const usual = foundIn(1, 0);
  for (const [unit, shift] of [[2 ** 200, 0], [2 ** -200, 0], [1, 5000], [3, -70.3]]) assert.deepEqual(foundIn(unit, shift), usual); // prettier-ignore
  // Planes and single points have cells, too.
  const flat = new NearestVertex(Float64Array.from([0, 0, 0, 1, 0, 0]), [0, 1], 2);
  assert.deepEqual([flat.of([0.2, 0, 0]), flat.of([0.8, 0, 0]), flat.of([9, 0, 0])], [0, 1, -1]);
});

test('arms of a cross are q equal turns in the map, and lie on the surface where the map has them', () => {
  const triangles = Uint32Array.from([0, 1, 2]);
  const positions = Float64Array.from([0, 0, 0, 2, 0, 0, 0, 3, 1]);
  const cornerUv = Float32Array.from([1, 1, 1.5, 1.25, 0.75, 2]);
  const [e, f] = [[2, 0, 0], [0, 3, 1]]; // prettier-ignore
  const samples = [{ triangle: 0, s: 0.3, r: 0.2, e, f }, { triangle: 0, s: 0.5, r: 0.4, e, f }]; // prettier-ignore
  const uvAt = (s, r) => [1 + 0.5 * s - 0.25 * r, 1 + 0.25 * s + r];
  for (const q of [1, 2, 3, 4, 6]) {
    const input = { positions, triangles, cornerUv, samples, arm: 0.01, spacing: 10, q };
    const flat = flatCrosses(input);
    const bent = surfaceCrosses(input);
    assert.deepEqual([flat.length, bent.length], [12 * q, 12 * q]);
    samples.forEach(({ s, r }, n) => {
      for (let k = 0; k < q; k++) {
        const [a, b] = [6 * (n * q + k), 6 * (n * q + k) + 3];
        const [u, v] = uvAt(s, r);
        near(flat[a], u, 'centre', 1e-6);
        near(flat[a + 1], v, 'centre', 1e-6);
        near(flat[b] - flat[a], 0.01 * Math.cos((2 * Math.PI * k) / q), 'along u', 1e-6);
        near(flat[b + 1] - flat[a + 1], 0.01 * Math.sin((2 * Math.PI * k) / q), 'along v', 1e-6);
        assert.ok(flat[a + 2] > 0 && flat[b + 2] === flat[a + 2], 'above the map');
        // The end on the surface has the coordinates of the end in the map.
        const [x, y, z] = at(bent, (a + 3) / 3);
        near(z, y / 3, 'in the plane', 1e-6);
        const [endU, endV] = uvAt(x / 2, y / 3);
        near(endU, flat[b], 'u of the end', 1e-5);
        near(endV, flat[b + 1], 'v of the end', 1e-5);
      }
    });
    const short = surfaceCrosses({ ...input, arm: 5, spacing: 0.1 });
    for (let i = 0; i < short.length; i += 6)
      near(apart(at(short, i / 3), at(short, i / 3 + 1)), 0.1, 'not longer than the spacing', 1e-5);
  }
});

test('points are spread: no two nearer than allowed, none far from all, each inside its triangle', () => {
  const spacing = spacingOf(surface, 8);
  near(spacing * 8 * 1.3, surface.diagonal, 'spacing');
  const samples = poissonSamples(surface, spacing);
  const points = samples.map(({ triangle, s, r, e, f }) => {
    assert.ok(s >= 0 && r >= 0 && s + r <= 1);
    const [a, b, c] = [0, 1, 2].map((k) => at(surface.positions, surface.triangles[3 * triangle + k])); // prettier-ignore
    e.forEach((x, i) => near(x, b[i] - a[i], 'e'));
    f.forEach((x, i) => near(x, c[i] - a[i], 'f'));
    return a.map((x, i) => x + s * e[i] + r * f[i]);
  });
  points.forEach((p, i) => points.slice(0, i).forEach((q) => assert.ok(apart(p, q) > 0.84 * spacing))); // prettier-ignore
  for (let v = 0; v < surface.vertexCount; v++)
    assert.ok(
      points.some((p) => apart(p, at(surface.positions, v)) < 2 * spacing),
      `${v}`,
    );
  const area = surface.area;
  assert.ok(points.length > (0.5 * area) / spacing ** 2 && points.length < (2 * area) / spacing ** 2); // prettier-ignore
  assert.deepEqual(poissonSamples(surface, spacing), samples, 'the same every time');
});

/** A parallelogram at `origin` along `a` and `b`, of n × n squares of two triangles each. */
function sheet(origin, a, b, n) {
  const positions = [];
  for (let i = 0; i <= n; i++)
    for (let j = 0; j <= n; j++) positions.push(...origin.map((x, d) => x + (i * a[d] + j * b[d]) / n)); // prettier-ignore
  const triangles = [];
  for (let i = 0; i < n; i++)
    for (let j = 0; j < n; j++) {
      const v = i * (n + 1) + j;
      triangles.push(v, v + n + 1, v + n + 2, v, v + n + 2, v + 1);
    }
  return { positions, triangles };
}
const together = (...parts) => {
  const all = { positions: [], triangles: [] };
  for (const { positions, triangles } of parts) {
    const first = all.positions.length / 3;
    all.triangles.push(...triangles.map((v) => first + v));
    all.positions.push(...positions);
  }
  return { positions: Float64Array.from(all.positions), triangles: Uint32Array.from(all.triangles) }; // prettier-ignore
};
const placesOf = ({ positions, triangles }, samples) =>
  samples.map(({ triangle, s, r, e, f }) =>
    at(positions, triangles[3 * triangle]).map((x, i) => x + s * e[i] + r * f[i]),
  );

test('no two points are nearer than allowed, in every direction and on both sides of zero', () => {
  // Sheets along the diagonals of space, on which neighbours are in cells that have a corner in common.
  const diagonals = [[1, 1, 1], [1, 1, -1], [1, -1, 1], [-1, 1, 1]]; // prettier-ignore
  for (const a of diagonals)
    for (const origin of [[0, 0, 0], [-0.7, -0.7, -0.7], [500, 0, -80]]) {
      // prettier-ignore
      const across = [a[1] * 0.3, -a[0] * 0.3, 0];
      const one = together(sheet(origin, a, across, 1));
      const points = placesOf(one, poissonSamples(one, 0.02));
      assert.ok(points.length > 1000);
      points.sort((p, q) => p[0] - q[0]);
      points.forEach((p, i) => {
        for (let j = i + 1; j < points.length && points[j][0] - p[0] < 0.017; j++)
          assert.ok(apart(p, points[j]) > 0.85 * 0.02 - 1e-9, `${p} and ${points[j]}`);
      });
    }
}); // prettier-ignore

test('points are as many on every part of a surface as its area says, whether its triangles are large or small', () => {
  const coarse = sheet([0, 0, 0], [1, 0, 0], [0, 1, 0], 1);
  const fine = sheet([2, 0, 0], [0, 1, 0], [0, 0, 1], 60);
  const middle = sheet([4, 0, 0], [1, 0, 0], [0, 2, 0], 5);
  const one = together(fine, coarse, middle);
  const spacing = 0.04;
  const points = placesOf(one, poissonSamples(one, spacing));
  // About four fifths of what fits in a random order, as gaps would be seen and more of them take time.
  const most = 0.547 / (Math.PI * 0.425 ** 2);
  const count = (isIn) => points.filter(isIn).length * spacing ** 2;
  const parts = [[count(([x]) => x < 1.5), 1], [count(([x]) => x > 1.5 && x < 3), 1], [count(([x]) => x > 3), 2]]; // prettier-ignore
  for (const [share, area] of parts) assert.ok(share > 0.75 * most * area && share < 0.84 * most * area, `${share} of ${area}`); // prettier-ignore
  // Within a large triangle, too: its quarters have as many each.
  for (const [low, high] of [[0, 0.5], [0.5, 1]])
    for (const [left, right] of [[0, 0.5], [0.5, 1]]) {
      const share = count(([x, y]) => x < 1 && x >= left && x < right && y >= low && y < high);
      assert.ok(share > 0.17 && share < 0.22, `${share}`);
    }
  // Larger and smaller surfaces have the same points, and no area none.
  for (const factor of [1 / 1024, 64]) {
    const scaled = { ...one, positions: one.positions.map((x) => factor * x) };
    assert.deepEqual(placesOf(scaled, poissonSamples(scaled, factor * spacing)), points.map((p) => p.map((x) => factor * x))); // prettier-ignore
  }
  const flat = together(sheet([0, 0, 0], [1, 0, 0], [2, 0, 0], 3));
  assert.deepEqual(poissonSamples(flat, 0.1), []);
  assert.deepEqual(poissonSamples(together(), 0.1), []);
}); // prettier-ignore

test('however small the spacing, some tens of thousands of points are tried, spread over all of the surface', () => {
  const one = together(sheet([0, 0, 0], [1, 0, 0], [0, 1, 0], 20));
  const samples = poissonSamples(one, 1e-5);
  assert.ok(samples.length > 30_000 && samples.length <= 60_000, `${samples.length}`);
  const rows = Array(20).fill(0);
  for (const { triangle } of samples) rows[Math.floor(triangle / 40)] += 1;
  for (const count of rows) near(count, samples.length / 20, 'as many in every row', 0.01);
  // Twice as many tiles are half as far from each other, and the tiles of a larger model larger.
  const [few, many, large] = [[3, 10], [3, 20], [6, 10]].map(([diagonal, tiles]) => spacingOf({ diagonal }, tiles)); // prettier-ignore
  near(few / many, 2, 'tiles');
  near(large / few, 2, 'size');
  assert.ok(few < 0.3 && few > 0.15, 'nearer than the tiles');
});

test('loops close: each segment begins where the one before ends', () => {
  const loop = Uint32Array.from([0, 9, 9, 20, 20, 3]);
  const lines = loopSegments({ places: surface.positions }, loop);
  for (let e = 0; e < 3; e++) {
    const [a, b] = [at(surface.positions, loop[2 * e]), at(surface.positions, loop[2 * e + 1])];
    a.forEach((x, i) => near(lines[6 * e + i], (x + b[i]) / 2, 'middle', 1e-6));
    for (let i = 0; i < 3; i++) assert.equal(lines[6 * e + 3 + i], lines[(6 * (e + 1) + i) % 18]);
  }
});

const values = (more) => ({ stretch: new Float32Array(3), area: new Float32Array(3), areaSize: new Float32Array(3), seamDistance: new Float32Array(9), flipped: new Uint32Array(0), ...more }); // prettier-ignore
const limits = { stretch: { p99: 3 }, areaSize: { p99: 2 }, seamDistance: { p99: 4 } };
const soup = Uint32Array.from([0, 1, 2, 3, 4, 5, 6, 7, 8]);
const colourOf = (out, c) => [...out.subarray(4 * c, 4 * c + 4)];
const luminance = ([r, g, b]) => 0.2126 * r + 0.7152 * g + 0.0722 * b;

test('overlays: the ends of a ramp are those of the legend, larger is lighter, and what is beyond is clamped', () => {
  const stretch = Float32Array.from([1, 2, 3]);
  const angle = overlayColours('angle', values({ stretch }), limits, soup);
  const [low, middle, high] = [0, 3, 6].map((c) => colourOf(angle, c));
  assert.deepEqual(low, [0, 34, 78, 225]);
  assert.deepEqual(high, [254, 232, 56, 225]);
  assert.deepEqual(middle.map((x, i) => Math.abs(x - [125, 124, 120, 225][i]) <= 1), [true, true, true, true]); // prettier-ignore
  const beyond = overlayColours('angle', values({ stretch: Float32Array.from([0, 50, 3]) }), limits, soup); // prettier-ignore
  assert.deepEqual([colourOf(beyond, 0), colourOf(beyond, 3)], [low, high]);
  const seen = Array.from({ length: 40 }, (_, i) =>
    overlayColours('angle', values({ stretch: new Float32Array(3).fill(1 + i / 20) }), limits, soup)); // prettier-ignore
  const lights = seen.map((out) => luminance(colourOf(out, 4)));
  lights.forEach((x, i) => assert.ok(i === 0 || x >= lights[i - 1], 'steadily lighter'));

  const area = overlayColours('area', values({ area: Float32Array.from([-2, 0, 2]) }), limits, soup); // prettier-ignore
  assert.deepEqual([0, 6].map((c) => colourOf(area, c)), [[33, 102, 172, 225], [178, 24, 43, 225]]); // prettier-ignore
  assert.ok(Math.min(...colourOf(area, 3).slice(0, 3)) >= 246, 'equal areas are white');

  const far = Float32Array.from([0, 2, 4, 8, Infinity, 1, 0, 0, 0]);
  const seams = overlayColours('seams', values({ seamDistance: far }), limits, soup);
  assert.deepEqual(colourOf(seams, 0), low);
  for (const c of [2, 3, 4]) assert.deepEqual(colourOf(seams, c), high, `corner ${c}`);
  // Corners have the value of their vertex.
  const shared = overlayColours('seams', values({ seamDistance: far }), limits, Uint32Array.from([2, 0, 1])); // prettier-ignore
  assert.deepEqual(
    [0, 1].map((c) => colourOf(shared, c)),
    [high, low],
  );
});

test('between its five colours a ramp is straight, to the nearest whole number, over all of its 256 steps', () => {
  const ramps = {
    angle: [[0, 34, 78], [66, 78, 108], [125, 124, 120], [187, 175, 113], [254, 232, 56]],
    area: [[33, 102, 172], [146, 197, 222], [247, 247, 247], [244, 165, 130], [178, 24, 43]],
  }; // prettier-ignore
  const steps = Array.from({ length: 256 }, (_, s) => s / 255);
  const corners = Uint32Array.from({ length: 3 * 256 }, (_, c) => c);
  const about = { stretch: Float32Array.from(steps, (x) => 1 + 2 * x), area: Float32Array.from(steps, (x) => 4 * x - 2) }; // prettier-ignore
  for (const [overlay, colours] of Object.entries(ramps)) {
    const out = overlayColours(overlay, values(about), limits, corners);
    steps.forEach((x, s) => {
      const [at, i] = [4 * x, Math.min(3, Math.floor(4 * x))];
      const expected = colours[i].map((low, k) => low + (at - i) * (colours[i + 1][k] - low));
      for (let c = 3 * s; c < 3 * s + 3; c++)
        expected.forEach((one, k) => assert.ok(Math.abs(out[4 * c + k] - one) <= 0.5 + 1e-9, `${overlay}, step ${s}`)); // prettier-ignore
    });
  }
});

test('folded triangles are red under every overlay, and others are never', () => {
  const folded = values({ flipped: Uint32Array.from([1]) });
  for (const overlay of ['none', 'angle', 'area', 'seams', 'flips']) {
    const out = overlayColours(overlay, folded, limits, soup);
    for (let c = 0; c < 9; c++) {
      const [r, g, , a] = colourOf(out, c);
      assert.equal(r > 200 && g < 60 && a === 255, c >= 3 && c < 6, `${overlay}, corner ${c}`);
    }
    assert.equal(out[3] > 0, overlay !== 'none', `${overlay} is seen`);
  }
});

test('normals point outwards with length one, also where a node turns, scales or mirrors the surface', () => {
  const random = randomFrom(8);
  const outward = ({ places = surface.positions, normals, center }) => {
    for (let v = 0; v < surface.vertexCount; v++) {
      const [n, p] = [at(normals, v), at(places, v)];
      near(Math.hypot(...n), 1, 'length', 1e-5);
      assert.ok(n.reduce((sum, x, i) => sum + x * (p[i] - center[i]), 0) > 0, `vertex ${v}`);
    }
  };
  outward(surface);
  for (let i = 0; i < 20; i++) {
    const m = [...numbers(random, 3), 0, ...numbers(random, 3), 0, ...numbers(random, 3), 0, ...numbers(random, 3, -9, 9), 1]; // prettier-ignore
    const here = placed(surface, m);
    const det = m[0] * (m[5] * m[10] - m[6] * m[9]) - m[4] * (m[1] * m[10] - m[2] * m[9]) + m[8] * (m[1] * m[6] - m[2] * m[5]); // prettier-ignore
    assert.equal(here.isMirrored, det < 0);
    // Perpendicular to the triangles: of a face, the normal of the moved corners.
    if (Math.abs(det) > 0.1) outward(here);
    const far = Math.max(...[...Array(surface.vertexCount).keys()].map((v) => apart(at(here.places, v), here.center))); // prettier-ignore
    near(here.radius, far, 'radius');
  }
  const same = placed(surface, [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);

  assert.equal(same.places, surface.positions, 'not even a copy');
});

test('a repaired surface has the normals of its repaired triangles', () => {
  // Every other triangle is turned over in the file; the repair turns it back.
  const turned = arrays.triangles.slice();
  for (let t = 0; t < turned.length; t += 6) [turned[t], turned[t + 1]] = [turned[t + 1], turned[t]]; // prettier-ignore
  const own = Int32Array.from({ length: surface.vertexCount }, (_, v) => v);
  const repaired = { triangles: arrays.triangles, vertexOrigin: Uint32Array.from(own), vertexImage: own }; // prettier-ignore
  const { positions } = arrays;
  const good = normalsOf({ positions, triangles: arrays.triangles });
  assert.deepEqual(normalsOf({ positions, triangles: turned, repaired }), good);
  const gone = own.slice();
  gone[5] = -1;
  const found = normalsOf({ positions, triangles: turned, repaired: { ...repaired, vertexImage: gone } }); // prettier-ignore
  assert.deepEqual(at(found, 5), [0, 0, 0], 'removed by the repair');
  assert.deepEqual(at(found, 6), at(good, 6));
});

test('the ball around a surface is that of its finite points', () => {
  const odd = Float64Array.from([...arrays.positions, NaN, 0, 0, Infinity, 1, 1]);
  const located = locatedSurface({ positions: odd, triangles: arrays.triangles }, plainFacts(cube));
  for (const key of ['center', 'radius', 'diagonal']) assert.deepEqual(located[key], surface[key]);
  assert.equal(located.vertexCount, surface.vertexCount + 2);
  const one = locatedSurface({ positions: new Float64Array(3), triangles: new Uint32Array(0) }, {});
  assert.ok(one.diagonal > 0 && one.radius > 0);
});

test('a picture of a mesh is centred, fills the frame, and is empty beside it', () => {
  const corners = Float32Array.from([...arrays.triangles].flatMap((v) => at(arrays.positions, v)));
  const size = 40;
  const picture = drawThumbnail({ cornerPositions: corners }, size);
  const seen = [];
  for (let y = 0; y < size; y++)
    for (let x = 0; x < size; x++) if (picture[4 * (y * size + x) + 3] === 255) seen.push([x, y]);
  const [xs, ys] = [0, 1].map((i) => seen.map((p) => p[i]));
  const span = (all) => Math.max(...all) - Math.min(...all) + 1;
  assert.ok(Math.max(span(xs), span(ys)) >= 0.86 * size && Math.max(span(xs), span(ys)) <= 0.96 * size); // prettier-ignore
  for (const all of [xs, ys]) near((Math.max(...all) + Math.min(...all) + 1) / 2, size / 2, 'centre', 0.05); // prettier-ignore
  assert.equal(picture[3], 0, 'a corner of the frame');
  // Twice as large and moved: the same picture.
  const moved = drawThumbnail({ cornerPositions: corners.map((x) => 2 * x + 5) }, size);
  const different = picture.filter((x, i) => Math.abs(x - moved[i]) > 3).length;
  assert.ok(different < 0.01 * picture.length, `${different} bytes differ`);
});
