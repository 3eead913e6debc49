// The UV view: the same map laid flat, with the same pattern, seams and cones. Drag pans, wheel zooms.

import { BufferGeometry, Color, Mesh, OrthographicCamera, Ray, Vector3 } from 'three';
import { MeshBVH } from 'three-mesh-bvh';
import type { Look } from '../state/app';
import { boxOf } from '../state/measure';
import type { Prescription } from '../state/prescription';
import type { Solved } from '../state/solved';
import { spacingOf } from '../state/spread';
import type { Surface } from '../state/surface';
import { crosses, flatGeometry, paint } from './geometry';
import { Lines, seamsInMap, Wire } from './lines';
import { ticksInMap } from './ticks';
import { Markers } from './markers';
import { setImage, setPalette, setPattern, surfaceMaterial, type Palette } from './material';
import { Stage } from './stage';
import type { Hit } from './surface_view';

type Place = { clientX: number; clientY: number };

const unitSquare = [0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 1, 0, 1, 1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0];

export class MapView extends Stage {
  readonly camera = new OrthographicCamera(-1, 1, 1, -1, -10, 10);
  readonly #mesh = new Mesh(new BufferGeometry(), surfaceMaterial(false));
  readonly #markers = new Markers();
  readonly #seams = new Lines(2.5, { order: 3, depth: false });
  readonly #ticks = new Lines(2, { order: 3, depth: false });
  readonly #crosses = new Lines(1.5, { order: 1, depth: false });
  readonly #wire = new Wire(1, false);
  readonly #light = new Lines(4, { order: 6, depth: false });
  readonly #square = new Lines(1.2, { order: 0, depth: false });
  #surface?: Surface;
  #solved?: Solved;
  #bvh?: MeshBVH;
  #center = { x: 0.5, y: 0.5 };
  /** Half of the visible height, in uv. */
  #reach = 0.6;
  #image?: ImageBitmap;
  #size = { width: 1, height: 1 };
  #isTouched = false;
  /** Off while a cone is dragged. */
  isPanning = true;

  constructor(canvas: HTMLCanvasElement) {
    super(canvas);
    this.scene.add(this.#square, this.#mesh, this.#wire, this.#crosses, this.#seams);
    this.scene.add(this.#ticks, this.#light, this.#markers);
    this.#mesh.visible = false;
    this.#mesh.frustumCulled = false;
    this.#listen();
  }

  protected onResize(width: number, height: number): void {
    this.#size = { width, height };
    if (this.#isTouched) this.#aim();
    else this.fit();
  }

  #aim(): void {
    const { x, y } = this.#center;
    const wide = (this.#reach * this.#size.width) / this.#size.height;
    Object.assign(this.camera, { left: x - wide, right: x + wide });
    Object.assign(this.camera, { top: y + this.#reach, bottom: y - this.#reach });
    this.camera.updateProjectionMatrix();
    this.#markers.resize(this.#markerSize());
    this.draw();
  }

  #markerSize(): number {
    return (2 * this.#reach * 22) / this.#size.height;
  }

  fit(): void {
    this.#isTouched = false;
    if (!this.#solved) return this.#aim();
    const { x, y, width, height } = boxOf(this.#solved.corners.uv);
    this.#center = { x: x + width / 2, y: y + height / 2 };
    const aspect = this.#size.width / this.#size.height;
    this.#reach = 0.55 * Math.max(height, width / aspect) || 0.6;
    this.#aim();
  }

  zoom(factor: number): void {
    this.#isTouched = true;
    this.#reach *= factor;
    this.#aim();
  }

  /** Brings what is under a pointer to the middle, twice as large. */
  centre(event: Place): void {
    this.#center = this.#toUv(event);
    this.zoom(0.5);
  }

  /** Parts of the visible height. */
  pan(x: number, y: number): void {
    this.#isTouched = true;
    this.#center.x += 2 * this.#reach * x;
    this.#center.y += 2 * this.#reach * y;
    this.#aim();
  }

  #listen(): void {
    const { canvas } = this;
    canvas.addEventListener(
      'wheel',
      (event) => {
        event.preventDefault();
        this.#isTouched = true;
        const before = this.#toUv(event);
        this.#reach *= Math.exp(Math.max(-1, Math.min(1, event.deltaY / 400)));
        this.#aim();
        const after = this.#toUv(event);
        this.#center.x += before.x - after.x;
        this.#center.y += before.y - after.y;
        this.#aim();
      },
      { passive: false },
    );
    const fingers = new Map<number, { clientX: number; clientY: number }>();
    const forget = (event: PointerEvent): void => void fingers.delete(event.pointerId);
    canvas.addEventListener('pointerdown', (event) => {
      canvas.setPointerCapture(event.pointerId);
      fingers.set(event.pointerId, event);
    });
    canvas.addEventListener('pointermove', (event) => {
      const before = fingers.get(event.pointerId);
      if (!before || event.buttons === 0) return;
      const other = [...fingers].find(([id]) => id !== event.pointerId)?.[1];
      fingers.set(event.pointerId, event);
      if (other) this.#pinch(before, event, other);
      else if (this.isPanning) this.#drag(before, event);
    });
    for (const end of ['pointerup', 'pointercancel'] as const) canvas.addEventListener(end, forget);
  }

  /** What was under the pointer stays under it. */
  #drag(before: Place, after: Place): void {
    this.#isTouched = true;
    const [from, to] = [this.#toUv(before), this.#toUv(after)];
    this.#center.x += from.x - to.x;
    this.#center.y += from.y - to.y;
    this.#aim();
  }

  /** One of two fingers moves: what lies under their middle goes along, and is as much larger. */
  #pinch(before: Place, after: Place, other: Place): void {
    const middle = (finger: Place): Place => ({
      clientX: (finger.clientX + other.clientX) / 2,
      clientY: (finger.clientY + other.clientY) / 2,
    });
    const apart = (finger: Place): number =>
      Math.max(20, Math.hypot(finger.clientX - other.clientX, finger.clientY - other.clientY));
    const from = this.#toUv(middle(before));
    this.#reach *= apart(before) / apart(after);
    const to = this.#toUv(middle(after));
    this.#isTouched = true;
    this.#center.x += from.x - to.x;
    this.#center.y += from.y - to.y;
    this.#aim();
  }

  #toUv(event: { clientX: number; clientY: number }): { x: number; y: number } {
    const { x, y } = this.pointer(event);
    const wide = (this.#reach * this.#size.width) / this.#size.height;
    return { x: this.#center.x + x * wide, y: this.#center.y + y * this.#reach };
  }

  setModel(surface: Surface | undefined, solved: Solved | undefined): void {
    if (solved === this.#solved) return;
    this.#solved = solved;
    this.#surface = surface;
    this.#bvh = undefined;
    this.#mesh.geometry.dispose();
    this.#mesh.visible = solved !== undefined;
    for (const lines of [this.#seams, this.#ticks, this.#crosses, this.#wire])
      lines.visible = false;
    this.#light.visible = this.#square.visible = false;
    this.#mesh.geometry = solved ? flatGeometry(solved) : new BufferGeometry();
    if (solved) this.fit();
    this.draw();
  }

  setLook(look: Look, q: number, isStale: boolean, palette: Palette): void {
    const solved = this.#solved;
    const surface = this.#surface;
    if (!solved || !surface) return;
    const material = this.#mesh.material;
    setPattern(material, look.pattern, q);
    setPalette(material, palette);
    material.uniforms.dim.value = isStale ? 0.65 : 0;
    if (look.image && look.image !== this.#image) setImage(material, (this.#image = look.image));
    const { surfaceArea, uvArea } = solved.distortion;
    material.uniforms.scale.value =
      look.tiles / (Math.sqrt(uvArea / surfaceArea) * surface.diagonal);
    paint(this.#mesh.geometry, solved, look.overlay);
    this.#square.set(unitSquare, palette.ink);
    if (look.pattern === 'cross' && look.overlay !== 'flips') {
      const spacing = spacingOf(surface, look.tiles);
      this.#crosses.set(crosses(surface, solved, spacing, q, true), palette.ink);
    } else this.#crosses.visible = false;
    if (look.hasSeams) {
      const { points, colours } = seamsInMap(solved);
      this.#seams.set(points, colours);
      const box = boxOf(solved.corners.uv);
      const half = 0.012 * Math.max(box.width, box.height);
      const ticks = ticksInMap(solved, half);
      this.#ticks.set(ticks.points, ticks.colours);
    } else this.#seams.visible = this.#ticks.visible = false;
    if (look.hasWire) this.#wire.set(this.#mesh.geometry, palette.ink);
    else this.#wire.visible = false;
    this.draw();
  }

  /** A cone on a cut has several images in the map; each is shown. */
  setCones(asked: Prescription, bad: boolean[], selected: number): void {
    if (!this.#solved) return this.#markers.show([], 0, false);
    const { uv, uvToVertex } = this.#solved.result;
    const coneAt = new Map(asked.cones.map(({ vertex }, i) => [vertex, i]));
    const markers = [...uvToVertex].flatMap((vertex, i) => {
      const cone = coneAt.get(vertex);
      if (cone === undefined) return [];
      const at = new Vector3(uv[2 * i], uv[2 * i + 1], 0.01);
      const { k } = asked.cones[cone];
      return [{ at, k, q: asked.q, isSelected: cone === selected, isBad: bad[cone] }];
    });
    this.#markers.show(markers, this.#markerSize(), false);
    this.draw();
  }

  /** Outlines triangles and edges given by uv vertices. */
  highlight(triangles: number[], edges: [number, number][] = []): void {
    const solved = this.#solved;
    const points: number[] = [];
    if (solved) {
      const { uv, cornerToUv } = solved.result;
      const add = (i: number, j: number): void => {
        points.push(uv[2 * i], uv[2 * i + 1], 0.005, uv[2 * j], uv[2 * j + 1], 0.005);
      };
      for (const t of triangles.slice(0, 2000)) {
        const [a, b, c] = cornerToUv.subarray(3 * t, 3 * t + 3);
        if (a !== undefined)
          [
            [a, b],
            [b, c],
            [c, a],
          ].forEach(([i, j]) => add(i, j));
      }
      for (const [i, j] of edges) add(i, j);
    }
    this.#light.set(points, new Color('#ff2d95'));
    this.draw();
  }

  pick(event: { clientX: number; clientY: number }): Hit | undefined {
    const solved = this.#solved;
    if (!solved) return undefined;
    this.#bvh ??= new MeshBVH(this.#mesh.geometry, { indirect: true, maxLeafSize: 10 });
    const at = this.#toUv(event);
    const ray = new Ray(new Vector3(at.x, at.y, 5), new Vector3(0, 0, -1));
    const hit = this.#bvh.raycastFirst(ray, 2);
    if (hit?.faceIndex === undefined || hit.faceIndex === null) return undefined;
    const { uv, cornerToUv, triangles } = solved.result;
    const perPixel = (2 * this.#reach) / this.#size.height;
    let best: Hit = { triangle: hit.faceIndex, vertex: -1, pixels: Infinity };
    for (let k = 0; k < 3; k++) {
      const i = cornerToUv[3 * hit.faceIndex + k];
      const pixels = Math.hypot(uv[2 * i] - at.x, uv[2 * i + 1] - at.y) / perPixel;
      if (pixels < best.pixels)
        best = { ...best, vertex: triangles[3 * hit.faceIndex + k], pixels };
    }
    return best;
  }
}
