// How sizes vary, against a sorted list, and against the certificate of the solver.

import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { scaleAt } from '../../../web/src/model/surface.ts';
import { sizesOf, weightedQuantile } from '../../../web/src/services/geometry/sizes.ts';
import { percentText, timesText } from '../../../web/src/text/format.ts';
import { randomFrom } from '../../mutation/draw.mjs';
import { bumpyDisk } from '../../support/disk.mjs';

const core = path.resolve(import.meta.dirname, '../../../build/package/node/core.js');
const skip = existsSync(core) ? false : 'build/package is not there: build hgp_package first';

test('a weighted quantile is that of the sorted list, also with equal values and weights of zero', () => {
  let seed = 5;
  const random = () => (seed = (seed * 16807) % 2147483647) / 2147483647;
  for (let round = 0; round < 300; round++) {
    const n = 1 + Math.floor(40 * random());
    const values = Array.from({ length: n }, () => Math.floor(6 * random()) - 3);
    const weights = values.map(() => (random() < 0.2 ? 0 : Math.ceil(5 * random())));
    const total = weights.reduce((sum, x) => sum + x, 0);
    if (total === 0) continue;
    for (const share of [0.01, 0.05, 0.5, 0.95, 1]) {
      const order = [...values.keys()].sort((a, b) => values[a] - values[b]);
      let below = 0;
      const wanted = values[order.find((i) => (below += weights[i]) >= share * total)];
      assert.equal(
        weightedQuantile(Uint32Array.from(values.keys()), values, weights, share),
        wanted,
      );
    }
  }
});

/** A strip of squares along x, two triangles each, and how each is scaled in the map. */
function strip(scales) {
  const n = scales.length;
  const positions = Float64Array.from({ length: 2 * (n + 1) }, (_, i) => i).reduce((all, i) => all.concat([i >> 1, i & 1, 0]), []); // prettier-ignore
  const triangles = scales.flatMap((_, s) => [2 * s, 2 * s + 2, 2 * s + 3, 2 * s, 2 * s + 3, 2 * s + 1]); // prettier-ignore
  const area = scales.flatMap((x) => [2 * Math.log2(x), 2 * Math.log2(x)]);
  const around = Array.from({ length: 2 * (n + 1) }, (_, v) => [v ^ 1, v - 2, v + 2].filter((w) => w >= 0 && w < 2 * (n + 1))); // prettier-ignore
  const neighbourStart = [0];
  for (const all of around) neighbourStart.push(neighbourStart.at(-1) + all.length);
  return {
    faces: {
      positions: Float64Array.from(positions),
      triangles: Uint32Array.from(triangles),
      area: Float32Array.from(area),
      stretch: new Float32Array(2 * n).fill(1.25),
      flipped: new Uint32Array(0),
      uvArea: scales.reduce((sum, x) => sum + x * x, 0),
      surfaceArea: n,
    },
    around: {
      vertexCount: 2 * (n + 1),
      neighbourStart: Uint32Array.from(neighbourStart),
      neighbours: Uint32Array.from(around.flat()),
      representative: Int32Array.from({ length: 2 * (n + 1) }, (_, v) => v),
      isBoundary: new Uint8Array(2 * (n + 1)),
    },
  };
}

test('a quantile is found in some looks at each value, whichever way they are sorted and whatever is asked for', () => {
  const count = 2000;
  const orders = {
    up: (i) => i,
    down: (i) => -i,
    'up and down': (i) => Math.min(i, count - i),
    'down and up': (i) => Math.max(i, count - i),
    equal: () => 3,
    few: (i) => i % 3,
    mixed: (i) => (i * 7919) % count,
  };
  for (const [name, at] of Object.entries(orders))
    for (const share of [0, 1 / 128, 0.5, 127 / 128, 1]) {
      let looks = 0;
      const values = new Proxy({}, { get: (_, i) => ((looks += 1), at(Number(i))) });
      const ids = Uint32Array.from({ length: count }, (_, i) => i);
      const found = weightedQuantile(ids, values, new Float64Array(count).fill(1), share);
      const sorted = Array.from({ length: count }, (_, i) => at(i)).sort((a, b) => a - b);
      assert.equal(found, sorted[Math.max(0, Math.ceil(share * count) - 1)], `${name} ${share}`); // prettier-ignore
      assert.ok(looks < 30 * count, `${name} ${share}: ${looks} looks`);
    }
});

test('places of very different size are found, each once, with a vertex inside', () => {
  const scales = new Array(60).fill(1);
  scales.fill(0.05, 10, 13).fill(20, 40, 44);
  const { faces, around } = strip(scales);
  const sizes = sizesOf(faces, around);
  assert.equal(sizes.typicalStretch, 1.25);
  assert.ok(Math.abs(sizes.typicalScale - 1) < 1e-6, `${sizes.typicalScale}`);
  assert.ok(Math.abs(sizes.range / 400 - 1) < 1e-6, `${sizes.range}`);
  const { larger, smaller } = sizes;
  assert.ok(Math.abs(larger.share - 3 / 60) < 1e-12 && Math.abs(smaller.share - 4 / 60) < 1e-12);
  assert.equal(larger.vertices.length, 1);
  assert.ok(larger.vertices[0] >= 20 && larger.vertices[0] <= 27, `${larger.vertices}`);
  assert.ok(smaller.vertices[0] >= 80 && smaller.vertices[0] <= 89, `${smaller.vertices}`);
  assert.deepEqual(
    [...larger.triangles].sort((a, b) => a - b),
    [20, 21, 22, 23, 24, 25],
  );
  // On a boundary there are no cones.
  around.isBoundary.fill(1);
  assert.deepEqual(sizesOf(faces, around).larger.vertices, []);
});

test('of many places the eight largest count, from three vertices on; of their triangles the 2000 most extreme are shown', () => {
  const scales = new Array(400).fill(1);
  const widths = [3, 9, 4, 8, 2, 10, 6, 5, 7, 11];
  widths.forEach((width, i) => scales.fill(i % 2 ? 30 : 20, 40 * i, 40 * i + width));
  const { faces, around } = strip(scales);
  const { vertices } = sizesOf(faces, around).smaller;
  const placeOf = (v) => Math.round((v >> 1) / 40);
  assert.deepEqual(vertices.map((v) => widths[placeOf(v)]), [11, 10, 9, 8, 7, 6, 5, 4]); // prettier-ignore

  // At the end of the strip one triangle alone stands out at one of its vertices, at two, at three.
  for (const [area, count] of [[6, 0], [8, 0], [12, 1]]) { // prettier-ignore
    const { faces: plain, around: beside } = strip(new Array(30).fill(1));
    for (const [sign, side] of [[1, 'smaller'], [-1, 'larger']]) { // prettier-ignore
      plain.area[1] = sign * area;
      assert.equal(sizesOf(plain, beside)[side].vertices.length, count, `${sign * area}`);
    }
  }

  const long = new Array(3000).fill(1).fill(20, 0, 1100).fill(25, 500, 700);
  const { share, triangles } = sizesOf(...Object.values(strip(long))).smaller;
  assert.ok(Math.abs(share - 1100 / 3000) < 1e-9, `all of them: ${share}`);
  assert.equal(triangles.length, 2000);
  assert.ok(triangles.subarray(0, 400).every((t) => t >= 1000 && t < 1400), 'the most extreme');
}); // prettier-ignore

/** The same with its vertices in another order, so that those that follow one another are no neighbours. */
function renumbered({ faces, around }, random) {
  const count = around.vertexCount;
  const old = Array.from({ length: count }, (_, v) => v);
  for (let v = count - 1; v > 0; v--) {
    const w = Math.floor((v + 1) * random());
    [old[v], old[w]] = [old[w], old[v]];
  }
  const now = old.map((_, v) => old.indexOf(v));
  const rings = old.map((v) => [...around.neighbours.subarray(around.neighbourStart[v], around.neighbourStart[v + 1])].map((w) => now[w])); // prettier-ignore
  const neighbourStart = [0];
  for (const ring of rings) neighbourStart.push(neighbourStart.at(-1) + ring.length);
  const positions = Float64Array.from(old.flatMap((v) => [...faces.positions.subarray(3 * v, 3 * v + 3)])); // prettier-ignore
  const triangles = faces.triangles.map((v) => now[v]);
  return {
    faces: { ...faces, positions, triangles },
    around: { ...around, neighbourStart: Uint32Array.from(neighbourStart), neighbours: Uint32Array.from(rings.flat()) }, // prettier-ignore
  };
}

/** What is told of sizes, counted as plainly as can be. */
function plainSizes(
  { positions: p, triangles, area, stretch, flipped, uvArea, surfaceArea },
  around,
) {
  const count = triangles.length / 3;
  const cornersOf = (t) => [...triangles.subarray(3 * t, 3 * t + 3)];
  const at = (v) => [...p.subarray(3 * v, 3 * v + 3)];
  const areaOf = (t) => {
    const [a, b, c] = cornersOf(t).map(at);
    const [u, w] = [b, c].map((end) => end.map((x, i) => x - a[i]));
    return Math.hypot(u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]) / 2; // prettier-ignore
  };
  const counted = Array.from({ length: count }, (_, t) => t).filter((t) => !flipped.includes(t) && areaOf(t) > 0); // prettier-ignore
  const sum = (all) => all.reduce((one, x) => one + x, 0);
  const total = sum(counted.map(areaOf)) || 1;
  const quantile = (values, share) => {
    let below = 0;
    const sorted = counted.toSorted((a, b) => values[a] - values[b]);
    const found = sorted.find((t) => (below += areaOf(t)) >= share * sum(counted.map(areaOf))); // prettier-ignore
    return values[found] ?? 0;
  };
  const middle = quantile(area, 0.5);
  const means = Array.from({ length: around.vertexCount }, (_, v) => {
    const corners = counted.flatMap((t) => cornersOf(t).filter((w) => around.representative[w] === v).map(() => t)); // prettier-ignore
    return sum(corners.map((t) => areaOf(t) * area[t])) / sum(corners.map(areaOf));
  });
  const places = (sign) => {
    const bound = sign * middle + Math.log2(10);
    const isIn = (v) => sign * means[v] > bound;
    const seen = new Set();
    const found = [];
    for (let start = 0; start < means.length; start++) {
      if (!isIn(start) || seen.has(start)) continue;
      const all = new Set([start]);
      for (const v of all) for (const w of around.neighbours.subarray(around.neighbourStart[v], around.neighbourStart[v + 1])) if (isIn(w)) all.add(w); // prettier-ignore
      for (const v of all) seen.add(v);
      const inside = [...all].filter((v) => !around.isBoundary[v]);
      if (inside.length > 0 && all.size >= 3) found.push({ size: all.size, most: Math.max(...inside.map((v) => sign * means[v])), inside }); // prettier-ignore
    }
    const apart = counted.filter((t) => sign * area[t] > bound);
    return { share: sum(apart.map(areaOf)) / total, triangles: apart, found, sign };
  };
  const mean = sum(counted.map((t) => (areaOf(t) / total) * 2 ** area[t]));
  return {
    typicalStretch: quantile(stretch, 0.5),
    spread: 2 ** ((quantile(area, 0.95) - quantile(area, 0.05)) / 2),
    range: 2 ** ((quantile(area, 0.99) - quantile(area, 0.01)) / 2),
    typicalScale: Math.sqrt((2 ** middle / (mean || 1)) * (uvArea / surfaceArea)),
    ...{ larger: places(-1), smaller: places(1), means },
  };
}

test('sizes are those that are counted plainly; triangles that are flipped or without area count for nothing, whatever was measured of them', () => {
  const random = randomFrom(6);
  const below = (n) => Math.floor(n * random());
  let [shown, known] = [0, 0];
  for (let round = 0; round < 200; round++) {
    const n = 4 + below(40);
    const { faces, around } = renumbered(strip(new Array(n).fill(1)), random);
    for (let at = 0, left = 0, size = 0; at < 2 * n; at++, left--) {
      if (left <= 0) [left, size] = [1 + below(8), [0, 0, 0, 5, -5, 9, -9][below(7)]];
      faces.area[at] = size + random();
      faces.stretch[at] = 1 + random();
    }
    // Of odd widths, so that no sum of areas is just the share that is asked for.
    const widths = Array.from({ length: n + 1 }, () => 0.3 * random());
    for (let v = 0; v < around.vertexCount; v++) faces.positions[3 * v] += widths[faces.positions[3 * v]]; // prettier-ignore
    for (let v = 0; v < around.vertexCount; v++) around.isBoundary[v] = random() < 0.2 ? 1 : 0;
    for (let v = 0; v < around.vertexCount; v++) if (random() < 0.05) around.representative[v] = -1;
    const isOut = Array.from({ length: 2 * n }, () => random() < 0.15);
    faces.flipped = Uint32Array.from(isOut.flatMap((is, t) => (is && random() < 0.6 ? [t] : [])));
    for (let t = 0; t < 2 * n; t++) {
      if (!isOut[t]) continue;
      faces.area[t] = [40, -40, 3 * random(), Infinity, -Infinity, NaN][below(6)];
      faces.stretch[t] = 1 + 50 * random();
      if (!faces.flipped.includes(t)) faces.triangles[3 * t + 1] = faces.triangles[3 * t];
    }
    const is = sizesOf(faces, around);
    const expected = plainSizes(faces, around);
    for (const key of ['typicalStretch', 'spread', 'range', 'typicalScale'])
      assert.ok(Math.abs(is[key] / expected[key] - 1) < 1e-9, `${key}: ${is[key]} ${expected[key]}`); // prettier-ignore
    for (const side of ['larger', 'smaller']) {
      const { share, triangles, found, sign } = expected[side];
      assert.ok(Math.abs(is[side].share - share) < 1e-9, side);
      assert.deepEqual(
        [...is[side].triangles].sort((a, b) => a - b),
        triangles,
        side,
      );
      const sizes = [...is[side].triangles].map((t) => sign * faces.area[t]);
      assert.deepEqual(
        sizes,
        sizes.toSorted((a, b) => b - a),
        'the most extreme first',
      );
      const places = is[side].vertices.map((v) => found.find(({ inside }) => inside.includes(v)));
      assert.equal(new Set(places).size, Math.min(8, found.length), side);
      places.forEach(({ size, most }, i) => {
        assert.equal(sign * expected.means[is[side].vertices[i]], most, 'the most extreme of its place'); // prettier-ignore
        assert.ok(i === 0 || size <= places[i - 1].size, 'the largest places first');
      });
      shown += places.length;
      known += triangles.length;
    }
  }
  assert.ok(shown > 100 && known > 500, `${shown} places, ${known} triangles`);
  // Of a map without a single triangle that counts there is nothing to tell.
  const { faces, around } = strip([1, 1, 1]);
  faces.flipped = Uint32Array.from([0, 1, 2, 3, 4, 5]);
  const { larger, smaller, typicalStretch } = sizesOf(faces, around);
  assert.deepEqual([larger, smaller].map(({ share, triangles, vertices }) => [share, triangles.length, vertices.length]), [[0, 0, 0], [0, 0, 0]]); // prettier-ignore
  assert.equal(typicalStretch, 0);
});

test('a map with equal sizes has no such places', () => {
  const { faces, around } = strip(new Array(30).fill(1));
  const { spread, range, larger, smaller } = sizesOf(faces, around);
  assert.deepEqual([spread, range], [1, 1]);
  assert.deepEqual([larger.vertices, smaller.vertices, larger.share], [[], [], 0]);
});

test('stretch and spread of sizes are the numbers of the certificate', { skip }, async () => {
  const { createCore } = await import(core);
  const solver = await createCore();
  const files = new Map([['disk.obj', new TextEncoder().encode(bumpyDisk(14))]]);
  const model = solver.load({ main: 'disk.obj', files });
  const map = model.parametrize({});
  const [{ distortion }] = map.certificate.components;
  const measures = map.measure();
  const { triangles, positions } = map;
  const sizes = sizesOf({ ...measures, triangles, positions }, { ...model.facts(), vertexCount: positions.length / 3 }); // prettier-ignore
  const stretch = (1 + distortion.medianMu) / (1 - distortion.medianMu);
  assert.ok(
    Math.abs(sizes.typicalStretch / stretch - 1) < 1e-6,
    `${sizes.typicalStretch} ${stretch}`,
  );
  assert.ok(Math.abs(sizes.spread / distortion.sizeSpread - 1) < 1e-6);
  assert.ok(sizes.spread > 1.01);
  // The local scale at the pointer is the root of a triangle's area in the map over that on the surface.
  const uv = Float64Array.from(map.cornerToUv).reduce((all, at) => [...all, map.uv[2 * at], map.uv[2 * at + 1]], []); // prettier-ignore
  const mean = measures.area.map((x, t) => x - 2 * Math.log2(scaleAt({ positions, triangles }, uv, t))); // prettier-ignore
  assert.ok(mean.every((x) => Math.abs(x - mean[0]) < 1e-4));
});

test('numbers are said in few digits', () => {
  assert.deepEqual([4.81, 9.94, 9.97, 41.4].map(percentText), ['4.8 %', '9.9 %', '10 %', '41 %']);
  assert.deepEqual([1.64, 23.7, 1234].map(timesText), ['× 1.6', '× 24', '× 1 234']);
});
