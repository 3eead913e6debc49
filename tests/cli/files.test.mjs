// Files as people have them, through the command line: packed, lenient, broken in optional parts.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import test, { after } from 'node:test';
import { gzipSync } from 'node:zlib';
import { cubeMesh, toGlb } from '../support/meshes.mjs';

const hgp =
  process.env.HGP_BIN ?? path.join(import.meta.dirname, '../../build/native-release/bin/hgp');
const folder = mkdtempSync(path.join(os.tmpdir(), 'hgp-files-'));
after(() => rmSync(folder, { recursive: true }));

const at = (name) => path.join(folder, name);
const put = (name, content) => {
  writeFileSync(at(name), content);
  return at(name);
};

function run(args, options = {}) {
  const result = spawnSync(hgp, args, { encoding: 'utf8', cwd: folder, ...options });
  return { code: result.status, out: result.stdout, err: result.stderr };
}

/** An octahedron as OBJ text. */
const octahedron = `v 1 0 0\nv 0 1 0\nv 0 0 1\nv -1 0 0\nv 0 -1 0\nv 0 0 -1\n${[
  [1, 2, 3],
  [2, 4, 3],
  [4, 5, 3],
  [5, 1, 3],
  [2, 1, 6],
  [4, 2, 6],
  [5, 4, 6],
  [1, 5, 6],
]
  .map((t) => `f ${t.join(' ')}\n`)
  .join('')}`;

test('every member of a gzip file is read, zeros between and rubbish behind them included', () => {
  const lines = octahedron.split('\n');
  const third = Math.ceil(lines.length / 3);
  const parts = [0, 1, 2].map((k) =>
    gzipSync(`${lines.slice(k * third, (k + 1) * third).join('\n')}\n`),
  );
  const files = {
    'parts.obj.gz': parts,
    'zeros.obj.gz': [parts[0], Buffer.alloc(7), parts[1], parts[2], Buffer.alloc(512)],
    'rubbish.obj.gz': [...parts, Buffer.from('rubbish')],
  };
  for (const [name, members] of Object.entries(files)) {
    const packed = Buffer.concat(members);
    const { code, out } = run(['inspect', put(name, packed), '--json', '-']);
    assert.equal(code, 0, name);
    assert.equal(JSON.parse(out).triangles, 8, name);
    assert.equal(/7 bytes behind the gzip data/.test(out), name === 'rubbish.obj.gz', out);
    const piped = run(['inspect', '-', '--format', 'obj', '--json', '-'], { input: packed });
    assert.equal(JSON.parse(piped.out).triangles, 8, name);
  }
  const cut = run(['inspect', put('cut.obj.gz', Buffer.concat(parts).subarray(0, -9))]);
  assert.equal(cut.code, 3);
  assert.match(cut.err, /damaged or cut off/);
});

test('a small file that unpacks to gigabytes is refused before it has', () => {
  const bomb = put('bomb.obj.gz', gzipSync(Buffer.alloc(700e6), { level: 9 }));
  // So little memory that holding what it unpacks to is out of the question.
  const script = 'ulimit -v 450000; exec "$0" inspect "$1"';
  const { status, stderr } = spawnSync('/bin/bash', ['-c', script, hgp, bomb]);
  assert.equal(status, 8, String(stderr));
  assert.match(String(stderr), /unpack to more than \d+; where that is right, unpack the file/);
  assert.equal(run(['inspect', bomb, '--max-bytes', '1000']).code, 8);
});

/** Spheres of a hundred sizes and some flat, thin ones: float32 in one row is too coarse for them. */
function manySpheres(count) {
  const vertices = [];
  const triangles = [];
  for (let c = 0; c < count; c++) {
    const { vertices: points, triangles: faces } = cubeMesh(2 + (c % 3));
    const size = 10 ** ((c % 7) - 3);
    const first = vertices.length;
    points.forEach(([x, y, z]) =>
      vertices.push([
        size * (x + 3.017 * c),
        size * (y + 0.0131 * c),
        size * z * (c % 5 ? 1 : 1e-3),
      ]),
    );
    faces.forEach((t) => triangles.push(t.map((v) => v + first)));
  }
  return { vertices, triangles };
}

test('of many components in float32 every one keeps its certificate', () => {
  writeFileSync(at('spheres.glb'), toGlb([manySpheres(120)]));
  const { code, err, out } = run(['param', 'spheres.glb', '-o', 'many.glb', '--json', '-']);
  assert.equal(code, 0, err);
  const { components, certified } = JSON.parse(out).certificate;
  assert.equal(components.length, 120);
  assert.ok(certified);
  assert.equal(run(['verify', 'many.glb']).code, 0);
  // What is told of them fits a screen.
  const told = run(['param', 'spheres.glb', '-o', 'many.glb']).err.split('\n');
  assert.ok(told.length < 150, `${told.length} lines`);
});

test('what a component costs does not grow with their number', () => {
  const seconds = [500, 4000].map((count) => {
    const lines = [];
    for (let c = 0; c < count; c++) {
      const [vertices, faces] = octahedron.split(/(?=f 1 2 3)/);
      lines.push(vertices.replaceAll(/v (\S+)/g, (_, x) => `v ${Number(x) + 3 * c}`));
      lines.push(faces.replaceAll(/\d+/g, (v) => Number(v) + 6 * c));
    }
    put('row.obj', lines.join(''));
    // Twice, as others use the machine, too; user time of the program alone.
    const times = [0, 1].map(() => {
      const args = ['param', 'row.obj', '-o', 'row_out.obj', '--quiet'];
      const timed = spawnSync('/bin/bash', ['-c', 'TIMEFORMAT=%U; time "$0" "$@"', hgp, ...args], {
        cwd: folder,
      });
      assert.equal(timed.status, 0);
      return Number(String(timed.stderr).trim());
    });
    return Math.min(...times);
  });
  // Eight times the components: quadratic cost would be 64 times the time.
  assert.ok(seconds[1] < 16 * (seconds[0] + 0.02), seconds.join(' and '));
});

test('broken c and sm lines are noted where cones are automatic, refused where asked for', () => {
  put('ball.obj', octahedron);
  const broken = put('broken.obj', `${octahedron}c 1 1.23456\nsm 1 1 x\n`);
  const { code, out, err } = run(['param', broken, '-o', 'out.obj', '--json', '-']);
  assert.equal(code, 0, err);
  assert.match(out, /cones stored in the file are not used: line \d+: c\/sm/);
  const asked = run(['param', 'ball.obj', '-o', 'out.obj', '--cones', broken]);
  assert.equal(asked.code, 3, asked.err);
});
