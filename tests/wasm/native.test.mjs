// The package and the native command line come to the same result: the same cones, the same verdict,
// the same distortion, and the same texture coordinates, on meshes of every kind.

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

function runNative(main, { cones, q, boundary }, out) {
  const report = `${out}.json`;
  const args = ['param', main, '-o', out, '--json', report, '--force', '--quiet'];
  if (cones) {
    const text = JSON.stringify({ format: 'hgp-cones', version: 1, ...cones });
    writeFileSync(`${out}.cones.json`, text);
    args.push('--cones', `${out}.cones.json`);
  }
  if (q) args.push('--q', `${q}`);
  if (boundary) args.push('--boundary', boundary);
  const { status, stderr } = spawnSync(native, args, { encoding: 'utf8', cwd: folder });
  assert.equal(status, 0, stderr);
  const files = [out];
  if (out.endsWith('.gltf')) {
    const { buffers } = JSON.parse(readFileSync(out, 'utf8'));
    files.push(...buffers.map(({ uri }) => path.join(folder, uri)));
  }
  return {
    report: JSON.parse(readFileSync(report, 'utf8')),
    files: files.map((name) => ({
      name: path.basename(name),
      bytes: new Uint8Array(readFileSync(name)),
    })),
  };
}

/** The texture coordinates of every corner of an OBJ, or of every vertex of a glTF's first mesh. */
function mapOf(name, files) {
  const main = files[0].bytes;
  if (name.endsWith('.obj')) {
    const lines = new TextDecoder().decode(main).split('\n');
    const rows = (word) =>
      lines.filter((l) => l.startsWith(`${word} `)).map((l) => l.trim().split(/\s+/).slice(1));
    const uv = rows('vt').map((row) => row.map(Number));
    const corners = rows('f').flat();
    return {
      uv: corners.flatMap((corner) => uv[corner.split('/')[1] - 1]),
      corners: corners.map((corner) => corner.split('/')[0]),
    };
  }
  const isBinary = name.endsWith('.glb');
  const view = new DataView(main.buffer, main.byteOffset, main.length);
  const size = isBinary ? view.getUint32(12, true) : 0;
  const json = JSON.parse(new TextDecoder().decode(isBinary ? main.subarray(20, 20 + size) : main));
  const bufferOf = (view) =>
    isBinary
      ? main.subarray(28 + size)
      : files.find(({ name: file }) => file === json.buffers[view.buffer].uri).bytes;
  const read = (index, Type) => {
    const { bufferView, byteOffset = 0, count, type } = json.accessors[index];
    const start = (json.bufferViews[bufferView].byteOffset ?? 0) + byteOffset;
    const bin = bufferOf(json.bufferViews[bufferView]);
    const width = { SCALAR: 1, VEC2: 2 }[type] * Type.BYTES_PER_ELEMENT * count;
    return [...new Type(bin.slice(start, start + width).buffer)];
  };
  const { attributes, indices } = json.meshes[0].primitives[0];
  const { TEXCOORD_0, TEXCOORD_1 } = attributes;
  return {
    uv: read(TEXCOORD_1 ?? TEXCOORD_0, Float32Array),
    corners: indices === undefined ? [] : json.accessors[indices].count,
  };
}

/** The counts of a certificate and everything in words. Which place is worst may be a draw. */
const integers = (certificate) =>
  JSON.parse(
    JSON.stringify(certificate, (key, x) => {
      if (/^worst|^smallest|^distortion$/.test(key)) return undefined;
      return typeof x === 'number' && !Number.isInteger(x) ? 0 : x;
    }),
  );

function assertNear(a, b, relative, what) {
  assert.equal(a.length, b.length, what);
  const size = Math.max(1, ...b.map(Math.abs));
  let worst = 0;
  a.forEach((x, i) => (worst = Math.max(worst, Math.abs(x - b[i]))));
  assert.ok(worst <= relative * size, `${what}: they differ by ${worst / size}`);
}

const distortions = ({ components }) =>
  components.flatMap(({ distortion: d }) => [d.meanMu, d.p95Mu, d.maxMu, d.rmsLogArea]);

const core = await createCore();
const hasNative = existsSync(native);
if (!hasNative) console.log(`SKIPPING comparison with the native program: ${native} is not there`);

for (const [what, files, options] of cases) {
  test(what, { skip: hasNative ? false : 'no native program' }, () => {
    const names = Object.keys(files);
    for (const name of names) writeFileSync(path.join(folder, name), files[name]);
    const map = new Map(names.map((name) => [name, toBytes(files[name])]));
    core.load({ main: names[0], files: map });
    const result = core.parametrize(options);
    const written = core.write();

    const out = path.join(folder, `native-${written.name}`);
    const other = runNative(names[0], options, out);
    assert.equal(result.certificate.certified, true);
    for (const { certified } of [result.report, other.report, other.report.certificate])
      assert.equal(certified, result.certificate.certified);
    assert.deepEqual(result.cones.cones, other.report.cones.cones);
    assert.deepEqual(result.cones.boundaries, other.report.cones.boundaries);
    assert.deepEqual(result.cones.handles, other.report.cones.handles);
    assert.deepEqual(integers(result.certificate), integers(other.report.certificate));
    assertNear(distortions(result.certificate), distortions(other.report.certificate), 1e-6, 'μ');

    const ours = mapOf(written.name, written.files);
    const theirs = mapOf(written.name, other.files);
    assert.deepEqual(ours.corners, theirs.corners);
    const isFloat = /\.gl(b|tf)$/.test(written.name);
    // What docs/cli.md promises; measured are at most 3.4e-13, and one step of a float.
    const tolerance = isFloat ? 2.4e-7 : 1e-11;
    assertNear(ours.uv, theirs.uv, tolerance, 'uv');
  });
}

function toBytes(content) {
  return typeof content === 'string' ? bytesOf(content) : new Uint8Array(content);
}

test('there are at least ten kinds', () => assert.ok(cases.length >= 10));
