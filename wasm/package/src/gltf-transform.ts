// hgp/gltf-transform: seamless texture coordinates as a transform of a document. Requires
// @gltf-transform/core.

import type { Accessor, Document, Mesh, Primitive, Transform } from '@gltf-transform/core';
import type { Client } from './lib/client.js';
import { HgpError, usage } from './lib/error.js';
import type { LoadOptions, SolveOptions } from './lib/options.js';
import type { Result } from './lib/results.js';
import { splitAlongSeams } from './lib/split.js';

export interface SeamlessOptions extends SolveOptions {
  /** The client that solves. */
  client: Client;
  /** The set to write, replaced if it exists; by default the first free one of each mesh. */
  texcoord?: number;
  /** Also write maps that are not certified; by default the transform fails with `no-map`. */
  allowUncertified?: boolean;
  /** Called for every mesh that was solved. */
  onMesh?: (mesh: Mesh, result: Result) => void;
  weld?: number;
  fix?: LoadOptions['fix'];
  limits?: LoadOptions['limits'];
}

const trianglesMode = 4;

type Numbers = Float32Array | Uint32Array | Uint16Array | Uint8Array | Int16Array | Int8Array;

interface Part {
  primitive: Primitive;
  position: Accessor;
  triangles: Uint32Array;
  firstCorner: number;
}

/** The triangles of a mesh, primitive by primitive, with vertices numbered consecutively over all primitives. */
function gather(mesh: Mesh): { parts: Part[]; positions: number[]; triangles: number[] } {
  const parts: Part[] = [];
  const positions: number[] = [];
  const triangles: number[] = [];
  for (const primitive of mesh.listPrimitives()) {
    const position = primitive.getAttribute('POSITION');
    if (primitive.getMode() !== trianglesMode || !position) continue;
    const first = positions.length / 3;
    const element: number[] = [];
    for (let v = 0; v < position.getCount(); v++)
      positions.push(...position.getElement(v, element));
    const indices = primitive.getIndices();
    const count = (indices ?? position).getCount();
    const own = Uint32Array.from({ length: count - (count % 3) }, (_, i) =>
      indices ? indices.getScalar(i) : i,
    );
    parts.push({ primitive, position, triangles: own, firstCorner: triangles.length });
    for (const v of own) triangles.push(first + v);
  }
  return { parts, positions, triangles };
}

/** A copy of an accessor with one element per new vertex. */
function splitAccessor(document: Document, accessor: Accessor, vertexOf: number[]): Accessor {
  const size = accessor.getElementSize();
  const from = accessor.getArray() as Numbers; // it has one, as it has elements
  const Type = from.constructor as new (length: number) => Numbers;
  const array = new Type(vertexOf.length * size);
  vertexOf.forEach((v, i) => array.set(from.subarray(v * size, v * size + size), i * size));
  return document
    .createAccessor(accessor.getName())
    .setType(accessor.getType())
    .setNormalized(accessor.getNormalized())
    .setBuffer(accessor.getBuffer())
    .setArray(array);
}

function writePrimitive(
  document: Document,
  { primitive, position, triangles, firstCorner }: Part,
  { uv, cornerToUv }: Result,
  name: string,
): void {
  const count = position.getCount();
  const corners = cornerToUv.subarray(firstCorner, firstCorner + triangles.length);
  const { index, vertexOf, uvOf } = splitAlongSeams(triangles, corners, count);
  const buffer = position.getBuffer();
  if (vertexOf.length > count) {
    for (const owner of [primitive, ...primitive.listTargets()]) {
      for (const semantic of owner.listSemantics()) {
        const accessor = owner.getAttribute(semantic);
        if (semantic !== name && accessor) {
          owner.setAttribute(semantic, splitAccessor(document, accessor, vertexOf));
        }
      }
    }
  }
  const coordinates = new Float32Array(2 * vertexOf.length);
  uvOf.forEach((i, v) => {
    if (i >= 0) coordinates.set([uv[2 * i], 1 - uv[2 * i + 1]], 2 * v); // glTF's v points down
  });
  primitive.setAttribute(
    name,
    document.createAccessor().setType('VEC2').setBuffer(buffer).setArray(coordinates),
  );
  const Index = vertexOf.length > 0xffff ? Uint32Array : Uint16Array;
  const indices = document.createAccessor().setType('SCALAR').setBuffer(buffer);
  primitive.setIndices(indices.setArray(Index.from(index)));
}

/** The set to write: the requested one, or the first that no primitive of the mesh has. */
function nameOfSet(mesh: Mesh, texcoord: number | undefined): string {
  if (texcoord !== undefined) return `TEXCOORD_${texcoord}`;
  const isTaken = (name: string): boolean =>
    mesh.listPrimitives().some((one) => one.getAttribute(name));
  let set = 0;
  while (isTaken(`TEXCOORD_${set}`)) set++;
  return `TEXCOORD_${set}`;
}

/**
 * `await document.transform(seamless({ client, q: 4 }))`: every mesh gets another set of texture
 * coordinates (TEXCOORD_n). The primitives of a mesh form one surface; points and lines are not changed.
 * Vertices are duplicated along seams; attributes, morph targets and skins are kept.
 */
export function seamless(options: SeamlessOptions): Transform {
  const { client, texcoord, allowUncertified, onMesh, weld, fix, limits, ...solve } =
    (options as SeamlessOptions | undefined) ?? ({} as Partial<SeamlessOptions> as SeamlessOptions);
  if (typeof (client as Partial<Client> | undefined)?.parametrizeRendered !== 'function') {
    throw usage('seamless({ client }) needs the client that createClient() made');
  }
  const transform: (document: Document) => unknown = async (document) => {
    for (const mesh of document.getRoot().listMeshes()) {
      const { parts, positions, triangles } = gather(mesh);
      if (triangles.length === 0) continue;
      const arrays = { positions, triangles };
      const result = await client.parametrizeRendered(arrays, { weld, fix, limits }, solve);
      onMesh?.(mesh, result);
      if (!result.certificate.certified && !allowUncertified) {
        const message = `The map of mesh '${mesh.getName()}' is not certified (allowUncertified writes it all the same).`;
        throw new HgpError({ code: 'no-map', message });
      }
      const name = nameOfSet(mesh, texcoord);
      for (const part of parts) writePrimitive(document, part, result, name);
    }
  };
  // The name that glTF-Transform uses in its log.
  Object.defineProperty(transform, 'name', { value: 'seamless' });
  return transform;
}
