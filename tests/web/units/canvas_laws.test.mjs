// Laws of a canvas with a scene: when it is drawn, how large its buffer is, what it shows when it is hidden or its
// context is lost. The graphics card is a stand-in; what it is told is looked at.

import assert from 'node:assert/strict';
import test from 'node:test';
import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  Matrix3,
  Mesh,
  MeshBasicMaterial,
  Object3D,
  PerspectiveCamera,
  Vector3,
} from 'three';
import { CanvasView, nearestOf } from '../../../web/src/views/canvas_view.ts';
import { Canvas, drawsIn, endsEmpty, withCanvases } from './canvases.mjs';

/** A view of one box, which tells what happens to it. */
class BoxView extends CanvasView {
  camera = new PerspectiveCamera(30, 1, 0.1, 100);
  sizes = [];
  restored = 0;
  steps = 0;
  constructor(canvas) {
    super(canvas);
    const box = new Mesh(new BoxGeometry(), new MeshBasicMaterial());
    box.frustumCulled = false;
    this.scene.add(box);
    this.beforeDraw(() => (this.steps += 1));
  }
  onResize(width, height) {
    this.sizes.push([width, height]);
  }
  onRestored() {
    this.restored += 1;
  }
}

function shown(rest, canvas = new Canvas()) {
  const view = new BoxView(canvas);
  view.draw();
  rest();
  assert.equal(canvas.taken().findLast(([name]) => name === 'clearColor')[4], 0, 'transparent');
  return { view, canvas };
}

test('a view is drawn once for any number of changes, and never without one', () =>
  withCanvases(({ frame, rest }) => {
    const { view, canvas } = shown(rest);
    assert.ok(canvas.options.antialias && canvas.options.alpha);
    assert.equal(frame(), 0, 'it rests');
    const { steps } = view;
    for (let i = 0; i < 3; i++) view.draw();
    assert.equal(canvas.dataset.pending, '');
    assert.equal(drawsIn(canvas.taken()), 0, 'not before the frame');
    assert.equal(rest(), 1);
    assert.equal(drawsIn(canvas.taken()), 1);
    assert.equal(view.steps, steps + 1);
    assert.equal(canvas.dataset.pending, undefined);
    assert.equal(canvas.dataset.triangles, '12');
    assert.equal(canvas.dataset.frames, String(view.renderer.info.render.frame));
    view.draw();
    rest();
    assert.equal(drawsIn(canvas.taken()), 1, 'again');
    view.setBacking('#ff0000');
    rest();
    const colour = () => canvas.taken().findLast(([name]) => name === 'clearColor').slice(1).map(Math.round); // prettier-ignore
    assert.deepEqual(colour(), [1, 0, 0, 1]);
    view.setBacking(undefined);
    rest();
    assert.equal(colour()[3], 0, 'nothing is behind it');
  }));

test('the buffer has the size of the canvas in pixels of the screen, of which at most two are counted', () =>
  withCanvases(({ rest, resized }) => {
    for (const ratio of [1, 1.5, 2, 3]) {
      globalThis.devicePixelRatio = ratio;
      const { view, canvas } = shown(rest);
      const most = Math.min(2, ratio);
      assert.deepEqual([canvas.width, canvas.height], [200 * most, 100 * most]);
      assert.deepEqual(view.sizes, [[200, 100]], 'told once');
      for (const [width, height] of [[300, 100], [300, 50]]) {
        Object.assign(canvas, { clientWidth: width, clientHeight: height });
        resized(canvas);
        rest();
        assert.deepEqual([canvas.width, canvas.height], [width * most, height * most]);
        assert.deepEqual(view.sizes.at(-1), [width, height]);
        assert.ok(!endsEmpty(canvas.taken()), 'a new buffer is empty: it is drawn again');
      }
      resized(canvas);
      rest();
      assert.equal(view.sizes.length, 3, 'no new buffer without a new size');
      globalThis.devicePixelRatio = ratio === 1 ? 2 : 1;
      resized(canvas);
      rest();
      assert.equal(canvas.width, 300 * globalThis.devicePixelRatio, 'moved to another screen');
    }
  })); // prettier-ignore

test('a view that is hidden draws nothing and is emptied, so that the next model does not show the last one first', () =>
  withCanvases(({ rest, resized }) => {
    for (const side of ['clientWidth', 'clientHeight']) {
      const { view, canvas } = shown(rest);
      const size = canvas[side];
      canvas[side] = 0;
      resized(canvas);
      assert.equal(rest(), 0, 'hiding alone changes nothing');
      view.draw();
      rest();
      const calls = canvas.taken();
      assert.ok(drawsIn(calls) === 0 && endsEmpty(calls));
      view.draw();
      rest();
      assert.deepEqual(canvas.taken().filter(([name]) => name === 'clear'), [], 'once'); // prettier-ignore
      canvas[side] = size;
      resized(canvas);
      rest();
      assert.equal(drawsIn(canvas.taken()), 1, 'back again');
      assert.deepEqual([canvas.width, canvas.height], [200, 100]);
    }
  }));

test('two views are never drawn in one frame, and the buffers of both are there before either is drawn', () =>
  withCanvases(({ frame, rest }) => {
    const views = [new BoxView(new Canvas()), new BoxView(new Canvas(80, 60))];
    for (const view of views) view.draw();
    let count = 0;
    while (frame() > 0 && count++ < 40) {
      const draws = views.map(({ canvas }) => drawsIn(canvas.taken()));
      assert.ok(draws[0] + draws[1] <= 1, 'not both');
      if (draws[0] + draws[1] > 0) assert.deepEqual(views.map(({ sizes }) => sizes.length), [1, 1]); // prettier-ignore
    }
    assert.deepEqual(views.map(({ steps }) => steps), [1, 1], 'both, once'); // prettier-ignore
    for (const view of views) view.draw();
    assert.equal(rest(), 2);
    // A view that is hidden has no buffer to wait for.
    const [hidden, other] = [new BoxView(new Canvas(0, 60)), new BoxView(new Canvas())];
    hidden.draw();
    other.draw();
    rest();
    assert.equal(other.steps, 1);
    assert.equal(hidden.steps, 0);
  }));

test('nothing is drawn without a context; when it is back everything is drawn again', () =>
  withCanvases(({ rest }) => {
    const { view, canvas } = shown(rest);
    const told = [];
    view.onContext = (isLost) => told.push(isLost);
    // The renderer sees to it that a lost context comes back.
    const lost = new Event('webglcontextlost', { cancelable: true });
    canvas.dispatchEvent(lost);
    assert.ok(lost.defaultPrevented, 'the browser restores it');
    canvas.taken();
    view.draw();
    rest();
    assert.equal(drawsIn(canvas.taken()), 0);
    canvas.dispatchEvent(new Event('webglcontextrestored'));
    rest();
    assert.ok(drawsIn(canvas.taken()) > 0);
    assert.deepEqual([told, view.restored], [[true, false], 1]);
  }));

test('arrays that are too large for one frame are sent before anything is drawn, and then nothing more', () =>
  withCanvases(({ frame, rest }) => {
    const { view, canvas } = shown(rest);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(3 * 10 ** 6), 3));
    const large = new Mesh(geometry, new MeshBasicMaterial());
    large.frustumCulled = false;
    view.scene.add(large);
    view.draw();
    let [sent, draws] = [0, 0];
    for (let i = 0; i < 40 && frame() > 0; i++) {
      const calls = canvas.taken();
      const pieces = calls.filter(([name]) => name === 'bufferSubData').map(([, , , piece]) => piece.byteLength); // prettier-ignore
      for (const size of pieces) sent += size;
      draws = drawsIn(calls);
      if (i > 0 && sent < 12 * 10 ** 6) assert.equal(draws, 0, 'not before all is there');
    }
    assert.deepEqual([sent, draws], [12 * 10 ** 6, 2]);
    assert.equal(canvas.dataset.pending, undefined, 'it rests');
    // Without its context nothing waits any more: the renderer sends everything again.
    geometry.getAttribute('position').needsUpdate = true;
    const other = new Mesh(geometry.clone(), large.material);
    other.frustumCulled = false;
    view.scene.add(other);
    view.draw();
    frame();
    frame();
    canvas.dispatchEvent(new Event('webglcontextlost', { cancelable: true }));
    rest();
    canvas.taken();
    canvas.dispatchEvent(new Event('webglcontextrestored'));
    frame();
    assert.ok(drawsIn(canvas.taken()) > 0, 'in the first frame');
  }));

test('warming leaves no trace: on a hidden canvas it is emptied again, a visible one is not touched', () =>
  withCanvases(async ({ rest }) => {
    const thing = () => new Mesh(new BoxGeometry(), new MeshBasicMaterial());
    const hidden = new Canvas(0, 0);
    const things = [thing(), thing()];
    await new BoxView(hidden).warm(things);
    const calls = hidden.taken();
    assert.equal(drawsIn(calls), 2, 'each of them');
    assert.ok(endsEmpty(calls));
    for (const { position, frustumCulled } of things) assert.ok(position.z < 0 && !frustumCulled, 'seen'); // prettier-ignore
    const { view, canvas } = shown(rest);
    await view.warm([thing()]);
    assert.equal(drawsIn(canvas.taken()), 0);
    assert.deepEqual([canvas.width, canvas.height], [200, 100]);
  }));

test('a picture is as wide as asked for, at most six times the view; the view is as before afterwards', () =>
  withCanvases(async ({ rest }) => {
    const { view, canvas } = shown(rest);
    const taken = [];
    let blob = new Blob(['a picture']);
    canvas.toBlob = (done, type) => {
      taken.push([canvas.width, canvas.height, endsEmpty(canvas.taken()), type]);
      done(blob);
    };
    for (const [width, is] of [
      [100, 200],
      [200, 200],
      [500, 500],
      [1200, 1200],
      [9000, 1200],
    ]) {
      // prettier-ignore
      const { steps } = view;
      assert.equal(await view.picture(width), blob);
      assert.deepEqual(taken.pop(), [is, is / 2, false, 'image/png'], `${width} pixels wide`);
      assert.equal(view.steps, steps + 1, 'prepared as every drawing');
      assert.deepEqual([canvas.width, canvas.height], [200, 100]);
      const calls = canvas.taken();
      assert.ok(drawsIn(calls) === 1 && !endsEmpty(calls), 'and drawn');
    }
    globalThis.devicePixelRatio = 2;
    await view.picture(100);
    assert.equal(taken.pop()[0], 400, 'as sharp as the screen');
    blob = null;
    await assert.rejects(view.picture(100), Error);
    blob = new Blob(['a picture']);
    canvas.clientHeight = 0;
    await assert.rejects(view.picture(100), Error, 'hidden');
    canvas.clientHeight = 100;
    canvas.dispatchEvent(new Event('webglcontextlost', { cancelable: true }));
    await assert.rejects(view.picture(100), Error, 'lost');
  }));

test('a pointer is at −1 and 1 at the edges of the canvas, up is positive', () =>
  withCanvases(() => {
    const view = new BoxView(new Canvas(200, 100));
    const at = (x, y) => Object.values(view.pointer({ clientX: 20 + x, clientY: 10 + y }));
    assert.deepEqual([at(0, 0), at(200, 100), at(100, 50), at(150, 25)], [[-1, 1], [1, -1], [0, 0], [0.5, 0.5]]); // prettier-ignore
    const far = [5, 2, 9];
    const near = (all) => nearestOf(7, all, (v) => far[v]);
    for (const all of [[0, 1, 2], [2, 1, 0], [1, 0, 2]]) assert.deepEqual(near(all), { triangle: 7, vertex: 1, pixels: 2 }); // prettier-ignore
    assert.equal(nearestOf(7, [3, 4], () => 1).vertex, 3, 'the first of equals');
    assert.equal(nearestOf(7, [], () => 1).vertex, -1);
  }));

test('the model of the start page is centred, fills its canvas, turns once in forty seconds, and rests where motion is not wanted', async (t) => {
  const { TurningView } = await import('../../../web/src/views/turning_view.ts');
  const box = new BoxGeometry(2, 1, 3).translate(5, -7, 2);
  const parts = ['position', 'normal', 'uv'].map((name) => box.getAttribute(name).array);
  const { array: corners } = box.index;
  const counts = Uint32Array.of(parts[0].length / 3, corners.length);
  const bytes = Buffer.concat([counts, ...parts, Uint32Array.from(corners)].map(({ buffer }) => Buffer.from(buffer))); // prettier-ignore
  const served = { 'hero.bin': Response.json({}), 'none.bin': new Response('', { status: 404 }) };
  served['hero.bin'].arrayBuffer = async () => new Uint8Array(bytes).buffer;
  t.mock.method(globalThis, 'fetch', async (url) => served[url]);
  let clock = 0;
  t.mock.method(performance, 'now', () => clock);
  const drawnThings = new Set();
  const update = Object3D.prototype.updateMatrixWorld;
  t.mock.method(Object3D.prototype, 'updateMatrixWorld', function note(...all) {
    drawnThings.add(this);
    return update.apply(this, all);
  });
  await withCanvases(async ({ frame, resized }) => {
    const canvas = new Canvas(300, 200);
    const still = { matches: false };
    const own = { document: { createElement: () => canvas }, matchMedia: () => still, devicePixelRatio: 3 }; // prettier-ignore
    Object.assign(globalThis, own);
    const view = new TurningView();
    assert.equal(view.canvas, canvas);
    assert.ok(canvas.options.antialias && canvas.options.alpha);
    assert.deepEqual([canvas.className, canvas.ariaHidden], ['turning', 'true']);
    // The renderer sees to it that a lost context comes back.
    const lost = new Event('webglcontextlost', { cancelable: true });
    canvas.dispatchEvent(lost);
    assert.equal(lost.defaultPrevented, true, 'the browser restores it');
    canvas.dispatchEvent(new Event('webglcontextrestored'));
    await assert.rejects(view.load('none.bin'), /none\.bin: 404/);
    const draws = () => drawsIn(canvas.taken());
    view.start();
    frame();
    assert.deepEqual([canvas.width, canvas.height], [600, 400], 'two pixels at most for each of the window');
    assert.deepEqual([draws(), 'drawn' in canvas.dataset], [0, false], 'nothing is there yet');
    await view.load('hero.bin');
    assert.deepEqual([draws(), 'drawn' in canvas.dataset], [1, true]);

    // What is drawn is what the file has, seen from above, as large as fits whichever way it is turned.
    const [scene, camera] = ['isScene', 'isCamera'].map((key) => [...drawnThings].find((one) => one[key])); // prettier-ignore
    const [{ geometry, material }] = scene.children;
    ['position', 'normal', 'uv'].forEach((name, i) => assert.deepEqual([...geometry.getAttribute(name).array], [...parts[i]], name)); // prettier-ignore
    assert.deepEqual([...geometry.index.array], [...corners]);
    assert.ok(geometry.getAttribute('tint').array.every((x) => x === 0), 'no colour but the pattern');
    assert.deepEqual([material.defines.PATTERN, material.uniforms.scale.value, material.uniforms.lit.value], [9, 1, 1]); // prettier-ignore
    const seen = () => {
      const mesh = scene.children[0];
      scene.updateMatrixWorld(true);
      const all = [];
      for (let i = 0; i < parts[0].length; i += 3) all.push(new Vector3(...parts[0].subarray(i, i + 3)).applyMatrix4(mesh.matrixWorld)); // prettier-ignore
      return all;
    };
    const turned = (at) => {
      clock = at;
      assert.equal(frame(), 1, 'the next one is asked for');
      return [scene.rotation.y, seen()];
    };
    const [, first] = turned(0);
    const middle = first.reduce((sum, p) => sum.add(p), new Vector3()).divideScalar(first.length);
    assert.ok(middle.length() < 1e-5, 'turned around its own centre');
    assert.ok(camera.position.y > 0.3 * camera.position.z && camera.position.x === 0);
    const { x, y } = new Vector3().project(camera);
    assert.ok(Math.hypot(x, y) < 1e-9, 'its centre is in the middle of the picture');
    const shape = () => Number((camera.projectionMatrix.elements[5] / camera.projectionMatrix.elements[0]).toFixed(9)); // prettier-ignore
    assert.deepEqual([camera.aspect, shape()], [1.5, 1.5]);
    let most = 0;
    for (let at = 0; at < 40_000; at += 2000) {
      const [angle, places] = turned(at);
      assert.ok(Math.abs(angle - (2 * Math.PI * at) / 40_000) < 1e-9);
      for (const p of places) most = Math.max(most, Math.abs(p.project(camera).y));
    }
    assert.ok(most > 0.7 && most <= 1, `${most}`);
    assert.ok(Math.abs(turned(40_000)[0]) < 1e-9);
    const studio = new Matrix3().setFromMatrix4(camera.matrixWorld).toArray();
    assert.deepEqual(material.uniforms.toStudio.value.toArray(), studio, 'the light stays where it is');

    // Another size is drawn at once, one of zero not; stopped, nothing is drawn.
    draws();
    canvas.clientHeight = 300;
    resized(canvas);
    assert.deepEqual([draws(), canvas.height, camera.aspect, shape()], [1, 600, 1, 1]);
    assert.equal(frame(), 1, 'one turns, not two');
    for (const side of ['clientWidth', 'clientHeight']) {
      draws();
      const size = canvas[side];
      canvas[side] = 0;
      resized(canvas);
      assert.equal(draws(), 0);
      canvas[side] = size;
    }
    view.stop();
    resized(canvas);
    assert.deepEqual([frame(), draws()], [0, 0]);
    still.matches = true;
    view.start();
    assert.deepEqual([draws(), frame(), scene.rotation.y], [1, 0, 0.6]);
  });
}); // prettier-ignore
