// Files as other programs write them: valid, or nearly so, with unusual but common features.

import { cubeMesh } from './meshes.mjs';

const cube = cubeMesh(3);
const { vertices, triangles } = cube;
const normals = vertices.map((p) => p.map((x) => x / Math.hypot(...p)));

// ---- glTF ---------------------------------------------------------------------------------------

/** Builds a glTF piece by piece; every accessor has the view passed to it. */
class Gltf {
  constructor() {
    this.parts = [];
    this.size = 0;
    this.json = {
      asset: { version: '2.0', generator: 'a test' },
      scene: 0,
      scenes: [{ nodes: [0] }],
      nodes: [{ mesh: 0 }],
      meshes: [{ primitives: [] }],
      accessors: [],
      bufferViews: [],
    };
  }

  view(bytes, more = {}) {
    const pad = (4 - (this.size % 4)) % 4;
    this.parts.push(Buffer.alloc(pad), Buffer.from(bytes));
    this.json.bufferViews.push({
      ...{ buffer: 0, byteOffset: this.size + pad, byteLength: bytes.length },
      ...more,
    });
    this.size += pad + bytes.length;
    return this.json.bufferViews.length - 1;
  }

  accessor(json) {
    this.json.accessors.push(json);
    return this.json.accessors.length - 1;
  }

  array(array, type, componentType, more = {}) {
    const size = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16 }[type];
    const bytes = new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
    const count = array.length / size;
    return this.accessor({ bufferView: this.view(bytes), componentType, count, type, ...more });
  }

  positions(list = vertices) {
    return this.array(new Float32Array(list.flat()), 'VEC3', 5126, boundsOf(list));
  }

  indices(list = triangles) {
    return this.array(new Uint16Array(list.flat()), 'SCALAR', 5123);
  }

  primitive(attributes, more = {}, mesh = 0) {
    this.json.meshes[mesh].primitives.push({ attributes, ...more });
    return this;
  }

  files(name) {
    this.json.buffers = [{ uri: `${name}.bin`, byteLength: this.size }];
    return {
      [`${name}.gltf`]: JSON.stringify(this.json),
      [`${name}.bin`]: Buffer.concat(this.parts),
    };
  }

  glb(name, { chunks = [], pad = ' ' } = {}) {
    this.json.buffers = [{ byteLength: this.size }];
    return { [`${name}.glb`]: glbOf(this.json, Buffer.concat(this.parts), { chunks, pad }) };
  }
}

function boundsOf(list) {
  const bound = (pick) =>
    [0, 1, 2].map((k) => Math.fround(pick(...list.map((p) => Math.fround(p[k])))));
  return { min: bound(Math.min), max: bound(Math.max) };
}

function glbOf(json, bin, { chunks = [], pad = ' ' } = {}) {
  const chunk = (type, bytes, filler) => {
    const padded = Buffer.alloc(Math.ceil(bytes.length / 4) * 4, filler);
    bytes.copy(padded);
    const head = Buffer.alloc(8);
    head.writeUInt32LE(padded.length, 0);
    head.writeUInt32LE(type, 4);
    return Buffer.concat([head, padded]);
  };
  const body = Buffer.concat([
    chunk(0x4e4f534a, Buffer.from(JSON.stringify(json)), pad),
    chunk(0x004e4942, bin, 0),
    ...chunks.map(({ type, bytes }) => chunk(type, bytes, 0)),
  ]);
  const head = Buffer.alloc(12);
  [0x46546c67, 2, 12 + body.length].forEach((n, i) => head.writeUInt32LE(n, 4 * i));
  return Buffer.concat([head, body]);
}

const spherical = normals.map(([x, y, z]) => [0.5 + Math.atan2(z, x) / 7, 0.5 + Math.asin(y) / 4]);

function plain(build = () => {}) {
  const gltf = new Gltf();
  const attributes = { POSITION: gltf.positions() };
  const primitive = { indices: gltf.indices() };
  build(gltf, attributes, primitive);
  return gltf.primitive(attributes, primitive);
}

/** Interleaved positions, normals and texture coordinates, with a gap after each vertex. */
function interleaved() {
  const gltf = new Gltf();
  const stride = 36;
  const bytes = Buffer.alloc(stride * vertices.length, 0xee);
  vertices.forEach((p, v) => {
    [...p, ...normals[v], ...spherical[v]].forEach((x, i) =>
      bytes.writeFloatLE(x, stride * v + 4 * i),
    );
  });
  const view = gltf.view(bytes, { byteStride: stride, target: 34962 });
  const float = { bufferView: view, componentType: 5126, count: vertices.length };
  const attributes = {
    TEXCOORD_0: gltf.accessor({ ...float, byteOffset: 24, type: 'VEC2' }),
    NORMAL: gltf.accessor({ ...float, byteOffset: 12, type: 'VEC3' }),
    POSITION: gltf.accessor({ ...float, type: 'VEC3', ...boundsOf(vertices) }),
  };
  return gltf.primitive(attributes, { indices: gltf.indices() });
}

/** Every second position is zero in the view and given by sparse values; or all of them are. */
function sparse(hasBase) {
  const gltf = new Gltf();
  const chosen = vertices.map((_, v) => v).filter((v) => !hasBase || v % 2 === 1);
  const values = new Float32Array(chosen.flatMap((v) => vertices[v]));
  const base = vertices.map((p, v) => (v % 2 === 1 ? [0, 0, 0] : p));
  const position = gltf.accessor({
    ...{ componentType: 5126, count: vertices.length, type: 'VEC3', ...boundsOf(vertices) },
    ...(hasBase && { bufferView: gltf.view(new Uint8Array(new Float32Array(base.flat()).buffer)) }),
    sparse: {
      count: chosen.length,
      indices: {
        bufferView: gltf.view(new Uint8Array(new Uint16Array(chosen).buffer)),
        componentType: 5123,
      },
      values: { bufferView: gltf.view(new Uint8Array(values.buffer)) },
    },
  });
  return gltf.primitive({ POSITION: position }, { indices: gltf.indices() });
}

/** Positions as shorts in a node that scales them, normals as bytes, uv as shorts: strides of 8 and 4. */
function quantized(isNormalized) {
  const gltf = new Gltf();
  const scale = isNormalized ? 32767 : 1000;
  const shorts = new Int16Array(4 * vertices.length);
  vertices.forEach((p, v) =>
    p.forEach((x, i) => (shorts[4 * v + i] = Math.round(x * scale * 0.9))),
  );
  const bytes = new Int8Array(4 * vertices.length);
  normals.forEach((p, v) => p.forEach((x, i) => (bytes[4 * v + i] = Math.round(x * 127))));
  const uv = new Uint16Array(spherical.flat().map((x) => Math.round(x * 65535)));
  const rows = vertices.map((_, v) => [...shorts.subarray(4 * v, 4 * v + 3)]);
  const all = (pick) => [0, 1, 2].map((k) => pick(...rows.map((p) => p[k])));
  const of = (array, stride) =>
    gltf.view(new Uint8Array(array.buffer), { byteStride: stride, target: 34962 });
  const count = vertices.length;
  const normalized = isNormalized ? { normalized: true } : {};
  const attributes = {
    POSITION: gltf.accessor({ bufferView: of(shorts, 8), componentType: 5122, count, type: 'VEC3', ...normalized, min: all(Math.min), max: all(Math.max) }), // prettier-ignore
    NORMAL: gltf.accessor({ bufferView: of(bytes, 4), componentType: 5120, count, type: 'VEC3', normalized: true }), // prettier-ignore
    TEXCOORD_0: gltf.accessor({ bufferView: of(uv, 4), componentType: 5123, count, type: 'VEC2', normalized: true }), // prettier-ignore
  };
  gltf.json.extensionsUsed = gltf.json.extensionsRequired = ['KHR_mesh_quantization'];
  gltf.json.nodes[0].scale = [0.002, 0.002, 0.002];
  return gltf.primitive(attributes, { indices: gltf.indices() });
}

/** Strips and fans connected by degenerate triangles. */
function strips() {
  const gltf = new Gltf();
  const POSITION = gltf.positions();
  const list = [];
  for (const [a, b, c] of triangles) {
    if (list.length > 0) list.push(list.at(-1), a);
    if (list.length % 2 === 1) list.push(a);
    list.push(a, b, c);
  }
  const indices = gltf.array(new Uint16Array(list), 'SCALAR', 5123);
  return gltf.primitive({ POSITION }, { indices, mode: 5 });
}

function fans() {
  const gltf = new Gltf();
  const POSITION = gltf.positions();
  for (let i = 0; i < triangles.length; i += 2) {
    // Two triangles of a square are a fan if they start with the same corner.
    const [[a, b, c], [d, e, f]] = [triangles[i], triangles[i + 1]];
    const list = a === d && c === e ? [a, b, c, f] : a === d && b === f ? [a, e, f, c] : undefined;
    const pieces = list
      ? [list]
      : [
          [a, b, c],
          [d, e, f],
        ];
    for (const piece of pieces)
      gltf.primitive(
        { POSITION },
        { indices: gltf.array(new Uint8Array(piece), 'SCALAR', 5121), mode: 6 },
      );
  }
  return gltf;
}

function soup() {
  const gltf = new Gltf();
  const corners = triangles.flat().map((v) => vertices[v]);
  const COLOR_0 = gltf.array(new Uint8Array(corners.flatMap((_, c) => [c % 256, 9, 7, 255])), 'VEC4', 5121, { normalized: true }); // prettier-ignore
  return gltf.primitive({ POSITION: gltf.positions(corners), COLOR_0 });
}

/** Primitives of several materials that share all vertices; one has lines, one points, one nothing. */
function materials() {
  const gltf = new Gltf();
  const attributes = { POSITION: gltf.positions(), TEXCOORD_0: gltf.array(new Float32Array(spherical.flat()), 'VEC2', 5126) }; // prettier-ignore
  gltf.json.materials = [{ name: 'a' }, { name: 'b' }, { name: 'c' }];
  for (let m = 0; m < 3; m++) {
    const indices = gltf.indices(triangles.filter((_, t) => t % 3 === m));
    gltf.primitive(attributes, { indices, material: m });
  }
  const lines = gltf.array(new Uint16Array([0, 1, 1, 2]), 'SCALAR', 5123);
  gltf.primitive({ POSITION: attributes.POSITION }, { indices: lines, mode: 1 });
  gltf.primitive({ POSITION: attributes.POSITION }, { mode: 0 });
  return gltf;
}

/** Two meshes that share one array of vertices, in three nodes, one of which is mirrored. */
function sharedArrays() {
  const gltf = new Gltf();
  const far = vertices.map(([x, y, z]) => [x + 5, y, z]);
  const POSITION = gltf.positions([...vertices, ...far]);
  const moved = triangles.map((t) => t.map((v) => v + vertices.length));
  gltf.json.meshes.push({ primitives: [] });
  gltf.primitive({ POSITION }, { indices: gltf.indices(triangles) }, 0);
  gltf.primitive({ POSITION }, { indices: gltf.indices(moved) }, 1);
  gltf.json.nodes = [{ mesh: 0, scale: [-1, 2, 0.5] }, { mesh: 1, children: [2] }, { mesh: 0 }];
  gltf.json.scenes = [{ nodes: [0, 1] }];
  return gltf;
}

function figure() {
  return plain((gltf, attributes, primitive) => {
    const count = vertices.length;
    attributes.JOINTS_0 = gltf.array(new Uint8Array(4 * count), 'VEC4', 5121);
    const weights = new Uint8Array(4 * count).map((_, i) => (i % 4 === 0 ? 255 : 0));
    attributes.WEIGHTS_0 = gltf.array(weights, 'VEC4', 5121, { normalized: true });
    const target = gltf.accessor({
      ...{ componentType: 5126, count, type: 'VEC3', min: [0, 0, 0], max: [0, 1, 0] },
      sparse: {
        count: 1,
        indices: { bufferView: gltf.view(new Uint8Array([3])), componentType: 5121 },
        values: { bufferView: gltf.view(new Uint8Array(new Float32Array([0, 1, 0]).buffer)) },
      },
    });
    primitive.targets = [{ POSITION: target }];
    gltf.json.meshes[0].weights = [0.5];
    gltf.json.meshes[0].extras = { targetNames: ['smile'] };
    gltf.json.nodes = [{ mesh: 0, skin: 0 }, { name: 'joint' }];
    gltf.json.scenes = [{ nodes: [0, 1] }];
    gltf.json.skins = [{ joints: [1] }];
  });
}

const withJson = (edit) => plain((gltf) => edit(gltf.json, gltf));

/** 20 000 triangles with 32-bit indices, the largest of which is that of a vertex far beyond the others. */
function hugeIndices() {
  const gltf = new Gltf();
  const count = 70_000;
  const list = Array.from({ length: count }, () => [9, 9, 9]);
  vertices.forEach((p, v) => (list[count - 1 - v] = p));
  const indices = new Uint32Array(triangles.flat().map((v) => count - 1 - v));
  const bytes = new Float32Array(list.flat());
  const POSITION = gltf.array(bytes, 'VEC3', 5126, { min: [-1, -1, -1], max: [9, 9, 9] });
  return gltf.primitive({ POSITION }, { indices: gltf.array(indices, 'SCALAR', 5125) });
}

const encoded = (gltf, mime, separator = ';base64,') => {
  const bin = Buffer.concat(gltf.parts);
  gltf.json.buffers = [{ uri: `data:${mime}${separator}${bin.toString('base64')}`, byteLength: bin.length }]; // prettier-ignore
  return { 'inside.gltf': JSON.stringify(gltf.json, null, '\t').replaceAll('\n', '\r\n') };
};

const named = (uri, file) => {
  const gltf = plain();
  const bin = Buffer.concat(gltf.parts);
  gltf.json.buffers = [{ uri, byteLength: bin.length }];
  return {
    'named.gltf': JSON.stringify(gltf.json),
    [file]: Buffer.concat([bin, Buffer.alloc(50)]),
  };
};

const behind = (files, bytes) =>
  Object.fromEntries(
    Object.entries(files).map(([name, glb]) => [name, Buffer.concat([glb, bytes])]),
  );

/** Sets the length in the header; negative: that many bytes less than the actual length. */
function counting(files, length) {
  for (const glb of Object.values(files)) glb.writeUInt32LE(length < 0 ? glb.length + length : length, 8); // prettier-ignore
  return files;
}

export const gltfFiles = {
  'interleaved with a gap': interleaved().glb('interleaved'),
  'sparse positions on a view': sparse(true).glb('sparse'),
  'sparse positions on nothing': sparse(false).glb('sparse'),
  'positions as shorts': quantized(false).glb('quantized'),
  'positions as normalized shorts': quantized(true).files('quantized'),
  'strips with jumps': strips().glb('strips'),
  'a primitive for each fan': fans().glb('fans'),
  'no indices, colours': soup().glb('soup'),
  'materials that share vertices, lines, points': materials().files('materials'),
  'two meshes in one array, mirrored nodes': sharedArrays().glb('shared'),
  'skin, sparse morph target': figure().glb('figure'),
  'indices far behind': hugeIndices().glb('huge'),
  'no bounds': plain((gltf, { POSITION }) => {
    delete gltf.json.accessors[POSITION].min;
    delete gltf.json.accessors[POSITION].max;
  }).glb('bounds'),
  'no scene, no nodes': withJson((json) => {
    for (const key of ['scene', 'scenes', 'nodes']) delete json[key];
  }).glb('bare'),
  'a mesh of one point first': (() => {
    const gltf = new Gltf();
    const point = { componentType: 5126, count: 1, type: 'VEC3', min: [0, 0, 0], max: [0, 0, 0] };
    gltf.primitive({ POSITION: gltf.accessor(point) }, { mode: 0 });
    gltf.json.meshes.push({ primitives: [] });
    gltf.json.nodes.push({ mesh: 1 });
    return gltf
      .primitive({ POSITION: gltf.positions() }, { indices: gltf.indices() }, 1)
      .glb('second');
  })(),
  'required extensions of materials and textures': withJson((json) => {
    json.extensionsUsed = [
      'KHR_texture_basisu',
      'EXT_mesh_gpu_instancing',
      'KHR_lights_punctual',
      'VENDOR_x',
    ];
    json.extensionsRequired = ['KHR_texture_basisu'];
    json.images = [{ uri: 'a.ktx2' }];
    json.textures = [{ extensions: { KHR_texture_basisu: { source: 0 } } }];
    json.materials = [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }];
    json.extensions = {
      KHR_lights_punctual: { lights: [{ type: 'point' }] },
      VENDOR_x: [1e3, 0.1],
    };
  }).glb('extended'),
  'a picture that is not there': withJson((json) => {
    json.images = [{ uri: 'textures/not%20here.png' }];
    json.textures = [{ source: 0 }];
    json.materials = [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }];
  }).files('pictured'),
  'sets 0 and 2, as the exporter had them': plain((gltf, attributes) => {
    attributes.TEXCOORD_0 = gltf.array(new Float32Array(spherical.flat()), 'VEC2', 5126);
    attributes.TEXCOORD_2 = gltf.array(new Uint8Array(spherical.flatMap((p) => [...p.map((x) => 255 * x), 0, 0])), 'VEC4', 5121); // prettier-ignore
    const accessor = gltf.json.accessors.at(-1);
    Object.assign(accessor, { type: 'VEC2', normalized: true, count: vertices.length });
    gltf.json.bufferViews[accessor.bufferView].byteStride = 4;
  }).glb('sets'),
  'vertices without numbers, at the ends': (() => {
    const gltf = new Gltf();
    const none = [NaN, Infinity, -Infinity];
    const POSITION = gltf.array(new Float32Array([none, ...vertices, none].flat()), 'VEC3', 5126, boundsOf(vertices)); // prettier-ignore
    const indices = gltf.indices(triangles.map((t) => t.map((v) => v + 1)));
    return gltf.primitive({ POSITION }, { indices }).glb('numbers');
  })(),
  'bytes behind the end': behind(plain().glb('behind'), Buffer.from('by a program\n')),
  'a header that counts nothing': counting(plain().glb('nothing'), 0),
  'a header that leaves the padding out': counting(plain().glb('padding'), -1),
  'chunks nobody knows, text padded with tabs': plain().glb('chunks', { pad: ' ', chunks: [{ type: 0x31415926, bytes: Buffer.from('more') }] }), // prettier-ignore
  'inside, as text of another kind': encoded(plain(), 'application/gltf-buffer'),
  'inside, with a parameter': encoded(plain(), 'application/octet-stream;charset=utf-8'),
  'a name with blanks, and bytes behind': named('a%20b%C3%BC.bin', 'a bü.bin'),
  'a name that is not encoded': named('a bü.bin', 'a bü.bin'),
  'a name that begins with ./': named('./a.bin', 'a.bin'),
};

// ---- PLY ----------------------------------------------------------------------------------------

const sizes = { char: 1, uchar: 1, short: 2, ushort: 2, int: 4, uint: 4, float: 4, double: 8, int8: 1, uint8: 1, int16: 2, uint16: 2, int32: 4, uint32: 4, float32: 4, float64: 8 }; // prettier-ignore
const put = {
  char: 'Int8', uchar: 'UInt8', short: 'Int16', ushort: 'UInt16', int: 'Int32', uint: 'UInt32', float: 'Float', double: 'Double',
  int8: 'Int8', uint8: 'UInt8', int16: 'Int16', uint16: 'UInt16', int32: 'Int32', uint32: 'UInt32', float32: 'Float', float64: 'Double',
}; // prettier-ignore

/** A value of a type as bytes. */
function binary(type, value, isBig) {
  const bytes = Buffer.alloc(sizes[type]);
  bytes[`write${put[type]}${sizes[type] === 1 ? '' : isBig ? 'BE' : 'LE'}`](value, 0);
  return bytes;
}

/**
 * elements: name → { properties: [[name, type] | [name, countType, type]], rows }.
 */
function ply(elements, { format = 'ascii', eol = '\n', comments = [] } = {}) {
  const head = ['ply', `format ${format} 1.0`, ...comments.map((text) => `comment ${text}`)];
  for (const [name, { properties, rows }] of Object.entries(elements)) {
    head.push(`element ${name} ${rows.length}`);
    for (const [property, ...types] of properties)
      head.push(
        `property ${types.length === 2 ? `list ${types.join(' ')}` : types[0]} ${property}`,
      );
  }
  const parts = [Buffer.from([...head, 'end_header', ''].join(eol))];
  for (const { properties, rows } of Object.values(elements))
    for (const row of rows) {
      if (format === 'ascii') {
        const words = row.flatMap((value, i) =>
          properties[i].length === 3 ? [value.length, ...value] : [value],
        );
        parts.push(Buffer.from(words.join(' ') + eol));
        continue;
      }
      const isBig = format === 'binary_big_endian';
      row.forEach((value, i) => {
        const [, ...types] = properties[i];
        if (types.length === 1) return parts.push(binary(types[0], value, isBig));
        parts.push(
          binary(types[0], value.length, isBig),
          ...value.map((x) => binary(types[1], x, isBig)),
        );
      });
    }
  return Buffer.concat(parts);
}

const xyz = (type = 'float') => ['x', 'y', 'z'].map((name) => [name, type]);
const faces = (name = 'vertex_indices', count = 'uchar', type = 'int') => ({
  properties: [[name, count, type]],
  rows: triangles.map((t) => [t]),
});
const points = { properties: xyz(), rows: vertices };

export const plyFiles = {
  'z y x between others': ply({
    vertex: {
      properties: [
        ['quality', 'float'],
        ['z', 'double'],
        ['red', 'uchar'],
        ['y', 'double'],
        ['x', 'double'],
      ],
      rows: vertices.map(([x, y, z]) => [0.5, z, 200, y, x]),
    },
    face: faces(),
  }),
  'faces before vertices': ply({ face: faces('vertex_index', 'uint8', 'uint32'), vertex: points }, { format: 'binary_little_endian' }), // prettier-ignore
  'big endian shorts': ply(
    {
      vertex: {
        properties: xyz('int16'),
        rows: vertices.map((p) => p.map((x) => Math.round(9000 * x))),
      },
      face: faces('vertex_indices', 'ushort', 'ushort'),
    },
    { format: 'binary_big_endian' },
  ),
  'lists of vertices, flags before the corners': ply(
    {
      vertex: {
        properties: [['around', 'uchar', 'float'], ...xyz()],
        rows: vertices.map((p, v) => [Array(v % 3).fill(1.5), ...p]),
      },
      face: {
        properties: [
          ['flags', 'uchar'],
          ['vertex_indices', 'uchar', 'int'],
          ['quality', 'float'],
          ['texcoord', 'uchar', 'float'],
          ['texnumber', 'int'],
        ],
        rows: triangles.map((t, f) => [f % 7, t, 0.25, [0, 0, 1, 0, 0, 1], 0]),
      },
    },
    { format: 'binary_little_endian' },
  ),
  'cameras, edges and materials around them': ply({
    camera: {
      properties: [
        ['view_px', 'float'],
        ['name', 'uchar', 'char'],
      ],
      rows: [[1, [65, 66]]],
    },
    vertex: points,
    edge: {
      properties: [
        ['vertex1', 'int'],
        ['vertex2', 'int'],
      ],
      rows: [[0, 1]],
    },
    face: faces(),
    material: { properties: [['ambient_red', 'uchar']], rows: [[9]] },
  }),
  'a head in Windows lines, binary': ply({ vertex: points, face: faces() }, { format: 'binary_little_endian', eol: '\r\n', comments: ['TextureFile a.png', '  ', 'ü'] }), // prettier-ignore
  'quads and a pentagon': (() => {
    const quads = [];
    for (let i = 0; i < triangles.length; i += 2) {
      const [[a, b, c], [d, e, f]] = [triangles[i], triangles[i + 1]];
      quads.push(a === d && c === e ? [[a, b, c, f]] : [[a, e, b === f ? b : f, c]]);
    }
    return ply({ vertex: points, face: { properties: faces().properties, rows: quads } });
  })(),
  'vertices and qualities that are no numbers': ply({
    vertex: {
      properties: [...xyz(), ['quality', 'float']],
      rows: [
        ...vertices.map((p) => [...p, 'nan']),
        ['-nan(ind)', '1.#INF', 0, 1],
        [0, 'inf', 0, 1],
      ],
    },
    face: faces(),
  }),
  'st at vertices': ply({
    vertex: {
      properties: [...xyz(), ['nx', 'float'], ['s', 'float'], ['t', 'float']],
      rows: vertices.map((p, v) => [...p, 0, ...spherical[v]]),
    },
    face: faces(),
  }),
};

// ---- OBJ ----------------------------------------------------------------------------------------

const lines = vertices.map((p) => `v ${p.join(' ')}`);
const face = (t) => `f ${t.map((v) => v + 1).join(' ')}`;
const body = triangles.map(face);
const join = (...parts) => `${parts.flat().join('\n')}\n`;

export const objFiles = {
  'groups, smoothing, materials': join(
    'mtllib not here.mtl',
    'o ü "x"',
    lines,
    body.flatMap((f, i) => [`g part ${i % 3}`, `s ${i % 2 ? 'off' : 1}`, `usemtl m${i % 4}`, f]),
  ),
  'negative indices while vertices come': join(
    triangles.flatMap((t) => [...t.map((v) => lines[v]), 'f -3 -2 -1']),
  ),
  'faces before their vertices': join(body, lines),
  'continued lines': join(
    lines.map((l) => l.replace(' ', ' \\\n ')),
    body.map((f) => f.replace(/ (\d+)$/, ' \\\r\n$1')),
  ),
  'slashes of every kind': join(
    lines,
    'vt 0 0',
    'vt 1 0 0',
    'vt 0.5',
    'vn 0 0 1',
    triangles.map(
      (t, i) =>
        `f ${t.map((v) => [`${v + 1}/1/1`, `${v + 1}//1`, `${v + 1}/2`, `${v + 1}/`, `${v + 1}//`][i % 5]).join(' ')}`,
    ),
  ),
  'normals that are no numbers': join(
    lines,
    'vn nan nan nan',
    'vn -nan(ind) 0 1',
    'vn inf 0 0',
    body.map((f) => f.replace(/(\d+)/g, '$1//1')),
  ),
  'vertices and vt that are no numbers': join(
    'v nan nan nan',
    lines,
    'v 1e999 -1.#IND -inf',
    'vt nan -nan',
    triangles.map((t) => `f ${t.map((v) => `${v + 2}/1`).join(' ')}`),
  ),
  'colours and weights': join(
    lines.map((l, v) => `${l} ${v % 2 ? '0.5 0.25 1' : '1.0'}`),
    body,
  ),
  'numbers as they come': join(
    lines.map((l) => l.replace(/ (-?)0\./g, ' $1.').replace(/ (\d)/g, ' +$1')),
    body,
  ),
  'curves, points and lines between': join(
    'vp 0.5',
    lines,
    'p 1 2',
    'l 1 2 3',
    'cstype bezier',
    'deg 3',
    'curv 0 1 1 2 3 4',
    'end',
    body,
    'l 4 5',
  ),
  'comments behind statements': join(
    lines.map((l) => `${l} # C:\\`),
    body.map((f) => `${f}  # ${f}`),
  ),
  'tabs, blanks at ends, no last line end': join(
    '\t# made',
    lines.map((l) => ` ${l.replaceAll(' ', '\t')}  `),
    '',
    body.map((f) => `${f} \t`),
  ).trimEnd(),
  'a corner given twice in a row': join(
    lines,
    body.map((f, i) => (i % 4 ? f : f.replace(/ (\d+)$/, ' $1 $1'))),
  ),
  'windows lines and a mark': `\ufeff${join(lines, body).replaceAll('\n', '\r\n')}`,
  'a vertex for each corner': join(
    triangles.flatMap((t) => t.map((v) => lines[v])),
    triangles.map((_, i) => face([3 * i, 3 * i + 1, 3 * i + 2])),
  ),
};

// ---- OFF and STL --------------------------------------------------------------------------------

const offFaces = (more = '') => triangles.map((t) => `3 ${t.join(' ')}${more}`);
const rows = vertices.map((p) => p.join(' '));
const counts = `${vertices.length} ${triangles.length} 0`;

export const offFiles = {
  'COFF with bytes': join(
    'COFF',
    counts,
    rows.map((r) => `${r} 255 0 0 255`),
    offFaces(),
  ),
  'COFF with fractions, faces coloured': join(
    'COFF',
    counts,
    rows.map((r) => `${r} 1.0 0.5 0 1`),
    offFaces(' 3 0.5 0.5 0.5'),
  ),
  NOFF: join(
    'NOFF',
    counts,
    rows.map((r) => `${r} 0 0 1`),
    offFaces(),
  ),
  CNOFF: join(
    'CNOFF',
    counts,
    rows.map((r) => `${r} 0 0 1 0.5 0.5 0.5 1`),
    offFaces(),
  ),
  'faces with a colour of a map': join('# made', 'OFF # here', '', counts, rows, offFaces(' 7')),
  'Windows lines, edges counted': join(
    'OFF',
    `${vertices.length} ${triangles.length} 162`,
    rows,
    offFaces(),
  ).replaceAll('\n', '\r\n'),
};

function stl({
  head = 'made',
  count = triangles.length,
  attribute = 0,
  more = '',
  normal = [0, 0, 0],
} = {}) {
  const bytes = Buffer.alloc(84 + 50 * triangles.length);
  bytes.write(head);
  bytes.writeUInt32LE(count, 80);
  triangles.forEach((t, i) => {
    const numbers = [...normal, ...t.flatMap((v) => vertices[v])];
    numbers.forEach((x, k) => bytes.writeFloatLE(x, 84 + 50 * i + 4 * k));
    bytes.writeUInt16LE(attribute, 84 + 50 * i + 48);
  });
  return Buffer.concat([bytes, Buffer.from(more)]);
}

const facets = (list, normal = '0 0 0', number = (x) => `${x}`) =>
  list.map((t) => `facet normal ${normal}\n outer loop\n${t.map((v) => `  vertex ${vertices[v].map(number).join(' ')}`).join('\n')}\n endloop\nendfacet`); // prettier-ignore

export const stlFiles = {
  'a binary that begins with solid, coloured': stl({
    head: 'solid COLOR=\xff\x00\x00\xff,MATERIAL=',
    attribute: 0x8fff,
  }),
  'a count of too few': stl({ count: triangles.length, more: 'by a program\n' }),
  'normals that are no numbers, binary': stl({ normal: [NaN, NaN, NaN] }),
  'several solids': join(
    'solid a b',
    facets(triangles.slice(0, 50)),
    'endsolid a b',
    'solid c',
    facets(triangles.slice(50)),
    'endsolid',
  ),
  'normals that are no numbers': join('solid', facets(triangles, 'nan -nan(ind) 0'), 'endsolid'),
  'Fortran and Windows': join(
    'SOLID X',
    facets(triangles, '0.0E+00 0.0E+00 1.0E+00', (x) => x.toExponential(6).toUpperCase()),
    'ENDSOLID',
  ).replaceAll('\n', '\r\n'),
  'no end': join('solid x', facets(triangles)),
  'facets without area between': join(
    'solid x',
    facets([...triangles.slice(0, 9), [0, 0, 1], [3, 3, 3], ...triangles.slice(9)]),
    'endsolid x',
  ),
};
