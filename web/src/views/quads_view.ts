// A quad mesh in place of the model: its faces, its edges, what is folded, and its irregular vertices, as markers of
// the number of their edges.

import {
  BufferAttribute,
  BufferGeometry,
  Group,
  type Matrix3,
  Mesh,
  type ShaderMaterial,
} from 'three';
import { bendOf, valencesOf, type QuadShape } from '../model/quad_shape';
import { creaseNormals } from '../services/geometry/crease_normals';
import { normalsOf } from '../services/geometry/placed_surface';
import { ConeMarkers } from './cone_markers';
import { Lines } from './lines';
import { setPalette, surfaceMaterial, type Palette } from './pattern_material';

/** The corners of the two triangles as which a quad is drawn. */
const halves = [0, 1, 2, 0, 2, 3];
const folded = [255, 45, 149, 255]; // as outlines

export class QuadsView extends Group {
  readonly #mesh: Mesh<BufferGeometry, ShaderMaterial>;
  readonly #edges = new Lines(1.5, { order: 1, bias: 1 });
  readonly #markers = new ConeMarkers(true);
  #shape?: QuadShape;

  constructor(toStudio: Matrix3) {
    super();
    this.#mesh = new Mesh(new BufferGeometry(), surfaceMaterial(true, toStudio));
    this.#mesh.frustumCulled = false;
    this.matrixAutoUpdate = false;
    this.add(this.#mesh, this.#edges, this.#markers);
    this.#markers.setStyle(0.7, 0.9);
    this.visible = false;
  }

  /** `matrix`: places it, by columns. */
  show(shape: QuadShape | undefined, matrix: readonly number[], palette: Palette): void {
    this.visible = shape !== undefined;
    if (!shape) {
      this.#mesh.geometry.dispose();
      this.#shape = undefined;
      return;
    }
    this.matrix.fromArray(matrix);
    this.updateMatrixWorld(true);
    setPalette(this.#mesh.material, palette);
    if (shape !== this.#shape) this.#take(shape);
    this.#edges.set(edgesOf(shape), palette.ink);
  }

  #take(shape: QuadShape): void {
    this.#shape = shape;
    const { positions: p, quads } = shape;
    const triangles = new Uint32Array((quads.length / 4) * 6);
    const tint = new Uint8Array(4 * triangles.length);
    for (let f = 0; f < quads.length / 4; f++) {
      halves.forEach((k, i) => (triangles[6 * f + i] = quads[4 * f + k]));
      if (bendOf(shape, f).isFolded) halves.forEach((_, i) => tint.set(folded, 4 * (6 * f + i)));
    }
    const position = Float32Array.from({ length: 3 * triangles.length }, (_, i) => p[3 * triangles[Math.floor(i / 3)] + (i % 3)]); // prettier-ignore
    const normal = normalsAtCorners(p, triangles);
    this.#mesh.geometry.dispose();
    this.#mesh.geometry = new BufferGeometry();
    this.#mesh.geometry.setAttribute('position', new BufferAttribute(position, 3));
    this.#mesh.geometry.setAttribute('normal', new BufferAttribute(normal, 3));
    this.#mesh.geometry.setAttribute('tint', new BufferAttribute(tint, 4, true));
    const plain = { q: 4, isSelected: false, isBad: false };
    this.#markers.show(
      valencesOf(shape).irregular.map(({ vertex: v, valence: k }) => ({
        at: [p[3 * v], p[3 * v + 1], p[3 * v + 2]],
        k,
        ...plain,
      })),
    );
  }
}

/** Smooth, but for creases. */
function normalsAtCorners(positions: Float64Array, triangles: Uint32Array): Float32Array {
  const normals = normalsOf({ positions, triangles });
  const creases = creaseNormals({ positions, triangles, normals });
  const out = new Float32Array(3 * triangles.length);
  triangles.forEach((v, c) => out.set(normals.subarray(3 * v, 3 * v + 3), 3 * c));
  creases.corners.forEach((c, i) => out.set(creases.normals.subarray(3 * i, 3 * i + 3), 3 * c));
  return out;
}

/** The sides of all quads, each once. */
function edgesOf({ positions: p, quads }: QuadShape): Float32Array {
  const n = p.length / 3;
  const seen = new Set<number>();
  const points: number[] = [];
  for (let c = 0; c < quads.length; c++) {
    const [v, w] = [quads[c], quads[c % 4 === 3 ? c - 3 : c + 1]];
    const key = Math.min(v, w) * n + Math.max(v, w);
    if (seen.has(key)) continue;
    seen.add(key);
    for (const one of [v, w]) points.push(p[3 * one], p[3 * one + 1], p[3 * one + 2]);
  }
  return Float32Array.from(points);
}
