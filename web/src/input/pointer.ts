// Mouse, pen and touch on the two views: placing, selecting and dragging cones, and hovering.

import { attempt, type AppView } from '../actions/app';
import { beginLive, cancelLive, dragLive, dropLive, pointAtCone } from '../actions/drag_live';
import { coneToPlace, moveCone, select } from '../actions/edit_cones';
import { chooseChain } from '../actions/features';
import { edgeMap } from '../actions/keep_features';
import { switchMesh } from '../actions/load';
import { placeOnAny } from '../actions/repair';
import { undo } from '../actions/undo';
import { clearHighlight } from '../actions/view';
import { isAligned } from '../model/grid';
import { cornerNear } from '../model/snapping';
import { defectDegrees, scaleAt } from '../model/surface';
import type { Surface } from '../model/types';
import { timesText, wholeDegrees } from '../text/format';
import type { Hit } from '../views/canvas_view';
import type { ModelView } from '../views/model_view';
import { edgeUnder } from '../views/nearest_side';
import type { UvView } from '../views/uv_view';

const reach = { mouse: 12, pen: 16, touch: 24 } as const;
const markerReach = { mouse: 18, pen: 22, touch: 28 } as const;
const clickMoves = 4; // pixels: a longer movement orbits
const longPress = 400; // milliseconds

type View = ModelView | UvView;

export class Pointer {
  readonly #app: AppView;
  readonly #model: ModelView;
  readonly #uv: UvView;
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

  constructor(app: AppView, model: ModelView, uv: UvView) {
    this.#app = app;
    this.#model = model;
    this.#uv = uv;
    app.ui.stopDrag = () => this.#putBack();
    for (const view of [model, uv]) {
      const { canvas } = view;
      // Handled before the orbit controls, so that dragging a cone does not turn the model.
      canvas.addEventListener('pointerdown', (event) => this.#press(view, event), {
        capture: true,
      });
      canvas.addEventListener('pointermove', (event) => this.#move(view, event));
      canvas.addEventListener('pointerup', (event) => this.#release(view, event));
      canvas.addEventListener('pointercancel', () => this.#forget());
      canvas.addEventListener('pointerleave', () => this.#leave());
      // An alternative to dragging for turning and moving the view.
      canvas.addEventListener('dblclick', (event) => {
        if (app.ui.tool === 'orbit') view.centre(event);
      });
    }
  }

  #coneNear(view: View, event: PointerEvent, front = view.pick(event)): number {
    const surfaceView = this.#model;
    const { cones } = this.#app.doc.prescription;
    const within = markerReach[event.pointerType as keyof typeof markerReach] ?? markerReach.mouse;
    if (view !== surfaceView) {
      return front && front.pixels < within
        ? cones.findIndex(({ vertex }) => vertex === front.vertex)
        : -1;
    }
    const box = view.canvas.getBoundingClientRect();
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
    const surfaceView = this.#model;
    const { position } = surfaceView.camera;
    const slack = 0.03 * this.#surface!.diagonal;
    const far = surfaceView.point(vertex).distanceTo(position);
    return far > surfaceView.point(front.vertex).distanceTo(position) + slack;
  }

  #press(view: View, event: PointerEvent): void {
    view.canvas.focus({ preventScroll: true });
    if (!event.isPrimary || event.button !== 0 || !this.#surface) return this.#forget();
    const cone = this.#app.doc.usableModel ? this.#coneNear(view, event) : -1;
    const { clientX: x, clientY: y } = event;
    const from = this.#app.doc.prescription.cones[cone]?.vertex;
    this.#down = { x, y, view, cone, from, time: performance.now(), isDrag: false };
    if (cone >= 0) void attempt(this.#app, () => beginLive(this.#app, cone));
    if (cone >= 0) {
      const { controls } = view === this.#model ? this.#model.orbit : this.#uv;
      controls.enabled = false;
      view.canvas.setPointerCapture(event.pointerId); // the release is seen wherever it is
    }
    if (event.pointerType === 'touch') {
      this.#timer = setTimeout(() => this.#place(view, event, reach.touch), longPress);
    }
  }

  #place(view: View, event: PointerEvent, within: number): void {
    const hit = view.pick(event);
    if (hit && hit.pixels <= within * 2.5) this.#placeAt(this.#snapped(view, hit, event));
    this.#forget();
  }

  #move(view: View, event: PointerEvent): void {
    const down = this.#down;
    if (down && event.buttons !== 0) {
      const far = Math.hypot(event.clientX - down.x, event.clientY - down.y) > clickMoves;
      if (far) {
        clearTimeout(this.#timer);
        if (!down.isDrag && down.cone >= 0) this.#leave();
        down.isDrag = true;
      }
      if (down.isDrag && down.cone >= 0) {
        const hit = view.pick(event);
        if (hit) {
          void attempt(this.#app, () => {
            moveCone(this.#app, down.cone, hit.vertex, String(down.time));
            dragLive(this.#app);
          });
        }
        if (this.#app.doc.selected !== down.cone) select(this.#app, down.cone);
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
    if (down && down.cone >= 0) {
      this.#down = undefined;
      void attempt(this.#app, () => dropLive(this.#app, `move cone: ${down.time}`));
    }
    this.#forget();
    if (!down || down.isDrag || down.view !== view) return;
    if (down.cone >= 0) return select(this.#app, down.cone);
    if (this.#chooseMesh(view, event)) return;
    if (this.#chooseEdge(view, event)) return;
    if (this.#app.ui.tool !== 'place') {
      if (this.#app.doc.selected >= 0) select(this.#app, -1);
      return;
    }
    // In a large triangle no vertex is near the pointer; the nearest of the three is taken.
    const hit = view.pick(event);
    if (hit) this.#placeAt(this.#snapped(view, hit, event));
  }

  /** With the tool for edges, a click on the surface chooses a chain, or with Alt takes it out. */
  #chooseEdge(view: View, event: PointerEvent): boolean {
    if (this.#app.ui.tool !== 'edges' || view !== this.#model || !this.#surface) return false;
    const edge = edgeUnder(this.#model, this.#surface, event);
    if (edge) void attempt(this.#app, () => chooseChain(this.#app, edge, event.altKey));
    return true;
  }

  /** A click on another mesh of the file opens it. */
  #chooseMesh(view: View, event: PointerEvent): boolean {
    const mesh = view === this.#model && !this.#app.doc.isBusy ? this.#model.pickPart(event) : -1;
    if (mesh < 0 || mesh === this.#app.doc.model?.info.surface) return false;
    this.#leave();
    void attempt(this.#app, () => switchMesh(this.#app, mesh));
    return true;
  }

  /** Shows which mesh a click would open; whether there is one. */
  #pointAtMesh(view: View, event: PointerEvent): boolean {
    const { doc, ui } = this.#app;
    const mesh = view === this.#model ? this.#model.pickPart(event) : -1;
    const isOther = mesh >= 0 && mesh !== doc.model?.info.surface;
    this.#model.pointAt(isOther ? mesh : -1);
    if (!isOther) return false;
    this.#leave();
    this.#model.pointAt(mesh);
    ui.hover = `${doc.model?.info.surfaces[mesh]?.name || `Mesh ${mesh}`}: click to work on it`;
    return true;
  }

  /** Returns the cone that is being dragged to its original vertex. */
  #putBack(): boolean {
    const down = this.#down;
    if (!down?.isDrag || down.cone < 0) return false;
    this.#forget();
    const isMoved = this.#app.doc.prescription.cones[down.cone]?.vertex !== down.from;
    if (isMoved) void attempt(this.#app, () => undo(this.#app));
    return true;
  }

  #forget(): void {
    clearTimeout(this.#timer);
    if (this.#down && this.#down.cone >= 0) cancelLive(this.#app);
    this.#down = undefined;
    this.#model.orbit.controls.enabled = true;
    this.#uv.controls.enabled = true;
  }

  #leave(): void {
    const { ui } = this.#app;
    this.#model.pointAt(-1);
    pointAtCone(this.#app, -1);
    if (ui.hover === '') return;
    ui.hover = '';
    clearHighlight(this.#app);
    this.#model.setGhost(undefined);
  }

  /** The corner or tip near the pointer, else the nearest vertex; with Alt always that one. */
  #snapped(view: View, { vertex }: Hit, event: PointerEvent): number {
    const surface = this.#surface;
    if (!surface || view !== this.#model || event.altKey) return vertex;
    const box = view.canvas.getBoundingClientRect();
    const [x, y] = [event.clientX - box.left, event.clientY - box.top];
    const within = reach[event.pointerType as keyof typeof reach] ?? reach.mouse;
    return cornerNear(surface, vertex, (v) => {
      const at = this.#model.toScreen(v);
      return Math.hypot(at.x - x, at.y - y) < within;
    });
  }

  #placeAt(vertex: number): void {
    this.#model.setGhost(undefined);
    void attempt(this.#app, () => placeOnAny(this.#app, vertex));
  }

  /** Shows the hovered triangle in both views, the other side of a seam, and the cone that a click would place. */
  #hover(view: View, event: PointerEvent): void {
    const { doc, ui } = this.#app;
    const surface = this.#surface;
    if (!surface || doc.isBusy) return;
    if (this.#pointAtMesh(view, event)) return;
    const hit = view.pick(event);
    if (!hit) return this.#leave();
    pointAtCone(this.#app, this.#coneNear(view, event, hit));
    const seam = this.#seamOf(hit);
    const { current } = doc;
    const ends = seam === undefined || !current ? undefined : current.seams[seam];
    const edges = ends ? [ends.a.map((end) => current!.result.uvToVertex[end])] : [];
    const isPlacing = ui.tool === 'place' && view === this.#model;
    const cone = isPlacing ? coneToPlace(this.#app, this.#snapped(view, hit, event)) : undefined;
    const isTaken = doc.prescription.cones.some(({ vertex }) => vertex === cone?.vertex);
    this.#model.setGhost(isTaken ? undefined : cone, doc.prescription.q);
    const isOutlined = !isPlacing && !this.#outlineChain(view, event);
    if (ui.tool === 'edges' && view === this.#model) return;
    this.#model.highlight(isOutlined ? [hit.triangle] : [], edges as [number, number][]);
    this.#uv.highlight([hit.triangle], ends ? [ends.a, ends.b] : []);
    ui.hover = ends ? this.#seamText(seam!) : this.#vertexText(hit, surface);
  }

  /** Shows the chain that a click would choose. */
  #outlineChain(view: View, event: PointerEvent): boolean {
    if (this.#app.ui.tool !== 'edges' || view !== this.#model || !this.#surface) return false;
    const edge = edgeUnder(this.#model, this.#surface, event);
    const chain = edge && edgeMap(this.#app)?.chainThrough(edge);
    this.#model.highlight(
      [],
      (chain ?? []).map(([v, w]): [number, number] => [v, w]),
    );
    this.#app.ui.hover = chain ? `Click: lines follow these ${chain.length} edges` : '';
    return true;
  }

  get #surface(): Surface | undefined {
    return this.#app.doc.model?.surface;
  }

  #seamOf(hit: Hit): number | undefined {
    const { current, look } = this.#app.doc;
    const surface = this.#surface;
    if (!current || !surface || look.seams === 'off') return undefined;
    const [x, y, z] = surface.triangles.subarray(3 * hit.triangle, 3 * hit.triangle + 3);
    const { seamAt } = current;
    for (const [v, w] of [
      [x, y],
      [y, z],
      [z, x],
    ]) {
      const seam = seamAt.get(Math.min(v, w) * surface.vertexCount + Math.max(v, w));
      if (seam !== undefined) return seam;
    }
    return undefined;
  }

  #seamText(seam: number): string {
    const current = this.#app.doc.current!;
    const { seams, result, prescription } = current;
    const { a, b, r } = seams[seam];
    const { q } = prescription;
    const by = shiftAcross(result.uv, a, b, r, q) + (isAligned(current) ? ' cells' : '');
    return `Seam: turns by ${r}·360°/${q} = ${((360 * r) / q).toFixed(0)}°, shifts by ${by}`;
  }

  #vertexText({ vertex, triangle }: Hit, surface: Surface): string {
    const cone = this.#app.doc.prescription.cones.findIndex((one) => one.vertex === vertex);
    const at = cone >= 0 ? `Cone ${cone + 1} · v` : 'v';
    const degrees = wholeDegrees(defectDegrees(surface, vertex));
    return `${at} ${vertex} · valence ${surface.valence[vertex]} · curvature ${degrees}°${this.#sizeText(triangle, surface)}`;
  }

  /** The local scale of the map, relative to the typical one and absolute. */
  #sizeText(triangle: number, surface: Surface): string {
    const solution = this.#app.doc.displayed;
    if (!solution || solution.cornerUv.length !== 2 * surface.triangles.length) return '';
    const scale = scaleAt(surface, solution.cornerUv, triangle);
    if (!(scale > 0)) return '';
    const unit = isAligned(solution) ? 'cells' : 'uv';
    const larger = timesText(solution.sizes.typicalScale / scale);
    return ` · pattern ${larger} · ${Number(scale.toPrecision(3))} ${unit} per unit of length`;
  }
}

/** The translation t of a seam, b = R a + t. */
function shiftAcross(
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
  const isWhole = [dx, dy].every((x) => Math.abs(x - Math.round(x)) < 1e-9);
  const [x3, y3] = [dx, dy].map((n) => (isWhole ? String(Math.round(n)) : n.toPrecision(3)));
  return `(${x3}, ${y3})`.replaceAll('-', '−');
}
