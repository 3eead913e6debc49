// A page that runs the example of the package's README, for the tests of bundlers and frameworks.

import assert from 'node:assert/strict';
import { gzipSync } from 'node:zlib';
import { featureFiles } from '../gltf/features.mjs';
import { bumpyDisk } from '../support/disk.mjs';
import { cubeMesh, toGlb } from '../support/meshes.mjs';
import { example } from './project.mjs';

/** The example of the README with more behind it; says in the title what came of it. */
export const page = (program) => `
const fetchFile = async (name) => new File([await (await fetch(name)).arrayBuffer()], name);
const file = await fetchFile('cube.glb');
${program}
const counts = [certificate.certified, uv.length > 0, cornerToUv.length, bytes.length > 0, name];
for (const other of ['draco.glb', 'meshopt.glb']) {
  counts.push((await client.load(await fetchFile(other))).info.triangles > 0);
}
// Cancelled in the middle, and alive afterwards.
const stop = new AbortController();
const large = await client.load(await fetchFile('large.obj.gz'));
const onProgress = () => stop.abort();
counts.push(await large.parametrize({}, { signal: stop.signal, onProgress }).catch((e) => e.name));
counts.push((await large.inspect()).triangles);
client.terminate();
document.title = JSON.stringify(counts);`;
/** What the page then says. */
const expected = [true, true, 3 * 12 * 36, true, 'cube.glb', true, true, 'AbortError', 15000];
export const html = '<!doctype html><script type="module" src="./main.js"></script>';
export const plainExample = example('In a browser');

/** What the page fetches, beside it. */
export async function putAssets(put, folder) {
  put(`${folder}/cube.glb`, toGlb([cubeMesh(6)]));
  put(`${folder}/large.obj.gz`, gzipSync(bumpyDisk(50)));
  for (const { name, files } of await featureFiles()) {
    if (/^(draco|meshopt)$/i.test(name)) {
      put(`${folder}/${name.toLowerCase()}.glb`, Object.values(files)[0]);
    }
  }
}

/** The page ran, and nothing went wrong. */
export function ran({ title, trouble }) {
  assert.deepEqual(trouble, []);
  assert.deepEqual(JSON.parse(title), expected);
}
