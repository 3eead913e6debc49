// Duplicates the vertices of a renderable mesh along the seams of its map: a vertex with several texture
// coordinates becomes several vertices; nothing else changes.

/**
 * @param triangles   3 vertices per triangle
 * @param cornerToUv  3 uv vertices per triangle
 * @return index: 3 new vertices per triangle, in the same order; vertexOf: new vertex → old vertex;
 *         uvOf: new vertex → uv vertex. Vertices without triangles are kept, with uvOf −1.
 */
export function splitAlongSeams(triangles, cornerToUv, vertexCount) {
  const vertexOf = Array.from({ length: vertexCount }, (_, v) => v);
  const uvOf = new Array(vertexCount).fill(-1);
  const next = new Array(vertexCount).fill(-1); // further copies of the same vertex
  const index = new Uint32Array(triangles.length);
  for (let corner = 0; corner < triangles.length; corner++) {
    const uv = cornerToUv[corner];
    let v = triangles[corner];
    while (uvOf[v] !== -1 && uvOf[v] !== uv) {
      if (next[v] === -1) {
        next[v] = vertexOf.length;
        vertexOf.push(triangles[corner]);
        uvOf.push(-1);
        next.push(-1);
      }
      v = next[v];
    }
    uvOf[v] = uv;
    index[corner] = v;
  }
  return { index, vertexOf, uvOf };
}
