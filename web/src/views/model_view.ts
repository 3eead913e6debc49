// The 3D view: surface, pattern, overlay, seams, cones, cursor, highlight; before and after.

import {
  BufferGeometry,
  Color,
  type Group,
  type Matrix3,
  Mesh,
  PerspectiveCamera,
  Raycaster,
  Vector2,
  Vector3,
} from 'three';
import type { MeshBVH } from 'three-mesh-bvh';
import type { Cone, Prescription } from '../model/prescription';
import { areSeamsShown, isAligned, tilesPerUnit } from '../model/grid';
import type { Look, Solution, Surface } from '../model/types';
import type { SerializedBvh } from '../services/geometry/protocol';
import { Orbit } from './camera';
import { CanvasView, type Hit } from './canvas_view';
import { ConeMarkers, type Marker } from './cone_markers';
import { bvhAtOnce, bvhFrom, setTint, surfaceGeometry } from './corner_geometry';
import { Lines, seamsOnSurface, Wire } from './lines';
import {
  setImage,
  setPalette,
  setPattern,
  surfaceMaterial,
  type Palette,
} from './pattern_material';
import { chainColour, ticksOnSurface } from './seam_marks';
import { StudioLight } from './studio_light';

const highlightColour = new Color('#ff2d95');

export class ModelView extends CanvasView {
  readonly camera = new PerspectiveCamera(32, 1, 0.01, 100);
  readonly orbit: Orbit;
  readonly #mesh = new Mesh(new BufferGeometry(), surfaceMaterial(true));
  readonly #markers = new ConeMarkers(true);
  readonly #ghost = new ConeMarkers(false, 12);
  readonly #seams = new Lines(3.5, { order: 3, bias: 2 });
  readonly #ticks = new Lines(2.5, { order: 3, bias: 2 });
  readonly #handles = new Lines(4, { order: 4, bias: 2 });
  readonly #crosses = new Lines(2, { order: 1, bias: 1 });
  readonly #wire = new Wire(1, true);
  readonly #light = new Lines(4.5, { order: 6, depth: false });
  readonly #cursor = new Lines(3, { order: 7, depth: false });
  readonly #studio: StudioLight;
  #surface?: Surface;
  #solution?: Solution;
  #bvh?: MeshBVH;
  #image?: ImageBitmap;
  #original?: Group;
  #isOriginalShown = false;
  /** Fraction of the width, from the left, in which the original model is shown. */
  #wipe = 0;

  constructor(canvas: HTMLCanvasElement) {
    super(canvas);
    this.scene.add(this.#mesh, this.#wire, this.#crosses, this.#seams, this.#ticks);
    this.scene.add(this.#handles, this.#light, this.#cursor, this.#markers, this.#ghost);
    this.#mesh.visible = false;
    this.#mesh.frustumCulled = false; // it is nearly always visible
    this.#ghost.setStyle(1.1, 0.75);
    const { toStudio } = this.#mesh.material.uniforms;
    this.#studio = new StudioLight(this.renderer, this.scene, toStudio.value as Matrix3);
    this.beforeDraw(() => {
      this.#studio.turn(this.camera, this.orbit.controls.target);
      const eye = this.camera.position;
      for (const lines of [this.#seams, this.#crosses, this.#wire, this.#ticks, this.#handles]) {
        lines.lift(eye, this.orbit.lift);
      }
    });
    this.orbit = new Orbit(this.camera, canvas, () => this.draw());
  }

  protected onResize(width: number, height: number): void {
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.orbit.reshaped();
  }

  protected override onRestored(): void {
    this.#studio.restore();
  }

  /** Shows a surface and its solution. A new surface is framed; a new solution keeps the camera. */
  setModel(surface: Surface | undefined, solution: Solution | undefined): void {
    if (surface === this.#surface && solution === this.#solution) return;
    const isNew = surface !== this.#surface;
    this.#surface = surface;
    this.#solution = solution;
    const before = this.#mesh.geometry;
    before.dispose();
    for (const lines of [this.#seams, this.#ticks, this.#crosses, this.#wire, this.#light]) {
      lines.visible = false;
    }
    if (isNew) this.#cursor.visible = this.#handles.visible = this.#ghost.visible = false;
    if (isNew) this.#bvh = undefined;
    if (!surface) {
      this.#mesh.geometry = new BufferGeometry();
      this.#markers.show([]);
    } else {
      this.#mesh.geometry = surfaceGeometry(surface, solution, isNew ? undefined : before);
      this.#mesh.material.uniforms.isMirrored.value = surface.isMirrored;
      for (const markers of [this.#markers, this.#ghost]) markers.setLift(0.08 * surface.radius);
      if (isNew) this.orbit.frame(new Vector3(...surface.center), surface.radius, surface.places);
    }
    this.#showOriginal();
    this.draw();
  }

  /** Sets the tree for picking on a surface that is too large to build it synchronously. */
  setBvh(surface: Surface, serialized: SerializedBvh): void {
    if (surface === this.#surface) this.#bvh = bvhFrom(serialized, this.#mesh.geometry);
  }

  setLook(look: Look, q: number, isStale: boolean, palette: Palette): void {
    const material = this.#mesh.material;
    const surface = this.#surface;
    const solution = this.#solution;
    if (!surface || !solution) setPattern(material, 'plain', { q, scale: 1, isAligned: false });
    else {
      const scale = tilesPerUnit(look, surface, solution);
      setPattern(material, look.pattern, { q, scale, isAligned: isAligned(solution) });
    }
    setPalette(material, palette);
    material.uniforms.dim.value = isStale ? 0.65 : 0;
    if (look.image && look.image !== this.#image) setImage(material, (this.#image = look.image));
    this.canvas.dataset.seams = look.seams;
    this.#setLines(look, palette);
    this.draw();
  }

  /** Fades the markers after Run, until cones are edited again. */
  setMarkers(areFaded: boolean): void {
    this.#markers.setStyle(areFaded ? 0.42 : 1, areFaded ? 0.55 : 1);
    this.draw();
  }

  #setLines(look: Look, palette: Palette): void {
    const surface = this.#surface;
    const solution = this.#solution;
    this.#crosses.visible &&= look.pattern === 'cross';
    this.#seams.visible = this.#ticks.visible = this.#wire.visible = false;
    if (surface && solution && areSeamsShown(look, solution)) {
      const { points, colours } = seamsOnSurface(surface, solution);
      this.#seams.set(points, colours);
      const ticks = ticksOnSurface(surface, solution);
      this.#ticks.set(ticks.points, ticks.colours);
    }
    if (surface && look.hasWire) this.#wire.set(this.#mesh.geometry, palette.ink);
  }

  setOverlay(colours: Uint8Array): void {
    setTint(this.#mesh.geometry, colours);
    this.draw();
  }

  setCrosses(points: Float32Array, palette: Palette): void {
    this.#crosses.set(points, palette.ink);
    this.draw();
  }

  /** Shows loops around handles, each in its colour in the panel. */
  setHandles(loops: Float32Array[]): void {
    const points = new Float32Array(loops.reduce((sum, loop) => sum + loop.length, 0));
    const colours: Color[] = [];
    let at = 0;
    loops.forEach((loop, i) => {
      points.set(loop, at);
      at += loop.length;
      for (let s = 0; s < loop.length; s += 6) colours.push(chainColour(i));
    });
    this.#handles.set(points, colours);
    this.draw();
  }

  /** Sets the model with its own materials, shown instead of the pattern or as the state before. */
  setOriginal(original: Group | undefined, isShown: boolean): void {
    if (original !== this.#original) {
      this.#original?.removeFromParent();
      this.#original = original;
      if (original) this.scene.add(original);
      if (original) this.#studio.lightMaterials();
    }
    this.#isOriginalShown = isShown;
    this.#showOriginal();
    this.draw();
  }

  setWipe(part: number): void {
    this.#wipe = part;
    this.draw();
  }

  #showOriginal(): void {
    const isOriginal = this.#original !== undefined && this.#isOriginalShown;
    if (this.#original) this.#original.visible = isOriginal;
    this.#mesh.visible = this.#surface !== undefined && !isOriginal;
    this.canvas.dataset.original = isOriginal ? 'shown' : 'none';
  }

  /** Draws twice if before and after are shown side by side. */
  protected override render(): void {
    const { renderer, scene, camera } = this;
    if (this.#wipe <= 0 || !this.#solution) return renderer.render(scene, camera);
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const split = Math.round(width * this.#wipe);
    renderer.setScissorTest(true);
    renderer.setScissor(split, 0, width - split, height);
    renderer.render(scene, camera);
    const over = [this.#seams, this.#ticks, this.#crosses, this.#markers];
    const wasVisible = over.map(({ visible }) => visible);
    const { pattern } = this.#mesh.material.uniforms;
    const usual: unknown = pattern.value;
    for (const thing of over) thing.visible = false;
    pattern.value = 0;
    if (this.#original) {
      this.#original.visible = true;
      this.#mesh.visible = false;
    }
    renderer.setScissor(0, 0, split, height);
    renderer.render(scene, camera);
    over.forEach((thing, i) => (thing.visible = wasVisible[i]));
    pattern.value = usual;
    this.#showOriginal();
    renderer.setScissorTest(false);
  }

  setCones({ cones, q }: Prescription, bad: boolean[], selected: number): void {
    const surface = this.#surface;
    if (!surface) return;
    const markers = cones.flatMap(({ vertex, k }, i): Marker[] =>
      vertex < surface.vertexCount
        ? [{ at: this.#place(vertex), k, q, isSelected: i === selected, isBad: bad[i] }]
        : [],
    );
    this.#markers.show(markers);
    this.draw();
  }

  /** Shows the cone that a click would place. */
  setGhost(cone: Cone | undefined, q = 4): void {
    if (!cone && !this.#ghost.visible) return;
    const at = cone && this.#surface ? this.#place(cone.vertex) : undefined;
    const plain = { isSelected: false, isBad: false };
    this.#ghost.show(cone && at ? [{ at, k: cone.k, q, ...plain }] : []);
    this.canvas.dataset.ghost = cone ? String(cone.k) : '';
    this.draw();
  }

  #place(vertex: number): [number, number, number] {
    const { places } = this.#surface!;
    return [0, 1, 2].map((i) => places[3 * vertex + i]) as [number, number, number];
  }
  point(vertex: number): Vector3 {
    return new Vector3(...this.#place(vertex));
  }

  /** Shows the vertex of the keyboard cursor by the edges of its one-ring. */
  setCursor(vertex: number): void {
    const surface = this.#surface;
    const points: number[] = [];
    if (surface && vertex >= 0) {
      const at = this.point(vertex);
      for (let n = surface.neighbourStart[vertex]; n < surface.neighbourStart[vertex + 1]; n++) {
        points.push(...at.toArray(), ...this.point(surface.neighbours[n]).lerp(at, 0.4).toArray());
      }
    }
    this.#cursor.set(points, highlightColour);
    this.draw();
  }

  /** Outlines triangles, and edges given by two vertices. */
  highlight(triangles: number[], edges: [number, number][] = []): void {
    const surface = this.#surface;
    if (!surface || triangles.length + edges.length === 0) {
      if (this.#light.visible) this.draw();
      this.#light.visible = false;
      return;
    }
    const points: number[] = [];
    const add = (v: number, w: number): void => {
      points.push(...this.#place(v), ...this.#place(w));
    };
    for (const t of triangles.slice(0, 2000)) {
      const [a, b, c] = surface.triangles.subarray(3 * t, 3 * t + 3);
      if (c === undefined) continue;
      add(a, b);
      add(b, c);
      add(c, a);
    }
    for (const [v, w] of edges) add(v, w);
    this.#light.set(points, highlightColour);
    this.draw();
  }

  /** The front triangle under a pointer, and its vertex nearest to the pointer. */
  pick(event: { clientX: number; clientY: number }): Hit | undefined {
    const surface = this.#surface;
    if (!surface) return undefined;
    this.#bvh ??= bvhAtOnce(this.#mesh.geometry);
    const { x, y } = this.pointer(event);
    const caster = new Raycaster();
    caster.setFromCamera(new Vector2(x, y), this.camera);
    const hit = this.#bvh?.raycastFirst(caster.ray, 2);
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

  /** The position of a vertex in CSS pixels from the corner of the canvas. */
  toScreen(vertex: number): { x: number; y: number } {
    const at = this.point(vertex).project(this.camera);
    const { clientWidth, clientHeight } = this.canvas;
    return { x: ((at.x + 1) / 2) * clientWidth, y: ((1 - at.y) / 2) * clientHeight };
  }

  /** Centres a vertex. */
  lookAt(vertex: number): void {
    if (!this.#surface) return;
    const normal = new Vector3().fromArray(this.#surface.normals, 3 * vertex);
    this.orbit.lookAt(this.point(vertex), normal);
    this.draw();
  }

  /** Centres the point under a pointer. */
  centre(event: { clientX: number; clientY: number }): void {
    const hit = this.pick(event);
    if (hit) this.lookAt(hit.vertex);
  }

  toggleParallel(): void {
    this.orbit.setParallel(!this.orbit.isParallel);
    this.draw();
  }
}
