// What the program writes, read again by others: glTF-Transform and gltf-validator for glTF, a few lines
// here for OBJ and PLY.
import { NodeIO } from '@gltf-transform/core';
import assert from 'node:assert/strict';
import { existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import validator from 'gltf-validator';
import { cubeMesh, toGlb, toGltf, toObj, toOff, toStl } from '../support/meshes.mjs';
import { inFolder } from '../support/program.mjs';
import { sentenceOf } from '../support/notes.mjs';

const { at, put, run, good } = inFolder('writers');

/** The cube with a normal per side, a colour per vertex and two materials; sides first to last. */
function richObj() {
  const { vertices, triangles } = cubeMesh(3);
  const lines = ['mtllib rich.mtl', 'o box'];
  for (const p of vertices)
    lines.push(`v ${p.join(' ')} ${p.map((x) => Math.abs(x / 4) % 1).join(' ')}`);
  for (const n of ['1 0 0', '0 1 0', '0 0 1', '-1 0 0', '0 -1 0', '0 0 -1']) lines.push(`vn ${n}`);
  let material = '';
  for (const t of triangles) {
    const [a, b, c] = t.map((v) => vertices[v]);
    const normal = [0, 1, 2].map((k) => {
      const [i, j] = [(k + 1) % 3, (k + 2) % 3];
      return (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
    });
    const axis = normal.findIndex((x) => x !== 0);
    const side = axis + (normal[axis] > 0 ? 0 : 3);
    const next = axis === 2 ? 'lid' : 'wall';
    if (next !== material) lines.push(`usemtl ${next}`);
    material = next;
    lines.push(`f ${t.map((v) => `${v + 1}//${side + 1}`).join(' ')}`);
  }
  return { text: `${lines.join('\n')}\n`, vertices, triangles };
}

/** v, vn, colours and faces with v, vt, vn from 0, materials by face. */
function readObj(text) {
  const out = { v: [], vt: [], vn: [], colors: [], faces: [], materials: [], objects: [] };
  let material = null;
  for (const line of text.split('\n')) {
    const [word, ...rest] = line.trim().split(/\s+/);
    const numbers = () => rest.map(Number);
    if (word === 'v') {
      out.v.push(numbers().slice(0, 3));
      out.colors.push(numbers().slice(3));
    } else if (word === 'vt') out.vt.push(numbers());
    else if (word === 'vn') out.vn.push(numbers());
    else if (word === 'o') out.objects.push(rest.join(' '));
    else if (word === 'usemtl') material = rest.join(' ');
    else if (word === 'f') {
      out.faces.push(rest.map((c) => c.split('/').map((i) => (i ? Number(i) - 1 : -1))));
      out.materials.push(material);
    }
  }
  return out;
}

const srgb = (x) => (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055);
const isNear = (a, b, tolerance) => a.every((x, k) => Math.abs(x - b[k]) <= tolerance);

async function isValidGlb(name, least = 2) {
  const { issues } = await validator.validateBytes(new Uint8Array(readFileSync(at(name))));
  assert.deepEqual(
    issues.messages.filter(({ severity }) => severity < least),
    [],
    name,
  );
}

/** Triangles of a file as a set of sorted corners "x y z", to compare shapes. */
const shapeOf = (triangles) =>
  triangles.map((t) => t.map((p) => p.map((x) => Math.fround(x)).join(' ')).sort().join(' | ')).sort(); // prettier-ignore

test('OBJ, OFF, STL and PLY become GLB, with normals, colours and the names of materials', async () => {
  const { text, vertices, triangles } = richObj();
  put('rich.obj', text);
  const { err } = good('param', 'rich.obj', '-o', 'rich.glb');
  assert.match(err, sentenceOf('convert-materials-lost'));
  await isValidGlb('rich.glb');
  const document = await new NodeIO().read(at('rich.glb'));
  const [mesh] = document.getRoot().listMeshes();
  const found = [];
  const names = [];
  for (const primitive of mesh.listPrimitives()) {
    names.push(primitive.getMaterial().getName());
    const [position, normal, color, uv] = ['POSITION', 'NORMAL', 'COLOR_0', 'TEXCOORD_0'].map((s) =>
      primitive.getAttribute(s),
    );
    assert.ok(uv, 'the map is TEXCOORD_0');
    const indices = primitive.getIndices();
    for (let i = 0; i < indices.getCount(); i += 3) {
      const ids = [0, 1, 2].map((k) => indices.getScalar(i + k));
      found.push(ids.map((v) => position.getElement(v, [])));
      for (const v of ids) {
        const p = position.getElement(v, []);
        const rgb = color.getElement(v, []).slice(0, 3).map(srgb);
        const wanted = p.map((x) => Math.abs(x / 4) % 1);
        assert.ok(isNear(rgb, wanted, 1e-4), `${rgb} and ${wanted}`);
        const n = normal.getElement(v, []);
        assert.equal(n.filter((x) => x === 0).length, 2);
        assert.equal(primitive.getMaterial().getName(), n[2] !== 0 ? 'lid' : 'wall');
      }
    }
  }
  assert.deepEqual(names.sort(), ['lid', 'wall']);
  assert.deepEqual(shapeOf(found), shapeOf(triangles.map((t) => t.map((v) => vertices[v]))));
  assert.match(good('verify', 'rich.glb').out, /certified .*float32/);

  const plain = cubeMesh(3);
  put('cube.off', toOff(plain));
  put('cube.stl', toStl(plain));
  for (const name of ['cube.off', 'cube.stl']) {
    good('param', name, '-o', `${name}.glb`);
    await isValidGlb(`${name}.glb`);
    good('verify', `${name}.glb`);
  }
});

test('cones keep their vertices from OBJ to GLB, and those of another numbering are refused', () => {
  put('rich.obj', richObj().text);
  good('cones', 'rich.obj', '-o', 'rich.json');
  const { cones } = JSON.parse(readFileSync(at('rich.json'), 'utf8'));
  const list = cones.flatMap(({ vertex, k }) => ['--cone', `${vertex}:${k}`]);
  good('param', 'rich.obj', ...list, '-o', 'coned.glb');
  good('verify', 'coned.glb', ...list);
  // Two cubes in one place: GLB joins what OBJ keeps apart.
  const { vertices, triangles } = cubeMesh(2);
  const far = vertices.map(([x, y, z]) => [x + 40, y, z]);
  const twice = [...vertices, ...vertices.map((p) => [...p]), ...far];
  const faces = [0, 2].flatMap((k) => triangles.map((t) => t.map((v) => v + k * vertices.length)));
  put(
    'twice.obj',
    `${twice.map((p) => `v ${p.join(' ')}`).join('\n')}\n${faces.map((t) => `f ${t.map((v) => v + 1).join(' ')}`).join('\n')}\n`,
  );
  const { code, err } = run('param', 'twice.obj', '--cone', '3:2', '-o', 'twice.glb');
  assert.equal(code, 5, err);
  assert.match(err, /vertices get new ids/);
});

test('GLB becomes OBJ: node transforms applied, faces of mirrored nodes reversed', () => {
  const { json, bin } = toGltf([cubeMesh(3), cubeMesh(2)]);
  json.nodes = [
    { mesh: 0, name: 'left one', translation: [10, 0, 0], children: [1] },
    { mesh: 1, scale: [-1, 2, 1], rotation: [0, 0, Math.SQRT1_2, Math.SQRT1_2] },
    { mesh: 1, matrix: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 50, 1] },
  ];
  json.scenes = [{ nodes: [0, 2] }];
  put('scene.gltf', JSON.stringify(json));
  put('cube.bin', bin);
  good('param', 'scene.gltf', '-o', 'scene.obj');
  const { v, faces, objects } = readObj(readFileSync(at('scene.obj'), 'utf8'));
  assert.deepEqual(objects, ['left_one', 'mesh_1', 'mesh_1']);
  const [big, small] = [cubeMesh(3), cubeMesh(2)];
  const place = (mesh, f) => mesh.triangles.map((t) => t.map((i) => f(mesh.vertices[i])));
  const turn = ([x, y, z]) => [-2 * y + 10, -x, z]; // scale, a quarter turn about z, the parent
  const wanted = [
    ...place(big, ([x, y, z]) => [x + 10, y, z]),
    ...place(small, turn),
    ...place(small, ([x, y, z]) => [x, y, z + 50]),
  ];
  const round = (list) =>
    list.map((t) => t.map((p) => p.map((x) => Math.round(1e4 * x) / 1e4 + 0)));
  const found = faces.map((f) => f.map(([i]) => v[i]));
  assert.deepEqual(shapeOf(round(found)), shapeOf(round(wanted)));
  // All closed surfaces have the same sign of volume: nothing is inside out.
  const volume = (list) =>
    list.reduce(
      (sum, [a, b, c]) =>
        sum + a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]), // prettier-ignore
      0,
    );
  const sizes = [big.triangles.length, small.triangles.length];
  const part = (from, count) => Math.sign(volume(found.slice(from, from + count)));
  const signs = [part(0, sizes[0]), part(sizes[0], sizes[1]), part(sizes[0] + sizes[1], sizes[1])];
  assert.equal(new Set(signs).size, 1, `${signs}`);
  good('verify', 'scene.obj');
});

test('OBJ to GLB to OBJ keeps shape, normals, colours and material names', () => {
  const { text } = richObj();
  put('rich.obj', text);
  good('param', 'rich.obj', '-o', 'there.glb');
  good('param', 'there.glb', '-o', 'back.obj');
  const [before, afterwards] = ['rich.obj', 'back.obj'].map((n) =>
    readObj(readFileSync(at(n), 'utf8')),
  );
  const corners = (o) =>
    o.faces
      .flatMap((f, i) =>
        f.map(
          ([v, , n]) =>
          JSON.stringify([o.v[v].map(Math.fround), o.vn[n].map((x) => x + 0), o.colors[v].map((x) => Math.round(1e3 * x)), o.materials[i]]), // prettier-ignore
        ),
      )
      .sort();
  assert.deepEqual(corners(afterwards), corners(before));
  assert.equal(afterwards.v.length, before.v.length, 'vertices stay one');
});

const plyTypes = {
  char: [1, 'Int8'], uchar: [1, 'UInt8'], short: [2, 'Int16'], ushort: [2, 'UInt16'],
  int: [4, 'Int32'], uint: [4, 'UInt32'], float: [4, 'Float'], double: [8, 'Double'],
}; // prettier-ignore

/** A PLY as lists of rows by element, each a record by property; no help from the program. */
function readPly(bytes) {
  const end = bytes.indexOf('end_header\n') + 'end_header\n'.length;
  const header = bytes.subarray(0, end).toString('latin1').split('\n');
  const format = header.find((l) => l.startsWith('format')).split(' ')[1];
  const elements = [];
  for (const line of header) {
    const [word, ...rest] = line.split(' ');
    if (word === 'element')
      elements.push({ name: rest[0], count: Number(rest[1]), properties: [] });
    if (word === 'property') elements.at(-1).properties.push(rest);
  }
  let offset = end;
  const words = format === 'ascii' ? bytes.subarray(end).toString('latin1').split(/\s+/) : null;
  let word = 0;
  const take = (type) => {
    if (words) return Number(words[word++]);
    const [size, name] = plyTypes[type];
    const order = size === 1 ? '' : format === 'binary_big_endian' ? 'BE' : 'LE';
    const x = bytes[`read${name}${order}`](offset);
    offset += size;
    return x;
  };
  const out = { header, format };
  for (const { name, count, properties } of elements) {
    out[name] = [];
    for (let i = 0; i < count; i++) {
      const row = {};
      for (const p of properties) {
        row[p.at(-1)] =
          p[0] === 'list' ? Array.from({ length: take(p[1]) }, () => take(p[2])) : take(p[0]);
      }
      out[name].push(row);
    }
  }
  if (!words) assert.equal(offset, bytes.length, 'nothing is left over');
  return out;
}

/** A PLY of the cube with everything that people put into one. */
function richPly(format, { quads = false, uv = false } = {}) {
  const { vertices, triangles } = cubeMesh(3);
  const faces = quads
    ? Array.from({ length: triangles.length / 2 }, (_, i) => {
        const [a, b] = [triangles[2 * i], triangles[2 * i + 1]];
        const last = b.find((v) => !a.includes(v));
        const lone = a.findIndex((v) => !b.includes(v));
        return [a[lone], a[(lone + 1) % 3], last, a[(lone + 2) % 3]];
      })
    : triangles;
  const vertexProperties = [
    ['float', 'x'], ['float', 'y'], ['float', 'z'],
    ['float', 'nx'], ['float', 'ny'], ['float', 'nz'],
    ...(uv ? [['float', 's'], ['float', 't']] : []),
    ['uchar', 'red'], ['uchar', 'green'], ['uchar', 'blue'], ['uchar', 'alpha'],
    ['short', 'label'], ['double', 'quality'],
  ]; // prettier-ignore
  const vertex = ([x, y, z], i) => [
    x, y, z, 0.6, 0, -0.8, ...(uv ? [i / 100, 0.25] : []),
    (7 * i) % 256, (11 * i) % 256, 200, 255, i - 50, Math.PI * i,
  ]; // prettier-ignore
  const header = [
    'ply',
    `format ${format} 1.0`,
    'comment by a test',
    `element vertex ${vertices.length}`,
    ...vertexProperties.map((p) => `property ${p.join(' ')}`),
    `element face ${faces.length}`,
    'property uchar group',
    'property list uchar int vertex_indices',
    'property float weight',
    'element edge 2',
    'property int vertex1',
    'property int vertex2',
    'end_header\n',
  ].join('\n');
  if (format === 'ascii') {
    const rows = [
      ...vertices.map((p, i) => vertex(p, i).join(' ')),
      ...faces.map((f, i) => `${i % 5} ${f.length} ${f.join(' ')} 0.125`),
      '0 1',
      '1 2',
    ];
    return Buffer.from(`${header}${rows.join('\n')}\n`);
  }
  const parts = [Buffer.from(header)];
  const order = format === 'binary_big_endian' ? 'BE' : 'LE';
  const write = (type, x) => {
    const [size, name] = plyTypes[type];
    const b = Buffer.alloc(size);
    b[`write${name}${size === 1 ? '' : order}`](x);
    parts.push(b);
  };
  vertices.forEach((p, i) => vertex(p, i).forEach((x, k) => write(vertexProperties[k][0], x)));
  faces.forEach((f, i) => {
    write('uchar', i % 5);
    write('uchar', f.length);
    f.forEach((v) => write('int', v));
    write('float', 0.125);
  });
  [0, 1, 1, 2].forEach((v) => write('int', v));
  return Buffer.concat(parts);
}

for (const format of ['ascii', 'binary_little_endian', 'binary_big_endian'])
  for (const more of [{}, { quads: true }, { uv: true }])
    test(`PLY stays PLY (${format}, ${Object.keys(more)[0] ?? 'triangles'}): every property, and a map`, () => {
      const bytes = richPly(format, more);
      put('rich.ply', bytes);
      good('param', 'rich.ply', '-o', 'mapped.ply');
      const [before, afterwards] = [readPly(bytes), readPly(readFileSync(at('mapped.ply')))];
      assert.equal(afterwards.format, format);
      for (const name of ['vertex', 'face', 'edge']) {
        const strip = ({ s: _s, t: _t, texcoord: _u, ...rest }) => rest;
        assert.deepEqual(afterwards[name].map(strip), before[name].map(strip), name);
      }
      assert.ok(!('s' in afterwards.vertex[0]), 'uv that no longer fit are gone');
      for (const { vertex_indices, texcoord } of afterwards.face)
        assert.equal(texcoord.length, 2 * vertex_indices.length);
      good('verify', 'mapped.ply');
      // The same numbers as in OBJ, as floats.
      good('param', 'rich.ply', '-o', 'mapped.obj');
      const { vt, faces } = readObj(readFileSync(at('mapped.obj'), 'utf8'));
      const largest = Math.max(...vt.flat().map(Math.abs));
      afterwards.face.forEach(({ texcoord }, f) => {
        const wanted = faces[f].flatMap(([, i]) => vt[i]);
        assert.ok(isNear(texcoord, wanted, 4e-7 * largest), `${texcoord} ${wanted}`);
        for (const x of texcoord) assert.equal(Math.fround(x), x);
      });
      // Mapped again: the same file.
      good('param', 'mapped.ply', '-o', 'again.ply');
      assert.deepEqual(readFileSync(at('again.ply')), readFileSync(at('mapped.ply')));
      const header = readPly(readFileSync(at('again.ply'))).header;
      assert.ok(header.some((l) => / float texcoord$/.test(l)));
    });

test('PLY colours and normals reach GLB', async () => {
  put('rich.ply', richPly('binary_little_endian'));
  good('param', 'rich.ply', '-o', 'ply.glb');
  await isValidGlb('ply.glb');
  const document = await new NodeIO().read(at('ply.glb'));
  const [primitive] = document.getRoot().listMeshes()[0].listPrimitives();
  const normal = primitive.getAttribute('NORMAL').getElement(0, []);
  assert.ok(isNear(normal, [0.6, 0, -0.8], 1e-6), `${normal}`);
  const colors = primitive.getAttribute('COLOR_0');
  const blue = srgb(colors.getElement(3, [])[2]) * 255;
  assert.ok(Math.abs(blue - 200) < 0.01, `${blue}`);
});

const pixel = Buffer.from(
  'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==',
  'base64',
);
function putScene() {
  const { json, bin } = toGltf([cubeMesh(3)], { buffer: 'bins/cube.bin', image: 'tex/a%20b.png' });
  put('model/scene.gltf', JSON.stringify(json));
  put('model/bins/cube.bin', bin);
  put('model/tex/a b.png', pixel);
}

test('a .gltf written elsewhere copies or embeds its side files, or becomes a GLB', async () => {
  putScene();
  const images = async (name) => {
    const document = await new NodeIO().read(at(name));
    const root = document.getRoot();
    assert.ok(root.listMeshes()[0].listPrimitives()[0].getAttribute('TEXCOORD_0'));
    return root.listTextures().map((t) => Buffer.from(t.getImage()));
  };
  mkdirSync(at('out'), { recursive: true });
  good('param', 'model/scene.gltf', '-o', 'out/scene.gltf');
  for (const name of ['out/bins/cube.bin', 'out/tex/a b.png'])
    assert.ok(existsSync(at(name)), name);
  good('verify', 'out/scene.gltf');
  assert.deepEqual(await images('out/scene.gltf'), [pixel]);
  // Again: the same files are there already.
  good('param', 'model/scene.gltf', '-o', 'out/scene.gltf');
  put('out/tex/a b.png', 'something else');
  const refused = run('param', 'model/scene.gltf', '-o', 'out/scene.gltf');
  assert.equal(refused.code, 2, refused.err);
  assert.match(refused.err, /a b\.png is another file/);
  assert.equal(readFileSync(at('out/tex/a b.png'), 'utf8'), 'something else');

  mkdirSync(at('inside'), { recursive: true });
  good('param', 'model/scene.gltf', '--embed', '-o', 'inside/scene.gltf');
  assert.deepEqual(await images('inside/scene.gltf'), [pixel]);
  const { buffers } = JSON.parse(readFileSync(at('inside/scene.gltf'), 'utf8'));
  assert.ok(buffers.every(({ uri }) => uri.startsWith('data:')));

  good('param', 'model/scene.gltf', '-o', 'packed.glb');
  await isValidGlb('packed.glb');
  assert.deepEqual(await images('packed.glb'), [pixel]);
  good('verify', 'packed.glb');
  rmSync(at('model/tex/a b.png'));
  // Images are not needed for the map: a reference to a missing one is kept, and a note says so.
  mkdirSync(at('gone'), { recursive: true });
  for (const words of [['gone/packed.glb'], ['gone/scene.gltf'], ['gone/inside.gltf', '--embed']]) {
    const { err } = good('param', 'model/scene.gltf', '-o', ...words);
    assert.match(err, sentenceOf('read-file-refused', { why: 'tex/a b.png' }), words[0]);
    const bytes = readFileSync(at(words[0]));
    const text = words[0].endsWith('.glb')
      ? bytes.subarray(20, 20 + bytes.readUInt32LE(12))
      : bytes;
    assert.deepEqual(
      JSON.parse(text).images.map(({ uri }) => uri),
      ['tex/a%20b.png'],
    );
    good('verify', words[0]);
  }
  assert.equal(existsSync(at('gone/tex')), false);
  rmSync(at('model/bins/cube.bin'));
  const missing = run('param', 'model/scene.gltf', '-o', 'packed.glb');
  assert.equal(missing.code, 3);
  assert.match(missing.err, /cube\.bin is missing/);
});

test('images whose names need encoding are copied; those outside the folder are named', () => {
  const { json, bin } = toGltf([cubeMesh(3)], {
    buffer: 'cube%20%26%20100%25.bin',
    image: 'Material%20%2325.png',
  });
  json.images.push({ uri: '../above.png' }, { uri: 'https://example.org/far.png' });
  put('named/scene.gltf', JSON.stringify(json));
  put('named/cube & 100%.bin', bin);
  put('named/Material #25.png', pixel);
  put('above.png', pixel);
  mkdirSync(at('moved/deeper'), { recursive: true });
  const { err } = good('param', 'named/scene.gltf', '-o', 'moved/deeper/scene.gltf');
  assert.deepEqual(readFileSync(at('moved/deeper/Material #25.png')), pixel);
  assert.deepEqual(readFileSync(at('moved/deeper/cube & 100%.bin')), Buffer.from(bin));
  assert.match(err, sentenceOf('write-file-refused'));
  assert.doesNotMatch(err, /far\.png/);
  assert.equal(existsSync(at('moved/above.png')), false);
  good('verify', 'moved/deeper/scene.gltf');
});

test('a GLB becomes a .gltf with its bytes beside it or inside it, and so does an OBJ', async () => {
  writeFileSync(at('scene.glb'), toGlb([cubeMesh(2), cubeMesh(3)]));
  const corners = async (name) => {
    const document = await new NodeIO().read(at(name));
    return document
      .getRoot()
      .listMeshes()
      .map((mesh) => mesh.listPrimitives()[0])
      .map((p) => [...p.getIndices().getArray()].map((i) => p.getAttribute('POSITION').getElement(i, []))); // prettier-ignore
  };
  for (const [output, side, more] of [
    ['apart/scene.gltf', ['scene.bin'], []],
    ['embedded/scene.gltf', [], ['--embed']],
  ]) {
    mkdirSync(path.dirname(at(output)));
    good('param', 'scene.glb', '-o', output, ...more);
    assert.deepEqual(readdirSync(path.dirname(at(output))), [...side, 'scene.gltf']);
    assert.match(good('verify', output).out, /2 of 2 meshes certified/);
    assert.deepEqual(await corners(output), await corners('scene.glb'));
    const { buffers } = JSON.parse(readFileSync(at(output), 'utf8'));
    assert.equal(buffers.length, 1);
  }
  // One mesh of it, and all of it again into the same folder.
  good('param', 'scene.glb', '--mesh', '1', '-o', 'apart/one.gltf');
  good('param', 'scene.glb', '-o', 'apart/scene.gltf');
  put('rich.obj', richObj().text);
  good('param', 'rich.obj', '-o', 'apart/rich.gltf');
  const document = await new NodeIO().read(at('apart/rich.gltf'));
  assert.ok(document.getRoot().listMeshes()[0].listPrimitives()[0].getAttribute('NORMAL'));
  good('verify', 'apart/rich.gltf');
});

test('output names of no format, or of one that this input cannot have, are refused at once', () => {
  put('rich.obj', richObj().text);
  writeFileSync(at('cube.glb'), toGlb([cubeMesh(2)]));
  for (const [input, output] of [
    ['rich.obj', 'x.fbx'],
    ['rich.obj', 'x.ply'],
    ['cube.glb', 'x.ply'],
    ['cube.glb', 'x.usdz'],
  ]) {
    const { code, err } = run('param', input, '-o', output);
    assert.equal(code, 2, `${input} ${output}: ${err}`);
    assert.ok(!existsSync(at(output)));
  }
});

test('glTF: a note says which set was written, and --use lets the materials follow', async () => {
  const { json, bin } = toGltf([cubeMesh(3), cubeMesh(2)], { image: 'pixel.png' });
  json.extensionsUsed = ['KHR_texture_transform', 'KHR_materials_clearcoat'];
  const [material] = json.materials;
  material.normalTexture = {
    index: 0,
    extensions: { KHR_texture_transform: { texCoord: 0, scale: [2, 2] } },
  };
  material.extensions = { KHR_materials_clearcoat: { clearcoatTexture: { index: 0 } } };
  put('look/cube.bin', bin);
  put('look/pixel.png', pixel);
  put('look/plain.gltf', JSON.stringify(json));
  const first = good('param', 'look/plain.gltf', '-o', 'look/first.gltf');
  assert.doesNotMatch(first.err, /TEXCOORD/, 'the pictures had no set, and now have this one');
  // hgp's own set is replaced; as the set of another program it is kept.
  const own = good('param', 'look/first.gltf', '-o', 'look/own.gltf');
  assert.match(own.err, /TEXCOORD_0 was replaced: the materials' pictures .* no longer fit/);
  const { accessors, ...rest } = JSON.parse(readFileSync(at('look/first.gltf'), 'utf8'));
  const marked = accessors.filter(({ extras }) => extras?.hgp === 'uv');
  assert.equal(marked.length, 2);
  for (const accessor of marked) delete accessor.extras;
  put('look/first.gltf', JSON.stringify({ ...rest, accessors }));
  const second = good('param', 'look/first.gltf', '-o', 'look/second.gltf');
  assert.match(second.err, sentenceOf('write-set-unused', { set: 1, others: 'TEXCOORD_0' }));
  const replaced = good('param', 'look/first.gltf', '--uv-set', '0', '-o', 'look/zero.gltf');
  assert.match(replaced.err, /TEXCOORD_0 was replaced: the materials' pictures .* no longer fit/);
  const sets = (file) => {
    const { materials, meshes } = JSON.parse(readFileSync(at(file), 'utf8'));
    return meshes.map(({ primitives: [p] }) => {
      const m = materials[p.material];
      return [
        m.pbrMetallicRoughness.baseColorTexture.texCoord ?? 0,
        m.normalTexture.extensions.KHR_texture_transform.texCoord,
        m.extensions.KHR_materials_clearcoat.clearcoatTexture.texCoord ?? 0,
      ];
    });
  };
  assert.deepEqual(sets('look/second.gltf'), [
    [0, 0, 0],
    [0, 0, 0],
  ]);
  // One mesh of two: the other one keeps the material as it was.
  const used = good('param', 'look/first.gltf', '--mesh', '1', '--use', '-o', 'look/one.gltf');
  assert.match(used.err, sentenceOf('write-set-used', { set: 1 }));
  assert.deepEqual(sets('look/one.gltf'), [
    [0, 0, 0],
    [1, 1, 1],
  ]);
  good('param', 'look/first.gltf', '--use', '-o', 'look/both.gltf');
  assert.deepEqual(sets('look/both.gltf'), [
    [1, 1, 1],
    [1, 1, 1],
  ]);
  good('param', 'look/first.gltf', '--use', '-o', 'both.glb');
  await isValidGlb('both.glb', 1); // the material asks for tangents, before and after
  const document = await new NodeIO().read(at('look/both.gltf'));
  for (const each of document
    .getRoot()
    .listMaterials()
    .filter((m) => m.listParents().length > 1))
    assert.equal(each.getNormalTextureInfo().getTexCoord(), 1);
});

test('glTF: textures whose set is missing or without area use the new one unless told otherwise', () => {
  const flat = ([x, y]) => [x / 3, y / 3];
  const point = () => [0.5, 0.5];
  const cases = {
    'seen with its set': { uv: { 0: flat }, asks: 0, uses: 0 },
    'asks for a set that is not there': { uv: { 0: flat }, asks: 3, uses: 1, code: 'write-set-unseen' }, // prettier-ignore
    'has no area in its set': { uv: { 0: point }, asks: 0, uses: 1, code: 'write-set-unseen' },
    'has no area in one of two': { uv: { 0: flat, 1: point }, asks: 1, uses: 2, code: 'write-set-unseen' }, // prettier-ignore
  };
  for (const [what, { uv, asks, uses, code }] of Object.entries(cases)) {
    const { json, bin } = toGltf([cubeMesh(3)], { image: 'pixel.png', uv });
    const [material] = json.materials;
    material.pbrMetallicRoughness.baseColorTexture.texCoord = asks;
    material.normalTexture = { index: 0 }; // of set 0
    put('fit/cube.bin', bin);
    put('fit/pixel.png', pixel);
    put('fit/in.gltf', JSON.stringify(json));
    const setsAfter = (...more) => {
      const { err } = good('param', 'fit/in.gltf', ...more, '--force', '-o', 'fit/out.gltf');
      const { materials, meshes } = JSON.parse(readFileSync(at('fit/out.gltf'), 'utf8'));
      assert.ok(`TEXCOORD_${Object.keys(uv).length}` in meshes[0].primitives[0].attributes, what);
      for (const set of Object.keys(uv)) assert.ok(`TEXCOORD_${set}` in meshes[0].primitives[0].attributes, 'old sets are kept'); // prettier-ignore
      const { pbrMetallicRoughness, normalTexture } = materials[0];
      return { err, base: pbrMetallicRoughness.baseColorTexture.texCoord ?? 0, normal: normalTexture.texCoord ?? 0 }; // prettier-ignore
    };
    const found = setsAfter();
    assert.equal(found.base, uses, what);
    assert.equal(found.normal, uv[0] === point ? uses : 0, `${what}: others stay where they are seen`); // prettier-ignore
    if (code) assert.match(found.err, sentenceOf(code, { set: uses, others: `TEXCOORD_${asks}` }));
    else assert.doesNotMatch(found.err, sentenceOf('write-set-unseen'));
    assert.equal(setsAfter('--use=false').base, asks, `${what}, kept`);
    assert.equal(setsAfter('--use').base, Object.keys(uv).length, `${what}, moved`);
  }
});

test('param of its own output is a fixed point, and a file has one side file for its maps', () => {
  const cubes = Array.from({ length: 12 }, (_, i) => cubeMesh(1 + (i % 3)));
  const { json, bin } = toGltf(cubes);
  put(`many/${json.buffers[0].uri}`, bin);
  put('many/cubes.gltf', JSON.stringify(json));
  good('param', 'many/cubes.gltf', '-o', 'many/mapped.gltf');
  const files = () => readdirSync(at('many')).sort();
  const before = files();
  assert.equal(before.filter((name) => name.startsWith('mapped')).length, 2, before.join());
  const bytes = () =>
    ['mapped.gltf', 'mapped-uv.bin'].map((name) => readFileSync(at(`many/${name}`)));
  const once = bytes();
  good('param', 'many/mapped.gltf', '--force', '-o', 'many/mapped.gltf');
  assert.deepEqual(bytes(), once);
  assert.deepEqual(files(), before);
  assert.match(good('verify', 'many/mapped.gltf').out, /12 of 12 meshes certified/);
  // Under another name the side file is another one.
  good('param', 'many/mapped.gltf', '-o', 'many/next.gltf');
  assert.deepEqual(readFileSync(at('many/next-uv.bin')), once[1]);
  assert.match(good('verify', 'many/next.gltf').out, /12 of 12 meshes certified/);
  for (const [name, text] of [
    ['one.glb', toGlb(cubes.slice(0, 4))],
    ['one.obj', richObj().text],
  ]) {
    put(`many/${name}`, text);
    good('param', `many/${name}`, '-o', `many/1${name}`);
    good('param', `many/1${name}`, '-o', `many/2${name}`);
    assert.deepEqual(readFileSync(at(`many/2${name}`)), readFileSync(at(`many/1${name}`)), name);
  }
});

test('an OBJ takes its materials and their pictures to another folder', () => {
  put('with/a.obj', `mtllib a.mtl\n${toObj(cubeMesh(2))}`);
  put('with/a.mtl', 'newmtl one\nKd 1 0 0\nmap_Kd -s 2 2 1 maps/skin.png\nmap_Bump lost.png\n');
  put('with/maps/skin.png', pixel);
  mkdirSync(at('away'));
  const { err } = good('param', 'with/a.obj', '-o', 'away/b.obj');
  assert.match(err, sentenceOf('read-file-refused', { why: 'lost.png' }));
  assert.deepEqual(readFileSync(at('away/a.mtl')), readFileSync(at('with/a.mtl')));
  assert.deepEqual(readFileSync(at('away/maps/skin.png')), readFileSync(at('with/maps/skin.png')));
});
