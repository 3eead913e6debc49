// What the page computes itself, against the solver and against plain counting.

import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { loopSegments } from '../../../web/src/services/geometry/handle_loops.ts';
import { randomFrom } from '../../mutation/draw.mjs';
import { drawThumbnail } from '../../../web/src/services/geometry/thumbnail.ts';
import { bumpyDisk } from '../../support/disk.mjs';
import { cubeMesh, toObj } from '../../support/meshes.mjs';
import { cubesOnAnEdge, torusMesh } from '../shapes.mjs';
import { plainFacts } from './plain_facts.mjs';

const core = path.resolve(import.meta.dirname, '../../../build/package/node/core.js');
const skip = existsSync(core) ? false : 'build/package is not there: build hgp_package first';
const { createCore } = skip ? {} : await import(core);

const open = async (mesh, options) => {
  const core = await createCore();
  const bytes = new TextEncoder().encode(toObj(mesh));
  return core.load({ main: 'mesh.obj', files: new Map([['mesh.obj', bytes]]) }, options);
};

/** The text of an OBJ of triangles as a mesh. */
function meshOf(text) {
  const rows = (word) => text.split('\n').filter((line) => line.startsWith(`${word} `)).map((line) => line.split(' ').slice(1)); // prettier-ignore
  const vertices = rows('v').map((row) => row.map(Number));
  return { vertices, triangles: rows('f').map((row) => row.map((corner) => parseInt(corner) - 1)) };
}

test(
  'facts of the package agree with direct counting: closed, open, several components',
  { skip },
  async () => {
    const [cube, torus] = [cubeMesh(4), torusMesh(9, 7)];
    const count = cube.vertices.length;
    const parts = {
      vertices: [...cube.vertices, [9, 9, 9], ...torus.vertices], // one that no triangle names
      triangles: [...cube.triangles, ...torus.triangles.map((t) => t.map((v) => v + count + 1))],
    };
    const fan = { vertices: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0, -1, 0]], triangles: [[0, 1, 2], [0, 1, 3], [0, 1, 4]] }; // prettier-ignore
    for (const mesh of [cube, torus, meshOf(bumpyDisk(9)), parts, fan]) {
      // One of them is refused as it is, and known all the same.
      const model = await open(mesh, { strict: mesh === fan });
      assert.equal(model.info.usable, mesh !== fan);
      const { angle, area, ...facts } = model.facts();
      const { angle: plainAngle, area: plainArea, ...plain } = plainFacts(mesh);
      assert.deepEqual(facts, plain);
      assert.ok(Math.abs(area / plainArea - 1) < 1e-12);
      for (const [v, x] of angle.entries()) assert.ok(Math.abs(x - plainAngle[v]) < 1e-12, `${v}`);
    }
  },
);

test('facts of a repaired mesh refer to the vertices of the file', { skip }, async () => {
  const core = await createCore();
  const files = new Map([['cubes.obj', new TextEncoder().encode(cubesOnAnEdge())]]);
  const model = core.load({ main: 'cubes.obj', files });
  assert.equal(model.info.components.length, 2);
  const facts = model.facts();
  // The cubes are apart; the vertices of the edge are in both and told by their triangles.
  assert.deepEqual([...new Set(facts.triangleComponent)].sort(), [0, 1]);
  assert.ok(facts.isBoundary.every((x) => x === 0));
  const { triangles, repaired } = model.surface();
  triangles.forEach((v, c) => {
    const isShared = repaired.vertexOrigin.filter((w) => w === v).length > 1;
    if (!isShared) assert.equal(facts.component[v], facts.triangleComponent[Math.floor(c / 3)]);
  });
  assert.deepEqual(
    facts.representative,
    Int32Array.from(facts.representative, (_, v) => v),
  );
  // A triangle that is left out has no component.
  const twice = cubeMesh(2);
  const again = await open({ ...twice, triangles: [...twice.triangles, twice.triangles[0]] });
  assert.equal(again.facts().triangleComponent.at(-1), -1);
});

test(
  'handle loops of the package: the seams along each add up to the prescribed r',
  { skip },
  async () => {
    const mesh = torusMesh(16, 10);
    const model = await open(mesh);
    const q = 4;
    const cones = [3, 5, 3, 5].map((k, i) => ({ vertex: 7 + 37 * i, k }));
    for (const asked of [
      [0, 0],
      [1, 0],
      [0, 1],
      [2, 3],
    ]) {
      const handles = asked.map((r, generator) => ({ generator, r }));
      const { seams, uvToVertex, cornerToUv, triangles, certificate } = model.parametrize({ cones: { q, cones, handles } }); // prettier-ignore
      assert.equal(certificate.brokenSeams, 0);
      const loops = model.loops().handles;
      assert.equal(loops.length, 2);
      const isLeft = (side, v, w) =>
        triangles.some((tail, c) => {
          const head = c % 3 === 2 ? c - 2 : c + 1;
          const ends = [cornerToUv[c], cornerToUv[head]];
          return tail === v && triangles[head] === w && side.every((i) => ends.includes(i));
        });
      const turns = loops.map((crossed) => {
        let turn = 0;
        for (let e = 0; e < crossed.length; e += 2) {
          const [v, w] = crossed.subarray(e, e + 2);
          const at = (side) => side.map((i) => uvToVertex[i]);
          const seam = seams.find(({ a }) => at(a).includes(v) && at(a).includes(w));
          // The loop leaves the triangle in which the edge runs from v to w.
          if (seam) turn += isLeft(seam.a, v, w) ? seam.r : -seam.r;
        }
        return ((turn % q) + q) % q;
      });
      const opposite = turns.map((r) => (q - r) % q);
      assert.ok(`${turns}` === `${asked}` || `${opposite}` === `${asked}`, `${turns} for ${asked}`);
    }
  },
);

test('lines along a loop join the midpoints of edges and close', () => {
  const places = Float64Array.of(0, 0, 0, 2, 0, 0, 0, 2, 0);
  const lines = loopSegments({ places }, Uint32Array.of(0, 1, 1, 2, 2, 0));
  assert.deepEqual([...lines], [1, 0, 0, 1, 1, 0, 1, 1, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0]);
});

test('a thumbnail shows the centred shape, nearer parts in front, with the checker of its map', () => {
  const { vertices, triangles } = cubeMesh(1);
  const cornerPositions = triangles.flat().flatMap((v) => vertices[v]);
  const picture = drawThumbnail({ cornerPositions }, 32);
  const at = (x, y) => [...picture.subarray(4 * (32 * y + x), 4 * (32 * y + x) + 4)];
  assert.equal(at(0, 0)[3], 0);
  assert.equal(at(16, 16)[3], 255);
  const filled = picture.filter((x, i) => i % 4 === 3 && x === 255).length;
  assert.ok(filled > 400 && filled < 1024, `${filled}`);
  // A second cube, nearer to the eye and in the same direction, hides the first.
  const toEye = [0.5, 0.38, 0.78];
  const near = triangles.flat().flatMap((v) => vertices[v].map((x, k) => 0.2 * x + 5 * toEye[k]));
  const corners = near.length / 3;
  const cornerUv = Array.from({ length: 4 * corners }, (_, i) => (i >= 2 * corners && i % 2 === 0 ? 1 : 0)); // prettier-ignore
  const all = [...cornerPositions, ...near];
  const [red, , blue] = drawThumbnail({ cornerPositions: all, cornerUv, tiles: 1 }, 32).subarray(4 * (32 * 16 + 16)); // prettier-ignore
  assert.ok(blue > red, 'the one in front is dark');
  const [otherRed, , otherBlue] = drawThumbnail({ cornerPositions, cornerUv, tiles: 1 }, 32).subarray(4 * (32 * 16 + 16)); // prettier-ignore
  assert.ok(otherRed > otherBlue, 'the other light');
  assert.equal(
    drawThumbnail({ cornerPositions: [NaN, NaN, NaN] }, 8).some((x) => x > 0),
    false,
  );
});

test('a thumbnail covers what its triangles cover as the camera first sees them, and no pixel beside them', () => {
  const random = randomFrom(15);
  const unit = (v) => v.map((x) => x / Math.hypot(...v));
  const cross = ([a, b, c], [d, e, f]) => [b * f - c * e, c * d - a * f, a * e - b * d];
  const toEye = unit([0.5, 0.38, 0.78]);
  const right = unit(cross([0, 1, 0], toEye));
  const up = cross(toEye, right);
  const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
  for (let round = 0; round < 40; round++) {
    const size = 12 + round;
    const count = 1 + (round % 3);
    const far = 10 ** ((round % 7) - 3);
    const points = Array.from({ length: 3 * count }, () => [0, 1, 2].map(() => far * (random() - 0.3))); // prettier-ignore
    const seen = points.map((p) => [dot(p, right), -dot(p, up)]);
    const [[left, top], [end, bottom]] = [Math.min, Math.max].map((most) => [0, 1].map((k) => most(...seen.map((p) => p[k])))); // prettier-ignore
    const scale = (0.92 * size) / Math.max(end - left, bottom - top);
    const at = seen.map(([x, y]) => [size / 2 + scale * (x - (left + end) / 2), size / 2 + scale * (y - (top + bottom) / 2)]); // prettier-ignore
    const picture = drawThumbnail({ cornerPositions: points.flat() }, size);
    assert.equal(picture.length, 4 * size * size);
    for (let y = 0; y < size; y++)
      for (let x = 0; x < size; x++) {
        // How far the middle of the pixel is inside of each triangle, in pixels.
        const inside = Array.from({ length: count }, (_, t) => {
          const [a, b, c] = at.slice(3 * t, 3 * t + 3);
          const side = ([px, py], [qx, qy]) => ((qx - px) * (y + 0.5 - py) - (qy - py) * (x + 0.5 - px)) / Math.hypot(qx - px, qy - py); // prettier-ignore
          const sides = [side(a, b), side(b, c), side(c, a)];
          return Math.max(Math.min(...sides), Math.min(...sides.map((s) => -s)));
        });
        const most = Math.max(...inside);
        if (Math.abs(most) < 1e-3) continue;
        assert.equal(picture[4 * (size * y + x) + 3], most > 0 ? 255 : 0, `${round}: ${x}, ${y}`);
      }
  }
});
