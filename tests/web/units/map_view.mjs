// The UV view with the map of a cube in six charts, as its laws look at it.

import assert from 'node:assert/strict';
import { Color, Vector3 } from 'three';
import { UvView } from '../../../web/src/views/uv_view.ts';
import { Canvas } from './canvases.mjs';
import { cubeSolution, cubeSurface, look } from './cube_view.mjs';

export const surface = cubeSurface();
export const solution = cubeSolution(surface);
export const palette = {
  paper: new Color('#eee'),
  ink: new Color('#123'),
  second: new Color('#fa0'),
};
export const near = (a, b, what, within = 1e-4) => assert.ok(Math.abs(a - b) <= within * Math.max(1, Math.abs(b)), `${what}: ${a} and ${b}`); // prettier-ignore

/** A view of the map, with its lines and markers by name. */
export function viewOf(rest, { size = [600, 400], of = solution } = {}) {
  const canvas = new Canvas(...size);
  const view = new UvView(canvas);
  view.setModel(surface, of);
  view.setLook(look, 4, false, palette);
  const drawn = () => (view.draw(), rest());
  drawn();
  const [square, mapped, wire, crosses, seams, ticks, light, markers] = view.scene.children;
  return { view, canvas, drawn, square, mapped, wire, crosses, seams, ticks, light, markers };
}

/** Where a point of the map is in the window. */
export function inWindow({ camera, canvas }, x, y) {
  camera.updateMatrixWorld(true);
  const at = new Vector3(x, y, 0).project(camera);
  const { left, top, width, height } = canvas.getBoundingClientRect();
  return { clientX: left + ((at.x + 1) / 2) * width, clientY: top + ((1 - at.y) / 2) * height };
}
/** The ends of the picture in the map: left, right, bottom, top. */
export function ends({ camera }) {
  camera.updateMatrixWorld(true);
  const [low, high] = [-1, 1].map((x) => new Vector3(x, x, 0).unproject(camera));
  return [low.x, high.x, low.y, high.y];
}
/** The segments that lines draw, by their ends. */
export const segments = ({ geometry }) => {
  const [from, to] = ['from', 'to'].map((name) => geometry.getAttribute(name).array);
  return Array.from({ length: from.length / 12 }, (_, s) => [from, to].map((one) => [...one.subarray(12 * s, 12 * s + 2)])); // prettier-ignore
};
