// `npx hgp` is the native command line: the same words, exit codes and bytes. Only with --full, because compiling it takes
// as long as the whole module.

import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import test from 'node:test';
import { gzipSync } from 'node:zlib';
import { blocks, eight, ring } from '../support/blocks.mjs';
import { cubeMesh, toGlb, toGltf, toObj, toOff, toPly, toStl } from '../support/meshes.mjs';
import { hgp } from '../support/program.mjs';
import { missingFiles } from './project.mjs';

const root = path.resolve(import.meta.dirname, '../..');
const isFull = process.env.HGP_FULL === '1';
const folder = mkdtempSync(path.join(os.tmpdir(), 'hgp-npx-'));
const at = (name) => path.join(folder, name);
let installed;

/** Installs the package with the command line as a user would, once. */
function program() {
  if (installed) return installed;
  const more = { cwd: root, stdio: 'pipe', encoding: 'utf8' };
  execFileSync(
    'cmake',
    ['--build', '--preset', 'wasm-release', '--target', 'hgp_package_with_cli'],
    more,
  );
  const packed = execFileSync(
    'npm',
    ['pack', '--silent', path.join(root, 'build/package-with-cli')],
    {
      ...more,
      cwd: folder,
    },
  );
  writeFileSync(at('package.json'), '{ "private": true }');
  execFileSync('npm', ['install', '--silent', '--offline', `./${packed.trim()}`], {
    ...more,
    cwd: folder,
  });
  installed = at('node_modules/.bin/hgp');
  return installed;
}

const run = (command, words, options = {}) => {
  const { status, stdout, stderr } = spawnSync(command, words, {
    cwd: folder,
    encoding: 'utf8',
    maxBuffer: 1 << 28,
    ...options,
  });
  return { status, stdout, stderr };
};
const both = (words, options) => [run(program(), words, options), run(hgp, words, options)];
const same = (words, options) => {
  const [ours, native] = both(words, options);
  assert.deepEqual(ours, native, words.join(' '));
  return ours;
};

const { json, bin } = toGltf([cubeMesh(4)], { buffer: 'side.bin' });
const files = {
  'cube.obj': toObj(cubeMesh(5)),
  'ring.off': toOff(blocks(ring, { n: 3 })),
  'eight.ply': toPly(blocks(eight, { n: 2 })),
  'cube.stl': toStl(cubeMesh(4)),
  'two.glb': toGlb([cubeMesh(4), blocks(ring, { n: 2 })]),
  'side.gltf': JSON.stringify(json),
  'side.bin': bin,
  'packed.obj.gz': gzipSync(toObj(cubeMesh(5))),
  'damaged.obj.gz': gzipSync(toObj(cubeMesh(5))).subarray(0, 400),
  'broken.obj': 'v 0 0 0\nf 1 2 3\n',
};

const theTests = async (t) => {
  for (const [name, content] of Object.entries(files)) writeFileSync(at(name), content);

  await t.test('every file that package.json names is there, packed and installed', () => {
    program();
    assert.deepEqual(missingFiles(path.join(root, 'build/package-with-cli')), []);
    assert.deepEqual(missingFiles(at('node_modules/hgp')), []);
  });

  await t.test('version, help and errors of usage are the same', () => {
    same(['--version']);
    for (const command of ['inspect', 'check', 'cones', 'param', 'quads', 'verify'])
      same([command, '--help']);
    assert.equal(same(['param', 'cube.obj']).status, 2);
    assert.equal(same(['parm', 'cube.obj']).status, 2);
    assert.equal(same(['param', 'cube.obj', '-o', 'x.obj', '--qality']).status, 2);
    assert.equal(same(['completion', 'bash']).status, 0);
  });

  await t.test('exit codes are the same', () => {
    assert.equal(same(['inspect', 'missing.obj']).status, 3);
    assert.equal(same(['inspect', 'broken.obj']).status, 3);
    assert.equal(same(['check', 'cube.obj', '--cone', '0:3']).status, 5);
    assert.equal(same(['verify', 'cube.obj']).status, 4);
    assert.equal(same(['inspect', 'cube.obj', '--max-triangles', '10']).status, 8);
    assert.equal(run(program(), ['inspect', 'damaged.obj.gz']).status, 3);
    assert.equal(run(hgp, ['inspect', 'damaged.obj.gz']).status, 3);
    const quick = ['param', 'cube.obj', '-o', 'x.obj', '--time-limit', '1e-9', '--quiet'];
    assert.equal(same(quick).status, 6);
    assert.equal(same(['param', 'cube.obj', '-o', 'no/folder/x.obj', '--quiet']).status, 7);
  });

  const maps = [
    ['cube.obj', 'x.obj'],
    ['cube.obj', 'x.glb', '--improve', 'isometric'],
    ['ring.off', 'x.obj', '--q', '6'],
    ['eight.ply', 'x.ply', '--cells', '300', '--grid-mode', 'quad'],
    ['cube.stl', 'x.glb'],
    ['two.glb', 'x.glb'],
    ['packed.obj.gz', 'x.obj'],
    ['side.gltf', 'x.gltf', '--embed'],
    ['side.gltf', 'x.glb', '--embed-cones'],
  ];
  for (const [input, output, ...words] of maps) {
    await t.test(`the same bytes: ${input} ${output} ${words.join(' ')}`, () => {
      const name = (which) => `${which}-${output}`;
      for (const [which, command] of [
        ['a', program()],
        ['b', hgp],
      ]) {
        const asked = ['param', input, '-o', name(which), '--reproducible', '--quiet', ...words];
        const { status, stderr } = run(command, asked);
        assert.equal(status, 0, stderr);
      }
      assert.deepEqual(readFileSync(at(name('a'))), readFileSync(at(name('b'))));
    });
  }

  await t.test('compressed glTF is read, by the decoders of the package', () => {
    const compress = ['param', 'two.glb', '-o', 'meshopt.glb', '--compress', '--quiet'];
    assert.equal(run(hgp, compress).status, 0);
    assert.equal(same(['verify', 'meshopt.glb']).status, 0);
  });

  await t.test('standard input and output', () => {
    const input = files['cube.obj'];
    const words = ['param', '-', '-o', '-', '--reproducible', '--quiet'];
    assert.match(same(words, { input }).stdout, /^vt /m);
  });

  rmSync(folder, { recursive: true });
};

if (isFull) test('npx hgp', theTests);
