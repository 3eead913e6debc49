// The page's own readers of written files against writers of the test, type by type: the numbers that come out are those that
// went in, whatever they are stored as.

import assert from 'node:assert/strict';
import test from 'node:test';
import { MeshoptEncoder } from 'meshoptimizer';
import { MeshoptDecoder } from 'three/addons/libs/meshopt_decoder.module.js';
import { readPly } from '../../../web/src/formats/read_ply.ts';
import { isMeshoptUsed, readUv } from '../../../web/src/formats/read_uv.ts';

const near = (a, b, what) => {
  assert.equal(a.length, b.length, `${what}: as many`);
  Array.from(a).forEach((x, i) => assert.ok(Math.abs(x - b[i]) < 1e-6, `${what}: ${i}: ${x} and ${b[i]}`)); // prettier-ignore
};

/** By component type: size, largest value where it is a fraction, writer. */
const types = {
  5120: [1, 127, 'setInt8'],
  5121: [1, 255, 'setUint8'],
  5122: [2, 32767, 'setInt16'],
  5123: [2, 65535, 'setUint16'],
  5125: [4, 1, 'setUint32'],
  5126: [4, 1, 'setFloat32'],
};

/** A buffer of items with room before the first and between them. */
function stored(items, type, { before = 0, gap = 0 } = {}) {
  const [size, , set] = types[type];
  const width = items[0].length;
  const stride = size * width + gap;
  const bytes = new Uint8Array(before + stride * items.length).fill(0x55);
  const view = new DataView(bytes.buffer);
  items.forEach((item, i) => item.forEach((x, k) => view[set](before + i * stride + k * size, x, true))); // prettier-ignore
  return { bytes, stride };
}

const positions = [[0, 0, 0], [3, 0, 1], [0, 5, 2], [7, 8, 9], [2, 6, 4]]; // prettier-ignore
const coordinates = [[0, 0], [1, 0], [0, 1], [1, 1], [0, 1]]; // prettier-ignore
const named = { 1: 'SCALAR', 2: 'VEC2', 3: 'VEC3' };

/** A glTF file of one primitive; each part has its type, and how it is stored. */
class Writer {
  json = { asset: { version: '2.0' }, buffers: [], bufferViews: [], accessors: [], meshes: [] };
  parts = [];
  #length = 0;
  view(bytes, more = {}) {
    this.json.bufferViews.push({ buffer: 0, byteOffset: this.#length || undefined, byteLength: bytes.length, ...more }); // prettier-ignore
    this.parts.push(bytes);
    this.#length += bytes.length;
    return this.json.bufferViews.length - 1;
  }
  accessor(items, componentType, { normalized, before = 0, gap = 0, ...more } = {}) {
    const { bytes, stride } = stored(items, componentType, { before, gap });
    const bufferView = this.view(bytes, gap > 0 ? { byteStride: stride } : {});
    this.json.accessors.push({ bufferView, componentType, count: items.length, type: named[items[0].length], ...(before > 0 ? { byteOffset: before } : {}), ...(normalized ? { normalized } : {}), ...more }); // prettier-ignore
    return this.json.accessors.length - 1;
  }
  files(primitives) {
    this.json.meshes = [{ primitives }];
    const bin = new Uint8Array(this.parts.flatMap((one) => [...one]));
    this.json.buffers = [{ uri: 'a%20b.bin', byteLength: bin.length }];
    return [
      { name: 'a.gltf', bytes: new TextEncoder().encode(JSON.stringify(this.json)) },
      { name: 'other.bin', bytes: new Uint8Array(bin.length) },
      { name: 'a b.bin', bytes: bin },
    ];
  }
}
const cornersOf = (list) => ({ positions: list.flatMap((v) => positions[v]), uv: list.flatMap((v) => [coordinates[v][0], 1 - coordinates[v][1]]) }); // prettier-ignore
function same(read, list, what) {
  near(read.positions, cornersOf(list).positions, what);
  near(read.uv, cornersOf(list).uv, what);
}

test('glTF: places, coordinates and triangles of every type, with any stride and offset', () => {
  const list = [0, 1, 2, 2, 1, 3, 4, 3, 0];
  for (const type of Object.keys(types).map(Number)) {
    const [, max] = types[type];
    for (const room of [{}, { before: 8 }, { gap: 4 }, { before: 4, gap: 8 }]) {
      const file = new Writer();
      const isFraction = type < 5125;
      const uv = coordinates.map((pair) => pair.map((x) => x * (isFraction ? max : 1)));
      const attributes = { POSITION: file.accessor(positions, type, room), TEXCOORD_0: file.accessor(uv, type, { ...room, normalized: isFraction }) }; // prettier-ignore
      const isIndex = [5121, 5123, 5125].includes(type);
      const indices = file.accessor(list.map((v) => [v]), isIndex ? type : 5125, { before: room.before }); // prettier-ignore
      same(readUv(file.files([{ attributes, indices }]), 0), list, `${type} ${JSON.stringify(room)}`); // prettier-ignore
    }
  }
  // Signed fractions end at −1, whose number is one further away.
  for (const [type, low] of [
    [5120, -128],
    [5122, -32768],
  ]) {
    // prettier-ignore
    const file = new Writer();
    const attributes = { POSITION: file.accessor(positions.slice(0, 3), 5126), TEXCOORD_0: file.accessor([[low, 0], [low + 1, 0], [0, low]], type, { normalized: true }) }; // prettier-ignore
    near(readUv(file.files([{ attributes }]), 0).uv, [-1, 1, -1, 1, 0, 2], `${type}`);
  }
});

test('glTF: triangles in a row, in strips and in fans; degenerate ones, points and lines are none', () => {
  const cases = [
    [4, [0, 1, 2, 2, 1, 3], [0, 1, 2, 2, 1, 3]],
    [5, [0, 1, 2, 3, 4], [0, 1, 2, 1, 3, 2, 2, 3, 4]],
    [6, [0, 1, 2, 3, 4], [1, 2, 0, 2, 3, 0, 3, 4, 0]],
    [5, [0, 1, 1, 3, 4], [1, 3, 4]],
    [5, [0, 1, 0, 3, 2], [1, 3, 0, 0, 3, 2]],
    [6, [0, 1, 1, 3, 0], [1, 3, 0]],
    [5, [0, 1], []],
    [1, [0, 1, 2, 3], []],
    [0, [0, 1, 2], []],
  ];
  for (const [mode, list, expected] of cases) {
    const file = new Writer();
    const attributes = { POSITION: file.accessor(positions, 5126), TEXCOORD_0: file.accessor(coordinates, 5126) }; // prettier-ignore
    const triangles = { attributes, indices: file.accessor([[0], [1], [2]], 5121), mode: 4 };
    const indices = file.accessor(list.map((v) => [v]), 5121); // prettier-ignore
    const bare = { attributes: { TEXCOORD_0: attributes.TEXCOORD_0 }, mode: 4 };
    const other = { attributes: { POSITION: attributes.POSITION }, mode: 4 };
    const read = readUv(file.files([triangles, bare, other, { attributes, indices, mode }]), 0);
    same(read, [0, 1, 2, ...expected], `mode ${mode}: ${list}`);
  }
  const file = new Writer();
  const attributes = { POSITION: file.accessor(positions.slice(0, 3), 5126), TEXCOORD_0: file.accessor(coordinates.slice(0, 3), 5126) }; // prettier-ignore
  same(readUv(file.files([{ attributes }]), 0), [0, 1, 2], 'without indices, in order');
});

test('glTF: of several sets the asked one, else the last without a gap', () => {
  const file = new Writer();
  const POSITION = file.accessor(positions.slice(0, 3), 5126);
  const set = (n) => file.accessor([[n, 0], [n, 1], [0, n]], 5126); // prettier-ignore
  const attributes = { POSITION, TEXCOORD_0: set(1), TEXCOORD_1: set(2), TEXCOORD_2: set(3), TEXCOORD_4: set(5) }; // prettier-ignore
  const files = file.files([{ attributes }]);
  const first = (uvSet) => readUv(files, 0, uvSet).uv[0];
  assert.deepEqual([undefined, 0, 1, 2, 3, 4].map(first), [3, 1, 2, 3, undefined, 5]);
});

test('glTF: values that are stored apart replace those of the list, or zeros where there is none', () => {
  for (const componentType of [5121, 5123, 5125]) {
    const file = new Writer();
    const POSITION = file.accessor(positions, 5126);
    const sparse = (items) => ({
      count: items.length,
      indices: { bufferView: file.view(stored(items.map(([i]) => [i]), componentType, { before: 4 }).bytes), byteOffset: 4, componentType }, // prettier-ignore
      values: { bufferView: file.view(stored(items.map(([, pair]) => pair), 5126).bytes) }, // prettier-ignore
    });
    const zeros = coordinates.map(() => [9, 9]);
    const all = coordinates.map((pair, i) => [i, pair]);
    const TEXCOORD_0 = file.accessor(zeros, 5126, { sparse: sparse(all) });
    const list = [0, 1, 2, 3, 4, 0];
    const indices = file.accessor(list.map((v) => [v]), 5121); // prettier-ignore
    same(readUv(file.files([{ attributes: { POSITION, TEXCOORD_0 }, indices }]), 0), list, `${componentType}`); // prettier-ignore
    // Only two of them, the others zero.
    const some = sparse([all[1], all[3]]);
    file.json.accessors.push({ componentType: 5126, count: 5, type: 'VEC2', sparse: some });
    const read = readUv(file.files([{ attributes: { POSITION, TEXCOORD_0: file.json.accessors.length - 1 }, indices }]), 0); // prettier-ignore
    near(read.uv, list.flatMap((v) => (v === 1 || v === 3 ? [coordinates[v][0], 1 - coordinates[v][1]] : [0, 1])), 'sparse'); // prettier-ignore
  }
});

test('glTF: buffers that are compressed are read with a decoder, and refused without', async () => {
  await Promise.all([MeshoptEncoder.ready, MeshoptDecoder.ready]);
  for (const extension of ['EXT_meshopt_compression', 'KHR_meshopt_compression']) {
    const file = new Writer();
    const packed = (items) => {
      const { bytes, stride } = stored(items, 5126);
      const encoded = MeshoptEncoder.encodeVertexBuffer(bytes, items.length, stride);
      const at = file.json.bufferViews.length;
      file.view(encoded);
      const { byteOffset, byteLength } = file.json.bufferViews[at];
      const about = { buffer: 0, byteOffset, byteLength, byteStride: stride, count: items.length, mode: 'ATTRIBUTES' }; // prettier-ignore
      file.json.bufferViews[at] = { buffer: 7, byteLength: bytes.length, extensions: { [extension]: about } }; // prettier-ignore
      file.json.accessors.push({ bufferView: at, componentType: 5126, count: items.length, type: named[items[0].length] }); // prettier-ignore
      return file.json.accessors.length - 1;
    };
    const attributes = { POSITION: packed(positions.slice(0, 3)), TEXCOORD_0: packed(coordinates.slice(0, 3)) }; // prettier-ignore
    file.json.extensionsUsed = ['other', extension];
    const files = file.files([{ attributes }]);
    assert.equal(isMeshoptUsed(files[0]), true);
    assert.equal(isMeshoptUsed({ ...files[0], name: 'a.obj' }), false);
    same(readUv(files, 0, undefined, MeshoptDecoder), [0, 1, 2], extension);
    assert.throws(() => readUv(files, 0));
  }
  const plain = new Writer();
  for (const extensionsUsed of [undefined, [], ['KHR_texture_transform']]) {
    plain.json.extensionsUsed = extensionsUsed;
    assert.equal(isMeshoptUsed(plain.files([])[0]), false);
  }
});

/** The types of a PLY file, with both of their names. */
const plyTypes = {
  int8: [1, 'setInt8', 'char', -100],
  uint8: [1, 'setUint8', 'uchar', 200],
  int16: [2, 'setInt16', 'short', -30000],
  uint16: [2, 'setUint16', 'ushort', 60000],
  int32: [4, 'setInt32', 'int', -2e9],
  uint32: [4, 'setUint32', 'uint', 4e9],
  float32: [4, 'setFloat32', 'float', 0.25],
  float64: [8, 'setFloat64', 'double', 0.1],
};

test('PLY: numbers of every type, in both orders of bytes and as text; other elements are passed over', () => {
  for (const [type, [, , old, odd]] of Object.entries(plyTypes)) {
    for (const name of [type, old]) {
      for (const format of ['binary_little_endian', 'binary_big_endian', 'ascii']) {
        const out = [];
        const put = (kind, x) => out.push([kind, x]);
        const header = ['ply', `format ${format} 1.0`, 'comment by a test', 'element edge 1', `property ${name} weight`, 'element vertex 4', `property ${name} y`, `property ${name} x`, 'property uchar red', `property ${name} z`, 'element face 3', 'property uchar flags', `property list uchar ${type.startsWith('float') ? 'int' : name} vertex_indices`, 'property list uint8 float texcoord', 'element more 1', `property list int ${name} vertex_indices`, 'end_header']; // prettier-ignore
        put(type, odd);
        const places = [[0, 0, 0], [1, 0, odd], [0, 1, 2], [1, 1, 3]]; // prettier-ignore
        for (const [x, y, z] of places) [[type, y], [type, x], ['uint8', 77], [type, z]].forEach((one) => put(...one)); // prettier-ignore
        const faces = [[0, 1, 2], [1, 3], [1, 3, 2]]; // prettier-ignore
        for (const face of faces) {
          put('uint8', 9);
          put('uint8', face.length);
          for (const v of face) put(type.startsWith('float') ? 'int32' : type, v);
          put('uint8', 2 * face.length);
          for (const v of face) [0.5, -0.5].forEach((x) => put('float32', v + x));
        }
        put('int32', 3);
        for (const v of [0, 1, 2]) put(type, v);
        const head = new TextEncoder().encode(`${header.join('\n')}\n`);
        const size = out.reduce((sum, [kind]) => sum + plyTypes[kind][0], 0);
        const view = new DataView(new ArrayBuffer(size));
        let at = 0;
        for (const [kind, x] of out) {
          view[plyTypes[kind][1]](at, x, format === 'binary_little_endian');
          at += plyTypes[kind][0];
        }
        const body = format === 'ascii' ? new TextEncoder().encode(`${out.map(([, x]) => x).join(' ')}\n`) : new Uint8Array(view.buffer); // prettier-ignore
        // Not at the beginning of its buffer, as what comes from a worker may be.
        const bytes = new Uint8Array([1, 2, 3, ...head, ...body]).subarray(3);
        const read = readPly(bytes);
        const list = [0, 1, 2, 1, 3, 2];
        near(read.positions, list.flatMap((v) => places[v]), `${name} ${format}`); // prettier-ignore
        near(read.uv, list.flatMap((v) => [v + 0.5, v - 0.5]), `${name} ${format}`); // prettier-ignore
        assert.equal(read.sizes, undefined, 'triangles alone');
      }
    }
  }
});

test('PLY as text: whatever blanks, ends of lines and comments are before, between and behind its numbers', () => {
  const header = ['ply', 'format ascii 1.0', 'element vertex 3', 'property float x', 'property float y', 'property float z', 'element face 1', 'property list uchar int vertex_indices', 'property list uchar float texcoord', 'end_header']; // prettier-ignore
  const rows = ['0 0 7', '1 0 0', '0 1 0', '3 2 0 1 6 .5 .25 1 0 0 1'];
  const plain = readPly(new TextEncoder().encode(`${[...header, ...rows].join('\n')}\n`));
  assert.deepEqual([[...plain.positions], [...plain.uv]], [[0, 1, 0, 0, 0, 7, 1, 0, 0], [0.5, 0.25, 1, 0, 0, 1]]); // prettier-ignore
  for (const end of ['\n', '\r\n', '\r'])
    for (const before of ['', ' ', '\t', `${end}${end}`])
      for (const between of [end, ` ${end}  `, `${end}comment 5 6 7${end}`])
        for (const behind of ['', end, `  ${end}`]) {
          const head = `${header.join(end)}${end}`;
          const text = `${head}${before}${rows.join(between)}${behind}`;
          assert.deepEqual(readPly(new TextEncoder().encode(text)), plain, JSON.stringify(text.slice(head.length))); // prettier-ignore
        }
});

test('OBJ: faces name corners from either end, before or behind what they name; comments and the rest of a line are not read', () => {
  const v = ['v 0 0 7', 'v 1 0 0 1 1 1', '\tv 0 1 0', 'v 1 1 -2e0'];
  const vt = ['vt .5 .25', 'vt 1 0 0', 'vt 0.125', 'vt 0 1'];
  const places = [[0, 0, 7], [1, 0, 0], [0, 1, 0], [1, 1, -2]]; // prettier-ignore
  const coordinates = [[0.5, 0.25], [1, 0], [0.125, 0], [0, 1]]; // prettier-ignore
  const corners = [0, 1, 2, 2, 1, 3];
  const expected = [corners.flatMap((c) => places[c]), corners.flatMap((c) => coordinates[c])];
  const fromStart = ['f 1/1 2/2 3/3', ' f 3/3/7 2/2/1 4/4/2'];
  const fromEnd = ['f -4/-4 -3/-3 -2/-2', 'fo -2/-2 -3/-3 -1/-1'];
  const orders = [[...v, ...vt, ...fromStart], [...vt, ...v, ...fromEnd], [...fromStart, ...v, ...vt], [vt[0], ...v, fromStart[0], ...vt.slice(1), fromStart[1]]]; // prettier-ignore
  const others = [
    '',
    'vn 0 0 1',
    'vp 5',
    'o v 1 2 3',
    '# v 5 5 5',
    'usemtl f',
    'l 1 2',
    'f 1/1 2/2',
    '#',
  ];
  const endings = ['', ' ', ' # 4/4', '#9'];
  for (const lines of orders)
    for (const [i, other] of others.entries())
      for (const end of ['\n', '\r\n', '\r']) {
        const text = lines.toSpliced(i, 0, other).map((line, at) => line + endings[(at + i) % 4]);
        const read = readUv([{ name: 'a.obj', bytes: new TextEncoder().encode(text.join(end)) }], 0); // prettier-ignore
        assert.deepEqual([[...read.positions], [...read.uv]], expected, JSON.stringify(text));
        assert.equal(read.sizes, undefined);
      }
  // A corner that names no coordinate has none, also where coordinates come later.
  const without = readUv([{ name: 'a.obj', bytes: new TextEncoder().encode([...v, 'f 1 2//1 3/', ...vt].join('\n')) }], 0); // prettier-ignore
  assert.deepEqual([[...without.positions], [...without.uv]], [expected[0].slice(0, 9), Array(6).fill(NaN)]); // prettier-ignore
});
