// Mouse, pen and touch on the two views: place, select, drag, and what lies under the pointer.

import type { App } from '../state/app';
import { moveCone, placeOrSelect, select, undo } from '../state/edit';
import { defectDegrees } from '../state/surface';
import type { Hit } from '../view/surface_view';
import type { Controls } from './controls';

const reach = { mouse: 12, pen: 16, touch: 24 } as const;
const markerReach = { mouse: 18, pen: 22, touch: 28 } as const;
const clickMoves = 4; // pixels: further is an orbit
const longPress = 400; // milliseconds

type View = {
  canvas: HTMLCanvasElement;
  pick(event: PointerEvent): Hit | undefined;
  centre(event: MouseEvent): void;
};

export class Pointer {
  readonly #app: App;
  readonly #ui: Controls;
  #down?: {
    x: number;
    y: number;
    view: View;
    cone: number;
    from?: number;
    time: number;
    isDrag: boolean;
  };
  #timer?: ReturnType<typeof setTimeout>;
  #hoverPending = false;

  constructor(app: App, ui: Controls) {
    this.#app = app;
    this.#ui = ui;
    ui.stopDrag = () => this.#putBack();
    for (const view of [ui.surfaceView!, ui.mapView!]) {
      const { canvas } = view;
      // Before the orbiting: a cone that is dragged must not turn the model.
      canvas.addEventListener('pointerdown', (event) => this.#press(view, event), {
        capture: true,
      });
      canvas.addEventListener('pointermove', (event) => this.#move(view, event));
      canvas.addEventListener('pointerup', (event) => this.#release(view, event));
      canvas.addEventListener('pointercancel', () => this.#forget());
      canvas.addEventListener('pointerleave', () => this.#leave());
      // What dragging turns and moves, without dragging.
      canvas.addEventListener('dblclick', (event) => {
        if (ui.tool === 'orbit') view.centre(event);
      });
    }
  }

  #coneNear(view: View, event: PointerEvent): number {
    const surfaceView = this.#ui.surfaceView!;
    const { cones } = this.#app.asked;
    const within = markerReach[event.pointerType as keyof typeof markerReach] ?? markerReach.mouse;
    if (view !== surfaceView) {
      const hit = view.pick(event);
      return hit && hit.pixels < within
        ? cones.findIndex(({ vertex }) => vertex === hit.vertex)
        : -1;
    }
    const box = view.canvas.getBoundingClientRect();
    const front = view.pick(event);
    let best = -1;
    let nearest: number = within;
    cones.forEach(({ vertex }, i) => {
      const at = surfaceView.toScreen(vertex);
      const pixels = Math.hypot(at.x - event.clientX + box.left, at.y - event.clientY + box.top);
      if (pixels >= nearest || (front && this.#isBehind(vertex, front))) return;
      [best, nearest] = [i, pixels];
    });
    return best;
  }

  /** Whether the surface under the pointer hides a vertex. */
  #isBehind(vertex: number, front: Hit): boolean {
    const surfaceView = this.#ui.surfaceView!;
    const { position } = surfaceView.camera;
    const slack = 0.03 * this.#app.surface!.diagonal;
    const far = surfaceView.point(vertex).distanceTo(position);
    return far > surfaceView.point(front.vertex).distanceTo(position) + slack;
  }

  #press(view: View, event: PointerEvent): void {
    view.canvas.focus({ preventScroll: true });
    if (!event.isPrimary || event.button !== 0 || !this.#app.surface) return this.#forget();
    const cone = this.#app.info?.usable ? this.#coneNear(view, event) : -1;
    const { clientX: x, clientY: y } = event;
    const from = this.#app.asked.cones[cone]?.vertex;
    this.#down = { x, y, view, cone, from, time: performance.now(), isDrag: false };
    if (cone >= 0 && view === this.#ui.surfaceView) {
      this.#ui.surfaceView.orbit.controls.enabled = false;
      view.canvas.setPointerCapture(event.pointerId);
    } else if (cone >= 0) this.#ui.mapView!.isPanning = false;
    if (event.pointerType === 'touch') {
      this.#timer = setTimeout(() => this.#place(view, event, reach.touch), longPress);
    }
  }

  #place(view: View, event: PointerEvent, within: number): void {
    const hit = view.pick(event);
    if (hit && hit.pixels <= within * 2.5) placeOrSelect(this.#app, hit.vertex);
    this.#forget();
  }

  #move(view: View, event: PointerEvent): void {
    const down = this.#down;
    if (down && event.buttons !== 0) {
      const far = Math.hypot(event.clientX - down.x, event.clientY - down.y) > clickMoves;
      if (far) {
        clearTimeout(this.#timer);
        down.isDrag = true;
      }
      if (down.isDrag && down.cone >= 0) {
        const hit = view.pick(event);
        if (hit) moveCone(this.#app, down.cone, hit.vertex, String(down.time));
        if (this.#app.selected !== down.cone) select(this.#app, down.cone);
      }
      return;
    }
    if (this.#hoverPending || event.pointerType === 'touch') return;
    this.#hoverPending = true;
    requestAnimationFrame(() => {
      this.#hoverPending = false;
      this.#hover(view, event);
    });
  }

  #release(view: View, event: PointerEvent): void {
    const down = this.#down;
    clearTimeout(this.#timer);
    this.#forget();
    if (!down || down.isDrag || down.view !== view) return;
    if (down.cone >= 0) return select(this.#app, down.cone);
    if (this.#ui.tool !== 'place' || event.pointerType === 'touch') {
      if (this.#app.selected >= 0) select(this.#app, -1);
      return;
    }
    // In a coarse triangle no vertex is near: the nearest of the three is meant all the same.
    const hit = view.pick(event);
    if (hit) placeOrSelect(this.#app, hit.vertex);
  }

  /** The cone that is being dragged, to where it was. */
  #putBack(): boolean {
    const down = this.#down;
    if (!down?.isDrag || down.cone < 0) return false;
    this.#forget();
    const isMoved = this.#app.asked.cones[down.cone]?.vertex !== down.from;
    if (isMoved) undo(this.#app);
    return true;
  }

  #forget(): void {
    clearTimeout(this.#timer);
    this.#down = undefined;
    if (this.#ui.surfaceView) this.#ui.surfaceView.orbit.controls.enabled = true;
    if (this.#ui.mapView) this.#ui.mapView.isPanning = true;
  }

  #leave(): void {
    if (this.#ui.hover === '') return;
    this.#ui.setHover('');
    this.#ui.surfaceView?.highlight([]);
    this.#ui.mapView?.highlight([]);
    if (this.#ui.tool === 'place') this.#ui.surfaceView?.setCursor(-1);
  }

  /** The same triangle in both views; the twin of a seam; what a click would place. */
  #hover(view: View, event: PointerEvent): void {
    const { surface, current } = this.#app;
    if (!surface || this.#app.phase === 'running') return;
    const hit = view.pick(event);
    if (!hit) return this.#leave();
    const edges: [number, number][] = [];
    const uvEdges: [number, number][] = [];
    let text = this.#textOf(hit.vertex);
    const seam = this.#seamOf(hit);
    if (seam !== undefined && current) {
      const { a, b, r } = current.seams[seam];
      const { uv, uvToVertex } = current.result;
      edges.push([uvToVertex[a[0]], uvToVertex[a[1]]]);
      uvEdges.push(a, b);
      text = `Seam: turns by ${r}·360°/${current.asked.q} = ${((360 * r) / current.asked.q).toFixed(0)}°, shifts by ${shift(uv, a, b, r, current.asked.q)}`;
    }
    if (this.#ui.tool === 'place') this.#ui.surfaceView!.setCursor(hit.vertex);
    this.#ui.surfaceView!.highlight([hit.triangle], edges);
    this.#ui.mapView!.highlight([hit.triangle], uvEdges);
    this.#ui.setHover(text);
  }

  #seamOf(hit: Hit): number | undefined {
    const { current, surface } = this.#app;
    if (!current || !surface || !this.#app.look.hasSeams) return undefined;
    const [x, y, z] = surface.triangles.subarray(3 * hit.triangle, 3 * hit.triangle + 3);
    for (const [v, w] of [
      [x, y],
      [y, z],
      [z, x],
    ]) {
      const seam = current.seamAt.get(Math.min(v, w) * surface.vertexCount + Math.max(v, w));
      if (seam !== undefined) return seam;
    }
    return undefined;
  }

  #textOf(vertex: number): string {
    const surface = this.#app.surface!;
    const cone = this.#app.asked.cones.findIndex((one) => one.vertex === vertex);
    const at = cone >= 0 ? `Cone ${cone + 1} · v` : 'v';
    const degrees = defectDegrees(surface, vertex).toFixed(0).replace('-', '−');
    return `${at} ${vertex} · valence ${surface.valence[vertex]} · curvature ${degrees}°`;
  }
}

/** b = turn(a) + t: the translation t. */
function shift(
  uv: Float64Array,
  [a]: [number, number],
  [b]: [number, number],
  r: number,
  q: number,
): string {
  const turn = (2 * Math.PI * r) / q;
  const [x, y] = [uv[2 * a], uv[2 * a + 1]];
  const dx = uv[2 * b] - (x * Math.cos(turn) - y * Math.sin(turn));
  const dy = uv[2 * b + 1] - (x * Math.sin(turn) + y * Math.cos(turn));
  return `(${dx.toPrecision(3)}, ${dy.toPrecision(3)})`;
}
