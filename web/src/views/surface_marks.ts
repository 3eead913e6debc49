// Everything that is drawn on the surface with lines: seams, crosses, wireframe, loops around handles, the keyboard's
// cursor and what is outlined.

import { type BufferGeometry, Color, Group, type Vector3 } from 'three';
import { areSeamsShown } from '../model/grid';
import type { Look, Solution, Surface } from '../model/types';
import { Lines, seamsOnSurface, Wire } from './lines';
import type { Palette } from './pattern_material';
import { chainColour, ticksOnSurface } from './seam_marks';

const highlightColour = new Color('#ff2d95');
const featureColour = new Color('#e0452f');
const maxOutlined = 2000; // triangles

type Point = [number, number, number];

export const placeOf = ({ places }: Surface, v: number): Point => [
  places[3 * v],
  places[3 * v + 1],
  places[3 * v + 2],
];

export class SurfaceMarks extends Group {
  readonly #seams = new Lines(3.5, { order: 3, bias: 2 });
  readonly #ticks = new Lines(2.5, { order: 3, bias: 2 });
  readonly #handles = new Lines(4, { order: 4, bias: 2 });
  readonly #features = new Lines(4, { order: 3, bias: 2 });
  readonly #crosses = new Lines(2, { order: 1, bias: 1 });
  readonly #wire = new Wire(1, true);
  readonly #light = new Lines(4.5, { order: 6, depth: false });
  readonly #cursor = new Lines(3, { order: 7, depth: false });
  /** Lines that belong to the map, which the state before does not show. */
  readonly ofMap = [this.#seams, this.#ticks, this.#crosses];

  constructor() {
    super();
    this.add(this.#wire, this.#crosses, this.#features, this.#seams, this.#ticks, this.#handles);
    this.add(this.#light, this.#cursor);
  }

  /** Draws lines nearer to the eye, so that the surface does not cover them. */
  lift(eye: Vector3, by: number): void {
    for (const lines of [...this.ofMap, this.#wire, this.#features, this.#handles])
      lines.lift(eye, by);
  }

  /** Hides what belongs to an earlier map or, if it is new, to another surface. */
  hide(isNewSurface: boolean): void {
    for (const lines of [...this.ofMap, this.#wire, this.#light]) lines.visible = false;
    if (!isNewSurface) return;
    this.#wire.forget();
    this.#cursor.visible = this.#handles.visible = this.#features.visible = false;
  }

  setLook(
    look: Look,
    palette: Palette,
    { surface, solution, geometry }: { surface?: Surface; solution?: Solution; geometry: BufferGeometry }, // prettier-ignore
  ): void {
    this.#crosses.visible &&= look.pattern === 'cross';
    this.#seams.visible = this.#ticks.visible = this.#wire.visible = false;
    if (surface && solution && areSeamsShown(look, solution)) {
      const { points, colours } = seamsOnSurface(surface, solution);
      this.#seams.set(points, colours);
      const ticks = ticksOnSurface(surface, solution);
      this.#ticks.set(ticks.points, ticks.colours);
    }
    if (surface && look.hasWire) this.#wire.set(geometry, palette.ink);
  }

  setCrosses(points: Float32Array, palette: Palette): void {
    this.#crosses.set(points, palette.ink);
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
  }

  /** Shows edges that lines of the map follow. */
  setFeatures(surface: Surface | undefined, edges: readonly (readonly [number, number])[]): void {
    const points = surface
      ? edges.flatMap(([v, w]) => [...placeOf(surface, v), ...placeOf(surface, w)])
      : [];
    this.#features.set(points, featureColour);
  }

  /** Shows the vertex of the keyboard cursor by the edges of its one-ring. */
  setCursor(surface: Surface | undefined, vertex: number): void {
    const points: number[] = [];
    if (surface && vertex >= 0) {
      const at = placeOf(surface, vertex);
      for (let n = surface.neighbourStart[vertex]; n < surface.neighbourStart[vertex + 1]; n++) {
        const to = placeOf(surface, surface.neighbours[n]);
        points.push(...at, ...to.map((x, i) => x + 0.4 * (at[i] - x)));
      }
    }
    this.#cursor.set(points, highlightColour);
  }

  /** Outlines triangles, and edges given by two vertices; returns whether anything has changed. */
  highlight(surface: Surface | undefined, triangles: number[], edges: [number, number][]): boolean {
    if (!surface || triangles.length + edges.length === 0) {
      const wasVisible = this.#light.visible;
      this.#light.visible = false;
      return wasVisible;
    }
    const points: number[] = [];
    const add = (v: number, w: number): void => {
      points.push(...placeOf(surface, v), ...placeOf(surface, w));
    };
    for (const t of triangles.slice(0, maxOutlined)) {
      const [a, b, c] = surface.triangles.subarray(3 * t, 3 * t + 3);
      if (c === undefined) continue;
      add(a, b);
      add(b, c);
      add(c, a);
    }
    for (const [v, w] of edges) add(v, w);
    this.#light.set(points, highlightColour);
    return true;
  }
}
