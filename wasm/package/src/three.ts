// hgp/three: a BufferGeometry with seamless texture coordinates. Requires three.

import {
  BufferAttribute,
  BufferGeometry,
  LineSegments,
  type InterleavedBufferAttribute,
  type TypedArray,
} from 'three';
import type { CallOptions, Client } from './lib/client.js';
import type { Certificate } from './lib/documents.js';
import { usage } from './lib/error.js';
import type { Lite, LiteCallOptions, LiteResult, LiteSolveOptions } from './lib/lite.js';
import type { LoadOptions, SolveOptions } from './lib/options.js';
import type { Result } from './lib/results.js';
import { splitAlongSeams, type SplitMesh } from './lib/split.js';

export interface GeometryOptions extends SolveOptions {
  /** The attribute to write; by default `uv`. */
  attribute?: string;
  /** Join vertices closer than this; by default those at equal positions. */
  weld?: number;
  fix?: LoadOptions['fix'];
  limits?: LoadOptions['limits'];
}

export interface ParametrizedGeometry {
  /**
   * A copy in which vertices are duplicated along the seams. Triangles keep their order; groups, morph
   * targets, skin weights and all other attributes are kept. Always indexed.
   */
  geometry: BufferGeometry;
  /** The seams on the surface, in the default material. */
  seams: LineSegments;
  /** Certificate of the coordinates as stored in the attribute, in float32. */
  certificate: Certificate;
  result: Result;
}

/** The options of a geometry that hgp/lite maps. */
export interface LiteGeometryOptions extends LiteSolveOptions {
  attribute?: string;
}

export interface LiteParametrizedGeometry extends Pick<ParametrizedGeometry, 'geometry' | 'seams'> {
  certificate: LiteResult['certificate'];
  result: LiteResult;
}

type Attribute = BufferAttribute | InterleavedBufferAttribute;

/** Three numbers per vertex, converted from any storage (interleaved, normalized …). */
function positionsOf(geometry: BufferGeometry): Float32Array {
  const attributes = (geometry as Partial<BufferGeometry> | undefined)?.attributes;
  const position = attributes?.position;
  if (!position) throw usage('parametrizeGeometry takes a BufferGeometry with positions');
  return Float32Array.from({ length: 3 * position.count }, (_, i) =>
    position.getComponent(Math.floor(i / 3), i % 3),
  );
}

function trianglesOf({ index, attributes }: BufferGeometry): Uint32Array {
  const count = index ? index.count : attributes.position.count;
  if (count === 0 || count % 3 !== 0) {
    throw usage(`parametrizeGeometry takes triangles; there are ${count} corners`);
  }
  return Uint32Array.from({ length: count }, (_, i) => (index ? index.getX(i) : i));
}

const isInterleaved = (attribute: Attribute): attribute is InterleavedBufferAttribute =>
  'isInterleavedBufferAttribute' in attribute;

/** The attribute with one entry per new vertex, in its original type. */
function splitAttribute(attribute: Attribute, vertexOf: number[]): BufferAttribute {
  const { itemSize, normalized } = attribute;
  const [from, stride, offset] = isInterleaved(attribute)
    ? [attribute.data.array, attribute.data.stride, attribute.offset]
    : [attribute.array, itemSize, 0];
  const Type = from.constructor as new (length: number) => TypedArray;
  const array = new Type(vertexOf.length * itemSize);
  vertexOf.forEach((v, i) => {
    const at = v * stride + offset;
    array.set(from.subarray(at, at + itemSize), i * itemSize);
  });
  const split = new BufferAttribute(array, itemSize, normalized);
  split.name = attribute.name;
  if (!isInterleaved(attribute)) split.gpuType = attribute.gpuType;
  return split;
}

/** A copy of the geometry with vertices duplicated along the seams and with the new attribute. */
function cutGeometry(
  geometry: BufferGeometry,
  { index, vertexOf, uvOf }: SplitMesh,
  uv: Float64Array,
  attribute: string,
): BufferGeometry {
  const cut = new BufferGeometry();
  cut.name = geometry.name;
  cut.userData = structuredClone(geometry.userData);
  for (const [name, old] of Object.entries(geometry.attributes)) {
    if (name !== attribute) cut.setAttribute(name, splitAttribute(old, vertexOf));
  }
  const morphs: Record<string, BufferAttribute[]> = {};
  for (const [name, targets] of Object.entries(geometry.morphAttributes)) {
    morphs[name] = targets.map((old) => splitAttribute(old, vertexOf));
  }
  cut.morphAttributes = morphs;
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
function seamLines({ seams, uvToVertex, positions }: LiteResult | Result): LineSegments {
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

/**
 * Texture coordinates for a three.js geometry; v points up, as textures in three.js expect. Vertices at
 * equal positions are joined, because renderers split them where normals or old texture coordinates differ. To draw the
 * result, use `geometry` in a mesh. The geometry is copied when this is called; nothing stays in the client.
 */
export function parametrizeGeometry(
  client: Client,
  geometry: BufferGeometry,
  options?: GeometryOptions,
  call?: CallOptions,
): Promise<ParametrizedGeometry>;
/** The same with hgp/lite, in this thread. */
export function parametrizeGeometry(
  lite: Lite,
  geometry: BufferGeometry,
  options?: LiteGeometryOptions,
  call?: LiteCallOptions,
): Promise<LiteParametrizedGeometry>;
export async function parametrizeGeometry(
  client: Client | Lite,
  geometry: BufferGeometry,
  options: GeometryOptions = {},
  call?: CallOptions | LiteCallOptions,
): Promise<ParametrizedGeometry | LiteParametrizedGeometry> {
  const { attribute = 'uv', weld, fix, limits, ...solve } = options;
  const positions = positionsOf(geometry);
  const triangles = trianglesOf(geometry);
  const mesh = { positions, triangles };
  const result = await (client as Client).parametrizeRendered(
    mesh,
    { weld, fix, limits },
    solve,
    call,
  );
  const split = splitAlongSeams(triangles, result.cornerToUv, positions.length / 3);
  return {
    geometry: cutGeometry(geometry, split, result.uv, attribute),
    seams: seamLines(result),
    certificate: result.certificate,
    result,
  };
}
