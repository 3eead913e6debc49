// What the page reads back from a written file, with readers of its own, is the map that was certified: for files
// as programs write them. A reader that understands less would call a good map not certified.

import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { compareWithFile } from '../../../web/src/services/geometry/analyse.ts';
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
