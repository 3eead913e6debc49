// Generated glTF files that use every feature the patch writer must carry through.

import assert from 'node:assert/strict';
import draco3d from 'draco3dgltf';
import { MeshoptEncoder } from 'meshoptimizer/encoder';
import { concat, packChunks, chunkType, packGlb } from './container.mjs';

const componentTypes = new Map([
  [Int8Array, 5120],
  [Uint8Array, 5121],
  [Int16Array, 5122],
  [Uint16Array, 5123],
  [Uint32Array, 5125],
  [Float32Array, 5126],
]);
const widths = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16 };

/** Collects accessors, views and bytes. */
class Asset {
  constructor() {
    this.json = { asset: { version: '2.0' }, accessors: [], bufferViews: [], buffers: [{}] };
    this.parts = [];
    this.length = 0;
  }

  bytes(array) {
    const bytes = new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
    const padding = new Uint8Array((4 - (bytes.length % 4)) % 4);
    const offset = this.length;
    this.parts.push(bytes, padding);
    this.length += bytes.length + padding.length;
    return { offset, length: bytes.length };
  }

  view(array, more = {}) {
    const { offset, length } = this.bytes(array);
    return (
      this.json.bufferViews.push({ buffer: 0, byteOffset: offset, byteLength: length, ...more }) - 1
    );
  }

  /** A tightly packed accessor; narrow elements get a stride of 4 as vertex attributes must. */
  accessor(array, type, more = {}) {
    const width = widths[type];
    const size = array.BYTES_PER_ELEMENT * width;
    const count = array.length / width;
    let data = array;
    let stride = {};
    if (more.target === 34962 && size % 4 !== 0) {
      const padded = Math.ceil(size / 4) * 4;
      stride = { byteStride: padded };
      data = new Uint8Array(count * padded);
      const bytes = new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
      for (let i = 0; i < count; i += 1)
        data.set(bytes.subarray(i * size, (i + 1) * size), i * padded);
    }
    const { target, ...rest } = more;
    const view = this.view(data, { ...(target ? { target } : {}), ...stride });
    return this.add({
      bufferView: view,
      componentType: componentTypes.get(array.constructor),
      count,
      type,
      ...rest,
    });
  }

  add(accessor) {
    return this.json.accessors.push(accessor) - 1;
  }

  vertices(array, type, more = {}) {
    return this.accessor(array, type, { target: 34962, ...more });
  }

  positions(array) {
    return this.vertices(array, 'VEC3', range(array));
  }

  indices(array) {
    return this.accessor(array, 'SCALAR', { target: 34963 });
  }

  bin() {
    this.json.buffers[0].byteLength = this.length;
    return concat(this.parts);
  }

  glb() {
    const bin = this.bin();
    return packGlb(this.json, bin);
  }
}

function range(array) {
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  array.forEach((value, i) => {
    min[i % 3] = Math.min(min[i % 3], value);
    max[i % 3] = Math.max(max[i % 3], value);
  });
  return { min, max };
}

/** A bumpy m × n grid. */
function grid(m, n) {
  const position = [];
  const normal = [];
  const tangent = [];
  const uv = [];
  for (let j = 0; j <= n; j += 1) {
    for (let i = 0; i <= m; i += 1) {
      position.push(i, j, Math.fround(0.3 * Math.sin(i * 1.3 + j * 0.7)));
      normal.push(0, 0, 1);
      tangent.push(1, 0, 0, 1);
      uv.push(i / m, j / n);
    }
  }
  const index = [];
  for (let j = 0; j < n; j += 1) {
    for (let i = 0; i < m; i += 1) {
      const a = j * (m + 1) + i;
      index.push(a, a + 1, a + m + 2, a, a + m + 2, a + m + 1);
    }
  }
  return {
    count: position.length / 3,
    position: Float32Array.from(position),
    normal: Float32Array.from(normal),
    tangent: Float32Array.from(tangent),
    uv: Float32Array.from(uv),
    index,
  };
}

const byCount = (count, width, value) =>
  Array.from({ length: count * width }, (_, i) => value(Math.floor(i / width), i % width));

// A 1 × 1 PNG.
const png = Uint8Array.from(
  Buffer.from(
    'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==',
    'base64',
  ),
);

/** Skin, morph targets, colours, custom attributes, shared accessors, materials, animation … */
function everything({ vendor }) {
  const asset = new Asset();
  const { json } = asset;
  const g = grid(6, 5);
  const n = g.count;
  const position = asset.positions(g.position);
  const normal = asset.vertices(g.normal, 'VEC3', {
    name: 'shared normals',
    extras: { keep: [1, null, 2] },
  });
  const attributes = {
    POSITION: position,
    NORMAL: normal,
    TANGENT: asset.vertices(g.tangent, 'VEC4'),
    TEXCOORD_0: asset.vertices(
      Uint16Array.from(g.uv, (x) => Math.round(x * 65535)),
      'VEC2',
      {
        normalized: true,
      },
    ),
    COLOR_0: asset.vertices(Uint8Array.from(byCount(n, 4, (v, k) => (v * 7 + k) % 256)), 'VEC4', {
      normalized: true,
    }),
    JOINTS_0: asset.vertices(
      Uint8Array.from(byCount(n, 4, (v, k) => (k === 0 ? v % 2 : 0))),
      'VEC4',
    ),
    WEIGHTS_0: asset.vertices(
      Float32Array.from(byCount(n, 4, (v, k) => (k === 0 ? 1 : 0))),
      'VEC4',
    ),
    _CUSTOM: asset.vertices(Int16Array.from(byCount(n, 3, (v, k) => v * 3 + k)), 'VEC3'),
    _ZERO: asset.add({ componentType: 5126, count: n, type: 'SCALAR' }),
  };
  const moved = Float32Array.from(g.position, (x) => x * 0.25);
  const targets = [
    {
      POSITION: asset.vertices(moved, 'VEC3', range(moved)),
      NORMAL: asset.vertices(
        Float32Array.from(g.normal, () => 0),
        'VEC3',
      ),
    },
    {
      POSITION: asset.add({
        componentType: 5126,
        count: n,
        type: 'VEC3',
        min: [0, 0, 0],
        max: [0, 0, 5],
        sparse: {
          count: 2,
          indices: { bufferView: asset.view(Uint16Array.of(3, 11)), componentType: 5123 },
          values: { bufferView: asset.view(Float32Array.of(0, 0, 5, 0, 0, 2.5)) },
        },
      }),
    },
  ];
  const half = (g.index.length / 6) * 3;
  json.meshes = [
    {
      name: 'quote " and \u202e',
      weights: [0.1, 0.2],
      primitives: [
        {
          attributes,
          targets,
          material: 0,
          indices: asset.indices(Uint8Array.from(g.index.slice(0, half))),
          extras: { big: 'replaced below' },
          extensions: {
            KHR_materials_variants: { mappings: [{ material: 1, variants: [0] }] },
          },
        },
        {
          attributes,
          targets,
          material: 1,
          indices: asset.indices(Uint16Array.from(g.index.slice(half))),
        },
        {
          attributes: { POSITION: position },
          targets: [{}, {}].map((_, t) => ({ POSITION: targets[t].POSITION })),
          mode: 0,
        },
      ],
      extras: { targetNames: ['a', 'b'], nothing: null, list: [null, 1, null] },
    },
    {
      name: 'shares accessors',
      primitives: [
        {
          attributes: { POSITION: position, NORMAL: normal },
          indices: asset.indices(Uint32Array.from(g.index)),
        },
      ],
    },
  ];
  const matrix = (x) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, 0, 0, 1];
  json.skins = [
    {
      joints: [1, 2],
      inverseBindMatrices: asset.accessor(Float32Array.from([...matrix(0), ...matrix(-1)]), 'MAT4'),
    },
  ];
  json.nodes = [
    { mesh: 0, skin: 0 },
    { name: 'joint 0', children: [2] },
    { name: 'joint 1', translation: [1, 0, 0] },
    { mesh: 1, camera: 0 },
  ];
  json.scenes = [{ nodes: [0, 1, 3] }];
  json.scene = 0;
  json.cameras = [{ type: 'perspective', perspective: { yfov: 0.7, znear: 0.01 } }];
  json.animations = [
    {
      samplers: [
        {
          input: asset.accessor(Float32Array.of(0, 1), 'SCALAR', { min: [0], max: [1] }),
          output: asset.accessor(Float32Array.of(0, 0, 1, 1), 'SCALAR'),
        },
      ],
      channels: [{ sampler: 0, target: { node: 0, path: 'weights' } }],
    },
  ];
  json.images = [{ bufferView: asset.view(png), mimeType: 'image/png' }];
  json.textures = [{ source: 0, name: 'kept' }];
  json.samplers = [{ wrapS: 10497 }];
  json.materials = [
    {
      normalTexture: { index: 0, scale: 0.5 },
      pbrMetallicRoughness: { baseColorTexture: { index: 0 } },
    },
    {
      normalTexture: {
        index: 0,
        texCoord: 0,
        extensions: { KHR_texture_transform: { scale: [2, 2] } },
      },
    },
  ];
  json.extensionsUsed = ['KHR_materials_variants', 'KHR_texture_transform'];
  json.extensions = { KHR_materials_variants: { variants: [{ name: 'v' }] } };
  if (vendor) {
    json.extensionsUsed.push('VENDOR_views');
    json.extensions.VENDOR_views = { someView: 0, accessor: 2, big: 'replaced below' };
  }
  const bin = asset.bin();
  // Spellings that no JavaScript number survives.
  const text = JSON.stringify(json).replaceAll(
    '"replaced below"',
    '[9007199254740993, 123456789012345678901234567890, 1.0, 1e400, 0.10000000000000000001]',
  );
  return packChunks([
    [chunkType.json, new TextEncoder().encode(text)],
    [chunkType.bin, bin],
    [0x21212121, Uint8Array.of(1, 2, 3, 4)],
  ]);
}

/** Position, normal and colour in one interleaved view, quantized as KHR_mesh_quantization allows. */
function interleaved() {
  const asset = new Asset();
  const { json } = asset;
  const g = grid(7, 4);
  const data = new DataView(new ArrayBuffer(g.count * 16));
  for (let v = 0; v < g.count; v += 1) {
    for (let k = 0; k < 3; k += 1) {
      data.setInt16(v * 16 + 2 * k, Math.round(g.position[3 * v + k] * 1000), true);
      data.setInt8(v * 16 + 8 + k, g.normal[3 * v + k] * 127);
      data.setUint8(v * 16 + 12 + k, v % 256);
    }
    data.setUint8(v * 16 + 15, 255);
  }
  const view = asset.view(new Uint8Array(data.buffer), {
    byteStride: 16,
    target: 34962,
    name: 'woven',
  });
  const shared = { bufferView: view, count: g.count };
  const positions = Array.from(g.position, (x) => Math.round(x * 1000));
  json.meshes = [
    {
      primitives: [
        {
          attributes: {
            POSITION: asset.add({
              ...shared,
              componentType: 5122,
              type: 'VEC3',
              ...range(positions),
            }),
            NORMAL: asset.add({
              ...shared,
              byteOffset: 8,
              componentType: 5120,
              type: 'VEC3',
              normalized: true,
            }),
            COLOR_0: asset.add({
              ...shared,
              byteOffset: 12,
              componentType: 5121,
              type: 'VEC4',
              normalized: true,
            }),
          },
          indices: asset.indices(Uint16Array.from(g.index)),
        },
      ],
      extras: 17,
    },
  ];
  json.nodes = [{ mesh: 0, scale: [0.001, 0.001, 0.001] }];
  json.scenes = [{ nodes: [0] }];
  json.extensionsUsed = ['KHR_mesh_quantization'];
  json.extensionsRequired = ['KHR_mesh_quantization'];
  return asset.glb();
}

/** One primitive draws all vertices there are, without indices; another one, with them, some again. */
function sharedSoup() {
  const asset = new Asset();
  const { json } = asset;
  const corners = [
    [0, 0, 0],
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  const drawn = [0, 2, 1, 0, 1, 3, 0, 3, 2];
  const POSITION = asset.positions(Float32Array.from(drawn.flatMap((v) => corners[v])));
  const indices = asset.indices(Uint16Array.from([2, 1, 5])); // the face opposite corner 0
  json.meshes = [
    { primitives: [{ attributes: { POSITION } }, { attributes: { POSITION }, indices }] },
  ];
  json.nodes = [{ mesh: 0 }];
  json.scenes = [{ nodes: [0] }];
  return asset.glb();
}

/** Strip, fan and a list without indices, each of its own vertices, in a .gltf printed in lines. */
function modes() {
  const asset = new Asset();
  const { json } = asset;
  const g = grid(5, 1);
  const strip = [];
  for (let i = 0; i <= 5; i += 1) strip.push(i, i + 6);
  strip.push(11, 11, 6); // joins and repeats
  const fan = Float32Array.from(
    [
      [10, 0, 0],
      ...Array.from({ length: 7 }, (_, i) => [
        10 + Math.cos((i * Math.PI) / 3),
        Math.sin((i * Math.PI) / 3),
        0,
      ]),
    ].flat(),
  );
  const soup = Float32Array.from(
    grid(2, 2).index.flatMap((v) => [...grid(2, 2).position.subarray(3 * v, 3 * v + 3)]),
  );
  json.meshes = [
    {
      primitives: [
        {
          attributes: { POSITION: asset.positions(g.position) },
          indices: asset.indices(Uint16Array.from(strip)),
          mode: 5,
        },
        { attributes: { POSITION: asset.positions(fan) }, mode: 6 },
        { attributes: { POSITION: asset.positions(soup) } },
      ],
    },
  ];
  json.nodes = [{ mesh: 0 }];
  json.scenes = [{ nodes: [0] }];
  const bin = asset.bin();
  json.buffers[0].uri = 'modes%20data.bin';
  return { 'modes.gltf': `${JSON.stringify(json, null, 2)}\n`, 'modes data.bin': bin };
}

/** All data in a data URI; byte indices that must become shorts, shorts that must become ints. */
function promotion(rows) {
  const asset = new Asset();
  const { json } = asset;
  const small = grid(15, 14);
  const large = grid(255, rows);
  // Indices have to be large, not many: triangles of the last rows only.
  large.index = large.index.slice(-6 * 255 * 40);
  json.meshes = [small, large].map((g) => ({
    primitives: [
      {
        attributes: { POSITION: asset.positions(g.position) },
        indices: asset.accessor(
          g === small ? Uint8Array.from(g.index) : Uint16Array.from(g.index),
          'SCALAR',
          { target: 34963, min: [g.index[0]], max: [g.count - 1], name: 'faces' },
        ),
      },
    ],
  }));
  json.nodes = [{ mesh: 0 }, { mesh: 1 }];
  json.scenes = [{ nodes: [0, 1] }];
  const bin = asset.bin();
  json.buffers[0].uri = `data:application/octet-stream;base64,${Buffer.from(bin).toString('base64')}`;
  return `\uFEFF${JSON.stringify(json, null, '\t')}`;
}

/** One primitive has more uv sets than the other, which has none. */
function unevenSets() {
  const asset = new Asset();
  const { json } = asset;
  const g = grid(3, 3);
  const uv = asset.vertices(g.uv, 'VEC2');
  json.meshes = [
    {
      primitives: [
        {
          attributes: { POSITION: asset.positions(g.position), TEXCOORD_0: uv, TEXCOORD_1: uv },
          indices: asset.indices(Uint16Array.from(g.index)),
        },
        {
          attributes: { POSITION: asset.positions(g.position.map((x) => x + 10)) },
          indices: asset.indices(Uint16Array.from(g.index)),
        },
      ],
    },
  ];
  json.nodes = [{ mesh: 0 }];
  json.scenes = [{ nodes: [0] }];
  return asset.glb();
}

/** Two materials on one closed surface, joined by EXT_mesh_manifold; `edit` may break the joint. */
function manifold(edit = () => {}) {
  const asset = new Asset();
  const { json } = asset;
  // An octahedron whose equator is split: 4 + 4 + 1 + 1 vertices.
  const ring = [1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0];
  const position = asset.positions(Float32Array.from([...ring, ...ring, 0, 0, 1, 0, 0, -1]));
  const upper = [0, 1, 2, 3].flatMap((i) => [i, (i + 1) % 4, 8]);
  const lower = [0, 1, 2, 3].flatMap((i) => [4 + ((i + 1) % 4), 4 + i, 9]);
  const all = asset.view(Uint32Array.from([...upper, ...lower]), { target: 34963 });
  const merged = lower.map((v, k) => [12 + k, v]).filter(([, v]) => v < 8);
  const where = asset.view(Uint32Array.from(merged.map(([k]) => k)));
  const values = asset.view(Uint32Array.from(merged.map(([, v]) => v - 4)));
  const shape = { componentType: 5125, type: 'SCALAR' };
  json.meshes = [
    {
      primitives: [
        { attributes: { POSITION: position }, material: 0, mode: 4, indices: 1 },
        { attributes: { POSITION: position }, material: 1, mode: 4, indices: 2 },
      ],
      extensions: {
        EXT_mesh_manifold: {
          manifoldPrimitive: { indices: 3, mode: 4, attributes: { POSITION: position } },
          mergeIndices: 4,
          mergeValues: 5,
        },
      },
    },
  ];
  asset.add({ bufferView: all, count: 12, ...shape });
  asset.add({ bufferView: all, byteOffset: 48, count: 12, ...shape });
  asset.add({
    bufferView: all,
    count: 24,
    ...shape,
    sparse: {
      count: merged.length,
      indices: { bufferView: where, componentType: 5125 },
      values: { bufferView: values },
    },
  });
  asset.add({ bufferView: where, count: merged.length, ...shape });
  asset.add({ bufferView: values, count: merged.length, ...shape });
  json.materials = [{}, { doubleSided: true }];
  json.extensionsUsed = ['EXT_mesh_manifold'];
  json.nodes = [{ mesh: 0 }];
  json.scenes = [{ nodes: [0] }];
  edit(json);
  return asset.glb();
}

/** The halves apart, with an apex whose place is not a number: there is no map, but the surface stays what it is. */
export function manifoldWithoutPlace() {
  const bytes = manifold((json) => delete json.accessors[3].sparse);
  const view = new DataView(bytes.buffer, bytes.byteOffset);
  const binary = 20 + view.getUint32(12, true) + 8;
  view.setFloat32(binary + 12 * 8 + 4, NaN, true);
  return bytes;
}

/** Merges that are all zero because they have no buffer view: legal, and wrong. */
function zeroMerges(json) {
  delete json.accessors[4].bufferView;
}

/** A manifold whose indices are not the primitives': read or kept, it would weld otherwise each time. */
function foreignIndices(json) {
  json.meshes[0].extensions.EXT_mesh_manifold.manifoldPrimitive.indices = 4;
}

/** Two primitives that draw the same indices, which are the manifold's: two cannot be written there. */
function oneForTwo(json) {
  delete json.accessors[2].byteOffset;
  json.meshes[0].extensions.EXT_mesh_manifold.manifoldPrimitive.indices = 2;
}

/** A primitive that reaches past the manifold's indices. */
function pastTheManifold(json) {
  json.accessors[3].count = 21;
  delete json.accessors[3].sparse;
}

/** A merge at one corner that the vertex's other corners do not have: copies would be told apart anew. */
function mergedAtOneCorner(json) {
  for (const a of [4, 5]) json.accessors[a].count -= 1;
  json.accessors[3].sparse.count -= 1;
}

/**
 * EXT_meshopt_compression: filtered normals, triangles, and a view of another mesh. `edit` may change
 * the positions.
 */
export async function meshopt(edit = () => {}) {
  await MeshoptEncoder.ready;
  const asset = new Asset();
  const { json } = asset;
  const g = grid(9, 8);
  edit(g.position);
  json.buffers.push({ byteLength: 0, extensions: { EXT_meshopt_compression: { fallback: true } } });
  const view = (source, count, stride, mode, more = {}, filter) => {
    const packed = MeshoptEncoder.encodeGltfBuffer(source, count, stride, mode);
    const { offset, length } = asset.bytes(packed);
    const byteOffset = json.buffers[1].byteLength;
    json.buffers[1].byteLength += count * stride;
    return (
      json.bufferViews.push({
        buffer: 1,
        byteOffset,
        byteLength: count * stride,
        ...more,
        extensions: {
          EXT_meshopt_compression: {
            buffer: 0,
            byteOffset: offset,
            byteLength: length,
            byteStride: stride,
            mode,
            count,
            ...(filter ? { filter } : {}),
          },
        },
      }) - 1
    );
  };
  const bytes = (array) => new Uint8Array(array.buffer);
  const vertices = { target: 34962 };
  const position = view(bytes(g.position), g.count, 12, 'ATTRIBUTES', {
    ...vertices,
    byteStride: 12,
  });
  const normals = Float32Array.from(byCount(g.count, 4, (v, k) => (k === 2 ? 1 : 0)));
  const octahedral = MeshoptEncoder.encodeFilterOct(normals, g.count, 4, 8);
  const normal = view(
    octahedral,
    g.count,
    4,
    'ATTRIBUTES',
    { ...vertices, byteStride: 4 },
    'OCTAHEDRAL',
  );
  const primitive = () => ({
    attributes: {
      POSITION: asset.add({
        bufferView: position,
        componentType: 5126,
        count: g.count,
        type: 'VEC3',
        ...range(g.position),
      }),
      NORMAL: asset.add({
        bufferView: normal,
        componentType: 5120,
        normalized: true,
        count: g.count,
        type: 'VEC3',
      }),
    },
    indices: asset.add({
      bufferView: view(bytes(Uint16Array.from(g.index)), g.index.length, 2, 'TRIANGLES', {
        target: 34963,
      }),
      componentType: 5123,
      count: g.index.length,
      type: 'SCALAR',
    }),
  });
  json.meshes = [{ primitives: [primitive()] }, { primitives: [primitive()] }];
  json.nodes = [{ mesh: 0 }, { mesh: 1 }];
  json.scenes = [{ nodes: [0, 1] }];
  json.extensionsUsed = ['EXT_meshopt_compression', 'KHR_mesh_quantization'];
  json.extensionsRequired = ['EXT_meshopt_compression', 'KHR_mesh_quantization'];
  return asset.glb();
}

/** KHR_draco_mesh_compression in two meshes; one attribute of the first stays outside. */
async function draco() {
  const module = await draco3d.createEncoderModule();
  const asset = new Asset();
  const { json } = asset;
  const primitive = (g) => {
    const encoder = new module.Encoder();
    const builder = new module.MeshBuilder();
    const mesh = new module.Mesh();
    builder.AddFacesToMesh(mesh, g.index.length / 3, g.index);
    const position = builder.AddFloatAttributeToMesh(mesh, module.POSITION, g.count, 3, g.position);
    const uv = builder.AddFloatAttributeToMesh(mesh, module.TEX_COORD, g.count, 2, g.uv);
    encoder.SetEncodingMethod(module.MESH_SEQUENTIAL_ENCODING);
    const out = new module.DracoInt8Array();
    const length = encoder.EncodeMeshToDracoBuffer(mesh, out);
    const bytes = Int8Array.from({ length }, (_, i) => out.GetValue(i));
    for (const object of [out, mesh, builder, encoder]) module.destroy(object);
    const view = asset.view(bytes);
    const shape = { componentType: 5126, count: g.count };
    return {
      attributes: {
        POSITION: asset.add({ ...shape, type: 'VEC3', ...range(g.position) }),
        TEXCOORD_0: asset.add({ ...shape, type: 'VEC2' }),
        _OUTSIDE: asset.vertices(
          Float32Array.from({ length: g.count }, (_, i) => i),
          'SCALAR',
        ),
      },
      indices: asset.add({ componentType: 5123, count: g.index.length, type: 'SCALAR' }),
      extensions: {
        KHR_draco_mesh_compression: {
          bufferView: view,
          attributes: { POSITION: position, TEXCOORD_0: uv },
        },
      },
    };
  };
  json.meshes = [
    { primitives: [primitive(grid(5, 5)), primitive(grid(3, 7))] },
    { primitives: [primitive(grid(4, 4))] },
  ];
  json.nodes = [{ mesh: 0 }, { mesh: 1 }];
  json.scenes = [{ nodes: [0, 1] }];
  json.extensionsUsed = ['KHR_draco_mesh_compression'];
  json.extensionsRequired = ['KHR_draco_mesh_compression'];
  return asset.glb();
}

// The unknown extension and the compressed data are beyond the validator; all else must be faultless.
const maps = (list, more = {}) =>
  list.map((map) => ({ map, ...more, extra: { isClean: true, ...more.extra } }));
const all = ['vertices', 'patches', 'corners'];

const primitives = (file, mesh = 0) => file.json.meshes[mesh].primitives;

/** Every halfedge of the manifold has its one partner, and merges keep positions. */
function isStillManifold({ document, json }) {
  const { manifoldPrimitive, mergeIndices, mergeValues } =
    json.meshes[0].extensions.EXT_mesh_manifold;
  const accessors = document.getRoot().listAccessors();
  const index = accessors[manifoldPrimitive.indices].getArray();
  const halfedges = new Set();
  for (let i = 0; i < index.length; i += 1) {
    const next = i % 3 === 2 ? i - 2 : i + 1;
    const name = `${index[i]} ${index[next]}`;
    assert.ok(!halfedges.has(name), 'one halfedge each way');
    halfedges.add(name);
  }
  for (const name of halfedges) assert.ok(halfedges.has(name.split(' ').reverse().join(' ')));
  const [where, values] = [mergeIndices, mergeValues].map((a) => accessors[a].getArray());
  where.forEach((k, i) => assert.equal(index[k], values[i]));
  const { sparse, bufferView } = json.accessors[manifoldPrimitive.indices];
  assert.equal(sparse.count, where.length);
  for (const { indices, attributes } of primitives({ json })) {
    assert.equal(json.accessors[indices].bufferView, bufferView, 'the same buffer view');
    assert.equal(attributes.POSITION, manifoldPrimitive.attributes.POSITION);
  }
}

function hasNoTangents(file, notes) {
  assert.equal(primitives(file)[0].attributes.TANGENT, undefined);
  assert.ok(notes.includes('write-tangents-dropped'));
}

/**
 * @param {{ isSolved?: boolean }} options  whether maps are solved for: the grid whose indices are nearly too
 *     large is then a small one, as nothing is promoted where its map needs no cut
 * @returns {Promise<{name: string, files: Record<string, Uint8Array|string>, cases: object[]}[]>}
 */
export async function featureFiles({ isSolved = false } = {}) {
  const replaced = {
    set: 0,
    extra: { replaced: true, lostTangents: true },
    check: hasNoTangents,
  };
  return [
    {
      name: 'everything',
      files: { 'everything.glb': everything({ vendor: false }) },
      cases: [
        ...maps(all),
        ...maps(all, replaced),
        ...maps(['corners'], { set: 3 }),
        ...maps(['corners'], { surface: 1, target: 1 }),
      ],
    },
    {
      name: 'everything and an unknown extension',
      files: { 'vendor.glb': everything({ vendor: true }) },
      cases: [
        ...maps(all, {
          // Nobody knows what an unknown extension points at, so nothing old is edited.
          check: ({ json }) => assert.equal(json.accessors[2].count, 42),
        }),
        ...maps(['patches'], replaced),
      ],
    },
    { name: 'interleaved and quantized', files: { 'woven.glb': interleaved() }, cases: maps(all) },
    { name: 'strip, fan, no indices', files: modes(), cases: maps(all) },
    { name: 'indices in part', files: { 'in-part.glb': sharedSoup() }, cases: maps(all) },
    {
      name: 'index promotion, data URI',
      files: { 'promotion.gltf': promotion(isSolved ? 8 : 254) },
      cases: [
        ...maps(['vertices', 'patches']),
        ...maps(['corners'], {
          check: ({ json }) =>
            assert.equal(json.accessors[primitives({ json })[0].indices].componentType, 5123),
        }),
        ...maps(['patches', 'corners'], {
          surface: 1,
          target: 1,
          check: ({ json }) =>
            assert.equal(json.accessors[primitives({ json }, 1)[0].indices].componentType, 5125),
        }),
      ],
    },
    { name: 'uneven uv sets', files: { 'uneven.glb': unevenSets() }, cases: maps(all) },
    {
      name: 'EXT_mesh_manifold',
      files: { 'manifold.glb': manifold() },
      cases: maps(all, { check: isStillManifold }),
    },
    {
      name: 'EXT_mesh_manifold with merges of zeros',
      files: { 'zero-merges.glb': manifold(zeroMerges) },
      cases: maps(all),
    },
    {
      name: 'EXT_mesh_manifold with indices of its own',
      files: { 'foreign-indices.glb': manifold(foreignIndices) },
      cases: [
        ...maps(['vertices']),
        // It cannot be kept true where vertices split: dropped, and the surface stays the same.
        ...maps(['patches', 'corners'], { extra: { lostExtensions: ['EXT_mesh_manifold'] } }),
      ],
    },
    {
      name: 'EXT_mesh_manifold with a vertex that is merged at one corner only',
      files: { 'one-corner.glb': manifold(mergedAtOneCorner) },
      cases: [
        ...maps(['vertices']),
        ...maps(['patches', 'corners'], { extra: { lostExtensions: ['EXT_mesh_manifold'] } }),
      ],
    },
    {
      name: 'EXT_mesh_manifold that ends within a primitive',
      files: { 'past-the-manifold.glb': manifold(pastTheManifold) },
      cases: [
        ...maps(['vertices']),
        ...maps(['patches', 'corners'], { extra: { lostExtensions: ['EXT_mesh_manifold'] } }),
      ],
    },
    {
      name: 'EXT_mesh_manifold with one array for two primitives',
      files: { 'one-for-two.glb': manifold(oneForTwo) },
      cases: [
        ...maps(['vertices']),
        ...maps(['patches', 'corners'], { extra: { lostExtensions: ['EXT_mesh_manifold'] } }),
      ],
    },
    {
      name: 'meshopt',
      files: { 'meshopt.glb': await meshopt() },
      cases: [
        ...maps(all),
        ...maps(['corners'], {
          check: ({ json }) => {
            const view = (mesh, name) =>
              json.bufferViews[
                json.accessors[primitives({ json }, mesh)[0].attributes[name]].bufferView
              ];
            assert.equal(view(0, 'NORMAL').extensions, undefined, 'stored uncompressed');
            assert.ok(view(1, 'NORMAL').extensions, 'others stay as they were');
          },
        }),
      ],
    },
    {
      name: 'Draco',
      files: { 'draco.glb': await draco() },
      cases: maps(all, {
        check: ({ json }) => {
          assert.ok(primitives({ json }, 0).every((p) => p.extensions === undefined));
          assert.ok(primitives({ json }, 1)[0].extensions.KHR_draco_mesh_compression);
          assert.deepEqual(json.extensionsRequired, ['KHR_draco_mesh_compression']);
        },
      }),
    },
  ];
}
