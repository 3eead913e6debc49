// hgp/gltf-transform: seamless texture coordinates as a transform of a document.

import { HgpError, usage } from './lib/error.js';
import { toGlb } from './lib/glb.js';
import { splitAlongSeams } from './lib/split.js';

const trianglesMode = 4;

/** The triangles of a mesh, primitive by primitive, with vertices numbered consecutively over all primitives. */
function gather(mesh) {
  const parts = [];
  const positions = [];
  const triangles = [];
  for (const primitive of mesh.listPrimitives()) {
    const position = primitive.getAttribute('POSITION');
    if (primitive.getMode() !== trianglesMode || !position) continue;
    const first = positions.length / 3;
    const element = [];
    for (let v = 0; v < position.getCount(); v++)
      positions.push(...position.getElement(v, element));
    const indices = primitive.getIndices();
    const count = indices ? indices.getCount() : position.getCount();
    const own = Uint32Array.from({ length: count - (count % 3) }, (_, i) =>
      indices ? indices.getScalar(i) : i,
    );
    parts.push({ primitive, triangles: own, firstCorner: triangles.length });
    for (const v of own) triangles.push(first + v);
  }
  return { parts, positions, triangles };
}

/** A copy of an accessor with one element per new vertex. */
function splitAccessor(document, accessor, vertexOf) {
  const size = accessor.getElementSize();
  const from = accessor.getArray();
  const array = new from.constructor(vertexOf.length * size);
  vertexOf.forEach((v, i) => {
    for (let k = 0; k < size; k++) array[i * size + k] = from[v * size + k];
  });
  return document
    .createAccessor(accessor.getName())
    .setType(accessor.getType())
    .setNormalized(accessor.getNormalized())
    .setBuffer(accessor.getBuffer())
    .setArray(array);
}

function writePrimitive(document, { primitive, triangles, firstCorner }, { uv, cornerToUv }, name) {
  const count = primitive.getAttribute('POSITION').getCount();
  const corners = cornerToUv.subarray(firstCorner, firstCorner + triangles.length);
  const { index, vertexOf, uvOf } = splitAlongSeams(triangles, corners, count);
  const buffer = primitive.getAttribute('POSITION').getBuffer();
  if (vertexOf.length > count) {
    for (const owner of [primitive, ...primitive.listTargets()]) {
      for (const semantic of owner.listSemantics()) {
        const accessor = owner.getAttribute(semantic);
        if (semantic !== name) {
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
  const Index = vertexOf.length > 0xfffe ? Uint32Array : Uint16Array;
  const indices = document.createAccessor().setType('SCALAR').setBuffer(buffer);
  primitive.setIndices(indices.setArray(Index.from(index)));
}

/** The set to write: the requested one, or the first that no primitive of the mesh has. */
function nameOfSet(mesh, texcoord) {
  if (texcoord !== undefined) return `TEXCOORD_${texcoord}`;
  const isTaken = (name) => mesh.listPrimitives().some((one) => one.getAttribute(name));
  let set = 0;
  while (isTaken(`TEXCOORD_${set}`)) set++;
  return `TEXCOORD_${set}`;
}

export function seamless(options) {
  const {
    client,
    texcoord,
    allowUncertified = false,
    onMesh,
    weld,
    fix,
    limits,
    ...solve
  } = options ?? {};
  if (typeof client?.parametrize !== 'function') {
    throw usage('seamless({ client }) needs the client that createClient() made');
  }
  const transform = async (document) => {
    for (const mesh of document.getRoot().listMeshes()) {
      const { parts, positions, triangles } = gather(mesh);
      if (triangles.length === 0) continue;
      await client.load(toGlb(positions, triangles), { name: 'mesh.glb', weld, fix, limits });
      const result = await client.parametrize(solve);
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
