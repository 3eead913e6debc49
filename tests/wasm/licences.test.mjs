// Everything that is part of the npm package is in THIRD_PARTY_LICENSES.txt, which is part of it, too.

import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { components, headersOf, packagesOf, unlisted } from '../support/compiled.mjs';
import { built, root } from './support.mjs';

const build = path.join(root, 'build/wasm-release');
const listed = components.filter(({ parts }) => parts.includes('npm'));

test('every header that is compiled into hgp.wasm is of a listed work', () => {
  const packages = packagesOf(headersOf(build, /^(core|wasm)\//));
  assert.ok(packages.has('libeigen3-dev') && packages.has('emscripten'), [...packages.keys()]);
  assert.deepEqual(unlisted(packages, ['npm']), {});
});

test('every decoder is of a listed work', () => {
  const sources = {
    'draco_decoder.js': 'draco3dgltf',
    'draco_decoder.wasm': 'draco3dgltf',
    'fflate.js': 'fflate',
    'meshopt_decoder.js': 'meshoptimizer',
  };
  assert.deepEqual(readdirSync(path.join(built, 'decoders')).sort(), Object.keys(sources).sort());
  for (const name of Object.values(sources))
    assert.ok(
      listed.some(({ source }) => source === `npm:${name}`),
      name,
    );
});

test('the package has the licences, with an entry for each of its works', () => {
  const text = readFileSync(path.join(built, 'THIRD_PARTY_LICENSES.txt'), 'utf8');
  assert.equal(text, readFileSync(path.join(root, 'THIRD_PARTY_LICENSES.txt'), 'utf8'));
  for (const { name, licence } of listed)
    assert.ok(text.includes(`\n${name} (${licence})\nIn: `), name);
});
