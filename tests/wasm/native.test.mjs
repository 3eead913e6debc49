// What `--reproducible` promises: the package (clang, its C library, WebAssembly) and the native command line
// (another compiler, another C library) write the same bytes and say the same, on meshes of every kind.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { beside, blocks, eight, ring } from '../support/blocks.mjs';
import { bumpyDisk } from '../support/disk.mjs';
import { cubeMesh, toGlb, toGltf, toObj, toOff, toPly, toStl } from '../support/meshes.mjs';
import { bytesOf, createCore, hasShared, native, scratch, shared } from './support.mjs';

const folder = scratch('native');
const eightCones = {
  q: 4,
  cones: [0, 1, 2, 3, 4, 5, 6, 7].map((vertex) => ({ vertex, k: 3 })),
};
const cut = ['0 0 +z', '2 2 -z'];

function sideFiles() {
  const { json, bin } = toGltf([cubeMesh(4)], { buffer: 'side.bin' });
  return { 'side.gltf': JSON.stringify(json), 'side.bin': bin };
}

/** Without symmetries: which of equally good cones is chosen depends on rounding, and so on the processor. */
const skew = ({ vertices, triangles }) => ({
  vertices: vertices.map(([x, y, z]) => [1.3 * x + 0.2 * y * z, 0.9 * y + 0.1 * x * x, z + 0.15 * x * y]), // prettier-ignore
  triangles,
});
/** [what it is, files with the main one first, options of both programs] */
const cases = [
  ['sphere, OBJ', { 'cube.obj': toObj(cubeMesh(6)) }, { q: 4 }],
  ['sphere with given cones, OFF', { 'cube.off': toOff(cubeMesh(6)) }, { cones: eightCones }],
  ['sphere, PLY, q = 6', { 'cube.ply': toPly(cubeMesh(5)) }, { q: 6 }],
  ['sphere, STL, q = 3', { 'cube.stl': toStl(cubeMesh(5)) }, { q: 3 }],
  ['sphere, GLB, q = 2', { 'cube.glb': toGlb([cubeMesh(5)]) }, { q: 2 }],
  ['sphere, glTF with a side file', sideFiles(), { q: 4 }],
  ['genus 1, OBJ', { 'ring.obj': toObj(blocks(ring, { n: 3 })) }, { q: 4 }],
  ['genus 1, GLB, q = 6', { 'ring.glb': toGlb([blocks(ring, { n: 3 })]) }, { q: 6 }],
  ['genus 2, OBJ', { 'eight.obj': toObj(blocks(eight, { n: 3 })) }, { q: 4 }],
  ['genus 2, GLB', { 'eight.glb': toGlb([blocks(eight, { n: 2 })]) }, { q: 4 }],
  [
    'genus 1 with two boundaries',
    { 'cut.obj': toObj(blocks(ring, { n: 3, open: cut })) },
    { q: 4 },
  ],
  [
    'annulus',
    { 'tube.ply': toPly(blocks(['##'], { n: 3, open: ['0 0 -x', '1 0 +x'] })) },
    { q: 4 },
  ],
  ['disk, q = 6', { 'disk.obj': bumpyDisk(8) }, { q: 6 }],
  ['disk, q = 8', { 'disk8.obj': bumpyDisk(8) }, { q: 8 }],
  ['disk onto a polygon', { 'flat.obj': bumpyDisk(10) }, { boundary: 'convex' }],
  ['two components', { 'two.obj': toObj(beside(cubeMesh(4), blocks(ring))) }, { q: 4 }],
  ['improved', { 'bump.obj': bumpyDisk(10) }, { q: 4, improve: 'isometric' }],
  ['improved angles', { 'angles.obj': toObj(blocks(eight, { n: 3 })) }, { improve: -0.7 }],
  ['aligned', { 'grid.obj': toObj(blocks(ring, { n: 4 })) }, { q: 4, grid: { cells: 400 } }],
  [
    'aligned, GLB',
    { 'grid.glb': toGlb([cubeMesh(8)]) },
    { q: 4, grid: { cells: 600, mode: 'quad' } },
  ],
  ['hard constraints', { 'hard.obj': toObj(blocks(eight, { n: 3 })) }, { method: 'harmonic' }],
  ['few cones', { 'few.obj': toObj(skew(cubeMesh(9))) }, { q: 4, conesFor: 'few' }],
  ['low distortion', { 'low.obj': toObj(blocks(ring)) }, { conesFor: 'low-distortion' }],
];
const real = [
  'gltf/torus.glb',
  'Directional/vase.off',
  'odedstein-meshes/spot_low_resolution.obj',
  'geometry-central/bob_small.ply',
  'OptCuts/torus_with_holes.obj',
  'BFF/teapot.obj',
];
if (hasShared) {
  for (const name of real) {
    const files = { [path.basename(name)]: readFileSync(path.join(shared, name)) };
    cases.push([name, files, { q: 4 }]);
  }
}

/** The options of the package as those of the command line. */
const flags = {
  q: 'q',
  boundary: 'boundary',
  improve: 'improve',
  method: 'method',
  conesFor: 'cones-for',
};

function runNative(main, { cones, grid, ...options }, out, more = []) {
  const report = `${out}.json`;
  const args = ['param', main, '-o', out, '--json', report, '--force', '--quiet', ...more];
  if (cones) {
    const text = JSON.stringify({ format: 'hgp-cones', version: 1, ...cones });
    writeFileSync(`${out}.cones.json`, text);
    args.push('--cones', `${out}.cones.json`);
  }
  if (grid) args.push(`--cells=${grid.cells}`, `--grid-mode=${grid.mode ?? 'tile'}`);
  for (const [name, value] of Object.entries(options)) args.push(`--${flags[name]}=${value}`);
  const { status, stderr } = spawnSync(native, args, { encoding: 'utf8', cwd: folder });
  assert.equal(status, 0, stderr);
  return JSON.parse(readFileSync(report, 'utf8'));
}

/** The texture coordinates of an OBJ, in the order of the file. */
const uvOf = (bytes) =>
  new TextDecoder()
    .decode(bytes)
    .split('\n')
    .filter((line) => line.startsWith('vt '))
    .flatMap((line) => line.slice(3).trim().split(/\s+/).map(Number));

/** What docs/cli.md says of maps without --reproducible. */
function assertNear(a, b, relative) {
  assert.equal(a.length, b.length);
  const size = Math.max(1, ...b.map(Math.abs));
  const worst = Math.max(...a.map((x, i) => Math.abs(x - b[i]))) / size;
  assert.ok(worst <= relative, `they differ by ${worst}`);
}

const core = await createCore();
const hasNative = existsSync(native);
if (!hasNative) console.log(`SKIPPING comparison with the native program: ${native} is not there`);

for (const [what, files, options] of cases) {
  test(what, { skip: hasNative ? false : 'no native program' }, () => {
    const names = Object.keys(files);
    const put = () => names.forEach((name) => writeFileSync(path.join(folder, name), files[name]));
    put();
    const map = new Map(names.map((name) => [name, toBytes(files[name])]));
    const model = core.load({ main: names[0], files: map });
    const result = model.parametrize(options);
    const written = result.write();
    model.free();

    const report = runNative(names[0], options, path.join(folder, written.name), [
      '--reproducible',
    ]);
    assert.equal(result.certificate.certified, true);
    assert.deepEqual(report.certificate, result.certificate);
    assert.deepEqual(report.cones, result.cones);
    for (const { name, bytes } of written.files)
      assert.ok(readFileSync(path.join(folder, name)).equals(bytes), `${name}: other bytes`);

    if (!written.name.endsWith('.obj')) return;
    // The kernels of this processor, which may fuse: the same cones and verdict, and nearly the same map.
    put(); // the run above took its place
    const fast = path.join(folder, `fast-${written.name}`);
    const other = runNative(names[0], options, fast);
    assert.equal(other.certificate.certified, true);
    assert.deepEqual(other.cones, report.cones);
    // Least squares with a weak tie-break are conditioned worse than exact rows.
    const isExact = report.components.every(({ rounds }) =>
      rounds.every(({ method }) => !method.startsWith('hard constraints')),
    );
    assertNear(uvOf(readFileSync(fast)), uvOf(written.files[0].bytes), isExact ? 1e-11 : 1e-8);
  });
}

function toBytes(content) {
  return typeof content === 'string' ? bytesOf(content) : new Uint8Array(content);
}

test('at least ten kinds of input are compared', () => assert.ok(cases.length >= 10));
