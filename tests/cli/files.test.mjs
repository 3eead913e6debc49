// Files as people have them, through the command line: packed, lenient, broken in optional parts.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { gzipSync } from 'node:zlib';
import { NodeIO } from '@gltf-transform/core';
import { cubeMesh, toGlb, toGltf, toPly } from '../support/meshes.mjs';
import { problems } from './schema.mjs';
import { hgp, inFolder } from '../support/program.mjs';
import { sentenceOf } from '../support/notes.mjs';

const { at, put, run } = inFolder('files');

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

/** An icosahedron with two neighbours that ask for more than the triangles between them have. */
function crowdedIcosahedron() {
  const t = (1 + Math.sqrt(5)) / 2;
  const v = [];
  for (const a of [-1, 1]) {
    for (const b of [-t, t]) v.push([a, b, 0], [0, a, b], [b, 0, a]);
  }
  const isEdge = (i, j) => Math.abs(Math.hypot(...v[i].map((x, k) => x - v[j][k])) - 2) < 1e-9;
  const faces = [];
  for (let i = 0; i < 12; i++) {
    for (let j = i + 1; j < 12; j++) {
      for (let k = j + 1; k < 12; k++) {
        if (!isEdge(i, j) || !isEdge(j, k) || !isEdge(i, k)) continue;
        const [a, b, c] = [v[i], v[j], v[k]];
        const volume =
          a[0] * (b[1] * c[2] - b[2] * c[1]) -
          a[1] * (b[0] * c[2] - b[2] * c[0]) +
          a[2] * (b[0] * c[1] - b[1] * c[0]);
        faces.push(volume > 0 ? [i, j, k] : [i, k, j]);
      }
    }
  }
  const beside = v.findIndex((_, j) => j > 0 && isEdge(0, j));
  const others = v.map((_, j) => j).filter((j) => j > 0 && j !== beside);
  const cones = [`0:9`, `${beside}:9`, ...others.slice(0, 6).map((j) => `${j}:1`)];
  return { v, faces, cones: cones.flatMap((cone) => ['--cone', cone]) };
}

test('--refine maps and writes a finer mesh where the mesh as it is has no map', () => {
  const { v, faces, cones } = crowdedIcosahedron();
  const lines = [
    ...v.map((p) => `v ${p.join(' ')} 1 0 0\n`),
    'usemtl red\n',
    ...faces.map((f) => `f ${f.map((i) => i + 1).join(' ')}\n`),
  ];
  put('crowded.obj', lines.join(''));
  const asked = ['param', 'crowded.obj', '--q', '4', ...cones, '-o', 'finer.obj', '--json', '-'];
  const plain = run(asked);
  assert.equal(plain.code, 6, plain.err);
  assert.equal(existsSync(at('finer.obj')), false);
  const told = JSON.parse(plain.out).notes.map(({ code }) => code);
  assert.ok(told.includes('refine-offered'));
  // Where one method was asked for, others are the nearer way out.
  const one = JSON.parse(run([...asked, '--method', 'soft']).out).notes.map(({ code }) => code);
  assert.ok(one.includes('method-offered') && !one.includes('refine-offered'), one.join());

  const { code, out, err } = run([...asked, '--refine']);
  assert.equal(code, 0, err);
  const report = JSON.parse(out);
  assert.deepEqual(problems('hgp-report', report), []);
  assert.equal(report.input.triangles, 20);
  assert.equal(report.refined.vertices, 12 + report.refined.edges);
  assert.ok(report.notes.some(({ code }) => code === 'refined'));
  const text = readFileSync(at('finer.obj'), 'utf8').split('\n');
  assert.equal(text.filter((line) => /^v /.test(line)).length, report.refined.vertices);
  assert.equal(text.filter((line) => /^v .* 1 0 0$/.test(line)).length, report.refined.vertices);
  assert.equal(text.filter((line) => /^f /.test(line)).length, report.refined.triangles);
  const verified = run(['verify', 'finer.obj', '--q', '4', ...cones]);
  assert.equal(verified.code, 0, verified.out);

  // Without need nothing is split.
  const easy = run(['param', 'crowded.obj', '--refine', '-o', 'easy.obj', '--json', '-']);
  assert.equal(JSON.parse(easy.out).refined, null);
});

test('--refine keeps everything in a glTF or PLY, or says what it cannot keep', async () => {
  const { v, faces, cones } = crowdedIcosahedron();
  const mesh = { vertices: v, triangles: faces };
  const { json, bin } = toGltf([mesh], { image: 'pixel.png', uv: { 0: ([x, y]) => [x + 9, y] } });
  put('pixel.png', 'not really');
  put('cube.bin', bin);
  put('crowded.gltf', JSON.stringify(json));
  put('crowded.ply', toPly(mesh));
  const args = (input, output) => ['param', input, ...cones, '--q', '4', '--refine', '-o', output, '--json', '-']; // prettier-ignore
  for (const [input, output] of [
    ['crowded.gltf', 'finer.gltf'],
    ['crowded.gltf', 'finer.glb'],
    ['crowded.ply', 'finer.ply'],
    ['crowded.ply', 'finer_of_ply.obj'],
    ['crowded.gltf', 'finer_of_gltf.obj'],
  ]) {
    // prettier-ignore
    const { code, out, err } = run(args(input, output));
    assert.equal(code, 0, err);
    const { refined, notes } = JSON.parse(out);
    assert.ok(refined.triangles > 20, output);
    assert.ok(!notes.some((note) => note.code === 'split-as-polygons'), output);
    const verified = run(['verify', output, '--q', '4', ...cones, '--json', '-']);
    assert.equal(verified.code, 0, output);
    const seen = JSON.parse(run(['inspect', output, '--json', '-']).out);
    assert.equal(seen.triangles, refined.triangles, output);
  }
  const root = (await new NodeIO().read(at('finer.glb'))).getRoot();
  assert.deepEqual(root.getExtras(), json.extras);
  assert.equal(Buffer.from(root.listTextures()[0].getImage()).toString(), 'not really');
  const [primitive] = root.listMeshes()[0].listPrimitives();
  assert.notEqual(primitive.getMaterial(), null);
  assert.deepEqual(primitive.listSemantics().sort(), ['POSITION', 'TEXCOORD_0', 'TEXCOORD_1']);
  // The old coordinates are where the positions put them, on split edges as well.
  const [positions, old] = ['POSITION', 'TEXCOORD_0'].map((name) => primitive.getAttribute(name));
  for (let i = 0; i < positions.getCount(); i++) {
    const [x, y] = positions.getElement(i, []);
    const [s, t] = old.getElement(i, []);
    assert.ok(Math.abs(s - x - 9) < 1e-6 && Math.abs(t - y) < 1e-6, `${s} ${t} at ${x} ${y}`);
  }
  // Where repairs are written as well, the mesh alone is refined.
  const turned = toGltf([{ vertices: v, triangles: [[...faces[0]].reverse(), ...faces.slice(1)] }]);
  put('cube.bin', turned.bin);
  put('turned.gltf', JSON.stringify(turned.json));
  for (const output of ['alone.glb', 'alone.gltf']) {
    const { code, out, err } = run([...args('turned.gltf', output), '--write-repairs']);
    assert.equal(code, 0, err);
    assert.ok(
      JSON.parse(out).notes.some((note) => note.code === 'split-as-polygons'),
      output,
    );
    assert.equal(run(['verify', output, '--q', '4', ...cones]).code, 0, output);
  }
});

test('every member of a gzip file is read, also with zeros between and other bytes after them', () => {
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
    const ignored = JSON.parse(out).notes.find((one) => one.code === 'read-gzip-longer');
    assert.equal(ignored?.numbers.bytes, name === 'rubbish.obj.gz' ? 7 : undefined, out);
    const piped = run(['inspect', '-', '--format', 'obj', '--json', '-'], { input: packed });
    assert.equal(JSON.parse(piped.out).triangles, 8, name);
  }
  const cut = run(['inspect', put('cut.obj.gz', Buffer.concat(parts).subarray(0, -9))]);
  assert.equal(cut.code, 3);
  assert.match(cut.err, /damaged or cut off/);
});

test('a small file that would unpack to gigabytes is refused early', () => {
  const bomb = put('bomb.obj.gz', gzipSync(Buffer.alloc(700e6), { level: 9 }));
  // So little memory that holding what it unpacks to is out of the question.
  const within = (...args) =>
    spawnSync('/bin/bash', ['-c', 'ulimit -v 450000; exec "$0" "$@"', hgp, ...args]);
  // Under a sanitizer no program starts with so little; there, only the refusal is tested.
  const isLimited = within('--version').status === 0;
  if (!isLimited) console.log('# without a limit of memory: this build does not start with it');
  const { status, stderr } = isLimited
    ? within('inspect', bomb)
    : spawnSync(hgp, ['inspect', bomb]);
  assert.equal(status, 8, String(stderr));
  assert.match(String(stderr), /unpack to more than \d+; where that is right, unpack the file/);
  assert.equal(run(['inspect', bomb, '--max-bytes', '1000']).code, 8);
});

/** Every corner its own vertex, moved apart by about `gap`. */
function soup(gap) {
  const { vertices, triangles } = cubeMesh(3);
  const lines = triangles.flatMap((t, i) => [
    ...t.map(
      (v, k) => `v ${vertices[v].map((x, n) => x + gap * Math.sin(7 * i + 3 * k + n)).join(' ')}`,
    ),
    `f ${3 * i + 1} ${3 * i + 2} ${3 * i + 3}`,
  ]);
  return `${lines.join('\n')}\n`;
}

test('a triangle soup is joined, two halves get a note, a crack names the length that closes it', () => {
  const inspect = (name, ...options) => {
    const { out } = run(['inspect', name, ...options, '--json', '-']);
    const { components, notes } = JSON.parse(out);
    const note = (code) => notes.find((one) => one.code === code)?.numbers;
    return { components: components.length, note };
  };
  put('soup.obj', soup(0));
  const joined = inspect('soup.obj');
  assert.equal(joined.components, 1);
  assert.deepEqual(joined.note('weld-soup'), { vertices: 268, before: 108, after: 1 });
  assert.equal(inspect('soup.obj', '--weld', 'none').components, 108);
  assert.equal(inspect('soup.obj', '--strict').components, 108);
  assert.equal(run(['param', 'soup.obj', '-o', 'soup_out.obj']).code, 0);
  assert.equal(run(['verify', 'soup_out.obj']).code, 0);

  put('crack.obj', soup(1e-6));
  const cracked = inspect('crack.obj');
  assert.equal(cracked.components, 108);
  const { vertices, gap, weld } = cracked.note('crack');
  assert.equal(vertices, 324);
  assert.ok(gap > 1e-7 && gap < 4e-6 && weld > gap && weld < 2 * gap);
  assert.equal(inspect('crack.obj', '--weld', String(weld)).components, 1);
  assert.equal(inspect('crack.obj', '--strict').note('crack').vertices, 324);
  // The command line names the option with a length that works when typed.
  const [, typed] = /; --weld (\S+) closes it/.exec(run(['inspect', 'crack.obj']).out);
  assert.equal(inspect('crack.obj', '--weld', typed).components, 1);

  const halves = octahedron.replace(
    /f (4 2 6|5 4 6|1 5 6|2 1 6)/g,
    (_, t) =>
      `f ${t
        .split(' ')
        .map((v) => (v === '6' ? v : Number(v) + 6))
        .join(' ')}`,
  );
  const copies = 'v 1 0 0\nv 0 1 0\nv 9 9 9\nv -1 0 0\nv 0 -1 0\n';
  put('halves.obj', halves.replace('f', `${copies}f`));
  const apart = inspect('halves.obj');
  assert.equal(apart.components, 2);
  assert.deepEqual(apart.note('weld-would-join'), { vertices: 4, before: 2, after: 1 });

  put(
    'junction.obj',
    'v 0 0 0\nv 2 0 0\nv 1 2 0\nv 1 0 0\nv 0 -1 0\nv 2 -1 0\nf 1 2 3\nf 1 5 4\nf 4 6 2\n',
  );
  assert.ok(inspect('junction.obj').note('t-junctions').vertices > 1);
  // The same with strips that share no vertex, as strict reading refuses two that meet in one.
  put(
    'strips.obj',
    'v 0 0 0\nv 2 0 0\nv 1 2 0\nv 1 0 0\nv 0 -1 0\nv 2 -1 0\nv 0 0 0\nv 2 0 0\n' +
      'f 1 2 3\nf 7 5 4\nf 4 5 6\nf 4 6 8\n',
  );
  assert.equal(inspect('strips.obj', '--strict').note('t-junctions').vertices, 1);
});

test('advice never recommends an option that was given', () => {
  const band = Array.from({ length: 9 }, (_, i) => {
    const a = (2 * Math.PI * i) / 9;
    return [-0.3, 0.3].map((w) => {
      const r = 1 + w * Math.cos(a / 2);
      return `v ${r * Math.cos(a)} ${r * Math.sin(a)} ${w * Math.sin(a / 2)}\n`;
    });
  }).flat();
  const faces = Array.from({ length: 9 }, (_, i) => {
    const [a, b] = [2 * i + 1, 2 * i + 2];
    const [c, d] = i < 8 ? [a + 2, a + 3] : [2, 1];
    return `f ${a} ${c} ${b}\nf ${b} ${c} ${d}\n`;
  });
  put('moebius.obj', [...band, ...faces].join(''));
  const strict = run(['param', 'moebius.obj', '-o', 'out.obj', '--strict']);
  assert.equal(strict.code, 4);
  const oriented = run(['param', 'moebius.obj', '-o', 'out.obj', '--fix', 'orient']);
  assert.equal(oriented.code, 4);
  assert.doesNotMatch(oriented.err, /Repair with --fix orient/);
  const { code, err } = run(['param', 'moebius.obj', '-o', 'out.obj']);
  assert.equal(code, 0, err);
  assert.match(err, /1 one-sided component cut along 1 edge\n/);
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
  const told = err.split('\n');
  assert.ok(told.length < 150, `${told.length} lines`);
});

test('every mesh of a file is mapped, and --keep-going writes the others where one has no map', () => {
  const point = { vertices: Array(3).fill([1, 1, 1]), triangles: [[0, 1, 2]] };
  const parts = (json) => {
    const { meshes, ...rest } = JSON.parse(json);
    // The documents inside have schemas of their own.
    const plain = meshes.map(({ document: { format, version }, ...m }) => ({
      ...m,
      document: { format, version },
    }));
    assert.deepEqual(problems('hgp-file', { ...rest, meshes: plain }), []);
    return meshes.map((m) => [m.mesh, m.certified]);
  };
  writeFileSync(at('three.glb'), toGlb([cubeMesh(3), cubeMesh(5), cubeMesh(2)]));
  const all = run(['param', 'three.glb', '-o', 'three_out.glb', '--json', '-']);
  assert.equal(all.code, 0, all.err);
  assert.deepEqual(
    parts(all.out),
    [0, 1, 2].map((m) => [m, true]),
  );
  // Cells have one size in the whole file, so that a number of cells is that of all meshes.
  const grid = run(['param', 'three.glb', '-o', 'grid.glb', '--cells', '1200', '--json', '-']);
  assert.equal(grid.code, 0, grid.err);
  const grids = JSON.parse(grid.out).meshes.map((m) => m.document.components[0].grid);
  assert.ok(grids.every((g) => g.aligned));
  const total = grids.reduce((sum, g) => sum + g.cells, 0);
  assert.ok(Math.abs(total / 1200 - 1) < 0.25, `${total} cells`);
  // A note on several meshes is printed once.
  const notes = (meshes) => {
    writeFileSync(at('noted.glb'), toGlb(meshes));
    return run(['param', 'noted.glb', '-o', 'noted_out.glb'])
      .err.match(/note: .*/g)
      .join('\n');
  };
  assert.match(
    notes([cubeMesh(3), cubeMesh(5), cubeMesh(2)]),
    /^note: mesh 0: .* along seams; likewise, with other numbers, meshes 1, 2$/,
  );
  const same = /^note: meshes 0 to 2: .* along seams$/;
  assert.match(notes([cubeMesh(3), cubeMesh(3), cubeMesh(3)]), same);
  for (const mesh of ['all', '0', '1', '2', 'largest']) {
    assert.equal(run(['verify', 'three_out.glb', '--mesh', mesh]).code, 0, mesh);
  }
  run(['param', 'three.glb', '-o', 'one_out.glb', '--mesh', 'largest']);
  assert.equal(run(['verify', 'one_out.glb']).code, 6);
  assert.equal(run(['verify', 'one_out.glb', '--mesh', '1']).code, 0);

  writeFileSync(at('bad.glb'), toGlb([cubeMesh(3), point, cubeMesh(2)]));
  const whole = run(['param', 'bad.glb', '-o', 'bad_out.glb']);
  assert.equal(whole.code, 6);
  assert.match(whole.err, /mesh 1: no map: .*nothing is left/);
  assert.ok(!existsSync(at('bad_out.glb')));
  const kept = run(['param', 'bad.glb', '-o', 'bad_out.glb', '--keep-going', '--json', '-']);
  assert.equal(kept.code, 6);
  assert.deepEqual(parts(kept.out), [
    [0, true],
    [1, false],
    [2, true],
  ]);
  for (const mesh of [0, 2]) {
    assert.equal(run(['verify', 'bad_out.glb', '--mesh', `${mesh}`]).code, 0, `${mesh}`);
  }
  assert.equal(
    run(['param', 'three.glb', '-o', 'x.glb', '--mesh', 'all', '--cone', '1:3']).code,
    2,
  );
});

test('a component without a solution is cut to a disk, the others keep their certificate', () => {
  // No cones and a closed surface: nothing that fits; the disk beside it is fine.
  const disk = 'v 9 0 0\nv 10 0 0\nv 9 1 0\nf 7 8 9\n';
  put('pair.obj', `${octahedron}${disk}`);
  const asked = ['param', 'pair.obj', '-o', 'pair_out.obj', '--boundary', 'convex'];
  assert.equal(run(asked).code, 4);
  const { code, err, out } = run([...asked, '--keep-going', '--json', '-']);
  assert.equal(code, 6, err);
  const { components } = JSON.parse(out).certificate;
  assert.deepEqual(
    components.map((c) => c.reasons.length === 0),
    [false, true],
  );
  assert.match(err, sentenceOf('component-without-map', { component: 0 }));
  // The octahedron, cut open: every triangle of the file is positive.
  const text = readFileSync(at('pair_out.obj'), 'utf8');
  const rows = (word) => text.split('\n').filter((l) => l.startsWith(`${word} `)).map((l) => l.split(/\s+/).slice(1)); // prettier-ignore
  const uv = rows('vt').map((p) => p.map(Number));
  for (const corners of rows('f')) {
    const [a, b, c] = corners.map((corner) => uv[Number(corner.split('/')[1]) - 1]);
    assert.ok((b[0] - a[0]) * (c[1] - a[1]) > (b[1] - a[1]) * (c[0] - a[0]), corners.join(' '));
  }
  assert.ok(existsSync(at('pair_out.obj')));
});

test('where the usual automatic cones leave a grid no room, few cones are tried, with a note', () => {
  const pretzel = path.join(import.meta.dirname, '../../examples/meshes/pretzel.obj');
  const coarse = ['--cells', '4', '--grid-mode', 'tile'];
  const asked = ['param', pretzel, '-o', 'pretzel_out.obj', ...coarse, '--json', 'pretzel.json'];
  const { code, err } = run(asked);
  assert.equal(code, 0, err);
  const few = (name) =>
    JSON.parse(readFileSync(at(name), 'utf8'))
      .components.flatMap(({ notes }) => notes)
      .some((one) => one.code === 'grid-few-used');
  assert.ok(few('pretzel.json'));
  assert.equal(run(['verify', 'pretzel_out.obj']).code, 0);
  // The map is that of its own cones, whoever names them; a choice that was made is kept.
  const { cones } = JSON.parse(readFileSync(at('pretzel.json'), 'utf8'));
  put('pretzel_cones.json', JSON.stringify(cones));
  const again = run([...asked.slice(0, 2), '-o', 'pretzel_again.obj', ...coarse, '--cones', 'pretzel_cones.json']); // prettier-ignore
  assert.equal(again.code, 0, again.err);
  assert.deepEqual(readFileSync(at('pretzel_again.obj')), readFileSync(at('pretzel_out.obj')));
  run([...asked, '--cones-for', 'low-distortion']);
  assert.ok(!few('pretzel.json'));
});

test('a component that is not as prescribed is not certified, even if its substitute map is sound', () => {
  // A ring of squares unrolls without a cone; asked are cones on its boundary, which no map can have.
  const n = 8;
  const ring = (z) => Array.from({ length: n }, (_, i) => `v ${Math.cos((2 * Math.PI * i) / n)} ${Math.sin((2 * Math.PI * i) / n)} ${z}`); // prettier-ignore
  const squares = Array.from({ length: n }, (_, i) => {
    const [a, b] = [i + 1, ((i + 1) % n) + 1];
    return `f ${a} ${b} ${b + n}\nf ${a} ${b + n} ${a + n}`;
  });
  put('ring.obj', `${[...ring(0), ...ring(1), ...squares].join('\n')}\n`);
  const asked = ['param', 'ring.obj', '-o', 'ring_out.obj', '--cone', '3:1'];
  assert.equal(run(asked).code, 5);
  const { code, out } = run([...asked, '--keep-going', '--json', '-']);
  assert.equal(code, 6);
  const { certified, certificate } = JSON.parse(out);
  assert.deepEqual([certified, certificate.certified], [false, false]);
  const [{ rule, message }] = certificate.components[0].reasons;
  assert.equal(rule, 'prescription');
  assert.match(message, /There is no map with this prescription: .*vertex 3/);
  const quiet = run([...asked, '--keep-going', '-q']);
  assert.deepEqual(
    [quiet.code, quiet.err],
    [6, 'hgp: ring.obj: written, but not certified\n'],
    'exit code 6 is never silent',
  );
});

test('a component without a solution keeps the uv it had, to the last digit', () => {
  const uv = ['0.1 0.2', '0.7 0.3', '0.30000000000000004 0.9', '0.123 0.456', '5.5 -2.25', '0 0'];
  const faces = octahedron.split('\n').filter((l) => l.startsWith('f '));
  const withUv = faces.map((l) => l.replace(/\d+/g, (v) => `${v}/${v}`));
  const points = octahedron.split('\n').filter((l) => l.startsWith('v '));
  const disk = ['v 9 0 0', 'v 10 0 0', 'v 9 1 0', ...['9 9', '8 9', '9 8'].map((p) => `vt ${p}`), 'f 7/7 8/8 9/9']; // prettier-ignore
  put('olduv.obj', `${[...points, ...uv.map((p) => `vt ${p}`), ...withUv, ...disk].join('\n')}\n`);
  const asked = [
    'param',
    'olduv.obj',
    '-o',
    'olduv_out.obj',
    '--boundary',
    'convex',
    '--scale',
    'unit',
  ];
  assert.equal(run([...asked, '--keep-going']).code, 6);
  const lines = readFileSync(at('olduv_out.obj'), 'utf8').split('\n');
  const written = lines.filter((l) => l.startsWith('vt ')).map((l) => l.slice(3));
  lines
    .filter((l) => l.startsWith('f '))
    .slice(0, 8)
    .forEach((l) => {
      for (const corner of l.slice(2).split(' ')) {
        const [v, vt] = corner.split('/').map(Number);
        assert.deepEqual(written[vt - 1].split(' ').map(Number), uv[v - 1].split(' ').map(Number));
      }
    });
});

test('an unknown extension is refused before anything is solved', () => {
  put('ball.obj', octahedron);
  const { code, err } = run(['param', 'ball.obj', '-o', 'out.fbx']);
  assert.equal(code, 2);
  assert.match(err, /no format has the extension \.fbx; the result is written as \.obj/);
  assert.ok(!existsSync(at('out.fbx')));
  assert.equal(run(['param', 'ball.obj', '-o', 'without']).code, 0);
});

test('broken c and sm lines are noted where cones are automatic, refused where asked for', () => {
  put('ball.obj', octahedron);
  const broken = put('broken.obj', `${octahedron}c 1 1.23456\nsm 1 1 x\n`);
  const { code, out, err } = run(['param', broken, '-o', 'out.obj', '--json', '-']);
  assert.equal(code, 0, err);
  const note = JSON.parse(out).notes.find((one) => one.code === 'read-cones-unused');
  assert.match(note.words.why, /^line \d+: c\/sm/);
  const asked = run(['param', 'ball.obj', '-o', 'out.obj', '--cones', broken]);
  assert.equal(asked.code, 3, asked.err);
});

test('for q = 3 and 6 every stored seam is exact between the points of a triangular lattice', () => {
  put('octahedron.obj', octahedron);
  for (const q of ['3', '6'])
    for (const output of ['sixths.obj', 'sixths.glb']) {
      const solved = run(['param', 'octahedron.obj', '--q', q, '-o', output]);
      assert.equal(solved.code, 0, solved.err);
      const { code, out } = run(['verify', output, '--q', q, '--json', '-']);
      assert.equal(code, 0, output);
      const { exactSeams, seamEdges } = JSON.parse(out);
      assert.ok(seamEdges > 2, output);
      assert.equal(exactSeams, seamEdges, output);
    }
});
