// --write-repairs: the file that is written is an oriented manifold itself, and otherwise the file that
// was read. Read again here by a few lines for OBJ and PLY, and by glTF-Transform.
import { NodeIO } from '@gltf-transform/core';
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import test from 'node:test';
import validator from 'gltf-validator';
import { cubeMesh, toGlb, toObj } from '../support/meshes.mjs';
import { inFolder } from '../support/program.mjs';

const { at, run, good } = inFolder('repairs');

/** Runs param and gives its report; what verify says of the file must agree. */
function param(input, output, ...more) {
  good('param', input, '-o', output, '--json', `${output}.json`, ...more);
  good('verify', output);
  return JSON.parse(readFileSync(at(`${output}.json`), 'utf8'));
}

/** Two cubes that share one corner, some faces of the first turned over. */
function pinched(turned = [3, 4, 11]) {
  const { vertices, triangles } = cubeMesh(3);
  const corner = vertices[0];
  const moved = vertices.map((p) => p.map((x, i) => 2 * corner[i] - x));
  const ids = moved.map((_, v) => (v === 0 ? 0 : vertices.length + v - 1));
  const second = triangles.map(([a, b, c]) => [ids[a], ids[c], ids[b]]);
  const all = [...triangles, ...second].map((t, f) =>
    turned.includes(f) ? [t[0], t[2], t[1]] : t,
  );
  return { vertices: [...vertices, ...moved.slice(1)], triangles: all, first: triangles.length };
}

/** A band with half a twist. */
function moebius(n = 24) {
  const vertices = [];
  for (let i = 0; i < n; ++i)
    for (const w of [-1, 0, 1]) {
      const a = (2 * Math.PI * i) / n;
      const r = 3 + w * Math.cos(a / 2);
      vertices.push([r * Math.cos(a), r * Math.sin(a), w * Math.sin(a / 2)]);
    }
  const triangles = [];
  const id = (i, k) => (i < n ? 3 * i + k : 2 - k);
  for (let i = 0; i < n; ++i)
    for (const k of [0, 1]) {
      const quad = [id(i, k), id(i + 1, k), id(i + 1, k + 1), id(i, k + 1)];
      triangles.push([quad[0], quad[1], quad[2]], [quad[0], quad[2], quad[3]]);
    }
  return { vertices, triangles };
}

/** A cube with a fin: three faces at one edge. */
function finned() {
  const { vertices, triangles } = cubeMesh(3);
  const [a, b] = triangles[0];
  const tip = vertices[a].map((x) => 2 * x + 0.1);
  return { vertices: [...vertices, tip], triangles: [...triangles, [a, b, vertices.length]] };
}

function readObj(text) {
  const out = { v: [], vt: [], faces: [] };
  for (const line of text.split('\n')) {
    const [word, ...rest] = line.trim().split(/\s+/);
    if (word === 'v' || word === 'vt') out[word].push(rest.join(' '));
    if (word === 'f') out.faces.push(rest.map((c) => c.split('/').map((i) => Number(i) - 1)));
  }
  return out;
}

/** Edges by the number of faces that run along each direction: every one 1 is an oriented manifold. */
function worstEdge(faces) {
  const count = new Map();
  for (const face of faces)
    face.forEach((a, k) => {
      const key = `${a} ${face[(k + 1) % face.length]}`;
      count.set(key, (count.get(key) ?? 0) + 1);
    });
  return Math.max(...count.values());
}

/** The place and the uv of every corner, whatever the corners' order. */
const cornersOf = ({ v, vt, faces }) =>
  faces.map((face) => face.map(([p, t]) => `${v[p]} → ${vt[t]}`).sort());

for (const [name, mesh] of Object.entries({
  pinched: pinched(),
  moebius: moebius(),
  finned: finned(),
}))
  test(`repairs are written into an OBJ: ${name}`, () => {
    const before = toObj(mesh);
    writeFileSync(at(`${name}.obj`), before);
    const plain = param(`${name}.obj`, `${name}-plain.obj`);
    const report = param(`${name}.obj`, `${name}-written.obj`, '--write-repairs');
    assert.equal(plain.repairsWritten, null);
    const { reversed, splitVertices } = plain.certificate.stored;
    assert.deepEqual(report.repairsWritten, {
      facesTurned: reversed,
      verticesCopied: splitVertices,
    });
    assert.ok(reversed + splitVertices > 0);
    assert.equal(report.certificate.stored.reversed, 0);
    assert.equal(report.certificate.stored.splitVertices, 0);
    assert.equal(report.input.vertices, mesh.vertices.length);
    assert.ok(report.notes.some(({ code }) => code === 'repairs-written'));

    const out = readObj(readFileSync(at(`${name}-written.obj`), 'utf8'));
    assert.equal(worstEdge(out.faces.map((f) => f.map(([v]) => v))), 1);
    good('verify', `${name}-written.obj`, '--strict');
    assert.equal(run('verify', `${name}-plain.obj`, '--strict').code, 4);
    // The vertices of before keep their lines, copies follow; the map is the same on every triangle.
    assert.deepEqual(out.v.slice(0, mesh.vertices.length), readObj(before).v);
    assert.equal(out.v.length, mesh.vertices.length + splitVertices);
    assert.deepEqual(
      cornersOf(out),
      cornersOf(readObj(readFileSync(at(`${name}-plain.obj`), 'utf8'))),
    );
    const again = param(`${name}-written.obj`, `${name}-again.obj`, '--write-repairs');
    assert.equal(again.repairsWritten, null, 'nothing is left to write');
  });

test('flipped faces of an OBJ keep their quads, normals, colours and groups', () => {
  // A cube of quads; one side turned over.
  const side = 4;
  const { vertices, triangles } = cubeMesh(side);
  const quads = [];
  for (let f = 0; f < triangles.length; f += 2) {
    const corners = [...triangles[f], ...triangles[f + 1]];
    const shared = triangles[f].filter((v) => triangles[f + 1].includes(v));
    const a = triangles[f].find((v) => !shared.includes(v));
    const k = triangles[f].indexOf(a);
    const c = triangles[f + 1].find((v) => !shared.includes(v));
    assert.equal(new Set(corners).size, 4);
    quads.push([a, triangles[f][(k + 1) % 3], c, triangles[f][(k + 2) % 3]]);
  }
  const turned = (f) => f < 5;
  const text = [
    'o box',
    ...vertices.map((p, v) => `v ${p.join(' ')} ${v / 1000} 0.5 1`),
    ...vertices.map((_, v) => `vn 0 ${v + 1} 1`),
    ...quads.flatMap((quad, f) => [
      ...(f === 7 ? ['usemtl lid'] : []),
      `f ${(turned(f) ? quad.toReversed() : quad).map((v) => `${v + 1}//${v + 1}`).join(' ')} # ${f}`,
    ]),
    '',
  ].join('\n');
  writeFileSync(at('quads.obj'), text);
  const report = param('quads.obj', 'quads-written.obj', '--write-repairs');
  assert.equal(report.repairsWritten.facesTurned, 10, 'triangles');
  const written = readFileSync(at('quads-written.obj'), 'utf8');
  good('verify', 'quads-written.obj', '--strict');
  const faces = written.split('\n').filter((line) => line.startsWith('f '));
  assert.equal(faces.length, quads.length);
  faces.forEach((line, f) => {
    const corners = line.replace(/#.*/, '').trim().split(/\s+/).slice(1).map((c) => c.split('/')); // prettier-ignore
    assert.equal(corners.length, 4, 'a quad stays one');
    for (const [v, , n] of corners) assert.equal(v, n, 'its normal goes with the vertex');
    const [first, ...rest] = corners.map(([v]) => Number(v) - 1);
    const k = quads[f].indexOf(first);
    assert.deepEqual(rest, [1, 2, 3].map((i) => quads[f][(k + i) % 4]), `face ${f}`); // prettier-ignore
  });
  for (const line of text.split('\n').filter((word) => /^(o|v|vn|usemtl) /.test(word)))
    assert.ok(written.includes(`${line}\n`), line);
});

function plyOf({ vertices, triangles }, encoding) {
  const head = [
    'ply',
    `format ${encoding} 1.0`,
    'comment kept',
    `element vertex ${vertices.length}`,
    'property float x',
    'property float y',
    'property float z',
    'property uchar red', // prettier-ignore
    'property uchar green',
    'property uchar blue', // prettier-ignore
    `element face ${triangles.length}`,
    'property uchar flag',
    'property list uchar int vertex_indices',
    'element edge 1',
    'property int vertex1',
    'property int vertex2',
    'end_header',
    '',
  ].join('\n');
  const color = (v) => [v % 256, 7, 255 - (v % 256)];
  if (encoding === 'ascii')
    return Buffer.from(
      head +
        vertices.map((p, v) => `${p.join(' ')} ${color(v).join(' ')}\n`).join('') +
        triangles.map((t, f) => `${f % 9} 3 ${t.join(' ')}\n`).join('') +
        '5 6\n',
    );
  const isLittle = encoding === 'binary_little_endian';
  const float = isLittle ? 'writeFloatLE' : 'writeFloatBE';
  const int = isLittle ? 'writeInt32LE' : 'writeInt32BE';
  const body = Buffer.alloc(15 * vertices.length + 14 * triangles.length + 8);
  vertices.forEach((p, v) => {
    p.forEach((x, i) => body[float](x, 15 * v + 4 * i));
    color(v).forEach((x, i) => body.writeUInt8(x, 15 * v + 12 + i));
  });
  triangles.forEach((t, f) => {
    const start = 15 * vertices.length + 14 * f;
    body.writeUInt8(f % 9, start);
    body.writeUInt8(3, start + 1);
    t.forEach((v, i) => body[int](v, start + 2 + 4 * i));
  });
  [5, 6].forEach((v, i) => body[int](v, body.length - 8 + 4 * i));
  return Buffer.concat([Buffer.from(head), body]);
}

for (const encoding of ['ascii', 'binary_little_endian', 'binary_big_endian'])
  test(`repairs are written into a PLY: ${encoding}`, () => {
    for (const [name, mesh] of Object.entries({ pinched: pinched(), moebius: moebius() })) {
      const input = `${name}-${encoding}.ply`;
      writeFileSync(at(input), plyOf(mesh, encoding));
      const plain = param(input, `plain-${input}`);
      const report = param(input, `written-${input}`, '--write-repairs');
      const { reversed, splitVertices } = plain.certificate.stored;
      assert.deepEqual(report.repairsWritten, {
        facesTurned: reversed,
        verticesCopied: splitVertices,
      });
      good('verify', `written-${input}`, '--strict');
      const written = readFileSync(at(`written-${input}`));
      const head = written.subarray(0, written.indexOf('end_header')).toString();
      assert.match(head, /comment kept/);
      assert.match(head, new RegExp(`element vertex ${mesh.vertices.length + splitVertices}\n`));
      assert.match(head, new RegExp(`element face ${mesh.triangles.length}\n`));
      if (encoding !== 'ascii') continue;
      const rows = written.toString().split('end_header\n')[1].split('\n');
      const count = mesh.vertices.length + splitVertices;
      assert.deepEqual(
        rows.slice(0, mesh.vertices.length),
        plyOf(mesh, encoding).toString().split('end_header\n')[1].split('\n').slice(0, mesh.vertices.length), // prettier-ignore
      );
      for (const copy of rows.slice(mesh.vertices.length, count))
        assert.ok(rows.slice(0, mesh.vertices.length).includes(copy), `a copy: ${copy}`);
      mesh.triangles.forEach((_, f) => assert.equal(rows[count + f].split(' ')[0], `${f % 9}`));
      assert.equal(rows[count + mesh.triangles.length], '5 6');
    }
  });

test('faces of a GLB are flipped, and nothing else changes', async () => {
  const { vertices, triangles } = cubeMesh(3);
  const mesh = {
    vertices,
    triangles: triangles.map((t, f) => (f % 9 === 4 ? [t[0], t[2], t[1]] : t)),
  };
  writeFileSync(at('turned.glb'), toGlb([mesh]));
  assert.equal(run('param', 'turned.glb', '-o', 'x.glb', '--strict').code, 4);
  const report = param('turned.glb', 'turned-written.glb', '--write-repairs');
  const count = mesh.triangles.filter((_, f) => f % 9 === 4).length;
  assert.deepEqual(report.repairsWritten, { facesTurned: count, verticesCopied: 0 });
  assert.equal(report.certificate.stored.reversed, 0);
  good('verify', 'turned-written.glb', '--strict');
  const { issues } = await validator.validateBytes(new Uint8Array(readFileSync(at('turned-written.glb')))); // prettier-ignore
  assert.equal(issues.numErrors, 0, JSON.stringify(issues.messages));
  const place = (prim, i) => prim.getAttribute('POSITION').getElement(prim.getIndices().getScalar(i), []).join(' '); // prettier-ignore
  const facesOf = async (name) => {
    const [prim] = (await new NodeIO().read(at(name))).getRoot().listMeshes()[0].listPrimitives();
    return mesh.triangles.map((_, f) => [0, 1, 2].map((k) => place(prim, 3 * f + k)));
  };
  const [before, now] = [await facesOf('turned.glb'), await facesOf('turned-written.glb')];
  before.forEach(([a, b, c], f) => assert.deepEqual(now[f], f % 9 === 4 ? [a, c, b] : [a, b, c]));
});

test('fans of a GLB that share a vertex get vertices of their own', async () => {
  const mesh = pinched([]);
  writeFileSync(at('pinched.glb'), toGlb([mesh]));
  const report = param('pinched.glb', 'pinched-written.glb', '--write-repairs');
  assert.deepEqual(report.repairsWritten, { facesTurned: 0, verticesCopied: 1 });
  const [prim] = (await new NodeIO().read(at('pinched-written.glb'))).getRoot().listMeshes()[0].listPrimitives(); // prettier-ignore
  const at0 = (part) =>
    new Set(
      mesh.triangles.flatMap((t, f) =>
        t.flatMap((v, k) => (v === 0 && part(f) ? [prim.getIndices().getScalar(3 * f + k)] : [])),
      ),
    );
  const [first, second] = [at0((f) => f < mesh.first), at0((f) => f >= mesh.first)];
  assert.ok(first.size > 0 && second.size > 0);
  for (const v of first) assert.ok(!second.has(v), `stored vertex ${v} is in both`);
});

test('all meshes of a file, and files that are converted, are repaired where they are written', () => {
  const turned = ({ vertices, triangles }, n) => ({
    vertices,
    triangles: triangles.map((t, f) => (f % 7 === n ? [t[0], t[2], t[1]] : t)),
  });
  writeFileSync(at('two.glb'), toGlb([turned(cubeMesh(3), 1), turned(cubeMesh(2), 2)]));
  good('param', 'two.glb', '-o', 'two-written.glb', '--write-repairs');
  for (const mesh of ['0', '1']) good('verify', 'two-written.glb', '--strict', '--mesh', mesh);
  writeFileSync(at('turned.obj'), toObj(turned(cubeMesh(3), 3)));
  param('turned.obj', 'from-obj.glb', '--write-repairs');
  good('verify', 'from-obj.glb', '--strict');
  param('two.glb', 'from-glb.obj', '--mesh', '0', '--write-repairs');
  good('verify', 'from-glb.obj', '--strict');
});

test('a file without defects is written as without the option', () => {
  writeFileSync(at('sound.obj'), toObj(cubeMesh(4)));
  param('sound.obj', 'sound-plain.obj');
  const report = param('sound.obj', 'sound-written.obj', '--write-repairs');
  assert.equal(report.repairsWritten, null);
  assert.deepEqual(readFileSync(at('sound-written.obj')), readFileSync(at('sound-plain.obj')));
});
