// The gallery: surfaces of our own making (web/examples.mjs, examples/meshes), mapped while the site is built by the
// package that users install. Nothing that is not certified is shown.

import { readFileSync } from 'node:fs';
import path from 'node:path';
import { createCore } from '../build/package/node/core.js';
import { examples } from '../web/examples.mjs';
import { modelBytes } from '../web/hero.mjs';

const root = path.resolve(import.meta.dirname, '..');

/** What is shown: id of the example, options of the solve, the pattern it starts with, and what to look at. */
const shown = [
  {
    id: 'figure',
    title: 'Arms and legs',
    options: { q: 4, grid: { spacing: 0.14 } },
    pattern: 'plaid',
    look: 'Cones chosen by hgp at hands, feet and forks; aligned to a grid, so that a texture of squares continues everywhere.',
  },
  {
    id: 'sphere',
    title: 'Three cones on a sphere',
    options: { q: 6 },
    lattice: 14,
    pattern: 'hex',
    look: 'q = 6: three cones of 120°, between which a pattern of triangles is turned by multiples of 60°.',
  },
  {
    id: 'cube',
    title: 'Eight corners',
    options: { q: 4, grid: { spacing: 0.25 } },
    pattern: 'checker',
    look: 'A cone of 270° on every corner of a cube, as in a cube that is folded of squared paper.',
  },
  {
    id: 'torus',
    title: 'No cone at all',
    options: { q: 4, grid: { spacing: 0.2 } },
    pattern: 'checker',
    look: 'A torus needs no cones; its two handles may turn the pattern, here by nothing.',
  },
  {
    id: 'rings',
    title: 'Two rings grown together',
    options: { q: 4, grid: { spacing: 0.16 } },
    pattern: 'checker',
    look: 'Genus 2: where the rings meet, cones of more than a full turn are needed; they sit in the two saddles.',
  },
  {
    id: 'pipe',
    title: 'Open at both ends',
    options: { q: 4, grid: { spacing: 0.2 } },
    pattern: 'grid',
    look: 'Two boundaries along which lines of the pattern run, without a cone.',
  },
  {
    id: 'pebble',
    title: 'A pebble in bricks',
    options: { q: 2, grid: { spacing: 0.3 } },
    pattern: 'brick',
    look: 'q = 2: half turns only, so that courses of bricks stay courses of bricks across every seam.',
  },
  {
    id: 'pretzel',
    file: 'examples/meshes/pretzel.obj',
    title: 'A pretzel',
    options: { q: 4, conesFor: 'few', improve: 'isometric', grid: { cells: 900 } },
    pattern: 'checker',
    look: 'Genus 3 with as few cones as possible.',
  },
];

const ofExample = (id) => {
  const one = examples().find((example) => example.id === id);
  if (!one) throw new Error(`there is no example ${id}`);
  return { name: one.file, bytes: new Uint8Array(one.bytes), cones: one.cones, q: one.q };
};

const sourceOf = ({ id, file }) =>
  file
    ? { name: path.basename(file), bytes: readFileSync(path.join(root, file)), cones: null }
    : ofExample(id);

/**
 * Moves, turns and scales a map with three cones so that the first lies on the origin and the second `steps` to its right:
 * all are then points of one lattice of triangles, and a pattern of hexagons continues across the seams.
 */
function onLattice(map, steps) {
  const [a, b] = map.cones.cones.map(({ vertex }) => 2 * map.uvToVertex.indexOf(vertex));
  const { uv } = map;
  const [x, y] = [uv[b] - uv[a], uv[b + 1] - uv[a + 1]];
  const factor = steps / (x * x + y * y);
  const result = new Float64Array(uv.length);
  for (let i = 0; i < uv.length; i += 2) {
    const [s, t] = [uv[i] - uv[a], uv[i + 1] - uv[a + 1]];
    result.set([factor * (s * x + t * y), factor * (t * x - s * y)], i);
  }
  return result;
}

/** How many tiles of a pattern are one unit of uv. */
const scaleOf = (map) => {
  // About 24 tiles along the diagonal of the surface.
  const { positions, uv, cornerToUv, triangles } = map;
  let area = 0;
  let flat = 0;
  for (let t = 0; t < triangles.length; t += 3) {
    const p = [0, 1, 2].map((k) => positions.slice(3 * triangles[t + k], 3 * triangles[t + k] + 3));
    const [d, e] = [1, 2].map((k) => p[k].map((x, i) => x - p[0][i]));
    area +=
      Math.hypot(d[1] * e[2] - d[2] * e[1], d[2] * e[0] - d[0] * e[2], d[0] * e[1] - d[1] * e[0]) /
      2;
    const w = [0, 1, 2].map((k) => uv.slice(2 * cornerToUv[t + k], 2 * cornerToUv[t + k] + 2));
    flat +=
      ((w[1][0] - w[0][0]) * (w[2][1] - w[0][1]) - (w[1][1] - w[0][1]) * (w[2][0] - w[0][0])) / 2;
  }
  let low = [Infinity, Infinity, Infinity];
  let high = low.map(() => -Infinity);
  for (let i = 0; i < positions.length; i++) {
    low[i % 3] = Math.min(low[i % 3], positions[i]);
    high[i % 3] = Math.max(high[i % 3], positions[i]);
  }
  const diagonal = Math.hypot(...high.map((x, i) => x - low[i]));
  return (24 / diagonal) * Math.sqrt(area / flat);
};

/** @returns {Promise<{ id, title, look, pattern, q, scale, isAligned, facts: string, bytes: Uint8Array }[]>} */
export async function galleryModels() {
  const core = await createCore();
  return shown.map((one) => {
    const { name, bytes, cones } = sourceOf(one);
    const model = core.load({ main: name, files: new Map([[name, bytes]]) });
    const { q, ...options } = one.options;
    const given = cones ? { cones: { q, cones } } : { q };
    const map = model.parametrize({ ...given, ...options });
    const { certificate } = map;
    if (!certificate.certified) throw new Error(`gallery: ${one.id} is not certified`);
    const isAligned = 'grid' in options;
    const placed = one.lattice ? { ...map, uv: onLattice(map, one.lattice) } : map;
    const count = map.cones.cones.length;
    const facts = `${map.triangles.length / 3} triangles, ${count} cones, q = ${q}; certified${one.lattice ? ', moved onto a lattice for this picture' : isAligned ? ', aligned to a grid' : ''}.`;
    const result = {
      ...{
        id: one.id,
        title: one.title,
        look: one.look,
        pattern: one.pattern,
        q,
        isAligned,
        facts,
      },
      ...{ scale: isAligned || one.lattice ? 1 : scaleOf(map), bytes: modelBytes(placed) },
    };
    return result;
  });
}
