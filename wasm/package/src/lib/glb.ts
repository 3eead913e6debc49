// Positions and triangles as a minimal GLB, so that maps for renderers are verified in float32, as
// glTF stores them.

const align = (bytes: number): number => Math.ceil(bytes / 4) * 4;

/**
 * @param positions  3 per vertex
 * @param triangles  3 vertices per triangle
 * @internal
 */
export function toGlb(positions: ArrayLike<number>, triangles: ArrayLike<number>): Uint8Array {
  const points = Float32Array.from(positions);
  const indices = Uint32Array.from(triangles);
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < points.length; i++) {
    low[i % 3] = Math.min(low[i % 3], points[i]);
    high[i % 3] = Math.max(high[i % 3], points[i]);
  }
  const json = JSON.stringify({
    asset: { version: '2.0' },
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
    accessors: [
      {
        bufferView: 0,
        componentType: 5126,
        count: points.length / 3,
        type: 'VEC3',
        min: low,
        max: high,
      },
      { bufferView: 1, componentType: 5125, count: indices.length, type: 'SCALAR' },
    ],
    bufferViews: [
      { buffer: 0, byteLength: points.byteLength },
      { buffer: 0, byteOffset: points.byteLength, byteLength: indices.byteLength },
    ],
    buffers: [{ byteLength: points.byteLength + indices.byteLength }],
  });
  const text = new TextEncoder().encode(json.padEnd(align(json.length)));
  const size = points.byteLength + indices.byteLength;
  const glb = new Uint8Array(12 + 8 + text.length + 8 + size);
  const view = new DataView(glb.buffer);
  const words = [0x46546c67, 2, glb.length, text.length, 0x4e4f534a];
  words.forEach((word, i) => view.setUint32(4 * i, word, true));
  glb.set(text, 20);
  view.setUint32(20 + text.length, size, true);
  view.setUint32(24 + text.length, 0x004e4942, true);
  glb.set(new Uint8Array(points.buffer), 28 + text.length);
  glb.set(new Uint8Array(indices.buffer), 28 + text.length + points.byteLength);
  return glb;
}
