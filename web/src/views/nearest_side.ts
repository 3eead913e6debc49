// The side of a triangle that is nearest to a point of the screen.

import type { Surface } from '../model/types';
import type { ModelView } from './model_view';

interface Point {
  x: number;
  y: number;
}

function distanceTo(p: Point, a: Point, b: Point): number {
  const [dx, dy] = [b.x - a.x, b.y - a.y];
  const t = ((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy || 1);
  const s = Math.min(1, Math.max(0, t));
  return Math.hypot(p.x - a.x - s * dx, p.y - a.y - s * dy);
}

function nearestSide(
  { triangles }: Surface,
  triangle: number,
  pointer: Point,
  toScreen: (vertex: number) => Point,
): [number, number] {
  const corners = [...triangles.subarray(3 * triangle, 3 * triangle + 3)];
  const sides = corners.map((v, k): [number, number] => [v, corners[(k + 1) % 3]]);
  const far = sides.map(([v, w]) => distanceTo(pointer, toScreen(v), toScreen(w)));
  return sides[far.indexOf(Math.min(...far))];
}

/** The edge of the front triangle under a pointer that is nearest to it. */
export function edgeUnder(
  view: ModelView,
  surface: Surface,
  event: { clientX: number; clientY: number },
): [number, number] | undefined {
  const hit = view.pick(event);
  const { left, top } = view.canvas.getBoundingClientRect();
  const pointer = { x: event.clientX - left, y: event.clientY - top };
  return hit && nearestSide(surface, hit.triangle, pointer, (v) => view.toScreen(v));
}
