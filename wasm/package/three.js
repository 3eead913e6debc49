// hgp/three: a BufferGeometry with seamless texture coordinates.

import { BufferAttribute, BufferGeometry, LineSegments } from 'three';
import { usage } from './lib/error.js';
import { toGlb } from './lib/glb.js';
import { splitAlongSeams } from './lib/split.js';

/** Three numbers per vertex, converted from any storage (interleaved, normalized …). */
function positionsOf(geometry) {
  const position = geometry?.attributes?.position;
  if (!position) throw usage('parametrizeGeometry takes a BufferGeometry with positions');
  const positions = new Float32Array(3 * position.count);
  for (let v = 0; v < position.count; v++) {
    positions[3 * v] = position.getX(v);
    positions[3 * v + 1] = position.getY(v);
    positions[3 * v + 2] = position.getZ(v);
  }
  return positions;
}

function trianglesOf(geometry) {
  const { index } = geometry;
  const count = index ? index.count : geometry.attributes.position.count;
  if (count === 0 || count % 3 !== 0) {
    throw usage(`parametrizeGeometry takes triangles; there are ${count} corners`);
  }
  return Uint32Array.from({ length: count }, (_, i) => (index ? index.getX(i) : i));
}

/** The attribute with one entry per new vertex, in its original type. */
function splitAttribute(attribute, vertexOf) {
  const { itemSize, normalized } = attribute;
  const Type = (attribute.data?.array ?? attribute.array).constructor;
  const array = new Type(vertexOf.length * itemSize);
  const from = attribute.isInterleavedBufferAttribute ? attribute.data.array : attribute.array;
  const stride = attribute.isInterleavedBufferAttribute ? attribute.data.stride : itemSize;
  const offset = attribute.isInterleavedBufferAttribute ? attribute.offset : 0;
  vertexOf.forEach((v, i) => {
    for (let k = 0; k < itemSize; k++) array[i * itemSize + k] = from[v * stride + offset + k];
  });
  const split = new BufferAttribute(array, itemSize, normalized);
  split.name = attribute.name;
  if (attribute.gpuType !== undefined) split.gpuType = attribute.gpuType;
  return split;
}

/** A copy of the geometry with vertices duplicated along the seams and with the new attribute. */
function cutGeometry(geometry, { index, vertexOf, uvOf }, uv, attribute) {
  const cut = new BufferGeometry();
  cut.name = geometry.name;
  cut.userData = structuredClone(geometry.userData);
  for (const [name, old] of Object.entries(geometry.attributes)) {
    if (name !== attribute) cut.setAttribute(name, splitAttribute(old, vertexOf));
  }
  for (const [name, targets] of Object.entries(geometry.morphAttributes)) {
    cut.morphAttributes[name] = targets.map((old) => splitAttribute(old, vertexOf));
  }
  cut.morphTargetsRelative = geometry.morphTargetsRelative;
  const coordinates = new Float32Array(2 * uvOf.length);
  uvOf.forEach((i, v) => {
    if (i >= 0) coordinates.set([uv[2 * i], uv[2 * i + 1]], 2 * v);
  });
  cut.setAttribute(attribute, new BufferAttribute(coordinates, 2));
  const Index = vertexOf.length > 0xffff ? Uint32Array : Uint16Array;
  cut.setIndex(new BufferAttribute(Index.from(index), 1));
  for (const { start, count, materialIndex } of geometry.groups) {
    cut.addGroup(start, count, materialIndex);
  }
  cut.setDrawRange(geometry.drawRange.start, geometry.drawRange.count);
  return cut;
}

/** The seams on the surface, one segment per edge. */
function seamLines({ seams, uvToVertex, positions }) {
  const points = new Float32Array(6 * seams.length);
  seams.forEach(({ a }, i) => {
    a.forEach((end, k) => {
      const v = uvToVertex[end];
      points.set(positions.subarray(3 * v, 3 * v + 3), 6 * i + 3 * k);
    });
  });
  const lines = new BufferGeometry();
  lines.setAttribute('position', new BufferAttribute(points, 3));
  return new LineSegments(lines);
}

export async function parametrizeGeometry(client, geometry, options = {}, call) {
  const { attribute = 'uv', weld, fix, limits, ...solve } = options;
  const positions = positionsOf(geometry);
  const triangles = trianglesOf(geometry);
  // As a GLB, so that vertices at equal positions are joined and the map is verified in float32, in which it is drawn.
  const glb = toGlb(positions, triangles);
  await client.load(glb, { name: 'geometry.glb', weld, fix, limits }, call);
  const result = await client.parametrize(solve, call);
  const split = splitAlongSeams(triangles, result.cornerToUv, positions.length / 3);
  return {
    geometry: cutGeometry(geometry, split, result.uv, attribute),
    seams: seamLines(result),
    certificate: result.certificate,
    result,
  };
}
