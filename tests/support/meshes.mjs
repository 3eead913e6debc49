// Small meshes for the tests, in every format that is read.

/** A rounded cube: 8 corners first, n × n squares per face. */
export function cubeMesh(n = 8) {
  const vertices = [];
  const ids = new Map();
  const vertex = (p) => {
    const key = p.join(' ');
    if (!ids.has(key)) {
      ids.set(key, vertices.length);
      const q = p.map((x) => (2 * x) / n - 1);
      const size = q.reduce((sum, x) => sum + x ** 6, 0) ** (1 / 6);
      vertices.push(q.map((x) => x / size));
    }
    return ids.get(key);
  };
  for (let i = 0; i < 8; i++) vertex([i & 1, (i >> 1) & 1, i >> 2].map((x) => x * n));
  const triangles = [];
  for (let axis = 0; axis < 3; axis++) {
    for (const side of [0, n]) {
      for (let i = 0; i < n; i++) {
        for (let j = 0; j < n; j++) {
          const at = (u, v) => {
            const p = [0, 0, 0];
            p[axis] = side;
            p[(axis + 1) % 3] = u;
            p[(axis + 2) % 3] = v;
            return vertex(p);
          };
          const [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
          if (side) triangles.push([a, b, c], [a, c, d]);
          else triangles.push([a, c, b], [a, d, c]);
        }
      }
    }
  }
  return { vertices, triangles };
}

/** A cross field along the edges of cubeMesh: one direction per triangle, as .rosy has it. */
export function cubeCrosses({ vertices, triangles }) {
  const rows = triangles.map((t) => {
    const middle = [0, 1, 2].map((i) => t.reduce((sum, v) => sum + vertices[v][i], 0));
    const axis = middle.map(Math.abs).indexOf(Math.max(...middle.map(Math.abs)));
    return [0, 1, 2].map((i) => (i === (axis + 1) % 3 ? 1 : 0)).join(' ');
  });
  return `${triangles.length}\n4\n${rows.join('\n')}\n`;
}

export const toObj = ({ vertices, triangles }) =>
  [
    ...vertices.map((p) => `v ${p.join(' ')}`),
    ...triangles.map((t) => `f ${t.map((v) => v + 1).join(' ')}`),
    '',
  ].join('\n');

export const toOff = ({ vertices, triangles }) =>
  [
    'OFF',
    `${vertices.length} ${triangles.length} 0`,
    ...vertices.map((p) => p.join(' ')),
    ...triangles.map((t) => `3 ${t.join(' ')}`),
    '',
  ].join('\n');

export const toPly = ({ vertices, triangles }) =>
  [
    'ply',
    'format ascii 1.0',
    `element vertex ${vertices.length}`,
    ...['x', 'y', 'z'].map((name) => `property float ${name}`),
    `element face ${triangles.length}`,
    'property list uchar int vertex_indices',
    'end_header',
    ...vertices.map((p) => p.join(' ')),
    ...triangles.map((t) => `3 ${t.join(' ')}`),
    '',
  ].join('\n');

export const toStl = ({ vertices, triangles }) =>
  [
    'solid cube',
    ...triangles.map(
      (t) =>
        `facet normal 0 0 0\nouter loop\n${t.map((v) => `vertex ${vertices[v].join(' ')}`).join('\n')}\nendloop\nendfacet`,
    ),
    'endsolid cube',
    '',
  ].join('\n');

/** A .gltf that refers to a buffer file and, optionally, an image. */
/** @param uv  texture coordinates by number of the set: functions of a position */
export function toGltf(meshes, { buffer = 'cube.bin', image, uv = {} } = {}) {
  const parts = [];
  const json = {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: meshes.map((_, i) => i) }],
    nodes: meshes.map((_, mesh) => ({ mesh })),
    meshes: [],
    accessors: [],
    bufferViews: [],
    buffers: [],
    extras: { keep: 9007199254740993n.toString() },
  };
  let at = 0;
  const add = (array, type, componentType, count, more) => {
    json.bufferViews.push({ buffer: 0, byteOffset: at, byteLength: array.byteLength });
    json.accessors.push({
      bufferView: json.bufferViews.length - 1,
      componentType,
      count,
      type,
      ...more,
    });
    parts.push(Buffer.from(array.buffer));
    at += array.byteLength;
    return json.accessors.length - 1;
  };
  meshes.forEach(({ vertices, triangles }, i) => {
    const positions = new Float32Array(vertices.flat());
    const bound = (pick) =>
      [0, 1, 2].map((k) => Math.fround(pick(...vertices.map((p) => Math.fround(p[k])))));
    const position = add(positions, 'VEC3', 5126, vertices.length, {
      min: bound(Math.min),
      max: bound(Math.max),
    });
    const indices = add(new Uint32Array(triangles.flat()), 'SCALAR', 5125, 3 * triangles.length);
    const material = image ? 0 : undefined;
    const attributes = { POSITION: position };
    for (const [set, of] of Object.entries(uv)) {
      const values = new Float32Array(vertices.flatMap(of));
      attributes[`TEXCOORD_${set}`] = add(values, 'VEC2', 5126, vertices.length);
    }
    json.meshes.push({ name: `mesh ${i}`, primitives: [{ attributes, indices, material }] });
  });
  const bin = Buffer.concat(parts);
  json.buffers.push({ uri: buffer, byteLength: bin.length });
  if (image) {
    json.images = [{ uri: image }];
    json.textures = [{ source: 0 }];
    json.materials = [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }];
  }
  return { json, bin };
}

export const toGlb = (meshes) => packGlb(toGltf(meshes));

/** A GLB of the parts of toGltf. */
export function packGlb({ json, bin }) {
  delete json.buffers[0].uri;
  const raw = JSON.stringify(json);
  const text = Buffer.from(raw.padEnd(Math.ceil(raw.length / 4) * 4));
  const head = Buffer.alloc(20);
  [0x46546c67, 2, 28 + text.length + bin.length, text.length, 0x4e4f534a].forEach((n, i) =>
    head.writeUInt32LE(n, 4 * i),
  );
  const chunk = Buffer.alloc(8);
  chunk.writeUInt32LE(bin.length, 0);
  chunk.writeUInt32LE(0x004e4942, 4);
  return Buffer.concat([head, text, chunk, bin]);
}
