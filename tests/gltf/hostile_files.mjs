// Broken and malicious glTF files, each with the exit code and the words it must end with.
// `node hostile_files.mjs FOLDER` writes them out.

import { mkdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { chunkType, concat, packChunks, packGlb } from './container.mjs';

const position = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1);
const index = Uint16Array.of(0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3);
const bytesOf = (array) => new Uint8Array(array.buffer, array.byteOffset, array.byteLength);

/** A tetrahedron: view 0 positions, view 1 indices, view 2 sixteen spare bytes. */
function good() {
  const bin = concat([bytesOf(position), bytesOf(index), new Uint8Array(16)]);
  const json = {
    asset: { version: '2.0' },
    buffers: [{ byteLength: bin.length }],
    bufferViews: [
      { buffer: 0, byteOffset: 0, byteLength: 48 },
      { buffer: 0, byteOffset: 48, byteLength: 24 },
      { buffer: 0, byteOffset: 72, byteLength: 16 },
    ],
    accessors: [
      {
        bufferView: 0,
        componentType: 5126,
        count: 4,
        type: 'VEC3',
        min: [0, 0, 0],
        max: [1, 1, 1],
      },
      { bufferView: 1, componentType: 5123, count: 12, type: 'SCALAR' },
    ],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
    nodes: [{ mesh: 0 }],
    scenes: [{ nodes: [0] }],
  };
  return { json, bin };
}

const glb = (change = () => {}) => {
  const file = good();
  change(file.json, file);
  return packGlb(file.json, file.bin);
};
/** The same as .gltf text, changed as text. */
const gltf = (change = (text) => text, edit = () => {}) => {
  const { json, bin } = good();
  json.buffers[0].uri = `data:application/octet-stream;base64,${Buffer.from(bin).toString('base64')}`;
  edit(json);
  return new TextEncoder().encode(change(JSON.stringify(json)));
};
const withWord = (bytes, offset, value) => {
  const out = bytes.slice();
  new DataView(out.buffer).setUint32(offset, value, true);
  return out;
};
const sparse = (change) =>
  glb((json, file) => {
    new DataView(file.bin.buffer).setUint16(72, 1, true);
    new DataView(file.bin.buffer).setUint16(74, 3, true);
    json.accessors[1].sparse = {
      count: 2,
      indices: { bufferView: 2, componentType: 5123 },
      values: { bufferView: 2, byteOffset: 8 },
    };
    change(json.accessors[1].sparse, json, file);
  });
const uri = (text) => gltf(undefined, (json) => (json.buffers[0].uri = text));
const draco = (bytes, change = () => {}) =>
  glb((json, file) => {
    const padded = new Uint8Array(Math.ceil(bytes.length / 4) * 4);
    padded.set(bytes);
    json.bufferViews.push({ buffer: 0, byteOffset: file.bin.length, byteLength: bytes.length });
    file.bin = concat([file.bin, padded]);
    json.buffers[0].byteLength = file.bin.length;
    for (const accessor of json.accessors) delete accessor.bufferView;
    json.extensionsUsed = ['KHR_draco_mesh_compression'];
    json.extensionsRequired = ['KHR_draco_mesh_compression'];
    json.meshes[0].primitives[0].extensions = {
      KHR_draco_mesh_compression: { bufferView: 3, attributes: { POSITION: 0 } },
    };
    change(json);
  });
const meshopt = (change = () => {}) =>
  glb((json) => {
    json.buffers.push({
      byteLength: 48,
      extensions: { EXT_meshopt_compression: { fallback: true } },
    });
    json.extensionsUsed = ['EXT_meshopt_compression'];
    json.extensionsRequired = ['EXT_meshopt_compression'];
    const extension = {
      buffer: 0,
      byteOffset: 72,
      byteLength: 16,
      byteStride: 12,
      count: 4,
      mode: 'ATTRIBUTES',
    };
    json.bufferViews[0] = {
      buffer: 1,
      byteLength: 48,
      byteStride: 12,
      extensions: { EXT_meshopt_compression: extension },
    };
    change(extension, json);
  });
/** A Draco header that claims counts: version 2.2, mesh, edgebreaker. */
const dracoClaim = (vertices, faces) => {
  const varint = (value) => {
    const out = [];
    for (; value > 127; value = Math.floor(value / 128)) out.push((value % 128) + 128);
    return [...out, value];
  };
  const head = [...'DRACO'].map((c) => c.charCodeAt(0));
  return Uint8Array.from([...head, 2, 2, 1, 1, 0, 0, 0, ...varint(vertices), ...varint(faces), 0]);
};
const chain = (count) =>
  glb((json) => {
    json.nodes = Array.from({ length: count }, (_, i) => ({ children: [i + 1] }));
    json.nodes.push({ mesh: 0 });
  });

const malformed = { exit: 3, code: 'malformed' };
const limit = { exit: 8, code: 'limit' };
const unsupported = { exit: 4, code: 'unsupported' };

/** [name, bytes, expected, what the message must say, more] */
const list = [
  // The container.
  ['empty.glb', new Uint8Array(), malformed, /empty/],
  ['blank.gltf', new TextEncoder().encode(' \n\t '), malformed, /empty/],
  ['html.gltf', new TextEncoder().encode('<!doctype html><p>404'), malformed, /not a glTF.*/],
  ['wrong-magic.glb', withWord(glb(), 0, 0x46546c68), malformed, /not a glTF file/],
  ['header-only.glb', glb().slice(0, 12), malformed, /byte 12: .*cut off/],
  ['version-1.glb', withWord(glb(), 4, 1), malformed, /byte 4: .*version 1/],
  ['too-short.glb', glb().slice(0, -9), malformed, /byte 8: .*header says/],
  ['too-long.glb', concat([withWord(glb(), 8, 30), new Uint8Array(4)]), malformed, /byte 8: .*header says/], // prettier-ignore
  ['length-huge.glb', withWord(glb(), 8, 0xffffffff), malformed, /byte 8/],
  ['chunk-huge.glb', withWord(glb(), 12, 0xfffffffc), malformed, /byte 12: .*chunk of 4294967292/],
  ['chunk-odd.glb', withWord(glb(), 12, 17), malformed, /multiple of 4/],
  [
    'two-bins.glb',
    packChunks([
      [chunkType.json, new TextEncoder().encode(JSON.stringify(good().json))],
      [chunkType.bin, good().bin],
      [chunkType.bin, good().bin],
    ]),
    malformed,
    /more than one BIN/,
  ],
  ['bin-first.glb', packChunks([[chunkType.bin, good().bin]]), malformed, /JSON chunk/],
  [
    'two-jsons.glb',
    packChunks([1, 2].map(() => [chunkType.json, new TextEncoder().encode('{}')])),
    malformed,
    /one JSON chunk/,
  ],
  // The JSON text.
  [
    'deep-arrays.gltf',
    gltf((t) => t.replace('{', `{"x":${'['.repeat(200000)},`)),
    malformed,
    /64 levels/,
  ],
  [
    'deep-objects.gltf',
    gltf((t) => t.replace('{', `{"x":${'{"a":'.repeat(200000)}`)),
    malformed,
    /64 levels/,
  ],
  [
    'deep-extras.glb',
    glb((j) => (j.extras = JSON.parse('['.repeat(70) + ']'.repeat(70)))),
    malformed,
    /64 levels/,
  ],
  ['duplicate-key.gltf', gltf((t) => t.replace('{', '{"nodes":[],')), malformed, /same key twice/],
  [
    'escaped-duplicate.gltf',
    gltf((t) => t.replace('{', '{"n\\u006fdes":[],')),
    malformed,
    /same key/,
  ],
  [
    'bad-utf8.gltf',
    concat([gltf().slice(0, 20), Uint8Array.of(0xc0, 0xaf), gltf().slice(20)]),
    malformed,
    /UTF-8/,
  ],
  [
    'surrogate-utf8.gltf',
    concat([gltf().slice(0, 10), Uint8Array.of(0xed, 0xa0, 0x80), gltf().slice(10)]),
    malformed,
    /UTF-8/,
  ],
  ['trailing.gltf', gltf((t) => `${t}{}`), malformed, /more text/],
  ['comment.gltf', gltf((t) => t.replace('{', '{/* */')), malformed, /byte 1/],
  ['nan.gltf', gltf((t) => t.replace('"count":4', '"count":NaN')), malformed, /expected a value/],
  [
    'leading-zero.gltf',
    gltf((t) => t.replace('"count":4', '"count":04')),
    malformed,
    /not a JSON number/,
  ],
  ['cut.gltf', gltf((t) => t.slice(0, t.length / 2)), malformed, /JSON, byte/],
  ['array.gltf', new TextEncoder().encode('[1]'), malformed, /neither/],
  ['control.gltf', gltf((t) => t.replace('2.0', '2.\n0')), malformed, /control character/],
  [
    'many-values.gltf',
    gltf((t) => t.replace('{', `{"x":[${'0,'.repeat(8_100_000)}0],`)),
    limit,
    /more than 8000000 values/,
  ],
  ['json-68-mb.gltf', gltf((t) => t + ' '.repeat(68 << 20)), limit, /the JSON text has/],
  // The asset.
  ['no-asset.glb', glb((j) => delete j.asset), malformed, /'asset' is missing/],
  ['version-3.glb', glb((j) => (j.asset.version = '3.0')), malformed, /\/asset\/version: .*3\.0/],
  ['version-number.glb', glb((j) => (j.asset.version = 2)), malformed, /\/asset.*version/],
  ['version-words.glb', glb((j) => (j.asset.version = '2.0.1x')), malformed, /\/asset/],
  ['min-version.glb', glb((j) => (j.asset.minVersion = '2.1')), malformed, /\/asset\/minVersion/],
  [
    'required.glb',
    glb((j) => (j.extensionsRequired = ['EVIL_<b>geometry\u0007'])),
    malformed,
    /\/extensionsRequired\/0: .*EVIL_<b>geometry/,
  ],
  ['required-object.glb', glb((j) => (j.extensionsRequired = {})), malformed, /must be an array/],
  // References.
  [
    'view-missing.glb',
    glb((j) => (j.accessors[0].bufferView = 3)),
    malformed,
    /\/accessors\/0\/bufferView: refers to bufferViews\[3\], but there are 3/,
  ],
  [
    'view-negative.glb',
    glb((j) => (j.accessors[0].bufferView = -1)),
    malformed,
    /\/accessors\/0\/bufferView/,
  ],
  [
    'view-bool.glb',
    glb((j) => (j.accessors[0].bufferView = true)),
    malformed,
    /\/accessors\/0\/bufferView/,
  ],
  [
    'view-float.gltf',
    gltf((t) => t.replace('"bufferView":1', '"bufferView":1.0')),
    malformed,
    /\/accessors\/1\/bufferView/,
  ],
  [
    'view-exponent.gltf',
    gltf((t) => t.replace('"bufferView":1', '"bufferView":1e0')),
    malformed,
    /\/accessors\/1\/bufferView/,
  ],
  [
    'view-huge.gltf',
    gltf((t) => t.replace('"bufferView":1', '"bufferView":18446744073709551617')),
    malformed,
    /\/accessors\/1\/bufferView/,
  ],
  [
    'buffer-missing.glb',
    glb((j) => (j.bufferViews[0].buffer = 7)),
    malformed,
    /\/bufferViews\/0\/buffer: refers to buffers\[7\], but there are 1/,
  ],
  [
    'accessor-missing.glb',
    glb((j) => (j.meshes[0].primitives[0].attributes.POSITION = 2)),
    malformed,
    /\/meshes\/0\/primitives\/0\/attributes\/POSITION/,
  ],
  [
    'indices-missing.glb',
    glb((j) => (j.meshes[0].primitives[0].indices = 99)),
    malformed,
    /\/meshes\/0\/primitives\/0\/indices/,
  ],
  [
    'target-missing.glb',
    glb((j) => (j.meshes[0].primitives[0].targets = [{ POSITION: 9 }])),
    malformed,
    /\/targets\/0\/POSITION/,
  ],
  [
    'material-missing.glb',
    glb((j) => (j.meshes[0].primitives[0].material = 0)),
    malformed,
    /\/material/,
  ],
  ['mesh-missing.glb', glb((j) => (j.nodes[0].mesh = 1)), malformed, /\/nodes\/0\/mesh/],
  [
    'scene-missing.glb',
    glb((j) => (j.scene = 4)),
    malformed,
    /\/scene: refers to scenes\[4\], but there are 1/,
  ],
  [
    'proto-key.gltf',
    gltf((t) => t.replace('"POSITION":0', '"__proto__":12,"POSITION":0')),
    malformed,
    /__proto__: refers to accessors\[12\], but there are 2/,
  ],
  [
    'nodes-object.glb',
    glb((j) => (j.nodes = { length: 1 })),
    malformed,
    /\/nodes: must be an array/,
  ],
  [
    'accessors-numbers.glb',
    glb((j) => (j.accessors = [1, 2])),
    malformed,
    /\/accessors\/0: must be an object/,
  ],
  ['primitives-null.glb', glb((j) => (j.meshes[0].primitives = null)), malformed, /\/meshes\/0/],
  // Spans.
  [
    'accessor-over-view.glb',
    glb((j) => (j.accessors[0].count = 5)),
    malformed,
    /\/accessors\/0: 5 elements do not fit/,
  ],
  [
    'count-2-53.gltf',
    gltf((t) => t.replace('"count":4', '"count":9007199254740992')),
    malformed,
    /do not fit/,
  ],
  [
    'count-zero.glb',
    glb((j) => (j.accessors[0].count = 0)),
    malformed,
    /'count' must be at least 1/,
  ],
  [
    'offset-2-64.gltf',
    gltf((t) => t.replace('"count":4', '"count":4,"byteOffset":18446744073709551612')),
    malformed,
    /byteOffset/,
  ],
  [
    'offset-2-53.gltf',
    gltf((t) => t.replace('"count":4', '"count":4,"byteOffset":9007199254740988')),
    malformed,
    /do not fit/,
  ],
  [
    'view-over-buffer.glb',
    glb((j) => (j.bufferViews[0].byteLength = 1000)),
    malformed,
    /\/bufferViews\/0: bytes 0 \+ 1000 are outside/,
  ],
  [
    'view-offset.gltf',
    gltf((t) => t.replace('"byteOffset":48', '"byteOffset":9007199254740984')),
    malformed,
    /\/bufferViews\/1/,
  ],
  ['view-empty.glb', glb((j) => (j.bufferViews[0].byteLength = 0)), malformed, /at least 1/],
  ['stride-negative.glb', glb((j) => (j.bufferViews[0].byteStride = -12)), malformed, /byteStride/],
  ['stride-256.glb', glb((j) => (j.bufferViews[0].byteStride = 256)), malformed, /from 4 to 252/],
  ['stride-odd.glb', glb((j) => (j.bufferViews[0].byteStride = 13)), malformed, /from 4 to 252/],
  [
    'stride-small.glb',
    glb((j) => (j.bufferViews[0].byteStride = 8)),
    malformed,
    /12 bytes at a stride of 8/,
  ],
  ['stride-over.glb', glb((j) => (j.bufferViews[0].byteStride = 252)), malformed, /do not fit/],
  [
    'unaligned.glb',
    glb((j) => ((j.accessors[0].byteOffset = 2), (j.accessors[0].count = 3))),
    malformed,
    /not aligned/,
  ],
  [
    'component-type.glb',
    glb((j) => (j.accessors[0].componentType = 5124)),
    malformed,
    /unknown componentType/,
  ],
  [
    'component-double.glb',
    glb((j) => (j.accessors[0].componentType = 5130)),
    malformed,
    /unknown componentType/,
  ],
  ['type-vec5.glb', glb((j) => (j.accessors[0].type = 'VEC5')), malformed, /unknown type 'VEC5'/],
  [
    'buffer-short.glb',
    glb((j) => (j.buffers[0].byteLength = 4096)),
    malformed,
    /\/buffers\/0: declares 4096 bytes, but there are 88/,
  ],
  [
    'buffer-huge.glb',
    glb((j) => (j.buffers[0].byteLength = 2 ** 50)),
    limit,
    /\/buffers\/0: .*limit/,
  ],
  [
    'buffers-huge.glb',
    glb((j) => j.buffers.push(...Array(5000).fill({ byteLength: 2 ** 52 }))),
    limit,
    /limit/,
  ],
  [
    'zeros.glb',
    glb((j) => (j.accessors[0] = { componentType: 5126, count: 2e9, type: 'VEC3' })),
    limit,
    /\/accessors\/0: 2000000000 elements without data/,
  ],
  [
    'zeros-2-53.glb',
    glb((j) => j.accessors.push({ componentType: 5126, count: 2 ** 53, type: 'MAT4' })),
    limit,
    /\/accessors\/2/,
  ],
  [
    'zeros-many.glb',
    glb((j) =>
      j.accessors.push(...Array(300).fill({ componentType: 5126, count: 1e6, type: 'SCALAR' })),
    ),
    limit,
    /without data of their own/,
  ],
  // Sparse.
  [
    'sparse-range.glb',
    sparse((s, j, f) => new DataView(f.bin.buffer).setUint16(74, 12, true)),
    malformed,
    /\/accessors\/1\/sparse\/indices: entry 1 is 12/,
  ],
  [
    'sparse-order.glb',
    sparse((s, j, f) => new DataView(f.bin.buffer).setUint16(74, 1, true)),
    malformed,
    /must increase/,
  ],
  ['sparse-count.glb', sparse((s) => (s.count = 13)), malformed, /'count' must be from 1/],
  [
    'sparse-view.glb',
    sparse((s) => (s.values.bufferView = 3)),
    malformed,
    /sparse\/values\/bufferView/,
  ],
  [
    'sparse-short.glb',
    sparse((s) => (s.values.byteOffset = 14)),
    malformed,
    /sparse\/values: 2 elements do not fit/,
  ],
  [
    'sparse-stride.glb',
    sparse((s, j) => (j.bufferViews[2].byteStride = 4)),
    malformed,
    /tightly packed/,
  ],
  [
    'sparse-type.glb',
    sparse((s) => (s.indices.componentType = 5122)),
    malformed,
    /unsigned integer/,
  ],
  ['sparse-none.glb', sparse((s) => delete s.indices), malformed, /'indices' and 'values'/],
  // Primitives.
  [
    'index-range.glb',
    glb((j, f) => new DataView(f.bin.buffer).setUint16(50, 4, true)),
    malformed,
    /\/meshes\/0\/primitives\/0\/indices: entry 1 is 4, but there are 4/,
  ],
  [
    'restart.glb',
    glb((j, f) => new DataView(f.bin.buffer).setUint16(50, 65535, true)),
    malformed,
    /restart value/,
  ],
  [
    'indices-float.glb',
    glb((j) => (j.meshes[0].primitives[0].indices = 0)),
    malformed,
    /indices must be SCALAR/,
  ],
  [
    'counts-differ.glb',
    glb(
      (j) => (
        (j.accessors[2] = { ...j.accessors[0], count: 3 }),
        (j.meshes[0].primitives[0].attributes.NORMAL = 2)
      ),
    ),
    malformed,
    /3 elements where the other attributes have 4|4 elements where the other attributes have 3/,
  ],
  [
    'target-count.glb',
    glb(
      (j) => (
        (j.accessors[2] = { ...j.accessors[0], count: 3 }),
        (j.meshes[0].primitives[0].targets = [{ POSITION: 2 }])
      ),
    ),
    malformed,
    /targets\/0\/POSITION: has 3/,
  ],
  [
    'position-vec2.glb',
    glb((j) => (j.accessors[0].type = 'VEC2')),
    malformed,
    /POSITION must be VEC3/,
  ],
  ['mode-7.glb', glb((j) => (j.meshes[0].primitives[0].mode = 7)), malformed, /from 0 to 6/],
  [
    'points-only.glb',
    glb((j) => (j.meshes[0].primitives[0].mode = 0)),
    unsupported,
    /no mesh with triangles/,
  ],
  [
    'no-mesh.glb',
    glb((j) => (delete j.meshes, (j.nodes = [{}]))),
    unsupported,
    /no mesh with triangles/,
  ],
  [
    'triangle-bomb.glb',
    glb((j) => (j.meshes[0].primitives = Array(60000).fill(j.meshes[0].primitives[0]))),
    limit,
    /more than the limit of 200000 triangles\. \S/,
  ],
  // Nodes.
  [
    'node-self.glb',
    glb((j) => (j.nodes[0].children = [0])),
    malformed,
    /two parents or is its own/,
  ],
  [
    'node-cycle.glb',
    glb((j) => (j.nodes = [{ children: [1] }, { children: [2] }, { children: [0] }])),
    malformed,
    /their own ancestors/,
  ],
  [
    'two-parents.glb',
    glb((j) => (j.nodes = [{ children: [2] }, { children: [2] }, { mesh: 0 }])),
    malformed,
    /node 2 has two parents/,
  ],
  ['node-depth.glb', chain(1200), malformed, /deeper than 1000/],
  ['node-depth-huge.glb', chain(200000), malformed, /deeper than 1000/],
  // URIs.
  ['passwd.gltf', uri('../../../../../../etc/passwd'), malformed, /leaves the folder/],
  ['passwd-encoded.gltf', uri('..%2f..%2F..%2fetc%2fpasswd'), malformed, /leaves the folder/],
  ['passwd-dots.gltf', uri('a/%2e%2e/%2E%2e/etc/passwd'), malformed, /leaves the folder/],
  ['absolute.gltf', uri('/etc/passwd'), malformed, /absolute/],
  ['backslash.gltf', uri('..\\secret.bin'), malformed, /backslash/],
  ['drive.gltf', uri('C:/secret.bin'), malformed, /no scheme, host or drive/],
  ['file-uri.gltf', uri('file:///etc/passwd'), malformed, /no scheme/],
  ['http.gltf', uri('http://localhost:1/x.bin'), malformed, /no scheme/],
  ['host.gltf', uri('//localhost/x.bin'), malformed, /absolute/],
  ['nul.gltf', uri('x.bin%00.png'), malformed, /control character/],
  ['percent.gltf', uri('x%zz.bin'), malformed, /percent-encoding/],
  ['double-encoded.gltf', uri('%252e%252e%252fsecret.bin'), malformed, /missing|not given/],
  ['name-missing.gltf', uri('nowhere.bin'), malformed, /nowhere\.bin/],
  ['uri-empty.gltf', uri(''), malformed, /name is empty/],
  ['uri-number.gltf', uri(5), malformed, /\/buffers\/0\/uri: must be a string/],
  ['no-uri.gltf', gltf(undefined, (j) => delete j.buffers[0].uri), malformed, /no data of its own/],
  ['data-plain.gltf', uri('data:application/octet-stream,AAAA'), malformed, /not base64/],
  [
    'data-short.gltf',
    gltf(undefined, (j) => (j.buffers[0].byteLength = 89)),
    malformed,
    /declares 89 bytes/,
  ],
  ['data-letters.gltf', gltf((t) => t.replace('base64,A', 'base64,*')), malformed, /not base64/],
  ['data-cut.gltf', uri('data:;base64,AAAAA'), malformed, /cut off/],
  // Compressed data.
  ['draco-noise.glb', draco(new Uint8Array(64).fill(7)), malformed, /does not start like Draco/],
  ['draco-cut.glb', draco(dracoClaim(4, 4).slice(0, 12)), malformed, /cut off|damaged/],
  [
    'draco-bomb.glb',
    draco(dracoClaim(4, 1_000_000_000)),
    malformed,
    /claims 4 vertices and 1000000000 triangles/,
  ],
  [
    'draco-vertices.glb',
    draco(dracoClaim(4_000_000_000, 4)),
    malformed,
    /claims 4000000000 vertices/,
  ],
  [
    'draco-body.glb',
    draco(concat([dracoClaim(4, 4), new Uint8Array(40).fill(255)])),
    malformed,
    /Draco data is damaged/,
  ],
  [
    'draco-version.glb',
    draco(dracoClaim(4, 4).map((b, i) => (i === 6 ? 1 : b))),
    malformed,
    /bitstream version 2\.1/,
  ],
  [
    'draco-attribute.glb',
    draco(
      dracoClaim(4, 4),
      (j) =>
        (j.meshes[0].primitives[0].extensions.KHR_draco_mesh_compression.attributes.NORMAL = 1),
    ),
    malformed,
    /attribute that the primitive does not have/,
  ],
  [
    'draco-metadata.glb',
    draco(
      concat([
        dracoClaim(4, 4)
          .map((b, i) => (i === 10 ? 0x80 : b))
          .slice(0, 11),
        new Uint8Array(200).fill(1),
      ]),
    ),
    malformed,
    /damaged metadata|claims|damaged/,
  ],
  ['meshopt-noise.glb', meshopt(), malformed, /meshopt data is damaged/],
  [
    'meshopt-bomb.glb',
    meshopt(
      (e, j) => (
        (e.count = 4e8),
        (j.bufferViews[0].byteLength = 48e8),
        (j.buffers[1].byteLength = 48e8)
      ),
    ),
    limit,
    /limit/,
  ],
  [
    'meshopt-count.glb',
    meshopt((e) => (e.count = 5)),
    malformed,
    /5 elements of \d+ bytes do not fill the view's 48/,
  ],
  [
    'meshopt-stride.glb',
    meshopt((e) => ((e.byteStride = 6), (e.count = 8))),
    malformed,
    /does not suit the mode/,
  ],
  ['meshopt-mode.glb', meshopt((e) => (e.mode = 'MAGIC')), malformed, /unknown mode 'MAGIC'/],
  [
    'meshopt-filter.glb',
    meshopt((e) => (e.filter = 'QUATERNION')),
    malformed,
    /filter 'QUATERNION'/,
  ],
  ['meshopt-span.glb', meshopt((e) => (e.byteLength = 17)), malformed, /outside their buffer/],
  [
    'fallback-needed.glb',
    meshopt((e, j) => delete j.bufferViews[0].extensions),
    malformed,
    /no data of its own/,
  ],
];

/** @returns {{name: string, bytes: Uint8Array, exit: number, code: string, message: RegExp}[]} */
export function hostileFiles() {
  return list.map(([name, bytes, { exit, code }, message]) => ({
    name,
    bytes,
    exit,
    code,
    message,
  }));
}

/** Odd but legal: must be read. */
export function harmlessFiles() {
  return [
    ['plain.glb', glb()],
    ['bom.gltf', concat([Uint8Array.of(0xef, 0xbb, 0xbf), gltf()])],
    ['deep-62.glb', glb((j) => (j.extras = JSON.parse('['.repeat(62) + ']'.repeat(62))))],
    ['sparse.glb', sparse(() => {})],
    ['markup-name.glb', glb((j) => (j.meshes[0].name = '<img src=x onerror=alert(1)>\u202e'))],
    ['long-name.glb', glb((j) => (j.meshes[0].name = 'x'.repeat(1 << 20)))],
    ['proto-name.gltf', gltf((t) => t.replace('{', '{"__proto__":{"a":1},'))],
    ['numbers.gltf', gltf((t) => t.replace('{', '{"extras":[1e999,-0,123456789012345678901],'))],
    ['image-elsewhere.glb', glb((j) => (j.images = [{ uri: 'file:///etc/passwd' }]))],
    ['unknown-used.glb', glb((j) => (j.extensionsUsed = ['VENDOR_unknown']))],
    ['zero-positions.glb', glb((j) => delete j.accessors[0].bufferView)],
    ['empty-lists.glb', glb((j) => (j.skins = []))],
  ].map(([name, bytes]) => ({ name, bytes }));
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) {
  const folder = process.argv[2] ?? 'hostile';
  mkdirSync(folder, { recursive: true });
  for (const { name, bytes } of [...hostileFiles(), ...harmlessFiles()]) {
    writeFileSync(path.join(folder, name), bytes);
  }
}
