// node run.mjs PROGRAM SCRATCH: fuzzes for a few seconds, or five minutes under HGP_FULL. The
// corpus is made of the generated files of tests/gltf and of small texts.

import { spawnSync } from 'node:child_process';
import { mkdirSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { featureFiles, manifoldWithoutPlace } from '../gltf/features.mjs';
import { harmlessFiles, hostileFiles } from '../gltf/hostile_files.mjs';

const [program, scratch] = process.argv.slice(2);
const seconds = process.env.HGP_FULL ? 300 : 2;
const target = path.basename(program).replace('fuzz_', '');
const here = path.dirname(fileURLToPath(import.meta.url));

/** A tetrahedron and a square in every other format, text and both byte orders. */
function formatSeeds() {
  const points = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1];
  const faces = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3];
  const header = (format, list) =>
    `ply\nformat ${format} 1.0\ncomment a\nelement vertex 4\nproperty float x\nproperty float y\n` +
    `property float z\nelement face 4\nproperty list uchar ${list} vertex_indices\nend_header\n`;
  const binary = (isLittle) => {
    const body = Buffer.alloc(4 * 12 + 4 * 13);
    const view = new DataView(body.buffer, body.byteOffset, body.length);
    points.forEach((x, i) => view.setFloat32(4 * i, x, isLittle));
    faces.forEach((v, i) => {
      const at = 48 + 13 * Math.floor(i / 3);
      view.setUint8(at, 3);
      view.setInt32(at + 1 + 4 * (i % 3), v, isLittle);
    });
    return Buffer.concat([
      Buffer.from(header(isLittle ? 'binary_little_endian' : 'binary_big_endian', 'int')),
      body,
    ]);
  };
  const stl = Buffer.alloc(84 + 50 * 4);
  stl.writeUInt32LE(4, 80);
  faces.forEach((v, i) => {
    for (let k = 0; k < 3; k++) {
      stl.writeFloatLE(points[3 * v + k], 84 + 50 * Math.floor(i / 3) + 12 + 12 * (i % 3) + 4 * k);
    }
  });
  const rows = (list) => list.map((x, i) => `${x}${i % 3 === 2 ? '\n' : ' '}`).join('');
  const counted = rows(faces).trim().replace(/^/gm, '3 ');
  const facet = (f) =>
    `facet normal 0 0 0\nouter loop\n${f.map((v) => `vertex ${points.slice(3 * v, 3 * v + 3).join(' ')}`).join('\n')}\nendloop\nendfacet\n`;
  const facets = [0, 3, 6, 9].map((i) => facet(faces.slice(i, i + 3))).join('');
  return [
    `OFF\n4 4 6\n${rows(points)}${counted}\n`,
    `COFF # colours\n4 1 0\n${rows(points).replace(/\n/g, ' 255 0 0 255\n')}4 0 1 2 3 0.5 0.5 0.5\n`,
    `STOFF\n1 0 0\n`,
    `${header('ascii', 'int')}${rows(points)}${counted}\n`,
    binary(true),
    binary(false),
    `solid a\n${facets}endsolid a\n`,
    stl,
  ];
}

const texts = {
  obj: [
    'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n',
    'mtllib a.mtl\ng a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf -3/1/1 -2/1/1 -1/1/1\n',
    'v 0 0 0\nv 1 0 0\nv 0 1 0 # end\nf 1 2 \\\n3\nl 1 2\nc 1 1.5\nsm 1 2 3\n',
  ],
  formats: formatSeeds(),
  cones: [
    '{"format":"hgp-cones","version":1,"q":4,"cones":[{"vertex":3,"k":3,"position":[0,1,2]}],"boundaries":[{"loop":0,"anchor":7,"l":4}],"handles":[{"generator":0,"r":1}]}',
    'q 4\ncones 2\n0 3\n5 5\nmatchings 1\n0 1 2 3 1\n',
    '4 2\n0 1\n7 -1\n',
    '0 1.5707963267948966\n4 -1.5707963267948966\n',
    '6.283185307179586\n4.71238898038469\n',
    '4 1\n1 0 0 0 1 0 -1 0 0 0 -1 0\n',
    '1\n4\n1 0 0\n',
  ],
};

/** Choices of fuzz_solve: any bytes are a surface. */
function choices() {
  let state = 1;
  const byte = () => (state = (state * 48271) % 2147483647) & 0xff;
  return Array.from({ length: 24 }, () => Uint8Array.from({ length: 160 }, byte));
}
texts.solve = choices();

async function seeds() {
  if (texts[target]) return texts[target].map((text, i) => [`seed${i}`, text]);
  const wanted = target === 'gltf' ? '.gltf' : '.glb';
  const files = [...hostileFiles(), ...harmlessFiles()].map(({ name, bytes }) => [name, bytes]);
  files.push(['manifold-nan.glb', manifoldWithoutPlace()]);
  for (const { files: made } of await featureFiles()) files.push(...Object.entries(made));
  return files.filter(([name, bytes]) => name.endsWith(wanted) && bytes.length < 100_000);
}

const [seedFolder, found] = ['seeds', 'found'].map((name) => path.join(scratch, target, name));
rmSync(path.join(scratch, target), { recursive: true, force: true });
for (const folder of [seedFolder, found]) mkdirSync(folder, { recursive: true });
for (const [name, bytes] of await seeds()) writeFileSync(path.join(seedFolder, name), bytes);

const ended = spawnSync(
  program,
  [
    found,
    seedFolder,
    `-max_total_time=${seconds}`,
    '-timeout=25',
    '-rss_limit_mb=3000',
    '-malloc_limit_mb=1000',
    `-max_len=${target === 'solve' ? 512 : 65536}`,
    '-print_final_stats=1',
    `-artifact_prefix=${path.join(scratch, target)}/`,
    ...(texts[target] ? [] : [`-dict=${path.join(here, 'gltf.dict')}`]),
  ],
  { stdio: 'inherit', timeout: (seconds + 120) * 1000 },
);
process.exit(ended.status ?? 1);
