// What the page reads back from a written file, with readers of its own, is the map that was certified: for files
// as programs write them. A reader that understands less would call a good map not certified.

import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { compareWithFile } from '../../../web/src/services/geometry/analyse.ts';
import { triangulatedLike } from '../../../web/src/services/geometry/polygon_corners.ts';
import { gltfFiles, objFiles, offFiles, plyFiles, stlFiles } from '../../support/exporters.mjs';
import { cubeMesh, toObj } from '../../support/meshes.mjs';

const core = path.resolve(import.meta.dirname, '../../../build/package/node/core.js');
const skip = existsSync(core) ? false : 'build/package is not there: build hgp_package first';
const { createCore } = skip ? {} : await import(core);

const bytesOf = (content) =>
  typeof content === 'string' ? new TextEncoder().encode(content) : new Uint8Array(content);

/** Why what is read back from the written file is not the map; '' where it is. By mesh. */
async function differences(named) {
  const files = new Map(Object.entries(named).map(([name, content]) => [name, bytesOf(content)]));
  const [main] = files.keys();
  const core = await createCore();
  const count = core.load({ main, files }).info.surfaces.length;
  const found = [];
  for (let surface = 0; surface < count; surface++) {
    const model = core.load({ main, files }, { surface, writeRepairs: true });
    const map = model.parametrize({ q: 4 });
    const written = map.write();
    const beside = [...files].slice(1).map(([name, bytes]) => ({ name, bytes }));
    const all = [...written.files, ...beside];
    found.push(compareWithFile({ map, files: all, mesh: model.info.surface }));
    model.free();
  }
  return found;
}

const polygons = { ply: plyFiles, obj: objFiles, off: offFiles, stl: stlFiles };
const all = [
  ...Object.entries(gltfFiles),
  ...Object.entries(polygons).flatMap(([kind, files]) =>
    Object.entries(files).map(([name, content]) => [name, { [`a.${kind}`]: content }]),
  ),
  ['faces of one and two corners', { 'a.obj': toObj(cubeMesh(3)).replace('f ', 'f 1 2\nf 3\nf ') }],
  ['lines that end in CR alone', { 'a.obj': toObj(cubeMesh(3)).replaceAll('\n', '\r') }],
];
for (const [name, files] of all)
  test(`read back: ${name}`, { skip }, async () => {
    for (const difference of await differences(files)) assert.equal(difference, '');
  });

test('polygons are those of the map however they were cut into triangles, also where corners coincide; other triangles are none of theirs', () => {
  const cornersOf = (all) => ({ positions: Float64Array.from(all.flatMap(([x, y]) => [x, y, 1])), uv: Float64Array.from(all.flatMap(([x, y]) => [x / 2, y + 3])) }); // prettier-ignore
  const around = (n) => Array.from({ length: n }, (_, i) => [Math.cos((2 * Math.PI * i) / n), Math.sin((2 * Math.PI * i) / n)]); // prettier-ignore
  const fan = (n, from) => Array.from({ length: n - 2 }, (_, i) => [0, i + 1, i + 2].map((k) => (from + k) % n)); // prettier-ignore
  const places = around(6);
  const polygons = {
    triangle: places.slice(0, 3),
    quad: places.slice(0, 4),
    hexagon: places,
    'a corner twice': [places[0], places[1], places[2], places[2], places[4]],
    'the first corner twice': [places[0], places[1], places[2], places[0]],
    'two places in turn': [places[0], places[1], places[0], places[1]],
    'two places, each twice': [places[0], places[0], places[1], places[1]],
    'one place': [places[0], places[0], places[0], places[0]],
  };
  for (const [name, polygon] of Object.entries(polygons)) {
    const n = polygon.length;
    // Others before and behind it, so that it is nowhere at the beginning.
    const file = { ...cornersOf([...around(4), ...polygon, ...around(3)]), sizes: [4, n, 3] };
    const mapOf = (triples) => cornersOf([...fan(4, 1).flat().map((i) => around(4)[i]), ...triples.flat().map((i) => polygon[i]), ...around(3)]); // prettier-ignore
    for (let from = 0; from < n; from++) {
      const map = mapOf(fan(n, from));
      const { positions, uv } = triangulatedLike(file, map) ?? assert.fail(`${name}, from corner ${from}`); // prettier-ignore
      assert.deepEqual([positions, uv], [map.positions, map.uv], name);
    }
    if (n < 4 || new Set(polygon.map(String)).size < n) continue;
    const wrong = { turned: fan(n, 0).with(0, fan(n, 0)[0].toReversed()), twice: fan(n, 0).with(0, fan(n, 0)[1]), across: fan(n, 0).with(0, [0, 1, 3]) }; // prettier-ignore
    for (const [what, triples] of Object.entries(wrong)) assert.equal(triangulatedLike(file, mapOf(triples)), undefined, `${name}: ${what}`); // prettier-ignore
  }
  // Files of triangles alone are taken as they are, and other numbers of triangles are none.
  const plain = cornersOf(places.slice(0, 3));
  assert.equal(triangulatedLike(plain, plain), plain);
  assert.equal(triangulatedLike({ ...cornersOf(places), sizes: [6] }, plain), undefined);
});
