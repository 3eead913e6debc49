// Line segments with a width in pixels: seams, crosses, highlights, wireframe.

import type { Color, Vector3 } from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import type { Solved } from '../state/solved';
import type { Surface } from '../state/surface';
import { chainColour } from './ticks';

export class Lines extends LineSegments2 {
  constructor(width: number, options: { depth?: boolean; order?: number; bias?: number } = {}) {
    const material = new LineMaterial({ linewidth: width, alphaToCoverage: false });
    material.depthTest = options.depth ?? true;
    material.depthWrite = false;
    if (options.bias) {
      material.polygonOffset = true;
      material.polygonOffsetFactor = -options.bias;
      material.polygonOffsetUnits = -options.bias;
    }
    super(new LineSegmentsGeometry(), material);
    this.renderOrder = options.order ?? 2;
    this.frustumCulled = false;
    this.visible = false;
  }

  /** A little nearer to the eye, which leaves it where it is in the picture: seen from either side. */
  lift(eye: Vector3, by: number): void {
    this.scale.setScalar(1 - by);
    this.position.copy(eye).multiplyScalar(by);
  }

  /** Pairs of points; one colour for all, or one per segment. */
  set(points: Float32Array | number[], colours: Color | Color[]): void {
    this.geometry.dispose();
    this.visible = points.length > 0;
    if (!this.visible) return;
    const geometry = new LineSegmentsGeometry();
    geometry.setPositions(points as Float32Array);
    if (Array.isArray(colours)) {
      geometry.setColors(colours.flatMap(({ r, g, b }) => [r, g, b, r, g, b]));
      this.material.vertexColors = true;
      this.material.color.set(0xffffff);
    } else {
      this.material.vertexColors = false;
      this.material.color.copy(colours);
    }
    this.material.needsUpdate = true;
    this.geometry = geometry;
  }
}

/** Seams on the surface: one segment per seam edge. */
export function seamsOnSurface(surface: Surface, { seams, chains, result }: Solved) {
  const points = new Float32Array(6 * seams.length);
  seams.forEach(({ a }, s) => {
    a.forEach((end, k) => {
      const v = 3 * result.uvToVertex[end];
      for (let i = 0; i < 3; i++) points[6 * s + 3 * k + i] = surface.positions[v + i];
    });
  });
  return { points, colours: seams.map((_, s) => chainColour(chains[s])) };
}

/** Both sides of every seam edge, the twins in one colour. */
export function seamsInMap({ seams, chains, result: { uv } }: Solved) {
  const points: number[] = [];
  const colours: Color[] = [];
  seams.forEach(({ a, b }, s) => {
    for (const [i, j] of [a, b]) {
      points.push(uv[2 * i], uv[2 * i + 1], 0.001, uv[2 * j], uv[2 * j + 1], 0.001);
      colours.push(chainColour(chains[s]));
    }
  });
  return { points: new Float32Array(points), colours };
}

export function edgesOfCorners(position: ArrayLike<number>): Float32Array {
  const corners = position.length / 3;
  const out = new Float32Array(6 * corners);
  for (let c = 0; c < corners; c++) {
    const d = c % 3 === 2 ? c - 2 : c + 1;
    for (let i = 0; i < 3; i++) {
      out[6 * c + i] = position[3 * c + i];
      out[6 * c + 3 + i] = position[3 * d + i];
    }
  }
  return out;
}
