// A thumbnail of a mesh, rendered in software: triangles with a depth buffer, lit from the viewer, and
// a checkerboard if there is a map. The camera is the initial one of the 3D view.

export const thumbnailSize = 48;

export interface ThumbnailSource {
  /** Three numbers for each triangle corner. */
  cornerPositions: ArrayLike<number>;
  /** Two numbers for each corner, if there is a map, and its tiles per unit of uv. */
  cornerUv?: ArrayLike<number>;
  tiles?: number;
}

type Vector = [number, number, number];

const cross = (a: Vector, b: Vector): Vector => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
const unit = (a: Vector): Vector => {
  const length = Math.hypot(...a) || 1;
  return [a[0] / length, a[1] / length, a[2] / length];
};

const toEye = unit([0.5, 0.38, 0.78]);
const right = unit(cross([0, 1, 0], toEye));
const up = cross(toEye, right);

const clay: Vector = [158, 172, 188];
const light: Vector = [243, 182, 63];
const dark: Vector = [29, 63, 99];

/** Position in the picture and depth, three numbers for each corner. */
function project(p: ArrayLike<number>, size: number): Float32Array {
  const out = new Float32Array(p.length);
  const box = [Infinity, Infinity, -Infinity, -Infinity];
  for (let i = 0; i < p.length; i += 3) {
    const along = (axis: Vector): number =>
      axis[0] * p[i] + axis[1] * p[i + 1] + axis[2] * p[i + 2];
    const [x, y] = [along(right), -along(up)];
    out.set([x, y, along(toEye)], i);
    if (!Number.isFinite(x + y)) continue;
    box[0] = Math.min(box[0], x);
    box[1] = Math.min(box[1], y);
    box[2] = Math.max(box[2], x);
    box[3] = Math.max(box[3], y);
  }
  const scale = (0.92 * size) / (Math.max(box[2] - box[0], box[3] - box[1]) || 1);
  for (let i = 0; i < out.length; i += 3) {
    out[i] = 0.5 * size + scale * (out[i] - (box[0] + box[2]) / 2);
    out[i + 1] = 0.5 * size + scale * (out[i + 1] - (box[1] + box[3]) / 2);
    out[i + 2] *= scale;
  }
  return out;
}

function colourAt(
  { cornerUv, tiles = 1 }: ThumbnailSource,
  corner: number,
  weights: Vector,
): Vector {
  if (!cornerUv) return clay;
  const along = (k: number): number =>
    tiles * weights.reduce((sum, w, i) => sum + w * cornerUv[2 * (corner + i) + k], 0);
  return (Math.round(along(0)) + Math.round(along(1))) % 2 === 0 ? light : dark;
}

/** The picture as red, green, blue and opacity, row by row. */
export function drawThumbnail(
  source: ThumbnailSource,
  size = thumbnailSize,
): Uint8ClampedArray<ArrayBuffer> {
  const seen = project(source.cornerPositions, size);
  const picture = new Uint8ClampedArray(4 * size * size);
  const depth = new Float32Array(size * size).fill(-Infinity);
  for (let c = 0; c < seen.length / 3; c += 3) {
    const [ax, ay, az, bx, by, bz, cx, cy, cz] = seen.subarray(3 * c, 3 * c + 9);
    const area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
    if (!(Math.abs(area) > 1e-9)) continue;
    const normal = unit(cross([bx - ax, by - ay, bz - az], [cx - ax, cy - ay, cz - az]));
    const shade = 0.45 + 0.55 * Math.abs(normal[2]); // both sides are lit
    const [top, bottom] = [Math.min(ay, by, cy), Math.max(ay, by, cy)];
    const [left, end] = [Math.min(ax, bx, cx), Math.max(ax, bx, cx)];
    for (let y = Math.max(0, Math.ceil(top - 0.5)); y < size && y + 0.5 <= bottom; y++) {
      for (let x = Math.max(0, Math.ceil(left - 0.5)); x < size && x + 0.5 <= end; x++) {
        const [px, py] = [x + 0.5, y + 0.5];
        const wa = ((bx - px) * (cy - py) - (by - py) * (cx - px)) / area;
        const wb = ((cx - px) * (ay - py) - (cy - py) * (ax - px)) / area;
        const wc = 1 - wa - wb;
        const z = wa * az + wb * bz + wc * cz;
        const at = y * size + x;
        if (wa < 0 || wb < 0 || wc < 0 || z <= depth[at]) continue;
        depth[at] = z;
        const colour = colourAt(source, c, [wa, wb, wc]);
        picture.set([shade * colour[0], shade * colour[1], shade * colour[2], 255], 4 * at);
      }
    }
  }
  return picture;
}
