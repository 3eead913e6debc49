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
import { ConeMarkers } from './cone_markers';
import { Lines } from './lines';
import { setPalette, surfaceMaterial, type Palette } from './pattern_material';

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
    const faces = quads.length / 4;
    const normals = new Float64Array(p.length);
    const position = new Float32Array(18 * faces);
    const normal = new Float32Array(18 * faces);
    const tint = new Uint8Array(24 * faces);
    const bends = Array.from({ length: faces }, (_, f) => bendOf(shape, f));
    bends.forEach((bend, f) => {
      for (let k = 0; k < 4; k++)
        for (let i = 0; i < 3; i++) normals[3 * quads[4 * f + k] + i] += bend.normal[i];
    });
    let at = 0;
    bends.forEach(({ isFolded }, f) => {
      for (const k of [0, 1, 2, 0, 2, 3]) {
        const v = 3 * quads[4 * f + k];
        const length = Math.hypot(normals[v], normals[v + 1], normals[v + 2]) || 1;
        for (let i = 0; i < 3; i++) {
          position[3 * at + i] = p[v + i];
          normal[3 * at + i] = normals[v + i] / length;
        }
        if (isFolded) tint.set(folded, 4 * at);
        at += 1;
      }
    });
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
