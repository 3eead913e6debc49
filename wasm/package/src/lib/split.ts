// Duplicates the vertices of a renderable mesh along the seams of its map: a vertex with several texture
// coordinates becomes several vertices; nothing else changes.

/** @internal */
export interface SplitMesh {
  /** 3 new vertices per triangle, in the same order. */
  index: Uint32Array;
  /** New vertex → old vertex. */
  vertexOf: number[];
  /** New vertex → uv vertex. Vertices without triangles are kept, with −1. */
  uvOf: number[];
}

/**
 * @param triangles   3 vertices per triangle
 * @param cornerToUv  3 uv vertices per triangle
 * @internal
 */
export function splitAlongSeams(
  triangles: Uint32Array,
  cornerToUv: Uint32Array,
  vertexCount: number,
): SplitMesh {
  const vertexOf = Array.from({ length: vertexCount }, (_, v) => v);
  const uvOf = new Array<number>(vertexCount).fill(-1);
  const next = new Array<number>(vertexCount).fill(-1); // further copies of the same vertex
  const index = new Uint32Array(triangles.length);
  triangles.forEach((vertex, corner) => {
    const uv = cornerToUv[corner];
    let v = vertex;
    while (uvOf[v] !== -1 && uvOf[v] !== uv) {
      if (next[v] === -1) {
        next[v] = vertexOf.length;
        vertexOf.push(vertex);
        uvOf.push(-1);
        next.push(-1);
      }
      v = next[v];
    }
    uvOf[v] = uv;
    index[corner] = v;
  });
  return { index, vertexOf, uvOf };
}
