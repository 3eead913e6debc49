// Two things that the page computes itself, against the solver and against plain counting.

import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { handleLoops } from '../../../web/src/services/geometry/handle_loops.ts';
import { findOverlaps } from '../../../web/src/services/geometry/overlaps.ts';
import { drawThumbnail } from '../../../web/src/services/geometry/thumbnail.ts';
import { cubeMesh, toObj } from '../../support/meshes.mjs';
import { torusMesh } from '../shapes.mjs';

const core = path.resolve(import.meta.dirname, '../../../build/package/node/core.js');
const skip = existsSync(core) ? false : 'build/package is not there: build hgp_package first';
const { createCore } = skip ? {} : await import(core);

const open = async (mesh) => {
  const core = await createCore();
  const bytes = new TextEncoder().encode(toObj(mesh));
  core.load({ main: 'mesh.obj', files: new Map([['mesh.obj', bytes]]) });
  return core;
};

const next = (h) => (h % 3 === 2 ? h - 2 : h + 1);

test(
  'handle loops are those of the solver: the seams along each add up to the r that was asked',
  { skip },
  async () => {
    const mesh = torusMesh(16, 10);
    const core = await open(mesh);
    const q = 4;
    const cones = [3, 5, 3, 5].map((k, i) => ({ vertex: 7 + 37 * i, k }));
    for (const asked of [
      [0, 0],
      [1, 0],
      [0, 1],
      [2, 3],
    ]) {
      const handles = asked.map((r, generator) => ({ generator, r }));
      const { seams, cornerToUv, triangles, certificate } = core.parametrize({ cones: { q, cones, handles } }); // prettier-ignore
      assert.equal(certificate.brokenSeams, 0);
      const vertexCount = mesh.vertices.length;
      const loops = handleLoops({ triangles, vertexCount, component: new Int32Array(vertexCount) });
      assert.equal(loops.length, 2);
      const turns = loops.map((crossed) => {
        let turn = 0;
        for (const h of crossed) {
          const ends = [cornerToUv[h], cornerToUv[next(h)]];
          const isSide = (side) => side.every((end) => ends.includes(end));
          const seam = seams.find(({ a, b }) => isSide(a) || isSide(b));
          if (seam) turn += isSide(seam.a) ? seam.r : -seam.r;
        }
        return ((turn % q) + q) % q;
      });
      const opposite = turns.map((r) => (q - r) % q);
      assert.ok(`${turns}` === `${asked}` || `${opposite}` === `${asked}`, `${turns} for ${asked}`);
    }
  },
);

test(
  'overlaps are counted as pairs of triangles that share area and no corner',
  { skip },
  async () => {
    const square = (x, y) => [x, y, x + 1, y, x + 1, y + 1, x, y, x + 1, y + 1, x, y + 1];
    const ids = (n) => Uint32Array.from({ length: n }, (_, i) => [0, 1, 2, 0, 2, 3][i % 6] + 4 * Math.floor(i / 6)); // prettier-ignore
    const count = async (...squares) => {
      const uv = Float32Array.from(squares.flatMap(([x, y]) => square(x, y)));
      return findOverlaps(uv, ids(uv.length / 2));
    };
    assert.equal((await count([0, 0])).pairs, 0);
    assert.equal((await count([0, 0], [1, 0], [0, 1], [1, 1])).pairs, 0); // they touch
    assert.deepEqual(await count([0, 0], [0.5, 0.25]), { pairs: 3, triangles: Uint32Array.of(0, 1, 2, 3), isMore: false }); // prettier-ignore
    assert.equal((await count([0, 0], [0, 0], [0, 0])).pairs, 6);
    // The net of a cube lies nowhere on itself.
    const core = await open(cubeMesh(4));
    const { uv, cornerToUv } = core.parametrize({ cones: { q: 4, cones: [...Array(8).keys()].map((vertex) => ({ vertex, k: 3 })) } }); // prettier-ignore
    const corners = Float32Array.from([...cornerToUv].flatMap((i) => [uv[2 * i], uv[2 * i + 1]]));
    assert.equal((await findOverlaps(corners, cornerToUv)).pairs, 0);
  },
);

test('a small picture has the shape in the middle, in front what is nearer, and the checker of its map', () => {
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
