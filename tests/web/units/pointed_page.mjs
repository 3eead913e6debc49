// The page with a cube open, as far as a pointer needs it: a document, both views on a graphics card that draws nothing,
// and events of pointers.

import { Vector3 } from 'three';
import { Pointer } from '../../../web/src/input/pointer.ts';
import { Document } from '../../../web/src/model/document.ts';
import { emptyPrescription } from '../../../web/src/model/prescription.ts';
import { ModelView } from '../../../web/src/views/model_view.ts';
import { UvView } from '../../../web/src/views/uv_view.ts';
import { Canvas } from './canvases.mjs';
import { cubeSolution, cubeSurface, look, mesh } from './cube_view.mjs';

export const surface = cubeSurface();
export const center = (t, places) => [0, 1].map((i) => [0, 1, 2].reduce((sum, k) => sum + places(3 * t + k)[i] / 3, 0)); // prettier-ignore

/** The page with the cube open, a pointer on both views, and these cones. */
export function opened({ rest, cones = [], hasMap = true, tool = 'place' }) {
  const doc = new Document();
  const components = [{ component: 0, eulerCharacteristic: 2, boundaryLoops: [] }];
  const info = { usable: true, genus: 0, components, file: { sha256: 'x', name: 'cube.obj' }, surface: 0, surfaces: [{}] }; // prettier-ignore
  doc.state = { kind: 'open', model: { main: 'cube.obj', files: new Map(), info, surface, solver: {}, loaded: doc.settings } }; // prettier-ignore
  const prescription = { ...emptyPrescription(4, 0, 0), cones };
  doc.begin(prescription);
  const solution = cubeSolution(surface, { prescription, ...doc.solve, settings: doc.settings });
  if (hasMap) doc.solutions = [solution];
  doc.look = { ...doc.look, ...look };
  const [model, uv] = [new ModelView(new Canvas(600, 400)), new UvView(new Canvas(600, 400))];
  model.setModel(surface, doc.displayed, { parts: [], isSameFile: false });
  uv.setModel(surface, doc.displayed);
  const ui = { tool, hover: '', holdsCone: false };
  const app = { doc, ui, views: { model, uv } };
  new Pointer(app, model, uv);
  rest();
  const settle = async () => {
    for (let i = 0; i < 5; i++) await new Promise((resolve) => setImmediate(resolve));
    rest();
  };
  const point = (view, type, place, more = {}) => {
    const event = new Event(type, { cancelable: true });
    const [clientX, clientY] = [20 + place[0], 10 + place[1]];
    const about = { clientX, clientY, pageX: clientX, pageY: clientY, pointerId: 1, isPrimary: true, pointerType: 'mouse', button: 0, buttons: 0, altKey: false, ...more }; // prettier-ignore
    for (const [key, value] of Object.entries(about)) Object.defineProperty(event, key, { value });
    view.canvas.dispatchEvent(event);
  };
  const click = async (view, place, more = {}) => {
    point(view, 'pointerdown', place, { buttons: 1, ...more });
    point(view, 'pointerup', place, more);
    await settle();
  };
  const hover = async (view, place, more = {}) => {
    point(view, 'pointermove', place, more);
    await settle();
  };
  return { app, doc, ui, model, uv, point, click, hover, settle, solution };
}

/** Where a vertex is in the 3D view. */
export const onModel = ({ model }, v) => {
  model.camera.updateMatrixWorld(true);
  return Object.values(model.toScreen(v));
};
/** Where a point of the map is in the UV view. */
export const inMap = ({ uv }, [x, y]) => {
  uv.camera.updateMatrixWorld(true);
  const at = new Vector3(x, y, 0).project(uv.camera);
  return [300 * (at.x + 1), 200 * (1 - at.y)];
};
/** A place in the map at which a vertex is the nearest: inside of a triangle around it. */
export const besideInMap = (page, v) => {
  const corner = (c) => uvOf(page, page.solution.result.cornerToUv[c]);
  const c = mesh.triangles.flat().indexOf(v);
  const [at, middle] = [corner(c), center(Math.floor(c / 3), corner)];
  return inMap(page, [0, 1].map((i) => 0.9 * at[i] + 0.1 * middle[i])); // prettier-ignore
};
export const uvOf = ({ solution }, end) => [...solution.result.uv.subarray(2 * end, 2 * end + 2)];
/** How much the triangles around a vertex are turned towards the camera, −1 to 1: the least and the most. */
export function facingOf({ model }, v) {
  const all = mesh.triangles
    .filter((t) => t.includes(v))
    .map((t) => {
      const [a, b, c] = t.map((w) => new Vector3(...mesh.vertices[w]));
      const normal = b.clone().sub(a).cross(c.clone().sub(a)).normalize();
      return normal.dot(model.camera.position.clone().sub(a).normalize());
    });
  return [Math.min(...all), Math.max(...all)];
}
export const isInFront = (page, v) => facingOf(page, v)[0] > 0.1;
