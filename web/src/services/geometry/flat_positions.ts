/** Texture coordinates as positions in the plane, with three numbers each: trees for picking read no other arrays. */
export function flatPositions(uv: ArrayLike<number>): Float32Array {
  const out = new Float32Array((uv.length / 2) * 3);
  for (let c = 0; c < uv.length / 2; c++) {
    out[3 * c] = uv[2 * c];
    out[3 * c + 1] = uv[2 * c + 1];
  }
  return out;
}
