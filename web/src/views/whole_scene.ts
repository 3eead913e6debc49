// The meshes of a file beside the open one, and its own further instances: quiet, with their maps where they have
// them, and chosen by a click.

import {
  BufferAttribute,
  BufferGeometry,
  Group,
  type Matrix3,
  Matrix4,
  Mesh,
  type Ray,
  type ShaderMaterial,
  Sphere,
  Vector3,
} from 'three';
import type { MeshBVH } from 'three-mesh-bvh';
import type { ScenePart } from '../model/scene';
import type { Pattern } from '../model/types';
import { ballAround } from './ball';
import type { Shape } from './camera';
import { bvhFrom } from './corner_geometry';
import type { OwnInstance } from './gltf_scene';
import { setPalette, setPattern, surfaceMaterial, type Palette } from './pattern_material';

/** The map of a part: two numbers per corner, and how the pattern lies on it. */
export interface PartMap {
  cornerUv: Float32Array;
  pattern: Pattern;
  q: number;
  /** Tiles per unit of uv. */
  scale: number;
  isAligned: boolean;
  isCertified: boolean;
}

export interface SceneContent {
  parts: readonly ScenePart[];
  /** The mesh that is open: its first instance is drawn by the view itself. */
  open: number;
  maps: ReadonlyMap<number, PartMap>;
  /** Whether meshes without a map are shown with their own materials. */
  isOwnShown: boolean;
  palette: Palette;
}

interface Part {
  mesh: number;
  isPlaced: boolean;
  geometry: BufferGeometry;
  tree: MeshBVH;
  material: ShaderMaterial;
  instances: Mesh[];
}

const quiet = { withMap: 0.3, certified: 0.12, plain: 0.62, pointedAt: 0.08 };
/** Of that, with materials of the file: a scene shall be seen as it is, with a hint of what is not open. */
const quietWithOwn = 0.75;
const maxPoints = 4000; // of each part that framing looks at

export class WholeScene extends Group {
  readonly #toStudio: Matrix3;
  #of?: readonly ScenePart[];
  #parts: Part[] = [];
  #content?: SceneContent;
  #pointedAt = -1;
  #own?: ReadonlyMap<number, readonly OwnInstance[]>;

  constructor(toStudio: Matrix3) {
    super();
    this.#toStudio = toStudio;
  }

  show(content: SceneContent): void {
    this.#content = content;
    if (content.parts !== this.#of) this.#take(content.parts);
    for (const part of this.#parts) this.#dress(part, content);
    this.#choose();
  }

  #take(parts: readonly ScenePart[]): void {
    this.clear();
    for (const { geometry, material } of this.#parts) {
      geometry.dispose();
      material.dispose();
    }
    this.#of = parts;
    this.#pointedAt = -1;
    this.#parts = parts.map(({ mesh, isPlaced, tree, matrices, ...shape }) => {
      const geometry = new BufferGeometry();
      geometry.setAttribute('position', new BufferAttribute(shape.cornerPositions, 3));
      geometry.setAttribute('normal', new BufferAttribute(shape.cornerNormals, 4, true));
      geometry.boundingSphere = ballAround(geometry.getAttribute('position'));
      const material = surfaceMaterial(true, this.#toStudio);
      const instances = matrices.map((matrix, instance) => {
        const one = new Mesh(geometry, material);
        one.matrixAutoUpdate = false;
        one.matrix.fromArray(matrix);
        one.frustumCulled = false;
        one.userData = { mesh, instance };
        return one;
      });
      for (const one of instances) this.add(one);
      return { mesh, isPlaced, geometry, tree: bvhFrom(tree, geometry), material, instances };
    });
    this.updateMatrixWorld(true);
  }

  #dress({ mesh, geometry, material }: Part, { maps, palette }: SceneContent): void {
    const map = maps.get(mesh);
    const corners = geometry.getAttribute('position').count;
    const isFitting = map !== undefined && map.cornerUv.length === 2 * corners;
    if (map && isFitting) {
      const before = geometry.getAttribute('uv') as BufferAttribute | undefined;
      if (before?.array !== map.cornerUv)
        geometry.setAttribute('uv', new BufferAttribute(map.cornerUv, 2));
      setPattern(material, map.pattern, map);
    } else setPattern(material, 'plain', { q: 4, scale: 1, isAligned: false });
    setPalette(material, palette);
    material.uniforms.dim.value = this.#dimOf(mesh);
  }

  #dimOf(mesh: number): number {
    const map = this.#content?.maps.get(mesh);
    if (mesh === this.#pointedAt) return quiet.pointedAt;
    if (!map) return mesh === this.#content?.open ? quiet.withMap : quiet.plain;
    return map.isCertified ? quiet.certified : quiet.withMap;
  }

  /** The materials of the file, of each mesh one object per instance. */
  setOwn(own: ReadonlyMap<number, readonly OwnInstance[]> | undefined): void {
    this.#own = own;
    this.#choose();
  }

  /** What is visible: not the instance that the view draws, and of the others materials or pattern. */
  #choose(): void {
    const { open = -1, maps, isOwnShown = false, palette } = this.#content ?? {};
    for (const { mesh, isPlaced, instances } of this.#parts) {
      const own = this.#own?.get(mesh) ?? [];
      instances.forEach((one, i) => {
        const isOpen = mesh === open && i === 0;
        const hasOwn = own[i] !== undefined && (isOwnShown || !maps?.has(mesh));
        one.visible = isPlaced && !isOpen && !hasOwn;
        if (!own[i]) return;
        if (!isOpen) own[i].visible = isPlaced && hasOwn;
        own[i].quiet.value = isOpen ? 0 : quietWithOwn * this.#dimOf(mesh);
        if (palette) own[i].paper.value = palette.paper;
      });
    }
  }

  /** Shows that a click would choose a mesh; −1: none. Returns whether that is new. */
  pointAt(mesh: number): boolean {
    if (mesh === this.#pointedAt) return false;
    this.#pointedAt = mesh;
    for (const part of this.#parts) part.material.uniforms.dim.value = this.#dimOf(part.mesh);
    this.#choose();
    return true;
  }

  /** The nearest part on a ray nearer than `within`, other than what the view draws itself. */
  pick(ray: Ray, within: number): number {
    const { open } = this.#content ?? {};
    let [found, nearest] = [-1, within];
    for (const { mesh, isPlaced, tree, instances } of this.#parts) {
      if (!isPlaced) continue;
      instances.forEach(({ matrix }, i) => {
        if (mesh === open && i === 0) return;
        const back = matrix.clone().invert();
        const hit = tree.raycastFirst(ray.clone().applyMatrix4(back), 2);
        const far = hit?.point.applyMatrix4(matrix).distanceTo(ray.origin) ?? Infinity;
        if (far < nearest) [found, nearest] = [mesh, far];
      });
    }
    return found;
  }
}

/** Points of the whole scene, three numbers each, for framing; empty if nothing is placed. */
function pointsOf(parts: readonly ScenePart[]): Float64Array {
  const found: number[] = [];
  const point = new Vector3();
  for (const { isPlaced, cornerPositions: p, matrices } of parts) {
    if (!isPlaced) continue;
    const step = 3 * Math.max(1, Math.ceil((p.length / 3 / maxPoints) * matrices.length));
    for (const one of matrices) {
      const matrix = new Matrix4().fromArray(one);
      for (let i = 0; i < p.length; i += step) {
        point.set(p[i], p[i + 1], p[i + 2]).applyMatrix4(matrix);
        if (Number.isFinite(point.x + point.y + point.z)) found.push(point.x, point.y, point.z);
      }
    }
  }
  return Float64Array.from(found);
}

/** All parts as what a camera frames; undefined if there are none. */
export function shapeOf(parts: readonly ScenePart[]): Shape | undefined {
  const places = pointsOf(parts);
  if (places.length === 0) return undefined;
  const { center, radius } = new Sphere().setFromPoints(
    Array.from({ length: places.length / 3 }, (_, i) => new Vector3().fromArray(places, 3 * i)),
  );
  return { center, radius, places };
}
