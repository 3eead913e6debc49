// The colours of an overlay, per triangle corner; flipped triangles are red.

import type { Distortion } from '../../model/measures';
import type { Overlay } from '../../model/types';
import type { FaceValues } from './analyse';

type Rgb = readonly [number, number, number];

// Ramps similar to Cividis and from vermilion to blue, which people who confuse red and green can distinguish.
const sequential: readonly Rgb[] = [
  [0, 34, 78],
  [66, 78, 108],
  [125, 124, 120],
  [187, 175, 113],
  [254, 232, 56],
];
const diverging: readonly Rgb[] = [
  [33, 102, 172],
  [146, 197, 222],
  [247, 247, 247],
  [244, 165, 130],
  [178, 24, 43],
];
const grey: Rgb = [205, 212, 220];
const red: Rgb = [214, 39, 40];
const strength = 225;

const stops = 256;
const byteOf = (x: number): number => Math.min(stops - 1, Math.max(0, Math.round(x * (stops - 1))));

/** The ramp as a table of bytes, three per entry. */
function table(colours: readonly Rgb[]): Uint8Array {
  const out = new Uint8Array(3 * stops);
  for (let s = 0; s < stops; s++) {
    const at = (s / (stops - 1)) * (colours.length - 1);
    const i = Math.min(Math.floor(at), colours.length - 2);
    for (let k = 0; k < 3; k++) {
      out[3 * s + k] = Math.round(colours[i][k] + (at - i) * (colours[i + 1][k] - colours[i][k]));
    }
  }
  return out;
}
const sequentialTable = table(sequential);
const divergingTable = table(diverging);

/** The ends of the ramps: the outermost percent of values is clamped. */
export const stretchLimit = ({ stretch }: Pick<Distortion, 'stretch'>): number =>
  Math.max(stretch.p99, 1.001);
export const areaLimit = ({ areaSize }: Pick<Distortion, 'areaSize'>): number =>
  Math.max(areaSize.p99, 0.01);
/** The same for the distance to seams; 1 if there are none. */
export const seamLimit = ({ seamDistance }: Pick<Distortion, 'seamDistance'>): number =>
  Number.isFinite(seamDistance.p99) && seamDistance.p99 > 0 ? seamDistance.p99 : 1;

class Painter {
  readonly out: Uint8Array;
  constructor(corners: number) {
    this.out = new Uint8Array(4 * corners);
  }
  corner(c: number, colours: Uint8Array, x: number): void {
    const s = 3 * byteOf(x);
    for (let k = 0; k < 3; k++) this.out[4 * c + k] = colours[s + k];
    this.out[4 * c + 3] = strength;
  }
  face(t: number, colours: Uint8Array, x: number): void {
    for (let k = 0; k < 3; k++) this.corner(3 * t + k, colours, x);
  }
  plain(t: number, [r, g, b]: Rgb, alpha: number): void {
    for (let k = 0; k < 3; k++) this.out.set([r, g, b, alpha], 12 * t + 4 * k);
  }
}

export function overlayColours(
  overlay: Overlay,
  values: FaceValues,
  limits: Pick<Distortion, 'stretch' | 'areaSize' | 'seamDistance'>,
  triangles: Uint32Array,
): Uint8Array {
  const painter = new Painter(triangles.length);
  const count = triangles.length / 3;
  if (overlay === 'angle') {
    const max = stretchLimit(limits) - 1;
    for (let t = 0; t < count; t++) {
      painter.face(t, sequentialTable, (values.stretch[t] - 1) / max);
    }
  } else if (overlay === 'area') {
    const max = areaLimit(limits);
    for (let t = 0; t < count; t++) {
      painter.face(t, divergingTable, 0.5 + values.area[t] / (2 * max));
    }
  } else if (overlay === 'seams') {
    const max = seamLimit(limits);
    for (let c = 0; c < triangles.length; c++) {
      const d = values.seamDistance[triangles[c]] / max;
      painter.corner(c, sequentialTable, Number.isFinite(d) ? d : 1);
    }
  } else if (overlay === 'flips') {
    for (let t = 0; t < count; t++) painter.plain(t, grey, strength);
  }
  for (const t of values.flipped) painter.plain(t, red, 255);
  return painter.out;
}
