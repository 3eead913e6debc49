// Quads keep what the input has: uv, colours, normals and materials at every corner, computed here a second time.
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import test from 'node:test';
import { NodeIO } from '@gltf-transform/core';
import { sentenceOf } from '../support/notes.mjs';
import { colorOf, cubeFaces, dot, facesWith, isClose, normalOf, uvOf } from '../support/painted.mjs'; // prettier-ignore
import { inFolder } from '../support/program.mjs';

const { at, put, read, good } = inFolder('quad-attributes');

/** A cube of n × n squares per face, cut alternately, as OBJ; faces have islands of uv and materials of their own. */
function cubeObj(n) {
  const lines = ['mtllib paint/cube.mtl'];
  const ids = new Map();
  const faces = [];
  let uvs = 0;
  cubeFaces.forEach(([corner, a, b], f) => {
    lines.push(`vn ${normalOf(f).join(' ')}`);
    const at = (i, j) => corner.map((x, k) => x + (a[k] * i + b[k] * j) / n);
    const vertex = (p) => {
      const key = p.map((x) => Math.round(x * n)).join();
      if (!ids.has(key)) {
        ids.set(key, ids.size + 1);
        lines.push(`v ${[...p, ...colorOf(p)].join(' ')}`);
      }
      return ids.get(key);
    };
    faces.push(`usemtl paint of face ${f}`);
    for (let i = 0; i < n; i++)
      for (let j = 0; j < n; j++) {
        const square = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]]; // prettier-ignore
        const corners = square.map(([k, l]) => {
          const p = at(k, l);
          lines.push(`vt ${uvOf(f, p).join(' ')}`);
          return `${vertex(p)}/${++uvs}/${f + 1}`;
        });
        const cuts = (i + j) % 2 ? [[0, 1, 2], [0, 2, 3]] : [[0, 1, 3], [1, 2, 3]]; // prettier-ignore
        for (const cut of cuts) faces.push(`f ${cut.map((k) => corners[k]).join(' ')}`);
      }
  });
  return [...lines, ...faces, ''].join('\n');
}

/** Rows of an OBJ by keyword, and its faces with the material of each. */
function readObj(text) {
  const out = { v: [], vt: [], vn: [], faces: [], mtllib: [] };
  let material = '';
  for (const line of text.split('\n')) {
    const [word, ...rest] = line.split(' ');
    if (word === 'usemtl') material = rest.join(' ');
    else if (word === 'mtllib') out.mtllib.push(rest.join(' '));
    else if (word === 'f')
      out.faces.push({
        material,
        corners: rest.map((c) => c.split('/').map((x) => Number(x) - 1)),
      });
    else if (out[word]) out[word].push(rest.map(Number));
  }
  return out;
}

const seamNote = /(\d+) quads? cross(es)? a seam/;

test('on a cube along its creases every corner has the uv, normal and material of its face', () => {
  put('cube.obj', cubeObj(6));
  const { err } = good('quads', 'cube.obj', '--creases', '--cells', '150', '-o', 'quads.obj');
  const { v, vt, vn, faces, mtllib } = readObj(read('quads.obj'));
  assert.deepEqual(mtllib, ['paint/cube.mtl']);
  assert.doesNotMatch(err, seamNote);
  assert.ok(faces.length >= 100);
  for (const { material, corners } of faces) {
    const [f, ...more] = facesWith(corners.map(([i]) => v[i].slice(0, 3)));
    assert.ok(f >= 0 && more.length === 0);
    assert.equal(material, `paint of face ${f}`);
    for (const [i, uv, normal] of corners) {
      const p = v[i].slice(0, 3);
      assert.ok(isClose(vt[uv], uvOf(f, p), 1e-12), `${vt[uv]} at ${p}`);
      assert.ok(isClose(vn[normal], normalOf(f), 1e-9));
      assert.ok(isClose(v[i].slice(3), colorOf(p), 1e-8));
    }
  }
});

test('quads across seams are counted, and their corners have what some triangle has there', () => {
  put('cube.obj', cubeObj(6));
  const { err } = good('quads', 'cube.obj', '--cells', '200', '-o', 'quads.obj');
  const { v, vt, faces } = readObj(read('quads.obj'));
  const across = faces.filter(
    ({ corners }) => facesWith(corners.map(([i]) => v[i].slice(0, 3))).length === 0,
  );
  assert.ok(across.length > 0);
  assert.equal(Number(err.match(seamNote)[1]), across.length);
  for (const { corners } of faces)
    for (const [i, uv] of corners) {
      const p = v[i].slice(0, 3);
      assert.ok(facesWith([p]).some((f) => isClose(vt[uv], uvOf(f, p), 1e-9)));
    }
});

test('on a very small cube it is the same', () => {
  const unit = 2 ** -299;
  const small = cubeObj(6).replace(/^v \S+ \S+ \S+/gm, (row) => ['v', ...row.split(' ').slice(1).map((x) => x * unit)].join(' ')); // prettier-ignore
  put('small.obj', small);
  const { err } = good('quads', 'small.obj', '--creases', '--cells', '150', '-o', 'small-quads.obj'); // prettier-ignore
  assert.doesNotMatch(err, /fold/);
  const { v, vt, faces } = readObj(read('small-quads.obj'));
  assert.ok(faces.length >= 100);
  for (const { corners } of faces) {
    const points = corners.map(([i]) => v[i].slice(0, 3).map((x) => x / unit));
    const [f] = facesWith(points);
    corners.forEach(([, uv], k) => assert.ok(isClose(vt[uv], uvOf(f, points[k]), 1e-12)));
  }
});

/** A torus with uv = angles: one island with two slits. */
function torusObj(m, n) {
  const lines = [];
  const faces = [];
  for (let i = 0; i < m; i++)
    for (let j = 0; j < n; j++) {
      const [a, b] = [(2 * Math.PI * i) / m, (2 * Math.PI * j) / n];
      const r = 1 + 0.4 * Math.cos(b);
      lines.push(`v ${r * Math.cos(a)} ${r * Math.sin(a)} ${0.4 * Math.sin(b)}`);
    }
  for (let i = 0; i <= m; i++) for (let j = 0; j <= n; j++) lines.push(`vt ${i / m} ${j / n}`);
  const corner = (i, j) => `${(i % m) * n + (j % n) + 1}/${i * (n + 1) + j + 1}`;
  for (let i = 0; i < m; i++)
    for (let j = 0; j < n; j++) {
      faces.push(`f ${corner(i, j)} ${corner(i + 1, j)} ${corner(i + 1, j + 1)}`);
      faces.push(`f ${corner(i, j)} ${corner(i + 1, j + 1)} ${corner(i, j + 1)}`);
    }
  return [...lines, ...faces, ''].join('\n');
}

test('a slit within one island is a seam: quads whose corners jump over it are those counted', () => {
  put('ring.obj', torusObj(48, 20));
  const { err } = good('quads', 'ring.obj', '--cells', '300', '-o', 'ring-quads.obj');
  const { vt, faces } = readObj(read('ring-quads.obj'));
  const jumps = faces.filter(({ corners }) =>
    [0, 1].some((k) => {
      const x = corners.map(([, uv]) => vt[uv][k]);
      return Math.max(...x) - Math.min(...x) > 0.5;
    }),
  );
  assert.ok(jumps.length > 0);
  assert.equal(Number(err.match(seamNote)[1]), jumps.length);
  for (const [u, w] of vt) assert.ok(u >= 0 && u <= 1 && w >= 0 && w <= 1);
});

test('PLY has quads with normals, colours and uv, which hgp reads again', () => {
  put('cube.obj', cubeObj(6));
  const { err } = good('quads', 'cube.obj', '--creases', '--cells', '150', '-o', 'quads.ply');
  assert.match(err, sentenceOf('quads-no-materials'));
  const [head, body] = read('quads.ply').split('end_header\n');
  const count = (name) => Number(head.match(new RegExp(`element ${name} (\\d+)`))[1]);
  const rows = body.trim().split('\n').map((line) => line.split(' ').map(Number)); // prettier-ignore
  assert.equal(rows.length, count('vertex') + count('face'));
  const points = rows.slice(0, count('vertex'));
  for (const row of points) {
    assert.equal(row.length, 10);
    assert.ok(isClose(row.slice(6, 9), colorOf(row.slice(0, 3)).map((x) => Math.round(255 * x)), 1)); // prettier-ignore
    assert.ok(Math.abs(dot(row.slice(3, 6), row.slice(3, 6)) - 1) < 1e-8);
  }
  for (const row of rows.slice(count('vertex'))) {
    assert.deepEqual([row[0], row[5], row.length], [4, 8, 14]);
    const corners = row.slice(1, 5).map((i) => points[i].slice(0, 3));
    const [f] = facesWith(corners);
    corners.forEach((p, k) =>
      assert.ok(isClose(row.slice(6 + 2 * k, 8 + 2 * k), uvOf(f, p), 1e-6)),
    );
  }
  assert.match(good('inspect', 'quads.ply').out, new RegExp(`${2 * count('face')} triangles`));
});

/** Positions and normals of a PLY of quads, a GLB or an OBJ. */
async function normalsIn(name) {
  if (name.endsWith('.glb')) {
    const [mesh] = (await new NodeIO().read(at(name))).getRoot().listMeshes();
    return mesh.listPrimitives().flatMap((primitive) => {
      const [points, normals] = ['POSITION', 'NORMAL'].map((s) => primitive.getAttribute(s));
      return [...primitive.getIndices().getArray()].map((v) => [points.getElement(v, []), normals.getElement(v, [])]); // prettier-ignore
    });
  }
  if (name.endsWith('.obj')) {
    const { v, vn, faces } = readObj(read(name));
    return faces.flatMap(({ corners }) => corners.map(([i, , n]) => [v[i].slice(0, 3), vn[n]]));
  }
  const [head, body] = read(name).split('end_header\n');
  const count = Number(/element vertex (\d+)/.exec(head)[1]);
  const rows = body.split('\n').slice(0, count);
  return rows.map((row) => row.split(' ').map(Number)).map((x) => [x.slice(0, 3), x.slice(3, 6)]);
}

async function areNormalsOfTheShape(name) {
  const found = await normalsIn(name);
  assert.ok(found.length > 100);
  for (const [p, n] of found) {
    const faces = facesWith([p], 1e-6);
    assert.ok(Math.abs(dot(n, n) - 1) < 1e-6);
    assert.ok(Math.max(...faces.map((f) => dot(n, normalOf(f)))) > 0.5, `${n} at ${p} in ${name}`);
  }
}

test('where the input has no normals, quads have those of the shape', async () => {
  let n = 0;
  const some = cubeObj(6).replace(/^f .*$/gm, (row) => (++n % 3 ? row : row.replace(/\/\d+( |$)/g, '$1'))); // prettier-ignore
  put('some.obj', some);
  for (const name of ['some-quads.obj', 'some-quads.ply', 'some-quads.glb']) {
    good('quads', 'some.obj', '--creases', '--cells', '150', '-o', name);
    await areNormalsOfTheShape(name);
  }
  good('param', 'some.obj', '-o', 'some-map.glb');
  await areNormalsOfTheShape('some-map.glb');
});

test('a PLY whose normals are 0 gets those of the shape; what is left out is named', async () => {
  const rows = cubeObj(6).split('\n');
  const points = rows.filter((row) => row.startsWith('v ')).map((row) => row.split(' ').slice(1, 4).join(' ')); // prettier-ignore
  const faces = rows.filter((row) => row.startsWith('f ')).map((row) => row.slice(2).split(' ').map((c) => parseInt(c) - 1).join(' ')); // prettier-ignore
  put(
    'zero.ply',
    `ply
format ascii 1.0
element vertex ${points.length}
property float x
property float y
property float z
property float nx
property float ny
property float nz
property float quality
element face ${faces.length}
property list uchar int vertex_indices
property int flags
end_header
${points.map((row) => `${row} 0 0 0 0.5`).join('\n')}
${faces.map((row) => `3 ${row} 7`).join('\n')}
`,
  );
  const { err } = good('quads', 'zero.ply', '--cells', '150', '-o', 'zero-quads.ply');
  assert.match(err, sentenceOf('convert-others-lost', { names: 'vertex quality, face flags' }));
  await areNormalsOfTheShape('zero-quads.ply');
});

test('where only some corners have uv, quads have them there, and a note counts the others', () => {
  const some = cubeObj(6).replace(/^usemtl paint of face 5\n(f .*\n)*/gm, (part) => part.replace(/\/\d+\//g, '//')); // prettier-ignore
  put('part.obj', some);
  const { err } = good('quads', 'part.obj', '--creases', '--cells', '150', '-o', 'part-quads.obj');
  const { v, vt, faces } = readObj(read('part-quads.obj'));
  let without = 0;
  for (const { corners } of faces) {
    const [f] = facesWith(corners.map(([i]) => v[i].slice(0, 3)));
    for (const [i, uv] of corners) {
      assert.equal(uv < 0, f === 5);
      without += uv < 0;
      if (uv >= 0) assert.ok(isClose(vt[uv], uvOf(f, v[i].slice(0, 3)), 1e-12));
    }
  }
  assert.ok(without > 0);
  assert.match(err, sentenceOf('quads-uv-missing', { corners: without }));
});

test('materials of an OBJ and their pictures are copied to another folder; groups are named', () => {
  put('cube.obj', cubeObj(6).replace('usemtl paint of face 3', 'g other\nusemtl paint of face 3').replace('usemtl', 'g one\nusemtl')); // prettier-ignore
  put('paint/cube.mtl', 'newmtl paint of face 0\nmap_Kd wood.png\n');
  put('wood.png', 'a picture');
  put('elsewhere/empty.txt', '');
  const { err } = good('quads', 'cube.obj', '--cells', '150', '-o', 'elsewhere/quads.obj');
  assert.match(err, sentenceOf('convert-groups-joined'));
  assert.equal(read('elsewhere/paint/cube.mtl'), read('paint/cube.mtl'));
  assert.ok(existsSync(at('elsewhere/wood.png')));
});
