// From arrays to what WebGL draws: one vertex per triangle corner, so that texture coordinates and
// overlays may differ on the two sides of an edge.

import { BufferAttribute, BufferGeometry, Sphere, Vector3 } from 'three';
import type { Overlay } from '../state/app';
import { boxOf, quantile } from '../state/measure';
import type { Solved } from '../state/solved';
import { spread } from '../state/spread';
import type { Surface } from '../state/surface';

/** `same` is a geometry of the same surface, whose places are taken over. */
export function cornerGeometry(
  surface: Surface,
  solved?: Solved,
  same?: BufferGeometry,
): BufferGeometry {
  const count = surface.triangles.length;
  const geometry = new BufferGeometry();
  if (same) {
    geometry.setAttribute('position', same.getAttribute('position'));
    geometry.setAttribute('normal', same.getAttribute('normal'));
  } else setPlaces(geometry, surface);
  geometry.boundingSphere = new Sphere(new Vector3(...surface.center), surface.radius);
  const uv = solved?.corners.uv ?? new Float32Array(2 * count);
  geometry.setAttribute('uv', new BufferAttribute(uv, 2));
  geometry.setAttribute('tint', new BufferAttribute(new Uint8Array(4 * count), 4, true));
  return geometry;
}

function setPlaces(geometry: BufferGeometry, { triangles, positions, normals }: Surface): void {
  const position = new Float32Array(3 * triangles.length);
  const normal = new Float32Array(3 * triangles.length);
  for (let c = 0; c < triangles.length; c++) {
    const v = 3 * triangles[c];
    for (let i = 0; i < 3; i++) {
      position[3 * c + i] = positions[v + i];
      normal[3 * c + i] = normals[v + i];
    }
  }
  geometry.setAttribute('position', new BufferAttribute(position, 3));
  geometry.setAttribute('normal', new BufferAttribute(normal, 3));
}

/** The map laid flat. */
export function flatGeometry(solved: Solved): BufferGeometry {
  const { uv } = solved.corners;
  const count = uv.length / 2;
  const position = new Float32Array(3 * count);
  const normal = new Float32Array(3 * count);
  for (let c = 0; c < count; c++) {
    position[3 * c] = uv[2 * c];
    position[3 * c + 1] = uv[2 * c + 1];
    normal[3 * c + 2] = 1;
  }
  const geometry = new BufferGeometry();
  const { x, y, width, height } = boxOf(uv);
  const center = new Vector3(x + width / 2, y + height / 2, 0);
  geometry.boundingSphere = new Sphere(center, Math.hypot(width, height) / 2);
  geometry.setAttribute('position', new BufferAttribute(position, 3));
  geometry.setAttribute('normal', new BufferAttribute(normal, 3));
  geometry.setAttribute('uv', new BufferAttribute(uv, 2));
  geometry.setAttribute('tint', new BufferAttribute(new Uint8Array(4 * count), 4, true));
  return geometry;
}

type Rgb = [number, number, number];

// Cividis-like and vermilion–blue ramps: both are told apart without red and green.
const sequential: Rgb[] = [
  [0, 34, 78],
  [66, 78, 108],
  [125, 124, 120],
  [187, 175, 113],
  [254, 232, 56],
];
const diverging: Rgb[] = [
  [33, 102, 172],
  [146, 197, 222],
  [247, 247, 247],
  [244, 165, 130],
  [178, 24, 43],
];

function ramp(colours: Rgb[], x: number): Rgb {
  const at = Math.min(Math.max(x, 0), 1) * (colours.length - 1);
  const i = Math.min(Math.floor(at), colours.length - 2);
  const mix = (k: number): number =>
    Math.round(colours[i][k] + (at - i) * (colours[i + 1][k] - colours[i][k]));
  return [mix(0), mix(1), mix(2)];
}

export interface Legend {
  title: string;
  low: string;
  middle: string;
  high: string;
  kind: 'sequential' | 'diverging';
}

/** What the colours of an overlay mean, in numbers; values beyond the last percent are clamped. */
export function legendOf(solved: Solved, overlay: Overlay): Legend | undefined {
  if (overlay === 'angle') {
    const most = Math.max(quantile(solved.distortion.conformal, 0.99), 1.001);
    const [middle, high] = [(1 + most) / 2, most].map((x) => x.toFixed(2));
    return { title: 'Stretch σ₁/σ₂', low: '1', middle, high: `≥ ${high}`, kind: 'sequential' };
  }
  if (overlay === 'seams') {
    const high = seamLimit(solved);
    const [middle, end] = [high / 2, high].map((x) => x.toPrecision(2));
    return { title: 'Distance to a seam', low: '0', middle, high: `≥ ${end}`, kind: 'sequential' };
  }
  if (overlay !== 'area') return undefined;
  const high = areaLimit(solved);
  const factor = (2 ** high).toPrecision(2);
  return { title: 'Area', low: `÷ ${factor}`, middle: '1', high: `× ${factor}`, kind: 'diverging' };
}

/** Without seams there is no distance to one. */
function seamLimit({ seamDistance }: Solved): number {
  const most = quantile(seamDistance, 0.99);
  return Number.isFinite(most) && most > 0 ? most : 1;
}

function areaLimit({ distortion }: Solved): number {
  return Math.max(quantile(distortion.areaSize, 0.99), 0.01);
}

/** Colour per corner: the overlay, and red where a triangle is folded over. */
export function paint(
  geometry: BufferGeometry,
  solved: Solved | undefined,
  overlay: Overlay,
): void {
  const tint = geometry.getAttribute('tint') as BufferAttribute;
  const out = tint.array as Uint8Array;
  out.fill(0);
  tint.needsUpdate = true;
  if (!solved) return;
  const { conformal, area, flipped } = solved.distortion;
  const set = (t: number, [r, g, b]: Rgb, alpha: number): void => {
    for (let k = 0; k < 3; k++) out.set([r, g, b, alpha], 12 * t + 4 * k);
  };
  if (overlay === 'angle') {
    const most = Math.max(quantile(conformal, 0.99), 1.001);
    conformal.forEach((x, t) => set(t, ramp(sequential, (x - 1) / (most - 1)), 225));
  } else if (overlay === 'area') {
    const most = areaLimit(solved);
    area.forEach((x, t) => set(t, ramp(diverging, 0.5 + x / (2 * most)), 225));
  } else if (overlay === 'seams') {
    const most = seamLimit(solved);
    solved.result.triangles.forEach((v, c) => {
      const d = solved.seamDistance[v] / most;
      out.set([...ramp(sequential, Number.isFinite(d) ? d : 1), 225], 4 * c);
    });
  } else if (overlay === 'flips') {
    for (let t = 0; t < area.length; t++) set(t, [205, 212, 220], 225);
  }
  for (const t of flipped) set(t, [214, 39, 40], 255);
}

/** Crosses whose arms follow u and v: they look the same whatever lines do across a seam. */
export function crosses(
  surface: Surface,
  solved: Solved,
  spacing: number,
  q: number,
  isFlat: boolean,
): Float32Array {
  const { positions: p, triangles } = surface;
  const { uv } = solved.corners;
  const { uvArea, surfaceArea } = solved.distortion;
  const arm = 0.42 * spacing * Math.sqrt(uvArea / surfaceArea); // in uv
  const out: number[] = [];
  for (const { triangle: t, s, r, e, f } of spread(surface, spacing)) {
    const [ux, uy] = [uv[6 * t + 2] - uv[6 * t], uv[6 * t + 3] - uv[6 * t + 1]];
    const [vx, vy] = [uv[6 * t + 4] - uv[6 * t], uv[6 * t + 5] - uv[6 * t + 1]];
    const det = ux * vy - uy * vx;
    for (let k = 0; k < q; k++) {
      const turn = (2 * Math.PI * k) / q;
      const [x, y] = [arm * Math.cos(turn), arm * Math.sin(turn)];
      if (isFlat) {
        const [cx, cy] = [uv[6 * t] + s * ux + r * vx, uv[6 * t + 1] + s * uy + r * vy];
        out.push(cx, cy, 0.002, cx + x, cy + y, 0.002);
        continue;
      }
      let [ds, dr] = [(x * vy - y * vx) / det, (ux * y - uy * x) / det];
      // Where the map is nearly flat the arm would leave the picture, and hide it.
      const far = Math.hypot(...e.map((_, m) => ds * e[m] + dr * f[m]));
      const part = Math.min(1, spacing / far);
      [ds, dr] = [part * ds, part * dr];
      const a = 3 * triangles[3 * t];
      for (const [i, j] of [
        [s, r],
        [s + ds, r + dr],
      ]) {
        for (let m = 0; m < 3; m++) out.push(p[a + m] + i * e[m] + j * f[m]);
      }
    }
  }
  return new Float32Array(out);
}
