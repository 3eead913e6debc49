// The 3D view: surface, pattern, overlay, seams, cones, cursor, highlight.

import {
  BufferGeometry,
  Color,
  type Group,
  Mesh,
  PerspectiveCamera,
  Raycaster,
  Vector2,
  Vector3,
} from 'three';
import { MeshBVH } from 'three-mesh-bvh';
import type { Look } from '../state/app';
import type { Prescription } from '../state/prescription';
import type { Solved } from '../state/solved';
import { spacingOf } from '../state/spread';
import type { Surface } from '../state/surface';
import { cornerGeometry, crosses, paint } from './geometry';
import { Lines, seamsOnSurface, Wire } from './lines';
import { chainColour, ticksOnSurface } from './ticks';
import { Markers } from './markers';
import { setImage, setPalette, setPattern, surfaceMaterial, type Palette } from './material';
import { Orbit } from './orbit';
import { Stage } from './stage';

export interface Hit {
  triangle: number;
  vertex: number;
  /** From the pointer to the vertex, in CSS pixels. */
  pixels: number;
}

const markerPixels = 30;

export class SurfaceView extends Stage {
  readonly camera = new PerspectiveCamera(32, 1, 0.01, 100);
  readonly orbit: Orbit;
  readonly #mesh = new Mesh(new BufferGeometry(), surfaceMaterial(true));
  readonly #markers = new Markers();
  readonly #seams = new Lines(3.5, { order: 3, bias: 2 });
  readonly #ticks = new Lines(2.5, { order: 3, bias: 2 });
  readonly #handles = new Lines(4, { order: 4, bias: 2 });
  readonly #crosses = new Lines(2, { order: 1, bias: 1 });
  readonly #wire = new Wire(1, true);
  readonly #light = new Lines(4.5, { order: 6, depth: false });
  readonly #cursor = new Lines(3, { order: 7, depth: false });
  #surface?: Surface;
  #solved?: Solved;
  #bvh?: MeshBVH;
  #crossKey = '';
  #palette?: Palette;
  #height = 1;
  #image?: ImageBitmap;
  #original?: Group;

  constructor(canvas: HTMLCanvasElement) {
    super(canvas);
    this.scene.add(this.#mesh, this.#wire, this.#crosses, this.#seams, this.#ticks);
    this.scene.add(this.#handles, this.#light, this.#cursor, this.#markers);
    this.#mesh.visible = false;
    this.#mesh.frustumCulled = false; // it is what the camera looks at
    this.beforeDraw(() => {
      const eye = this.camera.position;
      this.#markers.lift(eye, 0.04 * (this.#surface?.diagonal ?? 1));
      for (const lines of [this.#seams, this.#crosses, this.#wire, this.#ticks, this.#handles]) {
        lines.lift(eye, this.orbit.lift);
      }
    });
    this.orbit = new Orbit(this.camera, canvas, () => this.draw());
  }

  protected onResize(width: number, height: number): void {
    this.#height = height;
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.orbit.reshaped();
    this.#markers.resize(this.#markerSize());
  }

  #markerSize(): number {
    const half = Math.tan((Math.PI * this.camera.fov) / 360);
    return (2 * half * markerPixels) / this.#height;
  }

  /** Another surface frames it; another result keeps the camera. */
  setModel(surface: Surface | undefined, solved: Solved | undefined): void {
    if (surface === this.#surface && solved === this.#solved) return;
    const isNew = surface !== this.#surface;
    this.#surface = surface;
    this.#solved = solved;
    this.#crossKey = '';
    const before = this.#mesh.geometry;
    before.dispose();
    this.#mesh.visible = surface !== undefined;
    for (const lines of [this.#seams, this.#ticks, this.#crosses, this.#wire, this.#light]) {
      lines.visible = false;
    }
    if (isNew) this.#cursor.visible = this.#handles.visible = false;
    if (!surface) {
      this.#mesh.geometry = new BufferGeometry();
      this.#markers.show([], 0, true);
      return this.draw();
    }
    this.#mesh.geometry = cornerGeometry(surface, solved, isNew ? undefined : before);
    if (isNew) {
      this.#bvh = undefined;
      this.orbit.frame(new Vector3(...surface.center), surface.radius);
    }
    this.draw();
  }

  setLook(look: Look, q: number, isStale: boolean, palette: Palette): void {
    const material = this.#mesh.material;
    const pattern = this.#solved ? look.pattern : 'plain';
    setPattern(material, pattern, q);
    setPalette(material, palette);
    this.#palette = palette;
    material.uniforms.dim.value = isStale ? 0.65 : 0;
    if (look.image && look.image !== this.#image) setImage(material, (this.#image = look.image));
    if (this.#surface) {
      const { surfaceArea = 1, uvArea = 1 } = this.#solved?.distortion ?? {};
      const inUv = Math.sqrt(uvArea / surfaceArea) * this.#surface.diagonal;
      material.uniforms.scale.value = look.tiles / inUv;
      paint(this.#mesh.geometry, this.#solved, look.overlay);
      this.#setLines(look, q, pattern === 'cross');
    }
    this.draw();
  }

  #setLines(look: Look, q: number, hasCrosses: boolean): void {
    const surface = this.#surface!;
    const solved = this.#solved;
    const key = `${look.tiles} ${q} ${this.#palette!.ink.getHex()}`;
    if (hasCrosses && solved && key !== this.#crossKey) {
      const spacing = spacingOf(surface, look.tiles);
      this.#crosses.set(crosses(surface, solved, spacing, q, false), this.#palette!.ink);
      this.#crossKey = key;
    }
    this.#crosses.visible = hasCrosses && solved !== undefined && look.overlay !== 'flips';
    if (solved && look.hasSeams) {
      const { points, colours } = seamsOnSurface(surface, solved);
      this.#seams.set(points, colours);
      const ticks = ticksOnSurface(surface, solved);
      this.#ticks.set(ticks.points, ticks.colours);
    } else this.#seams.visible = this.#ticks.visible = false;
    if (look.hasWire) this.#wire.set(this.#mesh.geometry, this.#palette!.ink);
    else this.#wire.visible = false;
  }

  /** Loops around handles, each in the colour that the panel gives it. */
  setHandles(loops: Float32Array[]): void {
    const points: number[] = [];
    const colours: Color[] = [];
    loops.forEach((loop, i) => {
      points.push(...loop);
      for (let s = 0; s < loop.length; s += 6) colours.push(chainColour(i));
    });
    this.#handles.set(points, colours);
    this.draw();
  }

  /** The model with its own materials in place of the pattern; nothing to have the pattern back. */
  setOriginal(original: Group | undefined): void {
    if (original === this.#original) return;
    this.#original?.removeFromParent();
    this.#original = original;
    if (original) this.scene.add(original);
    this.canvas.dataset.original = original ? 'shown' : 'none';
    this.#mesh.visible = this.#surface !== undefined && original === undefined;
    this.draw();
  }

  setCones(asked: Prescription, bad: boolean[], selected: number): void {
    const surface = this.#surface;
    if (!surface) return;
    const markers = asked.cones.flatMap(({ vertex, k }, i) =>
      vertex < surface.vertexCount
        ? [{ at: this.point(vertex), k, q: asked.q, isSelected: i === selected, isBad: bad[i] }]
        : [],
    );
    this.#markers.show(markers, this.#markerSize(), true);
    this.draw();
  }

  point(vertex: number): Vector3 {
    return new Vector3().fromArray(this.#surface!.positions, 3 * vertex);
  }

  /** The vertex that the keyboard is at: a ring of its neighbours' edges. */
  setCursor(vertex: number): void {
    const surface = this.#surface;
    const points: number[] = [];
    if (surface && vertex >= 0) {
      for (let n = surface.starts[vertex]; n < surface.starts[vertex + 1]; n++) {
        const at = this.point(vertex);
        points.push(...at.toArray(), ...this.point(surface.neighbours[n]).lerp(at, 0.4).toArray());
      }
    }
    this.#cursor.set(points, new Color('#ff2d95'));
    this.draw();
  }

  /** Outlines triangles, and edges given by two vertices. */
  highlight(triangles: number[], edges: [number, number][] = []): void {
    const surface = this.#surface;
    const points: number[] = [];
    if (surface) {
      const add = (v: number, w: number): void => {
        points.push(...this.point(v).toArray(), ...this.point(w).toArray());
      };
      for (const t of triangles.slice(0, 2000)) {
        const [a, b, c] = surface.triangles.subarray(3 * t, 3 * t + 3);
        if (a !== undefined)
          [
            [a, b],
            [b, c],
            [c, a],
          ].forEach(([v, w]) => add(v, w));
      }
      for (const [v, w] of edges) add(v, w);
    }
    this.#light.set(points, new Color('#ff2d95'));
    this.draw();
  }

  /** The triangle under a pointer and its vertex nearest to it; what is behind is not seen. */
  pick(event: { clientX: number; clientY: number }): Hit | undefined {
    const surface = this.#surface;
    if (!surface) return undefined;
    this.#bvh ??= new MeshBVH(this.#mesh.geometry, { indirect: true, maxLeafSize: 10 });
    const { x, y } = this.pointer(event);
    const caster = new Raycaster();
    caster.setFromCamera(new Vector2(x, y), this.camera);
    const hit = this.#bvh.raycastFirst(caster.ray, 2);
    if (hit?.faceIndex === undefined || hit.faceIndex === null) return undefined;
    const corners = surface.triangles.subarray(3 * hit.faceIndex, 3 * hit.faceIndex + 3);
    const box = this.canvas.getBoundingClientRect();
    let best: Hit = { triangle: hit.faceIndex, vertex: -1, pixels: Infinity };
    for (const vertex of corners) {
      const at = this.toScreen(vertex);
      const pixels = Math.hypot(
        at.x - (event.clientX - box.left),
        at.y - (event.clientY - box.top),
      );
      if (pixels < best.pixels) best = { ...best, vertex, pixels };
    }
    return best;
  }

  /** CSS pixels from the corner of the canvas. */
  toScreen(vertex: number): { x: number; y: number } {
    const at = this.point(vertex).project(this.camera);
    const { clientWidth, clientHeight } = this.canvas;
    return { x: ((at.x + 1) / 2) * clientWidth, y: ((1 - at.y) / 2) * clientHeight };
  }

  /** Brings a vertex to the middle. */
  lookAt(vertex: number): void {
    const normal = new Vector3().fromArray(this.#surface!.normals, 3 * vertex);
    this.orbit.lookAt(this.point(vertex), normal);
    this.draw();
  }

  /** Brings what is under a pointer to the middle. */
  centre(event: { clientX: number; clientY: number }): void {
    const hit = this.pick(event);
    if (hit) this.lookAt(hit.vertex);
  }

  toggleParallel(): void {
    this.orbit.setParallel(!this.orbit.isParallel);
    this.#markers.resize(this.#markerSize());
    this.draw();
  }
}
