// The UV view: the map as a flat mesh, with the same pattern, seams and cones. Dragging pans, the wheel zooms.

import { BufferGeometry, Color, Mesh, MOUSE, OrthographicCamera, Ray, TOUCH, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { MeshBVH } from 'three-mesh-bvh';
import { isAligned, tilesPerUnit } from '../model/grid';
import type { LiveMap } from '../model/live';
import type { Prescription } from '../model/prescription';
import type { SerializedBvh } from '../model/scene';
import type { Look, Solution, Surface } from '../model/types';
import { CanvasView, nearestOf, type Hit } from './canvas_view';
import { ConeMarkers, type Marker } from './cone_markers';
import { boxOf } from '../services/geometry/distortion';
import { bvhAtOnce, bvhFrom, flatGeometry, setTint } from './corner_geometry';
import { LiveGeometry } from './live_geometry';
import { Lines, seamsInMap, Wire } from './lines';
import {
  setImage,
  setPalette,
  setPattern,
  surfaceMaterial,
  type Palette,
} from './pattern_material';
import { ticksInMap } from './seam_marks';

type Place = { clientX: number; clientY: number };

const unitSquare = [0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 1, 0, 1, 1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0];
const eyeHeight = 10;

export class UvView extends CanvasView {
  readonly camera = new OrthographicCamera(-1, 1, 1, -1, 0, 2 * eyeHeight);
  readonly controls: OrbitControls;
  readonly #mesh = new Mesh(new BufferGeometry(), surfaceMaterial(false));
  readonly #markers = new ConeMarkers(false);
  readonly #seams = new Lines(2.5, { order: 3, depth: false });
  readonly #ticks = new Lines(2, { order: 3, depth: false });
  readonly #crosses = new Lines(1.5, { order: 1, depth: false });
  readonly #wire = new Wire(1, false);
  readonly #light = new Lines(4, { order: 6, depth: false });
  readonly #square = new Lines(1.2, { order: 0, depth: false });
  /** Called with the pixels per unit of uv before every drawing. */
  onScale?: (pixels: number) => void;
  #surface?: Surface;
  #solution?: Solution;
  readonly #live = new LiveGeometry(true);
  #bvh?: MeshBVH;
  #image?: ImageBitmap;
  #size = { width: 1, height: 1 };
  /** Whether the user has moved the view: resizing then keeps it. */
  #isTouched = false;

  constructor(canvas: HTMLCanvasElement) {
    super(canvas);
    this.scene.add(this.#square, this.#mesh, this.#wire, this.#crosses, this.#seams);
    this.scene.add(this.#ticks, this.#light, this.#markers);
    this.#mesh.visible = false;
    this.#mesh.frustumCulled = false;
    this.#markers.setStyle(0.5, 0.8);
    this.controls = this.#makeControls(canvas);
    this.beforeDraw(() => this.onScale?.(this.#size.height / (2 * this.#reach)));
    this.#lookAt(0.5, 0.5, 0.6);
  }

  #makeControls(canvas: HTMLCanvasElement): OrbitControls {
    const controls = new OrbitControls(this.camera, canvas);
    Object.assign(controls, { enableRotate: false, enableDamping: false, zoomToCursor: true });
    controls.mouseButtons = { LEFT: MOUSE.PAN, MIDDLE: MOUSE.DOLLY, RIGHT: MOUSE.PAN };
    controls.touches = { ONE: TOUCH.PAN, TWO: TOUCH.DOLLY_PAN };
    controls.addEventListener('start', () => (this.#isTouched = true));
    controls.addEventListener('change', () => this.draw());
    return controls;
  }

  protected onResize(width: number, height: number): void {
    this.#size = { width, height };
    const wide = width / height;
    Object.assign(this.camera, { left: -wide, right: wide });
    this.camera.updateProjectionMatrix();
    if (!this.#isTouched) this.fit();
  }

  /** Half of the visible height, in uv. */
  get #reach(): number {
    return 1 / this.camera.zoom;
  }

  #lookAt(x: number, y: number, reach: number): void {
    this.camera.zoom = 1 / reach;
    this.camera.position.set(x, y, eyeHeight);
    Object.assign(this.controls.target, { x, y });
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.draw();
  }

  fit(): void {
    this.#isTouched = false;
    if (this.#solution) this.#fitTo(this.#solution.box);
  }

  /** Shows all of a box, if that is not so already: while a cone is dragged the view should rest. */
  #keepInView(box: Solution['box']): void {
    const { x, y } = this.controls.target;
    const tall = this.#reach;
    const wide = (tall * this.#size.width) / this.#size.height;
    const isInside =
      box.x > x - wide && box.x + box.width < x + wide && box.y > y - tall && box.y + box.height < y + tall; // prettier-ignore
    if (!isInside) this.#fitTo(box);
  }

  #fitTo({ x, y, width, height }: Solution['box']): void {
    const aspect = this.#size.width / this.#size.height;
    const reach = 0.55 * Math.max(height, width / aspect) || 0.6;
    this.#lookAt(x + width / 2, y + height / 2, reach);
  }

  zoom(factor: number): void {
    this.#isTouched = true;
    const { x, y } = this.controls.target;
    this.#lookAt(x, y, this.#reach * factor);
  }

  /** Centres the point under a pointer and doubles the magnification. */
  centre(event: Place): void {
    const { x, y } = this.#toUv(event);
    this.#isTouched = true;
    this.#lookAt(x, y, this.#reach / 2);
  }

  /** Pans by fractions of the visible height. */
  pan(x: number, y: number): void {
    this.#isTouched = true;
    const { target } = this.controls;
    const step = 2 * this.#reach;
    this.#lookAt(target.x + step * x, target.y + step * y, this.#reach);
  }

  #toUv(event: Place): { x: number; y: number } {
    const { x, y } = this.pointer(event);
    const at = new Vector3(x, y, 0).unproject(this.camera);
    return { x: at.x, y: at.y };
  }

  setModel(surface: Surface | undefined, solution: Solution | undefined): void {
    if (solution === this.#solution) return;
    this.#live.restore();
    this.#solution = solution;
    this.#surface = surface;
    this.#bvh = undefined;
    this.#mesh.geometry.dispose();
    this.#mesh.visible = solution !== undefined;
    for (const lines of [this.#seams, this.#ticks, this.#crosses]) lines.visible = false;
    this.#wire.forget();
    this.#light.visible = this.#square.visible = false;
    this.#mesh.geometry = solution ? flatGeometry(solution) : new BufferGeometry();
    // A cone that was dropped leaves the map where the hand has left it.
    if (solution && !solution.isDragged) this.fit();
    if (!solution) this.#markers.show([]);
    this.draw();
  }

  setBvh(solution: Solution, serialized: SerializedBvh): void {
    if (solution === this.#solution) this.#bvh = bvhFrom(serialized, this.#mesh.geometry);
  }

  setLook(look: Look, q: number, isStale: boolean, palette: Palette): void {
    const solution = this.#solution;
    const surface = this.#surface;
    if (!solution || !surface) return;
    const material = this.#mesh.material;
    const scale = tilesPerUnit(look, surface, solution);
    setPattern(material, look.pattern, { q, scale, isAligned: isAligned(solution) });
    setPalette(material, palette);
    material.uniforms.dim.value = isStale ? 0.65 : 0;
    if (look.image && look.image !== this.#image) setImage(material, (this.#image = look.image));
    // Of other maps it is any square; the bar says how large one cell is.
    this.#square.set(solution.output.scale === 'fit' ? unitSquare : [], palette.ink);
    this.#setLines(look, palette, solution);
    this.draw();
  }

  #setLines(look: Look, palette: Palette, solution: Solution): void {
    this.#crosses.visible &&= look.pattern === 'cross';
    this.#seams.visible = this.#ticks.visible = this.#wire.visible = false;
    if (look.seams !== 'off') {
      const { points, colours } = seamsInMap(solution);
      this.#seams.set(points, colours);
      const half = 0.012 * Math.max(solution.box.width, solution.box.height);
      const ticks = ticksInMap(solution, half);
      this.#ticks.set(ticks.points, ticks.colours);
    }
    if (look.hasWire) this.#wire.set(this.#mesh.geometry, palette.ink);
  }

  /** Shows a map that is not stored in place of the solution's; undefined: the solution's again. */
  setLive(live: LiveMap | undefined): void {
    if (!live && !this.#live.isShown) return;
    this.#live.show(this.#mesh.geometry, live, this.#surface);
    this.#bvh?.refit();
    if (live) {
      for (const lines of [this.#seams, this.#ticks, this.#crosses, this.#wire])
        lines.visible = false;
    }
    if (!this.#isTouched && live) this.#keepInView(boxOf(live.cornerUv));
    else if (!this.#isTouched) this.fit();
    this.draw();
  }

  setOverlay(colours: Uint8Array): void {
    setTint(this.#mesh.geometry, colours);
    this.draw();
  }

  setCrosses(points: Float32Array, palette: Palette): void {
    this.#crosses.set(points, palette.ink);
    this.draw();
  }

  /** Shows cones; a cone on a seam has several images in the map, all of which are shown. */
  setCones({ cones, q }: Prescription, bad: boolean[], selected: number): void {
    const solution = this.#solution;
    if (!solution) return this.#markers.show([]);
    const coneAt = new Map(cones.map(({ vertex }, i) => [vertex, i]));
    const markers = new Map<string, Marker>();
    const add = (vertex: number, x: number, y: number): void => {
      const cone = coneAt.get(vertex);
      if (cone === undefined) return;
      const isSelected = cone === selected;
      const at: Marker['at'] = [x, y, 0.01];
      markers.set(`${x} ${y}`, { at, k: cones[cone].k, q, isSelected, isBad: bad[cone] });
    };
    const { uv, uvToVertex, triangles } = solution.result;
    if (this.#live.isShown) {
      const at = this.#mesh.geometry.getAttribute('uv').array;
      triangles.forEach((vertex, c) => add(vertex, at[2 * c], at[2 * c + 1]));
    } else uvToVertex.forEach((vertex, i) => add(vertex, uv[2 * i], uv[2 * i + 1]));
    this.#markers.show([...markers.values()]);
    this.draw();
  }

  /** Outlines triangles and edges given by uv vertices. */
  highlight(triangles: number[], edges: [number, number][] = []): void {
    const solution = this.#solution;
    if (!solution || triangles.length + edges.length === 0) {
      if (this.#light.visible) this.draw();
      this.#light.visible = false;
      return;
    }
    const points: number[] = [];
    const { uv, cornerToUv } = solution.result;
    const add = (i: number, j: number): void => {
      points.push(uv[2 * i], uv[2 * i + 1], 0.005, uv[2 * j], uv[2 * j + 1], 0.005);
    };
    for (const t of triangles.slice(0, 2000)) {
      const [a, b, c] = cornerToUv.subarray(3 * t, 3 * t + 3);
      if (c === undefined) continue;
      add(a, b);
      add(b, c);
      add(c, a);
    }
    for (const [i, j] of edges) add(i, j);
    this.#light.set(points, new Color('#ff2d95'));
    this.draw();
  }

  pick(event: Place): Hit | undefined {
    const solution = this.#solution;
    if (!solution) return undefined;
    this.#bvh ??= bvhAtOnce(this.#mesh.geometry);
    const at = this.#toUv(event);
    const ray = new Ray(new Vector3(at.x, at.y, 5), new Vector3(0, 0, -1));
    const hit = this.#bvh?.raycastFirst(ray, 2);
    if (hit?.faceIndex === undefined || hit.faceIndex === null) return undefined;
    const { triangles } = solution.result;
    const uv = this.#mesh.geometry.getAttribute('uv').array;
    const perPixel = (2 * this.#reach) / this.#size.height;
    const first = 3 * hit.faceIndex;
    return nearestOf(hit.faceIndex, triangles.subarray(first, first + 3), (_, corner) => {
      const i = 2 * (first + corner);
      return Math.hypot(uv[i] - at.x, uv[i + 1] - at.y) / perPixel;
    });
  }
}
