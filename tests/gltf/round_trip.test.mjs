// Read, give uv, write, and read back with somebody else's reader: nothing else has changed. Over
// every readable file of the optional data and over generated files with every feature.

import assert from 'node:assert/strict';
import { cpSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { openFile } from './container.mjs';
import { featureFiles, meshopt } from './features.mjs';
import { assertLaw } from './law.mjs';
import { hasMeshes, isWasm, meshes, runProbe, scratch } from './probe.mjs';

const cones = '{"format":"hgp-cones","version":1,"q":4,"cones":[{"vertex":1,"k":3}]}';
/** Refused by contract; everything else in the folder must be readable. */
const broken = ['IndexOutOfRange.gltf', 'invalid-buffer-index.gltf', 'BoxWithInfinites.glb'];
/** 593 thousand triangles, of which nothing is new but their number; under sanitizers ten seconds. */
const large = 'cave.glb';
/** Without --full only one kind of map each. */
const plain = ['DenseSphere.glb', 'perf.glb'];
const isFull = process.env.HGP_FULL === '1';
/** Without a decoder of its own, a build says so; the package brings decoders along. */
const needsDecoder = (result) => isWasm && result.code === 'unsupported';

const folder = path.join(scratch, 'written');
mkdirSync(folder, { recursive: true });

async function holdsLaw(file, { target = 0, surface = 0, map, set, extra = {} }) {
  const out = path.join(folder, `${map}-${set ?? 'next'}-${path.basename(file)}`);
  const args = ['--write', out, '--map', map, '--surface', `${surface}`, '--cones', cones];
  if (set !== undefined) args.push('--set', `${set}`);
  const [result] = runProbe([...args, file]);
  if (needsDecoder(result)) return null;
  assert.equal(result.ok, true, JSON.stringify(result));
  assert.equal(result.sameSurface, true, 'read back, the surface is the same');
  assert.equal(result.sameUv, true, 'read back, the uv are those that were given');
  assert.equal(result.stable, true, 'rounding twice is rounding once');
  const written = set ?? result.set;
  const lostExtensions = ['KHR_draco_mesh_compression'];
  const files = await assertLaw(file, out, { target, set: written, lostExtensions, ...extra });
  return { ...result, ...files };
}

const shared = hasMeshes
  ? readdirSync(path.join(meshes, 'gltf'), { recursive: true })
      .filter((name) => /\.(glb|gltf)$/.test(name) && !broken.includes(path.basename(name)))
      .filter((name) => isFull || name !== large)
      .sort()
  : [];

test('optional data', { skip: hasMeshes ? false : `${meshes} is not there` }, () => {
  assert.ok(shared.length >= 10);
});

function mapsOf(name) {
  if (name === large) return ['patches'];
  return plain.includes(name) && !isFull ? ['corners'] : ['vertices', 'patches', 'corners'];
}

for (const name of shared) {
  for (const map of mapsOf(name)) {
    test(`${name}, ${map}`, async () => {
      // Next to copies of its companions, as a person would have it.
      const from = path.join(meshes, 'gltf', name);
      if (name.includes('/')) cpSync(path.dirname(from), folder, { recursive: true });
      const file = name.includes('/') ? path.join(folder, path.basename(name)) : from;
      await holdsLaw(file, { map });
    });
  }
}

for (const { name, files, cases } of await featureFiles()) {
  for (const [file, bytes] of Object.entries(files)) writeFileSync(path.join(folder, file), bytes);
  for (const options of cases) {
    test(`${name}: ${options.map}${options.set === undefined ? '' : ` set ${options.set}`}`, async () => {
      const main = path.join(folder, Object.keys(files)[0]);
      const result = await holdsLaw(main, options);
      if (result !== null) options.check?.(result.after, result.notes);
    });
  }
}

test('bounds are numbers even where positions are not, so that the written file can be read', async () => {
  const file = path.join(folder, 'infinite.glb');
  const infinite = (position) => position.set([Infinity, -Infinity, NaN], 3);
  writeFileSync(file, await meshopt(infinite));
  const out = path.join(folder, 'bounds.glb');
  const [result] = runProbe(['--write', out, '--map', 'corners', file]);
  if (needsDecoder(result)) return;
  assert.equal(result.ok, true, JSON.stringify(result));
  const json = JSON.parse(openFile(readFileSync(out)).text);
  const { min, max } = json.accessors[json.meshes[0].primitives[0].attributes.POSITION];
  assert.ok([...min, ...max].every(Number.isFinite), `${min} … ${max}`);
});
