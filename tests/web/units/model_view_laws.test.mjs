// Laws of the 3D view: what is under a pointer, what is shown of a surface and its map, before and after side by side.
// The surface is a rounded cube; the graphics card is a stand-in.

import assert from 'node:assert/strict';
import test from 'node:test';
import { BufferAttribute, BufferGeometry, Color, Group, Matrix4, Mesh, Vector3 } from 'three'; // prettier-ignore
import { MeshBVH } from 'three-mesh-bvh';
import { randomFrom } from '../../mutation/draw.mjs';
import { ModelView } from '../../../web/src/views/model_view.ts';
import { UvView } from '../../../web/src/views/uv_view.ts';
import { Canvas, drawsIn, withCanvases } from './canvases.mjs';
import { cubeSolution, cubeSurface, look, mesh } from './cube_view.mjs';

const surface = cubeSurface();
const solution = cubeSolution(surface);
const palette = { paper: new Color('#eee'), ink: new Color('#123'), second: new Color('#fa0') };
const near = (a, b, what, within = 1e-4) => assert.ok(Math.abs(a - b) <= within * Math.max(1, Math.abs(b)), `${what}: ${a} and ${b}`); // prettier-ignore
const alone = { parts: [], isSameFile: false };
const cones = [{ vertex: 0, k: 3 }, { vertex: 30, k: 5 }]; // prettier-ignore
const prescription = { q: 4, cones, turnings: [], handles: [] };

/** A view of the cube, with what is in its scene by name. */
function viewOf(rest, { of = solution, size = [600, 400] } = {}) {
  const canvas = new Canvas(...size);
  const view = new ModelView(canvas);
  view.setModel(surface, of, alone);
  view.setLook(look, 4, false, palette);
  rest();
  canvas.taken();
  const [mapped, , , , marks, markers, ghost] = view.scene.children;
  return { view, canvas, mapped, marks, markers, ghost };
}
/** A place of the view in the window. */
const inWindow = ({ x, y }) => ({ clientX: 20 + x, clientY: 10 + y });
const place = (v) => new Vector3(...mesh.vertices[v]);
const placesOf = (markers) => {
  const { array, count } = markers.children[0].geometry.getAttribute('position');
  return Array.from({ length: count / 4 }, (_, m) => [...array.subarray(12 * m, 12 * m + 3)]);
};

test('a view that has no model yet shows nothing of one, and draws nothing but its ground', () =>
  withCanvases(({ rest }) => {
    for (const View of [ModelView, UvView]) {
      const canvas = new Canvas(600, 400);
      const { scene } = new View(canvas);
      rest();
      assert.equal(drawsIn(canvas.taken()), 0, View.name);
      const own = scene.children.filter(({ isMesh, isLine }) => isMesh || isLine);
      assert.ok(own.length > 0);
      assert.deepEqual(own.filter(({ visible }) => visible), [], View.name); // prettier-ignore
    }
  }));

test('a pointer finds the front triangle and its nearest corner, wherever the camera is', () =>
  withCanvases(({ rest }) => {
    const random = randomFrom(9);
    const { view } = viewOf(rest);
    let found = 0;
    for (let i = 0; i < 150; i++) {
      if (i % 30 === 0) view.orbit.move(6 * random(), 2 * random() - 1, 0.8 + 0.4 * random());
      view.camera.updateMatrixWorld(true);
      const t = Math.floor(random() * mesh.triangles.length);
      const corners = mesh.triangles[t];
      const weights = [0, 1, 2].map(() => 0.1 + random());
      const point = new Vector3();
      corners.forEach((v, k) => point.addScaledVector(place(v), weights[k] / (weights[0] + weights[1] + weights[2]))); // prettier-ignore
      const at = point.clone().project(view.camera);
      const pixel = { x: ((at.x + 1) / 2) * 600, y: ((1 - at.y) / 2) * 400 };
      const hit = view.pick(inWindow(pixel));
      const [a, b, c] = corners.map(place);
      const normal = b.clone().sub(a).cross(c.clone().sub(a));
      const facing = normal.normalize().dot(view.camera.position.clone().sub(point).normalize());
      if (facing <= 0) assert.ok(hit?.triangle !== t, 'the back of a closed surface is never in front'); // prettier-ignore
      if (facing < 0.3) continue;
      found += 1;
      assert.equal(hit.triangle, t);
      const far = corners.map((v) => {
        const { x, y } = view.toScreen(v);
        return Math.hypot(x - pixel.x, y - pixel.y);
      });
      near(hit.pixels, Math.min(...far), 'distance');
      assert.equal(hit.vertex, corners[far.indexOf(Math.min(...far))]);
    }
    assert.ok(found > 30, `${found} in front`);
    assert.equal(view.pick(inWindow({ x: 1, y: 1 })), undefined, 'beside the model');
    for (const v of [0, 9, 30]) {
      const { x, y } = view.pointer(inWindow(view.toScreen(v)));
      const at = view.point(v).project(view.camera);
      near(x, at.x, 'there and back');
      near(y, at.y, 'there and back');
    }
    view.setModel(undefined, undefined, alone);
    assert.equal(view.pick(inWindow({ x: 300, y: 200 })), undefined);
  }));

test('what another mesh of the file hides has no vertex for a pointer, which mesh it may be; the one that is in front is found', () =>
  withCanvases(({ rest }) => {
    const { view } = viewOf(rest);
    view.camera.updateMatrixWorld(true);
    const middle = inWindow({ x: 300, y: 200 });
    const free = view.pick(middle);
    assert.ok(free);
    // A triangle around the middle of the picture, this part of the way from the eye to the model.
    const facing = (mesh, part, isPlaced = true) => {
      const to = view.camera.matrixWorld.clone().multiply(new Matrix4().makeTranslation(0, 0, -part * view.camera.position.length())); // prettier-ignore
      const cornerPositions = Float32Array.of(-1, -1, 0, 1, -1, 0, 0, 1, 0);
      const geometry = new BufferGeometry().setAttribute('position', new BufferAttribute(cornerPositions, 3)); // prettier-ignore
      const tree = MeshBVH.serialize(new MeshBVH(geometry, { indirect: true }));
      return { mesh, isPlaced, cornerPositions, cornerNormals: new Int8Array(12), tree, matrices: [to.elements] }; // prettier-ignore
    };
    const show = (...parts) => view.setScene({ parts, open: 7, maps: new Map(), isOwnShown: false, palette }); // prettier-ignore
    for (const mesh of [0, 1, 2, 6]) {
      show(facing(mesh, 0.3));
      assert.deepEqual([view.pick(middle), view.pickPart(middle)], [undefined, mesh]);
      for (const one of [facing(mesh, 3), facing(mesh, 0.3, false), facing(7, 0.3)]) {
        show(one);
        assert.deepEqual([view.pick(middle), view.pickPart(middle)], [free, -1], `mesh ${one.mesh}`); // prettier-ignore
      }
      show(facing(mesh, 0.4), facing(mesh + 1, 0.3), facing(mesh + 2, 0.5));
      assert.equal(view.pickPart(middle), mesh + 1 === 7 ? mesh : mesh + 1, 'the nearest');
    }
  }));

test('a double click brings what is under it into the middle, and beside the model does nothing', () =>
  withCanvases(({ rest }) => {
    const { view } = viewOf(rest);
    const hit = view.pick(inWindow({ x: 330, y: 180 }));
    view.centre(inWindow({ x: 330, y: 180 }));
    near(view.orbit.controls.target.distanceTo(place(hit.vertex)), 0, 'in the middle', 1e-6);
    const before = view.orbit.toText();
    view.centre(inWindow({ x: 1, y: 1 }));
    assert.equal(view.orbit.toText(), before);
    view.orbit.reset();
    const target = view.orbit.controls.target.clone();
    view.lookAt(0, false);
    near(view.orbit.controls.target.distanceTo(target), 0, 'it is well in view already', 1e-6);
  }));

test('cones are marked at their vertices; what the surface does not have is not', () =>
  withCanvases(({ rest }) => {
    const { view, markers, ghost, canvas } = viewOf(rest);
    view.setCones({ ...prescription, cones: [...cones, { vertex: 10 ** 4, k: 3 }, { vertex: surface.vertexCount, k: 3 }] }, [], 1); // prettier-ignore
    assert.deepEqual(placesOf(markers), cones.map(({ vertex }) => mesh.vertices[vertex].map(Math.fround))); // prettier-ignore
    const sizes = markers.children[0].geometry.getAttribute('look').array;
    assert.ok(sizes[2] === 1 && sizes[14] > 1, 'the selected one is larger');
    const style = () => markers.children.at(-1).material.uniforms;
    const [size, opacity] = [style().pixels.value, style().opacity.value];
    view.setMarkers(true);
    assert.ok(style().pixels.value < size && style().opacity.value < opacity, 'after a run');
    view.setMarkers(false);
    assert.deepEqual([style().pixels.value, style().opacity.value], [size, opacity]);
    rest();
    view.setGhost(undefined);
    assert.equal(rest(), 0, 'there was none');
    view.setGhost({ vertex: 5, k: 3 }, 4);
    const grown = ghost.children[0].material.uniforms.pixels.value / size;
    assert.ok(grown > 0.5 && grown < 2, `${grown} times as large as a cone`);
    assert.equal(ghost.children[0].geometry.getAttribute('look').array[2], 1, 'not selected');
    assert.deepEqual([placesOf(ghost).length, ghost.visible, canvas.dataset.ghost], [1, true, '3']);
    assert.equal(rest(), 1);
    view.setGhost(undefined);
    assert.deepEqual([ghost.visible, canvas.dataset.ghost, rest()], [false, '', 1]);
    view.setGhost({ vertex: 5, k: 3 }, 4);
    view.setModel(cubeSurface(2), undefined, alone);
    assert.equal(ghost.visible, false, 'not on another surface');
    view.setModel(undefined, undefined, alone);
    assert.equal(markers.visible && markers.children[0].geometry.index?.count > 0, false);
  }));

test('another map of a surface keeps camera, cursor and what the card has; another surface does not', () =>
  withCanvases(({ rest }) => {
    const { view, mapped, marks } = viewOf(rest);
    const [wire, , , seams, , handles, light, cursor] = marks.children;
    view.orbit.move(0.4, 0.1);
    const before = view.orbit.toText();
    const position = mapped.geometry.getAttribute('position');
    const show = (surface, solution, about = alone) => view.setModel(surface, solution, about);
    const mark = () => {
      view.setCursor(3);
      view.setHandles([new Float32Array(6)]);
      view.highlight([1]);
      view.setLook({ ...look, hasWire: true }, 4, false, palette);
    };
    const seen = () => [wire, seams, handles, light, cursor].map((one) => one.visible);
    mark();
    assert.deepEqual(seen(), [true, true, true, true, true]);
    show(surface, solution);
    assert.deepEqual(seen(), [true, true, true, true, true], 'nothing has changed');
    const other = cubeSolution(surface);
    show(surface, other);
    assert.equal(view.orbit.toText(), before);
    assert.equal(mapped.geometry.getAttribute('position'), position);
    assert.equal(mapped.geometry.getAttribute('uv').array, other.cornerUv);
    assert.deepEqual(seen(), [false, false, true, false, true], 'of the map before');
    mark();
    show(cubeSurface(3), undefined);
    assert.deepEqual(seen(), [false, false, false, false, false]);
    assert.notEqual(mapped.geometry.getAttribute('position'), position);
    assert.equal(mapped.geometry.getAttribute('uv'), undefined);
    assert.notEqual(view.orbit.toText(), before, 'framed');
    view.orbit.move(0.4, 0.1);
    const moved = view.orbit.toText();
    show(cubeSurface(4), undefined, { parts: [], isSameFile: true });
    assert.equal(view.orbit.toText(), moved, 'another mesh of the same file');
    assert.equal(mapped.visible, true);
    show(undefined, undefined);
    assert.equal(mapped.visible, false);
  }));

test('a new file is framed whole, and fitting then shows the open mesh alone', () =>
  withCanvases(({ rest }) => {
    const view = new ModelView(new Canvas(600, 400));
    const cornerPositions = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0);
    const geometry = new BufferGeometry().setAttribute('position', new BufferAttribute(cornerPositions, 3)); // prettier-ignore
    const tree = MeshBVH.serialize(new MeshBVH(geometry, { indirect: true }));
    const at = (x) => ({ mesh: 1, isPlaced: true, cornerPositions, cornerNormals: new Int8Array(12), tree, matrices: [new Matrix4().makeTranslation(x, 0, 0).elements] }); // prettier-ignore
    view.setModel(surface, undefined, { parts: [at(-30), at(50)], isSameFile: false });
    rest();
    const seen = () => [view.orbit.controls.target.x, view.camera.position.distanceTo(view.orbit.controls.target)]; // prettier-ignore
    const [middle, far] = seen();
    assert.ok(middle > 2 && middle < 20 && far > 50, `${middle}, from ${far}`);
    view.orbit.fit();
    const [own, near] = seen();
    assert.ok(Math.abs(own) < 0.5 && near < 12, `${own}, from ${near}`);
    view.orbit.reset();
    assert.ok(Math.abs(seen()[1] / far - 1) < 0.01);
  }));

test('a look without a map is plain; dimmed where the map is of earlier cones', () =>
  withCanvases(({ rest }) => {
    const { view, mapped, canvas } = viewOf(rest);
    const { uniforms, defines } = mapped.material;
    assert.ok(defines.PATTERN > 0);
    near(uniforms.scale.value * 2 * surface.diagonal, 24, 'tiles along the diagonal, where lengths are doubled'); // prettier-ignore
    view.setLook({ ...look, seams: 'off' }, 4, true, palette);
    assert.ok(uniforms.dim.value > 0.3 && uniforms.dim.value < 1);
    assert.equal(canvas.dataset.seams, 'off');
    const image = { width: 2, height: 2 };
    view.setLook({ ...look, pattern: 'image', image }, 4, false, palette);
    const texture = uniforms.image.value;
    view.setLook({ ...look, pattern: 'image', image }, 4, false, palette);
    assert.equal(uniforms.image.value, texture, 'uploaded once');
    assert.equal(texture.image, image);
    const lights = ['studio', 'side', 'gloss', 'flat'].map((light) => {
      view.setLook({ ...look, light }, 4, false, palette);
      return uniforms.light.value;
    });
    assert.equal(new Set(lights).size, 4);
    view.setLook(look, 4, false, palette);
    view.setModel(surface, undefined, alone);
    view.setLook(look, 4, false, palette);
    assert.equal(defines.PATTERN, 0);
    assert.equal(uniforms.dim.value, 0);
    assert.equal(uniforms.paper.value, palette.paper);
  }));

test('before and after share the picture at the wipe, and afterwards everything is as it was', () =>
  withCanvases(({ rest }) => {
    const { view, canvas, mapped, marks, markers } = viewOf(rest);
    view.setCones(prescription, [], -1);
    view.setCrosses(new Float32Array(6), palette);
    rest();
    canvas.taken();
    const pattern = () => mapped.material.defines.PATTERN;
    assert.ok(markers.visible && pattern() > 0);
    const shown = () => [...marks.ofMap, markers, mapped].map((one) => one.visible);
    const [whole, value] = [shown(), pattern()];
    const states = [];
    const { render } = view.renderer;
    view.renderer.render = (...all) => {
      states.push([shown(), pattern()]);
      render.apply(view.renderer, all);
    };
    const drawn = () => {
      states.length = 0;
      view.draw();
      rest();
      return canvas.taken().filter(([name]) => name === 'scissor').map(([, ...box]) => box); // prettier-ignore
    };
    drawn();
    assert.equal(states.length, 1);
    for (const part of [0.25, 0.5, 1]) {
      view.setWipe(part);
      const boxes = drawn().filter(([, , width]) => width !== 600 || part === 1);
      assert.deepEqual(boxes.slice(0, 1), [[600 * part, 0, 600 * (1 - part), 400]], 'after, right');
      assert.deepEqual(boxes.at(-1), [0, 0, 600 * part, 400], 'before, left');
      assert.deepEqual(states[0], [whole, value]);
      assert.deepEqual(states[1], [[false, false, false, false, true], 0], 'the bare surface');
      assert.deepEqual([shown(), pattern()], [whole, value]);
      assert.equal(view.renderer.getScissorTest(), false);
    }
    // With its own materials, the model as it was takes the place of the surface.
    const instance = new Mesh();
    view.setOriginal({ group: new Group().add(instance), instances: new Map([[0, [instance]]]) }, 0, false); // prettier-ignore
    const seen = [];
    view.renderer.render = () => seen.push([mapped.visible, instance.visible]);
    drawn();
    assert.deepEqual(seen, [[true, false], [false, true]]); // prettier-ignore
    assert.deepEqual([mapped.visible, instance.visible], [true, false]);
    // Without a map there is nothing to compare.
    view.setModel(surface, undefined, alone);
    seen.length = 0;
    view.draw();
    rest();
    assert.equal(seen.length, 1);
  }));

test('one of pattern, own materials and quads is shown at a time', () =>
  withCanvases(({ rest }) => {
    const { view, canvas, mapped, marks, markers } = viewOf(rest);
    const quads = view.scene.children[3];
    const instance = new Mesh();
    const original = { group: new Group().add(instance), instances: new Map([[2, [instance]]]) };
    const seen = () => [mapped.visible, instance.visible, quads.visible, marks.visible, markers.visible, canvas.dataset.original]; // prettier-ignore
    view.setOriginal(original, 2, true);
    assert.equal(original.group.parent, view.scene);
    assert.deepEqual(seen(), [false, true, false, true, true, 'shown']);
    view.setOriginal(original, 2, false);
    assert.deepEqual(seen(), [true, false, false, true, true, 'none']);
    view.setOriginal(original, 1, true);
    assert.equal(mapped.visible, true, 'no instance of this mesh');
    view.setOriginal(original, 2, true);
    const shape = { positions: Float64Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0), quads: Uint32Array.of(0, 1, 2, 3) }; // prettier-ignore
    const matrix = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
    view.setQuads(shape, matrix, palette);
    assert.deepEqual(seen(), [false, false, true, false, false, 'none']);
    view.setQuads(undefined, matrix, palette);
    assert.deepEqual(seen(), [false, true, false, true, true, 'shown']);
    // The light of materials is made once, and anew only where the card lost it.
    const { environment } = view.scene;
    assert.notEqual(environment, null);
    view.setOriginal({ ...original }, 2, true);
    assert.equal(view.scene.environment, environment);
    for (const name of ['lost', 'restored']) canvas.dispatchEvent(new Event(`webglcontext${name}`, { cancelable: true })); // prettier-ignore
    assert.notEqual(view.scene.environment, environment);
    assert.notEqual(view.scene.environment, null);
    view.setOriginal(undefined, 2, true);
    assert.equal(original.group.parent, null);
    assert.equal(mapped.visible, true);
  }));

test('every change is drawn', () =>
  withCanvases(({ rest }) => {
    const { view } = viewOf(rest);
    const changes = {
      setMarkers: () => view.setMarkers(true),
      setLook: () => view.setLook(look, 4, false, palette),
      setLive: () => view.setLive({ state: 'certified', cornerUv: solution.cornerUv, heat: [], notPositive: new Uint32Array(0) }), // prettier-ignore
      'setLive, the end': () => view.setLive(undefined),
      setOverlay: () => view.setOverlay(new Uint8Array(4 * surface.triangles.length)),
      setCrosses: () => view.setCrosses(new Float32Array(6), palette),
      setHandles: () => view.setHandles([]),
      setWipe: () => view.setWipe(0.5),
      setCones: () => view.setCones(prescription, [], -1),
      setCursor: () => view.setCursor(4),
      highlight: () => view.highlight([1]),
      setOriginal: () => view.setOriginal(undefined, 0, false),
      setQuads: () => view.setQuads(undefined, [], palette),
      setScene: () => view.setScene({ parts: [], open: 0, maps: new Map(), isOwnShown: false, palette }), // prettier-ignore
      setBacking: () => view.setBacking('#fff'),
      move: () => view.orbit.move(0.1, 0),
      setModel: () => view.setModel(surface, undefined, alone),
    };
    for (const [name, change] of Object.entries(changes)) {
      assert.equal(rest(), 0);
      view.canvas.taken();
      change();
      assert.equal(rest(), 1, name);
      assert.ok(drawsIn(view.canvas.taken()) > 0, name);
    }
  }));

test('a map that is dragged takes the place of the solution in every view, which comes back when it ends; markers fade after a run; the wipe needs a map', async () => {
  const { isStale, lastConcerns, liveConcern, markersConcern } = await import('../../../web/src/views/small_concerns.ts'); // prettier-ignore
  const told = [];
  const viewOf = (name) => ({ canvas: { dataset: {} }, setLive: (live) => told.push([name, live]) });
  const views = [viewOf('model'), viewOf('uv')];
  const doc = { live: undefined };
  const { key, show } = liveConcern(doc, views, (view) => told.push(['solution', views.indexOf(view)])); // prettier-ignore
  for (const state of ['heat', 'certified']) {
    doc.live = { state };
    assert.deepEqual(key(), [doc.live]);
    show();
    assert.deepEqual(told.splice(0), [['model', doc.live], ['uv', doc.live]]); // prettier-ignore
    for (const { canvas } of views) assert.equal(canvas.dataset.live, state);
  }
  doc.live = undefined;
  show();
  assert.deepEqual(told.splice(0), [['model', undefined], ['solution', 0], ['uv', undefined], ['solution', 1]]); // prettier-ignore
  for (const { canvas } of views) assert.equal(canvas.dataset.live, '');

  const [map, old] = [{}, {}];
  const stale = [[undefined, undefined, undefined], [map, map, undefined], [old, undefined, undefined], [old, map, undefined], [old, undefined, {}]]; // prettier-ignore
  assert.deepEqual(stale.map(([displayed, current, live]) => isStale({ displayed, current, live })), [false, false, true, true, false]); // prettier-ignore
  const faded = [];
  const marks = { setFeatures: (...all) => told.push(all) };
  const model = { setMarkers: (are) => faded.push(are), setWipe: (part) => told.push(part), draw: () => told.push('drawn'), marks }; // prettier-ignore
  for (const current of [undefined, map])
    for (const tool of ['orbit', 'place', 'edges']) {
      const concern = markersConcern({ doc: { current }, ui: { tool }, model });
      concern.show();
      assert.deepEqual(concern.key(), [faded.at(-1)]);
    }
  assert.deepEqual(faded, [false, false, false, true, false, false]);
  const surface = {};
  const file = { model: { surface }, features: { edges: [[1, 2]], rims: [[3, 4]] } }; // prettier-ignore
  const after = (doc, ui = { wipe: 25 }) => {
    for (const concern of lastConcerns({ doc, ui, model })) concern.show();
    return told.splice(0);
  };
  assert.deepEqual(after(file), [[surface, [[1, 2], [3, 4]]], 'drawn', 0]); // prettier-ignore
  assert.deepEqual(after({ displayed: map }), [[undefined, []], 'drawn', 0.25]);
}); // prettier-ignore
